// The scene with its islands, awake or asleep, and below it what each switch pays for this step.
#include "lesson.hpp"
#include "render/solver_style.hpp"

namespace cairn::needs {

namespace {

/// The runs that the question compares have looks of their own.
SeriesStyle style_of(const Page& page, int run) {
  const List<SeriesStyle> styles = render::neutral_styles(page.theme());
  if (run == early) return styles[0];
  return run == by_islands ? styles[1] : SeriesStyle{.color = page.theme().body};
}

/// The updates of all steps, in per cent of those of the run that leaves nothing out.
double share_of(const NeedsRun& all, int run) {
  return 100 * static_cast<double>(all.runs[run].updates) / static_cast<double>(all.runs[everything].updates);
}

/// What each run leaves, as horizontal bars.
void draw_shares(Page& page, const Rect& rect, const NeedsRun& all) {
  const Rect inside = page.panel(rect, "row updates of all steps");
  const TextStyle name = page.label();
  TextStyle value = page.label();
  value.bold = true;
  double names = 0;
  for (const BillRun& run : all.runs)
    names = std::max(names, page.canvas().text_width(run.switches.name, value));
  const double left = inside.x + names + 10;
  const double longest = inside.x + inside.width - left - page.canvas().text_width("9999999", value);
  const double line = inside.height / all.runs.size();
  for (int i = 0; i < all.runs.size(); ++i) {
    const double middle = inside.y + line * (i + 0.5), width = longest * share_of(all, i) / 100;
    const double base = middle + 0.36 * name.size;
    page.canvas().text({inside.x, base}, all.runs[i].switches.name,
                       i == early || i == by_islands ? value : name);
    page.canvas().rect(
        {left, middle - 0.32 * line, width, 0.64 * line},
        {.fill = style_of(page, i).color, .outline = page.theme().outline, .outline_width = 1});
    page.canvas().text({left + width + 6, base}, fixed(share_of(all, i), 0) + " %", value);
  }
}

/// Each island rows wide and sweeps high, so that its area is its bill, in the outline of all sweeps.
void draw_areas(Page& page, const Rect& rect, const NeedsRun& all, int step) {
  const Rect inside = page.panel(rect, "area: rows (wide) × sweeps (high); outline: all sweeps");
  const TextStyle text = aligned(page.label(), Align::center);
  const List<StageBill>& stages = all.runs[by_islands].steps[step - 1].stages;
  int rows = 0;
  for (const StageBill& stage : stages) rows += stage.rows;
  const double gap = page.canvas().text_width("chain 5000", text);
  const double base = inside.y + inside.height - 1.5 * text.size;
  const double wide = (inside.width - 3 * gap) / rows, high = (base - inside.y - 4) / all.settings.sweeps;
  const FixedList<std::string, 3> names = {"pyramid", "tower", "chain"};
  double left = inside.x + gap / 2;
  for (int i = 0; i < names.size(); ++i) {
    const double width = wide * stages[i].rows, height = high * stages[i].sweeps;
    const double most = high * all.settings.sweeps;
    page.canvas().rect({left, base - height, width, height}, {.fill = style_of(page, by_islands).color});
    page.canvas().rect({left, base - most, width, most},
                       {.outline = page.theme().outline, .outline_width = page.sizes().axis});
    page.canvas().text({left + width / 2, base + 1.3 * text.size},
                       fmt::format("{} {}", names[i], stages[i].rows * stages[i].sweeps), text);
    left += width + gap;
  }
}

/// A line that is level in each step.
void draw_course(Page& page, const Rect& rect, const NeedsRun& all, int step) {
  Plot plot{.title = "row updates, step by step"};
  plot.x = {.title = "step", .min = 0, .max = all.settings.steps};
  for (const int i : {early, by_islands}) {
    Series series{.name = all.runs[i].switches.name, .style = style_of(page, i), .markers = false};
    for (int k = 0; k < all.settings.steps; ++k) {
      const auto updates = static_cast<double>(all.runs[i].steps[k].updates);
      series.x.insert(series.x.end(), {static_cast<double>(k), k + 1.0});
      series.y.insert(series.y.end(), {updates, updates});
    }
    plot.series.push_back(series);
  }
  plot.y = {.min = 0};
  plot.now = step;
  draw_plot(page, rect, plot);
}

void draw_step(Page& page, const NeedsRun& all, int step) {
  const List<Rect> parts = in_rows(page, {0.56, {0.44, {0.44, 0.56}}});
  draw_scene(page, parts[0], all,
             {.title = "exit by island: rows × sweeps of this step",
              .step = step,
              .lines = swept_lines(all, by_islands, step)});
  draw_areas(page, parts[1], all, step);
  draw_course(page, parts[2], all, step);
}

Shot step_shot(const NeedsRun& all, int step, bool key) {
  const StepBill& whole = all.runs[everything].steps[step - 1];
  const StepBill& alone = all.runs[by_islands].steps[step - 1];
  return {.state = fmt::format("step {} · {} of {} row updates", step, alone.updates, whole.updates),
          .alt = fmt::format("Step {}: a pyramid, a tower, a chain and a ball. Row updates: {} with all "
                             "sweeps, {} if each island ends by itself. An area for each island.",
                             step, whole.updates, alone.updates),
          .draw = [&all, step](Page& page) { draw_step(page, all, step); },
          .key = key};
}

/// Asleep, and awake again, in the run that sleeps.
void draw_sleep(Page& page, const NeedsRun& all) {
  const List<Rect> parts = in_rows(page, {0.5, 0.5});
  for (int i = 0; i < parts.size(); ++i) {
    const int step = all.touch + (i == 0 ? -2 : 2);
    draw_scene(page, parts[i], all,
               {.title = fmt::format("sleep: step {}; pale: asleep", step),
                .run = sleeping,
                .step = step,
                .lines = swept_lines(all, sleeping, step)});
  }
}

/// "1820 of 2000": what each island takes by itself, and what all sweeps would be.
List<std::string> mean_lines(const NeedsRun& all) {
  const BillRun& run = all.runs[by_islands];
  List<std::string> lines;
  for (int i = 0; i < run.steps[0].stages.size(); ++i)
    lines.push_back(fmt::format("{:.0f} of {}", mean_of(run, i).updates,
                                run.steps[0].stages[i].rows * all.settings.sweeps));
  return lines;
}

std::string answer_text(const NeedsRun& all) {
  return fmt::format(
      "{:.0f} %. In one piece, a step ends for all together, mostly late, because of the tower. By itself "
      "the "
      "pyramid, with the most rows, stops after {:.0f} sweeps on average.",
      share_of(all, by_islands), mean_of(all.runs[by_islands], 0).sweeps);
}

/// Steps worth a frame of their own: the first, asleep, touched, the last.
std::set<int> key_steps(const NeedsRun& all) {
  std::set<int> keys = {1, all.settings.steps};
  if (all.touch > 2) keys.insert({all.touch - 2, all.touch + 2});
  return keys;
}

Shot answering_shot(const NeedsRun& all) {
  const auto draw_answer = [&all](Page& page, const Rect& rect) {
    const List<Rect> parts = in_rows(page, rect, {0.45, 0.55});
    draw_scene(page, parts[0], all,
               {.title = "exit by island: row updates a step, on average",
                .step = all.settings.steps,
                .lines = mean_lines(all)});
    draw_shares(page, parts[1], all);
  };
  const std::string answer = answer_text(all);
  return answer_shot(
      card(),
      {.state = "the answer",
       .alt = "The scene at the end, the row updates of each run as bars, and the answer: " + answer,
       .scene = draw_answer},
      answer);
}

}  // namespace

List<Shot> needs_shots(const NeedsRun& all) {
  List<Shot> shots = {
      question_shot(card(), {.state = "before the first step",
                             .alt = "A pyramid, a tower, a chain and a ball in flight, and the question",
                             .scene =
                                 [&all](Page& page, const Rect& rect) {
                                   draw_scene(page, rect, all, {.lines = swept_lines(all, by_islands, 0)});
                                 },
                             .place = ScenePlace::above})};
  const std::set<int> keys = key_steps(all);
  std::set<int> steps = keys;
  for (int step = 2; step < all.settings.steps; step += 2) steps.insert(step);
  for (const int step : steps) shots.push_back(step_shot(all, step, keys.contains(step)));
  if (all.touch > 2 && all.touch + 2 <= all.settings.steps) {
    shots.push_back(key_shot(all, fmt::format("the steps {} and {}", all.touch - 2, all.touch + 2),
                             "The scene twice: the pyramid is asleep and has no rows; then the ball has "
                             "touched it, and it is awake.",
                             draw_sleep));
  }
  shots.push_back(answering_shot(all));
  return shots;
}

}  // namespace cairn::needs
