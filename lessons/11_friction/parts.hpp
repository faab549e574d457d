// Lesson 11. What it prints, checks and draws.
#pragma once

#include <memory>
#include <string>

#include "lessons/kit/lesson.hpp"
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
List<Shot> pictures(const Study& study);

// The parts that pictures() puts together.

/// The slide in two engines, four slopes, and the acceleration over the angle.
List<Shot> slide_shots(const SharedStudy& study);

}  // namespace cairn::friction
