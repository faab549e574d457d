// Events of scene files: what they do, and what a mistake is answered.
#include <doctest/doctest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "scenes/scene_file.hpp"
#include "solvers/iterative/sequential_impulse.hpp"
#include "world/world.hpp"

using namespace cairn;

namespace {

/// A disc that rests on its rod, a wheel with a motor, a slide with one, and a chain.
const std::string event_scene =
    "gravity = [0, 0]\n"
    "[[body]]\nname = \"ball\"\ncircle = 1\nmass = 2\nposition = [3, 1]\n"
    "[[body]]\nname = \"wall\"\ntype = \"static\"\nbox = [1, 1]\nposition = [-9, 0]\n"
    "[[body]]\nname = \"wheel\"\ncircle = 1\nmass = 2\nposition = [8, 0]\n"
    "[[body]]\nname = \"slider\"\nbox = [1, 1]\nmass = 1\nposition = [12, 0]\n"
    "[[joint]]\nname = \"rod\"\ntype = \"rod\"\nb = \"ball\"\nanchor_a = [3, 5]\n"
    "[[joint]]\nname = \"axle\"\ntype = \"revolute\"\nb = \"wheel\"\nmotor = { speed = 0, max_torque = 4 }\n"
    "[[joint]]\nname = \"slide\"\ntype = \"prismatic\"\nb = \"slider\"\nmotor = { speed = 0, max_force = 4 "
    "}\n"
    "[[chain]]\nn = 3\nlink = 1\nfrom = [20, 0]\nbob = { radius = 0.5 }\n"
    "[[joint]]\nname = \"net\"\ntype = \"weld\"\nb = \"chain.*\"\n";

Scene events_of(const std::string& events) { return read_scene_text(event_scene + events, "my.toml").make(); }

std::string event_refusal(const std::string& events) {
  try {
    events_of(events);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// What is refused in the file, behind its place.
std::string event_mistake(const std::string& event) {
  const std::string text = event_refusal("[[event]]\n" + event);
  const std::size_t place = text.find(": ");
  return place == std::string::npos ? text : text.substr(place + 2);
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

TEST_CASE("a mistake in an event is answered with its place, the rule and the value") {
  const auto lines_before = std::count(event_scene.begin(), event_scene.end(), '\n');
  CHECK(event_refusal("[[event]]\ntime = 1\nremove = \"bal\"\n") ==
        "my.toml:" + std::to_string(lines_before + 3) +
            ":10: event[1].remove must be the name of a body or a joint (ball?), got \"bal\"");
  const std::string time = "time = 1\n", push = "push = \"ball\"\nimpulse = [1, 0]\n";
  CHECK(event_mistake("time = -1\n" + push) == "event[1].time must be a number >= 0 s, got -1");
  CHECK(event_mistake("time = 2\n" + push) ==
        "event[1].time must be before the end of the scene, which is at 2 s, got 2");
  CHECK(event_mistake(push) ==
        "event[1].time must be given: a number >= 0 s (carried out before the first step that begins at this "
        "time or later)");
  CHECK(event_mistake(time) == "event[1] must be one of remove, push and motor, got none of them");
  CHECK(event_mistake(time + push + "remove = \"rod\"\n") ==
        "event[1] must be one of remove, push and motor, got push and remove");
  CHECK(event_mistake(time + push + "speed = 1\n") ==
        "event[1].speed must be left out of an event without motor, got 1");
  CHECK(event_mistake(time + "remove = \"ground\"\n") ==
        "event[1].remove must be the name of a body other than the ground, or of a joint, got \"ground\"");
  CHECK(event_mistake(time + "push = \"ball\"\n") ==
        "event[1].impulse must be given for a push: impulse = [1, 0], got nothing");
  CHECK(event_mistake(time + "push = \"wall\"\nimpulse = [1, 0]\n") ==
        "event[1].push must be the name of a dynamic body, got \"wall\"");
  CHECK(event_mistake(time + "push = \"rod\"\nimpulse = [1, 0]\n") ==
        "event[1].push must be the name of a body: ground, ball, wall, wheel, slider, chain.1, chain.2, "
        "chain.3 "
        "and so on, got \"rod\"");
}

TEST_CASE("a mistake in the event of a motor, or about what is gone, is answered likewise") {
  const std::string time = "time = 1\n";
  CHECK(event_mistake(time + "motor = \"axl\"\noff = true\n") ==
        "event[1].motor must be the name of a joint (axle?), got \"axl\"");
  CHECK(event_mistake(time + "motor = \"rod\"\noff = true\n") ==
        "event[1].motor must be the name of a joint with a motor, got \"rod\"");
  CHECK(event_mistake(time + "motor = \"chain.joint.2\"\nspeed = 1\n") ==
        "event[1].motor must be the name of a joint with a motor, got \"chain.joint.2\"");
  CHECK(event_mistake(time + "motor = \"axle\"\nspeed = 1\nmax_force = 1\n") ==
        "event[1].max_force must be max_torque for a revolute joint, got 1");
  CHECK(event_mistake(time + "motor = \"axle\"\n") ==
        "event[1].off must be true, or else there is a speed or a max_torque, got neither");
  CHECK(event_mistake(time + "motor = \"slide\"\nspeed = 1\noff = true\n") ==
        "event[1].off must be true, or else there is a speed or a max_force, got both");
  CHECK(event_mistake(time + "remove = \"ball\"\n[[event]]\ntime = 1.5\nremove = \"rod\"\n") ==
        "event[2].remove must be the name of what no event before has removed, got \"rod\"");
  CHECK(event_mistake(
            "time = 1.5\npush = \"ball\"\nimpulse = [1, 0]\n[[event]]\ntime = 1\nremove = \"ball\"\n") ==
        "event[1].push must be the name of what no event before has removed, got \"ball\"");
}

TEST_CASE("a joint may have a name, which is that of nothing else") {
  const auto refusal = [](const std::string& text) {
    try {
      read_scene_text("[[body]]\nname = \"ball\"\ncircle = 1\n" + text, "my.toml");
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string weld = "[[joint]]\ntype = \"weld\"\nb = \"ball\"\n";
  CHECK(refusal(weld + weld).empty());  // joint.1 and joint.2
  CHECK(refusal(weld + "name = \"ball\"\n") ==
        "my.toml:7:8: joint[1].name must be a name that nothing else has, got \"ball\" once more");
  CHECK(refusal(weld + "name = \"my.weld\"\n") ==
        "my.toml:7:8: joint[1].name must be 1 to 60 letters, digits, _ and -, got \"my.weld\"");
}

TEST_CASE("a file says where bodies should end, and not where what is gone should") {
  const std::string place = "[[expect.body]]\nname = \"ball\"\nposition = [1, 2]\nwithin = 0.05\n";
  const List<ExpectedPlace> places =
      read_scene_text(event_scene + "[expect]\ndrift = 1\n" + place, "my.toml").expectations.places;
  REQUIRE(places.size() == 1);
  CHECK(places[0].body == BodyId{1});
  CHECK(places[0].position == Vec2<double>(1, 2));
  CHECK(places[0].within == 0.05);
  const auto mistake = [](const std::string& text) {
    const std::string refusal = event_refusal(text);
    return refusal.substr(refusal.find(": ") + 2);
  };
  CHECK(mistake("[expect]\nstands = 1\n" + place) ==
        "expect.stands must be left out where bodies have places to end in, got 1");
  CHECK(mistake(place + "[[event]]\ntime = 1\nremove = \"ball\"\n") ==
        "expect.body[1].name must be the name of a body that no event removes, got \"ball\"");
  CHECK(mistake("[[expect.body]]\nname = \"bal\"\nposition = [1, 2]\nwithin = 0.05\n") ==
        "expect.body[1].name must be the name of a body (ball?), got \"bal\"");
  CHECK(mistake("[[expect.body]]\nname = \"ball\"\nposition = [1, 2]\nwithin = 0\n") ==
        "expect.body[1].within must be a number > 0 m, got 0");
}
