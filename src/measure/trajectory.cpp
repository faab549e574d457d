// Floor 6. Measures of a run.
#include <cairn/measure/trajectory.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/math/check.hpp>
#include <cairn/measure/violation.hpp>

namespace cairn {

namespace {

const double trajectory_infinity = std::numeric_limits<double>::infinity();

bool all_finite(const Snapshot& snapshot) {
  return std::all_of(snapshot.bodies.begin(), snapshot.bodies.end(), [](const SnapshotBody& body) {
    return body.pose.position.allFinite() && std::isfinite(body.pose.angle) && body.velocity.allFinite();
  });
}

double part_of_scale(double energy, double scale) {
  if (energy == 0) return 0;
  return scale > 0 ? energy / scale : std::copysign(trajectory_infinity, energy);
}

/// Force and moment about the origin of gravity on all bodies [N, N, N m].
Vec3<double> gravity_on(const Snapshot& snapshot) {
  Vec3<double> sum = Vec3<double>::Zero();
  for (const SnapshotBody& body : snapshot.bodies) {
    const Vec2<double> weight = body.mass * body.gravity_scale * snapshot.gravity;
    sum += Vec3<double>(weight.x(), weight.y(), cross(body.pose.position, weight));
  }
  return sum;
}

const SnapshotBody& body_of(const Snapshot& snapshot, BodyId id) { return snapshot.bodies[id]; }

bool is_dynamic(const Snapshot& snapshot, BodyId id) {
  return body_of(snapshot, id).type == BodyType::dynamic;
}

/// Whether something that is not dynamic pushed or pulled.
bool has_outer_impulse(const Snapshot& snapshot) {
  const auto is_outer = [&](const auto& touch) {
    return !is_dynamic(snapshot, touch.a) || !is_dynamic(snapshot, touch.b);
  };
  for (const SnapshotContact& contact : snapshot.contacts) {
    if (is_outer(contact) && (contact.normal_impulse != 0 || contact.friction_impulse != 0)) return true;
  }
  // A joint may also pull without a force, by a moment that a snapshot does not hold.
  return std::any_of(snapshot.joints.begin(), snapshot.joints.end(), is_outer);
}

/// Of the body's point at the contact [m/s]. Contacts stand where the step began: where the body came from.
Vec2<double> velocity_at(const Snapshot& snapshot, BodyId id, const Vec2<double>& position) {
  const SnapshotBody& body = body_of(snapshot, id);
  const Vec2<double> v = body.velocity.head<2>();
  const Vec2<double> arm = position - (body.pose.position - snapshot.dt * v);
  return v + cross(body.velocity.z(), arm);
}

/// [W] that friction gives to the two bodies; negative where it brakes.
double friction_power(const Snapshot& snapshot, const SnapshotContact& contact) {
  const Vec2<double> tangent = -perpendicular(contact.normal);
  const Vec2<double> slide =
      velocity_at(snapshot, contact.b, contact.position) - velocity_at(snapshot, contact.a, contact.position);
  return contact.friction_impulse / snapshot.dt * tangent.dot(slide);
}

}  // namespace

double Trajectory::relative_energy_gain() const { return part_of_scale(energy_gain, energy_scale); }
double Trajectory::relative_energy_change() const { return part_of_scale(energy_change, energy_scale); }

void TrajectoryMeasure::add(const Snapshot& snapshot, double work) {
  if (result_.snapshots == 0) begin(snapshot);
  require(snapshot.bodies.size() == bodies_, "TrajectoryMeasure::add", "snapshot",
          "of as many bodies as the start", static_cast<double>(snapshot.bodies.size()));
  result_.snapshots += 1;
  result_.time = snapshot.time - start_time_;
  if (!result_.finite) return;
  if (!all_finite(snapshot)) return blow_up();
  result_.worst_penetration = std::max(result_.worst_penetration, worst_penetration(snapshot));
  result_.worst_drift = std::max(result_.worst_drift, worst_joint_drift(snapshot));
  result_.isolated = result_.isolated && !has_outer_impulse(snapshot);
  add_contacts(snapshot);
  add_momentum(snapshot);
  add_energy(snapshot, work);
}

void TrajectoryMeasure::begin(const Snapshot& snapshot) {
  bodies_ = snapshot.bodies.size();
  start_time_ = last_time_ = snapshot.time;
  if (!all_finite(snapshot)) return;
  energy_.emplace(snapshot);
  expected_momentum_ = momentum(snapshot);
}

void TrajectoryMeasure::add_contacts(const Snapshot& snapshot) {
  for (const SnapshotContact& contact : snapshot.contacts) {
    penetration_sum_ += std::max(0.0, -contact.separation);
    contact_count_ += 1;
    if (snapshot.dt > 0) {
      result_.worst_friction_power =
          std::max(result_.worst_friction_power, friction_power(snapshot, contact));
    }
  }
  if (contact_count_ > 0) result_.mean_contact_penetration = penetration_sum_ / contact_count_;
  result_.worst_cone_violation = std::max(result_.worst_cone_violation, worst_cone_violation(snapshot));
}

void TrajectoryMeasure::add_energy(const Snapshot& snapshot, double work) {
  energy_->give(work);
  energy_->see(snapshot);
  result_.energy_change = energy_->change();
  result_.energy_scale = energy_->scale();
  result_.energy_gain = std::max(result_.energy_gain, result_.energy_change);
  if (!std::isfinite(result_.energy_change)) blow_up();
}

/// Semi-implicit Euler gives L the moment of the weights where the step began, and internal impulses nothing.
void TrajectoryMeasure::add_momentum(const Snapshot& snapshot) {
  expected_momentum_ += (snapshot.time - last_time_) * gravity_push_;
  const Vec3<double> error = momentum(snapshot) - expected_momentum_;
  result_.momentum_error = std::max(result_.momentum_error, error.head<2>().norm());
  result_.angular_momentum_error = std::max(result_.angular_momentum_error, std::abs(error.z()));
  gravity_push_ = gravity_on(snapshot);
  last_time_ = snapshot.time;
}

void TrajectoryMeasure::blow_up() {
  result_.finite = false;
  result_.worst_penetration = result_.worst_drift = trajectory_infinity;
  result_.mean_contact_penetration = trajectory_infinity;
  result_.energy_gain = result_.energy_change = trajectory_infinity;
  result_.momentum_error = result_.angular_momentum_error = trajectory_infinity;
  result_.worst_cone_violation = result_.worst_friction_power = trajectory_infinity;
}

}  // namespace cairn
