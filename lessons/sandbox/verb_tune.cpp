// cairn tune: the cheapest setting that meets a wish.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lessons/kit/words.hpp"
#include "lessons/sandbox/interrupt.hpp"
#include "lessons/sandbox/scene_words.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/study/build_info.hpp>
#include <cairn/study/tuning/tuner.hpp>

namespace cairn::sandbox {
namespace {

using Json = nlohmann::ordered_json;
using Color = Console::Color;

constexpr double longest_run = 1e5;  // [s]

/// What is wished, or else what the scene expects.
Wish wish_of(const Words& words, const SceneEntry& scene, double seconds) {
  Wish wish;
  if (words.has("penetration")) wish.penetration = words.quantity("penetration", "m", 0);
  if (words.has("drift")) wish.drift = words.quantity("drift", "m", 0);
  if (words.has("residual")) wish.residual = words.number("residual", 0, 1e-14, 1);
  if (words.has("energy-gain")) wish.energy_gain = words.quantity("energy-gain", "%", 0);
  if (words.has("stands")) wish.stands = words.quantity("stands", "s", 0, longest_run);
  if (!wish.is_empty()) return wish;
  wish = cairn::wish_of(scene);
  if (wish.is_empty()) {
    throw UsageError(
        "cairn tune: a wish is missing, and the scene expects nothing ([expect] in its file): --penetration "
        "2mm, --drift 1mm, --residual 0.01, --energy-gain 1% or --stands 10s");
  }
  if (wish.stands) wish.stands = seconds;
  if (seconds < scene.seconds) wish.places.clear();  // they are of its end
  return wish;
}

std::string wish_text(const Wish& wish) {
  List<std::string> parts;
  if (wish.penetration) parts.push_back(fmt::format("penetration at most {:g} mm", 1e3 * *wish.penetration));
  if (wish.drift) parts.push_back(fmt::format("drift at most {:g} mm", 1e3 * *wish.drift));
  if (wish.residual) parts.push_back(fmt::format("R_E at most {:g}", *wish.residual));
  if (wish.energy_gain) parts.push_back(fmt::format("energy gain at most {:g} %", 1e2 * *wish.energy_gain));
  if (wish.energy_loss) parts.push_back(fmt::format("energy loss at most {:g} %", 1e2 * *wish.energy_loss));
  if (wish.stands) parts.push_back(fmt::format("stands {:g} s", *wish.stands));
  if (!wish.places.empty()) parts.push_back("bodies end in their places");
  return joined(parts, ", ");
}

std::string found_text(const Candidate& candidate, const Wish& wish) {
  std::string text;
  if (wish.penetration) text += fmt::format(", penetration {:.3g} mm", 1e3 * candidate.worst_penetration);
  if (wish.drift) text += fmt::format(", drift {:.3g} mm", 1e3 * candidate.worst_drift);
  if (wish.residual) text += fmt::format(", R_E {:.2g}", candidate.worst_residual);
  if (wish.energy_gain) text += fmt::format(", energy gain {:.3g} %", 1e2 * candidate.energy_gain);
  if (wish.energy_loss) text += fmt::format(", energy loss {:.3g} %", 1e2 * candidate.energy_loss);
  if (wish.stands) text += fmt::format(", stands {:.3g} s", candidate.stands_until);
  return text.empty() ? text : text.substr(2);
}

std::string starts_text(int starts) { return starts == 1 ? "1 start" : fmt::format("{} starts", starts); }

/// The table: who, with which setting, at what cost, and how well.
class TuneTable {
 public:
  TuneTable(const TunerAnswer& answer, const Wish& wish, const TunerOptions& options, Console& console)
      : wish_(wish), options_(options), console_(console) {
    best_cost_ = answer.best ? answer.best->cost : answer.plain_si ? answer.plain_si->cost : 1;
    for (const auto* one : {&answer.best, &answer.plain_si, &answer.box2d, &answer.nearest})
      if (*one) make_room(**one);
    for (const Candidate& one : answer.runners_up) make_room(one);
  }

