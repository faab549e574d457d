// A scene that changes while it runs: everything that is left alone goes on to the last bit.
#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>

#include "constraints/revolute_joint.hpp"
#include "solvers/iterative/sequential_impulse.hpp"
#include "world/world.hpp"

namespace cairn {
namespace {

const ContactSearch every_search[] = {ContactSearch::every_substep, ContactSearch::every_step,
                                      ContactSearch::when_moved};

/// A pile of boxes that lean on each other, a chain that swings, and a box that lies by itself.
struct Yard {
  Scene scene;
  List<BodyId> pile = {};
  BodyId lonely = {};
  JointId pin = {};

  explicit Yard(const SceneSettings& settings = {}) : scene(settings) {
    scene.add_ground();
    for (int i = 0; i < 6; ++i) {
      pile.push_back(scene.add({.shapes = {box(1, 0.8)}, .position = {0.1 * (i % 2), 0.4 + 0.8 * i}}));
    }
    BodyId above = ground;
    for (int i = 0; i < 4; ++i) {
      const BodyId link = scene.add({.shapes = {box(1, 0.2)}, .position = {5.5 + i, 4}});
      pin = scene.join<RevoluteJoint>({.a = above, .b = link, .anchor = {5.0 + i, 4}});
      above = link;
    }
    lonely = scene.add({.shapes = {box(1, 1)}, .position = {-20, 0.5}});
  }
};

/// A solver of its own in every call: none keeps anything from step to step.
void run_steps(World<double>& world, int steps) {
  SequentialImpulse<double> solver({.iterations = 10});
  for (int i = 0; i < steps; ++i) world.step(solver);
}

/// Of the bodies that both have.
bool go_alike(const World<double>& one, const World<double>& other) {
  const int count = std::min(one.bodies().pose.size(), other.bodies().pose.size());
  bool same = one.time() == other.time() && one.steps() == other.steps() && one.dt() == other.dt();
  for (int i = 0; i < count; ++i) {
    const BodyId body{i};
    if (one.scene().bodies()[body].removed || other.scene().bodies()[body].removed) continue;
    const Pose<double>&left = one.bodies().pose[body], &right = other.bodies().pose[body];
    same = same && left.position == right.position && left.angle == right.angle &&
           one.bodies().velocity[body] == other.bodies().velocity[body] &&
           one.is_awake(body) == other.is_awake(body);
  }
  return same;
}

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
        run_steps(world, steps);
        World<double> edited = world;
        edited.edit([](Scene&) {});
        CHECK(go_alike(world, edited));
        run_steps(world, 60);
        run_steps(edited, 60);
        CHECK(go_alike(world, edited));
        CHECK(world.last_step().problem.impulse == edited.last_step().problem.impulse);
      }
    }
  }
}

TEST_CASE("bodies that come and go elsewhere change no bit of the others") {
  for (const ContactSearch search : every_search) {
    World<double> world(Yard({.contact_search = search}).scene);
    run_steps(world, 20);
    World<double> edited = world;
    BodyId guest;
    edited.edit([&](Scene& scene) { guest = scene.add({.shapes = {box(1, 1)}, .position = {20, 0.5}}); });
    CHECK(guest.index == world.bodies().pose.size());
    run_steps(world, 20);
    run_steps(edited, 20);
    CHECK(go_alike(world, edited));
    CHECK(edited.bodies().pose[guest].position.y() == doctest::Approx(0.5).epsilon(0.01));
    edited.edit([&](Scene& scene) { scene.remove(guest); });
    run_steps(world, 20);
    run_steps(edited, 20);
    CHECK(go_alike(world, edited));
    const Yard yard;  // its ids
    edited.edit([&](Scene& scene) { scene.remove(yard.lonely); });
    run_steps(world, 20);
    run_steps(edited, 20);
    CHECK(go_alike(world, edited));
  }
}

TEST_CASE("rows that stay keep their impulses when shapes before them in the order go") {
  Yard yard;
  World<double> world(yard.scene);
  run_steps(world, 60);
  const double weight_below = world.last_step().problem.impulse[world.last_step().problem.blocks[4].first];
  CHECK(weight_below > 0);
  // The lowest number of the pile's colliders goes: the others are renumbered, and found again.
  world.edit([&](Scene& scene) { scene.remove(yard.lonely); });
  run_steps(world, 1);
  CHECK(all_found_again(world));
  world.edit([&](Scene& scene) { scene.remove(yard.pile[5]); });  // the top of the pile
  run_steps(world, 1);
  CHECK(all_found_again(world));
}

