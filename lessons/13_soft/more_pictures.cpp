// Springs from soft to stiff, three weights as sweeps go by, and a spring that is a force.
#include "lesson.hpp"

namespace cairn::soft {

namespace {

/// From one colour to another.
Color between(const Color& from, const Color& to, float part) {
  return {from.r + part * (to.r - from.r), from.g + part * (to.g - from.g), from.b + part * (to.b - from.b)};
}

/// The darker, the stiffer: at last a rod.
void draw_stiff_curves(Page& page, const Rect& rect, const SoftRuns& all) {
  Plot plot{.title = "c (mm)"};
  plot.x = {.title = "t (s)", .min = 0, .max = 0.5};
  double lowest = 0;
  double highest = 0;
  for (const int shown : {0, 1, 2, all.stiff.size() - 1}) {
    const StiffRun& run = all.stiff[shown];
    const float part = static_cast<float>(plot.series.size()) / 3;
    const FixedList<Marker, 4> markers = {Marker::diamond, Marker::square, Marker::triangle, Marker::circle};
    Series series{
        .name = run.frequency < 1e5 ? fmt::format("{:g} Hz", run.frequency) : "10^{6} Hz",
        .style = {
            between(style_of_soft(page).color, page.theme().outline, part), {}, markers[plot.series.size()]}};
    for (int step = 0; step * all.settings.dt <= 0.5 + 1e-9 && step < run.error.size(); ++step)
      series.add(step * all.settings.dt, 1000 * run.error[step]);
    plot.series.push_back(series);
    lowest = std::min(lowest, *std::min_element(series.y.begin(), series.y.end()));
    highest = std::max(highest, *std::max_element(series.y.begin(), series.y.end()));
  }
  plot.y = {.min = lowest - 20, .max = highest + 20};
  draw_plot(page, rect, plot);
}

void draw_stiff(Page& page, const SoftRuns& all) {
  const List<Rect> parts = in_columns(page, {0.54, {0.46, {0.6, 0.4}}});
  draw_stiff_curves(page, parts[0], all);
  TableView table{.header = {"f (Hz)", "γ (1/kg)", "β", "m g / k (mm)"}};
  for (const StiffRun& run : all.stiff) {
    const double sag = 1000 * run.sag;
    table.rows.push_back({run.frequency < 1e5 ? fmt::format("{:g}", run.frequency) : "10^{6}",
                          significant(run.gamma, 3), fixed(run.beta, 4), significant(sag, 3)});
    if (run.frequency == all.settings.frequency) table.active_row = table.rows.size() - 1;
  }
  page.table(parts[1], "the same Δt and damping ratio", table);
  page.note(parts[2], "Stiffer",
            "Δt k outgrows d, and β goes to 1: the row becomes a rod that takes its error back in one step.");
}

/// Three weights, one upon the other, on rods or on springs.
void draw_column(Page& page, const Rect& rect, const ColumnRun& run, const std::string& title) {
  const Camera camera = fit(page.panel(rect, title), {{-0.6, -0.05}, {0.6, 3.3}});
  Snapshot column = run.start;
  for (const SnapshotJoint& joint : run.start.joints) {
    if (run.gamma > 0) {
      draw_spring(page, camera, 0, joint.anchor_a.y(), joint.anchor_b.y(), style_of_soft(page));
    } else {
      page.canvas().line(camera.project({0, joint.anchor_a.y()}), camera.project({0, joint.anchor_b.y()}),
                         {.width = page.sizes().curve, .color = style_of_rigid(page).color});
    }
  }
  column.joints.clear();
  draw_world(page, camera, column);
  page.canvas().line(camera.project({-0.6, 0}), camera.project({0.6, 0}),
                     {.width = page.sizes().outline, .color = page.theme().outline});
}

/// Colours of both as strong as their numbers.
void draw_own_matrix(Page& page, const Rect& rect, const std::string& title, const ColumnRun& run,
                     const SoftRuns& all) {
  draw_matrix(page, rect,
              {.title = title,
               .values = run.A,
               .row_names = {"1", "2", "3"},
               .column_names = {"1", "2", "3"},
               .strongest = all.soft_column.A.maxCoeff()});
}

void draw_matrices(Page& page, const SoftRuns& all) {
  const List<Rect> parts = in_rows(page, {{0.5, {0.2, 0.3, 0.2, 0.3}}, {0.5, {0.5, 0.5}}});
  draw_column(page, parts[0], all.rigid_column, "rods");
  draw_own_matrix(page, parts[1], "A = J M⁻¹ Jᵀ (1/kg)", all.rigid_column, all);
  draw_column(page, parts[2], all.soft_column, "springs");
  draw_own_matrix(page, parts[3], "A + γ (1/kg)", all.soft_column, all);
  const ColumnRun& soft = all.soft_column;
  page.equation(parts[4], {.number = "eq (15), PGS",
                           .symbols = "A λ = b,   with A_{ii} + γ",
                           .numbers = fmt::format("row 1: ({:.3g} + {:.3g}) λ_{{1}} − λ_{{2}} = b_{{1}}",
                                                  all.rigid_column.A(0, 0), soft.gamma),
                           .result = fmt::format("A_{{11}} + γ = {:.4g} 1/kg", soft.A(0, 0)),
                           .algorithm = "a change of the matrix",
                           .color = style_of_soft(page).color});
  // Sweep 2 of row 1; zeta is 0, as the springs begin without load.
  const double dt = all.settings.dt;
  const double given = soft.gamma * soft.by_si[1][0] * dt;
  const double change = soft.by_si[2][0] - soft.by_si[1][0];
  const double jv = -given - change * soft.A(0, 0) * dt;
  page.equation(parts[5], {.number = "eq (22), SI: row 1, sweep 2",
                           .symbols = "Δλ = (ζ − j·v − γ λ Δt) / ((A_{ii} + γ) Δt)",
                           .numbers = fmt::format("= (0 − ({}) − {}) / ({:.3g} × {:.3g})", fixed(jv, 4),
                                                  fixed(given, 4), soft.A(0, 0), dt),
                           .result = fmt::format("= {} N", fixed(change, 4)),
                           .algorithm = "a term in one constraint's routine",
                           .color = style_of_soft(page).color});
}

SeriesStyle style_of_force(const Page& page) { return {page.theme().external, {2, 5}, Marker::triangle}; }

void draw_run_away(Page& page, const Rect& rect, const SoftRuns& all) {
  Plot plot{.title = fmt::format("distance from the place of rest (m), {:g} Hz", harsh_hertz)};
  plot.x = {.title = "step", .min = 0, .max = 6};
  plot.y = {.scale = AxisScale::logarithmic, .min = 1e-12, .max = 1e20};
  SoftSettings harsh = all.settings;
  harsh.frequency = harsh_hertz;
  const double sag = harsh.mass * gravity / stiffness(harsh);
  const auto add = [&](const std::string& name, const List<double>& error, const SeriesStyle& style) {
    List<double> distances;
    for (int k = 0; k <= 6; ++k) distances.push_back(std::abs(error[k] + sag));
    plot.series.push_back(over_steps(name, style, distances));
  };
  add("force", all.harsh_force, style_of_force(page));
  add("row", all.harsh_row, style_of_soft(page));
  draw_plot(page, rect, plot);
}

void draw_growth(Page& page, const Rect& rect, const SoftRuns& all) {
  Plot plot{.title = "a step multiplies the oscillation by at most"};
  plot.x = {.title = "f (Hz)", .scale = AxisScale::logarithmic, .min = 0.1, .max = 100};
  plot.y = {.scale = AxisScale::logarithmic, .min = 0.01, .max = 1e3};
  Series row{.name = "row", .style = style_of_soft(page), .markers = false};
  Series force{.name = "force", .style = style_of_force(page), .markers = false};
  for (const Growth& growth : all.growth) {
    row.add(growth.frequency, growth.row);
    force.add(growth.frequency, growth.force);
  }
  plot.series = {force, row};
  plot.goals.push_back({1, "above: grows"});
  // z = 2 pi f dt: with z = 1 and a damping ratio of 1/2 both parts of the oscillation are multiplied by 0.
  if (all.settings.damping == 0.5)
    plot.labels = {{1 / (2 * pi * all.settings.dt), 0.04, "2π f Δt = 1: stops"}};
  draw_plot(page, rect, plot);
}

/// The first frequency at which the oscillation grows under a force.
double largest_hertz(const SoftRuns& all) {
  // z^2 + 4 zeta z < 4 with z = w dt: then both parts of the oscillation shrink.
  const double z = 2 * (std::sqrt(all.settings.damping * all.settings.damping + 1) - all.settings.damping);
  return z / (2 * pi * all.settings.dt);
}

void draw_harsh(Page& page, const SoftRuns& all) {
  const List<Rect> parts = in_rows(page, {{0.7, {1, 1}}, 0.3});
  draw_run_away(page, parts[0], all);
  draw_growth(page, parts[1], all);
  const double hertz = largest_hertz(all);
  page.note(parts[2], "A force, or a row",
            fmt::format("The force −k c − d v of the beginning of a step pushes too far above {:.3g} Hz, and "
                        "further each time. The row takes the force of the step's end: it never diverges, "
                        "but it damps motions that are too fast for the step. Both charts: Δt = {:g} s.",
                        hertz, all.settings.dt));
}

}  // namespace

List<Shot> stiff_shots(const SoftRuns& all) {
  return {key_shot(all, "stiffer and stiffer",
                   "Oscillations on springs from 1 Hz to a million Hz, and a table of their γ, β and sag: γ "
                   "goes to 0, β "
                   "to 1, the sag to 0.",
                   draw_stiff)};
}

List<Shot> column_shots(const SoftRuns& all) {
  return {key_shot(all, "three weights · A",
                   fmt::format("A of three rods, and A of three springs: the same, but with γ = {:.3g} added "
                               "to the diagonal.",
                               all.soft_column.gamma),
                   draw_matrices)};
}

List<Shot> harsh_shots(const SoftRuns& all) {
  return {key_shot(
      all, fmt::format("a stiff spring, Δt = {:g} s", all.settings.dt),
      "Left: the same stiff spring as a force diverges, as a row it comes to rest. Right: by how much "
      "a step multiplies the oscillation, against the frequency; as a row always less than 1.",
      draw_harsh)};
}

}  // namespace cairn::soft
