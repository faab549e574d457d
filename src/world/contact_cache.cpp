// Floor 5. What contacts gave, and what they begin from.
#include <cairn/world/contact_cache.hpp>

#include <algorithm>

#include <cairn/constraints/contact_rows.hpp>
#include <cairn/constraints/contact_stiffness.hpp>
#include <cairn/world/contact_finder.hpp>

namespace cairn {

namespace {

template <Scalar Real>
bool strikes(const Contact<Real>& contact) {
  return contact.rigid[0] || (contact.manifold.count > 1 && contact.rigid[1]);
}

template <Scalar Real>
List<char> movable_of(const Model<Real>& model) {
  List<char> movable;
  for (const Collider<Real>& collider : *model.colliders)
    movable.push_back(model.scene->bodies()[collider.body].spec.type == BodyType::dynamic ? 1 : 0);
  return movable;
}

}  // namespace

template <Scalar Real>
ContactCache<Real>::ContactCache(const Model<Real>& model)
    : colliders_(model.colliders),
      movable_(movable_of(model)),
      graph_(model.plan->broadphase, movable_, model.plan->moves_manifolds),
      frames_(model.scene->bodies().size()),
      boxes_(colliders_->size()) {}

template <Scalar Real>
void ContactCache<Real>::find(const Substep<Real>& step, StepRecord<Real>& record) {
  ContactFinder<Real>(step, *this, record).find();
  if (step.plan.extras.static_friction) choose_friction(step, record.problem);
}

template <Scalar Real>
void ContactCache<Real>::move(const Substep<Real>& step, StepRecord<Real>& record) {
  ContactFinder<Real>(step, *this, record).move();
  if (step.plan.extras.static_friction) choose_friction(step, record.problem);
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
  if (plan.extras.static_friction) remember_sliding(problem);
  const int joints = problem.joint_blocks();
  for (int i = 0; i < problem.contacts.size(); ++i) {
    const RowBlock& block = problem.blocks[joints + i];
    const Manifold<Real>& manifold = problem.contacts[i].manifold;
    const auto part = [&](int k) { return contact_part(manifold, block.count, k); };
    remember_rows(graph_[touching_[i]].impulses, block, part, problem);
    // What an impact took is no load, which would begin the next substep.
    if (plan.extras.impact_sequence && strikes(problem.contacts[i])) graph_[touching_[i]].impulses.count = 0;
  }
}

template class ContactCache<float>;
template class ContactCache<double>;

}  // namespace cairn
