// Floor 6. Energy and momentum.
#include <cairn/measure/energy.hpp>

namespace cairn {

double kinetic_energy(const SnapshotBody& body) {
  const Vec2<double> v = body.velocity.head<2>();
  return 0.5 * (body.mass * v.squaredNorm() + body.inertia * body.velocity.z() * body.velocity.z());
}

double kinetic_energy(const Snapshot& snapshot) {
  double sum = 0;
  for (const SnapshotBody& body : snapshot.bodies) sum += kinetic_energy(body);
  return sum;
}

double potential_energy(const Snapshot& snapshot) {
  double sum = 0;
  for (const SnapshotBody& body : snapshot.bodies) {
    sum -= body.mass * body.gravity_scale * snapshot.gravity.dot(body.pose.position);
  }
  for (const SnapshotJoint& joint : snapshot.joints) sum += joint.energy;
  return sum;
}

double total_energy(const Snapshot& snapshot) {
  return kinetic_energy(snapshot) + potential_energy(snapshot);
}

Vec3<double> momentum(const Snapshot& snapshot) {
  Vec3<double> sum = Vec3<double>::Zero();
  for (const SnapshotBody& body : snapshot.bodies) {
    const Vec2<double> p = body.mass * body.velocity.head<2>();
    sum += Vec3<double>(p.x(), p.y(), body.inertia * body.velocity.z() + cross(body.pose.position, p));
  }
  return sum;
}

}  // namespace cairn
