// The rod on its supports, beside the plane of its two lambda.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/question.hpp"
#include "math/list.hpp"
#include "parts.hpp"
#include "plane.hpp"
#include "render/draw.hpp"

namespace cairn::sweeps {

namespace {

using render::fixed;
using render::Page;
using render::Point;
using render::Rect;

using Pair = FixedList<double, 2>;

Pair pair_of(const PerRow<double>& lambda) { return {lambda[0], lambda[1]}; }

/// Beside the upper end of a force, where there is room: left of it if possible.
void label_force(Page& page, const render::Camera& camera, const Vec2<double>& top, const std::string& text) {
  const Point at = camera.project(top);
  render::TextStyle style = page.value();
  style.bold = true;
  style.halo = page.theme().panel;
  const double width = page.canvas().text_width(text, style);
  const double left = at.x() - 14 - width;
  const double right = at.x() + 14;
  page.place_text({{left, at.y() + style.size},
                   {left, at.y()},
                   {left, at.y() - 8},
                   {right, at.y()},
                   {at.x() - width / 2, at.y() - 8},
                   {left, at.y() - 1.8 * style.size},
                   {left, at.y() - 3 * style.size},
                   {right, at.y() + style.size},
                   {at.x() - width / 2, at.y() - 3 * style.size}},
                  camera.viewport, text, style);
}

/// The same for the weight: right of it if possible.
void label_weight(Page& page, const render::Camera& camera, const Vec2<double>& top,
                  const std::string& text) {
  const Point at = camera.project(top);
  render::TextStyle style = page.value();
  style.halo = page.theme().panel;
  const double left = at.x() - 14 - page.canvas().text_width(text, style);
  page.place_text({{at.x() + 14, at.y() + 2 * style.size}, {at.x() + 14, at.y()}, {left, at.y()}},
                  camera.viewport, text, style);
}

/// The rod, what its supports give, its weight; behind it where it goes, if wanted.
void draw_rod(Page& page, const Rect& rect, const SweepRun& run, const Pair& lambda,
              Span<const Snapshot> motion = {}) {
  const Rect inside = page.panel(rect, "forces (N)");
  const render::Camera camera = render::fit(inside, {{-0.75, -0.8}, {rod_length + 0.5, 1.6}});
  page.canvas().push_clip(inside);
  render::WorldLook look;
  look.contacts = false;
  look.numbers = false;
  look.penetration = false;
  if (!motion.empty()) draw_ghosts(page, camera, motion);
  draw_world(page, camera, run.rod.snapshot, look);
  const double largest = std::max({std::abs(run.rod.statics[0]), run.rod.statics[1], rod_mass * gravity});
  const render::ArrowScale scale{
      .pixels_per_unit = 1.25 * camera.scale / largest, .longest = 1.4 * camera.scale, .unit = "N"};
  const double weight = rod_mass * gravity;
  const double shift = std::abs(run.rod.arm[1]) < 0.2 ? -0.2 : 0;  // not upon the push below it
  const Vec2<double> tail(rod_length / 2 + shift, 0.12 + weight / largest * 1.25);
  draw_arrow(page, camera, scale, {.kind = render::ArrowKind::external, .tail = tail, .value = {0, -weight}});
  const Pair place = {0.02, run.settings.support};
  for (const int i : {1, 0}) {
    if (std::abs(lambda[i]) < 0.005) continue;
    const bool pulls = lambda[i] < 0;
    draw_arrow(page, camera, scale,
               {.kind = pulls ? render::ArrowKind::negative_correction : render::ArrowKind::normal,
                .tail = {place[i], pulls ? 0.1 - lambda[i] / largest * 1.25 : 0.1},
                .value = {0, lambda[i]}});
  }
  for (const int i : {1, 0}) {  // when both arrows are there to keep off
    if (std::abs(lambda[i]) < 0.005) continue;
    const double top = 0.1 + std::abs(lambda[i]) / largest * 1.25;
    label_force(page, camera, {place[i], lambda[i] < 0 ? top + 0.2 : top},
                fmt::format("λ_{{{}}} = {}{}", i + 1, brief(lambda[i], 2), lambda[i] < 0 ? ": a pull" : ""));
  }
  label_weight(page, camera, tail, fmt::format("m g = {}", brief(weight)));
  page.canvas().pop_clip();
}

List<Pair> way_of(const Swept& swept, int count) {
  List<Pair> way = {{0, 0}};
  for (int k = 0; k < count; ++k) way.push_back(pair_of(swept.after[k]));
  return way;
}

/// Rod at the top left, plane right; returns what is free below the rod.
Rect draw_rod_moment(Page& page, const SweepRun& run, const Pair& lambda, const PlaneView& view,
                     Span<const Snapshot> motion = {}) {
  const List<Rect> halves = columns(page.area(), {0.57, 0.43}, page.sizes().gap);
  draw_plane(page, halves[1], run, view);
  const List<Rect> left = rows(halves[0], {0.54, 0.46}, page.sizes().gap);
  draw_rod(page, left[0], run, lambda, motion);
  return left[1];
}

/// So many updates of the solve without the clamp as can be told apart.
int visible_updates(const RodRun& rod) { return std::min(rod.unbounded.after.size(), 300); }

void draw_unbounded(Page& page, const SweepRun& run) {
  const RodRun& rod = run.rod;
  const Rect rest =
      draw_rod_moment(page, run, rod.statics, {.other = way_of(rod.unbounded, visible_updates(rod))});
  const Matrix<double>& A = rod.system.A;
  page.equation(
      rest,
      {.number = "eq (14), no bounds",
       .symbols = "A λ = b",
       .numbers = fmt::format("({} {}; {} {}) λ = ({}, {})", brief(A(0, 0)), brief(A(0, 1)), brief(A(1, 0)),
                              brief(A(1, 1)), brief(rod.system.b(0)), brief(rod.system.b(1))),
       .result = fmt::format("λ = ({}, {}) N", brief(rod.statics[0], 2), brief(rod.statics[1], 2)),
       .algorithm = rod.tips() ? "a support that pulls" : "both supports push"});
}

void draw_rod_update(Page& page, const SweepRun& run, int k) {
  const RodRun& rod = run.rod;
  PlaneView view{.way = way_of(rod.bounded, k + 1)};
  const RowUpdate<double>& update = rod.bounded.updates[k];
  view.asked = view.way[k];
  view.asked[update.row] = (update.impulse_before + update.corrective) / run.settings.dt;
  const Rect rest = draw_rod_moment(page, run, pair_of(rod.bounded.after[k]), view);
  page.equation(rest, equation_28(page, rod.system, rod.bounded, k));
}

/// w = A lambda - b of both rows, beside lambda.
void draw_complement(Page& page, const SweepRun& run) {
  const RodRun& rod = run.rod;
  PlaneView view{.way = way_of(rod.bounded, rod.bounded.after.size())};
  view.asked = {rod.formula[0] - rod.leaving[0] / rod.system.A(0, 0), rod.formula[1]};
  const Rect rest = draw_rod_moment(page, run, pair_of(rod.settled.after.back()), view);
  render::TableView table;
  table.header = {"row", "λ (N)", "w = A λ − b (m/s²)", "λ w"};
  for (int i = 0; i < 2; ++i) {
    const double lambda = rod.settled.after.back()[i];
    table.rows.push_back({fmt::format("{}", i + 1), brief(lambda), brief(rod.leaving[i]), "0"});
  }
  table.active_row = rod.tips() ? 0 : -1;
  const List<Rect> parts = rows(rest, {0.56, 0.44}, page.sizes().gap);
  page.table(parts[0], "A contact pushes, or it opens; never both", table);
  page.note(
      parts[1], "",
      "The ellipses are level curves of ½ λ·A λ − b·λ. The answer is its lowest point that is not behind "
      "the wall.");
}

std::string answer_text(const RodRun& rod) {
  if (!rod.tips()) return "Nothing changes. Both push anyway, so the clamp never acts.";
  return fmt::format(
      "{} N, not {}. The right support had to push against the pull as well as against the weight. Without "
      "the "
      "pull, the rod tips about the right support.",
      brief(rod.formula[1], 2), brief(rod.statics[1], 2));
}

Shot rod_update_shot(const Run& run, int k, int first_cut) {
  const Swept& swept = run->rod.bounded;
  const RowUpdate<double>& update = swept.updates[k];
  const bool cut = update.impulse_before + update.corrective < -1e-12;
  return {.state = fmt::format("B · sweep {}/{} · row {} of 2", update.sweep, run->settings.sweeps,
                               update.row + 1),
          .alt = fmt::format("Sweep {}, row {} of the rod: λ is ({:.4g}, {:.4g}) N{}; one more step of the "
                             "zig-zag in the plane.",
                             update.sweep, update.row + 1, swept.after[k][0], swept.after[k][1],
                             cut ? ", the row having been clamped" : ""),
          .draw = [run, k](Page& page) { draw_rod_update(page, *run, k); },
          .key = k == 1 || k == first_cut || k == first_cut + 1};
}

}  // namespace

List<Shot> rod_shots(const Run& run) {
  const Swept& swept = run->rod.bounded;
  int first_cut = 4;  // of a rod that does not tip: any two frames
  for (int k = swept.updates.size() - 1; k >= 0; --k) {
    if (swept.updates[k].impulse_before + swept.updates[k].corrective < -1e-12) first_cut = k;
  }
  List<Shot> shots;
  shots.push_back({.state = "B · without clamp",
                   .alt =
                       "The rod with the pull that A λ = b asks for, and a zig-zag to that answer, through "
                       "the hatched part of the plane where λ is negative.",
                   .draw = [run](Page& page) { draw_unbounded(page, *run); },
                   .key = true});
  for (int k = 0; k < swept.updates.size(); ++k) shots.push_back(rod_update_shot(run, k, first_cut));
  shots.push_back({.state = "B · solved",
                   .alt = "λ and w of both supports: one is zero where the other is not.",
                   .draw = [run](Page& page) { draw_complement(page, *run); },
                   .key = true});
  return shots;
}

Shot question_shot(const Run& run) {
  return cairn::question_shot(
      card(),
      {.state = "before the first sweep",
       .alt = "A rod on two supports, both left of its middle, the forces that "
              "hold it, one of them a pull, and the question.",
       .scene = [run](Page& page, const Rect& rect) { draw_rod(page, rect, *run, run->rod.statics); }});
}

Shot answer_shot(const Run& run) {
  return cairn::answer_shot(
      card(),
      {.state = "answer",
       .alt = "The rod with the push of the right support alone, tipping, and the answer.",
       .scene =
           [run](Page& page, const Rect& rect) {
             const RodRun& rod = run->rod;
             draw_rod(page, rect, *run, rod.formula,
                      rod.tips() ? Span<const Snapshot>(rod.motion) : Span<const Snapshot>());
           }},
      answer_text(run->rod));
}

}  // namespace cairn::sweeps
