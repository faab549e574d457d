// Floor 4. From contacts to lanes, and back.
#include "solvers/wide/lane_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace cairn {

namespace {

/// The manifold in one lane.
template <Scalar Real>
void keep_in_lane(const KeptManifold<Real>& kept, int lane, LaneKeptBatch<Real>& to) {
  for (int axis = 0; axis < 2; ++axis) {
    to.normal[axis][lane] = kept.normal(axis);
    for (int i = 0; i < most_lane_points; ++i) {
      to.core_a[i][axis][lane] = kept.points[i].core_a(axis);
      to.core_b[i][axis][lane] = kept.points[i].core_b(axis);
    }
  }
  to.radius_a[lane] = kept.radius_a;
  to.radius_b[lane] = kept.radius_b;
  to.on_b[lane] = kept.face == KeptManifold<Real>::Face::of_b ? Real(1) : Real(0);
}

}  // namespace

template <Scalar Real>
void LaneContacts<Real>::arrange(const LaneBatches& batches, const ContactProblem<Real>& problem,
                                 const PerBody<Vec3<Real>>& root) {
  contacts_.resize(batches.batches().size());
  roots_.resize(batches.batches().size());
  for (int k = 0; k < contacts_.size(); ++k) {
    const LaneBatch& batch = batches.batches()[k];
    LaneContactBatch<Real>& to = contacts_[k];
    if (batch.used < lane_count) {  // in all others, everything is set that is ever looked at
      to = {};
      roots_[k] = {};
    }
    to.rows = batch.rows;
    to.points = problem.manifolds[batch.block[0]].count;
    to.has_friction = to.rows > to.points;
    for (int lane = 0; lane < batch.used; ++lane) {
      const BodyId a = {batch.body_a[lane]}, b = {batch.body_b[lane]};
      for (int axis = 0; axis < 3; ++axis) {
        to.inverse_a[axis][lane] = problem.problem->inverse_mass[a](axis);
        to.inverse_b[axis][lane] = problem.problem->inverse_mass[b](axis);
        roots_[k].a[axis][lane] = static_cast<Number>(root[a](axis));
        roots_[k].b[axis][lane] = static_cast<Number>(root[b](axis));
      }
    }
  }
}

template <Scalar Real>
void LaneContacts<Real>::take(const LaneCode<Real>& code, const LaneBatches& batches,
                              const ContactProblem<Real>& problem) {
  const ContactRule<Real> rule = problem.stabilization->rule(problem.gravity);
  kept_.clear();
  for (int k = 0; k < contacts_.size(); ++k) {
    const LaneBatch& batch = batches.batches()[k];
    if (batch.used < lane_count) input_ = {};
    gather(batch, problem, contacts_[k]);
    code.measure_contacts(input_, rule, contacts_[k]);
  }
}

