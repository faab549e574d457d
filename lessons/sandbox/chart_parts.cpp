// What charts have in common: the looks and names of solvers, panels, notes.
#include "lessons/sandbox/charts.hpp"

#include <cmath>

#include "render/solver_style.hpp"
#include "render/text_layout.hpp"

namespace cairn::sandbox {

List<render::SeriesStyle> solver_styles(const List<std::string>& solvers, const render::Theme& theme) {
  List<render::SeriesStyle> styles;
  for (const std::string& solver : solvers) styles.push_back(render::style_of_solver(theme, solver));
  return styles;
}

std::string solver_label(const std::string& solver) {
  if (solver == "si") return "SI";
  if (solver == "box2d") return "Box2D";
  return solver.rfind("pgs", 0) == 0 ? "PGS" + solver.substr(3) : solver;
}

std::string unmarked(const std::string& text) {
  std::string plain;
  for (const char c : text) plain += c == '_' ? std::string("\\_") : std::string(1, c);
  return plain;
}

render::Rect place_note(render::Page& page, const std::string& note) {
  const render::Rect area = page.area();
  if (note.empty()) return area;
  const double size = page.secondary().size;
  const int lines = render::wrapped(page.canvas(), note, area.width, page.secondary()).size();
  const double height = (render::leading * (static_cast<double>(lines) - 1) + 1.8) * size;
  page.paragraph({area.x, area.y + area.height - height + 1.5 * size}, area.width, note, page.secondary());
  return {area.x, area.y, area.width, area.height - height};
}

render::TextStyle small_style(const render::Page& page, render::Align align) {
  return {.size = 13, .color = page.theme().secondary_text, .align = align};
}

render::TextStyle name_style(const render::Page& page, double size) {
  return {.size = size, .color = page.theme().text, .bold = true};
}

void frame_panel(render::Page& page, const render::Rect& rect) {
  const render::Rect frame = {std::floor(rect.x) + 0.5, std::floor(rect.y) + 0.5, std::floor(rect.width) - 1,
                              std::floor(rect.height) - 1};
  page.canvas().rect(frame,
                     {.fill = page.theme().panel, .outline = page.theme().frame_line, .outline_width = 1});
}

}  // namespace cairn::sandbox
