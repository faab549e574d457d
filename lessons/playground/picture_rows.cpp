// The panels beside the scene: impulses, residuals, and the equation of a row.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <cairn/constraints/contact_rows.hpp>
#include <cairn/math/list.hpp>
#include "lessons/playground/picture.hpp"
#include "render/plot.hpp"
#include <cairn/solvers/residual.hpp>

namespace cairn::playground {

namespace {

using render::Rect;

constexpr double least_pitch = 22;         // [px] of a bar that can be read and pointed at
constexpr double room_for_jacobian = 560;  // [px]
constexpr double bars_above = 70;          // [px] for the panel's title and key

std::string kind_of(const ConstraintRow<double>& row) {
  if (is_rolling(row)) return "rolling";
  if (row.bounds.is_friction()) return "friction";
  return row.bounds.is_unilateral() ? "normal" : "joint";
}

std::string jacobian_text(const Vec3<double>& j) {
  return fmt::format("({}, {}, {})", render::significant(j.x(), 2), render::significant(j.y(), 2),
                     render::significant(j.z(), 2));
}

/// Negative numbers in brackets, where they follow an operator.
std::string operand(double value, int digits) {
  const std::string text = render::significant(value, digits);
  return value < 0 ? "(" + text + ")" : text;
}

}  // namespace

/// As many rows as have room, with that of the student among them.
void Picture::draw_rows(const Playground& playground, const Rect& rect) {
  const SolveLook& look = playground.look(0);
  const PerRow<double>& ends = playground.ends();
  const int rows = look.given.row_count();
  bar_count_ = std::clamp(static_cast<int>((rect.height - bars_above) / least_pitch), 1, std::max(1, rows));
  bar_count_ = std::min(bar_count_, rows);
  const int shown =
      playground.prediction() ? playground.prediction()->row : std::max(0, playground.lit_row());
  if (shown < first_bar_ || shown >= first_bar_ + bar_count_) first_bar_ = shown - bar_count_ / 2;
  first_bar_ = std::clamp(first_bar_, 0, rows - bar_count_);
  const double dt = look.given.dt;
  render::BarChart chart{.title = fmt::format("accumulated λ (N), {} rows", rows),
                         .exact = "where sweeps end"};
  if (rows > bar_count_ && bar_count_ > 0) {
    chart.title =
        fmt::format("accumulated λ (N), rows {} to {} of {}", first_bar_ + 1, first_bar_ + bar_count_, rows);
  }
  const std::optional<Prediction>& prediction = playground.prediction();
  const bool is_predicting = prediction && !prediction->is_revealed;
  for (int i = first_bar_; i < first_bar_ + bar_count_; ++i) {
    render::Bar bar{.name = fmt::format("{} {}", i + 1, kind_of(look.given.rows[i])),
                    .before = look.impulse[i] / dt,
                    .exact = ends[i] / dt,
                    .active = i == playground.lit_row()};
    if (look.last && i == look.last->row) {
      bar.before = look.last->impulse_before / dt;
      bar.added = (look.last->impulse_after - look.last->impulse_before) / dt;
    }
    if (is_predicting) bar.exact.reset();
    if (is_predicting && prediction->row == i) {
      bar.before = 0;
      bar.added = prediction->force;
      bar.active =
          false;  // a number beside it would take room from all bars, and move this one under the pointer
    }
    chart.bars.push_back(bar);
  }
  // Whether or not a row is predicted, so that a bar stays where it is pulled to: with room to be wrong.
  const ForceRange forces = playground.forces();
  const double most = std::max(1.12 * forces.most, 0.25 * forces.largest());
  const bool has_negative = std::any_of(look.given.rows.begin(), look.given.rows.end(),
                                        [](const auto& row) { return !row.bounds.is_unilateral(); });
  chart.largest = std::max(most, 1e-6);
  chart.smallest = has_negative ? std::min(1.12 * forces.least, -0.25 * chart.largest) : 0;
  bar_places_ = render::draw_bars(*page_, rect, chart);
}

void Picture::draw_residuals(const Playground& playground, const Rect& rect) {
  const render::Theme& theme = page_->theme();
  render::Plot plot{.title = "what each sweep leaves",
                    .x = {.title = "sweep"},
                    .y = {.title = "R_{E}", .scale = render::AxisScale::logarithmic}};
  for (int k = 0; k < playground.bench_count(); ++k) {
    render::Series series{
        .name = k == 0 ? playground.controls().setting.solver : *playground.controls().other,
        .style = k == 0 ? theme.si : theme.pgs};
    const List<double>& residuals = playground.look(k).residuals;
    for (int sweep = 0; sweep < residuals.size(); ++sweep) {
      series.x.push_back(sweep);
      series.y.push_back(residuals[sweep] > 1e-16 ? residuals[sweep] : std::nan(""));
    }
    plot.series.push_back(series);
  }
  const SolveLook& look = playground.look(0);
  if (playground.cursor() && look.last) plot.cursor = look.last->sweep;
  render::draw_plot(*page_, rect, plot);
}

/// Equation (22) of the lit row, with the numbers that it has where the student is.
void Picture::draw_equation(const Playground& playground, const Rect& rect) {
  const SolveLook& look = playground.look(0);
  const int lit = playground.lit_row();
  if (lit < 0 || lit >= look.given.row_count()) {
    return page_->note(rect, "A row", "Click a bar, or do one row, and its equation stands here.");
  }
  VelocityProblem<double> now = look.given;
  now.velocity = look.velocity;
  now.impulse = look.impulse;
  const ConstraintRow<double>& row = look.given.rows[lit];
  const bool is_last = look.last && look.last->row == lit;
  const double dt = look.given.dt, before = is_last ? look.last->impulse_before : now.impulse[lit];
  const double jv = is_last ? look.last->row_velocity : row_velocity(now, row);
  const double mass = inverse_effective_mass(look.given, row);
  const double corrective = mass > 0 ? (row.bias - jv - row.softness * before) / mass : 0;
  const double after =
      is_last ? look.last->impulse_after : row.bounds.clamp(before + corrective, now.impulse);
  const bool is_soft = row.softness > 0;
  render::Equation equation;
  equation.number = fmt::format("row {}, {} · eq (22)", lit + 1, kind_of(row));
  if (rect.width > room_for_jacobian) {
    equation.number += fmt::format(" · j_{{a}} = {}, j_{{b}} = {}", jacobian_text(row.jacobian_a),
                                   jacobian_text(row.jacobian_b));
  }
  equation.symbols =
      is_soft ? "λ = (ζ − j·v − γ λ Δt) / ((j M^{−1} j^{T} + γ) Δt)" : "λ = (ζ − j·v) / (j M^{−1} j^{T} Δt)";
  const std::string soft = is_soft ? " − " + operand(row.softness * before, 3) : "";
  equation.numbers =
      fmt::format("  = ({} − {}{}) / ({} × {})", render::significant(row.bias, 3), operand(jv, 3), soft,
                  render::significant(mass, 3), render::significant(dt, 3));
  equation.result = fmt::format("  = {} N", render::significant(corrective / dt, 4));
  const bool is_of_a_block =
      is_last && std::abs(look.last->corrective - corrective) > 1e-6 * std::abs(corrective);
  equation.algorithm =
      fmt::format("{}:  λ_{{{}}}: {} → {} N", is_of_a_block ? "solved in its block" : "clamped", lit + 1,
                  render::readable(before / dt, 2), render::readable(after / dt, 2));
  equation.color = page_->theme().normal;
  page_->equation(rect, equation);
}

}  // namespace cairn::playground
