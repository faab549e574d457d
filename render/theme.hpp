// Colours, sizes and line styles: one look for every picture.
#pragma once

#include <cairn/math/list.hpp>
#include "render/canvas.hpp"

namespace cairn::render {

enum class Marker { none, circle, square, triangle, diamond, tick };

/// How one solver looks in every picture. Never colour alone: dash and marker tell it too.
struct SeriesStyle {
  Color color = {};
  List<double> dash = {};
  Marker marker = Marker::none;
};

/// Every quantity keeps its colour through all lessons. The palette was tested for contrast and under three
/// colour deficiencies (Machado et al., 2009).
struct Theme {
  Color background, panel, frame_line, grid;
  Color text, secondary_text;
  Color outline, body, active_a, active_b;  // of bodies
  Color static_body, static_hatch, sleeping;
  Color normal, friction, joint, velocity, external;  // arrows
  Color penetration, inactive;
  Color water;
  Color positive, negative;  // the two ends of a heat map of signed numbers
  SeriesStyle pgs, si, box2d, jacobi, exact;
};

Theme light_theme();
Theme dark_theme();
/// The same theme without hues, for black-and-white print: dashes, hatches and markers tell things apart.
Theme without_hues(const Theme& theme);

/// From here on bold text can be read with less contrast [px] (WCAG 2.1, 1.4.3).
inline constexpr double large_text = 18;

/// All in px, for one picture size. Text and lines do not scale with the picture.
struct Sizes {
  double title = 22, state = 18, label = 17, tick = 15, equation = 26, body_number = 30, question = 24;
  double outline = 2, active_outline = 3, arrow = 5, inactive_arrow = 3, head_length = 16, head_width = 14;
  double contact = 5, new_contact = 8, joint = 6;  // radii
  double curve = 3, marker = 5, grid = 1, axis = 1.5, hatch_pitch = 10, ghost = 1.5;
  double smallest = 12;  // no text is smaller
  double margin = 20, header = 48, footer = 28, gap = 16, padding = 16;
};

/// Large from 540 px of height, else compact; never text below 12 px.
Sizes sizes_for(int height);

}  // namespace cairn::render
