// A bead aside and the swing that a step makes of it, chains under four solvers, growth against load, and
// cures.
#include "lesson.hpp"
#include "render/solver_style.hpp"

namespace cairn::taut {

namespace {

void draw_chain(Page& page, const Rect& rect, const ChainRuns& runs, const Snapshot& chain,
                const std::string& title) {
  const double depth = (runs.settings.beads + 1) * rod_length;
  const Camera camera = fit(page.panel(rect, title), {{-1, -1.2 * depth - 0.5}, {1, 0.2}});
  draw_world(page, camera, chain, {.numbers = false, .contacts = false, .penetration = false});
}

/// A bead beside the line by 1, its neighbours at `beside`, and what its two rods do to it.
void draw_aside(Page& page, const Rect& rect, double beside, const std::string& title,
                const std::string& sum) {
  const Camera camera = fit(page.panel(rect, title), {{-0.78, -2.2}, {0.45, 0.2}});
  const double x = 0.3;  // [m]
  const List<Vec2<double>> places = {{beside * x, 0}, {x, -1}, {beside * x, -2}};
  for (int i = 0; i < 2; ++i)
    page.canvas().line(camera.project(places[i]), camera.project(places[i + 1]),
                       {.width = page.sizes().outline, .color = page.theme().secondary_text});
  page.canvas().line(camera.project({0, 0.15}), camera.project({0, -2.15}),
                     {.width = page.sizes().grid, .color = page.theme().secondary_text});
  for (const Vec2<double>& place : places)
    page.canvas().circle(camera.project(place), page.sizes().marker + 2, {.fill = page.theme().outline});
  const ArrowScale scale{.pixels_per_unit = 0.5 * camera.scale, .longest = camera.scale, .unit = "f"};
  Vec2<double> both = {0, 0};
  for (const int end : {0, 2}) {
    const Vec2<double> along = (places[end] - places[1]).normalized();
    both += along;
    draw_arrow(page, camera, scale,
               {.kind = ArrowKind::joint, .tail = places[1], .value = along, .label = "f"});
  }
  draw_arrow(page, camera, scale,
             {.kind = ArrowKind::external, .tail = places[1], .value = both, .label = sum});
}

/// What steps make of a swing, from rest.
Plot swing_plot(const Page& page) {
  Plot plot{.title = "x after each step, if it begins at 1"};
  plot.x = {.title = "step", .min = 0, .max = 8};
  plot.y = {.min = -16, .max = 16};
  const List<SeriesStyle> styles = render::neutral_styles(page.theme());
  const FixedList<double, 3> angles = {0.5, 1.9, 2.1};
  for (int i = 0; i < 3; ++i) {
    List<double> x = {1};
    for (double before = 1; x.size() <= 8;) {
      const double next = 2 * x.back() - before - angles[i] * angles[i] * x.back();
      before = x.back();
      x.push_back(next);
    }
    plot.series.push_back(over_steps(fmt::format("ω Δt = {:g}", angles[i]), styles[i], x));
  }
  return plot;
}

void draw_swing(Page& page, const ChainRuns&) {
  const List<Rect> parts = in_columns(page, {0.24, 0.24, {0.52, {0.64, 0.36}}});
  draw_aside(page, parts[0], 0, "one bead aside by x", "2 f x / l");
  draw_aside(page, parts[1], -1, "its neighbours by −x", "4 f x / l");
  draw_plot(page, parts[2], swing_plot(page));
  page.note(parts[3], "A step keeps both directions",
            "It pulls as hard all the way, even where the bead has long passed the line. Below ω Δt = 2 the "
            "swing stays within a bound, 3.2 at 1.9; above, each swing is wider than the one before.");
}

std::string short_name(const ChainRuns& runs) { return "steps of " + part_name(runs.settings); }

/// What fails, and the four that the question names.
List<const ChainRun*> asked(const ChainRuns& runs) {
  return {&runs.sweeps[ten_sweeps], &runs.sweeps[many_sweeps], &runs.sweeps[exactly],
          &runs.cures[short_steps], &runs.cures[heavier]};
}

void draw_asked(Page& page, const ChainRuns& runs, int step) {
  const List<Rect> parts = in_columns(page, {1, 1, 1, 1, 1});
  const FixedList<std::string, 5> titles = {"10 sweeps", "(1) 10 000 sweeps", "(2) exact",
                                            "(3) " + short_name(runs), "(4) twice the mass"};
  const List<const ChainRun*> chains = asked(runs);
  for (int i = 0; i < chains.size(); ++i)
    draw_chain(page, parts[i], runs, chains[i]->frames[step], titles[i]);
}

Shot asked_shot(const ChainRuns& runs, int step) {
  std::string alt =
      fmt::format("After {} steps under {:g} kg, farthest bead from the line:", step, runs.settings.load);
  for (const ChainRun* run : asked(runs)) alt += fmt::format(" {:.2g} m, {};", run->off[step], run->name);
  alt.back() = '.';
  return {.state = fmt::format("{:g} kg · step {}", runs.settings.load, step),
          .alt = alt,
          .draw = [&runs, step](Page& page) { draw_asked(page, runs, step); },
          .key = step == 20 || step == 60};
}

Plot off_plot(const Page& page, const List<const ChainRun*>& all) {
  Plot plot{.title = "farthest bead from the line (m)"};
  plot.x = {.title = "step", .min = 0, .max = film_steps};
  plot.y = {.scale = AxisScale::logarithmic, .min = 1e-5, .max = 10};
  const List<SeriesStyle> styles = render::neutral_styles(page.theme());
  for (int i = 0; i < all.size(); ++i) {
    plot.series.push_back(over_steps(all[i]->name, styles[i], all[i]->off));
    plot.series.back().markers = false;
  }
  plot.goals.push_back({lost, "lost"});
  return plot;
}

Plot growth_plot(const Page& page, const ChainRuns& runs) {
  const double most = 2.1 * runs.criticals[0].predicted;
  Plot plot{.title = "a step multiplies the zigzag by"};
  plot.x = {.title = "load (kg)", .min = 0, .max = most};
  plot.y = {.min = 0, .max = 7};
  Series formula{.name = "formula", .style = page.theme().exact, .markers = false};
  ChainSettings loaded = runs.settings;
  for (int i = 1; i <= 400; ++i) {
    loaded.load = i * most / 400;
    formula.add(loaded.load, growth_by_formula(fastest_angle(loaded)));
  }
  Series measured{.name = "measured", .style = render::neutral_styles(page.theme())[1], .line = false};
  for (const Growth& each : runs.growths) measured.add(each.load, each.measured);
  plot.series = {formula, measured};
  plot.cursor = runs.criticals[0].predicted;
  return plot;
}

void draw_growth(Page& page, const ChainRuns& runs) {
  const List<Rect> parts = in_rows(page, {{0.72, {1, 1}}, 0.28});
  draw_plot(page, parts[0], growth_plot(page, runs));
  draw_plot(page, parts[1], off_plot(page, {&runs.sweeps[exactly], &runs.sweeps[ten_sweeps]}));
  page.note(parts[2], "Not the solve: the step",
            fmt::format(
                "Left: squares are measured, the upright line is where ω Δt = 2. Right, under {:g} kg: "
                "solved exactly, one step makes {:.0f} mm of {:g} mm. Ten sweeps take some steps "
                "to find the pull; then they do the same.",
                runs.settings.load, 1000 * runs.sweeps[exactly].off[1], 1000 * runs.sweeps[exactly].off[0]));
}

void draw_cures(Page& page, const ChainRuns& runs) {
  const List<Rect> parts = in_rows(page, {{0.72, {0.2, 0.2, 0.6}}, 0.28});
  draw_chain(page, parts[0], runs, runs.cures[heavier].frames.back(), "twice the mass");
  draw_chain(page, parts[1], runs, runs.cures[enough_mass].frames.back(), "enough mass");
  draw_plot(page, parts[2],
            off_plot(page, {&runs.cures[heavier], &runs.cures[enough_mass], &runs.cures[short_steps]}));
  page.note(parts[3], "The mass that cures it",
            fmt::format(
                "With {:.3g} kg for the first bead, and a little less for each one below, ω Δt is 2 at most. "
                "Weights stay as they are.",
                masses_needed(runs.settings)[0]));
}

Shot answering_shot(const ChainRuns& runs) {
  const auto evidence = [&runs](Page& page, const Rect& rect) {
    draw_plot(page, rect, growth_plot(page, runs));
  };
  return answer_shot(
      card(),
      {.state = fmt::format("after step {}", film_steps),
       .alt = "The exactly solved chain in pieces, the one with steps of a quarter straight, the question, "
              "the answer, and the curve of growth against load.",
       .scene =
           [&runs](Page& page, const Rect& rect) {
             const List<Rect> parts = in_columns(page, rect, {1, 1});
             draw_chain(page, parts[0], runs, runs.sweeps[exactly].frames.back(), "(2) exact");
             draw_chain(page, parts[1], runs, runs.cures[short_steps].frames.back(),
                        "(3) " + short_name(runs));
           },
       .evidence = evidence},
      fmt::format("(3). A chain holds up to ω Δt = 2: {:.1f} kg here, twice that with twice the mass, and "
                  "sixteen times that with steps of a quarter. How well rows are solved is not what decides.",
                  runs.criticals[0].predicted));
}

}  // namespace

List<Shot> chain_shots(const ChainRuns& runs) {
  const auto draw_scene = [&runs](Page& page, const Rect& rect) {
    const List<Rect> parts = in_columns(page, rect, {1, 1});
    const List<Snapshot>& frames = runs.sweeps[ten_sweeps].frames;
    draw_chain(page, parts[0], runs, frames[0], "10 sweeps, at the start");
    draw_chain(page, parts[1], runs, frames[20], "10 sweeps, after step 20");
  };
  List<Shot> shots = {
      question_shot(card(), {.state = fmt::format("{:g} kg", runs.settings.load),
                             .alt = "A chain of light beads on rods with a large weight below: straight "
                                    "at the start, a zigzag after step 20; and the question",
                             .scene = draw_scene})};
  shots.push_back(
      key_shot(runs, "one bead · x drawn large",
               "Left: a bead beside the line of its neighbours, pulled back by both rods, and the same with "
               "its neighbours on the other side, pulled twice as hard. Right: with ω Δt = 0.5 and 1.9 it "
               "swings, with 2.1 each swing is wider than the one before.",
               draw_swing));
  for (int k = 1; k <= film_steps; ++k) shots.push_back(asked_shot(runs, k));
  shots.push_back(
      key_shot(runs, "growth",
               "Left: the factor by which a step multiplies the zigzag, 1 up to the critical load and "
               "rising from there, measured points on the curve. Right: the exactly solved chain is 12 mm "
               "off after one step, that under ten sweeps begins to grow at step 12; both rise above 0.1 m.",
               draw_growth));
  shots.push_back(key_shot(runs, "cures",
                           "A chain in pieces with twice the mass, one that hangs with the mass needed, and "
                           "the distance from the line of both and with steps of a quarter.",
                           draw_cures));
  shots.push_back(answering_shot(runs));
  return shots;
}

}  // namespace cairn::taut
