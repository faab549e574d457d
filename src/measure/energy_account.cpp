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
    mass_ += body.mass;
  }
  RowSpecs<double> rows;
  for (const std::shared_ptr<const Constraint>& joint : scene.joints()) joint->append_rows(poses, rows);
  for (const RowSpec<double>& row : rows) power_ += motor_power(row.speed, row.max_force.value_or(no_limit));
  for (const SceneEvent& event : scene.events()) {
    const auto* const switched = std::get_if<SwitchMotor>(&event.action);
    if (switched != nullptr && switched->motor)
      power_ += motor_power(switched->motor->speed, switched->motor->max_force);
    if (const auto* const change = std::get_if<ChangeBody>(&event.action))
      speed_ = std::max(speed_, own_speed(changed(scene.bodies()[change->body].spec, *change)));
  }
}

double Drive::most_energy(double energy, double time, double steps) const {
  const double own = power_ > 0 ? energy + power_ * time : energy;
  const double root = std::sqrt(own) + steps * speed_ * std::sqrt(2 * mass_);
  return root * root;
}

}  // namespace cairn
