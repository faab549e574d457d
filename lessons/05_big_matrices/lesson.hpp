// Lesson 05. A stack of boxes as one system of equations: built, solved and checked as section 2 of the paper
// says.
#pragma once

#include <Eigen/Core>

#include "lessons/kit/kit.hpp"

namespace cairn::big {

inline constexpr double gravity = 10;      // [m/s^2]
inline constexpr double heavy_mass = 100;  // [kg] of the uppermost box in the question

struct StackSettings {
  int boxes = 3;
  double dt = 0.02;  // [s]
  double top = 1;    // [kg] mass of the uppermost box; all others have 1 kg
};

/// Everything without the ground, which has zeros in M^-1. Three columns a box.
struct StackSystem {
  Eigen::MatrixXd J = {};             // (6)
  Eigen::VectorXd inverse_mass = {};  // the diagonal of (2)
  Eigen::MatrixXd A = {};             // (15) [1/kg]
  Eigen::VectorXd b = {};             // (15) [m/s^2]
  Eigen::VectorXd velocity = {};      // v_1
  Eigen::VectorXd zeta = {};          // (7) [m/s]
  double dt = 0;                      // [s]
};

struct StackRun {
  StackSettings settings = {};
  List<double> mass = {};  // [kg] of each box, from the ground up
  StackSystem system = {};
  Eigen::VectorXd lambda = {};            // [N]
  Eigen::VectorXd velocity = {};          // v_2 (12)
  Eigen::MatrixXd inverse = {};           // of A [kg]
  Eigen::VectorXd eigenvalues = {};       // of A, ascending [1/kg]
  Eigen::VectorXd reference = {};         // [N] of the library's exact solver, on rows of six numbers
  Eigen::VectorXd row_velocity = {};      // j v_1 of each row by its own six numbers
  Eigen::VectorXd lambda_without = {};    // [N] had gravity not been in v_1
  Eigen::VectorXd velocity_without = {};  // v_2 with that, and gravity added after
  double library_gap = 0;                 // between system and the library's A and b; the largest
  Snapshot snapshot = {};                 // for drawing

  int boxes() const { return settings.boxes; }
};

/// Boxes of 1 m, one normal row for each contact, that have fallen for a step under this gravity [m/s²].
VelocityProblem<double> stack_rows(const StackSettings& settings, double pull);
/// All rows in one system.
StackSystem assemble(const VelocityProblem<double>& problem);
/// Lambda [N] of A lambda = b.
Eigen::VectorXd solution_of(const StackSystem& system);
/// v_2 (12).
Eigen::VectorXd velocity_after(const StackSystem& system, const Eigen::VectorXd& lambda);
/// Everything else in `run`, for comparison.
void solve_otherwise(const VelocityProblem<double>& problem, StackRun& run);

/// [kg] that contact i (from 0) carries: box i + 1 and all above.
double mass_above(const StackRun& run, int contact);
/// lambda_i = g times that [N].
double lambda_by_formula(const StackRun& run, int contact);
/// A_ij from the masses alone [1/kg].
double entry_by_formula(const StackRun& run, int i, int j);
/// How many numbers of b are not the same.
int changed_numbers(const StackRun& run, const StackRun& other);

// What is printed, checked and drawn.

void print_scene(Lesson& lesson, const StackRun& run);
void print_matrices(Lesson& lesson, const StackRun& run);
void print_right_side(Lesson& lesson, const StackRun& run, const StackRun& heavy);
void print_solution(Lesson& lesson, const StackRun& run);
void check_matrices(Lesson& lesson, const StackRun& run);
void check_solution(Lesson& lesson, const StackRun& run);
/// What the heavy box on top changes.
void check_question(Lesson& lesson, const StackRun& run, const StackRun& heavy);
CsvTable entries_table(const StackRun& run);

/// The matrices entry by entry, and what comes of lambda.
List<Shot> stack_shots(const StackRun& run, const StackRun& heavy);

/// Their part: how A and b are built.
List<Shot> building_shots(const StackRun& run);

/// What of the stack is shown beside the matrices.
struct StackView {
  int contact = -1;               // whose two bodies are lit; from 0
  int row = -1, other_row = -1;   // whose boxes have a bracket left and right; from 0
  bool pushes = false;            // as arrows
  bool asked = false;             // a question mark for b of each contact
  bool masses = false;            // of each box
  Eigen::VectorXd velocity = {};  // three numbers a box; nothing: no velocities
};
void draw_stack(Page& page, const Rect& rect, const StackRun& run, const StackView& view);

/// Matrices side by side, between them the signs that make an equation of them; all cells of one size.
void draw_product(Page& page, const Rect& rect, const List<MatrixView>& factors,
                  const List<std::string>& signs);
/// A λ = b, with the row that is at work.
List<MatrixView> system_views(const StackRun& run, int active);

/// "1_{x}", "1_{y}", ... for the columns of J.
List<std::string> column_names(int boxes);
/// "1", "2", ...
List<std::string> row_names(int rows);

}  // namespace cairn::big
