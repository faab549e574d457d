// The card of lesson 09, and what it prints, checks and writes.
#pragma once

#include "lessons/lesson.hpp"
#include "start.hpp"

namespace cairn::warm {

LessonInfo card();

void tell_scene(Lesson& lesson, const StartSettings& settings);
void tell_loads(Lesson& lesson, const WarmStart& all);
void tell_sweeps(Lesson& lesson, const WarmStart& all);
void tell_order(Lesson& lesson, const WarmStart& all);
void check_claims(Lesson& lesson, const WarmStart& all);
CsvTable table_of(const WarmStart& all);

}  // namespace cairn::warm
