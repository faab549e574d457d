// The frames of lesson 05: the stack row by row, the rod in the plane of its two lambda, and the intervals.
#pragma once

#include <memory>
#include <vector>

#include "lessons/lesson.hpp"
#include "render/page.hpp"
#include "sweep.hpp"

namespace cairn::sweeps {

using Run = std::shared_ptr<const SweepRun>;

std::vector<Shot> sweep_shots(const SweepRun& run);

/// Their parts: the stack, and the rod between the question and the answer.
std::vector<Shot> stack_shots(const Run& run);
std::vector<Shot> rod_shots(const Run& run);
/// The rod on its supports with the question, and with the answer.
Shot question_shot(const Run& run);
Shot answer_shot(const Run& run);

/// (28) with the numbers of one update, and what became of it.
render::Equation equation_28(const render::Page& page, const SystemMatrices<double>& system,
                             const Swept& swept, std::size_t update);
/// As many decimals as it needs, up to `most`.
std::string brief(double value, int most = 3);

}  // namespace cairn::sweeps
