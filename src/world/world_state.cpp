// Floor 5. Making a world from its scene, changing what a user may change, and the ends of a step.
#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>
#include <cairn/world/scene_snapshot.hpp>
#include <cairn/world/world.hpp>

namespace cairn {

namespace {

/// Whether an exception may find bodies that are no longer as they were when the step began.
template <Scalar Real>
bool may_leave_midway(const Model<Real>& model) {
  return model.plan->settings.substeps > 1 || model.acting != nullptr;
}

}  // namespace

template <Scalar Real>
World<Real>::World(Scene scene)
    : model_(make_model<Real>(std::move(scene))),
      state_(state_of<Real>(*model_.scene)),
      contacts_(model_),
      joints_(model_),
      clock_{.dt = model_.scene->settings().dt} {
  if (model_.plan->settings.sleeping) sleep_.emplace(*model_.scene);
}

template <Scalar Real>
void World<Real>::set_dt(double dt) {
  occupation_.refuse("World::set_dt");
  require_time_step(dt, "World::set_dt");
  clock_.dt = dt;
}

template <Scalar Real>
void World<Real>::set_velocity(BodyId body, const Vec3<double>& velocity) {
  occupation_.refuse("World::set_velocity");
  require(body.index > 0 && body.index < state_.pose.size(), "World::set_velocity", "body",
          "the id of a body other than the ground", body.index);
  require(model_.scene->bodies()[body].spec.type != BodyType::static_body, "World::set_velocity", "body",
          "one that is not static", body.index);
  require_finite(Vec2<double>(velocity.head<2>()), "World::set_velocity", "velocity", "m/s");
  require_finite(velocity.z(), "World::set_velocity", "angular velocity", "rad/s");
  state_.velocity[body] = velocity.template cast<Real>();
  if (sleep_) sleep_->wake(body);
}

template <Scalar Real>
Substep<Real> World<Real>::now(int number) {
  const double dt = clock_.dt / model_.scene->settings().substeps;
  return {.scene = *model_.scene,
          .plan = *model_.plan,
          .kinds = *model_.kinds,
          .state = state_,
          .hand = hand_.joint(),
          .sleep = sleep_ ? &*sleep_ : nullptr,
          .acting = model_.acting.get(),
          .when = {.begin = clock_.time + number * dt,
                   .length = dt,
                   .is_first = clock_.steps == 0 && number == 0},
          .dt = static_cast<Real>(dt),
          .step_dt = static_cast<Real>(clock_.dt)};
}

/// Whom the hand holds wakes; and it is kept what a step that is not done would go back to.
template <Scalar Real>
void World<Real>::begin_step() {
  if (sleep_ && hand_.joint()) sleep_->wake(hand_.joint()->body());
  if (may_leave_midway(model_)) start_.pose = state_.pose, start_.velocity = state_.velocity;
  if (model_.plan->extras.one_way) contacts_.begin_step();
  if (model_.plan->watches()) watch_.begin();
}

/// Of a step that is not done: bodies are where it began. What was found on the way is found again.
template <Scalar Real>
void World<Real>::leave_step() {
  if (may_leave_midway(model_)) state_.pose = start_.pose, state_.velocity = start_.velocity;
  if (model_.plan->extras.one_way) contacts_.leave_step();
  record_ = {};
}

/// The events that a step has made are due before the next one.
template <Scalar Real>
void World<Real>::end_step() {
  if (!model_.plan->watches()) return;
  std::optional<Scene> then = watch_.end(clock_.time, clock_.dt, *model_.scene);
  if (then) model_ = with_events_of(std::move(*then), model_);
}

template class World<float>;
template class World<double>;

}  // namespace cairn
