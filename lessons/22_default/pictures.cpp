// The bridge and its gaps, the beam, the bridge with a part of the default off, and what is beyond the
// border.
#include "lesson.hpp"

namespace cairn::usual {

namespace {

std::string millimetres(double metres) {
  if (metres < 1e-5) return "0 mm";
  return significant(1000 * metres, metres < 0.1 ? 2 : 3) + " mm";
}

/// How wide the gap between the banks of a bridge is.
void draw_width(Page& page, const Camera& camera, const Kind& kind) {
  const double end = kind.view.upper.x() - 1, below = -0.9;
  draw_length(page, camera.project({-end, below}), camera.project({end, below}),
              {.width = 2, .color = page.theme().secondary_text});
  page.canvas().text(camera.project({0, below}) - Point(0, 0.5 * page.label().size),
                     fmt::format("{:g} m", 2 * end), aligned(page.label(), Align::center));
}

void draw_scene(Page& page, const Rect& rect, const Kind& kind, const Snapshot& now, const std::string& title,
                bool has_width = false) {
  const Rect inside = page.panel(rect, title);
  const Camera camera = fit(inside, kind.view);
  page.canvas().push_clip(inside);
  draw_world(page, camera, now, {.numbers = false, .contacts = false, .penetration = false});
  if (has_width) draw_width(page, camera, kind);
  page.canvas().pop_clip();
}

/// How far the load of the bridge sinks with each part off, as points on a logarithmic axis.
void draw_parts(Page& page, const DefaultRuns& runs) {
  constexpr int decades = 3;
  const List<Outcome>& outcomes = runs.bridge.outcomes;
  const Rect inside = page.panel(in_rows(page, {1})[0], "the middle load sinks by, on a logarithmic axis");
  TextStyle name = page.label(), bold = page.label();
  name.size = bold.size = render::large_text;
  bold.bold = true;
  bold.halo = page.theme().panel;
  const double left = inside.x + page.canvas().text_width("one substep  ", name);
  const double decade =
      (inside.x + inside.width - left - page.canvas().text_width(" 592 mm", bold)) / decades;
  const double line = (inside.height - 2 * name.size) / outcomes.size(),
               bottom = inside.y + line * outcomes.size();
  for (int power = 0; power <= decades; ++power) {
    const double x = left + power * decade;
    page.canvas().line({x, inside.y}, {x, bottom}, {.width = page.sizes().grid, .color = page.theme().grid});
    page.canvas().text({x, bottom + 1.4 * page.tick().size}, fmt::format("{:g} mm", std::pow(10, power)),
                       aligned(page.tick(), Align::center));
  }
  for (int i = 0; i < outcomes.size(); ++i) {
    const double y = inside.y + line * (i + 0.5), base = y + 0.36 * name.size;
    const double width = decade * std::max(0.0, std::log10(1000 * outcomes[i].sunk));
    page.canvas().text({inside.x, base}, outcomes[i].name, name);
    page.canvas().circle({left + width, y}, 1.6 * page.sizes().marker, {.fill = page.theme().text});
    page.canvas().text({left + width + 18, base}, millimetres(outcomes[i].sunk), bold);
  }
}

void draw_beam(Page& page, const DefaultRuns& runs) {
  const List<Rect> parts = in_rows(page, {{0.76, {1, 1}}, 0.24});
  const Trials& trials = runs.beam;
  for (const int i : {0, 1}) {
    const Outcome& outcome = trials.outcomes[i];
    draw_scene(page, parts[i], trials.kind, outcome.lowest,
               fmt::format("{}: its end sinks by {}", outcome.name, millimetres(outcome.sunk)));
  }
  page.note(
      parts[2], "A load that is carried far",
      fmt::format("Row updates a step: {} by default, {} with 20 sweeps. Welds have nothing to guess, so one "
                  "linear system is enough.",
                  spaced(trials.outcomes[0].work), spaced(trials.outcomes[1].work)));
}

void draw_sweeps(Page& page, const DefaultRuns& runs) {
  const List<Rect> parts = in_rows(page, {0.76, 0.24});
  Plot plot{.title = "the load of the bridge sinks by (mm), against the work"};
  plot.x = {.title = "row updates a step", .scale = AxisScale::logarithmic, .min = 1e3, .max = 1e6};
  plot.y = {.scale = AxisScale::logarithmic, .min = 1, .max = 2000};
  Series sunk{.style = render::style_of_solver(page.theme(), "wide")};
  for (const SweepTrial& trial : runs.sweeps) {
    sunk.add(trial.work, 1000 * trial.sunk);
    if (trial.sweeps == 20 || trial.sweeps == runs.sweeps.back().sweeps)
      plot.labels.push_back({trial.work, 1000 * trial.sunk,
                             fmt::format("{} sweeps: {}", trial.sweeps, millimetres(trial.sunk))});
  }
  const Outcome& usual = runs.bridge.outcomes[nothing_off];
  Series exact{.style = render::style_of_solver(page.theme(), "newton")};
  exact.add(usual.work, 1000 * usual.sunk);
  plot.labels.push_back({usual.work, 1000 * usual.sunk, "all rows at once: " + millimetres(usual.sunk)});
  plot.series = {sunk, exact};
  draw_plot(page, parts[0], plot);
  page.note(
      parts[1], "Sweeps do not get there",
      fmt::format("Eight times the sweeps halve it. {} sweeps take {} row updates a step and still leave "
                  "{}; all rows at once take {}.",
                  runs.sweeps.back().sweeps, spaced(runs.sweeps.back().work),
                  millimetres(runs.sweeps.back().sunk), spaced(usual.work)));
}

Plot course_plot(const Page& page, const std::string& title, const List<double>& swept_metres,
                 const List<double>& exact_metres) {
  Plot plot{.title = title};
  plot.x = {.title = "step", .min = 0, .max = swept_metres.size()};
  plot.y = {.min = 0};
  const auto add = [&plot](const std::string& name, const SeriesStyle& style, const List<double>& metres) {
    Series& series = plot.series.emplace_back(Series{.name = name, .style = style, .markers = false});
    for (int k = 0; k < metres.size(); ++k) series.add(k + 1, 1000 * metres[k]);
  };
  add("20 sweeps", render::style_of_solver(page.theme(), "wide"), swept_metres);
  add("newton", render::style_of_solver(page.theme(), "newton"), exact_metres);
  return plot;
}

void draw_beyond(Page& page, const DefaultRuns& runs) {
  const List<Rect> parts = in_rows(page, {{0.74, {1, 1}}, 0.26});
  const Trials &tower = runs.large[the_tower], &pile = runs.large[the_large_pile];
  draw_plot(page, parts[0],
            course_plot(page, "the top of the tower sinks by (mm)", tower.outcomes[by_sweeps].sunk_by_step,
                        tower.outcomes[at_once].sunk_by_step));
  draw_plot(page, parts[1],
            course_plot(page, "the pile overlaps by (mm)", pile.outcomes[by_sweeps].overlap_by_step,
                        pile.outcomes[at_once].overlap_by_step));
  page.note(
      parts[2], "Beyond 300 freedoms",
      fmt::format("Row updates a step: the tower {} with sweeps and {} with newton, the pile {} and {}. "
                  "One border for both is wrong for the tower.",
                  spaced(tower.outcomes[by_sweeps].work), spaced(tower.outcomes[at_once].work),
                  spaced(pile.outcomes[by_sweeps].work), spaced(pile.outcomes[at_once].work)));
}

/// The joints of the left half, as they hang.
void draw_joints(Page& page, const Point& bank, double scale, const Snapshot& bridge) {
  const Vec2<double> first = bridge.joints[0].anchor_a;
  for (int i = 0; 2 * i < bridge.joints.size(); ++i) {
    const Vec2<double> at = bridge.joints[i].anchor_a - first;
    page.canvas().circle(bank + scale * Point(at.x(), -at.y()), 4,
                         {.fill = page.theme().panel, .outline = page.theme().text, .outline_width = 2});
  }
}

/// What half of the bridge was when level, what it would be if straight, and its joints, to scale.
void draw_triangle(Page& page, const Rect& rect, double half, const Snapshot& bridge) {
  const Rect inside = page.panel(rect, "half of the bridge, to scale; the circles are its joints");
  const double longer = longer_half(bridge), size = page.label().size, sag = hangs_by(half, longer);
  const double scale = (inside.width - 5 * size) / half, level = inside.y + 0.3 * inside.height;
  const Point bank = {inside.x, level}, middle = {inside.x + scale * half, level};
  const Point low = {middle.x(), level + scale * sag};
  page.canvas().line(bank, middle, {.width = page.sizes().axis, .color = page.theme().secondary_text});
  for (const Point& from : {middle, bank})
    page.canvas().line(from, low, {.width = page.sizes().curve, .color = page.theme().text});
  const TextStyle label = aligned(page.label(), Align::center);
  page.canvas().text({(bank.x() + middle.x()) / 2, level - 0.6 * size}, fmt::format("{:g} m, level", half),
                     label);
  page.canvas().text({bank.x() + 0.4 * scale * half, level + scale * sag / 2 + 2.4 * size},
                     fmt::format("{:.3f} m", half + longer), label);
  page.canvas().text({low.x() + 0.5 * size, level + scale * sag / 2 + 0.3 * size},
                     fmt::format("{:.0f} cm", 100 * sag), page.label());
  draw_joints(page, bank, scale, bridge);
}

void draw_gaps(Page& page, const DefaultRuns& runs) {
  const List<Rect> parts = in_columns(page, {0.44, {0.56, {0.5, 0.5}}});
  const Outcome& loose = runs.bridge.outcomes[swept];
  const List<SnapshotJoint>& joints = loose.lowest.joints;
  BarChart gaps{.title = "20 sweeps: the gap of each joint (mm)", .digits = 3};
  for (int i = 0; i < joints.size(); ++i)
    gaps.bars.push_back({.name = fmt::format("joint {}", i + 1), .before = 1000 * joints[i].drift});
  draw_bars(page, parts[0], gaps);
  const double half = 0.5 * runs.settings.planks, longer = longer_half(loose.lowest);
  draw_triangle(page, parts[1], half, loose.lowest);
  page.note(parts[2], "A root makes much of little",
            fmt::format(
                "All gaps together are {:.1f}\u00a0cm, so either half is {:.1f}\u00a0cm longer. Straight, it "
                "hangs by √(2 · {:g} m · {:.3f} m) = {:.0f}\u00a0cm. The bridge is curved: its load has "
                "sunk by {:.0f}\u00a0cm.",
                200 * longer, 100 * longer, half, longer, 100 * hangs_by(half, longer), 100 * loose.sunk));
}

Shot asking_shot(const Trials& loaded) {
  return question_shot(
      card(), {.state = fmt::format("after {:g} s", seconds),
               .alt = "A level bridge of planks between two banks with three loads on it, and the question",
               .scene =
                   [&loaded](Page& page, const Rect& rect) {
                     draw_scene(page, rect, loaded.kind, loaded.outcomes[nothing_off].last,
                                "the default: all rows at once", true);
                   },
               .place = ScenePlace::above});
}

Shot answering_shot(const Trials& loaded) {
  const Outcome& loose = loaded.outcomes[swept];
  return answer_shot(
      card(),
      {.state = "at the lowest",
       .alt = "The bridge hanging down under 20 sweeps, the question, and the answer.",
       .scene =
           [&loaded](Page& page, const Rect& rect) {
             draw_scene(page, rect, loaded.kind, loaded.outcomes[swept].lowest,
                        "20 sweeps in each solve, at the lowest");
           },
       .place = ScenePlace::above},
      fmt::format(
          "{:.0f} cm, though no joint opens by more than {:.0f} mm: a level chain that is a little longer "
          "hangs a lot lower.",
          100 * loose.sunk, std::ceil(1000 * loose.gap)));
}

}  // namespace

List<Shot> default_shots(const DefaultRuns& runs) {
  return {
      asking_shot(runs.bridge),
      key_shot(runs, "the gaps",
               "Bars of millimetres, one for each joint of the bridge; and a triangle, half of the "
               "bridge level and hanging, hardly longer but far lower.",
               draw_gaps),
      key_shot(runs, "more sweeps",
               "How far the load of the bridge sinks against the work of 20 to 640 sweeps, a line that "
               "falls slowly, and far below it the dot of all rows at once.",
               draw_sweeps),
      key_shot(runs, "beam",
               "The beam by default, level, and under 20 sweeps, its end more than two metres lower.",
               draw_beam),
      key_shot(runs, "one part off",
               "Points on a logarithmic axis, one for each part of the default that is off: the load of the "
               "bridge sinks least by default, and most under 20 sweeps.",
               draw_parts),
      key_shot(runs, "beyond 300 freedoms",
               "The top of the tower sinks ever faster under sweeps and not at all under newton; the "
               "pile overlaps by a few millimetres under both.",
               draw_beyond),
      answering_shot(runs.bridge)};
}

}  // namespace cairn::usual
