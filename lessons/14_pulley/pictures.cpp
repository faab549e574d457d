// Masses on a rope, the row of J that holds them, and the pull in the rope step by step.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "lessons/question.hpp"
#include "math/list.hpp"
#include "parts.hpp"
#include "render/draw.hpp"
#include "render/matrix.hpp"
#include "render/plot.hpp"

namespace cairn::pulley {

namespace {

using render::fixed;
using render::Page;
using render::Point;
using render::Rect;

using Runs = std::shared_ptr<const PulleyRuns>;

void draw_wheel(Page& page, const render::Camera& camera, const Vec2<double>& middle) {
  page.canvas().circle(
      camera.project(middle), wheel_radius * camera.scale,
      {.fill = page.theme().static_body, .outline = page.theme().outline, .outline_width = 1.5});
  page.canvas().circle(camera.project(middle), page.sizes().joint * 0.6, {.fill = page.theme().outline});
}

/// The rope from the first mass over, under and over the wheels; dashed where it is slack.
void draw_rope(Page& page, const render::Camera& camera, const PulleyStep& step) {
  const PerBody<SnapshotBody>& bodies = step.snapshot.bodies;
  const double r = wheel_radius;
  const double loop = bodies[{2}].pose.position.y() + 0.3 + r;  // the movable wheel sits on the second mass
  render::Stroke style{.width = 3 * page.sizes().outline, .color = page.theme().joint};
  if (step.tension <= 0 && step.room > 1e-9) style.dash = {6, 5};
  const auto line = [&](const Vec2<double>& from, const Vec2<double>& to) {
    page.canvas().line(camera.project(from), camera.project(to), style);
  };
  line({-3 * r, bodies[{1}].pose.position.y() + 0.3}, {-3 * r, wheel_height});
  line({-r, wheel_height}, {-r, loop});
  line({r, loop}, {r, wheel_height});
  line({3 * r, wheel_height}, {3 * r, bodies[{3}].pose.position.y() + 0.3});
  draw_wheel(page, camera, {-2 * r, wheel_height});
  draw_wheel(page, camera, {2 * r, wheel_height});
  draw_wheel(page, camera, {0, loop});
}

/// The step in which the rope pulls hardest: that of the jerk, if there is one.
int hardest_pull(const PulleyRuns& all) {
  const List<PulleyStep>& steps = all.runs[0].steps;
  const auto weaker = [](const PulleyStep& a, const PulleyStep& b) { return a.tension < b.tension; };
  return static_cast<int>(std::max_element(steps.begin(), steps.end(), weaker) - steps.begin());
}

/// How hard the rope pulls at mass i, beside it.
void draw_pull(Page& page, const render::Camera& camera, const render::ArrowScale& scale, int i,
               const Vec2<double>& middle, double pull) {
  if (!(pull > 0)) return;
  const FixedList<double, 3> beside = {-0.5, 1.05, 0.5};  // [m] clear of the rope
  const Vec2<double> tail = middle + Vec2<double>(beside[i], -0.3);
  draw_arrow(page, camera, scale, {.kind = render::ArrowKind::joint, .tail = tail, .value = {0, pull}});
  const double length = pull * scale.pixels_per_unit;
  if (length > scale.longest) return;  // a cut arrow has its number already
  // Above the tip, on the side where there is no rope; or beside the shaft.
  render::TextStyle style = page.value();
  style.halo = page.theme().panel;
  style.align = i == 0 ? render::Align::right : render::Align::left;
  const double out = i == 0 ? -1 : 1;
  const Point foot = camera.project(tail);
  const Point tip = foot + Point(-0.1 * out * camera.scale, -length - 6);
  page.place_text({tip, foot + Point(out * style.size, -length / 2)}, camera.viewport, fixed(pull, 1) + " N",
                  style);
}

/// The masses by their weight in kg, with what the rope and gravity do to each.
void draw_masses(Page& page, const Rect& rect, const PulleyRuns& all, const PulleyStep& step) {
  const Rect inside = page.panel(rect, "");
  const render::Camera camera = render::fit(inside, {{-3.4, -0.7}, {3.4, 7.1}});
  page.canvas().line(camera.project({-2.4, wheel_height + 0.84}), camera.project({2.4, wheel_height + 0.84}),
                     {.width = 4, .color = page.theme().outline});
  draw_rope(page, camera, step);
  render::WorldLook look;
  look.contacts = false;
  look.names = {""};
  for (const double mass : all.settings.masses) look.names.push_back(fmt::format("{:g} kg", mass));
  look.numbers = camera.scale >= 45;
  Snapshot masses = step.snapshot;
  masses.joints.clear();  // the rope is drawn already, as it runs
  draw_world(page, camera, masses, look);
  const double heaviest = gravity * *std::max_element(all.settings.masses.begin(), all.settings.masses.end());
  const List<PulleyStep>& steps = all.runs[0].steps;
  const double hardest = 2 * steps[hardest_pull(all)].tension;  // on two parts
  // [N/m] A weight is at most 1.6 m long, a pull 3 m, unless it is far beyond all weights.
  const double newtons = std::max(std::min(hardest, 6 * heaviest) / 3, heaviest / 1.6);
  const render::ArrowScale scale{
      .pixels_per_unit = camera.scale / newtons, .longest = 3.03 * camera.scale, .unit = "N"};
  for (int i = 0; i < 3; ++i) {
    const Vec2<double> middle = step.snapshot.bodies[{i + 1}].pose.position;
    const double weight = gravity * all.settings.masses[i];
    draw_arrow(page, camera, scale,
               {.kind = render::ArrowKind::external,
                .tail = middle + Vec2<double>(0, -0.3),
                .value = {0, -weight},
                .label = fixed(weight, 0) + " N"});
    draw_pull(page, camera, scale, i, middle, parts[i] * step.tension);
  }
}

void draw_row(Page& page, const Rect& rect, const PulleyRuns& all) {
  render::MatrixView view{.title = "J: one row, three bodies"};
  view.values.resize(1, 9);
  view.values.setZero();
  for_each_term(all.first, all.first.rows[0], [&](BodyId body, const Vec3<double>& jacobian) {
    for (int k = 0; k < 3; ++k) view.values(0, 3 * (body.index - 1) + k) = jacobian[k];
  });
  for (int body = 1; body <= 3; ++body) {
    for (const char* name : {"x", "y", "θ"})
      view.column_names.push_back(fmt::format("{}_{{{}}}", name, body));
  }
  view.column_group = 3;
  draw_matrix(page, rect, view);
}

/// Left the masses, right the row; returns what is free below it.
Rect draw_moment(Page& page, const PulleyRuns& all, const PulleyStep& step) {
  const List<Rect> halves = columns(page.area(), {0.44, 0.56}, page.sizes().gap);
  draw_masses(page, halves[0], all, step);
  const List<Rect> right = rows(halves[1], {0.21, 0.79}, page.sizes().gap);
  draw_row(page, right[0], all);
  return right[1];
}

void draw_equation(Page& page, const PulleyRuns& all) {
  const ConstraintRow<double>& row = all.first.rows[0];
  const double jv = row_velocity(all.first, row);
  const double inverse = inverse_effective_mass(all.first, row);
  const Rect rest = draw_moment(page, all, all.runs[0].steps[1]);
  const List<Rect> parts_of_rest = rows(rest, {0.42, 0.58}, page.sizes().gap);
  page.equation(parts_of_rest[0], {.number = "eq (22)",
                                   .symbols = "λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)",
                                   .numbers = fmt::format("= (0 − ({})) / ({} × {:g})", fixed(jv, 3),
                                                          fixed(inverse, 4), all.settings.dt),
                                   .result = fmt::format("= {} N", fixed(all.runs[0].steps[1].tension, 3)),
                                   .color = page.theme().text});
  render::TableView table;
  table.header = {"solver, one sweep", "λ (N)", "bytes"};
  for (const PulleyRun& run : all.runs) {
    table.rows.push_back({run.solver, fixed(run.steps[1].tension, 9), fmt::format("{}", run.memory)});
  }
  page.table(parts_of_rest[1], "the same row in seven solvers", table);
}

void draw_step(Page& page, const PulleyRuns& all, int k) {
  const List<PulleyStep>& steps = all.runs[0].steps;
  const Rect rest = draw_moment(page, all, steps[k]);
  double largest = 0;
  for (const PulleyStep& step : steps) largest = std::max(largest, step.tension);
  render::Plot plot{.title = "pull in the rope, λ (N)"};
  plot.x = {.title = "step", .min = 0, .max = all.settings.steps};
  plot.y = {.title = "", .min = 0, .max = 1.15 * largest};
  render::Series series{.name = "", .style = page.theme().si};
  for (int i = 1; i < steps.size(); ++i) {
    series.x.push_back(i);
    series.y.push_back(steps[i].tension);
  }
  plot.series.push_back(series);
  const double tension = tension_by_hand(all.settings);
  plot.goals.push_back({tension, fmt::format("by hand: {} N", fixed(tension, 1))});
  plot.now = k;
  draw_plot(page, rest, plot);
}

Shot step_shot(const Runs& all, int k, const std::set<int>& keys) {
  const PulleyStep& step = all->runs[0].steps[k];
  const bool slack = step.tension <= 0;
  return {.state = fmt::format("step {} · {}", k, slack ? "the rope is slack" : "the rope is taut"),
          .alt = fmt::format(
              "Step {}: the rope is {} and pulls with {:.2f} N; the masses move at {:.2f}, {:.2f} and "
              "{:.2f} m/s upwards.",
              k, slack ? "slack" : "taut", step.tension, step.speed[0], step.speed[1], step.speed[2]),
          .draw = [all, k](Page& page) { draw_step(page, *all, k); },
          .key = keys.contains(k)};
}

/// The masses after step k, for the first and the last frame.
QuestionFrame moment(const Runs& all, int k, const std::string& state, const std::string& alt) {
  const auto scene = [all, k](Page& page, const Rect& rect) {
    draw_masses(page, rect, *all, all->runs[0].steps[k]);
  };
  return {.state = state, .alt = alt, .scene = scene};
}

}  // namespace

List<Shot> pulley_shots(const PulleyRuns& recorded) {
  const Runs all = std::make_shared<const PulleyRuns>(recorded);
  const int last = all->settings.steps;
  const int lift = all->settings.lift_step;
  const std::set<int> keys = {lift, lift + 1, lift + 10, hardest_pull(*all), last};
  List<Shot> shots;
  shots.push_back(
      question_shot(card(), moment(all, 0, "before the first step",
                                   "Three masses of 1, 2 and 3 kg on one rope over two fixed wheels and one "
                                   "movable wheel, and the question.")));
  shots.push_back(
      {.state = "step 1 · one row, one sweep",
       .alt = "Equation (22) for the row of the rope, filled in, and the answer of seven solvers.",
       .draw = [all](Page& page) { draw_equation(page, *all); },
       .key = true});
  for (int k = 2; k <= last; ++k) shots.push_back(step_shot(all, k, keys));
  shots.push_back(answer_shot(
      card(),
      moment(all, last, fmt::format("after {} steps", last),
             "The masses after the last step, and the answer."),
      fmt::format("The tension is {} N, and each part of the rope pulls with it. A mass goes down where all "
                  "its parts together pull with less than its weight. The joint is one class in the "
                  "lesson's own folder, and no solver knows of it.",
                  fixed(tension_by_hand(all->settings), 1))));
  return shots;
}

}  // namespace cairn::pulley
