// What charts have in common: the looks and names of solvers, panels, notes.
#include "lessons/sandbox/charts.hpp"

#include <cmath>

#include "render/text_layout.hpp"

namespace cairn::sandbox {
namespace {

/// That of its family.
render::SeriesStyle family_style(const std::string& solver, const render::Theme& theme) {
  if (solver == "si") return theme.si;
  if (solver == "box2d") return theme.box2d;
  if (solver.rfind("jacobi", 0) == 0) return theme.jacobi;
  if (solver.rfind("pgs", 0) == 0 || solver == "block") return theme.pgs;
  return theme.exact;
}

}  // namespace

List<render::SeriesStyle> solver_styles(const List<std::string>& solvers, const render::Theme& theme) {
  List<render::SeriesStyle> free = {theme.exact, theme.jacobi, theme.pgs, theme.si, theme.box2d};
  const auto take = [&free](const render::SeriesStyle& style) {
    const int before = free.size();
    erase_if(free, [&](const auto& other) { return other.marker == style.marker; });
    return free.size() < before;
  };
  List<render::SeriesStyle> styles;
  List<int> without;  // one of their own
  for (int i = 0; i < solvers.size(); ++i) {
    styles.push_back(family_style(solvers[i], theme));
    if (!take(styles.back())) without.push_back(i);
  }
  for (const int i : without) {
    styles[i] = free.front();
    take(styles[i]);
  }
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
