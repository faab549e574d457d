// The stack with its pushes and velocities, the bars of lambda, and equation (22) filled in.
#include "lesson.hpp"

namespace cairn::stack {

namespace {

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

void draw_stack(Page& page, const Rect& rect, const StackRun& run, const Moment& moment) {
  draw_stack_panel(page, rect,
                   {.stack = run.snapshot,
                    .lambda = moment.lambda,
                    .velocity = box_velocities(moment.velocity),
                    .earlier = box_velocities(moment_after(run, moment.update - 1).velocity),
                    .active = active_interface(run, moment),
                    .largest_lambda = run.exact[0],
                    .largest_velocity = run.settings.gravity * run.settings.dt});
}

BarChart lambda_bars(const StackRun& run, const Moment& moment) {
  BarChart chart{.title = "accumulated λ (N)", .largest = 1.12 * run.exact[0]};
  const int active = active_interface(run, moment);
  for (int i = run.settings.boxes - 1; i >= 0; --i) {  // from top to bottom, as the boxes stand
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

Equation equation_22(const Page& page, const StackRun& run, const Moment& moment) {
  const RowUpdate<double>& update = run.updates[moment.update].update;
  const double dt = run.settings.dt;
  Equation equation;
  equation.number = "eq (22)";
  equation.symbols = "λ_{corrective} = (ζ − j·v) / (j M^{−1} j^{T} Δt)";
  equation.numbers = fmt::format("= (0 − {}) / ({:g} × {:g})", in_brackets(fixed(update.row_velocity, 4)),
                                 update.inverse_mass, dt);
  equation.result = fmt::format("= {} N", fixed(update.corrective / dt, 3));
  equation.color = page.theme().normal;
  return equation;
}

/// What the row had given before the visit, what it gives, and the sum.
TableView ledger(const StackRun& run, const Moment& moment) {
  const RowUpdate<double>& update = run.updates[moment.update].update;
  const int row = run.interface_of_row[update.row] + 1;
  const double dt = run.settings.dt, before = update.impulse_before / dt, after = update.impulse_after / dt;
  return {.header = {fmt::format("row {}", row), "N"},
          .rows = {{"λ before the visit", fixed(before, 2)},
                   {"λ_{corrective}, to both boxes", fixed(after - before, 2)},
                   {"λ after it", fixed(after, 2)}}};
}

void draw_update(Page& page, const StackRun& run, int update) {
  const Moment moment = moment_after(run, update);
  const double bars = run.settings.boxes > 6 ? 0.7 : 0.38;  // or their names were too small
  const List<Rect> parts = in_columns(page, {0.52, {0.48, {bars, 0.29, 0.33}}});
  draw_stack(page, parts[0], run, moment);
  draw_bars(page, parts[1], lambda_bars(run, moment));
  page.equation(parts[2], equation_22(page, run, moment));
  page.table(parts[3], "", ledger(run, moment));
}

/// The lowest, the middle and the uppermost box over the sweeps.
Plot course(const StackRun& run, const std::string& title, const std::string& name, const Color& color,
            const std::function<List<double>(int)>& after) {
  Plot plot{.title = title, .x = {.title = "sweep"}};
  const int last = run.settings.boxes - 1;
  List<int> places = {0};
  if (last > 1) places.push_back((last + 1) / 2);
  if (last > 0) places.push_back(last);
  const FixedList<Marker, 3> markers = {Marker::circle, Marker::triangle, Marker::diamond};
  for (const int i : places) {
    List<double> values;
    for (int sweep = 0; sweep < run.sweeps.size(); ++sweep) values.push_back(after(sweep)[i]);
    const SeriesStyle style{.color = color, .marker = markers[plot.series.size()]};
    plot.series.push_back(over_steps(fmt::format("{}_{{{}}}", name, i + 1), style, values));
  }
  return plot;
}

Plot speeds(const Page& page, const StackRun& run) {
  return course(run, "velocity of each box (m/s)", "v", page.theme().velocity,
                [&run](int sweep) { return velocities_after(run, sweep); });
}

void draw_course(Page& page, const StackRun& run) {
  const List<Rect> parts = in_columns(page, {0.5, 0.5});
  Plot lambda = course(run, "λ (N) of each contact; dashed: exact", "λ", page.theme().normal,
                       [&run](int sweep) { return lambda_after(run, sweep); });
  for (const double exact : run.exact) lambda.goals.push_back({.y = exact});
  lambda.y.min = 0;
  draw_plot(page, parts[0], lambda);
  draw_plot(page, parts[1], speeds(page, run));
}

/// The stack before and after one sweep.
void draw_asked(Page& page, const Rect& rect, const StackRun& run, int sweep) {
  const Camera camera = draw_stack_panel(page, rect,
                                         {.stack = run.snapshot,
                                          .lambda = lambda_after(run, sweep),
                                          .velocity = velocities_after(run, sweep),
                                          .earlier = velocities_after(run, 0),
                                          .largest_lambda = 2 * lambda_after(run, 1)[0],
                                          .largest_velocity = run.settings.gravity * run.settings.dt});
  const int boxes = run.settings.boxes;
  for (int i = 0; i < boxes; ++i) {
    page.canvas().text(camera.project({0, i + 0.78}), "1 kg", aligned(page.label(), Align::center));
    const Point beside = camera.project({-1, i}) + Point(0, i == 0 ? -12 : 6);  // off the ground's line
    if (sweep == 0) page.canvas().text(beside, fmt::format("visit {}", i + 1), page.secondary());
  }
  const TextStyle style{.size = 24, .color = page.theme().velocity, .bold = true};
  const std::string fall = significant(-velocities_after(run, sweep).back());
  page.canvas().text(camera.project({0.62, boxes - 0.15}),
                     sweep == 0 ? "after one sweep: ?" : "still " + fall + " m/s", style);
}

Shot update_shot(const StackRun& run, int index) {
  const RowUpdate<double>& update = run.updates[index].update;
  const int row = run.interface_of_row[update.row] + 1;
  const double dt = run.settings.dt;
  return {.state = fmt::format("sweep {}/{} · row {} of {}", update.sweep, run.settings.sweeps, row,
                               run.settings.boxes),
          .alt = fmt::format(
              "Sweep {}, row {}: the boxes part at {:.4f} m/s, so the contact gives {:.4f} N more, "
              "{:.4f} N in total; exact is {:g} N.",
              update.sweep, row, update.row_velocity, update.corrective / dt, update.impulse_after / dt,
              run.exact[row - 1]),
          .draw = [&run, index](Page& page) { draw_update(page, run, index); },
          .key = index <= run.settings.boxes && index < 6};
}

}  // namespace

List<Shot> stack_shots(const StackRun& run) {
  const auto scene_after = [&run](int sweep) {
    return [&run, sweep](Page& page, const Rect& rect) { draw_asked(page, rect, run, sweep); };
  };
  List<Shot> shots = {question_shot(
      card(), {.state = "before the first sweep",
               .alt = "Three stacked boxes of 1 kg, all falling at the same speed, and the question.",
               .scene = scene_after(0)})};
  for (int i = 0; i < run.updates.size(); ++i) shots.push_back(update_shot(run, i));
  shots.push_back(
      key_shot(run, fmt::format("all {} sweeps", run.settings.sweeps),
               "λ of the contacts over the sweeps, rising to the exact values; and the velocities "
               "of the boxes, going to zero.",
               draw_course));
  const std::string fall = significant(-velocities_after(run, 1).back());
  shots.push_back(answer_shot(
      card(),
      {.state = "after one sweep",
       .alt = fmt::format("The stack after one sweep: the uppermost box still falls at {} m/s.", fall),
       .scene = scene_after(1)},
      fall + " m/s. Row 3 finds box 2 falling at 0.1 m/s, under a box that falls at 0.2 m/s, and makes both "
             "equally fast. Its push has made box 2 faster, so row 2 has an error again."));
  return shots;
}

}  // namespace cairn::stack