  void print_head() {
    console_.result(fmt::format("{:<12} {:<{}} {:>7} {:>7} {:>8} {:>11} {:>7} {:>8}", "", "", width_, "ms a",
                                "ms a", "slowest", "row updates", "x best", "% of"));
    console_.result(fmt::format("{:<12} {:<{}} {:>7} {:>7} {:>8} {:>11} {:>7} {:>8}  {}", "", "setting",
                                width_, "second", "frame", "step, ms", "a second", "", "limit",
                                "the worst of all starts"));
  }
  void print_best(const Candidate& best) {
    console_.result(console_.colored(console_.spelt(line("best", best)), Color::good));
  }
  void print(const std::string& who, const std::optional<Candidate>& rival) {
    if (!rival) return;
    const bool is_late = options_.budget && rival->frame > *options_.budget;
    const bool has_numbers = options_.budget ? std::isfinite(rival->share) : rival->meets();
    const char* others = rival->list_exhausted ? "; so does every setting with less work" : "";
    if (has_numbers)
      console_.result(console_.spelt(line(who, *rival) + (is_late ? "  over the budget" : "")));
    else
      console_.result(
          console_.spelt(fmt::format("{:<12} {:<{}} {}: {}{}", who, setting_text(rival->setting), width_,
                                     std::isfinite(rival->share) ? "misses it" : "fails", rival->missed,
                                     others)));
  }

 private:
  void make_room(const Candidate& candidate) {
    width_ = std::max(width_, setting_text(candidate.setting).size());
  }
  std::string line(const std::string& who, const Candidate& candidate) const {
    const std::string few =
        candidate.starts < options_.starts ? fmt::format(" (of {})", starts_text(candidate.starts)) : "";
    return fmt::format("{:<12} {:<{}} {:>7.3g} {:>7.2g} {:>8.2g} {:>11.3g} {:>7.2f} {:>8.3g}  {}{}", who,
                       setting_text(candidate.setting), width_, 1e3 * candidate.cost, 1e3 * candidate.frame,
                       1e3 * candidate.slowest_step, candidate.row_updates, candidate.cost / best_cost_,
                       100 * candidate.share, found_text(candidate, wish_), few);
  }

