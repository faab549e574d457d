// Lesson 02. What it prints, checks and draws.
#pragma once

#include "lessons/kit/lesson.hpp"
#include "math/list.hpp"
#include "peg.hpp"

namespace cairn::one_push {

void print_scene(Lesson& lesson, const PegSettings& settings);
/// The push at the last place, for both bodies.
void print_pair(Lesson& lesson, const Pushes& all);
void print_places(Lesson& lesson, const Pushes& all);
void check_row(Lesson& lesson, const Pushes& all);
void check_motion(Lesson& lesson, const Pushes& all);
void check_others(Lesson& lesson, const Pushes& all);
CsvTable places_table(const Pushes& all);

/// The peg at three places, and the mass that it feels at all.
List<Shot> peg_shots(const Pushes& all);

/// The box on its peg.
struct PegLook {
  bool push = false;        // the impulse as an arrow
  bool asked = false;       // the impulse as a number below the peg, or a question mark
  bool after = false;       // the velocities after it, and where they lead
  bool masses = false;      // bars under the underside: the effective mass there
  bool named = false;       // where the peg is, as the title
  bool directions = false;  // the curve of the effective mass in all directions
};

/// The box, the peg and arrows, in a panel.
void draw_push(render::Page& page, const render::Rect& rect, const Pushes& all, const Push& push,
               const PegLook& look);

}  // namespace cairn::one_push
