// Floor 4. Sequential impulses: section 3 of the paper.
#pragma once

#include <cairn/solvers/row_order.hpp>
#include <cairn/solvers/solver.hpp>
#include <cairn/solvers/stopping.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// What is clamped to a row's bounds.
enum class Clamp {
  accumulated,  // the sum of all that the row has given: Algorithm 1
  increment,    // each corrective impulse alone: a mistake to look at, as no impulse is ever taken back
};

/// When effective masses are computed.
enum class EffectiveMass {
  precomputed,  // once, before the sweeps
  in_the_loop,  // at every row update, as (22) reads: the same numbers to the last bit, for more work
};

/// How Algorithm 1 is carried out: for lessons on why it is written as it is (paper 3.2 and 4.2).
struct SequentialImpulseVariant {
  Clamp clamp = Clamp::accumulated;                           // what is clamped
  EffectiveMass effective_mass = EffectiveMass::precomputed;  // when they are computed
};

/// Algorithm 1. Visits one row after the other; computes the impulse that would satisfy that row alone (22),
/// adds it to what the row has given so far, clamps the sum, and gives the difference to the two bodies at
/// once. Builds no matrix. Effective masses are computed once, before the sweeps. A relaxation other than 1
/// makes it SOR.
///
/// Guarantees: every impulse is inside its bounds after its row's update (not with Clamp::increment); only
/// the row's two bodies change. Its impulses are those of Gauss-Seidel on A lambda = b (paper 4.1, eq.
/// (24)-(29)). Cost: 12 multiply-adds a row and sweep (6 for j v, 6 for the update), memory linear in m: one
/// effective mass and one place in the order a row.
template <Scalar Real = double>
class SequentialImpulse final : public Solver<Real> {
 public:
  /// @throws std::invalid_argument for settings out of range.
  explicit SequentialImpulse(const SolverSettings& settings = {},
                             const SequentialImpulseVariant& variant = {});

  std::string name() const override { return "SI"; }
  SolveReport solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer = nullptr) override;
  /// m numbers; without the order of the rows, an index for each.
  std::size_t memory() const override { return effective_mass_.bytes(); }

 private:
  void prepare(const VelocityProblem<Real>& problem);
  Real sweep(int number, VelocityProblem<Real>& problem, SolveObserver<Real>* watcher);

  SolverSettings settings_;
  SequentialImpulseVariant variant_;
  PerRow<Real> effective_mass_;  // [kg] for each row, 1 / A_ii
  RowSequence sequence_;
  Stopping<Real> stopping_;
};

}  // namespace cairn
