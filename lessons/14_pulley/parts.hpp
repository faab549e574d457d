// Lesson 14. What it prints, checks and draws.
#pragma once

#include <string>

#include "falls.hpp"
#include "lessons/lesson.hpp"
#include "math/list.hpp"

namespace cairn::pulley {

PulleySettings settings_of(const Lesson& lesson);

void print_scene(Lesson& lesson, const PulleySettings& settings);
/// The masses that weigh more than the rope pulls, with both.
std::string what_goes_down(const PulleySettings& settings);
void print_runs(Lesson& lesson, const PulleyRuns& all);
void check_runs(Lesson& lesson, const PulleyRuns& all);
/// Virtual calls of sweeps over a rope and many contacts, counted and checked.
void report_calls(Lesson& lesson, const PulleySettings& settings);
CsvTable steps_table(const PulleyRuns& all);

/// The row and its numbers, then every step of the fall.
List<Shot> pulley_shots(const PulleyRuns& all);

}  // namespace cairn::pulley
