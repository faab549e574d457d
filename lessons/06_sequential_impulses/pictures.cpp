// The stack with its pushes and velocities, the bars of lambda, and equation (22) filled in.
#include "parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "lessons/stack_panel.hpp"
#include "lessons/question.hpp"
#include "math/list.hpp"
#include "render/bars.hpp"

namespace cairn::stack {

namespace {

using render::fixed;
using render::Page;
using render::Rect;

using Run = std::shared_ptr<const StackRun>;

/// What one frame shows: lambda [N] of each interface, velocities, and the update that led here, if any.
struct Moment {
  List<double> lambda = {};
  PerBody<Vec3<double>> velocity = {};
  int update = -1;
};

Moment moment_after(const StackRun& run, int update) {
  Moment moment{
      .lambda = List<double>(run.exact.size(), 0.0), .velocity = run.problem.velocity, .update = update};
  for (int i = 0; i <= update; ++i) {
    const RowRecord& record = run.updates[i];
    const int interface = run.interface_of_row[record.update.row];
    moment.lambda[interface] = record.update.impulse_after / run.settings.dt;
    moment.velocity = record.velocity;
  }
  return moment;
}

int active_interface(const StackRun& run, const Moment& moment) {
  if (moment.update < 0) return -1;
  return run.interface_of_row[run.updates[moment.update].update.row];
}

List<double> speeds(const PerBody<Vec3<double>>& velocity) {
  List<double> result;
  for (const BodyId body : velocity.indices()) {
    if (body != ground) result.push_back(velocity[body].y());
  }
  return result;
}

void draw_stack(Page& page, const Rect& rect, const StackRun& run, const Moment& moment) {
  StackMoment shown{.stack = run.snapshot,
                    .lambda = moment.lambda,
                    .velocity = speeds(moment.velocity),
                    .active = active_interface(run, moment),
                    .largest_lambda = run.exact[0],
                    .largest_velocity = run.settings.gravity * run.settings.dt};
  if (moment.update >= 0) shown.earlier = speeds(moment_after(run, moment.update - 1).velocity);
  draw_stack_panel(page, rect, shown);
}

render::BarChart lambda_bars(const StackRun& run, const Moment& moment) {
  render::BarChart chart{.title = "accumulated λ (N)", .largest = 1.12 * run.exact[0]};
  const int active = active_interface(run, moment);
  for (int i = 0; i < run.settings.boxes; ++i) {
    render::Bar bar{.name = fmt::format("row {}", i + 1),
                    .before = moment.lambda[i],
                    .exact = run.exact[i],
                    .active = i == active};
    if (i == active) {
      const RowUpdate<double>& update = run.updates[moment.update].update;
      bar.before = update.impulse_before / run.settings.dt;
      bar.added = (update.impulse_after - update.impulse_before) / run.settings.dt;
    }
    chart.bars.push_back(bar);
  }
  return chart;
}

/// Negative numbers in brackets, where they follow an operator.
std::string operand(double value, int decimals) {
  const std::string text = fixed(value, decimals);
  return value < 0 && text.front() != '0' ? "(" + text + ")" : text;
}

render::Equation equation_22(const Page& page, const StackRun& run, const Moment& moment) {
  const RowUpdate<double>& update = run.updates[moment.update].update;
  const double dt = run.settings.dt;
  render::Equation equation;
  equation.number = "line 9 of Algorithm 1: eq (22)";
  equation.symbols = "λ_{corrective} = (ζ − j·v) / (j M^{−1} j^{T} Δt)";
  equation.numbers =
      fmt::format("= (0 − {}) / ({:g} × {:g})", operand(update.row_velocity, 4), update.inverse_mass, dt);
  equation.result = fmt::format("= {} N", fixed(update.corrective / dt, 3));
  equation.color = page.theme().normal;
  return equation;
}

/// Lines 10 to 13 of Algorithm 1 with what they have done.
render::TableView algorithm_1(const StackRun& run, const Moment& moment) {
  const RowUpdate<double>& update = run.updates[moment.update].update;
  const int row = run.interface_of_row[update.row] + 1;
  const double dt = run.settings.dt, before = update.impulse_before / dt, after = update.impulse_after / dt;
  const std::string bodies =
      row == 1 ? "to the ground and box 1" : fmt::format("to boxes {} and {}", row - 1, row);
  return {.header = {"lines 10 to 13", fmt::format("λ_{{{}}} (N)", row)},
          .rows = {{"10  λ_{old} ← λ", fixed(before, 2)},
                   {"11  λ ← λ + λ_{corrective}", fixed(before + update.corrective / dt, 2)},
                   {"12  clamp λ: at least 0", fixed(after, 2)},
                   {"13  λ − λ_{old} " + bodies, fixed(after - before, 2)}}};
}

void draw_update(Page& page, const StackRun& run, int update) {
  const Moment moment = moment_after(run, update);
  const List<Rect> parts = columns(page.area(), {0.48, 0.5}, page.sizes().gap);
  draw_stack(page, parts[0], run, moment);
  const List<Rect> panels = rows(parts[1], {0.38, 0.29, 0.33}, page.sizes().gap);
  draw_bars(page, panels[0], lambda_bars(run, moment));
  page.equation(panels[1], equation_22(page, run, moment));
  page.table(panels[2], "", algorithm_1(run, moment));
}

QuestionFrame frame_of(const Run& run, int update, std::string state, std::string alt) {
  return {
      .state = std::move(state), .alt = std::move(alt), .scene = [run, update](Page& page, const Rect& rect) {
        draw_stack(page, rect, *run, moment_after(*run, update));
      }};
}

Shot update_shot(const Run& run, int index) {
  const RowUpdate<double>& update = run->updates[index].update;
  const int row = run->interface_of_row[update.row] + 1;
  const double dt = run->settings.dt;
  return {.state = fmt::format("sweep {}/{} · row {} of {}", update.sweep, run->settings.sweeps, row,
                               run->settings.boxes),
          .alt = fmt::format(
              "Sweep {}, row {}: the boxes part at {:.4f} m/s, so the contact gives {:.4f} N more, "
              "{:.4f} N in total; exact is {:g} N.",
              update.sweep, row, update.row_velocity, update.corrective / dt, update.impulse_after / dt,
              run->exact[row - 1]),
          .draw = [run, index](Page& page) { draw_update(page, *run, index); },
          .key = index < 9 || index + 1 == run->updates.size()};
}

}  // namespace

List<Shot> stack_shots(const StackRun& recorded) {
  const Run run = std::make_shared<const StackRun>(recorded);
  const int n = run->settings.boxes;
  const int updates = run->updates.size();
  List<Shot> shots;
  shots.push_back(question_shot(
      card(), frame_of(run, -1, "before the first sweep",
                       "A stack of boxes that has begun to fall, all at the same speed, and the question.")));
  for (int i = 0; i < updates; ++i) shots.push_back(update_shot(run, i));
  std::string falls;
  for (const double speed : speeds(run->updates[n - 1].velocity))
    falls += (falls.empty() ? "" : ", ") + render::significant(0 - speed, 4);
  shots.push_back(answer_shot(
      card(),
      frame_of(run, n - 1, "after one sweep",
               fmt::format("The stack after one sweep, and the answer: {} m/s.", falls)),
      fmt::format("{} m/s. Only the two boxes visited last no longer close in: every push has two ends and "
                  "disturbs its neighbours. So the next sweep follows.",
                  falls)));
  return shots;
}

}  // namespace cairn::stack
