// Events of scene files: what they do.
#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <string>

#include <cairn/scenes/scene_file.hpp>
#include <cairn/solvers/iterative/sequential_impulse.hpp>
#include <cairn/world/world.hpp>

using namespace cairn;

namespace {

/// The scene of events.toml with these.
Scene events_of(const std::string& events) {
  std::ifstream file(CAIRN_SOURCE_DIR "/tests/scenes/events.toml");
  return read_scene_text(std::string(std::istreambuf_iterator<char>(file), {}) + events, "my.toml").make();
}

List<std::string> joints_left(const Scene& scene) {
  List<std::string> left;
  for (const auto& joint : scene.joints()) left.push_back(joint->name());
  return left;
}

World<double> event_world_after(const std::string& events, int steps) {
  World<double> world(events_of(events));
  SequentialImpulse<double> solver({.iterations = 20});
  for (int step = 0; step < steps; ++step) world.step(solver);
  return world;
}

}  // namespace

TEST_CASE("a file removes a body with its joints, a joint by its own name, and one of many by its number") {
  const int joints = events_of("").joints().size();
  CHECK(joints ==
        3 + 4 + 4);  // the chain hangs on three pins and its bob on one; the net welds its four bodies
  const auto left = [&](const std::string& name) {
    return event_world_after("[[event]]\ntime = 0\nremove = \"" + name + "\"\n", 1).scene().joints().size();
  };
  CHECK(left("ball") == joints - 1);
  CHECK(left("rod") == joints - 1);
  CHECK(left("chain.3") == joints - 3);  // two pins and a weld
  CHECK(left("chain.joint.4") == joints - 1);
  CHECK(left("net.4") == joints - 1);
  const Scene scene = event_world_after("[[event]]\ntime = 0\nremove = \"chain.joint.1\"\n", 1).scene();
  CHECK(joints_left(scene)[3] == "revolute");
  CHECK(scene.joints()[3]->attachments()[0].body == BodyId{5});  // the first that is left joins chain.1
}

TEST_CASE("a file pushes a body at a point that it names where the body begins") {
  const World<double> world = event_world_after(
      "[[event]]\ntime = 0\nremove = \"rod\"\n"
      "[[event]]\ntime = 0\npush = \"ball\"\nimpulse = [0, -4]\npoint = [3.5, 1]\n",
      1);
  const Vec3<double>& velocity = world.bodies().velocity[BodyId{1}];
  CHECK(velocity.x() == doctest::Approx(0));
  CHECK(velocity.y() == doctest::Approx(-4.0 / 2));          // J / m
  CHECK(velocity.z() == doctest::Approx(0.5 * -4.0 / 1.0));  // r x J / I, I = m r^2 / 2
}

TEST_CASE("a motor keeps what an event does not say, while it rests too") {
  const auto motor_at_end = [](const std::string& events) {
    Scene scene = events_of(events);
    scene.do_events(2);
    return scene.joints()[1]->motor();
  };
  const std::string off = "[[event]]\ntime = 0.5\nmotor = \"axle\"\noff = true\n";
  CHECK_FALSE(motor_at_end(off));
  const auto back = motor_at_end(off + "[[event]]\ntime = 1\nmotor = \"axle\"\nspeed = -3\n");
  REQUIRE(back);
  CHECK(back->speed == -3);
  CHECK(back->max_force == 4);
  // By time, whatever their order in the file.
  const auto early = motor_at_end(
      "[[event]]\ntime = 1\nmotor = \"axle\"\nspeed = 5\n"
      "[[event]]\ntime = 0.5\nmotor = \"axle\"\nspeed = 2\nmax_torque = 9\n");
  REQUIRE(early);
  CHECK(early->speed == 5);
  CHECK(early->max_force == 9);
  Scene scene = events_of("[[event]]\ntime = 1\nmotor = \"slide\"\nmax_force = 2\n");
  scene.do_events(2);
  CHECK(scene.joints()[2]->motor()->max_force == 2);
}

TEST_CASE("joints without a name have one of their own") {
  const std::string weld = "[[joint]]\ntype = \"weld\"\nb = \"ball\"\n";
  CHECK(events_of(weld + weld).joints().size() == events_of("").joints().size() + 2);
}

TEST_CASE("a file says where bodies should end") {
  const List<ExpectedPlace> places =
      read_scene_text(
          "[[body]]\nname = \"ball\"\ncircle = 1\n[expect]\ndrift = 1\n"
          "[[expect.body]]\nname = \"ball\"\nposition = [1, 2]\nwithin = 0.05\n",
          "my.toml")
          .expectations.places;
  REQUIRE(places.size() == 1);
  CHECK(places[0].body == BodyId{1});
  CHECK(places[0].position == Vec2<double>(1, 2));
  CHECK(places[0].within == 0.05);
}
