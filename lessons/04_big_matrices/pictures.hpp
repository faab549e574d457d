// The frames of lesson 04: the matrices entry by entry, the elimination, and what comes of lambda.
#pragma once

#include <string>
#include <vector>

#include "lessons/lesson.hpp"
#include "render/page.hpp"
#include "system.hpp"

namespace cairn::big {

std::vector<Shot> stack_shots(const StackRun& run);

/// Their parts: how A and b are built, and how they are solved.
std::vector<Shot> building_shots(const StackRun& run);
std::vector<Shot> solving_shots(const StackRun& run);

/// What of the stack is shown beside the matrices.
struct StackView {
  int contact = -1;               // whose two bodies are lit; from 0
  int box = 0;                    // instead: one body that is lit; from 1
  int known = 0;                  // so many pushes are shown, from the uppermost contact down
  Eigen::VectorXd velocity = {};  // three numbers a box; nothing: no velocities
};
void draw_stack(render::Page& page, const render::Rect& rect, const StackRun& run, const StackView& view);

/// "1_{x}", "1_{y}", ... for the columns of J.
std::vector<std::string> column_names(int boxes);
/// "1", "2", ...
std::vector<std::string> row_names(int rows);
/// Negative numbers, as behind an operator.
std::string in_brackets(const std::string& number);
/// As many decimals as it needs, up to three.
std::string brief(double value);

}  // namespace cairn::big
