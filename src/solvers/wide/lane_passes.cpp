// Floor 4. Passes over the rows in lanes and over those that go one by one.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include <cairn/solvers/residual.hpp>
#include <cairn/solvers/wide/lane_system.hpp>

namespace cairn {

template <Scalar Real>
LaneSteps<Real> LaneSystem<Real>::sweep(VelocityProblem<Real>& problem, int number,
                                        SolveObserver<Real>* watcher) {
  return pass<LanePass::sweep>(problem, number, watcher);
}

template <Scalar Real>
Real LaneSystem<Real>::sweep_once(VelocityProblem<Real>& problem, int number, SolveObserver<Real>* observer) {
  Real largest = 0;
  const auto update = [&](int i, const ConstraintRow<Real>& row) {
    const Real old = problem.impulse[i], jv = row_velocity(problem, row), mass = effective_mass(problem, row);
    const Real corrective = relaxation_ * ((row.bias - jv - row.softness * old) * mass);
    const Real now = problem.impulse[i] = row.bounds.clamp(old + corrective, problem.impulse);
    apply_impulse(problem, row, now - old);
    largest = std::max(largest, std::abs(now - old));
    if (observer == nullptr) return;
    observer->after_row({number, i, jv, mass > 0 ? 1 / mass : Real(0), corrective, old, now}, problem);
  };
  for (int k = 0; k < batches_.singles().rows.size(); ++k)
    update(batches_.singles().rows[k], single_row(problem, k));
  for_each_run(
      [&](const LaneBatch& batch) {
        for (int lane = 0; lane < batch.used; ++lane) {
          const int first = batch.block_row[lane];
          for (int i = first; i < first + batch.rows; ++i) update(i, problem.rows[i]);
        }
      },
      [&](Span<const LaneBatch> run) {
        largest = std::max(largest, contacts_.sweep_once(code_, run, relaxation_, problem.velocity));
      });
  contacts_.give(batches_, problem);
  return largest;
}

template <Scalar Real>
LaneSteps<Real> LaneSystem<Real>::gather_momentum(VelocityProblem<Real>& problem, Real momentum) {
  before_.bodies = bodies_;
  before_.momentum = momentum;
  if (momentum > 0) return pass<LanePass::momentum>(problem);
  before_.remember(rows_, batches_.singles().rows, problem.impulse);
  return {};
}

template <Scalar Real>
void LaneSystem<Real>::take_again(VelocityProblem<Real>& problem) {
  write_back(problem);
  before_.take_off(rows_);
  take(problem);
}

template <Scalar Real>
void LaneSystem<Real>::undo(VelocityProblem<Real>& problem) {
  bodies_ = before_.bodies;
  before_.give_back(rows_, batches_.singles().rows, problem.impulse);
}

/// Colour by colour: batches of one share no body that can move.
template <Scalar Real>
template <LanePass kind>
LaneSteps<Real> LaneSystem<Real>::pass(VelocityProblem<Real>& problem, int number,
                                       SolveObserver<Real>* watcher) {
  LaneSteps<Real> steps = pass_single_rows<kind>(problem, number, watcher);
  const List<int>& colours = batches_.colours();
  for (int colour = 0; colour + 1 < colours.size(); ++colour) {
    const int begin = colours[colour], end = colours[colour + 1];
    for (int first = begin; first < end; first += batches_in_a_sum)
      steps.add(pass_batches<kind>(problem, first, std::min(first + batches_in_a_sum, end), number, watcher));
  }
  return steps;
}

template <Scalar Real>
template <LanePass kind>
LaneSteps<Real> LaneSystem<Real>::pass_batches(VelocityProblem<Real>& problem, int first, int last,
                                               int number, SolveObserver<Real>* watcher) {
  LaneProblem lanes = lane_problem();
  if (watcher != nullptr) {
    for (int i = first; i < last; ++i) {
      code_.pass(lanes, kind, i, i + 1);
      watch_batch(number, batches_.batches()[i], problem, *watcher);
    }
  } else {
    code_.pass(lanes, kind, first, last);
  }
  LaneSteps<Real> steps;
  for (int lane = 0; lane < lane_count; ++lane) {
    steps.add({.largest = static_cast<Real>(lanes.largest_change[lane]),
               .squares = static_cast<Real>(lanes.squares[lane]),
               .work = static_cast<Real>(lanes.work[lane])});
  }
  return steps;
}

template <Scalar Real>
LaneProblem LaneSystem<Real>::lane_problem() {
  return {.batches = batches_.batches().data(),
          .kinds = batches_.kinds().data(),
          .couplings = couplings_.data(),
          .rows = rows_.data(),
          .bodies = bodies_.data(),
          .before = before_.rows.data(),
          .relaxation = static_cast<float>(relaxation_),
          .momentum = static_cast<float>(before_.momentum)};
}

/// In the problem's own precision, but for the velocities' changes. Impulses are those of the problem.
template <Scalar Real>
template <LanePass kind>
LaneSteps<Real> LaneSystem<Real>::pass_single_rows(VelocityProblem<Real>& problem, int number,
                                                   SolveObserver<Real>* watcher) {
  LaneSteps<Real> steps;
  for (int k = 0; k < single_.mass.size(); ++k) {
    const int i = batches_.singles().rows[k];
    const ConstraintRow<Real>& row = single_row(problem, k);
    const Real jv = single_row_velocity(problem, row), old = problem.impulse[i];
    const Real wanted = (row.bias - jv - row.softness * old) * single_.mass[k];
    const Real corrective = relaxation_ * wanted;
    Real wish = kind == LanePass::weigh ? wanted : corrective;
    if constexpr (kind == LanePass::momentum) {
      wish = before_.momentum * (old - before_.singles[k]);
      before_.singles[k] = old;
    }
    const Real now = row.bounds.clamp(old + wish, problem.impulse), step = now - old;
    const Real inverse = single_.mass[k] > 0 ? 1 / single_.mass[k] : Real(0);
    steps.squares += step * step * inverse;
    if constexpr (kind == LanePass::weigh) continue;
    problem.impulse[i] = now;
    apply_single_row(problem, row, step);
    steps.largest = std::max(steps.largest, std::abs(step));
    steps.work += corrective * step * inverse;
    if (watcher != nullptr) {
      apply_impulse(problem, row, step);
      watcher->after_row({number, i, jv, inverse, corrective, old, problem.impulse[i]}, problem);
    }
  }
  return steps;
}

template <Scalar Real>
Real LaneSystem<Real>::single_row_velocity(const VelocityProblem<Real>& problem,
                                           const ConstraintRow<Real>& row) const {
  Real jv = 0;
  for_each_term(problem, row, [&](BodyId body, const Vec3<Real>& jacobian) {
    const float(&change)[4] = bodies_[body].numbers;
    for (int axis = 0; axis < 3; ++axis) {
      jv += jacobian(axis) *
            (from_.velocity[body](axis) + from_.root[body](axis) * static_cast<Real>(change[axis]));
    }
  });
  return jv;
}

template <Scalar Real>
void LaneSystem<Real>::apply_single_row(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row,
                                        Real step) {
  for_each_term(problem, row, [&](BodyId body, const Vec3<Real>& jacobian) {
    float(&change)[4] = bodies_[body].numbers;
    for (int axis = 0; axis < 3; ++axis) {
      change[axis] = static_cast<float>(static_cast<Real>(change[axis]) +
                                        from_.root[body](axis) * jacobian(axis) * step);
    }
  });
}

/// The problem goes the way of the lanes, row by row.
template <Scalar Real>
void LaneSystem<Real>::watch_batch(int number, const LaneBatch& batch, VelocityProblem<Real>& problem,
                                   SolveObserver<Real>& observer) const {
  for (int lane = 0; lane < batch.used; ++lane) {
    for (int r = 0; r < batch.rows; ++r) {
      const int i = batch.block_row[lane] + r;
      const ConstraintRow<Real>& row = problem.rows[i];
      const Real old = problem.impulse[i];
      const Real jv = row_velocity(problem, row);
      const Real mass = effective_mass(problem, row);
      const Real corrective = relaxation_ * ((row.bias - jv - row.softness * old) * mass);
      problem.impulse[i] = written_back(problem, batch, r, lane);
      apply_impulse(problem, row, problem.impulse[i] - old);
      observer.after_row({number, i, jv, mass > 0 ? 1 / mass : Real(0), corrective, old, problem.impulse[i]},
                         problem);
    }
  }
}

/// One of the two sums of R_E [J].
template <Scalar Real>
Real LaneSystem<Real>::energy(const VelocityProblem<Real>& problem, LaneEnergy kind) {
  const auto of_row = [&](int i, const ConstraintRow<Real>& row) {
    return kind == LaneEnergy::at_start ? starting_energy(problem, row)
                                        : correction_energy(problem, row, problem.impulse[i]);
  };
  Real sum = 0;
  for (int k = 0; k < batches_.singles().rows.size(); ++k)
    sum += of_row(batches_.singles().rows[k], single_row(problem, k));
  Real squares[lane_count] = {};
  for_each_run(
      [&](const LaneBatch& batch) {
        for (int r = 0; r < batch.rows; ++r) {
          for (int lane = 0; lane < batch.used; ++lane) {
            const int i = batch.block_row[lane] + r;
            squares[lane] += of_row(i, problem.rows[i]);
          }
        }
      },
      [&](Span<const LaneBatch> run) { contacts_.add_energy(code_, run, kind, problem.velocity, squares); });
  return sum + std::accumulate(std::begin(squares), std::end(squares), Real(0));
}

template <Scalar Real>
Real LaneSystem<Real>::residual_scale(VelocityProblem<Real>& problem) {
  problem.velocity.swap(from_.velocity);  // to those before the warm start
  const Real scale = std::max(std::sqrt(energy(problem, LaneEnergy::at_start)), least_scale(problem));
  problem.velocity.swap(from_.velocity);
  return scale;
}

template <Scalar Real>
Real LaneSystem<Real>::residual(VelocityProblem<Real>& problem, Real scale, LaneLook look) {
  if (look == LaneLook::rough) return std::sqrt(pass<LanePass::weigh>(problem).squares) / scale;
  const Real sum = energy(problem, LaneEnergy::of_answer);
  return sum == 0 ? Real(0) : std::sqrt(sum) / scale;
}

template class LaneSystem<float>;
template class LaneSystem<double>;

}  // namespace cairn
