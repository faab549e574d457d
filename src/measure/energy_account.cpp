// Floor 6. Energies of a run, and where they may come from.
#include <cairn/measure/energy_account.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/geometry/aabb.hpp>
#include <cairn/measure/energy.hpp>

namespace cairn {

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

double motor_power(double speed, double force) { return speed == 0 ? 0 : std::abs(speed) * force; }

/// The root of the energy [J] that a force gives in a second at most: a body that has E goes, where it pulls,
/// no faster than sqrt(2 E (1/m + r^2/I)), so that dE/dt <= F sqrt(2 E (...)).
double force_growth(const SceneBody& body, const ApplyForce& pull) {
  const double turning = body.inertia > 0 ? 1 / body.inertia : 0;
  return pull.force.norm() * std::sqrt((1 / body.mass + pull.point.squaredNorm() * turning) / 2) +
         std::abs(pull.torque) * std::sqrt(turning / 2);
}

/// [m/s] Of the fastest point of a body that moves by itself; 0 of any other.
double own_speed(const BodySpec& spec) {
  const double of_surface = std::abs(spec.material.surface_speed);
  if (spec.type != BodyType::kinematic) return of_surface;
  double radius = 0;
  for (const Shape<double>& shape : spec.shapes) radius = std::max(radius, bounding_radius(shape));
  return spec.velocity.norm() + std::abs(spec.angular_velocity) * radius + of_surface;
}

}  // namespace

double energy_scale(const Snapshot& snapshot) {
  Vec2<double> lower(no_limit, no_limit), upper = -lower;
  double weight = 0;  // [N]
  for (const SnapshotBody& body : snapshot.bodies) {
    if (body.type != BodyType::dynamic) continue;
    weight += body.mass * std::abs(body.gravity_scale) * snapshot.gravity.norm();
    for (const Shape<double>& shape : body.shapes) {
      const Aabb<double> around = bounding_box(shape, body.pose);
      lower = lower.cwiseMin(around.lower);
      upper = upper.cwiseMax(around.upper);
    }
  }
  double held = kinetic_energy(snapshot);
  for (const SnapshotJoint& joint : snapshot.joints) held += joint.energy;
  if (!(lower.x() <= upper.x())) return held;
  for (const SnapshotJoint& joint : snapshot.joints) {
    lower = lower.cwiseMin(joint.anchor_a).cwiseMin(joint.anchor_b);
    upper = upper.cwiseMax(joint.anchor_a).cwiseMax(joint.anchor_b);
  }
  return held + weight * (upper - lower).norm();
}

EnergyAccount::EnergyAccount(const Snapshot& start) : lowest_(no_limit) {
  see(start);
  given_ = energy_;
  size_ = energy_scale(start);
}

void EnergyAccount::scene_changed(const Snapshot& now) {
  const double before = energy_;
  size_ = std::max(scale(), energy_scale(now));
  lowest_ = no_limit;  // a body that is gone has none any more
  see(now);
  given_ += energy_ - before;
}

void EnergyAccount::see(const Snapshot& now) {
  energy_ = total_energy(now);
  lowest_ = std::min(lowest_, energy_ - kinetic_energy(now));
}

double EnergyAccount::scale() const { return std::max(size_, given_ - lowest_); }

Drive::Drive(const Scene& scene) {
  PerBody<Pose<double>> poses;
  for (const SceneBody& body : scene.bodies()) {
    poses.push_back(body.pose);
    speed_ = std::max(speed_, own_speed(body.spec));
    if (body.mass > 0 && body.spec.damping.quadratic > 0)
      speed_ = std::max(speed_, scene.settings().fields.wind.norm());
    mass_ += body.mass;
  }
  RowSpecs<double> rows;
  for (const std::shared_ptr<const Constraint>& joint : scene.joints()) joint->append_rows(poses, rows);
  for (const RowSpec<double>& row : rows) power_ += motor_power(row.speed, row.max_force.value_or(no_limit));
  if (scene.settings().fields.water) speed_ = std::max(speed_, scene.settings().fields.water->flow.norm());
  for (const SceneEvent& event : scene.events()) {
    if (const auto* path = std::get_if<FollowPath>(&event.action)) speed_ = std::max(speed_, path->speed);
    if (const auto* pull = std::get_if<ApplyForce>(&event.action))
      forces_.push_back({.growth = force_growth(scene.bodies()[pull->body], *pull),
                         .begins = event.time,
                         .ends = event.time + pull->seconds});
    const auto* const switched = std::get_if<SwitchMotor>(&event.action);
    if (switched != nullptr && switched->motor)
      power_ += motor_power(switched->motor->speed, switched->motor->max_force);
    if (const auto* const change = std::get_if<ChangeBody>(&event.action))
      speed_ = std::max(speed_, own_speed(changed(scene.bodies()[change->body].spec, *change)));
  }
}

double Drive::most_energy(double energy, double time, double steps) const {
  const double own = power_ > 0 ? energy + power_ * time : energy;
  double root = std::sqrt(own) + steps * speed_ * std::sqrt(2 * mass_);
  for (const Force& force : forces_)
    root += force.growth * std::max(0.0, std::min(time, force.ends) - force.begins);
  return root * root;
}

}  // namespace cairn
