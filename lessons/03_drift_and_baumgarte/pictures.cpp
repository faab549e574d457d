// The question, the frames of the three scenes, and the answer.
#include "lesson.hpp"

namespace cairn::drift {

namespace {

QuestionFrame frame_of(const DriftRuns& all, const std::string& state, const std::string& alt,
                       const BallLook& look) {
  return {.state = state, .alt = alt, .scene = [&all, look](Page& page, const Rect& rect) {
            draw_balls(page, rect, all, look);
          }};
}

std::string answer_text(const DriftRuns& all) {
  return fmt::format(
      "{} m. To be out in one step the ball needs {} m/s. It keeps that speed when it is out, because the "
      "ground can push but not pull.",
      significant(ball_of(all, 1).peak), significant(all.settings.depth / all.settings.dt));
}

}  // namespace

std::string beta_name(double beta) { return fmt::format("β = {:g}", beta); }

SeriesStyle beta_style(const Theme& theme, double beta) {
  if (beta == 0) return {.color = theme.text};
  if (beta == 0.1) return {.color = theme.si.color};
  if (beta == 0.5) return {.color = theme.jacobi.color, .dash = {2, 5}};
  if (beta == 1) return {.color = theme.box2d.color, .dash = {10, 5, 2, 5}};
  if (beta == 1.8) return {.color = theme.secondary_text, .dash = {4, 4}};
  if (beta == 2.1) return {.color = theme.friction, .dash = {16, 4}};
  return {.color = theme.pgs.color, .dash = {10, 6}};  // the reader's
}

List<Shot> drift_shots(const DriftRuns& all) {
  List<Shot> shots = {question_shot(
      card(),
      frame_of(all, "before the first step",
               fmt::format("Four balls with different β, each {:g} mm inside the ground, and the question "
                           "how high the one with β = 1 comes",
                           1000 * all.settings.depth),
               {.asks = true}))};
  for (const List<Shot>& part : {swing_shots(all), hang_shots(all), ball_shots(all)})
    shots.insert(shots.end(), part.begin(), part.end());
  const int highest = highest_step(all);
  shots.push_back(answer_shot(
      card(),
      frame_of(all, fmt::format("step {} · answer", highest),
               "The balls when the one with β = 1 is highest, its height measured, and the answer.",
               {.step = highest, .measured = true}),
      answer_text(all)));
  return shots;
}

}  // namespace cairn::drift
