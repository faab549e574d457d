// The frames of lesson 02: the peg at three places, and the mass that it feels at all.
#pragma once

#include <memory>
#include <vector>

#include "lessons/lesson.hpp"
#include "peg.hpp"

namespace cairn::felt_mass {

/// The box on its peg.
struct PegLook {
  bool push = false;        // the impulse as an arrow
  bool after = false;       // the velocities after it, and where they lead
  bool masses = false;      // bars under the underside: what is felt there
  bool directions = false;  // the curve of what is felt in all directions
};

/// The box, the peg and arrows, in a panel.
void draw_push(render::Page& page, const render::Rect& rect, const Pushes& all, const Push& push,
               const PegLook& look);

std::vector<Shot> peg_shots(const Pushes& all);

}  // namespace cairn::felt_mass
