// Floor 5. What contacts gave, and what they begin from.
#include <cairn/world/contact_cache.hpp>

#include <algorithm>

#include <cairn/constraints/contact_rows.hpp>
#include <cairn/constraints/contact_stiffness.hpp>
#include <cairn/world/contact_finder.hpp>

namespace cairn {

namespace {

/// Whether two shapes lie among the same others as before.
template <Scalar Real>
bool has_same_neighbours(const Collider<Real>& one, const Collider<Real>& other) {
  const auto &around = one.form->around, &around_other = other.form->around;
  if (!around || !around_other) return around == around_other;
  return *around == *around_other;
}

template <Scalar Real>
bool strikes(const Contact<Real>& contact) {
  return contact.rigid[0] || (contact.manifold.count > 1 && contact.rigid[1]);
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
  if (step.plan.surfaces.static_friction) choose_friction(step, record.problem);
}

template <Scalar Real>
void ContactCache<Real>::move(const Substep<Real>& step, StepRecord<Real>& record) {
  ContactFinder<Real>(step, *this, record).move();
  if (step.plan.surfaces.static_friction) choose_friction(step, record.problem);
}

template <Scalar Real>
void ContactCache<Real>::add_stiffness(ForcesOf when, const StepRecord<Real>& record, RowForces<Real>& forces,
                                       PerBody<Vec3<Real>>& stiffness) const {
  const VelocityProblem<Real>& problem = record.problem;
  const int joints = problem.joint_blocks();
  for (int i = 0; i < problem.contacts.size(); ++i) {
    const CachedContact<Real>& cached = graph_[touching_[i]];
    const Contact<Real>& contact = problem.contacts[i];
    const auto part = [&](const RowBlock& block, int k) {
      return contact_part(contact.manifold, block.count, k);
    };
    take_forces(when, cached.impulses, problem, joints + i, part, forces);
    const Real radius_a = (*colliders_)[cached.collider_a].form->core_radius;
    const Real radius_b = (*colliders_)[cached.collider_b].form->core_radius;
    add_contact_stiffness(contact, radius_a, radius_b, forces, stiffness);
  }
}

template <Scalar Real>
void ContactCache<Real>::start(const Substep<Real>& step, StepRecord<Real>& record) const {
  VelocityProblem<Real>& problem = record.problem;
  const int joints = problem.joint_blocks();
  for (int i = 0; i < problem.contacts.size(); ++i) {
    const RowBlock& block = problem.blocks[joints + i];
    const Manifold<Real>& manifold = problem.contacts[i].manifold;
    const auto part = [&](int k) { return contact_part(manifold, block.count, k); };
    start_rows(graph_[touching_[i]].impulses, block, part, step.plan.settings.warm_start, problem,
               record.is_new);
  }
}

template <Scalar Real>
void ContactCache<Real>::remember(const Plan& plan, const StepRecord<Real>& record) {
  const VelocityProblem<Real>& problem = record.problem;
  if (plan.surfaces.static_friction) remember_sliding(problem);
  const int joints = problem.joint_blocks();
  for (int i = 0; i < problem.contacts.size(); ++i) {
    const RowBlock& block = problem.blocks[joints + i];
    const Manifold<Real>& manifold = problem.contacts[i].manifold;
    const auto part = [&](int k) { return contact_part(manifold, block.count, k); };
    remember_rows(graph_[touching_[i]].impulses, block, part, problem);
    // What an impact took is no load, which would begin the next substep.
    if (plan.surfaces.impact_sequence && strikes(problem.contacts[i]))
      graph_[touching_[i]].impulses.count = 0;
  }
}

template <Scalar Real>
void ContactCache<Real>::carry_over(const ContactCache& before, Span<const int> numbers,
                                    const Substep<Real>& step) {
  List<CachedContact<Real>> contacts;
  List<CachedManifold<Real>> manifolds;
  contacts.reserve(before.graph_.order().size());
  for (const NearPair& near : before.graph_.order()) {
    if (near.contact == NearPair::none) continue;
    const CachedContact<Real>& old = before.graph_[near.contact];
    const int a = numbers[old.collider_a], b = numbers[old.collider_b];
    if (a < 0 || b < 0 || !may_meet(step.scene, a, b)) continue;
    CachedContact<Real> cached = make_contact(step, a, b);
    cached.impulses = old.impulses;
    cached.slides = old.slides;
    contacts.push_back(cached);
    if (!before.graph_.keeps_manifolds()) continue;
    manifolds.push_back(before.graph_.manifold(near.contact));
    manifolds.back().is_found = manifolds.back().is_found &&
                                has_same_neighbours((*before.colliders_)[old.collider_a], (*colliders_)[a]) &&
                                has_same_neighbours((*before.colliders_)[old.collider_b], (*colliders_)[b]);
  }
  graph_.begin_with(std::move(contacts), std::move(manifolds));
}

/// Whether two shapes that are near, so that one can move, ever touch.
template <Scalar Real>
bool ContactCache<Real>::may_meet(const Scene& scene, int collider_a, int collider_b) const {
  const BodyId a = (*colliders_)[collider_a].body, b = (*colliders_)[collider_b].body;
  if (a == b || !may_touch(scene.bodies()[a].spec.filter, scene.bodies()[b].spec.filter)) return false;
  const List<std::pair<BodyId, BodyId>>& apart = scene.joints().apart();
  return !std::binary_search(apart.begin(), apart.end(), std::pair<BodyId, BodyId>(std::minmax(a, b)));
}

/// The contact of two shapes that may meet.
template <Scalar Real>
CachedContact<Real> ContactCache<Real>::make_contact(const Substep<Real>& step, int collider_a,
                                                     int collider_b) const {
  const BodyId a = (*colliders_)[collider_a].body, b = (*colliders_)[collider_b].body;
  const BodySpec &spec_a = step.scene.bodies()[a].spec, &spec_b = step.scene.bodies()[b].spec;
  const BodyTraits<Real>&of_a = step.kinds[a], &of_b = step.kinds[b];
  CachedContact<Real> cached{.collider_a = collider_a, .collider_b = collider_b, .a = a, .b = b};
  cached.sensed = spec_a.sensor || spec_b.sensor;
  cached.friction = static_cast<Real>(of_a.friction_root * of_b.friction_root);
  cached.restitution = static_cast<Real>(std::max(spec_a.material.restitution, spec_b.material.restitution));
  if (!step.scene.settings().mixing.is_usual()) {
    const PairSurface surface = mixed(step.scene.settings().mixing, a, spec_a.material, b, spec_b.material);
    cached.friction = static_cast<Real>(surface.friction);
    cached.restitution = static_cast<Real>(surface.restitution);
  }
  cached.slop_limit = std::min(of_a.slop_limit, of_b.slop_limit);
  return cached;
}

template class ContactCache<float>;
template class ContactCache<double>;

}  // namespace cairn
