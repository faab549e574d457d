// The question, the frames of the three scenes, and the answer.
#include "parts.hpp"

#include <fmt/format.h>

#include <memory>

#include "math/list.hpp"

namespace cairn::drift {

namespace {

using render::fixed;
using render::Page;
using render::Rect;

void draw_question(Page& page, const DriftRuns& all) {
  const DriftSettings& settings = all.settings;
  const List<Rect> halves = columns(page.area(), {0.5, 0.5}, page.sizes().gap);
  const List<Rect> right = rows(halves[1], {0.6, 0.4}, page.sizes().gap);
  draw_balls(page, halves[0], all, 0, 0);
  page.note(
      right[0], "The question",
      fmt::format("Every ball begins {:g} mm inside the ground, each with its own β. β = 1 takes the whole "
                  "error back in one step, which sounds best. How high above the ground does that ball come?",
                  1000 * settings.depth));
  page.equation(right[1], {.number = "eq (7), β = 1",
                           .symbols = "ζ = −β c / Δt",
                           .numbers = fmt::format("= −1 × (−{:g}) / {:.4g}", settings.depth, settings.dt),
                           .result = "= ? m/s"});
}

std::string answer_text(const DriftRuns& all) {
  const DriftSettings& settings = all.settings;
  const std::string hop = fixed(ball_of(all, 1).peak, 2);
  const std::string speed = fixed(settings.depth / settings.dt, 1);
  const std::string limit = fixed(1000 * limit_by_formula(settings.dt, settings.beta), 0);
  return fmt::format(
      "{} m. To be out in one step it needs {} m/s, and keeps that speed when it is out. A joint takes it "
      "away again in the next step. A contact can only push: it holds the ball if it is no deeper than "
      "g Δt² / β², with β = {:g} that is {} mm. So β = 1 is fine for a pendulum and bad for a contact, and "
      "0.2 is a "
      "common choice.",
      hop, speed, settings.beta, limit);
}

void draw_answer(Page& page, const DriftRuns& all, int step) {
  const List<Rect> halves = columns(page.area(), {0.5, 0.5}, page.sizes().gap);
  const List<Rect> left = rows(halves[0], {0.62, 0.38}, page.sizes().gap);
  const List<Rect> right = rows(halves[1], {0.5, 0.5}, page.sizes().gap);
  draw_balls(page, left[0], all, step, step);
  draw_ball_table(page, left[1], all, step);
  page.note(right[0], "The answer", answer_text(all));
  draw_heights(page, right[1], all, all.balls[0].steps.size() - 1);
}

}  // namespace

std::string beta_name(double beta) { return fmt::format("β = {:g}", beta); }

render::SeriesStyle curve_style(const render::Theme& theme, int k) {
  const FixedList<render::SeriesStyle, 4> styles = {{{theme.si.color, {}},
                                                     {theme.pgs.color, {10, 6}},
                                                     {theme.jacobi.color, {2, 5}},
                                                     {theme.box2d.color, {10, 5, 2, 5}}}};
  return styles[k];
}

List<Shot> drift_shots(const DriftRuns& recorded) {
  const Runs all = std::make_shared<const DriftRuns>(recorded);
  List<Shot> shots;
  shots.push_back(
      {.state = "before the first step",
       .alt = "Balls side by side, each with its own β and as deep inside the ground, and the question.",
       .draw = [all](Page& page) { draw_question(page, *all); },
       .key = true});
  for (const List<Shot>& part : {swing_shots(all), hang_shots(all), ball_shots(all)}) {
    shots.insert(shots.end(), part.begin(), part.end());
  }
  const int highest = highest_step(*all);
  shots.push_back({.state = fmt::format("step {} · answer", highest),
                   .alt = "The balls when the one with β = 1 is highest, and the answer.",
                   .draw = [all, highest](Page& page) { draw_answer(page, *all, highest); },
                   .key = true});
  return shots;
}

}  // namespace cairn::drift
