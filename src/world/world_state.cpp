// Floor 5. Making a world from its scene, changing what a user may change, and the ends of a step.
#include <algorithm>

#include <cairn/geometry/aabb.hpp>
#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>
#include <cairn/world/scene_snapshot.hpp>
#include <cairn/world/world.hpp>

namespace cairn {

namespace {

// Of the smallest shape of a body: what it may sink in at most, whatever the slop. Bodies of 0.1 m and more
// keep the usual slop of 5 mm.
constexpr double slop_share = 0.05;
// Likewise: what is deeper in another has passed half of the way to its middle.
constexpr double failed_share = 0.25;

/// [m] the longer side of the box around a shape.
double extent(const Shape<double>& shape) {
  const Aabb<double> box = bounding_box(shape, Pose<double>{});
  return (box.upper - box.lower).maxCoeff();
}

template <Scalar Real>
void require_number(double value, BodyId id, const char* field) {
  if (std::isfinite(static_cast<Real>(value))) return;
  require(false, "World", field + (" of body " + std::to_string(id.index)), "a number of its scalar type",
          value);
}

/// A body no longer than the distance of neighbouring numbers cannot touch anything in earnest. `smallest` is
/// the extent of its smallest shape [m].
template <Scalar Real>
void require_place(const SceneBody& body, BodyId id, double smallest) {
  for (int axis = 0; axis < 2; ++axis) {
    const double place = body.pose.position[axis];
    require_number<Real>(place, id, "position");
    require_number<Real>(body.spec.velocity[axis], id, "velocity");
    const Real at = static_cast<Real>(std::abs(place));
    const double step = static_cast<double>(std::nextafter(at, std::numeric_limits<Real>::infinity()) - at);
    if (step < smallest) continue;
    require(false, "World", "position of body " + std::to_string(id.index),
            "nearer to the origin in this scalar type, for a shape of " + shortest(smallest) + " m", place);
  }
  require_number<Real>(body.pose.angle, id, "angle");
  require_number<Real>(body.spec.angular_velocity, id, "angular_velocity");
}

/// [m] Infinite without shapes. Pieces of an outline are one shape, into however many it was cut.
double smallest_extent(const BodySpec& spec) {
  const double infinity = std::numeric_limits<double>::infinity();
  double smallest = infinity;
  Aabb<double> pieces = {.lower = {infinity, infinity}, .upper = {-infinity, -infinity}};
  for (const Shape<double>& shape : spec.shapes) {
    if (!is_piece(shape)) {
      smallest = std::min(smallest, extent(shape));
      continue;
    }
    const Aabb<double> box = bounding_box(shape, Pose<double>{});
    pieces.lower = pieces.lower.cwiseMin(box.lower);
    pieces.upper = pieces.upper.cwiseMax(box.upper);
  }
  const double whole = (pieces.upper - pieces.lower).maxCoeff();
  return whole > 0 ? std::min(smallest, whole) : smallest;
}

/// Springs that give way to a weight by half the length of a body let it through.
void require_springs_hold(const SceneSettings& settings, const SceneBody& body, BodyId id, double smallest) {
  const Stabilization& stabilization = settings.stabilization;
  const bool on_springs = stabilization.policy == StabilizationPolicy::soft;
  if (!on_springs || body.spec.type != BodyType::dynamic) return;
  const double weight = std::abs(body.spec.gravity_scale) * settings.gravity.norm();  // [N/kg]
  const double sag = spring_sag(stabilization.soft, settings.dt / settings.substeps, weight);
  if (sag < smallest / 2) return;
  require(false, "World", "stabilization.soft",
          "stiffer, or substeps shorter, for body " + std::to_string(id.index) + " of " + shortest(smallest) +
              " m, into which springs may give way by less than half",
          shortest(sag) + " m");
}

template <Scalar Real>
BodyForces<Real> forces_on(const BodySpec& spec) {
  return {.gravity_scale = static_cast<Real>(spec.gravity_scale),
          .linear_damping = static_cast<Real>(spec.damping.linear),
          .angular_damping = static_cast<Real>(spec.damping.angular)};
}

template <Scalar Real>
BodyTraits<Real> traits_of(const BodySpec& spec, double smallest, Real radius) {
  return {.slop_limit = static_cast<Real>(slop_share * smallest),
          .failed_error = static_cast<Real>(failed_share * smallest),
          .friction_root = std::sqrt(spec.material.friction),
          .surface_speed = static_cast<Real>(spec.material.surface_speed),
          .rolling_resistance = static_cast<Real>(spec.material.rolling_resistance),
          .radius = radius};
}

}  // namespace

template <Scalar Real>
World<Real>::World(Scene scene)
    : scene_(std::make_shared<const Scene>(std::move(scene))),
      plan_(std::make_shared<const Plan>(make_plan(*scene_))),
      contacts_(make_colliders<Real>(*scene_), *scene_, *plan_),
      clock_{.dt = scene_->settings().dt} {
  PerBody<Real> radius(scene_->bodies().size());
  for (const Collider<Real>& collider : contacts_.colliders())
    radius[collider.body] = std::max(radius[collider.body], collider.form->radius);
  state_ = state_of<Real>(*scene_);
  const auto kinds = std::make_shared<BodyKinds<Real>>();
  const Shape<double>* measured = nullptr;  // bodies that are alike share their shapes
  double smallest = smallest_extent({});    // of these shapes
  for (const BodyId id : scene_->bodies().indices()) {
    const SceneBody& body = scene_->bodies()[id];
    const BodySpec& spec = body.spec;
    if (spec.shapes.data() != measured) smallest = smallest_extent(spec);
    measured = spec.shapes.data();
    require_place<Real>(body, id, smallest);
    if (plan_->collision) require_springs_hold(scene_->settings(), body, id, smallest);
    kinds->add(forces_on<Real>(spec), traits_of(spec, smallest, radius[id]));
  }
  kinds_ = kinds;
  if (Acting<Real>::is_needed(*scene_)) acting_ = std::make_shared<const Acting<Real>>(*scene_);
  joints_ = JointWriter<Real>(scene_->joints().size(), std::move(radius));
  if (plan_->settings.sleeping) sleep_.emplace(*scene_);
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
  require(scene_->bodies()[body].spec.type != BodyType::static_body, "World::set_velocity", "body",
          "one that is not static", body.index);
  require_finite(Vec2<double>(velocity.head<2>()), "World::set_velocity", "velocity", "m/s");
  require_finite(velocity.z(), "World::set_velocity", "angular velocity", "rad/s");
  state_.velocity[body] = velocity.template cast<Real>();
  if (sleep_) sleep_->wake(body);
}

template <Scalar Real>
VelocityProblem<Real> World<Real>::velocity_problem() const {
  World twin = *this;
  do_events(twin);
  const Substep<Real> step = twin.now_asleep();
  if (twin.acting_) twin.follow(step.when);
  twin.contacts_.find(step, twin.record_);
  twin.solves_.write({step, twin.joints_, twin.contacts_, twin.record_});
  return twin.record_.problem;
}

template <Scalar Real>
Substep<Real> World<Real>::now(int number) const {
  const double dt = clock_.dt / scene_->settings().substeps;
  return {.scene = *scene_,
          .plan = *plan_,
          .kinds = *kinds_,
          .state = state_,
          .hand = hand_.joint(),
          .acting = acting_.get(),
          .when = {.begin = clock_.time + number * dt,
                   .length = dt,
                   .is_first = clock_.steps == 0 && number == 0},
          .dt = static_cast<Real>(dt),
          .step_dt = static_cast<Real>(clock_.dt)};
}

/// The same with who sleeps.
template <Scalar Real>
Substep<Real> World<Real>::now_asleep(int number) {
  Substep<Real> step = now(number);
  if (sleep_) step.sleep = &*sleep_;
  return step;
}

/// Whether an exception may find bodies that are no longer as they were when the step began.
template <Scalar Real>
bool World<Real>::may_leave_midway() const {
  return plan_->settings.substeps > 1 || acting_ != nullptr;
}

/// Bodies on paths go where these lead, and what forces begin to act on wakes.
template <Scalar Real>
void World<Real>::follow(SubstepTime time) {
  acting_->lead(time, state_);
  if (sleep_) acting_->find_changes(time, [this](BodyId body) { sleep_->wake(body); });
}

/// Whom the hand holds wakes; and it is kept what a step that is not done would go back to.
template <Scalar Real>
void World<Real>::begin_step() {
  if (sleep_ && hand_.joint()) sleep_->wake(hand_.joint()->body());
  if (may_leave_midway()) start_.pose = state_.pose, start_.velocity = state_.velocity;
  if (plan_->extras.one_way) contacts_.begin_step();
  if (plan_->watches()) watch_.begin();
}

/// Of a step that is not done: bodies are where it began. What was found on the way is found again.
template <Scalar Real>
void World<Real>::leave_step() {
  if (may_leave_midway()) state_.pose = start_.pose, state_.velocity = start_.velocity;
  if (plan_->extras.one_way) contacts_.leave_step();
  record_ = {};
}

/// The events that a step has made are due before the next one.
template <Scalar Real>
void World<Real>::end_step() {
  if (!plan_->watches()) return;
  std::optional<Scene> then = watch_.end(clock_.time, clock_.dt, *scene_);
  if (!then) return;
  scene_ = std::make_shared<const Scene>(std::move(*then));
  if (acting_) acting_ = std::make_shared<const Acting<Real>>(*scene_);
}

template class World<float>;
template class World<double>;

}  // namespace cairn
