// The box on its feet, visit by visit, with the clamp on each push and on the sum side by side.
#include "parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lessons/question.hpp"
#include "math/list.hpp"
#include "render/bars.hpp"
#include "render/draw.hpp"

namespace cairn::feet {

namespace {

using render::fixed;
using render::Page;
using render::Point;
using render::Rect;
using render::Sign;

/// How fast a foot moves, beside the box: an arrow, and its value below.
void draw_foot_velocity(Page& page, const render::Camera& camera, double fastest, double x, double velocity) {
  const render::ArrowScale scale{
      .pixels_per_unit = 0.6 * camera.scale / fastest, .longest = 0.7 * camera.scale, .unit = "m/s"};
  if (std::abs(velocity) * scale.pixels_per_unit >= 2) {
    draw_arrow(page, camera, scale,
               {.kind = render::ArrowKind::velocity,
                .tail = {x, velocity > 0 ? 0.4 : 0.4 - 0.6 * velocity / fastest},
                .value = {0, velocity}});
  }
  render::TextStyle style = page.value();
  style.align = render::Align::center;
  style.color = page.theme().secondary_text;
  page.canvas().text(camera.project({x, 0.2}), fixed(cleaned(velocity), 2, Sign::always) + " m/s", style);
}

/// The sum of a foot at the tip of its arrow, where there is room.
void label_sum(Page& page, const render::Camera& camera, const Vec2<double>& tip, double value, bool lit) {
  if (value < 0.005) return;
  render::TextStyle style = page.value();
  style.bold = lit;
  style.halo = page.theme().body;
  const Point at = camera.project(tip);
  const std::string text = fixed(value, 2);
  const double width = page.canvas().text_width(text, style);
  const double above = at.y() - 6;
  const double middle = at.x() - width / 2;
  const double inwards = tip.x() < 0 ? 3.0 : -6.0;
  page.place_text({{middle + inwards, above},
                   {at.x() + 8, at.y() + style.size},
                   {at.x() - 8 - width, at.y() + style.size},
                   {middle, above - 1.3 * style.size},
                   {middle, above - 2.6 * style.size},
                   {at.x() + 8, at.y() + 2.4 * style.size}},
                  camera.viewport, text, style);
}

render::BarChart sums_of(const Page& page, const FeetRun& run, const Landing& landing, int k) {
  const Visit& visit = landing.visits[k];
  const double largest = std::max(run.middle.exact[0], visit.after[0]);
  render::BarChart chart{.title = "sum of the pushes p (N s)",
                         .largest = 1.3 * std::max(largest, run.middle.exact[0] * 1.45)};
  chart.color = style_of(page.theme(), landing.clamped).color;
  for (int i = 0; i < 2; ++i) {
    const bool active = i == visit.foot && std::abs(visit.given()) > 0.005;
    chart.bars.push_back({.name = fmt::format("foot {}", i + 1),
                          .before = visit.before[i],
                          .added = visit.after[i] - visit.before[i],
                          .exact = run.middle.exact[i],
                          .active = active});
  }
  return chart;
}

render::Equation equation_of(const Page& page, const Landing& landing, int k) {
  const Visit& visit = landing.visits[k];
  const int foot = visit.foot;
  const std::string before = fixed(visit.before[foot], 2);
  const std::string asked = fixed(std::abs(cleaned(visit.asked)), 2);
  const char* sign = cleaned(visit.asked) < 0 ? "−" : "+";
  const std::string p = fmt::format("p_{{{}}}", foot + 1);
  render::Equation equation;
  equation.number = fmt::format("(22): p_{{corr}} = {} N s", fixed(cleaned(visit.asked), 2, Sign::always));
  if (landing.clamped == Clamped::increment) {
    equation.symbols = fmt::format("{} ← {} + max(0, p_{{corr}})", p, p);
    equation.numbers = fmt::format("= {} + max(0, {}{})", before, cleaned(visit.asked) < 0 ? "−" : "", asked);
  } else {
    equation.symbols = fmt::format("{} ← max(0, {} + p_{{corr}})", p, p);
    equation.numbers = fmt::format("= max(0, {} {} {})", before, sign, asked);
  }
  equation.result = fmt::format("= {} N s", fixed(visit.after[foot], 2));
  equation.color = style_of(page.theme(), landing.clamped).color;
  return equation;
}

double largest_of(const FeetRun& run) {
  return std::max({run.middle.by(Clamped::increment).impulse[0], run.middle.exact[0], run.middle.exact[1]});
}

BoxView view_after(const BoxRun& box, double speed, const Landing& landing, int visit) {
  const Visit& last = landing.visits[visit];
  BoxView view{.impulse = last.after, .foot = last.foot, .before = last.before[last.foot]};
  view.foot_velocity = {-speed + box.A11 * last.after[0] + box.A12 * last.after[1],
                        -speed + box.A12 * last.after[0] + box.A22 * last.after[1]};
  view.fastest = speed;
  return view;
}

void draw_visit(Page& page, const FeetRun& run, int k) {
  const List<Rect> halves = columns(page.area(), {0.5, 0.5}, page.sizes().gap);
  int at = 0;
  for (const Clamped clamped : {Clamped::increment, Clamped::sum}) {
    const Landing& landing = run.middle.by(clamped);
    const List<Rect> parts = rows(halves[at++], {0.44, 0.24, 0.32}, page.sizes().gap);
    draw_box(page, clamp_panel(page, parts[0], clamped), run.middle, largest_of(run),
             view_after(run.middle, run.settings.speed, landing, k));
    draw_bars(page, parts[1], sums_of(page, run, landing, k));
    page.equation(parts[2], equation_of(page, landing, k));
  }
}

QuestionFrame question_frame(const Run& run) {
  return {.state = "after one sweep",
          .alt =
              "A box on two feet after one sweep, with the impulses of its feet and how fast they move, and "
              "the question.",
          .scene = [run](Page& page, const Rect& rect) {
            draw_box(page, page.panel(rect, "after one sweep: pushes (N s)"), run->middle, largest_of(*run),
                     view_after(run->middle, run->settings.speed, run->middle.by(Clamped::sum), 1));
          }};
}

QuestionFrame answer_frame(const Run& run) {
  return {.state = "sweep 2 · foot 1",
          .alt =
              "The second visit of the left foot: with each push clamped nothing is taken back, with the "
              "sum clamped a part of the first push; and the answer.",
          .scene = [run](Page& page, const Rect& rect) {
            const List<Rect> parts = rows(rect, {0.5, 0.5}, page.sizes().gap);
            int at = 0;
            for (const Clamped clamped : {Clamped::increment, Clamped::sum}) {
              draw_box(page, clamp_panel(page, parts[at++], clamped), run->middle, largest_of(*run),
                       view_after(run->middle, run->settings.speed, run->middle.by(clamped), 2));
            }
          }};
}

std::string answer_text(const FeetRun& run) {
  const Visit& second = run.middle.by(Clamped::sum).visits[2];
  const std::string sum = fixed(second.after[0], 2) + " N s: ";
  if (second.given() >= 0) return sum + "it gives more. Feet so far out need the same of both clamps.";
  return sum + "it takes back " + fixed(-second.given(), 2) +
         " N s of its first push, which was too large. A push may be negative; the sum may not.";
}

Shot visit_shot(const Run& run, int k) {
  const Visit& naive = run->middle.by(Clamped::increment).visits[k];
  const Visit& sum = run->middle.by(Clamped::sum).visits[k];
  return {.state = fmt::format("sweep {}/{} · foot {}", sum.sweep, run->settings.sweeps, sum.foot + 1),
          .alt = fmt::format("Sweep {}, foot {}: with each push clamped it gives {:.2f} N s, with the sum "
                             "clamped {:.2f} N s; boxes, sums and both formulas side by side.",
                             sum.sweep, sum.foot + 1, naive.given(), sum.given()),
          .draw = [run, k](Page& page) { draw_visit(page, *run, k); },
          .key = k < 4 || k + 1 == run->middle.by(Clamped::sum).visits.size()};
}

List<Shot> visit_shots(const Run& run) {
  List<Shot> shots;
  for (int k = 0; k < run->middle.by(Clamped::sum).visits.size(); ++k) shots.push_back(visit_shot(run, k));
  return shots;
}

}  // namespace

render::SeriesStyle style_of(const render::Theme& theme, Clamped clamped) {
  if (clamped == Clamped::sum) return theme.si;
  render::SeriesStyle style = theme.jacobi;
  if (clamped == Clamped::increment) style.dash = {};
  return style;
}

Rect clamp_panel(Page& page, const Rect& rect, Clamped clamped) {
  const char* name = clamped == Clamped::sum         ? "the sum is clamped"
                     : clamped == Clamped::increment ? "each push is clamped"
                                                     : "clamped once, at the end";
  const Rect inside = page.panel(rect, name);
  page.canvas().rect({rect.x, rect.y, rect.width, 5}, {.fill = style_of(page.theme(), clamped).color});
  return inside;
}

void draw_box(Page& page, const Rect& rect, const BoxRun& box, double largest, const BoxView& view) {
  const render::Camera camera = render::fit(rect, {{-1.15, -0.1}, {1.15, 1.17}});
  const double tallest = 0.9;  // [m]
  page.canvas().push_clip(rect);
  render::WorldLook look;
  look.contacts = false;
  look.numbers = false;
  look.penetration = false;
  draw_world(page, camera, box.snapshot, look);
  const render::ArrowScale scale{
      .pixels_per_unit = tallest * camera.scale / largest, .longest = 1.15 * camera.scale, .unit = "N s"};
  draw_foot_velocity(page, camera, view.fastest, -0.85, view.foot_velocity[0]);
  draw_foot_velocity(page, camera, view.fastest, 0.85, view.foot_velocity[1]);
  for (int i = 0; i < 2; ++i) {
    const double x = box.foot[i];
    const bool lit = i == view.foot;
    const double given = lit ? view.impulse[i] - view.before : 0;
    const double tip = tallest * (given < 0 ? view.before : view.impulse[i]) / largest;
    if (view.impulse[i] > 0.005)
      draw_arrow(page, camera, scale, {.tail = {x, 0}, .value = {0, view.impulse[i]}, .active = lit});
    if (given < -0.005) {
      draw_arrow(page, camera, scale,
                 {.kind = render::ArrowKind::negative_correction,
                  .tail = {x + (i == 0 ? -0.1 : 0.1), tip},
                  .value = {0, given}});
    }
    // Beside the tip, where what was taken back stands above it.
    const double aside = given < -0.005 ? (i == 0 ? 0.2 : -0.2) : 0;
    const double height = tallest * view.impulse[i] / largest - 0.1 * std::abs(aside);
    label_sum(page, camera, {x + aside, height}, view.impulse[i], lit);
  }
  page.canvas().pop_clip();
}

List<Shot> feet_shots(const FeetRun& recorded) {
  const Run run = std::make_shared<const FeetRun>(recorded);
  List<Shot> shots = {question_shot(card(), question_frame(run))};
  for (const List<Shot>& part : {visit_shots(run), motion_shots(run)})
    shots.insert(shots.end(), part.begin(), part.end());
  shots.push_back(spread_shot(run));
  shots.push_back(side_shot(run));
  shots.push_back(answer_shot(card(), answer_frame(run), answer_text(recorded)));
  return shots;
}

}  // namespace cairn::feet
