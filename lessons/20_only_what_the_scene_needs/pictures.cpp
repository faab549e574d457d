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

/// Horizontal bars, a number for each switch.
void draw_amounts(Page& page, const Rect& rect, std::string_view title, const NeedsRun& all,
                  const List<double>& amounts, const std::string& unit, int digits) {
  const Rect inside = page.panel(rect, title);
  const TextStyle name = page.label();
  TextStyle value = page.label();
  value.bold = true;
  double names = 0;
  for (const BillRun& run : all.runs)
    names = std::max(names, page.canvas().text_width(run.switches.name, value));
  const double most = std::max(1.0, *std::max_element(amounts.begin(), amounts.end()));
  const double left = inside.x + names + 10;
  const double longest = inside.x + inside.width - left - page.canvas().text_width("9999999", value);
  const double line = inside.height / amounts.size();
  for (int i = 0; i < amounts.size(); ++i) {
    const double middle = inside.y + line * (i + 0.5), width = longest * amounts[i] / most;
    const double base = middle + 0.36 * name.size;
    page.canvas().text({inside.x, base}, all.runs[i].switches.name,
                       i == early || i == by_islands ? value : name);
    page.canvas().rect(
        {left, middle - 0.32 * line, width, 0.64 * line},
        {.fill = style_of(page, i).color, .outline = page.theme().outline, .outline_width = 1});
    page.canvas().text({left + width + 6, base}, fixed(amounts[i], digits) + unit, value);
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

/// The updates of all steps, in per cent of those of the run that leaves nothing out.
double share_of(const NeedsRun& all, int run) {
  return 100 * static_cast<double>(all.runs[run].updates) / static_cast<double>(all.runs[everything].updates);
}

void draw_shares(Page& page, const Rect& rect, const NeedsRun& all) {
  List<double> shares;
  for (int i = 0; i < all.runs.size(); ++i) shares.push_back(share_of(all, i));
  draw_amounts(page, rect, "row updates of all steps", all, shares, " %", 0);
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

/// Asleep, and awake again, in the run with all switches but one.
void draw_sleep(Page& page, const NeedsRun& all) {
  const List<Rect> parts = in_rows(page, {0.5, 0.5});
  for (int i = 0; i < parts.size(); ++i) {
    const int step = all.touch + (i == 0 ? -2 : 2);
    draw_scene(page, parts[i], all,
               {.title = fmt::format("all switches but \"no friction\", step {}; pale: asleep", step),
                .run = all_free,
                .step = step,
                .lines = swept_lines(all, all_free, step)});
  }
}

/// What each switch saves, and how much farther off it leaves bodies before the ball hits.
void draw_prices(Page& page, const NeedsRun& all) {
  const double usual = all.runs[everything].off_before;
  List<double> prices;
  for (const BillRun& run : all.runs) prices.push_back(1000 * std::max(0.0, run.off_before - usual));
  const List<Rect> parts = in_rows(page, {{0.66, {1, 1}}, 0.34});
  draw_shares(page, parts[0], all);
  draw_amounts(page, parts[1], "price: farther off by, before the ball hits", all, prices, " mm", 1);
  page.note(
      parts[2], "Farther off",
      fmt::format("With every row and every sweep the top of the tower is {} mm from its place in a run "
                  "swept to R_{{E}} = 10^{{−6}}. Ending early adds nothing to that. One friction row for two "
                  "adds a little, and no friction as much, until the ball comes.",
                  fixed(1000 * usual, 1)));
}

/// What becomes of the pyramid without friction, beside what should.
void draw_ruin(Page& page, const NeedsRun& all) {
  const List<Rect> parts = in_rows(page, {{0.62, {0.5, 0.5}}, 0.38});
  draw_pyramid(page, parts[0], all, everything);
  draw_pyramid(page, parts[1], all, no_friction);
  page.note(
      parts[2], "No friction",
      fmt::format("It saves nearly half of the row updates, and until the ball comes little is lost without "
                  "the rows that it leaves out. Then a row of boxes slides out: one of them ends {} m off.",
                  fixed(off_at_end(all, no_friction, farthest_box(all, no_friction)), 2)),
      question_growth);
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
      "pyramid, with the most rows, stops after {:.0f} sweeps on average. Sleep leaves {:.0f} %, all "
      "together "
      "{:.0f} %.",
      share_of(all, by_islands), mean_of(all.runs[by_islands], 0).sweeps, share_of(all, sleeping),
      share_of(all, all_free));
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
  shots.push_back(
      key_shot(all, "what it saves, and its price",
               "Two panels of bars: the row updates that each switch leaves, and how much farther off "
               "bodies are, 0 to 5 mm.",
               draw_prices));
  if (all.touch > 0) {
    shots.push_back(key_shot(
        all, fmt::format("step {}, with and without friction", all.settings.steps),
        "The pyramid after the hit: it stands with friction; without it a row of boxes has slid out.",
        draw_ruin));
  }
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
