// One rod, one box, one row.
#include "rod.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cairn::one_row {

namespace {

constexpr double half_box = 0.5;  // [m] from the middle of the box to the anchor on its side

RowSpec<double> row_at(const Constraint& joint, const Pose<double>& pose) {
  RowSpecs<double> rows;
  joint.append_rows({Pose<double>{}, pose}, rows);
  return rows.at(0);
}

Motion motion(const Rod& rod, const std::string& name, const Vec3<double>& velocity) {
  const double rate = rod.jacobian.dot(velocity);
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * velocity.norm();
  return {.name = name, .velocity = velocity, .rate = std::abs(rate) > rounding ? rate : 0};
}

/// The two freedoms that one row leaves of three, and a mixture of both.
std::vector<Motion> allowed_motions(const Rod& rod) {
  const Vec2<double> along = rod.jacobian.head<2>();  // of the rod, a unit vector
  const Vec2<double> across = perpendicular(along);
  const Vec3<double> swing(across.x(), across.y(), 0);
  const Vec3<double> turn(rod.arm.y(), -rod.arm.x(), 1);  // v = −ω × r: the anchor stands still
  return {motion(rod, "swing, without turning", swing), motion(rod, "turn about the anchor", turn),
          motion(rod, "1.25 swing − 0.5 turn", 1.25 * swing - 0.5 * turn)};
}

}  // namespace

double error_at(const Rod& rod, const Pose<double>& pose) { return row_at(*rod.joint, pose).error; }

Pose<double> carried(const Pose<double>& pose, const Vec3<double>& velocity, double t) {
  return {.position = pose.position + t * velocity.head<2>(), .angle = pose.angle + t * velocity.z()};
}

Snapshot moved_to(const Rod& rod, const Pose<double>& pose) {
  Snapshot moved = rod.snapshot;
  moved.bodies[1].pose = pose;
  moved.joints[0].anchor_b = pose.world(rod.pose.local(rod.settings.anchor));
  return moved;
}

Quotient quotient(const Rod& rod, double h) {
  Quotient result{.h = h};
  for (int k = 0; k < 3; ++k) {
    const auto at = static_cast<std::size_t>(k);
    result.forward[at] = error_at(rod, carried(rod.pose, Vec3<double>::Unit(k), h));
    result.backward[at] = error_at(rod, carried(rod.pose, Vec3<double>::Unit(k), -h));
    result.slope[at] = (result.forward[at] - result.backward[at]) / (2 * h);
    result.error = std::max(result.error, std::abs(result.slope[at] - rod.jacobian(k)));
  }
  return result;
}

double quotient_tolerance(double h) {
  const double size = 10;  // [m]
  return 8 * size * h * h / 6 + 8 * std::numeric_limits<double>::epsilon() * size / h;
}

Rod hang_box(const RodSettings& settings) {
  Rod rod{.settings = settings};
  rod.arm = Rotation<double>(settings.turn) * Vec2<double>(-half_box, 0);
  Scene scene({.gravity = {0, 0}});
  const BodyId body = scene.add({.shapes = {box(2 * half_box, 2 * half_box)},
                                 .position = settings.anchor - rod.arm,
                                 .angle = settings.turn,
                                 .velocity = settings.velocity.head<2>(),
                                 .angular_velocity = settings.velocity.z(),
                                 .mass = 1});
  scene.join<DistanceJoint>({.a = ground, .b = body, .anchor_a = {0, 0}, .anchor_b = settings.anchor});
  const World<double> world(scene);
  rod.snapshot = snapshot(world);
  rod.joint = scene.joints()[0];
  rod.pose = world.bodies().pose[1];
  rod.length = settings.anchor.norm();
  const RowSpec<double> row = row_at(*rod.joint, rod.pose);
  rod.error = row.error;
  rod.jacobian = row.jacobian_b;
  rod.asked = {motion(rod, "first", {0.8, 0.6, 0}), motion(rod, "second", {0.6, -0.8, 0}),
               motion(rod, "third", {1, 0.5, -0.5})};
  rod.allowed = allowed_motions(rod);
  for (int half = 2; half <= 22; ++half) rod.quotients.push_back(quotient(rod, std::pow(10, -0.5 * half)));
  rod.force = rod.jacobian * settings.lambda;
  return rod;
}

}  // namespace cairn::one_row
