// Eight worlds on one page, each with its stamp; and what the numbers of two pins tell.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "math/list.hpp"
#include "parts.hpp"
#include "render/draw.hpp"
#include "render/lint.hpp"
#include "render/plot.hpp"

namespace cairn::edges {

namespace {

using render::fixed;
using render::Page;
using render::Point;
using render::Rect;

/// A word in a box: the better the paler.
void draw_stamp(Page& page, const Point& right_base, Stamp stamp) {
  render::TextStyle text = page.tick();
  text.bold = true;
  text.align = render::Align::right;
  const render::Theme& theme = page.theme();
  const render::Color fill = stamp == Stamp::ok     ? theme.panel
                             : stamp == Stamp::soft ? theme.body
                                                    : theme.text;
  if (stamp != Stamp::ok) text.color = stamp == Stamp::soft ? render::ink_on(fill) : theme.panel;
  text.halo = fill;
  const std::string word = stamp_text(stamp);
  const double width = page.canvas().text_width(word, text) + 10;
  page.canvas().rect({right_base.x() - width, right_base.y() - 1.05 * text.size, width, 1.45 * text.size},
                     {.fill = fill, .outline = theme.text, .outline_width = page.sizes().axis}, 3);
  page.canvas().text({right_base.x() - 5, right_base.y()}, word, text);
}

/// The worst of all steps so far.
double off_so_far(const EdgeCase& edge, int step) {
  const auto begin = edge.off_by_step.begin();
  return *std::max_element(begin, begin + step + 1);
}

/// The stamp that the world would have, had it ended here; its energy is judged at the end.
Stamp stamp_so_far(const EdgeCase& edge, int step) {
  if (step + 1 >= edge.frames.size()) return edge.stamp;
  EdgeCase so_far{.off = off_so_far(edge, step)};
  return stamp_of(so_far);
}

/// Where the last body has been, each place as a ring: what is fast is seen nowhere else.
void draw_places(Page& page, const render::Camera& camera, const EdgeCase& edge, int step) {
  const SnapshotBody& body = edge.frames[0].bodies.back();
  const double radius = std::max(2.0, bounding_radius(body.shapes[0]) * camera.scale);
  const int first = step > 40 ? step - 40 : 0;
  for (int k = first; k < step; ++k) {
    const Vec2<double>& at = edge.frames[k].bodies.back().pose.position;
    page.canvas().circle(camera.project(at), radius,
                         {.outline = page.theme().inactive, .outline_width = page.sizes().ghost});
  }
}

/// A dashed line where the top of a stack belongs.
void draw_top(Page& page, const render::Camera& camera, const EdgeCase& edge) {
  const Point left = camera.project({edge.view.lower.x(), edge.top});
  const Point right = camera.project({edge.view.upper.x(), edge.top});
  page.canvas().line(left, right, {.width = 2, .color = page.theme().normal, .dash = {6, 4}});
}

/// What a share of something is called: 7.3 %, or 227 times.
std::string share_text(double share) {
  if (share < 1e-9) return "0 %";
  if (share <= 9.995) return fixed(100 * share, share < 0.0995 ? 1 : 0) + " %";
  return share < 9999 ? fixed(share, 0) + " ×" : "> 9999 ×";
}

void draw_edge(Page& page, const Rect& rect, const EdgeCase& edge, int which, int step) {
  const bool is_cut = edge.top > edge.view.upper.y() - edge.view.lower.y();
  const Rect inside = page.panel(rect, edge.name + (is_cut ? ", its upper end" : ""));
  const double line = 1.6 * page.sizes().tick;
  const Rect view = {inside.x, inside.y, inside.width, inside.height - line - 2};
  const render::Camera camera = render::fit(view, edge.view);
  page.canvas().push_clip(view);
  if (which == ball || which == fast_ball || which == sling) draw_places(page, camera, edge, step);
  const render::WorldLook look{.numbers = false,
                               .names = {"", which == pin ? "body" : "", "ball"},
                               .contacts = false,
                               .penetration = false};
  draw_world(page, camera, edge.frames[step], look);
  if (edge.top > 0) draw_top(page, camera, edge);
  page.canvas().pop_clip();
  if (which == pin) page.avoid({camera.project({-0.1, 0}), camera.project({edge.view.upper.x(), 0})});
  if (which == ball) page.avoid({camera.project({0, -1}), camera.project({0, 1})});  // the wall
  if (which == ball || which == pin) draw_unseen(page, camera, edge.frames[step], look);
  const double base = inside.y + inside.height - 0.35 * page.sizes().tick;
  const bool has_room = inside.width > 15 * page.sizes().tick;
  const bool tells_energy =
      has_room && step + 1 == edge.frames.size() && edge.energy_gain > 0.01 && edge.off <= 9;
  std::string text = share_text(off_so_far(edge, step));
  if (tells_energy) text += ", energy +" + share_text(edge.energy_gain);
  if (!tells_energy) text = "off " + text;
  page.canvas().text({inside.x, base}, text, page.tick());
  draw_stamp(page, {inside.x + inside.width, base}, stamp_so_far(edge, step));
}

void draw_wall(Page& page, const ExtremesRun& run, int step) {
  const List<Rect> lines = rows(page.area(), {1, 1, 0.05}, page.sizes().gap);
  page.canvas().text(
      {lines[2].x, lines[2].y + page.sizes().tick},
      "OK: off by at most 1 %.  SOFT: by at most its own size.  BROKEN: by more, or with more than "
      "1 % of energy from nowhere.  Dashed: the right height.",
      page.tick());
  for (int i = 0; i < run.wall.size(); ++i) {
    const List<Rect> panels = columns(lines[i / 4], {1, 1, 1, 1}, page.sizes().gap);
    draw_edge(page, panels[i % 4], run.wall[i], i, step);
  }
}

Shot wall_shot(const Run& run, int step) {
  std::string alt = fmt::format("Eight small worlds after step {}:", step);
  for (const EdgeCase& edge : run->wall)
    alt += fmt::format(" {}: {};", edge.name, stamp_text(stamp_so_far(edge, step)));
  alt.back() = '.';
  return {.state = fmt::format("eight worlds · step {}", step), .alt = alt, .draw = [run, step](Page& page) {
            draw_wall(page, *run, step);
          }};
}

/// What the two pins give: the picture of them stands still.
void draw_quarrel(Page& page, const Rect& rect, const ExtremesRun& run) {
  render::Plot plot{.title = "two pins: what each pulls with (kN)"};
  plot.x = {.title = "step", .min = 0, .max = run.settings.steps};
  plot.y = {.title = ""};
  List<double> measured, formula;  // [kN]
  for (const double given : quarrel(run.wall[two_pins])) {
    formula.push_back(std::abs(quarrel_by_formula(run.settings, measured.size())) / 1000);
    measured.push_back(std::abs(given) / 1000);
  }
  plot.series = {over_steps("formula", page.theme().exact, formula),
                 over_steps("SI", page.theme().si, measured)};
  plot.series[0].markers = false;
  draw_plot(page, rect, plot);
}

void draw_numbers(Page& page, const ExtremesRun& run) {
  const List<Rect> halves = columns(page.area(), {0.66, 0.34}, page.sizes().gap);
  const List<Rect> left = rows(halves[0], {0.6, 0.4}, page.sizes().gap);
  draw_quarrel(page, left[0], run);
  page.note(halves[1], "How you notice",
            "A picture shows that the body is off one pin, by their whole distance. It stands still, as if "
            "it were at rest.\n\nWhat no picture shows: in every sweep one pin pulls by "
            "m\u00a0β\u00a0d\u00a0/\u00a0Δt², and the "
            "other pulls back. No λ satisfies both, so λ grows for ever.");
  render::TableView table;
  table.header = {"asked for", "what the program answers"};
  for (const Refusal& refusal : run.refusals) {
    const std::size_t cut = refusal.message.find(": ");
    table.rows.push_back({refusal.asked, refusal.message.substr(cut == std::string::npos ? 0 : cut + 2)});
  }
  table.text_columns = 2;
  page.table(left[1], "", table);
}

}  // namespace

List<Shot> wall_shots(const Run& run) {
  const int last = run->settings.steps;
  const std::set<int> keys = {3, 10, last};
  List<Shot> shots;
  for (int step = 0; step <= last; ++step) {
    shots.push_back(wall_shot(run, step));
    shots.back().key = keys.contains(step);
  }
  shots.push_back({.state = "what pictures do not show",
                   .alt = "Two pins pull at one body that stands still: what each gives grows by as much in "
                          "every step, for ever. Below, scenes that are refused, and the messages.",
                   .draw = [run](Page& page) { draw_numbers(page, *run); },
                   .key = true});
  return shots;
}

}  // namespace cairn::edges
