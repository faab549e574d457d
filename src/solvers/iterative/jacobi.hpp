// Floor 4. Jacobi's method: all rows at once (paper 4.4, last paragraph).
#pragma once

#include <cairn/solvers/solver.hpp>
#include <cairn/solvers/stopping.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// What a row takes for the masses of its two bodies.
enum class Splitting {
  none,  // all of them, as if no other row touched them
  mass,  // its share: the mass over the number of rows that touch the body
};

/// What each row multiplies what is wrong by, omega / D_ii [kg] (Jacobi), and how many rows touch each body.
template <Scalar Real>
void prepare_jacobi(const VelocityProblem<Real>& problem, Real relaxation, Splitting splitting,
                    PerBody<int>& rows_on_body, PerRow<Real>& step);

/// Every row computes its impulse from the velocities and impulses at the beginning of the sweep; then all of
/// them act together. No row waits for another, so that each could have a processor of its own, and their
/// order means nothing but rounding (settings.order is not used). The price: rows that share a body correct
/// the same error several times over. settings.relaxation, omega, is the share of its correction that a row
/// gives: 1 is plain Jacobi, less is damped. Sums are clamped as in SequentialImpulse. Friction is bounded by
/// mu times the normal impulse of the sweep's beginning, which is one sweep older than Gauss-Seidel's.
///
/// Guarantees: every impulse is inside its bounds at the impulses of the sweep's beginning. With fixed bounds
/// the velocities converge when omega times the largest eigenvalue of D^-1 A is below 2, where D_ii is what
/// row i divides by. Without splitting D_ii = A_ii, and the eigenvalue may be as large as the number of rows
/// that act on each other: plain Jacobi does not converge for a box on three feet. With Splitting::mass
///   D_ii = n_a j_a M_a^-1 j_a^T + n_b j_b M_b^-1 j_b^T + softness,
/// n rows touching the body, and the eigenvalue is at most 1, because (x_1 + ... + x_n)^2 is at most
/// n (x_1^2 + ... + x_n^2): every omega below 2 converges. To solve each part of a split body alone and then
/// to average the velocities of the parts, as the method is told in R. Tonge, F. Benevolenski, A. Voroshilov,
/// Mass Splitting for Jitter-Free Parallel Rigid Body Simulation, 2012, gives the same numbers. Friction
/// moves its own bounds, so that the guarantee ends there; tests hold it against contact scenes.
///
/// Cost: 12 multiply-adds a row and sweep, memory linear in m: two numbers a row. Observers: after_row comes
/// in the order of the rows while all of them are being computed: its problem is still that of the sweep's
/// beginning. The correction has omega and the splitting in it.
template <Scalar Real = double>
class Jacobi final : public Solver<Real> {
 public:
  /// @throws std::invalid_argument for settings out of range.
  explicit Jacobi(const SolverSettings& settings = {}, Splitting splitting = Splitting::none);

  std::string name() const override;
  SolveReport solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer = nullptr) override;
  /// 2 m numbers, and a count for each body.
  std::size_t memory() const override { return step_.bytes() + new_impulse_.bytes() + rows_on_body_.bytes(); }

 private:
  Real sweep(int number, VelocityProblem<Real>& problem, SolveObserver<Real>* watcher);

  SolverSettings settings_;
  Splitting splitting_;
  PerRow<Real> step_;          // omega / D_ii [kg] for each row
  PerRow<Real> new_impulse_;   // [N s] for each row, until all of them are known
  PerBody<int> rows_on_body_;  // n, for each body; 1 where masses are not split
  Stopping<Real> stopping_;
};

}  // namespace cairn
