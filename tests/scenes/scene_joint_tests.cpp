// Joints from TOML: they do what the same joints do that are made by hand.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include <cairn/constraints/differential_joint.hpp>
#include <cairn/constraints/distance_joint.hpp>
#include <cairn/constraints/drag_joint.hpp>
#include <cairn/constraints/friction_joint.hpp>
#include <cairn/constraints/gear_joint.hpp>
#include <cairn/constraints/prismatic_joint.hpp>
#include <cairn/constraints/pulley_joint.hpp>
#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/constraints/weld_joint.hpp>
#include <cairn/measure/violation.hpp>
#include <cairn/scenes/scene_file.hpp>
#include <cairn/study/trial.hpp>
#include <cairn/world/world.hpp>

#include "scenes/same_joint.hpp"

using namespace cairn;
using namespace cairn::scene_tests;

TEST_CASE("rods, ropes and springs from a file are those made by hand") {
  using Kind = DistanceJoint::Kind;
  check_same_joint<DistanceJoint>(
      "type = \"rod\"\na = \"a\"\nb = \"b\"\nanchor_a = [0.5, 0]\nanchor_b = [1.5, 0.25]\nlength = 1.2\n",
      {.a = a_box, .b = b_box, .anchor_a = {0.5, 0}, .anchor_b = {1.5, 0.25}, .length = 1.2});
  check_same_joint<DistanceJoint>("type = \"rod\"\na = \"a\"\nb = \"b\"\n",
                                  {.a = a_box, .b = b_box, .anchor_a = {0, 0}, .anchor_b = {2, 0}});
  check_same_joint<DistanceJoint>(
      "type = \"rope\"\nb = \"b\"\nanchor_a = [2, 3]\nslack_margin = 0.1\n"
      "softness = { frequency = 3, damping_ratio = 0.2 }\n",
      {.a = ground,
       .b = b_box,
       .anchor_a = {2, 3},
       .anchor_b = {2, 0},
       .kind = Kind::rope,
       .softness = SwingSoftness{.frequency = 3, .damping_ratio = 0.2},
       .slack_margin = 0.1});
  check_same_joint<DistanceJoint>(
      "type = \"spring\"\na = \"a\"\nb = \"c\"\nlength = 3\ncollide = \"on\"\n"
      "softness = { stiffness = 40, damping = 2 }\n",
      {.a = a_box,
       .b = c_box,
       .anchor_a = {0, 0},
       .anchor_b = {4, 0},
       .length = 3,
       .kind = Kind::spring,
       .softness = SpringSoftness{.stiffness = 40, .damping = 2}},
      JointCollision::on);
}

TEST_CASE("pins, slides and welds from a file are those made by hand, with limits and motors") {
  check_same_joint<RevoluteJoint>("type = \"revolute\"\nb = \"b\"\n",
                                  {.a = ground, .b = b_box, .anchor = {2, 0}});
  check_same_joint<RevoluteJoint>(
      "type = \"revolute\"\na = \"a\"\nb = \"b\"\nanchor = [1, 0]\nlower = -0.2\nupper = 0.3\n"
      "limit_margin = 0.1\nmotor = { speed = 4, max_torque = 5 }\n",
      {.a = a_box,
       .b = b_box,
       .anchor = {1, 0},
       .lower = -0.2,
       .upper = 0.3,
       .limit_margin = 0.1,
       .motor = RevoluteJoint::Motor{.speed = 4, .max_torque = 5}});
  check_same_joint<PrismaticJoint>(
      "type = \"prismatic\"\nb = \"b\"\nanchor = [2, 0.1]\naxis = [1, 2]\nlower = -0.1\nupper = 0.2\n"
      "limit_margin = 0.3\nmotor = { speed = 4, max_force = 50 }\n",
      {.a = ground,
       .b = b_box,
       .anchor = {2, 0.1},
       .axis = {1, 2},
       .lower = -0.1,
       .upper = 0.2,
       .limit_margin = 0.3,
       .motor = PrismaticJoint::Motor{.speed = 4, .max_force = 50}});
  check_same_joint<WeldJoint>("type = \"weld\"\na = \"a\"\nb = \"b\"\nanchor = [1, 0]\ncollide = \"off\"\n",
                              {.a = a_box, .b = b_box, .anchor = {1, 0}}, JointCollision::off);
}

