// Floor 5. What contacts gave, and the rows that they get.
#include "world/contact_cache.hpp"

#include <algorithm>

#include "world/contact_finder.hpp"

namespace cairn {

namespace {

// RowKey::source of contacts: joints have their ids.
constexpr std::uint64_t contact_source_bit = std::uint64_t{1} << 63;

template <Scalar Real>
std::uint64_t contact_source(const Manifold<Real>& manifold) {
  return contact_source_bit | static_cast<std::uint64_t>(manifold.collider_a) << 31 |
         static_cast<std::uint64_t>(manifold.collider_b);
}

template <Scalar Real>
ContactMaterial<Real> material(const Contact<Real>& contact, const SceneSettings& settings) {
  return {.friction = contact.friction,
          .restitution = contact.restitution,
          .restitution_threshold = static_cast<Real>(*settings.restitution_threshold),
          .friction_rows = settings.friction_rows,
          .slop_limit = contact.slop_limit};
}

/// Nothing of what it gives is known yet.
template <Scalar Real>
Contact<Real> contact_of(const ContactSlot<Real>& slot) {
  Contact<Real> contact;
  contact.a = slot.a;
  contact.b = slot.b;
  contact.friction = slot.friction;
  contact.restitution = slot.restitution;
  contact.slop_limit = slot.slop_limit;
  return contact;
}

/// Whether the bodies overlap at a point and come together there almost too fast for a spring to stop them.
template <Scalar Real>
bool may_strike(const Contact<Real>& contact, const Manifold<Real>& manifold, const Stabilization& rules,
                const PerBody<Pose<Real>>& poses, const PerBody<Vec3<Real>>& velocity) {
  const auto speed_at = [&](BodyId body, const Vec2<Real>& point) -> Vec2<Real> {
    const Vec3<Real>& v = velocity[body];
    return v.template head<2>() + cross<Real>(v.z(), point - poses[body].position);
  };
  const Real most = static_cast<Real>(0.99 * most_speed(rules));  // rows tell exactly
  return std::any_of(
      manifold.points.begin(), manifold.points.begin() + manifold.count, [&](const auto& point) {
        const Vec2<Real> parting = speed_at(contact.b, point.position) - speed_at(contact.a, point.position);
        return !(point.separation >= 0) && -manifold.normal.dot(parting) > most;
      });
}

/// Whether it has to be written in rows, where bodies would have these velocities without constraints.
template <Scalar Real>
bool needs_rows(const Contact<Real>& contact, const Manifold<Real>& manifold, const SceneSettings& settings,
                const PerBody<Pose<Real>>& poses, const PerBody<Vec3<Real>>& velocity) {
  const Stabilization& rules = settings.stabilization;
  if (contact.restitution > 0 || (contact.friction > 0 && settings.friction_rows != FrictionRows::per_point))
    return true;
  return rules.policy == StabilizationPolicy::soft && may_strike(contact, manifold, rules, poses, velocity);
}

/// RowKey::part of the k-th row that a contact would have.
template <Scalar Real>
std::uint64_t part_of(const Manifold<Real>& manifold, const Contact<Real>& contact, int k) {
  if (!(contact.friction > 0)) return normal_part(manifold.points[k].feature);
  const std::uint32_t feature = manifold.points[k / 2].feature;
  return k % 2 == 0 ? normal_part(feature) : friction_part(feature);
}

/// Whether two shapes lie among the same others as before.
template <Scalar Real>
bool has_same_surroundings(const Collider<Real>& one, const Collider<Real>& other) {
  const auto &around = one.form->around, &around_other = other.form->around;
  if (!around || !around_other) return around == around_other;
  return *around == *around_other;
}

}  // namespace

template <Scalar Real>
ContactCache<Real>::ContactCache(List<Collider<Real>> colliders, const Scene& scene, const Plan& plan)
    : colliders_(std::make_shared<const List<Collider<Real>>>(std::move(colliders))) {
  for (const Collider<Real>& collider : *colliders_)
    movable_.push_back(scene.bodies()[collider.body].spec.type == BodyType::dynamic ? 1 : 0);
  graph_ = ContactGraph<Real>(plan.broadphase, movable_, plan.moves_manifolds);
  frames_.resize(scene.bodies().size());
  boxes_ = SweptBoxes<Real>(colliders_->size());
}

template <Scalar Real>
void ContactCache<Real>::find(const Substep<Real>& step, StepRecord<Real>& record) {
  ContactFinder<Real>(step, *this, record).find();
}

template <Scalar Real>
void ContactCache<Real>::move(const Substep<Real>& step, StepRecord<Real>& record) {
  ContactFinder<Real>(step, *this, record).move();
}

template <Scalar Real>
void ContactCache<Real>::add_stiffness(const Substep<Real>& step, ForcesOf when,
                                       const StepRecord<Real>& record, RowForces<Real>& forces,
                                       PerBody<Vec3<Real>>& stiffness) const {
  for (int i = 0; i < record.manifolds.size(); ++i) {
    const ContactSlot<Real>& slot = graph_[touching_[i]];
    if (when == ForcesOf::last_substep || record.has_rows) {
      take_forces(when, slot.impulses, record.problem, step.joint_count() + i, forces);
    } else if (const Contact<Real>& contact = record.contacts[i]; contact.block) {
      take_forces(when, slot.impulses, record.problem, *contact.block, forces);
    } else {
      forces.rows.clear();
      for (int k = 0; k < contact.count; ++k)
        forces.rows.push_back({part_of(record.manifolds[i], contact, k), contact.impulse[k] / step.dt});
    }
    const Real radius_a = (*colliders_)[slot.collider_a].form->core_radius;
    const Real radius_b = (*colliders_)[slot.collider_b].form->core_radius;
    add_contact_stiffness(record.manifolds[i], slot.a, slot.b, radius_a, radius_b, step.state.pose, forces,
                          stiffness);
  }
}

template <Scalar Real>
void ContactCache<Real>::write(const Substep<Real>& step, const List<Manifold<Real>>& manifolds,
                               StabilizationPass pass, VelocityProblem<Real>& problem, int& next,
                               List<RelaxedRow<Real>>* relaxed) const {
  const ContactWriter<Real> writer(step.plan.settings, step.state, pass, problem.dt);
  int most = next;
  for (const Manifold<Real>& manifold : manifolds) most += 2 * manifold.count;
  make_room(problem.rows, most);
  for (int i = 0; i < manifolds.size(); ++i)
    writer.write(contact_of(graph_[touching_[i]]), manifolds[i], problem, next, relaxed);
}

template <Scalar Real>
void ContactWriter<Real>::write(const Contact<Real>& contact, const Manifold<Real>& manifold,
                                VelocityProblem<Real>& problem, int& next,
                                List<RelaxedRow<Real>>* relaxed) const {
  const int first = next;
  write_contact_rows(manifold, contact.a, contact.b, material(contact, settings_), state_.pose,
                     state_.velocity, rule_, contact_source(manifold), problem, next, relaxed);
  problem.blocks.push_back(
      {first, next - first, !needs_rows(contact, manifold, settings_, state_.pose, problem.velocity)});
}

template <Scalar Real>
void ContactCache<Real>::start(const Substep<Real>& step, int first, VelocityProblem<Real>& problem,
                               PerRow<char>& is_new) const {
  for (int i = first; i < problem.blocks.size(); ++i)
    start_rows(graph_[touching_[i - first]].impulses, problem.blocks[i], step.plan.warm_start, problem,
               is_new);
}

template <Scalar Real>
void ContactCache<Real>::take(const Substep<Real>& step, StepRecord<Real>& record, int& next,
                              List<RelaxedRow<Real>>* relaxed) const {
  VelocityProblem<Real>& problem = record.problem;
  const SceneSettings& settings = step.plan.settings;
  const ContactWriter<Real> writer(settings, step.state, StabilizationPass::velocity, problem.dt);
  record.contacts.resize(record.manifolds.size());
  for (int i = 0; i < record.manifolds.size(); ++i) {
    const Manifold<Real>& manifold = record.manifolds[i];
    Contact<Real>& contact = record.contacts[i];
    contact = contact_of(graph_[touching_[i]]);
    if (needs_rows(contact, manifold, settings, step.state.pose, problem.velocity)) {
      contact.block = problem.blocks.size();
      writer.write(contact, manifold, problem, next, relaxed);
      contact.count = problem.blocks.back().count;
      continue;
    }
    const PerBody<Vec3<Real>>& inverse_mass = step.state.inverse_mass;
    const bool still = inverse_mass[contact.a].isZero(0) && inverse_mass[contact.b].isZero(0);
    contact.count = still ? 0 : manifold.count * (contact.friction > 0 ? 2 : 1);
  }
  problem.rows.resize(next);
  problem.impulse.resize(next);
  for (int i = 0; i < record.contacts.size(); ++i) start(step, i, record);
}

/// What one contact begins from, behind those before it.
template <Scalar Real>
void ContactCache<Real>::start(const Substep<Real>& step, int touch, StepRecord<Real>& record) const {
  const ContactSlot<Real>& slot = graph_[touching_[touch]];
  VelocityProblem<Real>& problem = record.problem;
  Contact<Real>& contact = record.contacts[touch];
  const Real scale = slot.impulses.count > 0 ? step.dt / slot.impulses.dt : Real(1);
  for (int k = 0; k < contact.count; ++k) {
    const int row = contact.block ? problem.blocks[*contact.block].first + k : 0;
    const std::uint64_t part =
        contact.block ? problem.rows[row].key.part : part_of(record.manifolds[touch], contact, k);
    const RowImpulse<Real>* last = slot.impulses.find(part, k);
    record.is_new.push_back(last == nullptr);
    Real& impulse = contact.block ? problem.impulse[row] : contact.start[k];
    impulse = last && step.plan.warm_start ? scale * last->impulse : Real(0);
  }
}

template <Scalar Real>
void ContactCache<Real>::remember(const StepRecord<Real>& record) {
  if (record.has_rows) {
    for (int i = 0; i < record.manifolds.size(); ++i)
      remember_rows(graph_[touching_[i]].impulses, record.problem.blocks[record.first_contact_block + i],
                    record.problem);
    return;
  }
  for (int i = 0; i < record.contacts.size(); ++i) {
    const Contact<Real>& contact = record.contacts[i];
    auto& impulses = graph_[touching_[i]].impulses;
    if (contact.block) {
      remember_rows(impulses, record.problem.blocks[*contact.block], record.problem);
    } else {
      cairn::remember(impulses, contact.count, record.problem.dt, [&](int k) {
        return RowImpulse<Real>{part_of(record.manifolds[i], contact, k), contact.impulse[k]};
      });
    }
  }
}

template <Scalar Real>
int ContactCache<Real>::count_too_deep(const Substep<Real>& step,
                                       const List<Manifold<Real>>& manifolds) const {
  int count = 0;
  for (int i = 0; i < manifolds.size(); ++i) {
    const ContactSlot<Real>& slot = graph_[touching_[i]];
    const Manifold<Real>& manifold = manifolds[i];
    // Each of the two is a quarter.
    const Real most = 2 * std::min(step.kinds[slot.a].failed_error, step.kinds[slot.b].failed_error);
    const auto is_deep = [most](const auto& point) { return point.separation < -most; };
    count += std::any_of(manifold.points.begin(), manifold.points.begin() + manifold.count, is_deep);
  }
  return count;
}

template <Scalar Real>
void ContactCache<Real>::carry_over(const ContactCache& before, Span<const int> numbers,
                                    const Substep<Real>& step) {
  List<ContactSlot<Real>> slots;
  List<LastingManifold<Real>> lasting;
  for (const NearSlot& near : before.graph_.order()) {
    if (near.slot == NearSlot::none) continue;
    const ContactSlot<Real>& old = before.graph_[near.slot];
    const int a = numbers[old.collider_a], b = numbers[old.collider_b];
    if (a < 0 || b < 0 || !may_meet(step.scene, a, b)) continue;
    ContactSlot<Real> slot = make_slot(step, a, b);
    slot.impulses = old.impulses;
    slots.push_back(slot);
    if (!before.graph_.lasts()) continue;
    lasting.push_back(before.graph_.lasting(near.slot));
    lasting.back().is_found = lasting.back().is_found &&
                              has_same_surroundings((*before.colliders_)[old.collider_a], (*colliders_)[a]) &&
                              has_same_surroundings((*before.colliders_)[old.collider_b], (*colliders_)[b]);
  }
  graph_.begin_with(std::move(slots), std::move(lasting));
}

/// Whether two shapes that are near, so that one can move, ever touch.
template <Scalar Real>
bool ContactCache<Real>::may_meet(const Scene& scene, int collider_a, int collider_b) const {
  const BodyId a = (*colliders_)[collider_a].body, b = (*colliders_)[collider_b].body;
  if (a == b || !may_touch(scene.bodies()[a].spec, scene.bodies()[b].spec)) return false;
  const List<std::pair<BodyId, BodyId>>& apart = scene.apart();
  return !std::binary_search(apart.begin(), apart.end(), std::pair<BodyId, BodyId>(std::minmax(a, b)));
}

/// The slot of two shapes that may meet.
template <Scalar Real>
ContactSlot<Real> ContactCache<Real>::make_slot(const Substep<Real>& step, int collider_a,
                                                int collider_b) const {
  const BodyId a = (*colliders_)[collider_a].body, b = (*colliders_)[collider_b].body;
  const BodySpec &spec_a = step.scene.bodies()[a].spec, &spec_b = step.scene.bodies()[b].spec;
  const BodyTraits<Real>&of_a = step.kinds[a], &of_b = step.kinds[b];
  ContactSlot<Real> slot{.collider_a = collider_a, .collider_b = collider_b, .a = a, .b = b};
  slot.sensed = spec_a.sensor || spec_b.sensor;
  slot.friction = static_cast<Real>(of_a.friction_root * of_b.friction_root);
  slot.restitution = static_cast<Real>(std::max(spec_a.restitution, spec_b.restitution));
  slot.slop_limit = std::min(of_a.slop_limit, of_b.slop_limit);
  return slot;
}

template class ContactWriter<float>;
template class ContactWriter<double>;
template class ContactWriter<long double>;
template class ContactCache<float>;
template class ContactCache<double>;
template class ContactCache<long double>;

}  // namespace cairn
