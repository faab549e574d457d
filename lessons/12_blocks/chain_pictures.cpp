// Three welded beams, their A, and the bars of the question.
#include "lesson.hpp"

namespace cairn::blocks {

namespace {

void draw_wall(Page& page, const Camera& camera) {
  const List<Point> wall = {camera.project({-0.2, -0.35}), camera.project({0, -0.35}),
                            camera.project({0, 0.35}), camera.project({-0.2, 0.35})};
  page.canvas().polygon(wall, {.fill = page.theme().static_body,
                               .outline = page.theme().outline,
                               .outline_width = page.sizes().outline});
  page.canvas().hatch(wall, {.width = 1, .color = page.theme().static_hatch}, page.sizes().hatch_pitch);
}

void draw_errors(Page& page, const Rect& rect, const ChainRun& chain) {
  Plot plot{.title = "largest error of λ, as a part of the largest λ (moments in N m, forces in N)"};
  plot.x = {.title = "sweep", .min = 0, .max = 1.1 * chain.rows.sweeps};
  plot.y = {.scale = AxisScale::logarithmic, .min = 0.003, .max = 2};
  const auto add = [&](const std::string& name, const ChainSolve& solve, const SeriesStyle& style) {
    plot.series.push_back(over_steps(name, style, solve.error));
    plot.labels.push_back({0.98 * solve.sweeps, 0.6 * goal, fmt::format("{} sweeps", solve.sweeps)});
  };
  add("rows", chain.rows, style_of_rows(page));
  add("blocks", chain.blocks, style_of_blocks(page));
  plot.goals.push_back({goal, "1 %"});
  draw_plot(page, rect, plot);
}

/// One entry of A with its number: in the blocks' colour where a block settles it.
void draw_entry(Page& page, const Rect& cell, double value, bool in_block) {
  const Color color = in_block ? style_of_blocks(page).color : page.theme().inactive;
  page.canvas().rect(cell, {.fill = value == 0 ? page.theme().panel : faded(color, 0.3),
                            .outline = page.theme().grid,
                            .outline_width = 1});
  TextStyle text = page.value();
  text.size = 0.26 * cell.height;
  text.align = Align::center;
  if (value != 0)
    page.canvas().text({cell.x + cell.width / 2, cell.y + 0.6 * cell.height}, significant(value, 3), text);
}

/// A of three beams: what a block settles stands in the frames on the diagonal, what it cannot beside them.
void draw_system(Page& page, const Rect& rect, const ChainRun& chain) {
  const Rect inside = page.panel(rect, "matrix A of three welded beams: λ of x and y in N, of θ in N m");
  const double size = (inside.height - 24) / 9;
  const double left = inside.x + 32;
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 9; ++j) {
      const double value = std::abs(chain.A(i, j)) < 1e-9 ? 0 : chain.A(i, j);
      draw_entry(page, {left + j * size, inside.y + i * size, size, size}, value, i / 3 == j / 3);
    }
    const std::string name = fmt::format("{}_{{{}}}", i % 3 == 0 ? "x" : i % 3 == 1 ? "y" : "θ", i / 3 + 1);
    page.canvas().text({inside.x, inside.y + (i + 0.6) * size}, name, page.label());
    page.canvas().text({left + (i + 0.35) * size, inside.y + inside.height - 4}, name, page.label());
  }
  for (int weld = 0; weld < 3; ++weld)
    page.canvas().rect({left + 3 * weld * size, inside.y + 3 * weld * size, 3 * size, 3 * size},
                       {.outline = style_of_blocks(page).color, .outline_width = 4});
}

void draw_chain(Page& page, const BlocksRuns& all) {
  const List<Rect> parts = in_rows(page, {0.3, 0.7});
  draw_start(page, parts[0], all.chains[welded_three]);
  draw_errors(page, parts[1], all.chains[welded_three]);
}

void draw_inside(Page& page, const BlocksRuns& all) {
  const List<Rect> parts = in_columns(page, {0.55, {0.45, {0.35, 0.65}}});
  draw_system(page, parts[0], all.chains[welded_three]);
  draw_start(page, parts[1], all.chains[welded_three]);
  page.card(
      parts[2], "What a block settles",
      "Its square on the diagonal. Only in the first square do rows couple: y with θ, at the wall. All else "
      "stands beside the squares, between the joints, and takes its sweeps.");
}

}  // namespace

void draw_start(Page& page, const Rect& rect, const ChainRun& chain) {
  const Rect inside = page.panel(rect, "each welded to the one before, and the first to a wall");
  const int beams = chain.start.bodies.size() - 1;  // body 0 is the wall
  const Camera camera = fit(inside, {{-0.25, -0.4}, {beams * beam_length + 0.15, 0.4}});
  draw_wall(page, camera);
  Snapshot start = chain.start;
  start.joints.clear();
  draw_world(page, camera, start, {.contacts = false, .penetration = false});
}

void draw_sweep_bars(Page& page, const Rect& rect, const BlocksRuns& all, bool asked) {
  const Rect inside = page.panel(rect, "sweeps with blocks, as a share of those row by row");
  List<int> shown = {welded_one, welded_two, welded_three, welded_ten};
  if (asked) shown = {welded_one, welded_ten};
  const double pitch = inside.height / shown.size();
  TextStyle numbers = page.value(), name = page.label();
  numbers.size = name.size = 1.2 * page.value().size;
  numbers.align = Align::right;
  const double left = 6 * name.size, right = 14.5 * name.size;
  for (int line = 0; line < shown.size(); ++line) {
    const ChainRun& chain = all.chains[shown[line]];
    const bool hidden = asked && shown[line] == welded_ten;
    const double middle = inside.y + pitch * (line + 0.5), base = middle + 0.35 * name.size;
    const int beams = chain.start.bodies.size() - 1;  // body 0 is the wall
    page.canvas().text({inside.x, base}, fmt::format("{} beam{}", beams, beams == 1 ? "" : "s"), name);
    page.canvas().text({inside.x + inside.width, base},
                       hidden ? fmt::format("? of {} = ? %", chain.rows.sweeps)
                              : fmt::format("{} of {} = {} %", chain.blocks.sweeps, chain.rows.sweeps,
                                            fixed(share_left(chain), 0)),
                       numbers);
    Rect bar = {inside.x + left, middle - 0.3 * pitch, inside.width - left - right, 0.6 * pitch};
    page.canvas().rect(bar, {.fill = faded(style_of_rows(page).color, 0.35)});
    bar.width *= share_left(chain) / 100;
    if (!hidden) page.canvas().rect(bar, {.fill = style_of_blocks(page).color});
  }
}

List<Shot> chain_shots(const BlocksRuns& all) {
  const ChainRun& chain = all.chains[welded_three];
  return {key_shot(all, "beams · three, welded",
                   fmt::format(
                       "Three welded beams, and their largest error against sweeps: 1 % after {} row by row, "
                       "after {} with blocks.",
                       chain.rows.sweeps, chain.blocks.sweeps),
                   draw_chain),
          key_shot(all, "beams · A",
                   "A of three welded beams with the square of each weld framed: only in the first square is "
                   "there an entry beside the diagonal.",
                   draw_inside)};
}

}  // namespace cairn::blocks
