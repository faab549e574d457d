// Events that wait for a touch, and what counts touches, held against closed forms.
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

using Change = TouchCondition::Change;

const double touch_dt = 1.0 / 64;  // [s] exact, so that sums of it are

/// A disc of 0.5 m whose lowest point is `height` above a floor; or above a sensor 1 m high, if asked for.
struct FallingDisc {
  explicit FallingDisc(double height, double restitution = 0, SceneSettings settings = {}) {
    settings.dt = touch_dt;
    scene = Scene(settings);
    scene.add_ground();
    disc = scene.add(
        {.shapes = {circle(0.5)}, .position = {0, 0.5 + height}, .material = {.restitution = restitution}});
  }
  void count(const std::string& counter, Change change, std::optional<int> times = {}) {
    scene.add({.action = CountTouches{counter},
               .touch = TouchCondition{.a = {disc}, .b = {ground}, .change = change},
               .times = times});
  }

  Scene scene;
  BodyId disc;
};

/// The first step that ends at least so far down [m]: semi-implicit Euler falls g dt^2 n (n + 1) / 2.
int steps_to_fall(double height) {
  int steps = 0;
  while (10 * touch_dt * touch_dt * steps * (steps + 1) / 2 < height) ++steps;
  return steps;
}

int count_of(const Snapshot& now, const std::string& counter) {
  for (const SnapshotCounter& each : now.counters) {
    if (each.name == counter) return each.count;
  }
  return -1;
}

}  // namespace

TEST_CASE(
    "an event of a touch is done before the step after the one in which the two first push each other") {
  const double height = 2.3;
  for (const int substeps : {1, 4}) {
    for (const double delay : {0.0, 3 * touch_dt}) {
      FallingDisc fall(height, 0, {.substeps = substeps});
      // Substeps fall less in a step: g dt^2 n (n + 1 / substeps) / 2.
      int first = 0;
      while (10 * touch_dt * touch_dt * first * (first + 1.0 / substeps) / 2 < height) ++first;
      fall.scene.add({.time = delay,
                      .action = RemoveBody{fall.disc},
                      .touch = TouchCondition{.a = {fall.disc}, .b = {ground}}});
      const int waits = static_cast<int>(delay / touch_dt);
      CHECK_FALSE(world_after(fall.scene, first + waits).scene().bodies()[fall.disc].removed);
      CHECK(world_after(fall.scene, first + waits + 1).scene().bodies()[fall.disc].removed);
      CHECK(world_after<float>(fall.scene, first + waits + 1).scene().bodies()[fall.disc].removed);
    }
  }
}

TEST_CASE("an elastic disc that bounces n times begins and leaves n touches, and times says how many count") {
  FallingDisc fall(0.5, 1);  // back after 2 sqrt(2 h / g) = 0.632 s: six touches in 3.79 s
  fall.count("begun", Change::begins);
  fall.count("left", Change::ends);
  fall.count("few", Change::begins, 2);
  const Snapshot now = snapshot(world_after(fall.scene, static_cast<int>(3.6 / touch_dt)));
  CHECK(count_of(now, "begun") == 6);
  CHECK(count_of(now, "left") == 6);
  CHECK(count_of(now, "few") == 2);
  CHECK(count_of(now, "none") == -1);
}

TEST_CASE("what rests goes on to touch, asleep too, and what wakes it changes nothing") {
  FallingDisc fall(0, 0, {.sleeping = Sleeping{}});
  fall.count("begun", Change::begins);
  fall.count("left", Change::ends);
  World<double> world = world_after(fall.scene, 200);
  REQUIRE_FALSE(world.is_awake(fall.disc));
  world.set_velocity(fall.disc, {0, 0, 0});
  take_steps(world, 10);
  REQUIRE(world.is_awake(fall.disc));
  CHECK(count_of(snapshot(world), "begun") == 1);
  CHECK(count_of(snapshot(world), "left") == 0);
  world.set_velocity(fall.disc, {0, 3, 0});
  take_steps(world, 10);
  CHECK(count_of(snapshot(world), "left") == 1);
}

