// Floor 5. Which pairs of shapes have contacts, and what their surfaces make of them.
#include <cairn/world/contact_cache.hpp>

#include <algorithm>

#include <cairn/constraints/contact_rows.hpp>

namespace cairn {

namespace {

/// Whether two shapes lie among the same others as before.
template <Scalar Real>
bool has_same_neighbours(const Collider<Real>& one, const Collider<Real>& other) {
  const auto &around = one.form->around, &around_other = other.form->around;
  if (!around || !around_other) return around == around_other;
  return *around == *around_other;
}

PairSurface surface_between(const Scene& scene, BodyId a, BodyId b) {
  return mixed(scene.settings().mixing, a, scene.bodies()[a].spec.material, b,
               scene.bodies()[b].spec.material);
}

}  // namespace

/// What sticks may have its static coefficient: contacts come with that of sliding.
template <Scalar Real>
void ContactCache<Real>::choose_friction(const Substep<Real>& step, VelocityProblem<Real>& problem) {
  for (int i = 0; i < problem.contacts.size(); ++i) {
    Contact<Real>& contact = problem.contacts[i];
    CachedContact<Real>& cached = graph_[touching_[i]];
    if (cached.impulses.count == 0) cached.slides = comes_sliding(contact, problem, step.state.velocity);
    if (!cached.slides)
      contact.friction = static_cast<Real>(surface_between(step.scene, contact.a, contact.b).static_friction);
  }
}

/// Keeps which contacts slide, for the next substep.
template <Scalar Real>
void ContactCache<Real>::remember_sliding(const VelocityProblem<Real>& problem) {
  const int joints = problem.joint_blocks();
  for (int i = 0; i < problem.contacts.size(); ++i) {
    const RowBlock& block = problem.blocks[joints + i];
    const Contact<Real>& contact = problem.contacts[i];
    Real load = 0;
    for (int k = 0; k < block.count; ++k) {
      const std::uint64_t part = contact_part(contact.manifold, block.count, k);
      if (is_normal_part(part)) load += problem.impulse[block.first + k];
    }
    CachedContact<Real>& cached = graph_[touching_[i]];
    cached.slides = slides(contact, problem, cached.friction, load);
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
  sides_.carry_over(before.sides_, numbers);
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
    const PairSurface surface = surface_between(step.scene, a, b);
    cached.friction = static_cast<Real>(surface.friction);
    cached.restitution = static_cast<Real>(surface.restitution);
  }
  cached.slop_limit = std::min(of_a.slop_limit, of_b.slop_limit);
  return cached;
}

template class ContactCache<float>;
template class ContactCache<double>;

}  // namespace cairn
