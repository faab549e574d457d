// The pyramid: what decides whether Jacobi converges, and what it costs.
#include "lesson.hpp"

namespace cairn::everybody {

namespace {

/// The pyramid with the number of rows on each box.
void draw_rows_on_boxes(Page& page, const Rect& rect, const PileRun& run) {
  const Rect inside = page.panel(rect, "rows on each box");
  const double half = 0.625 * run.settings.base + 0.2;
  const Camera camera = fit(inside, {{-half, -0.3}, {half, run.settings.base + 0.1}});
  WorldLook look;
  for (const BodyId body : run.rows_on_box.indices())
    look.names.push_back(body == ground ? "" : fmt::format("{}", run.rows_on_box[body]));
  draw_world(page, camera, run.snapshot, look);
}

std::string verdict_of(const PileHistory& history) {
  if (history.method == Method::sequential) return "yes, in turn";
  return history.eigenvalue < 2 ? "yes, below 2" : "no, above 2";
}

void draw_eigenvalues(Page& page, const PileRun& run) {
  const List<Rect> parts = in_columns(page, {0.46, {0.54, {0.42, 0.58}}});
  draw_rows_on_boxes(page, parts[0], run);
  TableView table;
  table.header = {"method", "ω × eigenvalue", "it converges"};
  for (const PileHistory& history : run.histories) {
    const bool in_turn = history.method == Method::sequential;
    table.rows.push_back({method_name(history.method, run.settings.omega),
                          in_turn ? "·" : fixed(history.eigenvalue, 3), verdict_of(history)});
  }
  page.table(parts[1], "the largest eigenvalue of D^{−1} A", table);
  const int most = *std::max_element(run.rows_on_box.begin() + 1, run.rows_on_box.end());
  page.note(parts[2], "What decides",
            fmt::format("Up to {} rows correct one box at the same time. With an eigenvalue above 2 a "
                        "sweep leaves some error larger than before. Damping gives a share of each "
                        "correction; every scene needs its own share. Split masses give each row its share "
                        "of the box, and no eigenvalue is above 1 in any scene.",
                        most));
}

void draw_convergence(Page& page, const PileRun& run) {
  const List<Rect> parts = in_rows(page, {0.6, {0.4, {0.6, 0.4}}});
  Plot plot{.title = "residual R_{E} after each sweep"};
  plot.x = {.title = "sweep", .scale = AxisScale::logarithmic, .min = 1, .max = 1000};
  plot.y = {.title = "", .scale = AxisScale::logarithmic, .min = 2e-5, .max = 2};
  const auto add = [&](const std::string& name, const SeriesStyle& style, const List<double>& residual) {
    Series series{.name = name, .style = style};
    for (int k = 1; k <= 300 && k < residual.size(); ++k) {
      if (!(residual[k] > 1e-4)) break;
      series.add(k, residual[k]);
    }
    plot.series.push_back(series);
  };
  for (const PileHistory& history : run.histories) {
    if (history.method == Method::plain) continue;  // which grows from 1 on
    add(method_name(history.method, run.settings.omega), style_of(page.theme(), history.method),
        history.residual);
  }
  add("momentum", {page.theme().jacobi.color, {12, 5, 2, 5}, Marker::circle}, run.momentum_residual);
  plot.goals.push_back({0.01, "1 %"});
  draw_plot(page, parts[0], plot);
  TableView table;
  table.header = {"method", "sweeps to 1 %", "turns a sweep", "turns"};
  const auto line = [&](const std::string& name, const PileHistory& history) {
    const int turns = turns_per_sweep(run, history);
    const int needed = history.sweeps_needed;
    table.rows.push_back({name, needed < 0 ? "never" : fmt::format("{}", needed), fmt::format("{}", turns),
                          needed < 0 ? "·" : fmt::format("{}", needed * turns)});
  };
  for (const PileHistory& history : run.histories)
    line(method_name(history.method, run.settings.omega), history);
  line("SI, by colours", run.coloured);
  const int sweeps = run.with_momentum.sweeps_needed;
  table.rows.push_back({"Jacobi, momentum", fmt::format("{}", sweeps), "2", fmt::format("{}", 2 * sweeps)});
  page.table(parts[1], "", table);
  page.note(parts[2], "With a processor for each row",
            "All rows of Jacobi work in one turn, not counting the sums into each box. SI takes one row "
            "after the other; by colours, rows that share no box go together. Plain Jacobi grows, and is not "
            "drawn.");
}

}  // namespace

List<Shot> pile_shots(const PileRun& run) {
  List<Shot> shots;
  shots.push_back(
      key_shot(run, fmt::format("a pyramid, {} rows", run.problem.row_count()),
               "A pyramid with the number of rows on each box, and the largest eigenvalue of each "
               "method.",
               draw_eigenvalues));
  shots.push_back(key_shot(run, "one step of the pyramid",
                           "Residual against sweeps for SI and three forms of Jacobi, and how many turns "
                           "each needs with a processor for each row.",
                           draw_convergence));
  return shots;
}

}  // namespace cairn::everybody