TEST_CASE("a sensor is entered in the first step that begins in it, and left likewise") {
  Scene scene({.dt = touch_dt});
  scene.add({.shapes = {circle(0.5)}, .position = {0, 3}});
  const BodyId sensor =
      scene.add({.type = BodyType::static_body, .shapes = {box(4, 1)}, .position = {0, 0}, .sensor = true});
  for (const Change change : {Change::begins, Change::ends}) {
    scene.add({.action = CountTouches{change == Change::begins ? "in" : "out"},
               .touch = TouchCondition{.a = {sensor}, .change = change}});
  }
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = 1});
  // Its lowest point meets the sensor's top after 2 m, its highest one the bottom after 4 m.
  for (int step = 1; step < 80; ++step) {
    world.step(solver);
    CAPTURE(step);
    CHECK(count_of(snapshot(world), "in") == (step > steps_to_fall(2) ? 1 : 0));
    CHECK(count_of(snapshot(world), "out") == (step > steps_to_fall(4) ? 1 : 0));
    CHECK(snapshot(world).sensed.size() == (step > steps_to_fall(2) && step <= steps_to_fall(4) ? 1 : 0));
  }
}

TEST_CASE("each pair of two groups counts, and pairs of others do not") {
  Scene scene({.dt = touch_dt});
  scene.add_ground();
  List<BodyId> discs;
  for (int i = 0; i < 5; ++i)
    discs.push_back(scene.add({.shapes = {circle(0.5)}, .position = {2.0 * i, 0.5 + 0.1 * i}}));
  const BodyId table =
      scene.add({.type = BodyType::static_body, .shapes = {box(1, 1)}, .position = {8, 0.1}});
  scene.add({.action = CountTouches{"some"}, .touch = TouchCondition{.a = {discs[0], discs[1], discs[2]}}});
  scene.add({.action = CountTouches{"table"}, .touch = TouchCondition{.a = discs, .b = {table}}});
  const Snapshot now = snapshot(world_after(scene, 60));
  CHECK(count_of(now, "some") == 3);
  CHECK(count_of(now, "table") == 1);
}

TEST_CASE("events change velocity, friction, gravity and what is a sensor, of what they name alone") {
  Scene scene({.dt = touch_dt});
  scene.add_ground();
  const BodyId lift = scene.add({.type = BodyType::kinematic, .shapes = {box(1, 1)}, .position = {-9, 5}});
  const BodyId sled = scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}, .velocity = {4, 0}});
  const BodyId free = scene.add({.position = {9, 9}, .mass = 1, .inertia = 1});
  scene.add({.time = 0.5, .action = ChangeBody{.body = lift, .velocity = Vec2<double>(0, 2)}});
  scene.add({.time = 0, .action = ChangeBody{.body = sled, .friction = 0}});
  scene.add({.time = 0.5, .action = SetGravity{.gravity = {0, 10}}});
  const World<double> world = world_after(scene, 64);
  CHECK(pose_of(world, lift).position.y() == doctest::Approx(5 + 2 * 0.5).epsilon(1e-13));
  CHECK(velocity_of(world, lift).z() == 0);
  CHECK(velocity_of(world, sled).x() == doctest::Approx(4).epsilon(1e-12));  // nothing rubs
  CHECK(std::abs(velocity_of(world, free).y()) <= 1e-12);                    // 32 steps down, and 32 up
  CHECK(world.scene().bodies()[sled].spec.material.friction == 0);
}

TEST_CASE("copies, edits that change nothing and repeated steps count the same, to the same bits") {
  FallingDisc fall(0.5, 0.8);
  fall.count("begun", Change::begins);
  fall.scene.add({.action = PushBody{.body = fall.disc, .impulse = {0.1, 0.5}},
                  .touch = TouchCondition{.a = {fall.disc}},
                  .times = 3});
  World<double> world = world_after(fall.scene, 20);
  World<double> edited = world;
  for (int i = 0; i < 200; ++i) {
    edited.edit([](Scene&) {});
    take_steps(world, 1);
    take_steps(edited, 1);
  }
  CHECK(go_alike(world, edited));
  CHECK(count_of(snapshot(world), "begun") == count_of(snapshot(edited), "begun"));
  CHECK(count_of(snapshot(world), "begun") >= 4);
}

