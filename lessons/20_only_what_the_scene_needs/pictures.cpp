// The scene with its islands, awake or asleep, and below it what each switch pays for this step.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <set>

#include "lessons/question.hpp"
#include "math/list.hpp"
#include "parts.hpp"
#include "render/draw.hpp"
#include "render/plot.hpp"

namespace cairn::needs {

namespace {

using render::fixed;
using render::Page;
using render::Rect;
using Run = std::shared_ptr<const NeedsRun>;

/// Horizontal bars, a number for each switch.
void draw_amounts(Page& page, const Rect& rect, std::string_view title, const NeedsRun& all,
                  const List<double>& amounts) {
  const Rect inside = page.panel(rect, title);
  const render::TextStyle name = page.tick();
  render::TextStyle value = page.tick();
  value.bold = true;
  value.color = page.theme().text;
  double names = 0;
  double most = 1;
  for (int i = 0; i < amounts.size(); ++i) {
    names = std::max(names, page.canvas().text_width(all.runs[i].switches.name, name));
    most = std::max(most, amounts[i]);
  }
  const double left = inside.x + names + 10;
  const double longest = inside.x + inside.width - left - page.canvas().text_width("9999999", value);
  const double line = inside.height / amounts.size();
  for (int i = 0; i < amounts.size(); ++i) {
    const double middle = inside.y + line * (i + 0.5);
    const double base = middle + 0.36 * name.size;
    const double width = longest * amounts[i] / most;
    page.canvas().text({inside.x, base}, all.runs[i].switches.name, name);
    page.canvas().rect({left, middle - 0.32 * line, width, 0.64 * line},
                       {.fill = page.theme().si.color, .outline = page.theme().outline, .outline_width = 1});
    page.canvas().text({left + width + 6, base}, fixed(amounts[i], 0), value);
  }
}

void draw_bill(Page& page, const Rect& rect, const NeedsRun& all, int step) {
  List<double> updates;
  for (const BillRun& run : all.runs) updates.push_back(static_cast<double>(run.steps[step - 1].updates));
  draw_amounts(page, rect, "row updates of this step", all, updates);
}

/// All of them are SI, so that they share its colour.
render::SeriesStyle style_of(const Page& page, int which) {
  const FixedList<render::Marker, 3> markers = {render::Marker::square, render::Marker::circle,
                                                render::Marker::triangle};
  const FixedList<List<double>, 3> dashes = {List<double>{10, 6}, {3, 4}, {}};
  return {.color = page.theme().si.color, .dash = dashes[which], .marker = markers[which]};
}

void draw_course(Page& page, const Rect& rect, const NeedsRun& all, int step) {
  render::Plot plot{.title = "row updates, step by step"};
  plot.x = {.title = "step", .min = 0, .max = all.settings.steps};
  double most = 1;
  int which = 0;
  for (const int i : {everything, sleeping, by_islands}) {
    List<double> updates = {std::numeric_limits<double>::quiet_NaN()};  // step 0 is not solved
    for (const StepBill& bill : all.runs[i].steps) {
      updates.push_back(static_cast<double>(bill.updates));
      most = std::max(most, updates.back());
    }
    plot.series.push_back(over_steps(all.runs[i].switches.name, style_of(page, which++), updates));
  }
  plot.y = {.min = 0, .max = 1.03 * most};
  plot.now = step;
  draw_plot(page, rect, plot);
}

void draw_step(Page& page, const NeedsRun& all, int step) {
  const List<Rect> parts = rows(page.area(), {0.5, 0.5}, page.sizes().gap);
  draw_scene(page, parts[0], all, step);
  const List<Rect> below = columns(parts[1], {0.46, 0.54}, page.sizes().gap);
  draw_bill(page, below[0], all, step);
  draw_course(page, below[1], all, step);
}

Shot step_shot(const Run& all, int step, bool key) {
  const StepBill& whole = all->runs[everything].steps[step - 1];
  const StepBill& asleep = all->runs[sleeping].steps[step - 1];
  const StepBill& alone = all->runs[by_islands].steps[step - 1];
  return {.state = fmt::format("step {} · {} of {} bodies awake", step, asleep.awake, whole.awake),
          .alt = fmt::format("Step {}: a pyramid, a tower, a chain and a ball; {} bodies are awake. Row "
                             "updates: {} with everything, {} with sleep, {} if each island ends by itself.",
                             step, asleep.awake, whole.updates, asleep.updates, alone.updates),
          .draw = [all, step](Page& page) { draw_step(page, *all, step); },
          .key = key};
}

std::string millimetres(double metres) { return fixed(1000 * metres, metres < 0.1 ? 1 : 0); }

void draw_total(Page& page, const Rect& rect, const NeedsRun& all) {
  List<double> thousands;
  for (const BillRun& run : all.runs) thousands.push_back(static_cast<double>(run.updates) / 1000);
  draw_amounts(page, rect, "row updates of all steps, thousands", all, thousands);
}

void draw_table(Page& page, const NeedsRun& all) {
  render::TableView table;
  table.header = {"switch", "rows", "least", "updates a step", "of all", "off before", "pyramid after (mm)"};
  const auto of_all = static_cast<double>(all.runs[everything].updates);
  for (const BillRun& run : all.runs) {
    table.rows.push_back({run.switches.name, fmt::format("{}", run.steps[0].rows),
                          fmt::format("{}", least_rows(run)),
                          fmt::format("{}", run.updates / all.settings.steps),
                          fixed(100 * static_cast<double>(run.updates) / of_all, 0) + " %",
                          millimetres(run.off_before), millimetres(run.off_after)});
  }
  const List<Rect> parts = rows(page.area(), {0.5, 0.5}, page.sizes().gap);
  page.table(parts[0], "", table);
  const List<Rect> below = columns(parts[1], {0.5, 0.5}, page.sizes().gap);
  draw_total(page, below[0], all);
  page.note(below[1], "Off",
            "How far bodies are from their places in a run with all rows, swept to R_{E} = 10^{−6}: any body "
            "before the ball hits (it is the top of the tower, which leans), boxes of the pyramid after it.",
            question_growth);
}

void draw_choice(Page& page, const NeedsRun&) {
  render::TableView table;
  table.header = {"the scene has", "take", "because", "lesson"};
  table.rows = {{"contacts and joints, as games have", "SI, warm", "no matrix", "06, 09"},
                {"a use for A itself, few rows", "PGS", "A shows which rows couple", "08, 10"},
                {"a processor for every row", "Jacobi, split", "no row waits", "16"},
                {"joints of two or three rows", "blocks", "their rows at once", "12"},
                {"springs, or rows that may give", "soft rows", "γ is all they add", "13"},
                {"towers, heavy on light", "more sweeps, substeps", "a sweep removes little", "18, 19"},
                {"things at rest", "sleep", "no rows at all", "20"}};
  const List<Rect> parts = rows(page.area(), {0.58, 0.42}, page.sizes().gap);
  table.text_columns = 4;
  page.table(parts[0], "", table);
  page.note(parts[1], "Section 5",
            "The paper ends with SI as the better choice in most situations: the same "
            "numbers as PGS, and easier to maintain. The lessons add when each of the others pays off. "
            "The cheapest row is the one that the scene does not need.",
            question_growth);
}

/// What becomes of the pyramid without friction, beside what should.
void draw_ruin(Page& page, const NeedsRun& all) {
  const List<Rect> parts = rows(page.area(), {0.62, 0.38}, page.sizes().gap);
  const List<Rect> sides = columns(parts[0], {0.5, 0.5}, page.sizes().gap);
  draw_pyramid(page, sides[0], all, everything);
  draw_pyramid(page, sides[1], all, no_friction);
  page.note(
      parts[1], "No friction",
      fmt::format("It saves nearly half of the row updates, and until the ball comes nothing needs the rows "
                  "that it leaves out. Then a row of boxes slides out: they are up to {} m off.",
                  fixed(all.runs[no_friction].off_after, 2)),
      question_growth);
}

QuestionFrame moment(const Run& all, int step, const std::string& state, const std::string& alt) {
  const auto scene = [all, step](Page& page, const Rect& rect) { draw_scene(page, rect, *all, step); };
  return {.state = state, .alt = alt, .scene = scene, .place = ScenePlace::above};
}

std::string answer_text(const NeedsRun& all) {
  const auto share = [&](int i) {
    return fixed(
        100 * static_cast<double>(all.runs[i].updates) / static_cast<double>(all.runs[everything].updates),
        0);
  };
  return fmt::format(
      "{} %. The tower needs all {} sweeps in most steps. In one piece, pyramid and chain are swept as "
      "often; by "
      "themselves they stop after a few. Sleep leaves {} %, both with shared friction {} %.",
      share(by_islands), all.settings.sweeps, share(sleeping), share(all_free));
}

/// Steps worth a frame of their own: early, asleep, touched, late.
std::set<int> key_steps(const NeedsRun& all) {
  std::set<int> keys = {1, all.settings.steps};
  if (all.touch > 2) keys.insert({all.touch - 2, all.touch + 2});
  return keys;
}

}  // namespace

List<Shot> needs_shots(const NeedsRun& recorded) {
  const Run all = std::make_shared<const NeedsRun>(recorded);
  List<Shot> shots = {
      question_shot(card(), moment(all, 0, "before the first step",
                                   "A pyramid, a tower, a chain and a ball in flight, and the question."))};
  const std::set<int> keys = key_steps(*all);
  std::set<int> steps = keys;
  for (int step = 2; step < all->settings.steps; step += 2) steps.insert(step);
  for (const int step : steps) shots.push_back(step_shot(all, step, keys.contains(step)));
  shots.push_back({.state = fmt::format("{} steps", all->settings.steps),
                   .alt = "A table: what each switch costs in rows and row updates, and how far it is off.",
                   .draw = [all](Page& page) { draw_table(page, *all); },
                   .key = true});
  if (all->touch > 0) {
    shots.push_back(
        {.state = fmt::format("step {}, with and without friction", all->settings.steps),
         .alt = "The pyramid after the hit: it stands with friction; without it a row of boxes has slid out.",
         .draw = [all](Page& page) { draw_ruin(page, *all); },
         .key = true});
  }
  shots.push_back({.state = "what to take when",
                   .alt = "A table: what a scene may have, and the solver or switch for it.",
                   .draw = [all](Page& page) { draw_choice(page, *all); },
                   .key = true});
  const std::string answer = answer_text(*all);
  shots.push_back(answer_shot(
      card(),
      moment(all, all->settings.steps, "the answer", "The scene at the end, and the answer: " + answer),
      answer));
  return shots;
}

}  // namespace cairn::needs
