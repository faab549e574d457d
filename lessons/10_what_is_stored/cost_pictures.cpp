// Memory and work against the number of rows, and a scene where A has no zeros.
#include "lesson.hpp"

namespace cairn::stored {

namespace {

/// A number of each pyramid against its rows. The largest pyramid allowed has 968 rows.
Plot rows_plot(const Page& page, const StoredRun& run, const std::string& title, bool of_work) {
  Plot plot{.title = title};
  plot.x = {.title = "rows m", .scale = AxisScale::logarithmic, .min = 10, .max = 1000};
  plot.y = {.scale = AxisScale::logarithmic, .min = 100, .max = 1e7};
  Series full{.name = "full A", .style = page.theme().pgs};
  Series sparse{.name = "sparse A", .style = {page.theme().outline, {2, 5}, Marker::diamond}};
  Series si{.name = "SI", .style = page.theme().si};
  Series naive{.name = "naive", .style = {page.theme().external, {10, 5, 2, 5}, Marker::triangle}};
  for (const Count& count : run.pyramids) {
    const Work work = work_of(count);
    full.add(count.rows, of_work ? work.dense : count.dense * sizeof(double));
    sparse.add(count.rows, of_work ? work.sparse : count.pairs * (sizeof(double) + sizeof(int)));
    si.add(count.rows, of_work ? work.si : count.rows * sizeof(double));
    naive.add(count.rows, work.naive);
  }
  plot.series = {full, sparse, si};
  if (of_work) plot.series.push_back(naive);
  return plot;
}

void draw_cost(Page& page, const StoredRun& run) {
  const List<Rect> parts = in_rows(page, {{0.7, {0.5, 0.5}}, {0.3, {0.5, 0.5}}});
  draw_plot(page, parts[0], rows_plot(page, run, "what is kept of A (bytes)", false));
  draw_plot(page, parts[1], rows_plot(page, run, "products of one sweep", true));
  page.note(parts[2], "",
            "Twice the rows take four times the memory in a full A, and twice in the others. Each entry of a "
            "sparse A has its column beside it: 12 bytes.");
  page.note(
      parts[3], "",
      fmt::format(
          "SI makes {:g} for each row, or {:g} if it keeps M^{{−1}}j^{{T}}. A sparse row of A has {:.1f} "
          "entries at base {}. Naive PGS computes all velocities anew for each row (paper 4.4).",
          si_products, si_products_kept, work_of(run.pyramids.back()).sparse / run.pyramids.back().rows,
          run.settings.base));
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
  page.table(parts[3], "products of a sweep",
             {.header = {"", pyramid.name, run.tray.name},
              .rows = {{"sparse A", spaced(work_of(pyramid).sparse), spaced(work_of(run.tray).sparse)},
                       {"SI", spaced(work_of(pyramid).si), spaced(work_of(run.tray).si)}}});
  page.note(parts[4], "", "All boxes push the tray, so all rows meet. The work of SI stays the same.");
}

}  // namespace

List<Shot> cost_shots(const StoredRun& run) {
  return {
      key_shot(run, "memory and work",
               "Two charts against rows, all axes logarithmic. Bytes: a full A rises twice as steeply as a "
               "sparse one and SI. Multiply-adds of a sweep: naive and full A rise with the square, sparse A "
               "and SI lie together.",
               draw_cost),
      key_shot(run, "a scene without zeros",
               "Boxes in a row on one tray; the pattern of a pyramid's A, a thin band, beside that of the "
               "tray with as many rows, which is full.",
               draw_tray)};
}

}  // namespace cairn::stored
