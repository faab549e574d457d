// The frames: the row, three pushes and what they leave, the effective mass here, this way, and against
// another body.
#include "lesson.hpp"

namespace cairn::one_push {

namespace {

/// Left the box; returns the two parts on the right.
List<Rect> draw_left(Page& page, const Pushes& all, const Push& push, const PegLook& look, double upper) {
  const List<Rect> parts = in_columns(page, {0.44, {0.56, {upper, 1 - upper}}});
  draw_push(page, parts[0], all, push, look);
  return {parts[1], parts[2]};
}

/// The places with what was found at each, as far as it is known.
TableView table_of(const Pushes& all, const List<std::string>& header, int known,
                   const std::function<List<std::string>(const Push&)>& found) {
  TableView table{.header = header, .active_row = known - 1};
  for (int i = 0; i < all.at.size(); ++i) {
    List<std::string> row = {significant(all.at[i].x)};
    const List<std::string> numbers =
        i < known ? found(all.at[i]) : List<std::string>(header.size() - 1, "?");
    row.insert(row.end(), numbers.begin(), numbers.end());
    table.rows.push_back(row);
  }
  return table;
}

/// Question and answer: below the centre and at the last place, side by side, at one scale.
QuestionFrame frame_of(const Pushes& all, const std::string& state, const std::string& alt,
                       const PegLook& look) {
  return {.state = state,
          .alt = alt,
          .scene =
              [&all, look](Page& page, const Rect& rect) {
                const List<Rect> panels = in_columns(page, rect, {1, 1});
                draw_push(page, panels[0], all, all.at.front(), look);
                draw_push(page, panels[1], all, all.at.back(), look);
              },
          .place = ScenePlace::above};
}

/// j, the diagonal of M^-1 and their products below each other, and the sum.
void draw_row(Page& page, const Pushes& all) {
  const Push& push = all.at.back();
  const List<Rect> parts = draw_left(page, all, push, {}, 0.62);
  Eigen::MatrixXd j(1, 6), masses(1, 6);
  j << push.row.jacobian_a.transpose(), push.row.jacobian_b.transpose();
  masses << push.inverse_mass[{1}].transpose(), push.inverse_mass[{2}].transpose();
  const Rect inside = page.panel(parts[0], "");
  const List<Rect> strips = rows(inside, {1, 1, 1}, 4);
  const FixedList<MatrixView, 3> views = {
      {{.title = "j: body a is the peg, body b the box", .values = j},
       {.title = "the diagonal of M⁻¹, eq (17)", .values = masses, .colors = MatrixColors::magnitude},
       {.title = "j² times that: the sum is j M⁻¹ j^{T}",
        .values = j.array().square() * masses.array(),
        .colors = MatrixColors::magnitude}}};
  for (int i = 0; i < strips.size(); ++i) {
    MatrixView view = views[i];
    view.column_group = 3;
    for (const char* name : {"x_{a}", "y_{a}", "θ_{a}", "x_{b}", "y_{b}", "θ_{b}"})
      view.column_names.emplace_back(name);
    const double margin = 0.2 * inside.width;
    draw_matrix(page, {strips[i].x + margin, strips[i].y, inside.width - margin, strips[i].height}, view);
  }
  const Vec3<double>& w = push.inverse_mass[{2}];
  page.equation(
      parts[1],
      {.number = "of the six products, two are not 0",
       .symbols = "j M⁻¹ j^{T} = 1/m + x²/I",
       .numbers =
           fmt::format("= {} + {}² × {}", significant(w.y(), 4), significant(push.x), significant(w.z(), 4)),
       .result = fmt::format("= {} 1/kg = 1 / ({} kg)", fixed(push.inverse, 4), fixed(1 / push.inverse, 3))});
}

void draw_step(Page& page, const Pushes& all, int i) {
  const Push& push = all.at[i];
  const List<Rect> parts = draw_left(page, all, push, {.push = true}, 0.46);
  page.equation(parts[0], {.number = "eq (22)",
                           .symbols = "λ = (ζ − j·v_{1}) / (j M⁻¹ j^{T} Δt)",
                           .numbers = fmt::format("= (0 − ({})) / ({} × {})", significant(push.rate_before),
                                                  fixed(push.inverse, 4), significant(all.settings.dt)),
                           .result = fmt::format("= {} N,   λΔt = {} N s",
                                                 significant(push.impulse / all.settings.dt, 4),
                                                 significant(push.impulse, 4)),
                           .color = page.theme().normal});
  page.table(parts[1], "the peg, at three places",
             table_of(all, {"x (m)", "effective mass (kg)", "λΔt (N s)", "λ (N)"}, i + 1,
                      [&all](const Push& one) -> List<std::string> {
                        return {fixed(1 / one.inverse, 3), fixed(one.impulse, 3),
                                significant(one.impulse / all.settings.dt, 4)};
                      }));
}

void draw_after(Page& page, const Pushes& all, int i) {
  const Push& push = all.at[i];
  const Vec3<double>& v = push.after.bodies[{2}].velocity;
  const List<Rect> parts = draw_left(page, all, push, {.after = true}, 0.46);
  page.equation(
      parts[0],
      {.number = "eq (19) for v_y and ω, then eq (20)",
       .symbols = fmt::format("v_{{y}} = −{} + {}/{} = {} m/s", significant(all.settings.speed),
                              significant(push.impulse), significant(all.settings.mass), fixed(v.y(), 3)),
       .numbers = fmt::format("ω = {} × {}/{} = {} rad/s", significant(push.x), significant(push.impulse),
                              significant(inertia_of(all.settings.mass)), fixed(v.z(), 3)),
       .result = fmt::format("j·v_{{2}} = {} + {} × {} = {} m/s", fixed(v.y(), 3), significant(push.x),
                             fixed(v.z(), 3), fixed(push.rate_after, 3))});
  page.table(parts[1], fmt::format("what is left of {} J", significant(kinetic_energy(push.before))),
             table_of(all, {"x (m)", "v_{y} (m/s)", "ω (rad/s)", "energy (J)"}, i + 1,
                      [](const Push& one) -> List<std::string> {
                        const Vec3<double>& left = one.after.bodies[{2}].velocity;
                        return {fixed(left.y(), 3), fixed(left.z(), 3), fixed(kinetic_energy(one.after), 3)};
                      }));
}

Series curve_of_places(const Page& page, const Pushes& all) {
  Series curve{.style = {.color = page.theme().normal}, .markers = false};
  for (int k = -50; k <= 50; ++k) curve.add(0.01 * k, mass_at(all.settings.mass, {0.01 * k, -0.5}, {0, 1}));
  return curve;
}

void draw_here(Page& page, const Pushes& all) {
  const List<Rect> halves = in_columns(page, {0.44, 0.56});
  draw_push(page, halves[0], all, all.at[0], {.masses = true});
  Plot plot{.title = "effective mass 1 / (j M⁻¹ jᵀ), upwards (kg)"};
  Series found{.style = {page.theme().outline, {}, Marker::circle}, .line = false};
  for (const Push& push : {all.mirrored, all.at[0], all.at[1], all.at[2]})
    found.add(push.x, push.impulse / all.settings.speed);
  plot.series = {curve_of_places(page, all), found};
  plot.goals.push_back({all.settings.mass, "all of the box"});
  plot.x = {.title = "place of the peg, x (m)", .min = -0.55, .max = 0.55};
  plot.y = {.title = "", .min = 0, .max = 1.2 * all.settings.mass};
  draw_plot(page, halves[1], plot);
}

void draw_this_way(Page& page, const Pushes& all) {
  const List<Rect> halves = in_columns(page, {0.5, 0.5});
  draw_push(page, halves[0], all, all.at[0], {.directions = true});
  draw_push(page, halves[1], all, all.at[2], {.directions = true});
}

/// Those of the last place are key frames: their tables have all three.
void append_pushes(const Pushes& all, List<Shot>& shots) {
  for (int i = 0; i < all.at.size(); ++i) {
    const Push& push = all.at[i];
    shots.push_back(
        key_shot(all, fmt::format("push {} of 3 · x = {:.3g} m", i + 1, push.x),
                 fmt::format("The peg at x = {:.3g} m pushes the box with {:.3f} N s upwards; equation "
                             "(22) filled in.",
                             push.x, push.impulse),
                 [i](Page& page, const Pushes& pushes) { draw_step(page, pushes, i); }));
    shots.back().key = i == 2;
    shots.push_back(
        key_shot(all, fmt::format("after push {} of 3", i + 1),
                 fmt::format("After the push the box moves at {:.3f} m/s and turns at {:.3f} rad/s, so "
                             "that the contact stands still; outlines show where it goes.",
                             push.after.bodies[{2}].velocity.y(), push.after.bodies[{2}].velocity.z()),
                 [i](Page& page, const Pushes& pushes) { draw_after(page, pushes, i); }));
    shots.back().key = i == 2;
  }
}

}  // namespace

List<Shot> peg_shots(const Pushes& all) {
  List<Shot> shots = {question_shot(
      card(),
      frame_of(all, "before the push",
               "A box that falls on a peg, once below its centre and once below its corner, and the question "
               "how hard the peg has to push",
               {.asked = true, .named = true}))};
  shots.push_back(key_shot(all, "the row",
                           "The row j and the diagonal of M⁻¹ for peg and box, and j M⁻¹ jᵀ from both.",
                           draw_row));
  append_pushes(all, shots);
  shots.push_back(key_shot(
      all, "here", "Bars along the underside of the box: the effective mass is largest below the centre.",
      draw_here));
  shots.back().key = false;
  shots.push_back(
      key_shot(all, "this way",
               "Below the centre and off-centre a closed curve: its distance from the contact is "
               "the effective mass in that direction, all of the box towards its centre and less across.",
               draw_this_way));
  const std::string answer = fmt::format(
      "Less: {} N s instead of {}. Off-centre the box also turns, so its corner yields more easily: here, "
      "this way, the effective mass is {} kg instead of {} kg.",
      significant(all.at[2].impulse), significant(all.at[0].impulse), significant(1 / all.at[2].inverse),
      significant(all.settings.mass));
  shots.push_back(
      answer_shot(card(),
                  frame_of(all, "after the lesson",
                           "The pushes below the centre and below the corner, at one scale, and the answer.",
                           {.push = true, .named = true}),
                  answer));
  return shots;
}

}  // namespace cairn::one_push
