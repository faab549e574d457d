// The one table of looks.
#include "render/solver_style.hpp"

namespace cairn::render {

namespace {

const List<double> long_dash = {14, 6};
const List<double> dots = {2, 5};
const List<double> dash_dot = {12, 5, 2, 5};
const List<double> dash_dot_dot = {12, 5, 2, 5, 2, 5};

}  // namespace

SeriesStyle style_of_solver(const Theme& theme, std::string_view solver) {
  if (solver == "si") return theme.si;
  if (solver == "sor") return {theme.si.color, {}, Marker::triangle};
  if (solver == "block" || solver == "block-contact") return {theme.si.color, dash_dot, Marker::diamond};
  if (solver == "wide") return {theme.si.color, dots, Marker::circle};
  if (solver == "accelerated" || solver == "wide-accelerated")
    return {theme.pgs.color, dots, Marker::triangle};
  if (solver == "box2d") return theme.box2d;
  if (solver == "jacobi-split") return {theme.jacobi.color, {}, Marker::triangle};
  if (solver == "jacobi-damped") return {theme.jacobi.color, long_dash, Marker::square};
  if (solver.ends_with("jacobi")) return theme.jacobi;
  if (solver.starts_with("pgs")) return theme.pgs;
  return {theme.text, dash_dot_dot, Marker::square};
}

List<SeriesStyle> neutral_styles(const Theme& theme) {
  return {{theme.text, {}, Marker::circle},
          {theme.secondary_text, long_dash, Marker::square},
          {theme.text, dots, Marker::triangle},
          {theme.secondary_text, dash_dot, Marker::diamond}};
}

}  // namespace cairn::render