TEST_CASE("what rested on a removed body falls, and what sleeps elsewhere sleeps on") {
  Yard yard({.sleeping = Sleeping{}});
  World<double> world(yard.scene);
  run_steps(world, 240);
  REQUIRE(!world.is_awake(yard.pile[5]));
  REQUIRE(!world.is_awake(yard.lonely));
  world.edit([&](Scene& scene) { scene.remove(yard.pile[0]); });
  CHECK(world.is_awake(yard.pile[1]));
  CHECK(world.is_awake(yard.pile[5]));
  CHECK(!world.is_awake(yard.lonely));
  const double height = world.bodies().pose[yard.pile[5]].position.y();
  run_steps(world, 30);
  CHECK(world.bodies().pose[yard.pile[5]].position.y() < height - 0.5);
  CHECK(!world.is_awake(yard.lonely));
}

TEST_CASE("a changed body, a changed rule and a new joint act from the next step on") {
  Scene scene({.sleeping = Sleeping{}});
  scene.add_ground({.friction = 1});
  const BodyId slider =
      scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}, .velocity = {3, 0}, .friction = 0});
  World<double> world(scene);
  run_steps(world, 30);
  CHECK(world.bodies().velocity[slider].x() == doctest::Approx(3));
  world.edit([&](Scene& now) {
    BodySpec spec = now.bodies()[slider].spec;
    spec.friction = 1;
    now.change(slider, spec);
  });
  CHECK(world.bodies().velocity[slider].x() == doctest::Approx(3));
  run_steps(world, 15);
  CHECK(world.bodies().velocity[slider].x() == doctest::Approx(3 - 10 * 15.0 / 60).epsilon(0.05));  // mu g t
  run_steps(world, 120);
  REQUIRE(!world.is_awake(slider));

  // Gravity to the side wakes it; a pin at its centre then holds it.
  world.edit([](Scene& now) {
    SceneSettings settings = now.settings();
    settings.gravity = {20, -10};
    now.set_settings(settings);
  });
  CHECK(world.is_awake(slider));
  run_steps(world, 10);
  CHECK(world.bodies().velocity[slider].x() > 1);
  const double place = world.bodies().pose[slider].position.x();
  world.edit([&](Scene& now) {
    now.join<RevoluteJoint>({.a = ground, .b = slider, .anchor = now.bodies()[slider].pose.position});
  });
  run_steps(world, 120);
  CHECK(world.bodies().pose[slider].position.x() == doctest::Approx(place).epsilon(0.01));
}

