// The panels beside the scene: impulses, residuals, and the equation of a row.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <cairn/constraints/contact_rows.hpp>
#include <cairn/math/list.hpp>
#include "lessons/playground/picture.hpp"
#include "render/plot.hpp"
#include "render/solver_style.hpp"
#include <cairn/solvers/residual.hpp>

namespace cairn::playground {

namespace {

using render::Rect;

constexpr double least_pitch = 22;         // [px] of a bar that can be read and pointed at
constexpr double room_for_jacobian = 560;  // [px]
constexpr double bars_above = 92;          // [px] for the panel's title, key and range

constexpr double coarse[] = {1, 2, 5, 10};
constexpr double fine[] = {1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10};

/// The least of the steps, times a power of ten, that is not below the value.
double rounded_up(double value, Span<const double> steps) {
  const double ten = std::pow(10, std::floor(std::log10(std::max(value, 1e-6))));
  for (const double step : steps) {
    if (step * ten >= value) return step * ten;
  }
  return 10 * ten;
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

/// The bar of a line, of which the last row update has come so far as it is drawn.
render::Bar Picture::bar_of(const Playground& playground, const BarLine& line) const {
  const SolveLook& look = playground.look(0);
  const std::optional<Prediction>& prediction = playground.prediction();
  const bool is_asked = prediction && !prediction->is_revealed;
  const double dt = look.given.dt;
  const bool is_lit = line.rows.size() == 1 && line.rows[0] == playground.lit_row();
  render::Bar bar{.name = line.name, .before = sum_of(line, impulses(playground, 0)) / dt, .active = is_lit};
  if (!is_asked) bar.exact = sum_of(line, playground.ends()) / dt;
  if (look.last && line.rows.size() == 1 && line.rows[0] == look.last->row) {
    bar.before = look.last->impulse_before / dt;
    bar.added = moment_ * (look.last->impulse_after - look.last->impulse_before) / dt;
  }
  if (is_asked && line.rows[0] == prediction->row) {
    bar.before = 0;
    bar.added = prediction->force;
  }
  return bar;
}

/// As many lines as have room, with that of the student among them.
void Picture::choose_lines(const Playground& playground, const Rect& rect) {
  lines_ = bar_lines(playground, shows_all_rows_);
  const int lines = lines_.size();
  bar_count_ = std::clamp(static_cast<int>((rect.height - bars_above) / least_pitch), 1, std::max(1, lines));
  bar_count_ = std::min(bar_count_, lines);
  const int wanted =
      playground.prediction() ? playground.prediction()->row : std::max(0, playground.lit_row());
  const auto found = std::find_if(lines_.begin(), lines_.end(),
                                  [&](const BarLine& line) { return line.rows.back() >= wanted; });
  const int shown = static_cast<int>(found - lines_.begin());
  if (shown < first_bar_ || shown >= first_bar_ + bar_count_) first_bar_ = shown - bar_count_ / 2;
  first_bar_ = std::clamp(first_bar_, 0, lines - bar_count_);
}

std::string Picture::bars_title(const Playground& playground) const {
  const int lines = lines_.size(), rows = playground.look(0).given.row_count();
  const bool are_rows = shows_all_rows_ || shows_rows(playground);
  const std::string what = are_rows ? "accumulated λ (N)" : "force of each contact (N)";
  if (lines > bar_count_)
    return fmt::format("{}, {} to {} of {}", what, first_bar_ + 1, first_bar_ + bar_count_, lines);
  if (are_rows && lines < rows) return fmt::format("{}, {} rows without friction", what, lines);
  return are_rows ? fmt::format("{}, {} rows", what, rows) : what;
}

/// For single rows a range that stands still while they grow. That of a question has room to be wrong, and is
/// as long for one answer as for another. What contacts give stands still by itself.
ForceRange Picture::range_of(const Playground& playground) const {
  const SolveLook& look = playground.look(0);
  const double dt = look.given.dt;
  const ForceRange forces = playground.forces();
  ForceRange range{.most = 1.02 * std::max(forces.most, 0.25 * forces.largest())};
  if (const auto& prediction = playground.prediction()) {
    const double end = playground.ends()[prediction->row] / dt;
    range.most = rounded_up(std::max(1.3 * std::abs(end), forces.most), coarse);
  } else if (!shows_all_rows_ && !shows_rows(playground)) {
    double largest = 0;
    for (const BarLine& line : lines_) {
      const double sum = std::abs(sum_of(line, look.impulse)),
                   end = std::abs(sum_of(line, playground.ends()));
      largest = std::max({largest, sum, std::min(end, 2 * sum)});
    }
    range.most = rounded_up(1.02 * largest / dt, fine);
  }
  range.most = std::max(range.most, 1e-6);
  const bool has_negative = std::any_of(lines_.begin(), lines_.end(), [&](const BarLine& line) {
    return !look.given.rows[line.rows[0]].bounds.is_unilateral();
  });
  if (has_negative) range.least = std::min(1.02 * forces.least, -0.25 * range.most);
  return range;
}

void Picture::draw_rows(const Playground& playground, const Rect& rect) {
  choose_lines(playground, rect);
  const bool are_rows = shows_all_rows_ || shows_rows(playground);
  const ForceRange range = range_of(playground);
  render::BarChart chart{.title = bars_title(playground),
                         .exact = are_rows ? "where sweeps end" : "where its sum ends",
                         .largest = range.most,
                         .smallest = range.least,
                         .digits = shows_all_rows_ ? 3 : 2};
  for (int i = first_bar_; i < first_bar_ + bar_count_; ++i)
    chart.bars.push_back(bar_of(playground, lines_[i]));
  bar_places_ = render::draw_bars(*page_, rect, chart);
}

void Picture::draw_residuals(const Playground& playground, const Rect& rect) {
  const render::Theme& theme = page_->theme();
  render::Plot plot{.title = "what each sweep leaves",
                    .x = {.title = "sweep"},
                    .y = {.title = "R_{E}", .scale = render::AxisScale::logarithmic}};
  for (int k = 0; k < playground.bench_count(); ++k) {
    const std::string solver = k == 0 ? playground.controls().setting.solver : *playground.controls().other;
    render::Series series{.name = solver, .style = render::style_of_solver(theme, solver)};
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
  const double corrective = without_rounding(mass > 0 ? (row.bias - jv - row.softness * before) / mass : 0,
                                             playground.forces().largest() * dt);
  const double after =
      is_last ? look.last->impulse_after : row.bounds.clamp(before + corrective, now.impulse);
  const bool is_soft = row.softness > 0;
  render::Equation equation;
  equation.number = fmt::format("row {}, {} · eq (22)", lit + 1, kind_name(row));
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
