// Lesson 01. A box on a rod: the error c of the rod where the box is, its derivative j, and what both say
// about motions.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::one_row {

inline constexpr double small_step = 1e-5;  // of central differences: near the best one for double

/// The rod goes from the origin to an anchor on the box.
struct RodSettings {
  Vec2<double> anchor = {3, -4};      // [m]
  double turn = 0;                    // [rad] of the box about the anchor
  Vec3<double> velocity = {0, 0, 0};  // [m/s, m/s, rad/s]
  double lambda = 0;                  // [N] of the rod; negative: it pulls
};

/// A velocity, and how fast it makes the rod longer.
struct Motion {
  std::string name = {};
  Vec3<double> velocity = {0, 0, 0};  // [m/s, m/s, rad/s]
  double rate = 0;                    // j·v [m/s]; 0 where only rounding is left of it
};

/// dc by central differences of step h, and the largest distance from j.
struct Quotient {
  double h = 0;                                      // [m or rad]
  FixedList<double, 3> forward = {}, backward = {};  // [m] c at +h and at -h
  FixedList<double, 3> slope = {};                   // 1, 1, m
  double error = 0;
};

/// Everything that the lesson says about one pose.
struct Rod {
  RodSettings settings = {};
  Snapshot snapshot = {};              // the scene as it stands
  RowSpec<double> row = {};            // of the library's rod
  Pose<double> pose = {};              // of the box
  Vec2<double> local_anchor = {0, 0};  // [m] the anchor in the frame of the box
  Vec2<double> arm = {0, 0};           // [m] from its centre of mass to the anchor
  double length = 0;                   // [m] of the rod
  double error = 0;                    // c [m]
  Vec3<double> jacobian = {0, 0, 0};   // j: 1, 1, m
  Motion motion = {};                  // with settings.velocity
  List<Motion> allowed = {};           // swing, turn about the anchor, and a mixture
  List<Quotient> quotients = {};       // h = 10^-1, 10^-1.5 ... 10^-11
  Vec3<double> force = {0, 0, 0};      // f = j^T lambda [N, N, N m]
};

/// c [m] with the box at this pose.
double error_at(const Rod& rod, const Pose<double>& box);
/// Where the box is after t seconds of this velocity [m/s, m/s, rad/s].
Pose<double> carried(const Pose<double>& pose, const Vec3<double>& velocity, double t);
/// The scene with the box at another pose.
Snapshot moved_to(const Rod& rod, const Pose<double>& pose);
/// A velocity under a row with this j.
Motion motion_of(const Vec3<double>& jacobian, const std::string& name, const Vec3<double>& velocity);
/// The motions that the row leaves of three: swing, turn about the anchor, and a mixture of both.
List<Motion> allowed_motions(const Vec3<double>& jacobian, const Vec2<double>& arm);
Quotient quotient(const Rod& rod, double h);

/// What a step of `h` costs in a central difference of these constraints: coordinates and arms are below 10
/// m, third derivatives below 8 of them while no two anchors are nearer than 1 m, and every c is rounded a
/// few times.
double quotient_tolerance(double h);

// What is printed, checked and drawn.

void print_scene(Lesson& lesson, const Rod& rod);
void print_derivative(Lesson& lesson, const Rod& rod);
void print_motions(Lesson& lesson, const Rod& rod);
void check_derivative(Lesson& lesson, const Rod& rod);
void check_force(Lesson& lesson, const Rod& rod);
CsvTable quotients_table(const Rod& rod);

/// Where, which way, how fast, and how strong.
List<Shot> rod_shots(const Rod& rod);

/// What is drawn of the rod besides the box.
struct RodLook {
  Pose<double> pose = {};          // of the box
  bool close = false;              // only the box and its surroundings
  List<Pose<double>> others = {};  // outlines of the box elsewhere
  bool errors = false;             // c of the box and of the others, as lengths
  bool circles = false;            // level curves of c
  bool direction = false;          // j: an arrow and an arc
  bool force = false;              // j^T lambda: an arrow and an arc
  bool asked = false;              // the velocity at the centre, and what is known of the rod
  bool velocity = false;           // the velocity at the centre and at the anchor
};

/// The pivot, the rod and the box, in a panel.
void draw_rod(Page& page, const Rect& rect, const Rod& rod, const RodLook& look);

}  // namespace cairn::one_row
