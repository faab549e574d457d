// Floor 4. Newton's method as a solver for steps: warm, in double, on sparse factors.
#pragma once

#include <type_traits>
#include <utility>

#include "solvers/exact/block_factors.hpp"
#include "solvers/exact/proximal_rows.hpp"
#include "solvers/solver.hpp"
#include "math/list.hpp"

namespace cairn {

/// Sees the rows, and solves all of them at once, by the proximal steps of newton.hpp: rows a little soft
/// around the impulses of the moment, each such problem by Newton's method, one sparse linear system after
/// the other. It differs from newton() in three things. It begins from the warm start, and at a softness from
/// which a pile at rest needs one or two systems; only where that fails do sweeps of accelerated PGS lead on.
/// It computes in double (for float too), on factors in blocks (block_factors.hpp). And it stops at the
/// settings' tolerance, of which 1e-9 is enough for any scene, or where R_E falls no further.
///
/// Masses do not matter, nor does how far a load has to travel: what takes Gauss-Seidel 10^5 sweeps takes it
/// the same few systems. For fixed bounds that rows can keep, it converges; with friction nothing is
/// guaranteed. Where it has not converged it gives the impulses with the least R_E that it has seen, those of
/// the warm start among them.
///
/// settings.iterations is the number of linear systems, at most; order, relaxation, patience and time_budget
/// mean nothing to it. Cost of a system: for a stack or a chain that of about 15 sweeps of SequentialImpulse;
/// for a pile of bodies on a plane it grows a little faster than their number. Memory: that of the factors.
/// Observers see the end alone.
template <Scalar Real = double>
class NewtonSolver final : public Solver<Real> {
 public:
  /// @throws std::invalid_argument for settings out of range.
  explicit NewtonSolver(const SolverSettings& settings = {});

  std::string name() const override { return "Newton"; }
  /// @throws std::length_error for more pairs of bodies than BlockFactors holds: before anything is changed.
  SolveReport solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer = nullptr) override;
  std::size_t memory() const override { return factors_.memory(); }

 private:
  /// What it computes in.
  using Work = std::conditional_t<std::is_same_v<Real, long double>, long double, double>;

  void begin(const VelocityProblem<Work>& problem);
  void answer(const VelocityProblem<Work>& problem);
  void approach(const VelocityProblem<Work>& problem);
  void sweep(const VelocityProblem<Work>& problem, int sweeps);
  Work enough() const;
  bool solve_softened();
  bool find_change(Vector<Work>& change);
  bool shorten(const Vector<Work>& change, Work& error);
  void note_center();

  SolverSettings settings_;
  ProximalRows<Work> rows_;
  BlockFactors<Work> factors_;
  List<std::pair<int, int>> pairs_;  // of bodies that share a row
  Vector<Work> du_;                  // where Newton's method is
  Vector<Work> next_;                // and where it may go
  Vector<Work> change_;              // its step
  Work scale_ = 0;                   // of R_E
  Work residual_ = 0;                // R_E at the centre
  Work least_residual_ = 0;
  VelocityProblem<Work> swept_;  // a copy for sweeps
  PerRow<Work> best_;            // [N s] the impulses with that
  int systems_ = 0;              // solved
  int sweeps_ = 0;               // done between them, and one to look at the warm start
};

}  // namespace cairn
