// Scene files: events that wait for a touch, joints that break, and one-way bodies.
#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <string>

#include <cairn/scenes/scene_file.hpp>
#include <cairn/solvers/iterative/sequential_impulse.hpp>
#include <cairn/world/world.hpp>

using namespace cairn;

namespace {

/// The scene of events.toml with these tables.
Scene scene_with(const std::string& tables) {
  std::ifstream file(CAIRN_SOURCE_DIR "/tests/scenes/events.toml");
  return read_scene_text(std::string(std::istreambuf_iterator<char>(file), {}) + tables, "my.toml").make();
}

const SceneEvent& only_event(const Scene& scene) {
  REQUIRE(scene.events().size() == 1);
  return scene.events()[0];
}

}  // namespace

TEST_CASE("an event of a touch says who, by whom, how late and how often") {
  const Scene scene = scene_with(
      "[[event]]\ntouch = \"chain.*\"\nby = \"wall\"\ndelay = 0.5\ntimes = 3\nremove = \"ball\"\n");
  const SceneEvent& event = only_event(scene);
  REQUIRE(event.touch);
  CHECK(event.touch->a == List<BodyId>{{5}, {6}, {7}, {8}});  // with chain.bob
  CHECK(event.touch->b == List<BodyId>{{2}});
  CHECK(event.touch->change == TouchCondition::Change::begins);
  CHECK(event.time == 0.5);
  CHECK(event.times == 3);
  CHECK(std::get<RemoveBody>(event.action).body == BodyId{1});
}

TEST_CASE("an event that waits for a leave counts, each time and by anything, unless the file says more") {
  const Scene scene = scene_with("[[event]]\nleave = \"ball\"\ncount = \"jumps\"\n");
  const SceneEvent& event = only_event(scene);
  REQUIRE(event.touch);
  CHECK(event.touch->change == TouchCondition::Change::ends);
  CHECK(event.touch->b.empty());
  CHECK_FALSE(event.times);
  CHECK(std::get<CountTouches>(event.action).counter == "jumps");
}

TEST_CASE("events of touches stand behind those with times, and may name what these remove") {
  const Scene scene = scene_with(
      "[[event]]\ntouch = \"ball\"\npush = \"ball\"\nimpulse = [1, 0]\n"
      "[[event]]\ntime = 1\nremove = \"ball\"\n");
  REQUIRE(scene.events().size() == 2);
  CHECK_FALSE(scene.events()[0].touch);
  CHECK(scene.events()[1].touch);
}

TEST_CASE("a change is of what it names, and gravity of the scene") {
  const Scene scene = scene_with(
      "[[event]]\ntime = 0\nchange = \"ball\"\nvelocity = [1, 2]\nangular_velocity = 3\nfriction = 0.1\n"
      "restitution = 0.2\nsurface_speed = 0.3\nsensor = true\n"
      "[[event]]\ntime = 0\ngravity = [0, -4]\n[[event]]\ntime = 0\nbreak = \"rod\"\n");
  Scene then = scene;
  then.do_events(0);
  const BodySpec& ball = then.bodies()[{1}].spec;
  CHECK(ball.velocity == Vec2<double>(1, 2));
  CHECK(ball.angular_velocity == 3);
  CHECK(ball.material == Material{.friction = 0.1, .restitution = 0.2, .surface_speed = 0.3});
  CHECK(ball.sensor);
  CHECK(then.settings().gravity == Vec2<double>(0, -4));
  REQUIRE(then.joints().broken().size() == 1);
  CHECK(then.joints().broken()[0].joint->name() == "rod");
  CHECK(then.bodies()[{2}].spec == scene.bodies()[{2}].spec);
}

TEST_CASE("joints of a file break above their strengths, those of rows and chains too") {
  const std::string bodies = "[[body]]\nname = \"a\"\ncircle = 1\nposition = [0, -5]\n";
  const Scene scene =
      read_scene_text(bodies +
                          "[[joint]]\ntype = \"weld\"\nb = \"a\"\nbreak_force = 3\nbreak_torque = \"2 + 2\"\n"
                          "[[joint]]\ntype = \"rod\"\nb = \"a\"\n"
                          "[[chain]]\nn = 2\nlink = 1\nbreak_force = 5\n"
                          "[[row]]\nn = 2\nposition = [9, 0]\nstep = [1, 0]\ncircle = 0.5\njoint = \"pin\"\n"
                          "break_torque = 6\n",
                      "my.toml")
          .make();
  const SceneJoints& joints = scene.joints();
  CHECK(joints.hold(0).strength == JointStrength{.force = 3, .torque = 4});
  CHECK_FALSE(joints.hold(1).strength.is_finite());
  CHECK(joints.hold(2).strength.force == 5);
  CHECK(joints.hold(joints.size() - 1).strength.torque == 6);
}

TEST_CASE("a file says from where a body holds things off") {
  const Scene scene =
      read_scene_text("[[body]]\ntype = \"static\"\nbox = [4, 1]\none_way = [0, 2]\n", "my.toml").make();
  CHECK(scene.bodies()[{1}].spec.filter.one_way == Vec2<double>(0, 2));
}
