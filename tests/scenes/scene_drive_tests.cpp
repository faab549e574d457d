// Servos, springs, ratchets, slots, wheels, racks and soft welds from TOML.
#include <doctest/doctest.h>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/constraints/gear_joint.hpp>
#include <cairn/constraints/prismatic_joint.hpp>
#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/constraints/weld_joint.hpp>

#include "scenes/same_joint.hpp"

using namespace cairn;
using namespace cairn::scene_tests;

TEST_CASE("servos, springs and ratchets from a file are those made by hand") {
  check_same_joint<RevoluteJoint>(
      "type = \"revolute\"\na = \"a\"\nb = \"b\"\nanchor = [1, 0]\nratchet = -0.2\n"
      "motor = { speed = 4, max_torque = 5, target = -0.5, rate = 3 }\n"
      "spring = { stiffness = 6, damping = 0.5, rest = \"30 deg\" }\n",
      {.a = a_box,
       .b = b_box,
       .anchor = {1, 0},
       .motor = RevoluteJoint::Motor{.speed = 4, .max_torque = 5, .target = -0.5, .rate = 3},
       .spring = JointSpring{.softness = SpringSoftness{.stiffness = 6, .damping = 0.5}, .rest = pi / 6},
       .ratchet = -0.2});
  check_same_joint<PrismaticJoint>(
      "type = \"prismatic\"\na = \"a\"\nb = \"b\"\naxis = [1, 2]\nratchet = 0.1\n"
      "motor = { speed = 4, max_force = 50, target = 0.3 }\n"
      "spring = { frequency = 2, damping_ratio = 0.3, rest = 0.1 }\n",
      {.a = a_box,
       .b = b_box,
       .anchor = {2, 0},
       .axis = {1, 2},
       .motor = PrismaticJoint::Motor{.speed = 4, .max_force = 50, .target = 0.3},
       .spring = JointSpring{.softness = SwingSoftness{.frequency = 2, .damping_ratio = 0.3}, .rest = 0.1},
       .ratchet = 0.1});
}

TEST_CASE("slots, wheels, soft welds, racks and least lengths from a file are those made by hand") {
  using Kind = PrismaticJoint::Kind;
  check_same_joint<PrismaticJoint>(
      "type = \"slot\"\na = \"a\"\nb = \"b\"\nanchor = [1.5, 0]\nlower = -0.1\nupper = 0.2\n",
      {.a = a_box, .b = b_box, .anchor = {1.5, 0}, .kind = Kind::slot, .lower = -0.1, .upper = 0.2});
  check_same_joint<PrismaticJoint>(
      "type = \"wheel\"\na = \"a\"\nb = \"b\"\nspring = { stiffness = 90, damping = 3 }\n"
      "motor = { speed = 4, max_torque = 5 }\n",
      {.a = a_box,
       .b = b_box,
       .anchor = {2, 0},
       .axis = {0, 1},
       .kind = Kind::wheel,
       .motor = PrismaticJoint::Motor{.speed = 4, .max_force = 5},
       .spring = JointSpring{.softness = SpringSoftness{.stiffness = 90, .damping = 3}}});
  check_same_joint<WeldJoint>(
      "type = \"weld\"\na = \"a\"\nb = \"b\"\nanchor = [1, 0]\nsoftness = { frequency = 3 }\n"
      "bending = { stiffness = 5, damping = 0.1 }\n",
      {.a = a_box,
       .b = b_box,
       .anchor = {1, 0},
       .softness = SwingSoftness{.frequency = 3},
       .bending = SpringSoftness{.stiffness = 5, .damping = 0.1}});
  check_same_joint<GearJoint>(
      "type = \"gear\"\na = \"b\"\nb = \"a\"\ncarrier = \"c\"\nradius_a = 0.5\nmesh = \"rack\"\n"
      "axis = [0, 1]\n",
      {.a = b_box, .b = a_box, .c = c_box, .radius_a = 0.5, .mesh = GearJoint::Mesh::rack, .axis = {0, 1}});
  check_same_joint<DistanceJoint>(
      "type = \"rope\"\na = \"a\"\nb = \"b\"\nlength = 3\nleast = 1.99\nslack_margin = 2\n",
      {.a = a_box,
       .b = b_box,
       .anchor_a = {0, 0},
       .anchor_b = {2, 0},
       .length = 3,
       .kind = DistanceJoint::Kind::rope,
       .least = 1.99,
       .slack_margin = 2});
}