TEST_CASE("a force that waits for a touch acts from the end of the step that saw it, each time for so long") {
  Scene scene({.gravity = {0, 0}, .dt = touch_dt});
  const BodyId disc =
      scene.add({.shapes = {circle(0.5)}, .position = {touch_dt / 2, 0}, .velocity = {1, 0}, .mass = 2});
  for (const double x : {2.0, 6.0, 10.0})
    scene.add({.type = BodyType::static_body, .shapes = {box(1, 1)}, .position = {x, 0}, .sensor = true});
  const double delay = 4 * touch_dt, seconds = 10 * touch_dt;
  scene.add({.time = delay,
             .action = ApplyForce{.body = disc, .force = {3.2, 0}, .seconds = seconds},
             .touch = TouchCondition{.a = {disc}}});
  // After 64 steps the disc is half a step's way in the first sensor. The step that begins there sees it.
  CHECK(velocity_of(world_after(scene, 65 + 4), disc).x() == 1);
  for (const int steps : {1, 7, 10, 50}) {
    const World<double> world = world_after(scene, 65 + 4 + steps);
    const double pulled = 1.6 * std::min(steps * touch_dt, seconds);
    CHECK(std::abs(velocity_of(world, disc).x() - 1 - pulled) < 1e-14);
    CHECK(snapshot(world).forces.size() == (steps < 10 ? 1 : 0));
  }
  const World<double> end = world_after(scene, 600);
  CHECK(std::abs(velocity_of(end, disc).x() - 1 - 3 * 1.6 * seconds) < 1e-13);
  CHECK(end.scene().events().size() == 2);  // the one that waits and the last; those before are over
}

TEST_CASE("a lift that waits for a touch stays at its first point until then") {
  FallingDisc fall(2);
  const BodyId lift = fall.scene.add(
      {.type = BodyType::kinematic, .shapes = {box(3, 0.5)}, .position = {0, 0.25}, .velocity = {1, 0}});
  const SceneEvent event{.action = FollowPath{.body = lift, .points = {{0, 0.25}, {0, 5}}, .speed = 0.5},
                         .touch = TouchCondition{.a = {lift}, .b = {fall.disc}},
                         .times = 1};
  fall.scene.add(event);
  const int first = steps_to_fall(1.5);
  CHECK(world_after(fall.scene, first).bodies().pose[lift].position == Vec2<double>(0, 0.25));
  for (const int steps : {1, 30, 64}) {
    const World<double> world = world_after(fall.scene, first + steps);
    CHECK((world.bodies().pose[lift].position - Vec2<double>(0, 0.25 + 0.5 * steps * touch_dt)).norm() <
          1e-14);
  }
  SceneEvent twice = event;
  twice.times = 2;
  CHECK_THROWS_AS(fall.scene.add(twice), std::invalid_argument);
}

TEST_CASE("what no event waits for is not looked for, and events of bodies that are gone are forgotten") {
  FallingDisc fall(1);
  CHECK_FALSE(make_plan(fall.scene).watches());
  fall.scene.add({.action = SetGravity{}, .touch = TouchCondition{.a = {fall.disc}}});
  fall.count("begun", Change::begins);
  CHECK(make_plan(fall.scene).extras.touches);
  fall.scene.remove(fall.disc);
  CHECK(fall.scene.events().size() == 1);  // what was counted stays
}

TEST_CASE("events of touches that cannot be are refused") {
  FallingDisc fall(1);
  const BodyId wall = fall.scene.add({.type = BodyType::static_body, .shapes = {box(1, 1)}});
  const auto refused = [&](const SceneEvent& event) {
    CHECK_THROWS_AS(fall.scene.add(event), std::invalid_argument);
  };
  refused({.action = SetGravity{}, .touch = TouchCondition{}});
  refused({.action = SetGravity{}, .touch = TouchCondition{.a = {wall}, .b = {ground}}});
  refused({.action = SetGravity{}, .touch = TouchCondition{.a = {{17}}}});
  refused({.action = SetGravity{}, .touch = TouchCondition{.a = {wall}}, .times = 0});
  refused({.time = -1, .action = SetGravity{}, .touch = TouchCondition{.a = {wall}}});
  refused({.time = 1, .action = CountTouches{"none"}});
  refused({.time = 1, .action = SetGravity{.gravity = {0, std::numeric_limits<double>::infinity()}}});
  refused({.time = 1, .action = ChangeBody{.body = ground, .friction = 1}});
  refused({.time = 1, .action = ChangeBody{.body = fall.disc, .friction = -1}});
  refused({.time = 1, .action = ChangeBody{.body = wall, .velocity = Vec2<double>(1, 0)}});
  refused({.time = 1, .action = BreakJoint{.joint = {3}}});
  CHECK(fall.scene.events().empty());
}
