// Floor 8. Problems written by hand, row by row, and how fast sweeps solve them.
#pragma once

#include <cmath>

#include <cairn/measure/recorder.hpp>
#include <cairn/solvers/residual.hpp>
#include <cairn/validation/case_solvers.hpp>
#include <cairn/validation/column.hpp>
#include <cairn/math/list.hpp>

namespace cairn::cases {

/// A contact of the ground with body `b` at arm (x, y) from its centre: the normal is up.
template <Scalar Real>
ConstraintRow<Real> floor_row(BodyId b, Real x) {
  ConstraintRow<Real> row;
  row.b = b;
  row.jacobian_b = {0, 1, x};
  row.bounds = Bounds<Real>::unilateral();
  return row;
}

/// The friction that goes with row `normal`, at height y from the centre of `b`: the tangent points right.
template <Scalar Real>
ConstraintRow<Real> floor_friction_row(BodyId b, Real y, Real friction, int normal) {
  ConstraintRow<Real> row;
  row.b = b;
  row.jacobian_b = {1, 0, -y};
  row.bounds = Bounds<Real>::coulomb(friction, normal);
  return row;
}

/// n equal boxes.
template <Scalar Real>
VelocityProblem<Real> stack(int n) {
  return column<Real>(List<Real>(n, Real(1)));
}

/// Beads of 1 kg on a line, each tied to the next by a rod, at rest but for the first, which was struck.
/// Rows: n - 1.
inline VelocityProblem<double> free_chain(int n) {
  VelocityProblem<double> problem = empty_problem<double>();
  BodyId last = add_body<double>(problem, 1, 1, {0, 1, 0});
  for (int i = 1; i < n; ++i) {
    const BodyId bead = add_body<double>(problem, 1, 1, {0, 0, 0});
    add_row(problem, vertical_row<double>(last, bead, Bounds<double>::equality()));
    last = bead;
  }
  return problem;
}

/// A box of 1 kg that fits tightly between two walls, each with one contact and its friction, after one step
/// of falling. Rows: normal and friction of the left wall, then of the right one. Up is along the tangents.
inline VelocityProblem<double> box_in_slot(double friction) {
  VelocityProblem<double> problem = empty_problem<double>();
  const BodyId slot_box = add_body<double>(problem, 1, 1.0 / 6, {0, -standard_gravity * standard_dt, 0});
  for (const double side : {-1.0, 1.0}) {
    ConstraintRow<double> normal;
    normal.b = slot_box;
    normal.jacobian_b = {-side, 0, 0};
    normal.bounds = Bounds<double>::unilateral();
    const int place = add_row(problem, normal);
    ConstraintRow<double> tangent = normal;
    tangent.jacobian_b = {0, 1, side / 2};
    tangent.bounds = Bounds<double>::coulomb(friction, place);
    add_row(problem, tangent);
  }
  return problem;
}

/// Of the rod below, by the arm (0.5 cos, -0.5 sin) with tan = 2 from its centre to its lower end and its
/// inertia 1/12: A_nn = 1 + 12 x^2, A_nt = 12 x y, A_tt = 1 + 12 y^2 [1/kg].
inline constexpr double painleve_nn = 1.6, painleve_nt = 1.2, painleve_tt = 3.4;
inline constexpr double painleve_fall = 0.01;  // [m/s] g dt

/// A uniform rod of 1 m and 1 kg, inclined by atan 2, on its lower end that slides along the floor
/// (P. Painleve, 1895), after one step of 0.001 s of falling. Its centre is on the left of that end and has
/// the given speed to the right [m/s]: friction turns the end out of the floor when the end goes to the left,
/// and into it when it goes to the right.
template <Scalar Real>
VelocityProblem<Real> painleve_rod(Real speed, Real friction) {
  VelocityProblem<Real> problem = empty_problem<Real>(Real(0.001));
  const Real x = Real(0.5) / std::sqrt(Real(5)), y = -2 * x;
  const BodyId rod = add_body<Real>(problem, 1, Real(1) / 12, {speed, -static_cast<Real>(painleve_fall), 0});
  const int normal = add_row(problem, floor_row<Real>(rod, x));
  const int tangent = add_row(problem, floor_friction_row<Real>(rod, y, friction, normal));
  problem.rows[tangent].key.part = 1;
  return problem;
}

/// The largest violation of any row by these impulses instead of those of the problem, whose velocities are
/// those without any [m/s]: 0 for a solution.
inline double violation_by(VelocityProblem<double> problem, const PerRow<double>& impulse) {
  problem.impulse = impulse;
  for (int i = 0; i < impulse.size(); ++i) apply_impulse(problem, problem.rows[i], impulse[i]);
  return residual(problem, 1.0).velocity;
}

/// All impulses after each sweep, in the scalar they were computed in. Sweep 0 is the start.
template <Scalar Real>
class ImpulseTrace final : public SolveObserver<Real> {
 public:
  void before_solve(const VelocityProblem<Real>& problem) override { sweeps = {problem.impulse}; }
  void after_sweep(int, const VelocityProblem<Real>& problem) override { sweeps.push_back(problem.impulse); }
  List<PerRow<Real>> sweeps = {};
};

/// The ratio of tensions up to which friction holds a rope that bends by pi in n equal corners (L. Euler,
/// 1769, for many). At each one the pulls T and T' press with (T + T') sin(h), h half the corner, and pull
/// along with (T' - T) cos(h).
inline double capstan_ratio(int n, double friction) {
  const double bend = friction * std::tan(pi / (2 * n));
  return std::pow((1 + bend) / (1 - bend), n);
}

/// How many sweeps make the error ten times as small, where each leaves `rate` of it.
inline double sweeps_a_digit(double rate) { return -std::log(10.0) / std::log(rate); }

/// By how much one sweep shrinks the residual R_E, averaged from sweep `first` to sweep `last`.
inline double measured_rate(const SolverMaker<double>& make, VelocityProblem<double> problem, int first,
                            int last) {
  SweepRecorder<double> recorder;
  make({.iterations = last})->solve(problem, &recorder);
  const double before = recorder.sweeps()[first].residual_energy;
  const double after = recorder.sweeps()[last].residual_energy;
  return std::pow(after / before, 1.0 / (last - first));
}

}  // namespace cairn::cases
