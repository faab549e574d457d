// Lesson 07. A random problem, solved by both solvers and watched row by row, in three precisions.
#pragma once

#include <cstdint>

#include "lessons/kit/kit.hpp"

namespace cairn::twice {

struct TwiceSettings {
  int bodies = 8;
  int rows = 20;
  int sweeps = 50;
  double dt = 0.02;  // [s]
  std::uint64_t seed = 1;
};

/// One row update of the first sweep, computed three ways, before clamping [N].
struct RowStep {
  int row = 0;              // from 0
  double eta = 0;           // of this row, before
  double row_velocity = 0;  // j v of SI, before [m/s]
  double by_27 = 0;         // eta + (zeta - j v) / (j M^-1 j^T dt), from the velocities of SI
  double by_28 = 0;         // (b_i - sum A_ij eta_j) / A_ii, from A, b and the eta of PGS
  double by_29 = 0;         // (-A_i . eta + A_ii eta_i) / A_ii + b_i / A_ii: the step between the two
  double pgs = 0;           // lambda of PGS afterwards, clamped
  double si = 0;            // lambda of SI afterwards, clamped
};

/// Both solvers in one precision: their lambda [N] after every sweep, sweep 0 being the start.
struct PrecisionRun {
  std::string name = {};
  double epsilon = 0;            // the spacing of numbers near 1
  List<double> difference = {};  // max |lambda_PGS - lambda_SI| after each sweep [N]
  double scale = 0;              // max |lambda| of all sweeps [N]
  int row = 0;                   // from 0, the one in which they differ most in the end
  std::string pgs = {};          // its lambda [N] of PGS with all digits that this precision has
  std::string si = {};           // and of SI
  /// In how many decimal digits of the largest lambda they agree in the end.
  double digits() const { return -std::log10(difference.back() / scale); }
};

struct TwiceRun {
  TwiceSettings settings = {};
  VelocityProblem<double> problem = {};
  SystemMatrices<double> system = {};
  List<RowStep> steps = {};       // of the first sweep
  List<PerRow<double>> pgs = {};  // lambda [N] after each sweep, double
  List<PerRow<double>> si = {};
  List<PrecisionRun> precisions = {};  // float, double, long double
  PrecisionRun warm = {};              // double again, starting from the answer
  double identity_error = 0;  // max |v - (v0 + M^-1 J^T eta dt)| over all row updates of SI [m/s], (26)
  int at_bound = 0;           // rows that end at lambda = 0
  double pgs_off = 0;         // [%] largest error of any lambda after asked_sweeps, of the largest lambda
  double si_off = 0;
  List<double> backwards = {};  // [N] largest difference to SI of PGS from the last row to the first,
                                // after 1, 10, 100 ... sweeps of both
  PerRow<double> exact = {};    // where both end, lambda [N]
};

inline constexpr int asked_sweeps = 10;  // that the question is about

/// A number with as many significant digits; minus sign U+2212.
std::string all_digits(long double value, int digits);

/// Everything but `steps`.
TwiceRun solve_with_the_library(const TwiceSettings& settings);

/// How far two exact accounts of Gauss-Seidel may part by rounding after k sweeps, relative to the largest
/// lambda. An update of one row commits some three roundings of that size (a sum of 20 products, or j v and
/// two velocities), a sweep has 20 of them, and sweeps do not amplify what came before: 64 epsilon a sweep.
double rounding_bound(const PrecisionRun& run, int sweeps);

// What is printed, checked and drawn.

void tell_scene(Lesson& lesson, const TwiceSettings& settings);
void tell_first_sweep(Lesson& lesson, const TwiceRun& run);
void tell_precisions(Lesson& lesson, const TwiceRun& run);
/// (24) and (25), in the sweeps of the library's SI.
void check_eta(Lesson& lesson, const TwiceRun& run);
/// Effective masses computed once or in each update: how many, and the same λ.
void check_masses(Lesson& lesson, const TwiceRun& run);
void check_claims(Lesson& lesson, const TwiceRun& run);
CsvTable table_of(const TwiceRun& run);

/// A frame for each row update of the first sweep, then one for each sweep.
List<Shot> twice_shots(const TwiceRun& run);

// What the pictures of lesson 07 are made of.

/// Lambda of both solvers at one moment [N].
struct Moment {
  PerRow<double> pgs = {};
  PerRow<double> si = {};  // empty: not shown
  int active = -1;
  PerRow<double> unclamped = {};  // what each row asked for; empty: not known
  PerRow<double> exact = {};      // a tick on each pair
};

/// From the least to the largest lambda [N] of all moments, clamped or not.
struct Range {
  double low = 0;
  double high = 0;
};

Range range_of(const TwiceRun& run);

/// Two bars for every row, side by side: they never part.
void draw_pairs(Page& page, const Rect& rect, const std::string& title, const Moment& moment,
                const Range& range);

/// A as colours, with one row framed.
void draw_system(Page& page, const Rect& rect, const TwiceRun& run, int active);

/// The bodies in a ring and the rows between them: one row lit with its two bodies, and strong those that it
/// shares a body with.
void draw_bodies(Page& page, const Rect& rect, const TwiceRun& run, int active);

/// A number with its name, in a column of numbers.
struct Digits {
  std::string name = {};
  std::string digits = {};
};

/// Numbers below each other: grey as far as all agree, lit from the first digit on that differs.
void draw_digits(Page& page, const Rect& rect, const std::string& title, const List<Digits>& lines,
                 const std::string& below);

}  // namespace cairn::twice
