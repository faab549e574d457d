// What `lessons legend` says of curves, held against the table that pictures take their looks from.
#include <doctest/doctest.h>

#include <map>
#include <sstream>
#include <string>

#include "child_lesson.hpp"
#include <cairn/math/list.hpp>
#include "render/solver_style.hpp"

using namespace cairn;
using namespace cairn::render;
using cairn::testing::run_program;

namespace {

/// The lines of the part on curves: looks, and whose they are.
List<std::pair<std::string, std::string>> curves_of_legend() {
  std::istringstream lines(run_program("lessons", {"legend"}).out);
  List<std::pair<std::string, std::string>> curves;
  bool is_curve = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] != ' ') is_curve = line.rfind("Curves", 0) == 0;
    if (!is_curve) continue;
    const std::string look = line.substr(12, line.find("  ", 12) - 12);
    const std::size_t name = line.find_first_not_of(' ', 12 + look.size());
    curves.push_back({look, line.substr(name)});
  }
  return curves;
}

bool same(Color a, Color b) { return a.r == b.r && a.g == b.g && a.b == b.b; }

}  // namespace

TEST_CASE("the legend says of each solver what pictures show of it") {
  const Theme theme = light_theme();
  const std::map<std::string, Color> colors = {{"blue", theme.pgs.color},
                                               {"ochre", theme.si.color},
                                               {"plum", theme.jacobi.color},
                                               {"green", theme.box2d.color},
                                               {"text colour", theme.text}};
  const std::map<std::string, List<double>> dashes = {{"solid", {}},
                                                      {"dotted", {2, 5}},
                                                      {"dashed", {10, 6}},
                                                      {"long dashes", {14, 6}},
                                                      {"dash-dot", {12, 5, 2, 5}},
                                                      {"dash-dot-dot", {12, 5, 2, 5, 2, 5}}};
  const std::map<std::string, Marker> markers = {{"circle", Marker::circle},
                                                 {"square", Marker::square},
                                                 {"triangle", Marker::triangle},
                                                 {"diamond", Marker::diamond}};
  const std::map<std::string, std::string> names = {{"PGS (projected Gauss-Seidel)", "pgs"},
                                                    {"accelerated: PGS with momentum", "accelerated"},
                                                    {"SI (sequential impulses)", "si"},
                                                    {"block; of its points: block-contact", "block"},
                                                    {"wide", "wide"},
                                                    {"SOR", "sor"},
                                                    {"Jacobi", "jacobi"},
                                                    {"damped Jacobi", "jacobi-damped"},
                                                    {"split Jacobi", "jacobi-split"},
                                                    {"Box2D", "box2d"},
                                                    {"newton", "newton"}};
  int solvers = 0;
  for (const auto& [look, whose] : curves_of_legend()) {
    if (names.count(whose) == 0) continue;
    ++solvers;
    CAPTURE(whose);
    const SeriesStyle style = style_of_solver(theme, names.at(whose));
    const std::size_t first = look.find(", "), second = look.find(", ", first + 2);
    CHECK(same(style.color, colors.at(look.substr(0, first))));
    CHECK(style.dash == dashes.at(look.substr(first + 2, second - first - 2)));
    CHECK(style.marker == markers.at(look.substr(second + 2)));
  }
  CHECK(solvers == static_cast<int>(names.size()));
}
