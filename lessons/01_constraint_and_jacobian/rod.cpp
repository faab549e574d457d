// Velocities of the box, and where they lead.
#include "lesson.hpp"

namespace cairn::one_row {

Motion motion_of(const Vec3<double>& jacobian, const std::string& name, const Vec3<double>& velocity) {
  const double rate = jacobian.dot(velocity);  // (5)
  const double rounding = 8 * epsilon * velocity.norm();
  return {.name = name, .velocity = velocity, .rate = std::abs(rate) > rounding ? rate : 0};
}

List<Motion> allowed_motions(const Vec3<double>& jacobian, const Vec2<double>& arm) {
  const Vec2<double> along = jacobian.head<2>();  // the rod, a unit vector
  const Vec2<double> across = perpendicular(along);
  const Vec3<double> swing(across.x(), across.y(), 0);
  const Vec3<double> turn(arm.y(), -arm.x(), 1);  // v = −ω × r: the anchor stands still
  return {motion_of(jacobian, "swing, without turning", swing),
          motion_of(jacobian, "turn about the anchor", turn),
          motion_of(jacobian, "1.25 swing − 0.5 turn", 1.25 * swing - 0.5 * turn)};
}

Pose<double> carried(const Pose<double>& pose, const Vec3<double>& velocity, double t) {
  return {.position = pose.position + t * velocity.head<2>(), .angle = pose.angle + t * velocity.z()};
}

Snapshot moved_to(const Rod& rod, const Pose<double>& pose) {
  Snapshot moved = rod.snapshot;
  moved.bodies[{1}].pose = pose;
  moved.joints[0].anchor_b = pose.world(rod.pose.local(rod.settings.anchor));
  return moved;
}

double quotient_tolerance(double h) {
  const double size = 10;  // [m]
  return 8 * size * h * h / 6 + 8 * epsilon * size / h;
}

}  // namespace cairn::one_row
