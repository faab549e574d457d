// Lesson 11. What it prints, checks and draws.
#pragma once

#include <memory>
#include <string>

#include "lessons/lesson.hpp"
#include "math/list.hpp"
#include "study.hpp"

namespace cairn::friction {

StudySettings settings_of(const Lesson& lesson);

void tell_scene(Lesson& lesson, const Study& study);
/// Needed, limit and verdict for one block.
void tell_law(Lesson& lesson, const Slide& slide);
/// The first step of the slippery block: how the bounds of the tangent rows move with the normal rows.
void tell_sweeps(Lesson& lesson, const Study& study);
/// Speeds, and the angles above which blocks slide.
void tell_run(Lesson& lesson, const Study& study);
void check_study(Lesson& lesson, const Study& study);
CsvTable table_of(const Study& study);

using SharedStudy = std::shared_ptr<const Study>;

/// All frames, from the question to the answer.
List<Shot> pictures(const Study& study, const std::string& question);

// The parts that pictures() puts together.

Shot question_shot(const SharedStudy& study, const std::string& question);
/// The block at rest, or about to slide: needed and limit.
Shot force_shot(const SharedStudy& study, const Slide& slide);
/// The first step, sweep by sweep: bounds that move.
Shot sweep_shot(const SharedStudy& study);
Shot answer_shot(const SharedStudy& study, const std::string& question);

}  // namespace cairn::friction