TEST_CASE("ropes over rollers, gears and differentials from a file are those made by hand") {
  check_same_joint<PulleyJoint>(
      "type = \"pulley\"\nkind = \"taut\"\nslack_margin = 0.2\nlength = 6.1\n"
      "ends = [{ body = \"a\", anchor = [0, 0.5], roller = [0, 2.5] },\n"
      "        { body = \"b\", anchor = [2, 0.25], roller = [2, 2.25], parts = 2 }]\n",
      {.ends = {{.body = a_box, .anchor = {0, 0.5}, .roller = {0, 2.5}},
                {.body = b_box, .anchor = {2, 0.25}, .roller = {2, 2.25}, .parts = 2}},
       .length = 6.1,
       .kind = PulleyJoint::Kind::taut,
       .slack_margin = 0.2});
  check_same_joint<PulleyJoint>(
      "type = \"pulley\"\nends = [{ body = \"c\", anchor = [4, -0.5], roller = [2.5, 0.2], carrier = \"b\", "
      "kind = \"drum\" }]\n",
      {.ends = {{.body = c_box,
                 .anchor = {4, -0.5},
                 .roller = {2.5, 0.2},
                 .carrier = b_box,
                 .kind = PulleyJoint::Roller::drum}}});
  check_same_joint<GearJoint>(
      "type = \"gear\"\na = \"a\"\nb = \"b\"\ncarrier = \"c\"\nradius_a = 2\nradius_b = 0.5\nmesh = "
      "\"internal\"\n",
      {.a = a_box,
       .b = b_box,
       .c = c_box,
       .radius_a = 2,
       .radius_b = 0.5,
       .mesh = GearJoint::Mesh::internal});
  check_same_joint<DifferentialJoint>("type = \"differential\"\na = \"a\"\nb = \"b\"\ncase = \"c\"\n",
                                      {.a = a_box, .b = b_box, .c = c_box});
}

TEST_CASE("drags and frictions from a file are those made by hand") {
  check_same_joint<DragJoint>("type = \"drag\"\nb = \"b\"\ntarget = [3, 1]\n",
                              {.body = b_box, .anchor = {2, 0}, .target = {3, 1}});
  check_same_joint<DragJoint>(
      "type = \"drag\"\nb = \"b\"\nanchor = [2.4, 0]\ntarget = [3, 1]\nmax_force = 3\n"
      "softness = { frequency = 2, damping_ratio = 1 }\n",
      {.body = b_box,
       .anchor = {2.4, 0},
       .target = {3, 1},
       .softness = SwingSoftness{.frequency = 2, .damping_ratio = 1},
       .max_force = 3});
  check_same_joint<FrictionJoint>(
      "type = \"friction\"\nb = \"b\"\nanchor = [2.2, 0]\nmax_force = 2\nmax_torque = 0.1\n"
      "shape = \"aligned square\"\n",
      {.b = b_box,
       .anchor = Vec2<double>(2.2, 0),
       .max_force = 2,
       .max_torque = 0.1,
       .shape = FrictionShape::aligned_square});
}

