// The frames: the row, three pushes and what they leave, the effective mass here, this way, and against
// another body.
#include "parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/question.hpp"
#include "math/list.hpp"
#include "render/matrix.hpp"
#include "render/plot.hpp"

namespace cairn::one_push {

namespace {

using render::fixed;
using render::Page;
using render::Rect;
using render::significant;

using Shared = std::shared_ptr<const Pushes>;

/// Left the box; returns the two parts on the right.
List<Rect> draw_left(Page& page, const Pushes& all, const Push& push, const PegLook& look, double upper) {
  const List<Rect> halves = columns(page.area(), {0.44, 0.56}, page.sizes().gap);
  draw_push(page, halves[0], all, push, look);
  return rows(halves[1], {upper, 1 - upper}, page.sizes().gap);
}

/// The places and their pushes, as far as they are known.
render::TableView push_table(const Pushes& all, int known) {
  render::TableView table{.header = {"x (m)", "effective mass (kg)", "λΔt (N s)", "λ (N)"},
                          .active_row = known - 1};
  for (int i = 0; i < all.at.size(); ++i) {
    const Push& push = all.at[i];
    List<std::string> row = {significant(push.x), "?", "?", "?"};
    if (i < known)
      row = {significant(push.x), fixed(1 / push.inverse, 3), fixed(push.impulse, 3),
             significant(push.impulse / all.settings.dt, 4)};
    table.rows.push_back(row);
  }
  return table;
}

void draw_note(Page& page, const Pushes& all, const PegLook& look, std::string_view title,
               std::string_view text, int known) {
  const List<Rect> parts = draw_left(page, all, all.at.back(), look, 0.3);
  page.note(parts[0], title, text);
  const List<Rect> below = rows(parts[1], {0.6, 0.4}, page.sizes().gap);
  const List<Rect> others = columns(below[0], {0.5, 0.5}, page.sizes().gap);
  for (int i = 0; i < others.size(); ++i) draw_push(page, others[i], all, all.at[i], look);
  render::TableView table = push_table(all, known);
  table.active_row = -1;
  page.table(below[1], "", table);
}

/// j and the diagonal of M^-1 over each other, and what comes of them.
void draw_row(Page& page, const Pushes& all) {
  const Push& push = all.at.back();
  const List<Rect> parts = draw_left(page, all, push, {}, 0.46);
  const List<Rect> halves = rows(parts[0], {0.5, 0.5}, page.sizes().gap);
  render::MatrixView j{.title = "j: the peg (1) and the box (2)", .column_group = 3};
  j.values.resize(1, 6);
  j.values << push.row.jacobian_a.transpose(), push.row.jacobian_b.transpose();
  render::MatrixView masses{.title = "the diagonal of M⁻¹, eq (17)", .column_group = 3};
  masses.values.resize(1, 6);
  masses.values << push.inverse_mass[{1}].transpose(), push.inverse_mass[{2}].transpose();
  masses.colors = render::MatrixColors::magnitude;
  for (const char* name : {"x_{1}", "y_{1}", "θ_{1}", "x_{2}", "y_{2}", "θ_{2}"}) {
    j.column_names.emplace_back(name);
    masses.column_names.emplace_back(name);
  }
  draw_matrix(page, halves[0], j);
  draw_matrix(page, halves[1], masses);
  const Vec3<double>& w = push.inverse_mass[{2}];
  page.equation(
      parts[1],
      {.number = "entry by entry: j² of the one times the other",
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
  page.table(parts[1], "the peg, at three places", push_table(all, i + 1));
}

render::TableView motion_table(const Pushes& all, int known) {
  render::TableView table{.header = {"x (m)", "v_{y} (m/s)", "ω (rad/s)", "energy (J)"},
                          .active_row = known - 1};
  for (int i = 0; i < all.at.size(); ++i) {
    const Push& push = all.at[i];
    const Vec3<double>& v = push.after.bodies[{2}].velocity;
    List<std::string> row = {significant(push.x), "?", "?", "?"};
    if (i < known)
      row = {significant(push.x), fixed(v.y(), 3), fixed(v.z(), 3), fixed(kinetic_energy(push.after), 3)};
    table.rows.push_back(row);
  }
  return table;
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
             motion_table(all, i + 1));
}

render::Series curve_of_places(const Page& page, const Pushes& all) {
  render::Series curve{
      .name = "", .style = {page.theme().normal, {}, render::Marker::none}, .markers = false};
  for (int k = -50; k <= 50; ++k) {
    curve.x.push_back(0.01 * k);
    curve.y.push_back(mass_at(all.settings.mass, {0.01 * k, -0.5}, {0, 1}));
  }
  return curve;
}

void draw_here(Page& page, const Pushes& all) {
  const List<Rect> halves = columns(page.area(), {0.44, 0.56}, page.sizes().gap);
  draw_push(page, halves[0], all, all.at[0], {.masses = true});
  render::Plot plot{.title = "effective mass 1 / (j M⁻¹ jᵀ), upwards (kg)"};
  render::Series found{
      .name = "", .style = {page.theme().outline, {}, render::Marker::circle}, .line = false};
  for (const Push& push : {all.mirrored, all.at[0], all.at[1], all.at[2]}) {
    found.x.push_back(push.x);
    found.y.push_back(push.impulse / all.settings.speed);
  }
  plot.series = {curve_of_places(page, all), found};
  plot.goals.push_back({all.settings.mass, "all of the box"});
  plot.x = {.title = "place of the peg, x (m)", .min = -0.55, .max = 0.55};
  plot.y = {.title = "", .min = 0, .max = 1.2 * all.settings.mass};
  draw_plot(page, halves[1], plot);
}

void draw_this_way(Page& page, const Pushes& all) {
  const List<Rect> halves = columns(page.area(), {0.5, 0.5}, page.sizes().gap);
  draw_push(page, halves[0], all, all.at[0], {.directions = true});
  draw_push(page, halves[1], all, all.at[2], {.directions = true});
}

void draw_others(Page& page, const Pushes& all) {
  const List<Rect> halves = columns(page.area(), {0.56, 0.44}, page.sizes().gap);
  const double m = all.settings.mass;
  render::Plot plot{.title = "effective mass in the middle, of box and peg (kg)"};
  render::Series curve{
      .name = "", .style = {page.theme().normal, {}, render::Marker::none}, .markers = false};
  render::Series found{
      .name = "", .style = {page.theme().outline, {}, render::Marker::circle}, .line = false};
  for (int k = -16; k <= 16; ++k) {
    const double other = m * std::pow(10, k / 4.0 * 0.75);
    curve.x.push_back(other);
    curve.y.push_back(1 / (1 / m + 1 / other));
  }
  render::TableView table{.header = {"peg (kg)", "1/m of both", "effective (kg)"}};
  for (const OtherMass& other : all.others) {
    const bool fixed_peg = !(other.mass > 0);
    table.rows.push_back({fixed_peg ? "fixed" : significant(other.mass), significant(1 / other.effective, 4),
                          significant(other.effective, 4)});
    if (fixed_peg || other.mass < curve.x.front() || other.mass > curve.x.back()) continue;
    found.x.push_back(other.mass);
    found.y.push_back(other.effective);
  }
  plot.series = {curve, found};
  plot.goals.push_back({m, "the box alone"});
  plot.x = {.title = "mass of the peg (kg)", .scale = render::AxisScale::logarithmic};
  plot.y = {.title = "", .scale = render::AxisScale::logarithmic, .max = 3 * m};
  draw_plot(page, halves[0], plot);
  const List<Rect> parts = rows(halves[1], {0.48, 0.52}, page.sizes().gap);
  page.equation(parts[0],
                {.number = "two bodies that can move",
                 .symbols = "j M⁻¹ j^{T} = 1/m_{1} + 1/m_{2}",
                 .numbers = fmt::format("= 1/{} + 1/{}", significant(m), significant(all.others[2].mass)),
                 .result = fmt::format("= 1 / ({} kg)", significant(all.others[2].effective, 4))});
  page.table(parts[1], "whom the box meets", table);
}

Shot shot(const std::string& state, const std::string& alt, std::function<void(Page&)> draw) {
  return {.state = state, .alt = alt, .draw = std::move(draw), .key = true};
}

void append_pushes(const Shared& all, List<Shot>& shots) {
  for (int i = 0; i < all->at.size(); ++i) {
    const Push& push = all->at[i];
    shots.push_back(
        shot(fmt::format("push {} of 3 · x = {:.3g} m", i + 1, push.x),
             fmt::format("The peg at x = {:.3g} m pushes the box with {:.3f} N s upwards; equation "
                         "(22) filled in.",
                         push.x, push.impulse),
             [all, i](Page& page) { draw_step(page, *all, i); }));
    shots.push_back(
        shot(fmt::format("after push {} of 3", i + 1),
             fmt::format("After the push the box moves at {:.3f} m/s and turns at {:.3f} rad/s, so "
                         "that the contact stands still; outlines show where it goes.",
                         push.after.bodies[{2}].velocity.y(), push.after.bodies[{2}].velocity.z()),
             [all, i](Page& page) { draw_after(page, *all, i); }));
  }
}

}  // namespace

List<Shot> peg_shots(const Pushes& recorded) {
  const auto all = std::make_shared<const Pushes>(recorded);
  List<Shot> shots;
  shots.push_back(
      shot("before the push", "A box falls on a peg beside its middle, and the question.", [all](Page& page) {
        draw_note(
            page, *all, {.named = true}, "The question",
            fmt::format("A box of {:g}\u00a0kg falls on a peg. Only the point above the peg has to stop. "
                        "Does that take more here than under the middle, or less? How many N\u00a0s?",
                        all->settings.mass),
            0);
      }));
  shots.push_back(shot("the row",
                       "The row j and the diagonal of M⁻¹ for peg and box, and j M⁻¹ jᵀ from both.",
                       [all](Page& page) { draw_row(page, *all); }));
  append_pushes(all, shots);
  shots.push_back(shot("here",
                       "Bars along the underside of the box: the effective mass is largest in the middle.",
                       [all](Page& page) { draw_here(page, *all); }));
  shots.push_back(
      shot("this way",
           "Under the middle and beside it a closed curve: its distance from the contact is "
           "the effective mass in that direction, all of the box towards its centre and less across.",
           [all](Page& page) { draw_this_way(page, *all); }));
  shots.push_back(shot("against whom",
                       "The effective mass against the mass of the peg: never more than the box alone.",
                       [all](Page& page) { draw_others(page, *all); }));
  shots.push_back(shot("after the lesson", "The push beside the middle, and the answer.", [all](Page& page) {
    draw_note(page, *all, {.push = true, .named = true}, "The answer",
              fmt::format("Less: {} N s instead of {}. Away from the middle the box gives way by turning, so "
                          "the peg meets only {} of its {} kg.",
                          significant(all->at[2].impulse), significant(all->at[0].impulse),
                          significant(1 / all->at[2].inverse), significant(all->settings.mass)),
              3);
  }));
  return shots;
}

}  // namespace cairn::one_push
