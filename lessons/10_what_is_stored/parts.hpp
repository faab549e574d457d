// Lesson 10. What it prints, checks and draws.
#pragma once

#include <memory>

#include "lessons/kit/lesson.hpp"
#include "math/list.hpp"
#include "stored.hpp"

namespace cairn::stored {

void tell_scene(Lesson& lesson, const StoredRun& run);
void tell_counts(Lesson& lesson, const StoredRun& run);
void tell_kept(Lesson& lesson, const StoredRun& run);
void tell_cases(Lesson& lesson, const StoredRun& run);
/// What A costs before the first sweep, and what a sweep reads.
void tell_building(Lesson& lesson, const StoredRun& run);
void check_building(Lesson& lesson, const StoredRun& run);
void check_claims(Lesson& lesson, const StoredRun& run);
CsvTable table_of(const StoredRun& run);

/// Which rows meet, the pattern of A, pairs on which (30) errs, and what it all costs.
List<Shot> stored_shots(const StoredRun& run);

using Run = std::shared_ptr<const StoredRun>;

/// Their parts: pairs of rows for which (30) and A disagree, and charts.
List<Shot> case_shots(const Run& run);
List<Shot> cost_shots(const Run& run);

/// A panel with the pattern of A as large as `rect` allows. Returns the square.
render::Rect draw_pattern(render::Page& page, const render::Rect& rect, const Count& count,
                          const VelocityProblem<double>& problem);

}  // namespace cairn::stored
