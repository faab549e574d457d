// Lesson 10. Pyramids, and what solvers keep of them.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::stored {

struct StoredSettings {
  int base = 20;         // boxes in the lowest row of the largest pyramid
  double spacing = 1.1;  // [m] between centres of a row; boxes of 1 m
  int sweeps = 10;       // of each solver, where their answers are compared
};

/// Numbers (of 8 bytes) that one problem needs, by what is stored.
struct Count {
  std::string name = {};  // "base 10"
  int base = 0;           // 0: not a pyramid
  int bodies = 0;         // without the ground
  double rows = 0;        // m
  double dense = 0;       // m^2
  double printed = 0;     // eq. (30) as it is printed
  double non_zeros = 0;   // J_i M^-1 J_j^T != 0
  double pairs = 0;       // rows that share a body that can move: what a sparse A has room for
};

/// Multiply-adds of one sweep.
struct Work {
  double naive = 0;   // every velocity anew for each row: 6 m^2
  double dense = 0;   // a row of A for each row: m^2
  double sparse = 0;  // only what is not zero
  double si = 0;      // 6 to read a row's velocity, 12 to change it
};
/// Products of one row update of SI: for j·v, for M⁻¹jᵀ, and for that times the impulse; the second falls
/// away if M⁻¹jᵀ is kept.
inline constexpr double si_products = 18;
inline constexpr double si_products_kept = 12;
Work work_of(const Count& count);

/// What a solver has kept beside the problem, by its own account [bytes], and its answer.
struct Kept {
  std::string name = {};
  double bytes = 0;
  PerRow<double> impulse = {};  // [N s]
};

struct StoredRun {
  StoredSettings settings = {};
  List<Count> pyramids = {};                    // of base 3, 5, 10 and the one asked for
  List<VelocityProblem<double>> problems = {};  // of these
  List<Snapshot> snapshots = {};
  List<Kept> kept = {};  // for the largest: SI, factored, sparse and dense PGS
  Count tray = {};       // boxes that all stand on one body
  VelocityProblem<double> tray_problem = {};
  Snapshot tray_snapshot = {};
};

/// A pyramid without friction, gravity just applied.
Scene pyramid_scene(int base, double spacing);
/// `boxes` of them on one tray that can move.
Scene tray_scene(int boxes);

/// As many rows as the pyramid of base 10 has, but for the two below the tray.
inline constexpr int boxes_on_tray = 99;
/// How a scene begins, with the contacts that it has after a step.
Snapshot with_contacts(const Scene& scene);

/// By counting boxes: two rows for each overlap, 4 of them on the sides of most boxes.
double rows_by_formula(int base);
/// Sum over bodies of (rows on the body)^2, less those pairs that were counted on two bodies.
double pairs_by_formula(int base);
/// Entries of a matrix that are not zero but for rounding: 1e-12 of its largest.
double count_entries(const Eigen::MatrixXd& matrix);

/// For every pair of rows: whether it is in A.
List<List<char>> pattern(const VelocityProblem<double>& problem);

/// "312.5 KiB"
std::string bytes_text(double bytes);

// What is printed, checked and drawn.

void tell_scene(Lesson& lesson, const StoredRun& run);
void tell_counts(Lesson& lesson, const StoredRun& run);
void tell_kept(Lesson& lesson, const StoredRun& run);
/// What A costs before the first sweep, and what a sweep reads.
void tell_building(Lesson& lesson, const StoredRun& run);
void check_building(Lesson& lesson, const StoredRun& run);
void check_claims(Lesson& lesson, const StoredRun& run);
CsvTable table_of(const StoredRun& run);

/// Which rows meet, the pattern of A, and what is kept of it.
List<Shot> stored_shots(const StoredRun& run);

/// Their last part: the memory, and the tray.
List<Shot> cost_shots(const StoredRun& run);

/// A panel with the pattern of A as large as `rect` allows. Returns the square.
Rect draw_pattern(Page& page, const Rect& rect, const Count& count, const VelocityProblem<double>& problem);

}  // namespace cairn::stored
