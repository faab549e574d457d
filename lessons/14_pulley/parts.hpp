// Lesson 14. What it prints, checks and draws.
#pragma once

#include <string>

#include "falls.hpp"
#include "lessons/kit/lesson.hpp"
#include "math/list.hpp"

namespace cairn::pulley {

PulleySettings settings_of(const Lesson& lesson);

void print_scene(Lesson& lesson, const PulleySettings& settings);
/// The masses that weigh more than the rope pulls, with both.
std::string what_goes_down(const PulleySettings& settings);
void print_runs(Lesson& lesson, const PulleyRuns& all);
void check_runs(Lesson& lesson, const PulleyRuns& all);

/// Virtual calls in a sweep over a rope and a tower.
struct CountedCalls {
  int constraints = 0;
  int in_one_loop = 0;   // over all constraints
  int in_two_loops = 0;  // the second over the contacts, without virtual calls
  double change = 0;     // [N s] of the impulses, against sweeps with no virtual call
};

CountedCalls count_calls(const PulleySettings& settings);
void print_calls(Lesson& lesson, const CountedCalls& counted);
void check_calls(Lesson& lesson, const CountedCalls& counted);
CsvTable steps_table(const PulleyRuns& all);

/// The row and its numbers, then every step of the fall.
List<Shot> pulley_shots(const PulleyRuns& all);

}  // namespace cairn::pulley
