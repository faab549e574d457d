// Two towers side by side, cold and warm, above one chart that both share; the question and its answer.
#include "lesson.hpp"

namespace cairn::warm {

namespace {

FixedList<const StartRun*, 2> runs_of(const WarmStart& all) { return {&all.cold, &all.warm}; }

double largest_load(const WarmStart& all) {
  double largest = all.settings.weight();
  for (const StartRun* run : runs_of(all)) {
    for (const List<double>& frame : run->loads) {
      largest = std::max(largest, *std::max_element(frame.begin(), frame.end()));
    }
  }
  return largest;
}

constexpr int lately = 15;  // steps: a little more than one swing of the warm load

/// The least and the most that each contact has carried lately [N].
struct Range {
  List<double> least = {};
  List<double> most = {};
};

Range lately_carried(const StartRun& run, int frame) {
  Range range{.least = run.loads[frame], .most = run.loads[frame]};
  for (int k = std::max(1, frame - lately + 1); k < frame; ++k) {
    for (int i = 0; i < range.least.size(); ++i) {
      range.least[i] = std::min(range.least[i], run.loads[k][i]);
      range.most[i] = std::max(range.most[i], run.loads[k][i]);
    }
  }
  return range;
}

/// Where the top of the tower was at the start.
void draw_start_line(Page& page, const Camera& camera, double boxes) {
  page.canvas().line(camera.project({-1, boxes}), camera.project({1, boxes}),
                     {.width = 1.5, .color = page.theme().secondary_text, .dash = {6, 4}});
}

/// What the top of the tower does, and not only where it is.
std::string motion_of(const StartRun& run, int frame) {
  const double speed = std::round(1000 * run.frames[frame].bodies.back().velocity.y());
  if (speed == 0) return "nearly at rest";
  return fmt::format("{} at {:.0f} mm/s", speed < 0 ? "sinks" : "rises", std::abs(speed));
}

/// One start: its tower, its loads, and within which bounds the loads have been lately.
struct StartView {
  const StartRun& run;
  SeriesStyle style = {};
  std::string name = {};
  bool is_first = false;  // with what bars and ticks are
};

void draw_start(Page& page, const Rect& rect, const WarmStart& all, int frame, const StartView& shown) {
  const StartRun& run = shown.run;
  const std::string top = "top " + fixed(risen(run, frame), 0, Sign::always) + " mm";
  const bool is_wide = rect.width > 300;  // or there is room for the tower alone
  const Rect view = draw_solver_panel(page, rect, shown.style, shown.name, is_wide ? top : "");
  const Range range = lately_carried(run, frame);
  const Camera camera = draw_tower_loads(page, view, run.frames[frame], run.loads[frame],
                                         {.box_weight = gravity,
                                          .largest = largest_load(all),
                                          .color = shown.style.color,
                                          .least = range.least,
                                          .most = range.most});
  draw_start_line(page, camera, all.settings.boxes);
  if (frame == 0 || !is_wide) return;
  List<std::string> lines = {motion_of(run, frame),
                             range.most[0] - range.least[0] < 1
                                 ? fmt::format("λ_{{1}} {:.0f} N", range.most[0])
                                 : fmt::format("λ_{{1}} {:.0f} to {:.0f} N", range.least[0], range.most[0])};
  const bool swings = range.most[0] - range.least[0] >= 1;
  if (swings) lines.push_back(fmt::format("now {:.0f} N", run.loads[frame][0]));
  if (shown.is_first) lines.insert(lines.end(), {"bar: load", "tick: to carry"});
  if (shown.is_first && swings) lines.push_back(fmt::format("pale: last {} steps", lately));
  for (int i = 0; i < lines.size(); ++i) {
    TextStyle text = aligned(i < (swings ? 3 : 2) ? page.value() : page.secondary(), Align::right);
    page.canvas().text({view.x + view.width, view.y + 1.5 * (i + 1) * text.size}, lines[i], text);
  }
}

void draw_towers(Page& page, const Rect& rect, const WarmStart& all, int frame) {
  const List<Rect> panels = in_columns(page, rect, {1, 1});
  const FixedList<SeriesStyle, 3> styles = start_styles(page.theme());
  const FixedList<const StartRun*, 2> runs = runs_of(all);
  for (int s = 0; s < runs.size(); ++s) {
    const std::string name =
        fmt::format("{}, {} sweep{}", runs[s]->name, all.settings.sweeps, all.settings.sweeps > 1 ? "s" : "");
    draw_start(page, panels[s], all, frame, {*runs[s], styles[s], name, s == 0});
  }
}

void draw_load_plot(Page& page, const Rect& rect, const WarmStart& all, int frame) {
  Plot plot{.title = fmt::format("load λ_{{1}} on the lowest box, step by step; to carry: {:g} N",
                                 all.settings.weight())};
  constexpr int near = 30;  // steps that the first frames show
  const int shown = frame <= near ? near : all.settings.steps;
  plot.x = {.title = "step", .min = 0, .max = shown};
  plot.y = {.min = 0, .max = 1.15 * largest_load(all)};
  const FixedList<SeriesStyle, 3> styles = start_styles(page.theme());
  const FixedList<const StartRun*, 2> runs = runs_of(all);
  for (int s = 0; s < runs.size(); ++s) {
    Series series{.name = runs[s]->name, .style = styles[s]};
    for (int k = 0; k <= shown; ++k) series.add(k, runs[s]->loads[k][0]);
    plot.series.push_back(series);
  }
  plot.goals.push_back({all.settings.weight(), ""});
  plot.now = frame;
  draw_plot(page, rect, plot);
}

void draw_step(Page& page, const WarmStart& all, int frame) {
  const List<Rect> parts = in_rows(page, {0.57, 0.43});
  draw_towers(page, parts[0], all, frame);
  draw_load_plot(page, parts[1], all, frame);
}

/// A tower of the question: the cold one as its last step leaves it, the warm one before the first.
void draw_asked(Page& page, const Rect& rect, const WarmStart& all, bool is_warm) {
  const double boxes = all.settings.boxes, sunk = -risen(all.many_cold, question_steps);
  const SeriesStyle style = start_styles(page.theme())[is_warm ? 1 : 0];
  const Rect view = draw_solver_panel(page, rect, style, is_warm ? all.one_warm.name : all.many_cold.name,
                                      is_warm ? "top −? mm" : fmt::format("top −{:.0f} mm", sunk));
  const StartRun& run = is_warm ? all.one_warm : all.many_cold;
  const int frame = is_warm ? 0 : question_steps;
  const Camera camera =
      draw_tower_loads(page, view, run.frames[frame], run.loads[frame],
                       {.box_weight = gravity, .largest = 1.2 * all.settings.weight(), .color = style.color});
  draw_start_line(page, camera, boxes);
  const List<std::string> lines =
      is_warm ? List<std::string>{"step 1: from zero,", "then from the last", "one's impulses"}
              : List<std::string>{"each step begins", "from zero", "bar: load", "tick: to carry"};
  for (int i = 0; i < lines.size(); ++i) {
    const TextStyle text = aligned(!is_warm && i >= 2 ? page.secondary() : page.value(), Align::right);
    page.canvas().text({view.x + view.width, view.y + 1.5 * (i + 1) * text.size}, lines[i], text);
  }
}

/// Where the tops have been.
void draw_tops(Page& page, const Rect& rect, const WarmStart& all) {
  const FixedList<SeriesStyle, 3> styles = start_styles(page.theme());
  Plot plot{.title = "how far the tops have moved (mm)"};
  plot.x = {.title = "step", .min = 0, .max = question_steps};
  plot.y = {.min = 1.1 * lowest(all.many_cold), .max = 0};
  const auto add = [&](const StartRun& run, const SeriesStyle& style) {
    List<double> tops;
    for (int k = 0; k <= question_steps; ++k) tops.push_back(risen(run, k));
    plot.series.push_back(over_steps(run.name, style, tops));
  };
  add(all.many_cold, styles[0]);
  add(all.one_warm, styles[1]);
  draw_plot(page, rect, plot);
}

QuestionFrame asked(const WarmStart& all) {
  return {.state = fmt::format("after {} steps, and before the first", question_steps),
          .alt = fmt::format(
              "A tower of {} boxes has sunk with {} cold sweeps in each step. Another begins each step with "
              "the impulses of the last, does one sweep, and has not begun to sink.",
              all.settings.boxes, many_sweeps),
          .scene = [&all](Page& page, const Rect& rect) {
            const List<Rect> parts = in_columns(page, rect, {1, 1});
            draw_asked(page, parts[0], all, false);
            draw_asked(page, parts[1], all, true);
          }};
}

/// Both towers of the question at the end, and how they came there.
QuestionFrame answered(const WarmStart& all) {
  const auto draw = [&all](Page& page, const Rect& rect) {
    const List<Rect> parts = in_rows(page, rect, {{0.5, {1, 1}}, 0.5});
    const FixedList<SeriesStyle, 3> styles = start_styles(page.theme());
    draw_start(page, parts[0], all, question_steps, {all.many_cold, styles[0], all.many_cold.name, true});
    draw_start(page, parts[1], all, question_steps, {all.one_warm, styles[1], all.one_warm.name});
    draw_tops(page, parts[2], all);
  };
  return {.state = fmt::format("after {} steps", question_steps),
          .alt = "Both towers at the end, how they sank, and the answer.",
          .scene = draw};
}

LessonInfo card_for(const WarmStart& all) {
  LessonInfo info = card();
  info.question = question_of(all);
  return info;
}

Shot step_shot(const WarmStart& all, int frame) {
  return {.state = fmt::format("step {} · t = {} s", frame, fixed(frame * all.settings.dt, 2)),
          .alt = fmt::format(
              "Step {}: the lowest box carries {:.2f} N cold and {:.2f} N warm; the tops have moved by "
              "{:+.0f} mm and {:+.0f} mm.",
              frame, all.cold.loads[frame][0], all.warm.loads[frame][0], risen(all.cold, frame),
              risen(all.warm, frame)),
          .draw = [&all, frame](Page& page) { draw_step(page, all, frame); }};
}

std::string answer_text(const WarmStart& all) {
  return fmt::format(
      "{} mm in place of {}. The tower falls until its impulses have grown, swings, and comes to rest. "
      "Cold, the loads are right at last, but the tower {}.",
      fixed(-risen(all.one_warm, question_steps), 0), fixed(-risen(all.many_cold, question_steps), 0),
      motion_of(all.many_cold, question_steps));
}

}  // namespace

FixedList<SeriesStyle, 3> start_styles(const Theme& theme) {
  const List<SeriesStyle> neutral = render::neutral_styles(theme);
  SeriesStyle cold = neutral[1];
  cold.dash = {};  // without colour, dashes and marks tell it from the warm one
  cold.marker = Marker::circle;
  return {{cold, theme.si, neutral[3]}};  // all are SI: the warm one is what is meant by it
}

List<Shot> start_shots(const WarmStart& all) {
  const int last = all.settings.steps;
  const std::set<int> keys = {5, last};
  List<Shot> shots = {question_shot(card_for(all), asked(all))};
  for (int k = 1; k <= last; ++k) {
    shots.push_back(step_shot(all, k));
    shots.back().key = keys.contains(k);
  }
  shots.push_back(order_shot(all));
  shots.push_back(answer_shot(card_for(all), answered(all), answer_text(all)));
  return shots;
}

}  // namespace cairn::warm