  const Wish& wish_;
  const TunerOptions& options_;
  Console& console_;
  double best_cost_ = 1;  // [s] of a second of the scene
  std::size_t width_ = std::string("setting").size();
};

void print_answer(const TunerAnswer& answer, const Wish& wish, const TunerOptions& options,
                  Console& console) {
  TuneTable table(answer, wish, options, console);
  table.print_head();
  if (answer.best) {
    table.print_best(*answer.best);
    for (const Candidate& next : answer.runners_up) table.print("runner-up", next);
  } else {
    const std::string asked = options.budget ? "holds within the budget" : "meets the wish";
    console.result(console.colored("Nothing that was tried " + asked + ".", Color::bad));
    table.print(options.budget ? "fastest" : "most work", answer.nearest);
  }
  table.print("plain SI", answer.plain_si);
  table.print("Box2D 2.4.1", answer.box2d);
}

Json candidate_json(const std::optional<Candidate>& candidate, const Setting& usual) {
  if (!candidate) return nullptr;
  const Setting& setting = candidate->setting;
  return {{"setting", setting_text(setting)},
          {"flags", flags_text(setting, usual)},
          {"solver", setting.solver},
          {"sweeps", setting.sweeps.iterations},
          {"dt", setting.dt},
          {"substeps", setting.substeps},
          {"cost_s_per_s", candidate->cost},
          {"frame_s", candidate->frame},
          {"slowest_step_s", candidate->slowest_step},
          {"share_of_limit", std::isfinite(candidate->share) ? Json(candidate->share) : Json(nullptr)},
          {"row_updates_per_s", candidate->row_updates},
          {"penetration_m", candidate->worst_penetration},
          {"drift_m", candidate->worst_drift},
          {"residual", candidate->worst_residual},
          {"energy_gain", candidate->energy_gain},
          {"stands_s", candidate->stands_until},
          {"starts", candidate->starts},
          {"missed", candidate->missed}};
}

Json answer_json(const SceneEntry& scene, const TunerAnswer& answer) {
  const auto json_of = [&scene](const std::optional<Candidate>& candidate) {
    return candidate_json(candidate, scene.setting);
  };
  Json runners_up = Json::array();
  for (const Candidate& next : answer.runners_up) runners_up.push_back(json_of(next));
  return {{"scene", scene.name},
          {"best", json_of(answer.best)},
          {"runners_up", runners_up},
          {"plain_si", json_of(answer.plain_si)},
          {"box2d", json_of(answer.box2d)},
          {"nearest", json_of(answer.nearest)},
          {"build", build_json()},
          {"tried", answer.tried},
          {"complete", answer.complete}};
}

double seconds_to_tune(const Words& words, const SceneEntry& entry) {
  const double stands = words.has("stands") ? words.quantity("stands", "s", 0, longest_run) : 0;
  const double standard = std::max(entry.seconds, stands);
  const double seconds = words.has("seconds") ? words.quantity("seconds", "s", 0, longest_run) : standard;
  if (seconds < stands) words.refuse("seconds", "at least as long as --stands", *words.text("seconds"));
  return seconds;
}

/// Standing needs a distance, which only the scene can say.
void check_stands(const Words& words, const SceneEntry& entry) {
  if (!words.has("stands") || entry.expectations.stands || !entry.expectations.places.empty()) return;
  words.refuse("stands",
               "for a scene that says how near its bodies stay ([expect] stands) or where they end "
               "([[expect.body]])",
               entry.name);
}

TunerOptions tuner_options(const Words& words, Progress& bar) {
  TunerOptions options;
  options.starts = words.whole("starts", 16, 1, 1000);
  if (words.has("solvers")) options.solvers = words.known_texts("solvers", solver_names());
  options.time_limit = words.quantity("time", "s", 60);
  if (words.has("budget")) options.budget = words.quantity("budget", "s", 0);
  options.progress = [&bar](int tried, int total) {
    bar.expect(total);
    bar.advance(tried);
    return !interrupted();
  };
  return options;
}

int run_tune(const Words& words, Console& console) {
  const SceneEntry entry = scene_of(words, words.places.front());
  check_stands(words, entry);
  const double seconds = seconds_to_tune(words, entry);
  const Wish wish = wish_of(words, entry, seconds);
  Progress bar(words.console, "settings", 0);  // tune() knows how many
  const TunerOptions options = tuner_options(words, bar);
  const std::string budget =
      options.budget ? fmt::format(", with {:g} ms for a 60th of a second", 1e3 * *options.budget) : "";
  console.narrate(fmt::format("{}: {}, for {:g} s from {}{}", entry.name, wish_text(wish), seconds,
                              starts_text(options.starts), budget));
  const TunerAnswer answer = tune(entry, seconds, wish, options, interrupted);
  bar.clear();
  if (interrupted()) {
    console.warn(fmt::format("stopped after {} settings", answer.tried));
    return stopped;
  }
  if (words.has("json")) {
    fmt::print("{}\n", answer_json(entry, answer).dump(1));
  } else {
    print_answer(answer, wish, options, console);
    if (answer.best)
      console.result(fmt::format("to run it: cairn run {} {}", words.places.front(),
                                 flags_text(answer.best->setting, entry.setting)));
  }
  const char* late = answer.complete ? "" : "; time ran out before the search ended: --time allows more";
  console.narrate(fmt::format("{} settings tried{}", answer.tried, late));
  return answer.best ? all_well : check_failed;
}

}  // namespace

Verb tune_verb() {
  return {
      .name = "tune",
      .places = "SCENE",
      .fewest_places = 1,
      .most_places = 1,
      .summary = "the cheapest setting that meets an error you name",
      .idea =
          "Tries solvers, sweeps, steps, substeps and policies, and finds the one that costs the least "
          "processor time of those that do what you wish, or else what the scene expects ([expect] in its "
          "file), from 16 starts a thousandth of a millimetre apart; with --budget the one that comes "
          "nearest to it in the time that a frame may take. Says what that costs beside plain SI (60 Hz, "
          "relaxed, more and more sweeps) and beside Box2D 2.4.1. Several wishes must all be met. Exit code "
          "1 when nothing "
          "does. A scene stands while no body is farther from its place, aside or down, than it allows "
          "([expect] stands in its file); places are those after the first second (or half of a shorter "
          "run). Until then, and upwards, a body may come as far as half its radius. Where the file says in "
          "which places bodies should end ([[expect.body]]), a run that ends with them there stands, and no "
          "other.",
      .flags = {{"penetration", "LENGTH", "no two shapes overlap by more, such as 2mm"},
                {"drift", "LENGTH", "no joint is farther off, such as 1mm"},
                {"residual", "R_E", "no solve leaves more, such as 0.01"},
                {"energy-gain", "SHARE", "kinetic and potential energy never rise by more, such as 1%"},
                {"stands", "TIME", "nothing leaves the place it settles in for so long, such as 10s"},
                {"budget", "TIME", "for a 60th of a second of the scene, such as 2ms: how good can it be?"},
                {"seconds", "TIME", "of every run (the scene's own, or as long as it should stand)"},
                {"solvers", "NAME,NAME",
                 "to try (si, wide, block, block-contact, accelerated, wide-accelerated, newton)", true},
                {"starts", "N", "from which it must hold (16)"},
                {"time", "TIME", "for all of it, the rivals too (60s)"}},
      .examples = {"tune arch", "tune stack --penetration 2mm", "tune bridge --budget 0.5ms",
                   "tune chain-bob --drift 5mm --energy-gain 1%", "tune stack-ratio --stands 10s --json"},
      .run = run_tune};
}

}  // namespace cairn::sandbox
