// Lesson 09. What it prints, checks and draws.
#pragma once

#include <memory>
#include <string>

#include "lessons/kit/lesson.hpp"
#include "math/list.hpp"
#include "render/theme.hpp"
#include "start.hpp"

namespace cairn::warm {

/// The question of the card with the numbers of these runs.
std::string question_of(const WarmStart& all);

void tell_scene(Lesson& lesson, const StartSettings& settings);
void tell_loads(Lesson& lesson, const WarmStart& all);
void tell_sweeps(Lesson& lesson, const WarmStart& all);
void tell_order(Lesson& lesson, const WarmStart& all);
void check_claims(Lesson& lesson, const WarmStart& all);
CsvTable table_of(const WarmStart& all);

using All = std::shared_ptr<const WarmStart>;

/// Three towers side by side, what the error does, and rows in another order.
List<Shot> start_shots(const WarmStart& all);

/// Their last part: charts of the error, and what becomes of impulses in the wrong place.
List<Shot> order_shots(const All& all);

/// Cold, warm, and a guess in the wrong place. All three are SI: the right ones have its colour, and only the
/// dash tells them apart; the mistake has the colour of mistakes, as in lesson 07.
FixedList<render::SeriesStyle, 3> start_styles(const render::Theme& theme);

}  // namespace cairn::warm
