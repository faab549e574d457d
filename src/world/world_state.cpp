// Floor 5. Making a world from its scene, and changing what a user may change.
#include "math/check.hpp"
#include "world/world.hpp"

namespace cairn {

template <Scalar Real>
World<Real>::World(Scene scene)
    : scene_(std::make_shared<const Scene>(std::move(scene))),
      plan_(std::make_shared<const Plan>(make_plan(*scene_))),
      dt_(scene_->settings().dt),
      broadphase_(plan_->broadphase) {
  std::vector<Collider> colliders;
  for (std::size_t i = 0; i < scene_->bodies().size(); ++i) {
    const SceneBody& body = scene_->bodies()[i];
    const BodySpec& spec = body.spec;
    state_.pose.push_back(
        {.position = body.pose.position.template cast<Real>(), .angle = static_cast<Real>(body.pose.angle)});
    state_.velocity.push_back({static_cast<Real>(spec.velocity.x()), static_cast<Real>(spec.velocity.y()),
                               static_cast<Real>(spec.angular_velocity)});
    const Real inverse_mass = body.mass > 0 ? static_cast<Real>(1 / body.mass) : Real(0);
    const Real inverse_inertia = body.inertia > 0 ? static_cast<Real>(1 / body.inertia) : Real(0);
    state_.inverse_mass.push_back({inverse_mass, inverse_mass, inverse_inertia});
    forces_.push_back({.gravity_scale = static_cast<Real>(spec.gravity_scale),
                       .linear_damping = static_cast<Real>(spec.linear_damping),
                       .angular_damping = static_cast<Real>(spec.angular_damping)});
    for (const Shape<double>& shape : spec.shapes) {
      colliders.push_back({BodyId{static_cast<int>(i)}, shape_cast<Real>(shape)});
      movable_.push_back(spec.type == BodyType::dynamic ? 1 : 0);
    }
  }
  if (plan_->sleeping) sleep_.emplace(*scene_);
  boxes_.resize(colliders.size());
  colliders_ = std::make_shared<const std::vector<Collider>>(std::move(colliders));
}

template <Scalar Real>
void World<Real>::set_dt(double dt) {
  require_time_step(dt, "World::set_dt");
  dt_ = dt;
}

template <Scalar Real>
void World<Real>::set_velocity(BodyId body, const Vec3<double>& velocity) {
  require(body.index > 0 && body.index < static_cast<int>(state_.pose.size()), "World::set_velocity", "body",
          "the id of a body other than the ground", body.index);
  const auto index = static_cast<std::size_t>(body.index);
  require(scene_->bodies()[index].spec.type != BodyType::static_body, "World::set_velocity", "body",
          "one that is not static", body.index);
  require_finite(Vec2<double>(velocity.head<2>()), "World::set_velocity", "velocity", "m/s");
  require_finite(velocity.z(), "World::set_velocity", "angular velocity", "rad/s");
  state_.velocity[index] = velocity.template cast<Real>();
  wake(body);
}

template <Scalar Real>
void World<Real>::wake(BodyId body) {
  require(body.index >= 0 && body.index < static_cast<int>(state_.pose.size()), "World::wake", "body",
          "the id of a body of this world", body.index);
  if (sleep_) sleep_->wake(body);
}

template class World<float>;
template class World<double>;
template class World<long double>;

}  // namespace cairn
