// Lesson 11. Forces: what is needed, what is allowed, and how the bounds move within a step.
#include "lesson.hpp"

namespace cairn::friction {

namespace {

render::Bar named_bar(const std::string& name, double before, double added) {
  return {.name = name + " " + fixed(before + added, 2), .before = before, .added = added};
}

/// What the law allows each corner, and what its row gives.
BarChart force_bars(const Page& page, const Study& study, const Slide& slide) {
  BarChart chart = {.title = "friction of each corner (N)",
                    .largest = 1.1 * coulomb(slide.slope, study.rough.block).limit,
                    .color = page.theme().friction};
  const Snapshot& now = slide.frames[1];
  const double middle = now.bodies[first_block].pose.position.x();
  for (const bool upper : {true, false}) {
    const std::string name = upper ? "upper" : "lower";
    for (const SnapshotContact& contact : now.contacts) {
      if ((contact.position.x() < middle) != upper) continue;
      chart.bars.push_back(named_bar(name + " limit", contact.friction * contact.normal_impulse / now.dt, 0));
      chart.bars.push_back(named_bar(name + " given", 0, std::abs(contact.friction_impulse) / now.dt));
    }
  }
  return chart;
}

Equation limit_equation(const Slide& slide) {
  const Coulomb law = coulomb(slide.slope, slide.block);
  const bool holds = law.acceleration == 0;
  return {.number = "both corners together, paper 2.2",
          .symbols = "|λ_{t}| ≤ μ λ_{n}",
          .numbers = fmt::format("{} {} {} × {} = {} N", fixed(law.needed, 2), holds ? "≤" : ">",
                                 fixed(slide.block.friction, 2), fixed(law.load, 2), fixed(law.limit, 2)),
          .result = holds ? fmt::format("it holds: λ_{{t}} = {} N", fixed(law.needed, 2))
                          : fmt::format("it slides: a = {} m/s²", fixed(law.acceleration, 3)),
          .algorithm = holds ? "a row that is not clamped gets what it asks for"
                             : "Algorithm 1: clamp to the allowed interval"};
}

std::string state_of(const Slide& slide) {
  return significant(slide.slope.angle * 180 / pi) + "° · μ = " + fixed(slide.block.friction, 2);
}

TableView sweep_table(const Study& study) {
  const Slope& slope = study.settings.slope;
  TableView table = {
      .header = {"sweep", "upper λ_{n}", "± μ λ_{n}", "λ_{t}", "lower λ_{n}", "± μ λ_{n}", "λ_{t}"}};
  for (const int sweep : {1, 2, 3, 4, 5, 10, slope.sweeps}) {
    if (sweep >= study.by_hand.size()) break;
    List<std::string> row = {std::to_string(sweep)};
    for (const CornerRow normal : {upper_normal, lower_normal}) {
      const double load = study.by_hand[sweep][normal] / slope.dt;
      row.push_back(fixed(load, 2));
      row.push_back(fixed(study.settings.slippery * load, 2));
      row.push_back(fixed(study.by_hand[sweep][normal + 1] / slope.dt, 2));
    }
    table.rows.push_back(row);
  }
  table.active_row = table.rows.size() - 1;
  return table;
}

/// The upper corner: its friction, and the bound that moves with its load.
void draw_moving_bound(Page& page, const Rect& rect, const Study& study) {
  Series bound = {.name = "−μ λ_{n}", .style = page.theme().exact, .markers = false};
  Series friction = {.name = "λ_{t}",
                     .style = {.color = page.theme().friction, .dash = {}, .marker = Marker::circle}};
  for (int sweep = 1; sweep < std::min(study.by_hand.size(), 13); ++sweep) {
    const PerRow<double>& impulse = study.by_hand[sweep];
    bound.add(sweep, -study.settings.slippery * impulse[upper_normal] / study.settings.slope.dt);
    friction.add(sweep, impulse[upper_tangent] / study.settings.slope.dt);
  }
  draw_plot(page, rect,
            {.title = "upper corner: λ_{t} and its bound (N)",
             .x = {.title = "sweep"},
             .series = {bound, friction}});
}

/// The friction of both corners, and one line at half of it.
void draw_corner_bars(Page& page, const Rect& rect, const Study& study) {
  BarChart chart = {.title = "λ_{t} of each corner (N)", .color = page.theme().friction};
  for (const auto& [name, row] : {std::pair("upper", upper_tangent), std::pair("lower", lower_tangent)})
    chart.bars.push_back(named_bar(name, 0, std::abs(first_force(study, row))));
  const double half = coulomb(study.slippery.slope, study.slippery.block).given() / 2;
  const render::BarPlaces places = draw_bars(page, rect, chart);
  const double x = places.plot.x + places.plot.width * (half - places.low) / (places.high - places.low);
  page.canvas().line({x, places.rows.y}, {x, places.rows.y + places.rows.height},
                     {.width = 3, .color = page.theme().exact.color});
  const TextStyle text = page.label();
  page.canvas().text({x + 8, places.rows.y + places.pitch / 2 + 0.35 * text.size}, "half: " + fixed(half, 2),
                     text);
}

QuestionFrame corner_frame(const Study& study, Corners corners) {
  return {.state = state_of(study.slippery),
          .scene = [&study, corners](Page& page,
                                     const Rect& rect) { draw_corners(page, rect, study.slippery, corners); },
          .evidence = [&study](Page& page, const Rect& rect) { draw_corner_bars(page, rect, study); }};
}

/// The block at rest, or about to slide: the limit of each corner, and what it gives.
Shot force_shot(const Study& study, bool rough) {
  const Slide& slide = rough ? study.rough : study.slippery;
  const Coulomb law = coulomb(slide.slope, slide.block);
  return {.state = state_of(slide),
          .alt = fmt::format("A block on a slope, and at each corner its load and its friction inside the "
                             "brackets of its limit. "
                             "Together the loads are {} N, the friction is {} N and its limit {} N.",
                             fixed(law.load, 2), fixed(law.given(), 2), fixed(law.limit, 2)),
          .draw =
              [&study, rough](Page& page) {
                const Slide& shown = rough ? study.rough : study.slippery;
                const List<Rect> parts = in_columns(page, {50, {50, {50, 50}}});
                draw_corners(page, parts[0], shown, Corners::solved);
                draw_bars(page, parts[1], force_bars(page, study, shown));
                page.equation(parts[2], limit_equation(shown));
              },
          .key = rough};
}

/// The first step, sweep by sweep: bounds that move.
Shot sweep_shot(const Study& study) {
  return {
      .state = "first step, sweep by sweep",
      .alt =
          "A table: in each sweep the normal impulses of both corners change, and with them the bounds of "
          "the friction rows beside them. Below it λ_t of the upper corner meets its bound in sweep 4.",
      .draw =
          [&study](Page& page) {
            const List<Rect> parts = in_rows(page, {52, 48});
            page.table(parts[0], "λ of the two corners (N); λ_{t} is negative uphill", sweep_table(study));
            draw_moving_bound(page, parts[1], study);
          },
      .key = true};
}

}  // namespace

List<Shot> pictures(const Study& study) {
  QuestionFrame asked = corner_frame(study, Corners::asked);
  asked.alt =
      "A block on a slope of 30 degrees, a friction force of unknown size at each of its two corners, and "
      "the "
      "question.";
  List<Shot> shots = {question_shot(card(), asked), force_shot(study, true), force_shot(study, false),
                      sweep_shot(study)};
  const List<Shot> slide = slide_shots(study);
  shots.insert(shots.end(), slide.begin(), slide.end());
  const std::string answer = fmt::format(
      "{} N. Friction turns the block onto its lower corner, which carries {} of the {}\u00a0N. Its bound is "
      "μ times that.",
      fixed(std::abs(first_force(study, lower_tangent)), 2), fixed(first_force(study, lower_normal), 2),
      fixed(coulomb(study.slippery.slope, study.slippery.block).load, 2));
  QuestionFrame answered = corner_frame(study, Corners::solved);
  answered.alt = "The same block with the load and the friction of each corner on one scale. " + answer;
  shots.push_back(answer_shot(card(), answered, answer));
  return shots;
}

}  // namespace cairn::friction
