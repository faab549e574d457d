// Lesson 05. What it prints, checks and draws.
#pragma once

#include <memory>
#include <string>

#include "lessons/kit/lesson.hpp"
#include "math/list.hpp"
#include "render/page.hpp"
#include "sweep.hpp"

namespace cairn::sweeps {

void print_scenes(Lesson& lesson, const SweepSettings& settings);
void print_stack(Lesson& lesson, const SweepRun& run);
void print_rod(Lesson& lesson, const SweepRun& run);
void print_intervals(Lesson& lesson);
void check_stack(Lesson& lesson, const SweepRun& run);
void check_rod(Lesson& lesson, const SweepRun& run);
CsvTable updates_table(const SweepRun& run);

/// The stack row by row, the rod in the plane of its two lambda, and the intervals.
List<Shot> sweep_shots(const SweepRun& run);

using Run = std::shared_ptr<const SweepRun>;

/// The rod between the question and the answer.
List<Shot> rod_shots(const Run& run);
/// The rod on its supports with the question, and with the answer.
Shot question_shot(const Run& run);
Shot answer_shot(const Run& run);

/// A and b as one matrix, with the row that is being visited framed; -1: none.
void draw_system(render::Page& page, const render::Rect& rect, const SystemMatrices<double>& system,
                 int active);
/// (28) with the numbers of one update, and what became of it.
render::Equation equation_28(const render::Page& page, const SystemMatrices<double>& system,
                             const Swept& swept, int update);
/// As many decimals as it needs, up to `most`.
std::string brief(double value, int most = 3);

}  // namespace cairn::sweeps
