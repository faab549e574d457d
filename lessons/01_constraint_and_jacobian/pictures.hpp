// The frames of lesson 01: where, which way, how fast, and how strong.
#pragma once

#include <memory>
#include <vector>

#include "lessons/lesson.hpp"
#include "rod.hpp"

namespace cairn::one_row {

struct Story {
  Rod rod = {};
  std::vector<KindOfRows> kinds = {};
};

/// What is drawn of the rod besides the box.
struct RodLook {
  Pose<double> pose = {};                     // of the box
  bool ghost = false;                         // the box as the scene has it, as an outline
  bool circles = false;                       // level curves of c
  bool direction = false;                     // j: an arrow and an arc
  bool force = false;                         // j^T lambda: an arrow and an arc
  std::optional<Vec3<double>> velocity = {};  // arrows at the centre and at the anchor
};

/// The pivot, the rod and the box, in a panel.
void draw_rod(render::Page& page, const render::Rect& rect, const Rod& rod, const RodLook& look);

std::vector<Shot> rod_shots(const Rod& rod, const std::vector<KindOfRows>& kinds);

}  // namespace cairn::one_row
