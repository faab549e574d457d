// Memory and work against the number of rows, and a scene where A has no zeros.
#include <fmt/format.h>

#include "lessons/question.hpp"
#include "math/list.hpp"
#include "parts.hpp"
#include "render/draw.hpp"
#include "render/plot.hpp"

namespace cairn::stored {

namespace {

using render::Page;
using render::Rect;

render::SeriesStyle sparse_style(const Page& page) {
  return {page.theme().outline, {2, 5}, render::Marker::diamond};
}

render::SeriesStyle naive_style(const Page& page) {
  return {page.theme().external, {10, 5, 2, 5}, render::Marker::triangle};
}

/// A number of each pyramid against its rows.
template <typename Number>
render::Series series_of(const StoredRun& run, const std::string& name, const render::SeriesStyle& style,
                         const Number& number) {
  render::Series series{.name = name, .style = style};
  for (const Count& count : run.pyramids) {
    series.x.push_back(count.rows);
    series.y.push_back(number(count));
  }
  return series;
}

/// The largest pyramid allowed has 968 rows.
render::Plot rows_plot(const std::string& title) {
  render::Plot plot{.title = title};
  plot.x = {.title = "rows m", .scale = render::AxisScale::logarithmic, .min = 10, .max = 1000};
  plot.y = {.scale = render::AxisScale::logarithmic};
  return plot;
}

void draw_memory(Page& page, const StoredRun& run) {
  const List<Rect> parts = columns(page.area(), {0.6, 0.4}, page.sizes().gap);
  render::Plot plot = rows_plot("A in memory (bytes)");
  plot.series = {
      series_of(run, "full A", page.theme().pgs, [](const Count& count) { return 8 * count.dense; }),
      series_of(run, "sparse A", sparse_style(page), [](const Count& count) { return 12 * count.pairs; }),
      series_of(run, "SI", page.theme().si, [](const Count& count) { return 8 * count.rows; })};
  plot.y.min = 100;
  draw_plot(page, parts[0], plot);
  const List<Rect> right = rows(parts[1], {0.42, 0.58}, page.sizes().gap);
  render::TableView table{.header = {fmt::format("base {}", run.settings.base), "in all"}};
  for (const Kept& kept : run.kept) table.rows.push_back({kept.name, bytes_text(kept.bytes)});
  page.table(right[0], "", table);
  page.note(right[1], "",
            "A full A takes four times the memory for twice the rows; the others take twice. "
            "An entry of a sparse A has its column beside it, 12 bytes. The table is what each "
            "solver really keeps beside the rows, J included.",
            question_growth);
}

void draw_work(Page& page, const StoredRun& run) {
  const List<Rect> parts = columns(page.area(), {0.6, 0.4}, page.sizes().gap);
  render::Plot plot = rows_plot("multiply-adds of one sweep");
  plot.series = {
      series_of(run, "naive", naive_style(page), [](const Count& count) { return work_of(count).naive; }),
      series_of(run, "full A", page.theme().pgs, [](const Count& count) { return work_of(count).dense; }),
      series_of(run, "sparse A", sparse_style(page),
                [](const Count& count) { return work_of(count).sparse; }),
      series_of(run, "SI", page.theme().si, [](const Count& count) { return work_of(count).si; })};
  draw_plot(page, parts[0], plot);
  const Work work = work_of(run.pyramids.back());
  page.note(parts[1], "Work",
            fmt::format("SI reads the velocities of two bodies and changes them: 12 for each row, always. "
                        "A sparse row of A has {:.1f} entries here. Naive is section 4.4's warning: all "
                        "velocities anew after every row.",
                        work.sparse / run.pyramids.back().rows),
            question_growth);
}

void draw_tray(Page& page, const StoredRun& run) {
  const List<Rect> parts = rows(page.area(), {0.42, 0.58}, page.sizes().gap);
  const Rect inside = page.panel(parts[0], "");
  const render::Camera camera = render::fit(inside, {{-5.9, -0.4}, {5.9, 1.8}});
  render::WorldLook look;
  look.penetration = false;
  draw_world(page, camera, run.tray_snapshot, look);
  const List<Rect> below = columns(parts[1], {0.45, 0.55}, page.sizes().gap);
  render::TableView table{.header = {"", "base 10", "tray"}};
  const Count& pyramid = run.pyramids[2];
  const auto line = [&](const char* name, double first, double second) {
    table.rows.push_back({name, fmt::format("{:.0f}", first), fmt::format("{:.0f}", second)});
  };
  line("rows m", pyramid.rows, run.tray.rows);
  line("full A", pyramid.dense, run.tray.dense);
  line("not zero", pyramid.non_zeros, run.tray.non_zeros);
  line("(30)", pyramid.printed, run.tray.printed);
  line("sparse A, a sweep", work_of(pyramid).sparse, work_of(run.tray).sparse);
  line("SI, a sweep", work_of(pyramid).si, work_of(run.tray).si);
  page.table(below[0], "", table);
  page.note(below[1], "All on one body",
            "99 boxes on one tray that can move, with as many rows as the pyramid of base 10. "
            "All of them push the tray, so all rows meet, and no entry of A is zero. SI does "
            "not notice: its work is the same for every scene of 200 rows.",
            question_growth);
}

}  // namespace

List<Shot> cost_shots(const Run& run) {
  return {
      {.state = "memory",
       .alt = "Bytes against rows, both logarithmic: a full A rises twice as steeply as a sparse one and "
              "SI.",
       .draw = [run](Page& page) { draw_memory(page, *run); },
       .key = true},
      {.state = "work",
       .alt = "Multiply-adds of a sweep against rows: naive and full A rise with the square, sparse A and SI "
              "lie together.",
       .draw = [run](Page& page) { draw_work(page, *run); },
       .key = true},
      {.state = "a scene without zeros",
       .alt = "Boxes in a row on one tray, and its counts beside those of a pyramid with as many rows.",
       .draw = [run](Page& page) { draw_tray(page, *run); },
       .key = true}};
}

}  // namespace cairn::stored
