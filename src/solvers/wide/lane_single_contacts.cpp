// Floor 4. Contacts that fit into no lane.
#include "solvers/wide/lane_system.hpp"

namespace cairn {

/// Of the contacts that fit into no lane.
template <Scalar Real>
void LaneSystem<Real>::write_single_rows(const ContactProblem<Real>& contacts) {
  VelocityProblem<Real>& problem = *contacts.problem;
  int next = contacts.rows;
  for (const int k : batches_.single_contacts()) {
    const Contact<Real>& contact = contacts.contacts[k];
    const ContactMaterial<Real> material = {.friction = contact.friction, .slop_limit = contact.slop_limit};
    write_contact_rows(contacts.manifolds[k], contact.a, contact.b, material, *contacts.poses,
                       problem.velocity, contacts.rule, 0, problem, next);
  }
  problem.rows.resize(next);
  start_single_contacts(contacts);
}

template <Scalar Real>
void LaneSystem<Real>::start_single_contacts(const ContactProblem<Real>& contacts) {
  PerRow<Real>& impulse = contacts.problem->impulse;
  impulse.resize(contacts.rows);
  for (const int k : batches_.single_contacts()) {
    const Contact<Real>& contact = contacts.contacts[k];
    for (int i = 0; i < contact.count; ++i) impulse.push_back(contact.start[i]);
  }
}

template <Scalar Real>
void LaneSystem<Real>::give_single_contacts(ContactProblem<Real>& contacts) const {
  int next = contacts.rows;
  for (const int k : batches_.single_contacts()) {
    Contact<Real>& contact = contacts.contacts[k];
    for (int i = 0; i < contact.count; ++i) contact.impulse[i] = contacts.problem->impulse[next++];
  }
}

template class LaneSystem<float>;
template class LaneSystem<double>;
template class LaneSystem<long double>;

}  // namespace cairn
