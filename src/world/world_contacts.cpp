// Floor 5. What touches what: from poses to manifolds.
#include <algorithm>

#include "collision/collide.hpp"
#include "world/last_word.hpp"
#include "world/world.hpp"

namespace cairn {

namespace {

// Times what a body may sink in at ease (slop_limit_, a twentieth of its smallest shape): a quarter of that
// shape. What is deeper in another is on its way through.
constexpr double slops_in_depth = 5;

}  // namespace

template <Scalar Real>
void World<Real>::find_contacts() {
  find_manifolds();
  if (!sleep_) return;
  // What wakes may touch, or hold, what else sleeps.
  while (sleep_->wake_touched(record_.manifolds, state_.velocity)) find_manifolds();
  sleep_->give_back(impulses_, previous_dt_);
}

template <Scalar Real>
void World<Real>::find_manifolds() {
  record_.manifolds.clear();
  record_.sensed.clear();
  if (!plan_->collision) return;
  const Real margin = static_cast<Real>(scene_->settings().speculative_margin);
  const std::vector<Collider>& colliders = *colliders_;
  for (std::size_t i = 0; i < colliders.size(); ++i) {
    const BodyId body = colliders[i].body;
    const Pose<Real>& pose = state_.pose[static_cast<std::size_t>(body.index)];
    boxes_[i] = bounding_box(colliders[i].shape, pose, margin / 2 + reach(body));
  }
  if (sleep_) sleep_->mark_movable(state_.velocity, movable_);
  for (const auto& [i, j] : broadphase_.pairs(boxes_, movable_)) meet(i, j);
  std::sort(record_.sensed.begin(), record_.sensed.end());
  record_.sensed.erase(std::unique(record_.sensed.begin(), record_.sensed.end()), record_.sensed.end());
}

/// One pair that is near: its manifold, if the two may touch.
template <Scalar Real>
void World<Real>::meet(int collider_a, int collider_b) {
  const Collider& a = (*colliders_)[static_cast<std::size_t>(collider_a)];
  const Collider& b = (*colliders_)[static_cast<std::size_t>(collider_b)];
  if (a.body == b.body) return;
  const BodySpec& spec_a = scene_->bodies()[static_cast<std::size_t>(a.body.index)].spec;
  const BodySpec& spec_b = scene_->bodies()[static_cast<std::size_t>(b.body.index)].spec;
  if (spec_a.type != BodyType::dynamic && spec_b.type != BodyType::dynamic) return;
  const std::pair<BodyId, BodyId> bodies = std::minmax(a.body, b.body);
  const auto& apart = scene_->apart();
  if (!may_touch(spec_a, spec_b) || std::binary_search(apart.begin(), apart.end(), bodies)) return;

  const bool is_sensed = spec_a.sensor || spec_b.sensor;
  const Real wide = static_cast<Real>(scene_->settings().speculative_margin) + reach(a.body) + reach(b.body);
  Manifold<Real> manifold =
      collide(a.shape, state_.pose[static_cast<std::size_t>(a.body.index)], b.shape,
              state_.pose[static_cast<std::size_t>(b.body.index)], is_sensed ? Real(0) : wide);
  if (manifold.count == 0) return;
  if (is_sensed) {
    record_.sensed.push_back(bodies);
    return;
  }
  manifold.collider_a = collider_a;
  manifold.collider_b = collider_b;
  record_.manifolds.push_back(manifold);
}

/// How far a fast body can come within a substep [m]; 0 for every other body, unless it comes farther than
/// its largest shape is long: then it could pass through another of its size.
template <Scalar Real>
Real World<Real>::reach(BodyId body) const {
  const auto index = static_cast<std::size_t>(body.index);
  const BodySpec& spec = scene_->bodies()[index].spec;
  if (spec.type == BodyType::static_body) return 0;
  const Real dt = substep_length();
  const Real gravity = static_cast<Real>(spec.gravity_scale * scene_->settings().gravity.norm());
  const Real way = dt * (state_.velocity[index].template head<2>().norm() + dt * std::abs(gravity));
  return spec.fast || way > length_[index] ? way : Real(0);
}

/// Where the solve has left bodies going through each other, they are stopped: in how they move and in what
/// they keep. In every other step this changes nothing.
template <Scalar Real>
void World<Real>::keep_apart(StepReport& report) {
  const VelocityProblem<Real>& problem = record_.problem;
  std::size_t block = scene_->joints().size();
  const auto limits_of = [&](const Manifold<Real>& manifold, const auto& visit) {
    const auto a =
        static_cast<std::size_t>((*colliders_)[static_cast<std::size_t>(manifold.collider_a)].body.index);
    const auto b =
        static_cast<std::size_t>((*colliders_)[static_cast<std::size_t>(manifold.collider_b)].body.index);
    const Real depth = static_cast<Real>(slops_in_depth) * std::min(slop_limit_[a], slop_limit_[b]);
    int row = problem.blocks[block++].first;
    for (int i = 0; i < manifold.count; ++i, ++row) {
      while (!problem.rows[static_cast<std::size_t>(row)].bounds.is_unilateral()) ++row;
      visit(ContactLimit<Real>{row, manifold.points[static_cast<std::size_t>(i)].separation, depth});
    }
  };
  bool any = false;
  for (const Manifold<Real>& manifold : record_.manifolds)
    limits_of(manifold, [&](const ContactLimit<Real>& limit) {
      any = any || goes_too_deep(problem, limit, moving_velocity_);
    });
  if (!any) return;
  report.kept_apart += 1;
  std::vector<ContactLimit<Real>> limits;
  block = scene_->joints().size();
  for (const Manifold<Real>& manifold : record_.manifolds)
    limits_of(manifold, [&](const ContactLimit<Real>& limit) { limits.push_back(limit); });
  keep_bodies_apart(problem, limits, moving_velocity_);
  keep_bodies_apart(problem, limits, record_.problem.velocity);
}

template class World<float>;
template class World<double>;
template class World<long double>;

}  // namespace cairn
