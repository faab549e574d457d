// A scene that changes while it runs: everything that is left alone goes on to the last bit.
#include "yard.hpp"

namespace cairn {

using namespace testing;

namespace {

bool all_found_again(const World<double>& world) {
  const auto& is_new = world.last_step().is_new;
  return std::none_of(is_new.begin(), is_new.end(), [](char each) { return each != 0; });
}

}  // namespace

TEST_CASE("a world whose scene was edited without a change goes on with the same bits") {
  for (const ContactSearch search : every_search) {
    for (const bool sleeps : {false, true}) {
      for (const int steps : {0, 1, 25, 200}) {
        CAPTURE(steps);
        SceneSettings settings{.substeps = 2, .contact_search = search};
        if (sleeps) settings.sleeping = Sleeping{};
        World<double> world(Yard(settings).scene);
        take_steps(world, steps);
        World<double> edited = world;
        edited.edit([](Scene&) {});
        CHECK(go_alike(world, edited));
        CHECK(go_on_alike(world, edited, 60));
        CHECK(world.last_step().problem.impulse == edited.last_step().problem.impulse);
      }
    }
  }
}

TEST_CASE("bodies that come and go elsewhere change no bit of the others") {
  for (const ContactSearch search : every_search) {
    World<double> world(Yard({.contact_search = search}).scene);
    take_steps(world, 20);
    World<double> edited = world;
    BodyId guest;
    edited.edit([&](Scene& scene) { guest = scene.add({.shapes = {box(1, 1)}, .position = {20, 0.5}}); });
    CHECK(guest.index == world.bodies().pose.size());
    CHECK(go_on_alike(world, edited, 20));
    CHECK(edited.bodies().pose[guest].position.y() == doctest::Approx(0.5).epsilon(0.01));
    edited.edit([&](Scene& scene) { scene.remove(guest); });
    CHECK(go_on_alike(world, edited, 20));
    const Yard yard;  // its ids
    edited.edit([&](Scene& scene) { scene.remove(yard.lonely); });
    CHECK(go_on_alike(world, edited, 20));
  }
}

TEST_CASE("rows that stay keep their impulses when shapes before them in the order go") {
  Yard yard;
  World<double> world(yard.scene);
  take_steps(world, 60);
  const double weight_below = world.last_step().problem.impulse[world.last_step().problem.blocks[4].first];
  CHECK(weight_below > 0);
  // The lowest number of the pile's colliders goes: the others are renumbered, and found again.
  world.edit([&](Scene& scene) { scene.remove(yard.lonely); });
  take_steps(world, 1);
  CHECK(all_found_again(world));
  world.edit([&](Scene& scene) { scene.remove(yard.pile[5]); });  // the top of the pile
  take_steps(world, 1);
  CHECK(all_found_again(world));
}

TEST_CASE("what rested on a removed body falls, and what sleeps elsewhere sleeps on") {
  Yard yard({.sleeping = Sleeping{}});
  World<double> world(yard.scene);
  take_steps(world, 240);
  REQUIRE(!world.is_awake(yard.pile[5]));
  REQUIRE(!world.is_awake(yard.lonely));
  world.edit([&](Scene& scene) { scene.remove(yard.pile[0]); });
  CHECK(world.is_awake(yard.pile[1]));
  CHECK(world.is_awake(yard.pile[5]));
  CHECK(!world.is_awake(yard.lonely));
  const double height = world.bodies().pose[yard.pile[5]].position.y();
  take_steps(world, 30);
  CHECK(world.bodies().pose[yard.pile[5]].position.y() < height - 0.5);
  CHECK(!world.is_awake(yard.lonely));
}

TEST_CASE("a changed body, a changed rule and a new joint act from the next step on") {
  Scene scene({.sleeping = Sleeping{}});
  scene.add_ground({.material = {.friction = 1}});
  const BodyId slider = scene.add(
      {.shapes = {box(1, 1)}, .position = {0, 0.5}, .velocity = {3, 0}, .material = {.friction = 0}});
  World<double> world(scene);
  take_steps(world, 30);
  CHECK(world.bodies().velocity[slider].x() == doctest::Approx(3));
  world.edit([&](Scene& now) {
    BodySpec spec = now.bodies()[slider].spec;
    spec.material.friction = 1;
    now.change(slider, spec);
  });
  CHECK(world.bodies().velocity[slider].x() == doctest::Approx(3));
  take_steps(world, 15);
  CHECK(world.bodies().velocity[slider].x() == doctest::Approx(3 - 10 * 15.0 / 60).epsilon(0.05));  // mu g t
  take_steps(world, 120);
  REQUIRE(!world.is_awake(slider));

  // Gravity to the side wakes it; a pin at its centre then holds it.
  world.edit([](Scene& now) {
    SceneSettings settings = now.settings();
    settings.gravity = {20, -10};
    now.set_settings(settings);
  });
  CHECK(world.is_awake(slider));
  take_steps(world, 10);
  CHECK(world.bodies().velocity[slider].x() > 1);
  const double place = world.bodies().pose[slider].position.x();
  world.edit([&](Scene& now) {
    now.join<RevoluteJoint>({.a = ground, .b = slider, .anchor = now.bodies()[slider].pose.position});
  });
  take_steps(world, 120);
  CHECK(world.bodies().pose[slider].position.x() == doctest::Approx(place).epsilon(0.01));
}

TEST_CASE("joints that stay keep their impulses when others are removed and added") {
  Yard yard;
  World<double> world(yard.scene);
  take_steps(world, 30);
  const JointId first = world.scene().joints().id(0);
  world.edit([&](Scene& scene) { scene.remove(yard.pin); });
  CHECK(world.scene().joints().size() == 3);
  CHECK(world.scene().joints().id(0) == first);
  const auto joints_found_again = [&] {
    take_steps(world, 1);
    const auto& is_new = world.last_step().is_new;
    const int rows = 2 * world.scene().joints().size();  // of pins
    return std::none_of(is_new.begin(), is_new.begin() + rows, [](char each) { return each != 0; });
  };
  CHECK(joints_found_again());
  world.edit([&](Scene& scene) { scene.remove(first); });  // those that stay come one place forward
  CHECK(joints_found_again());
}

TEST_CASE("a body that is put elsewhere begins there, and one that is not keeps its bits") {
  Yard yard;
  World<double> world(yard.scene);
  take_steps(world, 50);
  World<double> edited = world;
  edited.edit([&](Scene& scene) { displace(scene, yard.lonely, {0, 3}); });
  CHECK(edited.bodies().pose[yard.lonely].position.y() ==
        doctest::Approx(world.bodies().pose[yard.lonely].position.y() + 3));
  for (const BodyId body : yard.pile) {
    CHECK(edited.bodies().pose[body].position == world.bodies().pose[body].position);
  }
  take_steps(world, 20);
  take_steps(edited, 20);
  CHECK(edited.bodies().pose[yard.pile[3]].position == world.bodies().pose[yard.pile[3]].position);
}

TEST_CASE("an edit that is refused, or fails midway, changes nothing") {
  Yard yard;
  World<double> world(yard.scene);
  take_steps(world, 20);
  World<double> untouched = world;
  CHECK_THROWS_AS(world.edit([&](Scene& scene) {
    scene.remove(yard.lonely);
    scene.remove(yard.lonely);
  }),
                  std::invalid_argument);
  CHECK_THROWS_AS(world.edit([](Scene& scene) {
    scene.add({.shapes = {circle(1e-3)}, .position = {1e18, 0}});  // no double tells places there apart
  }),
                  std::invalid_argument);
  CHECK_THROWS_AS(world.edit([](Scene&) { throw std::runtime_error("midway"); }), std::runtime_error);
  CHECK(go_on_alike(world, untouched, 20));
}

TEST_CASE("time, steps and dt go on over an edit") {
  World<double> world(Yard().scene);
  world.set_dt(1.0 / 120);
  take_steps(world, 7);
  world.edit([](Scene& scene) { scene.add({.shapes = {circle(0.2)}, .position = {0, 30}}); });
  CHECK(world.clock().steps == 7);
  CHECK(world.clock().time == doctest::Approx(7.0 / 120));
  CHECK(world.clock().dt == 1.0 / 120);
  world.edit([](Scene& scene) {
    SceneSettings settings = scene.settings();
    settings.dt = 1.0 / 30;
    scene.set_settings(settings);
  });
  CHECK(world.clock().dt == 1.0 / 30);
}

}  // namespace cairn
