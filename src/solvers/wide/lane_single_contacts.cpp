// Floor 4. Contacts that fit into no lane.
#include "solvers/wide/lane_system.hpp"

namespace cairn {

/// Of the contacts that fit into no lane.
template <Scalar Real>
void LaneSystem<Real>::write_single_rows(const ContactProblem<Real>& contacts) {
  VelocityProblem<Real>& problem = *contacts.problem;
  int next = 0;
  for (int single = 0; single < single_manifolds_.size(); ++single) {
    const Contact<Real>& contact = contacts.contacts[batches_.single_blocks()[single]];
    const ContactMaterial<Real> material = {
        .friction = contact.friction, .slop_limit = contact.slop_limit, .gravity = contacts.gravity};
    write_contact_rows(single_manifolds_[single], contact.a, contact.b, material, *contacts.poses,
                       problem.velocity, *contacts.stabilization, 0, problem, next);
  }
  problem.rows.resize(next);
  start_single_contacts(contacts);
}

template <Scalar Real>
void LaneSystem<Real>::start_single_contacts(const ContactProblem<Real>& contacts) {
  PerRow<Real>& impulse = contacts.problem->impulse;
  impulse.clear();
  for (const int k : batches_.single_blocks()) {
    const Contact<Real>& contact = contacts.contacts[k];
    for (int i = 0; i < contact.count; ++i) impulse.push_back(contact.start[i]);
  }
}

template <Scalar Real>
bool LaneSystem<Real>::follow_single_contacts(ContactProblem<Real>& contacts) {
  const PerBody<Frame<Real>>& frames = *contacts.frames;
  for (int single = 0; single < single_manifolds_.size(); ++single) {
    const int k = batches_.single_blocks()[single];
    const Contact<Real>& contact = contacts.contacts[k];
    Manifold<Real>& manifold = single_manifolds_[single];
    manifold = contacts.manifolds[k];
    if (contact.kept == nullptr) continue;
    manifold = contact.kept->at(frames[contact.a], frames[contact.b], contacts.margin);
    if (manifold.count < contact.kept->count) return false;
    for (int i = 0; i < manifold.count; ++i) {
      if (manifold.points[i].separation < -contact.deepest) return false;
    }
  }
  for (const int k : batches_.single_blocks()) contacts.contacts[k].start = contacts.contacts[k].impulse;
  write_single_rows(contacts);
  return true;
}

template <Scalar Real>
void LaneSystem<Real>::give_single_contacts(ContactProblem<Real>& contacts) const {
  int next = 0;
  for (const int k : batches_.single_blocks()) {
    Contact<Real>& contact = contacts.contacts[k];
    for (int i = 0; i < contact.count; ++i) contact.impulse[i] = contacts.problem->impulse[next++];
  }
}

template class LaneSystem<float>;
template class LaneSystem<double>;
template class LaneSystem<long double>;

}  // namespace cairn
