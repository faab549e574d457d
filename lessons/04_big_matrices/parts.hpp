// Lesson 04. What it prints, checks and draws.
#pragma once

#include <memory>
#include <string>

#include "lessons/kit/lesson.hpp"
#include "math/list.hpp"
#include "render/matrix.hpp"
#include "system.hpp"

namespace cairn::big {

void print_scene(Lesson& lesson, const StackRun& run);
void print_matrices(Lesson& lesson, const StackRun& run);
void print_right_side(Lesson& lesson, const StackRun& run);
void print_solution(Lesson& lesson, const StackRun& run);
void print_growth(Lesson& lesson, const StackRun& run);
void check_matrices(Lesson& lesson, const StackRun& run);
void check_solution(Lesson& lesson, const StackRun& run);
CsvTable entries_table(const StackRun& run);

/// Without a minus in front of what rounding left of a zero.
double cleaned(double value);

/// The matrices entry by entry, the elimination, and what comes of lambda.
List<Shot> stack_shots(const StackRun& run);

using Run = std::shared_ptr<const StackRun>;

/// Their parts: how A and b are built, and how they are solved.
List<Shot> building_shots(const Run& run);
List<Shot> solving_shots(const Run& run);

/// What of the stack is shown beside the matrices.
struct StackView {
  int contact = -1;               // whose two bodies are lit; from 0
  int row = -1, other_row = -1;   // whose boxes have a bracket left and right; from 0
  int known = 0;                  // so many pushes are shown, from the uppermost contact down
  bool asks = false;              // "b_1 = ?" beside each contact
  Eigen::VectorXd velocity = {};  // three numbers a box; nothing: no velocities
};
void draw_stack(render::Page& page, const render::Rect& rect, const StackRun& run, const StackView& view);

/// Matrices side by side, between them the signs that make an equation of them; all cells of one size.
void draw_product(render::Page& page, const render::Rect& rect, const List<render::MatrixView>& factors,
                  const List<std::string>& signs);
/// A λ = b at a stage of the elimination, with the row that is at work.
List<render::MatrixView> system_views(const StackRun& run, const Eigen::MatrixXd& stage, int active);

/// "1_{x}", "1_{y}", ... for the columns of J.
List<std::string> column_names(int boxes);
/// "1", "2", ...
List<std::string> row_names(int rows);
/// A count with a space between its thousands: "90 000".
std::string in_thousands(double count);
/// Negative numbers, as behind an operator.
std::string in_brackets(const std::string& number);
/// As many decimals as it needs, up to three.
std::string brief(double value);

}  // namespace cairn::big