TEST_CASE(
    "rows of bodies that are joined to their neighbours have 2 n m - n - m joints, halfway between them") {
  const std::string net =
      "[[row]]\nname = \"net\"\nn = 4\nrows = 3\nfirst = [1, 2]\nstep = [2, 0]\nrow_step = [0, -1]\ncircle = "
      "0.3\n";
  CHECK(read_scene_text(net, "net.toml").make().joints().empty());
  for (const std::string kind : {"pin", "weld", "rod"}) {
    CAPTURE(kind);
    const Scene scene = read_scene_text(net + "joint = \"" + kind + "\"\n", "net.toml").make();
    REQUIRE(scene.joints().size() == 2 * 4 * 3 - 4 - 3);
    int upright = 0;
    for (const auto& joint : scene.joints()) {
      const auto& places = joint->attachments();
      const Vec2<double> a = scene.bodies()[places[0].body].pose.position,
                         b = scene.bodies()[places[1].body].pose.position;
      const Vec2<double> way = b - a;
      CHECK((way == Vec2<double>(2, 0) || way == Vec2<double>(0, -1)));
      upright += way.x() == 0;
      // Bodies do not turn yet: anchors are in the axes of the world.
      CHECK(places[0].anchor == (kind == "rod" ? Vec2<double>(0, 0) : Vec2<double>(way / 2)));
      CHECK(places[1].anchor == (kind == "rod" ? Vec2<double>(0, 0) : Vec2<double>(-way / 2)));
    }
    CHECK(upright == 4 * 2);
  }
}

TEST_CASE("a body that is displaced begins where it was put, and its joints with an error") {
  const Scene scene =
      read_scene_text(
          "[[body]]\nname = \"bob\"\ncircle = 0.2\nposition = [1, 0]\ndisplaced = [0.5, -0.25]\n"
          "displaced_angle = 0.125\n[[joint]]\ntype = \"revolute\"\nb = \"bob\"\nanchor = [1, 0]\n",
          "open.toml")
          .make();
  CHECK(scene.bodies()[{1}].pose.position == Vec2<double>(1.5, -0.25));
  CHECK(scene.bodies()[{1}].pose.angle == 0.125);
  CHECK(worst_joint_drift(snapshot(World<double>(scene))) ==
        doctest::Approx(std::hypot(0.5, 0.25)).epsilon(1e-15));
}

TEST_CASE("a joint for each of a row is as many joints") {
  const std::string row = "[[row]]\nn = 3\nfirst = [0, 0]\nstep = [2, 0]\ncircle = 0.5\n";
  const Scene scene =
      read_scene_text(row + "[[joint]]\ntype = \"friction\"\nb = \"row.*\"\nmax_force = 1\n", "row.toml")
          .make();
  REQUIRE(scene.joints().size() == 3);
  for (int i = 0; i < 3; ++i) {
    CHECK(scene.joints()[i]->attachments()[1].body == BodyId{i + 1});
  }
}

TEST_CASE("a joint's own frequency is that of the file, and its damping ratio that of the policy") {
  const auto spring = [](const std::string& text) {
    const Scene scene = read_scene_text(three_boxes + "[[joint]]\n" + text, "joint.toml").make();
    return scene.joints().hold(0).soft;
  };
  const SwingSoftness usual = SceneSettings{}.stabilization.joint_soft;
  const std::string weld = "type = \"weld\"\nb = \"b\"\n";
  CHECK_FALSE(spring(weld));
  CHECK(spring(weld + "frequency = 20\n") ==
        SwingSoftness{.frequency = 20, .damping_ratio = usual.damping_ratio});
  CHECK(spring(weld + "frequency = 20\ndamping_ratio = 1\n") ==
        SwingSoftness{.frequency = 20, .damping_ratio = 1});
  CHECK_THROWS_WITH_AS(spring(weld + "damping_ratio = 1\n"),
                       "joint.toml:18:17: joint[1].damping_ratio must be left out, or else given beside a "
                       "frequency, got 1",
                       std::invalid_argument);
  CHECK_THROWS_WITH_AS(
      spring("type = \"rope\"\nb = \"b\"\nfrequency = 5\nsoftness = { frequency = 2 }\n"),
      "joint.toml:18:13: joint[1].frequency must be left out where there is a softness, got 5",
      std::invalid_argument);
}