TEST_CASE("joints that stay keep their impulses when others are removed and added") {
  Yard yard;
  World<double> world(yard.scene);
  run_steps(world, 30);
  const JointId first = world.scene().joint_id(0);
  world.edit([&](Scene& scene) { scene.remove(yard.pin); });
  CHECK(world.scene().joints().size() == 3);
  CHECK(world.scene().joint_id(0) == first);
  const auto joints_found_again = [&] {
    run_steps(world, 1);
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
  run_steps(world, 50);
  World<double> edited = world;
  edited.edit([&](Scene& scene) { scene.displace(yard.lonely, {0, 3}); });
  CHECK(edited.bodies().pose[yard.lonely].position.y() ==
        doctest::Approx(world.bodies().pose[yard.lonely].position.y() + 3));
  for (const BodyId body : yard.pile) {
    CHECK(edited.bodies().pose[body].position == world.bodies().pose[body].position);
  }
  run_steps(world, 20);
  run_steps(edited, 20);
  CHECK(edited.bodies().pose[yard.pile[3]].position == world.bodies().pose[yard.pile[3]].position);
}

TEST_CASE("an edit that is refused, or fails midway, changes nothing") {
  Yard yard;
  World<double> world(yard.scene);
  run_steps(world, 20);
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
  run_steps(world, 20);
  run_steps(untouched, 20);
  CHECK(go_alike(world, untouched));
}

TEST_CASE("time, steps and dt go on over an edit") {
  World<double> world(Yard().scene);
  world.set_dt(1.0 / 120);
  run_steps(world, 7);
  world.edit([](Scene& scene) { scene.add({.shapes = {circle(0.2)}, .position = {0, 30}}); });
  CHECK(world.steps() == 7);
  CHECK(world.time() == doctest::Approx(7.0 / 120));
  CHECK(world.dt() == 1.0 / 120);
  world.edit([](Scene& scene) {
    SceneSettings settings = scene.settings();
    settings.dt = 1.0 / 30;
    scene.set_settings(settings);
  });
  CHECK(world.dt() == 1.0 / 30);
}

TEST_CASE("a hand drags a body to where it pulls, wakes it, and lets go") {
  Yard yard({.sleeping = Sleeping{}});
  World<double> world(yard.scene);
  run_steps(world, 120);
  REQUIRE(!world.is_awake(yard.lonely));
  world.grab({.body = yard.lonely, .anchor = {-20, 0.5}, .target = {-20, 0.5}, .max_force = 200});
  for (int i = 0; i < 120; ++i) {
    world.drag_to({-20 + 0.02 * i, 3});
    run_steps(world, 1);
  }
  run_steps(world, 60);
  CHECK(world.is_awake(yard.lonely));
  // The spring of 5 Hz gives way to the weight by g / omega^2.
  const double sag = 10 / std::pow(2 * pi * 5, 2);
  CHECK(world.bodies().pose[yard.lonely].position.y() == doctest::Approx(3 - sag).epsilon(0.002));
  CHECK(world.bodies().pose[yard.lonely].position.x() == doctest::Approx(-20 + 0.02 * 119).epsilon(0.002));
  const Snapshot seen = snapshot(world);
  CHECK(seen.joints.back().name == "drag");
  CHECK(seen.joints.back().impulse.y() / seen.dt == doctest::Approx(10).epsilon(0.01));  // its weight: 1 kg
  world.let_go();
  CHECK(world.hand() == nullptr);
  run_steps(world, 30);
  CHECK(world.bodies().pose[yard.lonely].position.y() < 2.5);
}

TEST_CASE("a run with a hand is repeated from its inputs, over edits and sleep") {
  const auto begin = [] { return World<double>(Yard({.sleeping = Sleeping{}}).scene); };
  const BodyId top = Yard().pile[5];
  const auto add_ball = [](Scene& scene) { scene.add({.shapes = {circle(0.3)}, .position = {0, 9}}); };
  World<double> world = begin();
  for (int i = 0; i < 200; ++i) {
    if (i == 50) world.grab({.body = top, .anchor = {0.3, 4.6}, .target = {1, 5}});
    if (i > 50 && i < 120) world.drag_to({1 + 0.03 * (i - 50), 5 + std::sin(0.1 * i)});
    if (i == 80) world.edit(add_ball);
    if (i == 120) world.let_go();
    run_steps(world, 1);
  }
  World<double> again = begin();
  auto input = world.hand_inputs().begin();
  for (int i = 0; i < 200; ++i) {
    for (; input != world.hand_inputs().end() && input->step == i; ++input) again.repeat(*input);
    if (i == 80) again.edit(add_ball);
    run_steps(again, 1);
  }
  CHECK(go_alike(world, again));
  CHECK(again.hand_inputs().size() == world.hand_inputs().size());
}

TEST_CASE("a hand refuses what it cannot hold and targets without a grip") {
  World<double> world(Yard().scene);
  CHECK_THROWS_AS(world.drag_to({0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(world.grab({.body = ground}), std::invalid_argument);
  CHECK_THROWS_AS(world.grab({.body = {99}}), std::invalid_argument);
  CHECK(world.hand() == nullptr);
  world.grab({.body = {1}});
  CHECK_THROWS_AS(world.drag_to({std::numeric_limits<double>::quiet_NaN(), 0}), std::invalid_argument);
  CHECK(world.hand_inputs().size() == 1);
  // What it holds goes: so does the hand.
  world.edit([](Scene& scene) { scene.remove(BodyId{1}); });
  CHECK(world.hand() == nullptr);
}

}  // namespace cairn
