// Floor 5. What a world looked like at one instant: plain values in double, for measuring and drawing.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include <cairn/constraints/joint_traits.hpp>
#include <cairn/dynamics/body.hpp>
#include <cairn/dynamics/fields.hpp>
#include <cairn/geometry/shape.hpp>
#include <cairn/math/list.hpp>
#include <cairn/math/shared_list.hpp>
#include <cairn/world/joint_id.hpp>

namespace cairn {

/// One body.
struct SnapshotBody {
  BodyType type = BodyType::static_body;  // static, kinematic or dynamic
  Pose<double> pose = {};                 // of the centre of mass
  Vec3<double> velocity = {0, 0, 0};      // [m/s, m/s, rad/s]
  double mass = 0;                        // [kg]; 0 where it cannot be moved
  double inertia = 0;                     // [kg m^2]; 0 where it cannot be turned
  double gravity_scale = 1;               // how many times the gravity of the scene it feels
  bool awake = true;                      // takes part in the steps
  bool removed = false;                   // an empty place, where a body of the scene was
  bool sensor = false;                    // is seen to touch, and neither pushes nor is pushed
  CollisionFilter filter = {};            // with which others it collides
  double surface_speed = 0;               // [m/s] with which its surface runs around it
  SharedList<Shape<double>> shapes = {};  // in the frame of `pose`
};

/// One contact point.
struct SnapshotContact {
  BodyId a = {};                   // of its first shape
  BodyId b = {};                   // of its second shape
  Vec2<double> position = {0, 0};  // [m]
  Vec2<double> normal = {0, 0};    // from a to b
  double separation = 0;           // [m], negative in overlap
  double normal_impulse = 0;       // [N s], on b along the normal
  double friction_impulse =
      0;                // [N s], on b along the normal turned by -90 degrees (right, where the normal is up)
  double friction = 0;  // mu of the pair
  bool is_new = false;  // was not there in the step before
  std::uint32_t feature = 0;  // which features touch: the same number in the next step
};

/// One joint, as far as it can be drawn and measured.
struct SnapshotJoint {
  JointId id = {};                  // in the scene; of a hand -1
  std::string name = {};            // Constraint::name()
  JointTraits traits = {};          // Constraint::traits()
  BodyId a = {};                    // where it begins
  BodyId b = {};                    // where it ends
  Vec2<double> anchor_a = {0, 0};   // [m], world
  Vec2<double> anchor_b = {0, 0};   // [m], world
  List<Vec2<double>> between = {};  // [m], world: where a rope goes on its way from a to b
  List<Vec2<double>> groove = {};   // [m], world: the ends of the line that b slides along; empty: none
  double drift = 0;                 // [m or rad], norm of what its rigid rows lack
  Vec2<double> impulse = {0, 0};    // [N s], on b, world
  double energy = 0;                // [J] that its springs hold
};

/// A force from outside, at work.
struct SnapshotForce {
  BodyId body = {};             // that it pulls at
  Vec2<double> point = {0, 0};  // [m] world
  Vec2<double> force = {0, 0};  // [N] world
  double torque = 0;            // [N m]
};

/// The way that a kinematic body is led along.
struct SnapshotPath {
  BodyId body = {};                // that follows it
  List<Vec2<double>> points = {};  // [m] world, of the centre of mass; back at the first where it goes round
};

/// A joint that has broken: its ends are where they are now.
struct SnapshotBreak {
  SnapshotJoint joint = {};  // without impulse
  double time = 0;           // [s] when it broke
  double force = 0;          // [N] that it held then; 0 where an event broke it
  double torque = 0;         // [N m] likewise
};

/// What events have counted.
struct SnapshotCounter {
  std::string name = {};  // CountTouches::counter
  int count = 0;          // of all events that count for it
};

/// A world at one instant.
struct Snapshot {
  double time = 0;                      // [s]
  int step = 0;                         // how many were taken before
  double dt = 0;                        // [s] of the last substep: impulse / dt is the paper's lambda
  Vec2<double> gravity = {0, 0};        // [m/s^2]
  Fields fields = {};                   // of the scene
  List<SnapshotForce> forces = {};      // that act now, by their beginnings
  List<SnapshotPath> paths = {};        // of the scene, by their beginnings
  PerBody<SnapshotBody> bodies = {};    // index 0 is the ground
  List<SnapshotContact> contacts = {};  // ordered by the shapes that touch
  List<SnapshotJoint> joints = {};      // in the order of the scene
  /// Bodies that a joint keeps from colliding, or of which one passes the other, which is one-way; sorted.
  List<std::pair<BodyId, BodyId>> apart = {};
  List<std::pair<BodyId, BodyId>> sensed = {};  // what touches a sensor: as StepRecord::sensed
  List<SnapshotBreak> broken = {};              // in the order in which they broke
  List<SnapshotCounter> counters = {};          // by their names
};

}  // namespace cairn
