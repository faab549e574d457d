// Floor 6. Energy and momentum.
#include <cairn/measure/energy.hpp>

#include <cmath>

#include <cairn/geometry/immersion.hpp>
#include <cairn/geometry/mass.hpp>

namespace cairn {

namespace {

/// [m] Of a disc that has the area of the body.
double disc_radius(const SnapshotBody& body) { return std::sqrt(mass_properties(body.shapes).area / pi); }

/// [J] What bodies of these places have of their mass and the fields of a snapshot.
double attracted_energy(const Snapshot& snapshot) {
  const Fields& fields = snapshot.fields;
  double sum = 0;
  const PerBody<SnapshotBody>& bodies = snapshot.bodies;
  for (const BodyId id : bodies.indices()) {
    const SnapshotBody& body = bodies[id];
    if (!(body.mass > 0)) continue;
    for (const Attraction& star : fields.attractions)
      sum += body.mass * attraction_potential(star.point - body.pose.position, star.strength, star.radius);
    for (BodyId other = {1}; fields.gravitation != 0 && other < id; ++other.index) {
      const double near = disc_radius(body) + disc_radius(bodies[other]);
      sum += body.mass * attraction_potential(bodies[other].pose.position - body.pose.position,
                                              fields.gravitation * bodies[other].mass, near);
    }
  }
  return sum;
}

/// [J] The water that bodies displace stands as high as the level: density times gravity times the area below
/// it, times the depth of its middle.
double displaced_energy(const Snapshot& snapshot) {
  if (!snapshot.fields.water) return 0;
  const Water& water = *snapshot.fields.water;
  const Vec2<double> up = up_direction(snapshot.gravity);
  double sum = 0;
  for (const SnapshotBody& body : snapshot.bodies) {
    if (body.type != BodyType::dynamic) continue;
    const AreaMoments part = immersed(body.shapes, body.pose, up, water.level);
    const double depth = water.level - up.dot(body.pose.position);  // of the centre of mass
    sum += part.area * depth - up.dot(part.first);
  }
  return water.density * snapshot.gravity.norm() * sum;
}

}  // namespace

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
  return sum + attracted_energy(snapshot) + displaced_energy(snapshot);
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
