// Lesson 18. A tower of boxes, one cold step: how wrong several solvers are after each sweep, and what a
// sweep costs.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::cost {

inline constexpr double gravity = 10;         // [m/s^2]
inline constexpr double time_step = 0.02;     // [s]
inline constexpr double least_error = 1e-12;  // below it a curve ends
inline constexpr int kept_sweeps = 200;       // of which all lambda are kept
inline constexpr FixedList<int, 4> tower_sizes = {3, 5, 10, 20};

struct CostSettings {
  int boxes = 10;
  double omega = 0;  // of SOR; 0: the best
};

/// One solver on the tower. Index: the sweep; 0 is before the first. Errors are max |lambda - exact| over the
/// largest exact lambda.
struct Curve {
  std::string name = {};
  double work = 0;                 // products of one sweep over A: 3n − 2 entries, and one for each share
  double rate = 0;                 // what a sweep leaves of the error in the end; 0: no formula
  List<double> error = {};         // until least_error
  List<List<double>> lambda = {};  // [N] of the first kept_sweeps
  List<double> by_hand = {};       // the same errors by plain loops, of the first kept_sweeps
};

/// In the order of CostRun::curves. The first three are watched sweep by sweep.
enum : int { si_curve, jacobi_curve, sor_curve, accelerated_curve };
inline constexpr int watched_curves = 3;

/// Sweeps of one tower size until no load is wrong by more than 1 %.
struct SizeCost {
  int boxes = 0;
  int si = 0;
  int sor = 0;      // with its best omega
  int by_hand = 0;  // as si
};

struct CostRun {
  CostSettings settings = {};
  double omega = 1;       // of SOR
  double best_omega = 1;  // by formula
  List<Curve> curves = {};
  Curve pgs = {};  // without end at least_error
  List<SizeCost> sizes = {};
  std::ptrdiff_t non_zeros = 0;  // of A
  Snapshot tower = {};
};

/// The largest error of any load, over the largest load.
double error_of(const List<double>& lambda, const List<double>& exact);

/// One cold step of the tower under a solver, which is watched after each sweep until the error is `least`.
template <typename Real>
void watch(Solver<Real>& solver, int boxes, double least, Curve& curve);

/// SI and SOR on a tower of that size, in at most so many sweeps.
SizeCost sweeps_to_one_percent(int boxes);
int most_sweeps(int boxes);

/// The rest of a run that has its curves: those of PGS, the entries of A, and the tower to draw.
void look_closer(CostRun& run);

/// (n - i) g [N]: what each box has to be given, from the ground up.
List<double> exact_lambda(int boxes);

/// The first sweep after which the error is at most this; -1: none.
int sweeps_to(const List<double>& errors, double error);
/// Sweeps for one more digit in the end: ln 10 / -ln(rate).
double sweeps_per_digit(const Curve& curve);

/// cos(pi / 2n): what plain Jacobi keeps; its square: Gauss-Seidel (D. M. Young, 1954).
double jacobi_rate(int boxes);
double best_relaxation(int boxes);
/// Of SOR with this omega, by Young's formula, and as the largest eigenvalue of its matrix.
double sor_rate(int boxes, double omega);
double sor_rate_by_matrix(int boxes, double omega);

/// 1/2 e^T A e dt^2 of e = lambda - exact [J]: the kinetic energy of what velocities are wrong by. Every row
/// update makes it smaller.
double error_energy(const List<double>& lambda);

/// What is left of SI where all is known beforehand: which bodies, which direction, which masses. One line
/// for this kind of row, and nothing to look up. The impulses after so many sweeps [N s].
List<double> tower_only(int boxes, int sweeps);

void check_tower(Lesson& lesson, int boxes);

VelocityProblem<double> tower_problem(int boxes);

// What is printed, checked and drawn.

/// Prints errors, sweeps and the answer, and checks every claim.
void report(Lesson& lesson, const CostRun& run);

CsvTable errors_table(const CostRun& run);

/// The tower's loads sweep by sweep, and errors against sweeps and work.
List<Shot> cost_shots(const CostRun& run);

/// Errors against sweeps, and against products.
Shot work_shot(const CostRun& run);

/// In the order of CostRun::curves: SI, Jacobi, SOR, momentum.
SeriesStyle style_of(const Page& page, int curve);
std::string short_name(const CostRun& run, int curve);

}  // namespace cairn::cost
