// Floor 4. Fills lanes, and empties them.
#include <cairn/solvers/wide/lane_system.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/constraints/contact_rows.hpp>
#include <cairn/math/check.hpp>

namespace cairn {

namespace {

LaneSet known(LaneSet set) {
  require(has(set), "WideSequentialImpulse", "instruction set", "one of this processor",
          static_cast<int>(set));
  return set;
}

}  // namespace

template <Scalar Real>
LaneSystem<Real>::LaneSystem(LaneSet set, Real relaxation)
    : code_(lane_code<Real>(known(set))), relaxation_(relaxation) {}

template <Scalar Real>
void LaneSystem<Real>::begin(VelocityProblem<Real>& problem) {
  if (problem.has_rows()) return begin_rows(problem);
  if (!contacts_.knows(problem)) {
    const bool new_masses = take_masses(problem);
    const bool rearranged = batches_.arrange_contacts(problem);
    if (rearranged || new_masses) contacts_.arrange(batches_, problem, from_.root);
  }
  write_single_contacts(problem);
  contacts_.take(code_, batches_, problem);
  push(problem);
}

template <Scalar Real>
void LaneSystem<Real>::begin_rows(VelocityProblem<Real>& problem) {
  single_.contact_rows.clear();
  take_masses(problem);
  from_.velocity = problem.velocity;
  if (batches_.may_be_same(problem) && push_rows(problem)) return;
  problem.velocity = from_.velocity;
  batches_.arrange(problem);
  push_rows(problem);
}

/// Behind the problem's rows, from where they are taken away again.
template <Scalar Real>
void LaneSystem<Real>::write_single_contacts(VelocityProblem<Real>& problem) {
  single_.contact_rows.clear();
  const int first = problem.row_count();
  for (const int k : batches_.singles().contacts) {
    int next = first;
    write_contact_rows(problem.contacts[k], problem, next);
    for (int i = first; i < next; ++i) {
      single_.contact_rows.push_back(problem.rows[i]);
      single_.contact_rows.back().bounds.shift(problem.blocks[problem.joint_blocks() + k].first - first);
    }
  }
  problem.rows.resize(first);
}

/// False where a lane is not made for its row any more: velocities are of no use then.
template <Scalar Real>
bool LaneSystem<Real>::push_rows(VelocityProblem<Real>& problem) {
  for (const int i : batches_.singles().rows) apply_impulse(problem, problem.rows[i], problem.impulse[i]);
  for (const LaneBatch& batch : batches_.batches()) {
    for (int lane = 0; lane < batch.used; ++lane) {
      for (int r = 0; r < batch.rows; ++r) {
        if (!batches_.is_same_row(problem, batch, r, lane)) return false;
        const int i = batch.block_row[lane] + r;
        apply_impulse(problem, problem.rows[i], problem.impulse[i]);
      }
    }
  }
  return true;
}

/// The warm start of lanes that are made for their rows.
template <Scalar Real>
void LaneSystem<Real>::push(VelocityProblem<Real>& problem) {
  from_.velocity = problem.velocity;
  for (int k = 0; k < batches_.singles().rows.size(); ++k)
    apply_impulse(problem, single_row(problem, k), problem.impulse[batches_.singles().rows[k]]);
  for_each_run(
      [&](const LaneBatch& batch) {
        for (int lane = 0; lane < batch.used; ++lane) {
          for (int i = batch.block_row[lane]; i < batch.block_row[lane] + batch.rows; ++i)
            apply_impulse(problem, problem.rows[i], problem.impulse[i]);
        }
      },
      [&](Span<const LaneBatch> run) { contacts_.push(code_, run, problem.velocity); });
}

template <Scalar Real>
void LaneSystem<Real>::take(const VelocityProblem<Real>& problem) {
  begin_changes(problem);
  rows_.resize(batches_.counts().rows);
  couplings_.resize(batches_.counts().couplings);
  fill(problem);
  if (batches_.counts().contact_batches > 0)
    contacts_.fill(code_, batches_, relaxation_, from_.velocity, rows_, couplings_);
}

/// Changes begin at 0; and so do rows that go one by one.
template <Scalar Real>
void LaneSystem<Real>::begin_changes(const VelocityProblem<Real>& problem) {
  from_.velocity = problem.velocity;
  bodies_.assign(problem.velocity.size() + 1, LaneBody<float>{});
  from_.impulse = problem.impulse;
  take_single_rows(problem);
}

template <Scalar Real>
void LaneSystem<Real>::fill(const VelocityProblem<Real>& problem) {
  filling_.relaxation = relaxation_;
  for (const LaneBatch& batch : batches_.batches()) {
    if (batch.contacts >= 0) continue;
    if (batch.used < lane_count)
      filling_ = {.bodies = {}, .roots = {}, .rows = {}, .relaxation = relaxation_};
    filling_.row_count = batch.rows;
    take_batch_bodies(batch);
    for (int lane = 0; lane < batch.used; ++lane) {  // block after block, as they lie in memory
      for (int i = 0; i < batch.rows; ++i) take_row(problem, batch, i, lane);
    }
    code_.fill(filling_, &rows_[batch.first_row], couplings_.data() + batch.first_coupling);
  }
}

/// Whether one has changed.
template <Scalar Real>
bool LaneSystem<Real>::take_masses(const VelocityProblem<Real>& problem) {
  bool changed = from_.root.size() != problem.inverse_mass.size();
  if (changed) {
    from_.inverse_mass.assign(problem.inverse_mass.size(), Vec3<Real>::Zero());
    from_.root = from_.inverse_mass;
  }
  for (const BodyId body : from_.root.indices()) {
    if (from_.inverse_mass[body] == problem.inverse_mass[body]) continue;
    from_.inverse_mass[body] = problem.inverse_mass[body];
    from_.root[body] = from_.inverse_mass[body].cwiseSqrt();
    changed = true;
  }
  return changed;
}

template <Scalar Real>
void LaneSystem<Real>::take_single_rows(const VelocityProblem<Real>& problem) {
  single_.mass.clear();
  for (int k = 0; k < batches_.singles().rows.size(); ++k)
    single_.mass.push_back(effective_mass(problem, single_row(problem, k)));
}

template <Scalar Real>
void LaneSystem<Real>::take_batch_bodies(const LaneBatch& batch) {
  LaneBodyInput<Real>& to = filling_.bodies;
  LaneRoots& roots = filling_.roots;
  for (int lane = 0; lane < batch.used; ++lane) {
    const BodyId a = {batch.body_a[lane]}, b = {batch.body_b[lane]};
    for (int axis = 0; axis < 3; ++axis) {
      to.velocity_a[axis][lane] = from_.velocity[a](axis);
      to.velocity_b[axis][lane] = from_.velocity[b](axis);
      roots.a[axis][lane] = static_cast<float>(from_.root[a](axis));
      roots.b[axis][lane] = static_cast<float>(from_.root[b](axis));
    }
  }
}

template <Scalar Real>
void LaneSystem<Real>::take_row(const VelocityProblem<Real>& problem, const LaneBatch& batch, int number,
                                int lane) {
  LaneInput<Real>& to = filling_.rows[number];
  const LaneKind kind = batches_.kinds()[batch.first_kind + number];
  const int i = batch.block_row[lane] + number;
  const ConstraintRow<Real>& row = problem.rows[i];
  for (int axis = 0; axis < 3; ++axis) {
    to.jacobian_a[axis][lane] = row.jacobian_a(axis);
    to.jacobian_b[axis][lane] = row.jacobian_b(axis);
  }
  to.bias[lane] = row.bias;
  to.softness[lane] = row.softness;
  to.impulse[lane] = from_.impulse[i];
  if (kind.bounds < LaneBounds::friction) {
    to.lower[lane] = row.bounds.lower;
    to.upper[lane] = row.bounds.upper;
  } else {
    Real load = from_.impulse[batch.block_row[lane] + kind.normal];
    if (kind.bounds == LaneBounds::friction_of_two) {
      load += from_.impulse[batch.block_row[lane] + kind.second_normal];
    }
    to.friction[lane] = row.bounds.friction;
    to.lower[lane] = -row.bounds.friction * load;
    to.upper[lane] = row.bounds.friction * load;
  }
}

template <Scalar Real>
Real LaneSystem<Real>::written_back(const VelocityProblem<Real>& problem, const LaneBatch& batch, int r,
                                    int lane) const {
  const int i = batch.block_row[lane] + r;
  const LaneRow& row = rows_[batch.first_row + r];
  const Real change = static_cast<Real>(row.scale[lane]) * static_cast<Real>(row.impulse[lane]);
  return problem.rows[i].bounds.clamp(from_.impulse[i] + change, problem.impulse);
}

template <Scalar Real>
void LaneSystem<Real>::write_back(VelocityProblem<Real>& problem) {
  problem.velocity = from_.velocity;
  empty_single_rows(problem);
  for_each_run([&](const LaneBatch& batch) { empty_rows(problem, batch); },
               [&](Span<const LaneBatch> run) { contacts_.empty(code_, run, rows_, problem.velocity); });
  contacts_.give(batches_, problem);
}

template <Scalar Real>
void LaneSystem<Real>::empty_single_rows(VelocityProblem<Real>& problem) const {
  for (int k = 0; k < batches_.singles().rows.size(); ++k) {
    const int i = batches_.singles().rows[k];
    apply_impulse(problem, single_row(problem, k), problem.impulse[i] - from_.impulse[i]);
  }
}

template <Scalar Real>
void LaneSystem<Real>::empty_rows(VelocityProblem<Real>& problem, const LaneBatch& batch) const {
  for (int lane = 0; lane < batch.used; ++lane) {
    for (int r = 0; r < batch.rows; ++r) {
      const int i = batch.block_row[lane] + r;
      problem.impulse[i] = written_back(problem, batch, r, lane);
      apply_impulse(problem, problem.rows[i], problem.impulse[i] - from_.impulse[i]);
    }
  }
}

template <Scalar Real>
bool LaneSystem<Real>::is_worth_taking(Real change, Real path) const {
  if (!(path > 0) || !(change <= 1024 * static_cast<Real>(std::numeric_limits<float>::epsilon()) * path))
    return false;
  Real largest = 0;
  for (const Real impulse : from_.impulse) largest = std::max(largest, std::abs(impulse));
  return path > 16 * std::numeric_limits<Real>::epsilon() * largest;
}

template <Scalar Real>
std::size_t LaneSystem<Real>::bytes() const {
  return batches_.bytes() + contacts_.bytes() + rows_.bytes() + couplings_.bytes() + bodies_.bytes() +
         from_.inverse_mass.bytes() + from_.root.bytes() + from_.velocity.bytes() + from_.impulse.bytes() +
         single_.mass.bytes() + single_.contact_rows.bytes() + before_.bytes();
}

template class LaneSystem<float>;
template class LaneSystem<double>;

}  // namespace cairn
