// Lesson 01. What it prints, checks and draws.
#pragma once

#include <optional>

#include "lessons/kit/lesson.hpp"
#include "math/list.hpp"
#include "rod.hpp"

namespace cairn::one_row {

void print_scene(Lesson& lesson, const Rod& rod);
void print_derivative(Lesson& lesson, const Rod& rod);
void print_motions(Lesson& lesson, const Rod& rod);
void print_kinds(Lesson& lesson, const List<KindOfRows>& kinds);
void check_derivative(Lesson& lesson, const Rod& rod, const List<KindOfRows>& kinds);
void check_force(Lesson& lesson, const Rod& rod);
CsvTable quotients_table(const Rod& rod);

/// Where, which way, how fast, and how strong.
List<Shot> rod_shots(const Rod& rod, const List<KindOfRows>& kinds);

/// What is drawn of the rod besides the box.
struct RodLook {
  Pose<double> pose = {};                     // of the box
  bool close = false;                         // only the box and its surroundings
  List<Pose<double>> others = {};             // outlines of the box elsewhere
  bool errors = false;                        // c of the box and of the others, as lengths
  bool circles = false;                       // level curves of c
  bool direction = false;                     // j: an arrow and an arc
  bool force = false;                         // j^T lambda: an arrow and an arc
  bool asked = false;                         // the three velocities of the question, at the centre
  bool answered = false;                      // the same of the anchor
  std::optional<Vec3<double>> velocity = {};  // arrows at the centre and at the anchor
};

/// The pivot, the rod and the box, in a panel.
void draw_rod(render::Page& page, const render::Rect& rect, const Rod& rod, const RodLook& look);

}  // namespace cairn::one_row
