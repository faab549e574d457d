// A step's matrix and how its residual falls, on one page.
#include <fmt/format.h>

#include "lessons/sandbox/step_view.hpp"
#include <cairn/math/list.hpp>
#include "render/matrix.hpp"
#include "render/plot.hpp"
#include "render/solver_style.hpp"
#include <cairn/solvers/system_matrix.hpp>

namespace cairn::sandbox {
namespace {

constexpr int most_names = 40;  // more are too small to be read

render::MatrixView matrix_view(const StepView& view) {
  render::MatrixView matrix{.title = fmt::format("A = J M⁻¹ Jᵀ (1/kg), {} rows", view.rows.size())};
  matrix.values = system_matrices(view.given).A;
  if (view.rows.size() > most_names) return matrix;
  for (int i = 0; i < view.rows.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    matrix.row_names.push_back(number);
    matrix.column_names.push_back(number);
  }
  return matrix;
}

render::Plot residual_plot(const StepView& view, const render::Theme& theme) {
  render::Plot plot{.title = "What each sweep leaves",
                    .x = {.title = "sweep"},
                    .y = {.title = "R_{E}", .scale = render::AxisScale::logarithmic}};
  render::Series series{.name = view.setting.solver,
                        .style = render::style_of_solver(theme, view.setting.solver)};
  for (const SweepRecord& sweep : view.sweeps) {
    series.x.push_back(sweep.sweep);
    series.y.push_back(sweep.residual_energy);
  }
  plot.series.push_back(series);
  return plot;
}

}  // namespace

render::Image draw_step(const StepView& view, const std::string& title, const render::Theme& theme, int width,
                        int height) {
  render::Page page(width, height, theme);
  page.begin({.title = title, .state = fmt::format("step {} · t = {:.3f} s", view.step, view.time)});
  const render::Rect area = page.area();
  const render::TextStyle words = page.label();
  const double line = 1.6 * words.size;
  const List<render::Rect> parts =
      render::columns({area.x, area.y, area.width, area.height - line}, {1, 1}, page.sizes().gap);
  const render::Rect inside = page.panel(parts[0], "");
  if (view.rows.empty()) {
    page.paragraph({inside.x, inside.y + words.size}, inside.width, "The step has no rows: nothing touches.",
                   words);
  } else {
    render::draw_matrix(page, inside, matrix_view(view));
    render::draw_plot(page, parts[1], residual_plot(view, theme));
  }
  page.paragraph({area.x, area.y + area.height}, area.width, setting_text(view.setting), words);
  return page.canvas().read();
}

}  // namespace cairn::sandbox
