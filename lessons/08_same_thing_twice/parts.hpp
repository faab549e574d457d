// Lesson 08. What it prints, checks and draws.
#pragma once

#include "lessons/kit/lesson.hpp"
#include "math/list.hpp"
#include "twice.hpp"

namespace cairn::twice {

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

}  // namespace cairn::twice
