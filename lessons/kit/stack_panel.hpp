// A stack of boxes in the middle of a solve: what each contact gives to both of its bodies, and how the boxes
// move.
#pragma once

#include <cairn/math/list.hpp>
#include "render/camera.hpp"
#include "render/page.hpp"
#include <cairn/world/snapshot.hpp>

namespace cairn {

/// Boxes 1, 2, ... from the ground up; contact i is below box i + 1.
struct StackMoment {
  Snapshot stack = {};          // of stack_at_rest()
  List<double> lambda = {};     // [N] of each contact
  List<double> velocity = {};   // [m/s] of each box, upwards; empty: not drawn
  List<double> earlier = {};    // [m/s] before the last row update, drawn pale where it changed
  int active = -1;              // the contact that is being visited
  double largest_lambda = 1;    // [N] that is two thirds as long as a box is high
  double largest_velocity = 1;  // [m/s] that is half as long
};

/// So many unit boxes of 1 kg on each other and the ground, and a contact below each.
Snapshot stack_at_rest(int boxes);

/// Each push is an arrow up, for the body above its contact, and an arrow down for the body below it.
/// @returns how metres of the stack become pixels.
render::Camera draw_stack_panel(render::Page& page, const render::Rect& view, const StackMoment& moment);

}  // namespace cairn
