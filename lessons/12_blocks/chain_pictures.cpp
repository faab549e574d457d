// Three welded beams as sweeps go by, and where blocks help.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "math/list.hpp"
#include "parts.hpp"
#include "render/draw.hpp"
#include "render/matrix.hpp"
#include "render/plot.hpp"

namespace cairn::blocks {

namespace {

using render::Page;
using render::Rect;

const PerBody<Vec3<double>>& velocity_after(const ChainSolve& solve, int sweep) {
  return solve.velocity[std::min(sweep, solve.sweeps)];
}

void draw_wall(Page& page, const render::Camera& camera) {
  const render::Point wall = camera.project({-0.2, 0.35});
  const render::Point corner = camera.project({0, -0.35});
  page.canvas().rect(
      {wall.x(), wall.y(), corner.x() - wall.x(), corner.y() - wall.y()},
      {.fill = page.theme().static_body, .outline = page.theme().outline, .outline_width = 1.5});
}

/// Three beams before the first sweep, and what is known of their sweeps.
void draw_question(Page& page, const BlocksRuns& all, const std::string& question) {
  const List<Rect> parts = rows(page.area(), {0.54, 0.46}, page.sizes().gap);
  const Rect inside = page.panel(parts[0], "each welded to the one before, and the first to a wall");
  const render::Camera camera = render::fit(inside, {{-0.25, -0.4}, {3.15, 0.4}});
  draw_wall(page, camera);
  Snapshot start = all.chains[welded_three].start;
  start.joints.clear();
  render::WorldLook look;
  look.contacts = false;
  look.penetration = false;
  draw_world(page, camera, start, look);
  const List<Rect> below = columns(parts[1], {0.42, 0.58}, page.sizes().gap);
  render::TableView table{.header = {"sweeps to 1 %", "rows", "blocks"}};
  for (const int chain : {welded_one, welded_three}) {
    const ChainRun& run = all.chains[chain];
    table.rows.push_back({run.name, fmt::format("{}", run.rows.sweeps),
                          chain == welded_three ? "?" : fmt::format("{}", run.blocks.sweeps)});
  }
  table.active_row = 1;
  page.table(below[0], "", table);
  page.note(below[1], "The question", question);
}

/// The beams where their velocities after these sweeps would lead within a second; solved, they stay level.
void draw_beams(Page& page, const Rect& rect, const ChainRun& chain, const ChainSolve& solve, int sweep,
                const std::string& name, const render::SeriesStyle& style) {
  const int done = std::min(sweep, solve.sweeps);
  const double error = solve.error[done];
  const Rect inside = page.panel(
      rect, fmt::format("{}: {} sweep{}, error {} %{}", name, done, done == 1 ? "" : "s",
                        render::fixed(100 * error, error < 0.02 ? 1 : 0), error <= goal ? ", done" : ""));
  page.canvas().rect({rect.x, rect.y, rect.width, 4}, {.fill = style.color});
  const render::Camera camera = render::fit(inside, {{-0.25, -0.62}, {3.15, 0.38}});
  page.canvas().push_clip(inside);
  draw_wall(page, camera);
  draw_ghosts(page, camera, List<Snapshot>{chain.start});
  Snapshot moved = chain.start;
  moved.joints.clear();
  for (const BodyId body : moved.bodies.indices()) {
    if (body == ground) continue;
    const Vec3<double>& v = velocity_after(solve, done)[body];
    moved.bodies[body].pose.position += v.head<2>();
    moved.bodies[body].pose.angle += v.z();
  }
  render::WorldLook look;
  look.contacts = false;
  look.penetration = false;
  draw_world(page, camera, moved, look);
  page.canvas().pop_clip();
}

void draw_errors(Page& page, const Rect& rect, const ChainRun& chain, int sweep) {
  render::Plot plot{.title = "largest error of λ"};
  plot.x = {.title = "sweep", .scale = render::AxisScale::logarithmic, .min = 1, .max = chain.rows.sweeps};
  plot.y = {.title = "", .scale = render::AxisScale::logarithmic, .min = 0.003, .max = 2};
  const auto add = [&](const std::string& name, const ChainSolve& solve, const render::SeriesStyle& style) {
    render::Series series{.name = name, .style = style};
    for (int k = 1; k <= solve.sweeps; ++k) {
      series.x.push_back(k);
      series.y.push_back(solve.error[k]);
    }
    plot.series.push_back(series);
  };
  add("rows", chain.rows, style_of_rows(page));
  add("blocks", chain.blocks, style_of_blocks(page));
  plot.goals.push_back({goal, "1 %"});
  plot.now = sweep;
  draw_plot(page, rect, plot);
}

void draw_chain(Page& page, const ChainRun& chain, int sweep) {
  const List<Rect> parts = rows(page.area(), {0.46, 0.54}, page.sizes().gap);
  const List<Rect> top = columns(parts[0], {0.5, 0.5}, page.sizes().gap);
  draw_both_beams(page, {top[0], top[1]}, chain, sweep);
  draw_errors(page, parts[1], chain, sweep);
}

/// A of three beams: what a block settles stands in the frames on the diagonal, what it cannot beside them.
void draw_system(Page& page, const Rect& rect, const ChainRun& chain) {
  render::MatrixView view{.title = "A of three welded beams (1/kg), 3 rows a weld", .values = chain.A};
  for (int weld = 1; weld <= 3; ++weld) {
    for (const char* name : {"x", "y", "θ"}) {
      view.row_names.push_back(fmt::format("{}_{{{}}}", name, weld));
      view.column_names.push_back(view.row_names.back());
    }
  }
  view.column_group = 3;
  draw_matrix(page, rect, view);
}

void draw_table(Page& page, const BlocksRuns& all) {
  const List<Rect> halves = columns(page.area(), {0.46, 0.54}, page.sizes().gap);
  const List<Rect> left = rows(halves[0], {0.54, 0.46}, page.sizes().gap);
  render::TableView table;
  table.header = {"scene", "rows", "blocks", "work, blocks / rows"};
  for (const ChainRun& chain : all.chains) {
    const double ratio = static_cast<double>(chain.blocks.work) / static_cast<double>(chain.rows.work);
    table.rows.push_back({chain.name, fmt::format("{}", chain.rows.sweeps),
                          fmt::format("{}", chain.blocks.sweeps), render::fixed(ratio, 2)});
  }
  page.table(left[0], "sweeps until no λ is wrong by more than 1 %", table);
  page.note(left[1], "Where blocks help",
            "A block settles its square on the diagonal at once. In this chain only the first "
            "square has rows that couple; all else is between the joints and takes its "
            "sweeps. Oblique pins couple more, level ones not at all.");
  draw_system(page, halves[1], all.chains[welded_three]);
}

}  // namespace

void draw_both_beams(Page& page, const FixedList<Rect, 2>& rects, const ChainRun& chain, int sweep) {
  draw_beams(page, rects[0], chain, chain.rows, sweep, "rows", style_of_rows(page));
  draw_beams(page, rects[1], chain, chain.blocks, sweep, "blocks", style_of_blocks(page));
}

Shot question_shot(const Runs& all, const std::string& question) {
  return {
      .state = "before the first sweep",
      .alt =
          "Three beams, each welded to the one before and the first to a wall, a table of sweeps with one "
          "number missing, and the question.",
      .draw = [all, question](Page& page) { draw_question(page, *all, question); },
      .key = true};
}

List<Shot> chain_shots(const Runs& all) {
  const ChainRun& chain = all->chains[welded_three];
  std::set<int> sweeps = {1, 2, 5, 10, 20, 50, 100, 200};
  sweeps.insert({chain.blocks.sweeps, chain.rows.sweeps});
  List<Shot> shots;
  for (const int sweep : sweeps) {
    const auto error = [&](const ChainSolve& solve) {
      return 100 * solve.error[std::min(sweep, solve.sweeps)];
    };
    shots.push_back(
        {.state = fmt::format("B · three beams · sweep {}", sweep),
         .alt = fmt::format("Three welded beams after {} sweeps: the largest error is {:.1f} % row by "
                            "row and {:.1f} % with blocks.",
                            sweep, error(chain.rows), error(chain.blocks)),
         .draw = [all, sweep](Page& page) { draw_chain(page, all->chains[welded_three], sweep); },
         .key = sweep == 10 || sweep == chain.rows.sweeps});
  }
  shots.push_back({.state = "B · all chains and a tower",
                   .alt = "A table of sweeps to 1 % by rows and by blocks, for chains of beams and a tower.",
                   .draw = [all](Page& page) { draw_table(page, *all); },
                   .key = true});
  return shots;
}

}  // namespace cairn::blocks
