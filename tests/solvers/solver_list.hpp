// The solvers under test, problems for them, and who watches them.
#pragma once

#include "testing.hpp"
#include <cairn/validation/case_problems.hpp>

namespace cairn::testing {

using namespace cairn::cases;

/// n boxes of mass 1 kg on the ground, one normal row an interface, falling for one step: row j between j and
/// j + 1.
template <Scalar Real>
VelocityProblem<Real> hand_made_stack(int boxes, Real g, Real dt) {
  return column<Real>(List<Real>(boxes, Real(1)), g, dt);
}

/// A box of 1 m and 1 kg on feet at these places below it [m], as fast as a step of falling has made it and
/// faster by `push`. Where there is friction, each foot has its row behind that of the foot, `low` [m] below
/// the middle, and all rows are one block.
template <Scalar Real = double>
VelocityProblem<Real> box_on_feet(const List<Real>& feet, const Vec3<Real>& velocity, Real friction = 0,
                                  Real low = Real(0.5)) {
  VelocityProblem<Real> problem = empty_problem<Real>();
  const BodyId box = add_body<Real>(problem, 1, Real(1) / 6, velocity);
  for (const Real foot : feet) {
    const int normal = add_row(problem, floor_row<Real>(box, foot));
    if (friction > 0) add_row(problem, floor_friction_row<Real>(box, -low, friction, normal));
  }
  if (friction > 0) problem.blocks = {{0, problem.row_count()}};
  return problem;
}

/// Row k of the result is row order[k] of the problem, a block of its own.
template <Scalar Real, typename Rows>
VelocityProblem<Real> reordered(const VelocityProblem<Real>& problem, const Rows& order) {
  VelocityProblem<Real> result = problem;
  result.blocks.clear();
  List<int> place(order.size());
  for (int k = 0; k < order.size(); ++k) place[order[k]] = k;
  for (int k = 0; k < order.size(); ++k) {
    ConstraintRow<Real> row = problem.rows[order[k]];
    for (int* normal : {&row.bounds.normal_row, &row.bounds.second_normal_row})
      if (*normal >= 0) *normal = place[*normal];
    result.rows[k] = row;
    result.impulse[k] = problem.impulse[order[k]];
    result.blocks.push_back({k, 1});
  }
  return result;
}

/// Whether an impulse is outside of its bounds.
template <Scalar Real>
bool is_outside(const VelocityProblem<Real>& problem, int row, Real impulse) {
  return problem.rows[row].bounds.clamp(impulse, problem.impulse) != impulse;
}

/// Counts sweeps, and the impulses that are outside of their bounds after one.
template <Scalar Real>
class SweepWatcher final : public SolveObserver<Real> {
 public:
  void after_sweep(int, const VelocityProblem<Real>& problem) override {
    sweeps += 1;
    for (int i = 0; i < problem.row_count(); ++i) outside += is_outside(problem, i, problem.impulse[i]);
  }
  int sweeps = 0;
  int outside = 0;
};

/// Keeps the rows in the order in which they are updated, and counts those that are outside of their bounds
/// then, or not what the problem says.
template <Scalar Real>
class RowWatcher final : public SolveObserver<Real> {
 public:
  bool watches_rows() const override { return true; }
  void after_row(const RowUpdate<Real>& update, const VelocityProblem<Real>& problem) override {
    rows.push_back(update.row);
    outside += is_outside(problem, update.row, update.impulse_after);
  }
  List<int> rows = {};
  int outside = 0;
};

/// Counts the sweeps that changed nothing at all.
class UndoneSweeps final : public SolveObserver<double> {
 public:
  void before_solve(const VelocityProblem<double>& problem) override { last_ = problem.impulse; }
  void after_sweep(int, const VelocityProblem<double>& problem) override {
    count += problem.impulse == last_;
    last_ = problem.impulse;
  }
  int count = 0;

 private:
  PerRow<double> last_ = {};
};

}  // namespace cairn::testing