template <Scalar Real>
void LaneContacts<Real>::gather(const LaneBatch& batch, const ContactProblem<Real>& problem,
                                LaneContactBatch<Real>& to) {
  const PerBody<Pose<Real>>& poses = *problem.poses;
  for (int lane = 0; lane < batch.used; ++lane) {
    const Contact<Real>& contact = problem.contacts[batch.block[lane]];
    for (int axis = 0; axis < 2; ++axis) {
      input_.position_a[axis][lane] = poses[contact.a].position(axis);
      input_.position_b[axis][lane] = poses[contact.b].position(axis);
    }
    gather_manifold(problem.manifolds[batch.block[lane]], lane);
    to.friction[lane] = contact.friction;
    to.slop_limit[lane] = contact.slop_limit;
    for (int i = 0; i < to.rows; ++i) to.start[i][lane] = to.answer[i][lane] = contact.start[i];
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

template <Scalar Real>
bool LaneContacts<Real>::follow(const LaneCode<Real>& code, const LaneBatches& batches,
                                const ContactProblem<Real>& problem) {
  const ContactRule<Real> rule = problem.stabilization->rule(problem.gravity);
  if (kept_.size() < contacts_.size()) keep(batches, problem.contacts);
  take_frames(*problem.frames);
  for (int k = 0; k < contacts_.size(); ++k) {
    const LaneBatch& batch = batches.batches()[k];
    const int points = contacts_[k].points;
    if (!code.move_contacts(kept_[k], batch, frames_.data(), points, problem.margin, input_)) return false;
    for (int lane = 0; kept_[k].given >> lane != 0; ++lane) {
      if ((kept_[k].given >> lane & 1u) != 0) gather_manifold(problem.manifolds[batch.block[lane]], lane);
    }
    code.measure_contacts(input_, rule, contacts_[k]);
  }
  return true;
}

/// Manifolds, as far as they move by themselves.
template <Scalar Real>
void LaneContacts<Real>::keep(const LaneBatches& batches, Span<const Contact<Real>> contacts) {
  kept_.assign(contacts_.size(), LaneKeptBatch<Real>{});
  for (int k = 0; k < contacts_.size(); ++k) {
    const LaneBatch& batch = batches.batches()[k];
    for (int lane = 0; lane < batch.used; ++lane) {
      const Contact<Real>& contact = contacts[batch.block[lane]];
      kept_[k].deepest[lane] = contact.deepest;
      if (contact.kept != nullptr) {
        keep_in_lane(*contact.kept, lane, kept_[k]);
      } else {
        kept_[k].given |= 1u << lane;
      }
    }
  }
}

/// Where bodies are, as lanes read it.
template <Scalar Real>
void LaneContacts<Real>::take_frames(const PerBody<Frame<Real>>& frames) {
  frames_.resize(frames.size() + 1);
  for (const BodyId body : frames.indices()) {
    const Frame<Real>& frame = frames[body];
    frames_[body] = {{frame.position.x(), frame.position.y(), frame.rotation.c, frame.rotation.s}};
  }
  frames_[BodyId{frames.size()}] = {};
}

template <Scalar Real>
void LaneContacts<Real>::go_on() {
  for (LaneContactBatch<Real>& batch : contacts_) {
    for (int i = 0; i < batch.rows; ++i) {
      for (int lane = 0; lane < lane_count; ++lane) {
        batch.start[i][lane] = batch.answer[i][lane];
      }
    }
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
void LaneContacts<Real>::relax(const LaneCode<Real>& code, SecondStart start) {
  for (LaneContactBatch<Real>& batch : contacts_) {
    code.relax_contacts(batch);
    if (start == SecondStart::of_first_answer) continue;
    for (int i = 0; i < batch.rows; ++i) {
      for (int lane = 0; lane < lane_count; ++lane) {
        batch.answer[i][lane] = batch.start[i][lane];
      }
    }
  }
}

template <Scalar Real>
void LaneContacts<Real>::push(const LaneCode<Real>& code, const LaneBatches& batches,
                              PerBody<Vec3<Real>>& velocity) {
  take_velocities(velocity);
  for (int k = 0; k < contacts_.size(); ++k) {
    code.push_contacts(contacts_[k], batches.batches()[k], bodies_.data());
  }
  give_velocities(velocity);
}

template <Scalar Real>
Real LaneContacts<Real>::sweep_once(const LaneCode<Real>& code, const LaneBatches& batches, Real relaxation,
                                    PerBody<Vec3<Real>>& velocity) {
  take_velocities(velocity);
  Real largest[lane_count] = {};
  for (int k = 0; k < contacts_.size(); ++k) {
    code.sweep_contacts(contacts_[k], batches.batches()[k], relaxation, bodies_.data(), largest);
  }
  give_velocities(velocity);
  return *std::max_element(std::begin(largest), std::end(largest));
}

template <Scalar Real>
void LaneContacts<Real>::fill(const LaneCode<Real>& code, const LaneBatches& batches, Real relaxation,
                              const PerBody<Vec3<Real>>& velocity, List<LaneRow<Number>>& rows,
                              List<LaneCoupling<Number>>& couplings) {
  take_velocities(velocity);
  for (int k = 0; k < contacts_.size(); ++k) {
    const LaneBatch& batch = batches.batches()[k];
    code.fill_contacts(contacts_[k], batch, bodies_.data(), roots_[k], relaxation, &rows[batch.first_row],
                       couplings.data() + batch.first_coupling);
  }
}

template <Scalar Real>
void LaneContacts<Real>::empty(const LaneCode<Real>& code, const LaneBatches& batches,
                               const List<LaneRow<Number>>& rows, PerBody<Vec3<Real>>& velocity) {
  take_velocities(velocity);
  for (int k = 0; k < contacts_.size(); ++k) {
    const LaneBatch& batch = batches.batches()[k];
    code.empty_contacts(&rows[batch.first_row], contacts_[k], batch, bodies_.data());
  }
  give_velocities(velocity);
}

template <Scalar Real>
Real LaneContacts<Real>::energy(const LaneCode<Real>& code, const LaneBatches& batches, LaneEnergy kind,
                                const PerBody<Vec3<Real>>& velocity) {
  take_velocities(velocity);
  Real squares[lane_count] = {};
  for (int k = 0; k < contacts_.size(); ++k) {
    code.weigh_contacts(contacts_[k], batches.batches()[k], bodies_.data(), kind, squares);
  }
  return std::accumulate(std::begin(squares), std::end(squares), Real(0));
}

template <Scalar Real>
void LaneContacts<Real>::give(const LaneBatches& batches, Span<Contact<Real>> contacts) const {
  for (int k = 0; k < contacts_.size(); ++k) {
    const LaneBatch& batch = batches.batches()[k];
    for (int lane = 0; lane < batch.used; ++lane) {
      Contact<Real>& contact = contacts[batch.block[lane]];
      for (int i = 0; i < batch.rows; ++i) {
        contact.start[i] = contacts_[k].start[i][lane];
        contact.impulse[i] = contacts_[k].answer[i][lane];
      }
    }
  }
}

template <Scalar Real>
Real LaneContacts<Real>::largest_impulse() const {
  Real largest = 0;
  for (const LaneContactBatch<Real>& batch : contacts_) {
    for (int i = 0; i < batch.rows; ++i) {
      for (const Real impulse : batch.answer[i]) largest = std::max(largest, std::abs(impulse));
    }
  }
  return largest;
}

template class LaneContacts<float>;
template class LaneContacts<double>;
template class LaneContacts<long double>;

}  // namespace cairn
