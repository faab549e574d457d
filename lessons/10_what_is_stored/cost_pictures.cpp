// Memory against the number of rows, and a scene where A has no zeros.
#include "lesson.hpp"

namespace cairn::stored {

namespace {

/// The bytes kept of each pyramid's A against its rows. The largest pyramid allowed has 968 rows.
void draw_memory(Page& page, const StoredRun& run) {
  const List<Rect> parts = in_columns(page, {0.62, 0.38});
  Plot plot{.title = "what is kept of A (bytes)"};
  plot.x = {.title = "rows m", .scale = AxisScale::logarithmic, .min = 10, .max = 1000};
  plot.y = {.scale = AxisScale::logarithmic, .min = 100, .max = 1e7};
  Series full{.name = "full A", .style = page.theme().pgs};
  Series sparse{.name = "sparse A", .style = {page.theme().outline, {2, 5}, Marker::diamond}};
  Series si{.name = "SI", .style = page.theme().si};
  for (const Count& count : run.pyramids) {
    full.add(count.rows, count.dense * sizeof(double));
    sparse.add(count.rows, count.pairs * (sizeof(double) + sizeof(int)));
    si.add(count.rows, count.rows * sizeof(double));
  }
  plot.series = {full, sparse, si};
  draw_plot(page, parts[0], plot);
  page.note(parts[1], "",
            "Twice the rows take four times the memory in a full A, and twice in the others. Each entry of a "
            "sparse A has its column beside it: 12 bytes. SI keeps 8 bytes for each row.");
}

void draw_tray(Page& page, const StoredRun& run) {
  const List<Rect> parts = in_rows(page, {0.2, {0.8, {0.36, 0.36, {0.28, {0.4, 0.6}}}}});
  const Rect inside = page.panel(
      parts[0],
      fmt::format("tray: {} boxes on one body that can move, m = {:g} rows", boxes_on_tray, run.tray.rows));
  const Camera camera = fit(inside, render::bounds_of({&run.tray_snapshot, 1}));
  draw_world(page, camera, run.tray_snapshot, {.numbers = false, .contacts = false, .penetration = false});
  const Count& pyramid = run.pyramids[2];
  draw_pattern(page, parts[1], pyramid, run.problems[2]);
  draw_pattern(page, parts[2], run.tray, run.tray_problem);
  const auto for_each_row = [](const Count& count) {
    return fmt::format("{:.3g}", count.non_zeros / count.rows);
  };
  page.table(parts[3], "numbers kept for each row",
             {.header = {"", pyramid.name, run.tray.name},
              .rows = {{"sparse A", for_each_row(pyramid), for_each_row(run.tray)}, {"SI", "1", "1"}}});
  page.note(parts[4], "",
            "All boxes push the tray, so all rows meet. SI keeps one number for each, as before.");
}

}  // namespace

List<Shot> cost_shots(const StoredRun& run) {
  return {
      key_shot(
          run, "memory",
          "Bytes against rows, both axes logarithmic: a full A rises twice as steeply as a sparse one and "
          "SI.",
          draw_memory),
      key_shot(run, "a scene without zeros",
               "Boxes in a row on one tray; the pattern of a pyramid's A, a thin band, beside that of the "
               "tray with as many rows, which is full.",
               draw_tray)};
}

}  // namespace cairn::stored
