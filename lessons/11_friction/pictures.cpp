// Lesson 11. Forces: what is needed, what is allowed, and how the bounds move within a step.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "forces.hpp"
#include "lessons/question.hpp"
#include "math/list.hpp"
#include "parts.hpp"
#include "render/bars.hpp"
#include "render/draw.hpp"
#include "render/plot.hpp"

namespace cairn::friction {

namespace {

using namespace render;

std::string with_value(const std::string& name, double value) { return name + " " + fixed(value, 2); }

Bar grey_bar(const std::string& name, double value) {
  Bar bar;
  bar.name = name;
  bar.before = value;
  return bar;
}

Bar colored_bar(const std::string& name, double value) {
  Bar bar;
  bar.name = name;
  bar.added = value;
  return bar;
}

/// What holding would need, what the law allows, and what the row gives.
BarChart force_bars(const Page& page, const Slide& slide) {
  const Coulomb law = coulomb(slide.slope, slide.block);
  const double given = std::min(law.needed, law.limit);
  BarChart chart = {.title = "along the slope (N): needed, limit μ λ_{n}, given λ_{t}"};
  chart.bars.push_back(grey_bar(with_value("needed", law.needed), law.needed));
  chart.bars.push_back(grey_bar(with_value("limit", law.limit), law.limit));
  chart.bars.push_back(colored_bar(with_value("given", given), given));
  chart.largest = 1.1 * std::max(law.needed, law.limit);
  chart.color = page.theme().friction;
  return chart;
}

Equation limit_equation(const Slide& slide) {
  const Coulomb law = coulomb(slide.slope, slide.block);
  const bool holds = law.acceleration == 0;
  Equation equation = {.number = "bounds of the tangent row, paper 2.2"};
  equation.symbols = "|λ_{t}| ≤ μ λ_{n}";
  equation.numbers = fmt::format("{} {} {} × {} = {} N", fixed(law.needed, 2), holds ? "≤" : ">",
                                 fixed(slide.block.friction, 2), fixed(law.load, 2), fixed(law.limit, 2));
  equation.result = holds ? fmt::format("it holds: λ_{{t}} = {} N", fixed(law.needed, 2))
                          : fmt::format("it slides: a = {} m/s²", fixed(law.acceleration, 3));
  equation.algorithm = holds ? "the row gets what it asks for" : "Algorithm 1: clamp to the allowed interval";
  return equation;
}

std::string degrees(const Slope& slope) { return significant(slope.angle * 180 / pi) + "°"; }

TableView known_table(const Study& study) {
  const Coulomb law = coulomb(study.rough.slope, study.rough.block);
  TableView table = {.header = {"", "1 kg", significant(study.heavy.block.mass) + " kg"}};
  table.rows.push_back({"angle", degrees(study.rough.slope), degrees(study.heavy.slope)});
  table.rows.push_back(
      {"friction μ", fixed(study.rough.block.friction, 2), fixed(study.heavy.block.friction, 2)});
  table.rows.push_back({"it", law.acceleration == 0 ? "holds" : "slides", "?"});
  table.active_row = 2;
  return table;
}

TableView sweep_table(const Study& study) {
  const Slide& slide = study.slippery;
  const double dt = slide.slope.dt;
  TableView table = {.header = {"sweep"}};
  const List<std::string> points = {"upper", "lower"};
  for (int point = 0; point < points.size(); ++point) {
    table.header.push_back(points[point] + " λ_{n}");
    table.header.push_back("± μ λ_{n}");
    table.header.push_back("λ_{t}");
  }
  for (const SweepRecord& record : slide.first_step) {
    const int sweep = record.sweep;
    const bool shown = sweep <= 3 || sweep == 5 || sweep == 10 || sweep == slide.slope.sweeps;
    if (!shown) continue;
    List<std::string> row = {std::to_string(sweep)};
    for (int point = 0; point < std::min(points.size(), record.impulse.size() / 2); ++point) {
      const double load = record.impulse[2 * point] / dt;
      row.push_back(fixed(load, 2));
      row.push_back(fixed(slide.block.friction * load, 2));
      row.push_back(fixed(record.impulse[2 * point + 1] / dt, 2));
    }
    table.rows.push_back(row);
  }
  table.active_row = table.rows.size() - 1;
  return table;
}

/// The upper corner: its friction, and the bound that moves with its load.
void draw_moving_bound(Page& page, const Rect& rect, const Study& study) {
  const Slide& slide = study.slippery;
  Series bound = {.name = "−μ λ_{n}", .style = page.theme().exact, .markers = false};
  Series friction = {.name = "λ_{t}",
                     .style = {.color = page.theme().friction, .dash = {}, .marker = Marker::circle}};
  for (const SweepRecord& record : slide.first_step) {
    if (record.sweep == 0 || record.sweep > 12 || record.impulse.size() < 2) continue;
    bound.x.push_back(record.sweep);
    bound.y.push_back(-slide.block.friction * record.impulse[0] / slide.slope.dt);
    friction.x.push_back(record.sweep);
    friction.y.push_back(record.impulse[1] / slide.slope.dt);
  }
  Plot plot = {.title = "upper corner: λ_{t} and its bound (N)"};
  plot.x = {.title = "sweep"};
  plot.series = {bound, friction};
  draw_plot(page, rect, plot);
}

BarChart mass_bars(const Page& page, const Study& study) {
  const std::string heavy = significant(study.heavy.block.mass);
  BarChart chart = {.title = fmt::format("1 kg, then {} kg (N)", heavy)};
  for (const Slide* slide : {&study.rough, &study.heavy}) {
    const Coulomb law = coulomb(slide->slope, slide->block);
    chart.bars.push_back(grey_bar(with_value("needed", law.needed), law.needed));
    chart.bars.push_back(colored_bar(with_value("limit", law.limit), law.limit));
    chart.largest = std::max(chart.largest, 1.1 * std::max(law.needed, law.limit));
  }
  chart.color = page.theme().friction;
  return chart;
}

}  // namespace

Shot question_shot(const SharedStudy& study, const std::string& question) {
  Shot shot;
  shot.key = true;
  shot.state = degrees(study->rough.slope) + " · μ = " + fixed(study->rough.block.friction, 2);
  shot.alt =
      "A block of 1 kg that holds on a slope, a table with its numbers and those of a heavier one, and the "
      "question";
  shot.draw = [study, question](Page& page) {
    const Layout layout = layout_of(page);
    const Camera camera = camera_of(layout.scene, study->rough.slope);
    draw_world(page, camera, study->rough.frames.front(), {.names = {"", "", "1 kg"}, .contacts = false});
    page.note(layout.upper, "The question", question, question_growth);
    page.table(layout.lower, "what is given", known_table(*study));
  };
  return shot;
}

Shot force_shot(const SharedStudy& study, const Slide& slide) {
  const Coulomb law = coulomb(slide.slope, slide.block);
  Shot shot;
  shot.key = true;
  shot.state = degrees(slide.slope) + " · μ = " + fixed(slide.block.friction, 2);
  shot.alt = fmt::format(
      "A block on a slope with its weight, the normal force {} N and friction {} N inside the "
      "bracket of its limit {} N; {} N would hold it.",
      fixed(law.load, 2), fixed(std::min(law.needed, law.limit), 2), fixed(law.limit, 2),
      fixed(law.needed, 2));
  const bool rough = slide.block.friction == study->rough.block.friction;
  shot.draw = [study, rough](Page& page) {
    const Slide& shown = rough ? study->rough : study->slippery;
    const Layout layout = layout_of(page);
    draw_forces(page, shown, *study);
    draw_bars(page, layout.upper, force_bars(page, shown));
    page.equation(layout.lower, limit_equation(shown));
  };
  return shot;
}

Shot sweep_shot(const SharedStudy& study) {
  Shot shot;
  shot.key = true;
  shot.state = "first step, sweep by sweep";
  shot.alt =
      "The block with the forces of its two contact points, and a table: in each sweep the normal impulses "
      "change, and with them the bounds of the friction rows beside them.";
  shot.draw = [study](Page& page) {
    const Layout layout = layout_of(page);
    draw_corners(page, study->slippery, *study);
    page.table(layout.upper, "λ of the two corners (N); λ_{t} is negative uphill", sweep_table(*study));
    draw_moving_bound(page, layout.lower, *study);
  };
  return shot;
}

Shot answer_shot(const SharedStudy& study, const std::string& question) {
  const bool holds = coulomb(study->rough.slope, study->rough.block).acceleration == 0;
  // No-break spaces keep a formula on one line.
  const std::string answer = fmt::format(
      "No: the mass cancels. Needed: m\u00a0g\u00a0sin\u00a0α. Allowed: μ\u00a0m\u00a0g\u00a0cos\u00a0α. "
      "Only tan\u00a0α\u00a0≤\u00a0μ counts, here {}\u00a0{}\u00a0{}. {}",
      fixed(std::tan(study->rough.slope.angle), 3), holds ? "≤" : ">",
      significant(study->rough.block.friction), holds ? "Both hold." : "Both slide.");
  Shot shot;
  shot.key = true;
  shot.state = significant(study->heavy.block.mass) + " kg · " + degrees(study->heavy.slope);
  shot.alt = question + " " + answer;
  shot.draw = [study, answer](Page& page) {
    const Layout layout = layout_of(page);
    const Camera camera = camera_of(layout.scene, study->heavy.slope);
    const std::string name = significant(study->heavy.block.mass) + " kg";
    draw_world(page, camera, study->heavy.frames.back(), {.names = {"", "", name}, .contacts = false});
    draw_bars(page, layout.upper, mass_bars(page, *study));
    page.note(layout.lower, "The answer", answer, question_growth);
  };
  return shot;
}

}  // namespace cairn::friction
