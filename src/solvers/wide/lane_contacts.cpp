// Floor 4. From contacts to lanes, and back.
#include <cairn/solvers/wide/lane_contacts.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace cairn {

template <Scalar Real>
void LaneContacts<Real>::arrange(const LaneBatches& batches, const VelocityProblem<Real>& problem,
                                 const PerBody<Vec3<Real>>& root) {
  contacts_.resize(batches.counts().contact_batches);
  roots_.resize(batches.counts().contact_batches);
  for (const LaneBatch& batch : batches.batches()) {
    if (batch.contacts < 0) continue;
    LaneContactBatch<Real>& to = contacts_[batch.contacts];
    LaneRoots& roots = roots_[batch.contacts];
    if (batch.used < lane_count) {  // in all others, everything is set that is ever looked at
      to = {};
      roots = {};
    }
    to.points = problem.contacts[batch.block[0]].manifold.count;
    to.has_friction = batch.rows > to.points;
    for (int lane = 0; lane < batch.used; ++lane) {
      const BodyId a = {batch.body_a[lane]}, b = {batch.body_b[lane]};
      for (int axis = 0; axis < 3; ++axis) {
        to.inverse_a[axis][lane] = problem.inverse_mass[a](axis);
        to.inverse_b[axis][lane] = problem.inverse_mass[b](axis);
        roots.a[axis][lane] = static_cast<float>(root[a](axis));
        roots.b[axis][lane] = static_cast<float>(root[b](axis));
      }
    }
  }
}

template <Scalar Real>
void LaneContacts<Real>::take(const LaneCode<Real>& code, const LaneBatches& batches,
                              const VelocityProblem<Real>& problem) {
  const bool known = problem.is_second && knows(problem);
  for (const LaneBatch& batch : batches.batches()) {
    if (batch.contacts < 0) continue;
    LaneContactBatch<Real>& to = contacts_[batch.contacts];
    if (!known) {
      if (batch.used < lane_count) input_ = {};
      gather(batch, problem);
      code.measure_contacts(input_, problem.rule, to);
    }
    if (problem.is_second) code.begin_second_solve(to);
    for (int lane = 0; lane < batch.used; ++lane) {
      for (int i = 0; i < batch.rows; ++i) to.answer[i][lane] = problem.impulse[batch.block_row[lane] + i];
    }
  }
  taken_ = problem.number.value();
}

template <Scalar Real>
void LaneContacts<Real>::gather(const LaneBatch& batch, const VelocityProblem<Real>& problem) {
  LaneContactBatch<Real>& to = contacts_[batch.contacts];
  for (int lane = 0; lane < batch.used; ++lane) {
    const Contact<Real>& contact = problem.contacts[batch.block[lane]];
    for (int axis = 0; axis < 2; ++axis) {
      input_.center_a[axis][lane] = contact.center_a(axis);
      input_.center_b[axis][lane] = contact.center_b(axis);
    }
    gather_manifold(contact.manifold, lane);
    to.friction[lane] = contact.friction;
    input_.slop_limit[lane] = contact.slop_limit;
    for (int i = 0; i < to.points; ++i) {
      to.rebound[i][lane] = contact.rebound[i];
      input_.rigid[i][lane] = contact.rigid[i] ? Real(1) : Real(0);
    }
  }
}

template <Scalar Real>
void LaneContacts<Real>::gather_manifold(const Manifold<Real>& manifold, int lane) {
  input_.normal[0][lane] = manifold.normal.x();
  input_.normal[1][lane] = manifold.normal.y();
  for (int i = 0; i < manifold.count; ++i) {
    const ManifoldPoint<Real>& point = manifold.points[i];
    input_.point[i][0][lane] = point.position.x();
    input_.point[i][1][lane] = point.position.y();
    input_.separation[i][lane] = point.separation;
  }
}

/// Velocities as lanes read them, and those of a body that nothing moves.
template <Scalar Real>
void LaneContacts<Real>::take_velocities(const PerBody<Vec3<Real>>& velocity) {
  bodies_.resize(velocity.size() + 1);
  for (const BodyId body : velocity.indices()) {
    const Vec3<Real>& v = velocity[body];
    bodies_[body] = {{v.x(), v.y(), v.z(), Real(0)}};
  }
  bodies_[BodyId{velocity.size()}] = {};
}

template <Scalar Real>
void LaneContacts<Real>::give_velocities(PerBody<Vec3<Real>>& velocity) const {
  for (const BodyId body : velocity.indices()) {
    const Real(&v)[4] = bodies_[body].numbers;
    velocity[body] = {v[0], v[1], v[2]};
  }
}

template <Scalar Real>
void LaneContacts<Real>::push(const LaneCode<Real>& code, Span<const LaneBatch> run,
                              PerBody<Vec3<Real>>& velocity) {
  take_velocities(velocity);
  for (const LaneBatch& batch : run) code.push_contacts(contacts_[batch.contacts], batch, bodies_.data());
  give_velocities(velocity);
}

template <Scalar Real>
Real LaneContacts<Real>::sweep_once(const LaneCode<Real>& code, Span<const LaneBatch> run, Real relaxation,
                                    PerBody<Vec3<Real>>& velocity) {
  take_velocities(velocity);
  Real largest[lane_count] = {};
  for (const LaneBatch& batch : run)
    code.sweep_contacts(contacts_[batch.contacts], batch, relaxation, bodies_.data(), largest);
  give_velocities(velocity);
  return *std::max_element(std::begin(largest), std::end(largest));
}

template <Scalar Real>
void LaneContacts<Real>::fill(const LaneCode<Real>& code, const LaneBatches& batches, Real relaxation,
                              const PerBody<Vec3<Real>>& velocity, List<LaneRow>& rows,
                              List<LaneCoupling>& couplings) {
  take_velocities(velocity);
  for (const LaneBatch& batch : batches.batches()) {
    if (batch.contacts < 0) continue;
    code.fill_contacts(contacts_[batch.contacts], batch, bodies_.data(), roots_[batch.contacts], relaxation,
                       &rows[batch.first_row], couplings.data() + batch.first_coupling);
  }
}

template <Scalar Real>
void LaneContacts<Real>::empty(const LaneCode<Real>& code, Span<const LaneBatch> run,
                               const List<LaneRow>& rows, PerBody<Vec3<Real>>& velocity) {
  take_velocities(velocity);
  for (const LaneBatch& batch : run)
    code.empty_contacts(&rows[batch.first_row], contacts_[batch.contacts], batch, bodies_.data());
  give_velocities(velocity);
}

template <Scalar Real>
void LaneContacts<Real>::add_energy(const LaneCode<Real>& code, Span<const LaneBatch> run, LaneEnergy kind,
                                    const PerBody<Vec3<Real>>& velocity, Real* squares) {
  take_velocities(velocity);
  for (const LaneBatch& batch : run)
    code.weigh_contacts(contacts_[batch.contacts], batch, bodies_.data(), kind, squares);
}

template <Scalar Real>
void LaneContacts<Real>::give(const LaneBatches& batches, VelocityProblem<Real>& problem) const {
  for (const LaneBatch& batch : batches.batches()) {
    if (batch.contacts < 0) continue;
    const LaneContactBatch<Real>& from = contacts_[batch.contacts];
    for (int lane = 0; lane < batch.used; ++lane) {
      for (int i = 0; i < batch.rows; ++i) problem.impulse[batch.block_row[lane] + i] = from.answer[i][lane];
    }
  }
}

template class LaneContacts<float>;
template class LaneContacts<double>;

}  // namespace cairn
