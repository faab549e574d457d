// Fields, forces and paths of scene files: what arrives, and where points are counted from.
#include <doctest/doctest.h>

#include <cairn/scenes/scene_file.hpp>

using namespace cairn;

TEST_CASE("fields, forces and paths of a file are those made by hand") {
  const Scene scene = read_scene_text(R"(
wind = [1, 2]
gravitation = 3
[water]
level = 4
density = 5
drag = 6
flow = [7, 8]
[[attraction]]
point = [1, -1]
strength = 9
radius = 0.5
[[attraction]]
strength = -2
[[body]]
name = "engine"
polygon = [[0, 0], [2, 0], [0, 1]]
position = [10, 20]
angle = "90 deg"
drag = 0.25
[[body]]
name = "lift"
type = "kinematic"
polygon = [[0, 0], [3, 0], [0, 3]]
position = [1, 1]
[[force]]
body = "engine"
force = [0, 4]
torque = -1
point = [10, 21]
turns = true
time = 0.5
seconds = 2
[[path]]
body = "lift"
points = [[5, 1], [5, 7]]
speed = 3
kind = "to and fro"
time = 1
)",
                                      "my.toml")
                          .make();
  CHECK(scene.settings().fields ==
        Fields{.wind = {1, 2},
               .water = Water{.level = 4, .density = 5, .drag = 6, .flow = {7, 8}},
               .attractions = {{.point = {1, -1}, .strength = 9, .radius = 0.5}, {.strength = -2}},
               .gravitation = 3});
  const SceneBody &engine = scene.bodies()[{1}], &lift = scene.bodies()[{2}];
  CHECK(engine.spec.damping.quadratic == 0.25);
  REQUIRE(scene.events().size() == 2);
  const auto& pull = std::get<ApplyForce>(scene.events()[0].action);
  CHECK(scene.events()[0].time == 0.5);
  CHECK(pull.body == BodyId{1});
  CHECK(pull.seconds == 2);
  CHECK(pull.torque == -1);
  CHECK(pull.turns);
  // What is along y in the world is along x of a body that stands at 90 degrees.
  CHECK((pull.force - Vec2<double>(4, 0)).norm() < 1e-15);
  CHECK((engine.pose.world(pull.point) - Vec2<double>(10, 21)).norm() < 1e-14);
  const auto& path = std::get<FollowPath>(scene.events()[1].action);
  // Points are of the body's position; its middle is (1, 1) from it.
  CHECK(path.points == List<Vec2<double>>{lift.pose.position, {6, 2}, {6, 8}});
  CHECK(path.speed == 3);
  CHECK(path.kind == PathKind::to_and_fro);
}

TEST_CASE(
    "a force or a path of \"row.*\" is one for each of the row, and lasts for ever from the beginning") {
  const Scene scene = read_scene_text(
                          "[[row]]\nn = 3\nfirst = [0, 0]\nstep = [2, 0]\ncircle = 0.5\n"
                          "[[force]]\nbody = \"row.*\"\ntorque = 1\n",
                          "my.toml")
                          .make();
  REQUIRE(scene.events().size() == 3);
  for (int i = 0; i < 3; ++i) {
    const auto& pull = std::get<ApplyForce>(scene.events()[i].action);
    CHECK(pull.body == BodyId{i + 1});
    CHECK(pull.seconds == std::numeric_limits<double>::infinity());
    CHECK(scene.events()[i].time == 0);
  }
}

TEST_CASE("forces and paths of a file may wait for a touch, a path for one alone") {
  const Scene scene = read_scene_text(
                          "[[body]]\nname = \"ball\"\ncircle = 0.5\nposition = [0, 3]\n"
                          "[[body]]\nname = \"lift\"\ntype = \"kinematic\"\nbox = [1, 1]\n"
                          "[[force]]\nbody = \"ball\"\nforce = [0, 4]\nseconds = 1\n"
                          "touch = \"ball\"\nby = \"lift\"\ndelay = 0.5\ntimes = 3\n"
                          "[[path]]\nbody = \"lift\"\npoints = [[0, 4]]\nspeed = 1\nleave = \"ball\"\n",
                          "my.toml")
                          .make();
  REQUIRE(scene.events().size() == 2);
  const SceneEvent &pull = scene.events()[0], &path = scene.events()[1];
  REQUIRE(pull.touch);
  CHECK(pull.touch->a == List<BodyId>{{1}});
  CHECK(pull.touch->b == List<BodyId>{{2}});
  CHECK(pull.time == 0.5);
  CHECK(pull.times == 3);
  REQUIRE(path.touch);
  CHECK(path.touch->change == TouchCondition::Change::ends);
  CHECK(path.times == 1);
}
