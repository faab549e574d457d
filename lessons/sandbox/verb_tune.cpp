// cairn tune: the cheapest setting that meets a wish.
#include <fmt/format.h>

#include <algorithm>
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

Wish wish_of(const Words& words) {
  Wish wish;
  if (words.has("penetration")) wish.penetration = words.quantity("penetration", "m", 0);
  if (words.has("drift")) wish.drift = words.quantity("drift", "m", 0);
  if (words.has("residual")) wish.residual = words.number("residual", 0, 1e-14, 1);
  if (words.has("energy-gain")) wish.energy_gain = words.quantity("energy-gain", "%", 0);
  if (words.has("stands")) wish.stands = words.quantity("stands", "s", 0, longest_run);
  const bool is_empty =
      !wish.penetration && !wish.drift && !wish.residual && !wish.energy_gain && !wish.stands;
  if (is_empty) {
    throw UsageError(
        "cairn tune: a wish is missing: --penetration 2mm, --drift 1mm, --residual 0.01, --energy-gain 1% or "
        "--stands 10s");
  }
  return wish;
}

std::string wish_text(const Wish& wish) {
  List<std::string> parts;
  if (wish.penetration) parts.push_back(fmt::format("penetration at most {:g} mm", 1e3 * *wish.penetration));
  if (wish.drift) parts.push_back(fmt::format("drift at most {:g} mm", 1e3 * *wish.drift));
  if (wish.residual) parts.push_back(fmt::format("R_E at most {:g}", *wish.residual));
  if (wish.energy_gain) parts.push_back(fmt::format("energy gain at most {:g} %", 1e2 * *wish.energy_gain));
  if (wish.stands) parts.push_back(fmt::format("stands {:g} s", *wish.stands));
  return joined(parts, ", ");
}

std::string found_text(const Candidate& candidate, const Wish& wish) {
  std::string text;
  if (wish.penetration) text += fmt::format(", penetration {:.3g} mm", 1e3 * candidate.worst_penetration);
  if (wish.drift) text += fmt::format(", drift {:.3g} mm", 1e3 * candidate.worst_drift);
  if (wish.residual) text += fmt::format(", R_E {:.2g}", candidate.worst_residual);
  if (wish.energy_gain) text += fmt::format(", energy gain {:.3g} %", 1e2 * candidate.energy_gain);
  if (wish.stands) text += fmt::format(", stands {:.3g} s", candidate.stands_until);
  return text.empty() ? text : text.substr(2);
}

std::string starts_text(int starts) { return starts == 1 ? "1 start" : fmt::format("{} starts", starts); }

/// The table: who, with which setting, at what cost, and how well.
class TuneTable {
 public:
  TuneTable(const TunerAnswer& answer, const Wish& wish, Console& console) : wish_(wish), console_(console) {
    best_cost_ = answer.best ? answer.best->cost : answer.plain_si ? answer.plain_si->cost : 1;
    for (const auto* one : {&answer.best, &answer.plain_si, &answer.box2d, &answer.nearest})
      if (*one) make_room(**one);
    for (const Candidate& one : answer.runners_up) make_room(one);
  }

  void print_head() {
    console_.result(fmt::format("{:<12} {:<{}} {:>7} {:>11} {:>7}  {}", "", "for a second of the scene",
                                width_, "ms", "row updates", "x best", "the worst of all starts"));
  }
  void print_best(const Candidate& best) {
    console_.result(console_.colored(console_.spelt(line("best", best)), Color::good));
  }
  void print(const std::string& who, const std::optional<Candidate>& rival) {
    if (!rival) return;
    const char* others = rival->list_exhausted ? "; so does every setting with less work" : "";
    console_.result(console_.spelt(rival->verdict.meets ? line(who, *rival)
                                                        : fmt::format("{:<12} {:<{}} misses it: {}{}", who,
                                                                      setting_text(rival->setting), width_,
                                                                      rival->verdict.missed, others)));
  }

 private:
  void make_room(const Candidate& candidate) {
    width_ = std::max(width_, setting_text(candidate.setting).size());
  }
  std::string line(const std::string& who, const Candidate& candidate) const {
    return fmt::format("{:<12} {:<{}} {:>7.3g} {:>11.3g} {:>7.2f}  {}", who, setting_text(candidate.setting),
                       width_, 1e3 * candidate.cost, candidate.row_updates, candidate.cost / best_cost_,
                       found_text(candidate, wish_));
  }

  const Wish& wish_;
  Console& console_;
  double best_cost_ = 1;  // [s] of a second of the scene
  std::size_t width_ = std::string("for a second of the scene").size();
};

void print_answer(const TunerAnswer& answer, const Wish& wish, Console& console) {
  TuneTable table(answer, wish, console);
  table.print_head();
  if (answer.best) {
    table.print_best(*answer.best);
    for (const Candidate& next : answer.runners_up) table.print("runner-up", next);
  } else {
    console.result(console.colored("Nothing that was tried meets the wish.", Color::bad));
    table.print("most work", answer.nearest);
  }
  table.print("plain SI", answer.plain_si);
  table.print("Box2D 2.4.1", answer.box2d);
}

Json candidate_json(const std::optional<Candidate>& candidate) {
  if (!candidate) return nullptr;
  const Setting& setting = candidate->setting;
  return {{"setting", setting_text(setting)},
          {"solver", setting.solver},
          {"sweeps", setting.sweeps.iterations},
          {"dt", setting.dt},
          {"substeps", setting.substeps},
          {"cost_s_per_s", candidate->cost},
          {"row_updates_per_s", candidate->row_updates},
          {"penetration_m", candidate->worst_penetration},
          {"drift_m", candidate->worst_drift},
          {"residual", candidate->worst_residual},
          {"energy_gain", candidate->energy_gain},
          {"stands_s", candidate->stands_until},
          {"starts", candidate->starts},
          {"missed", candidate->verdict.missed}};
}

Json answer_json(const std::string& scene, const TunerAnswer& answer) {
  Json runners_up = Json::array();
  for (const Candidate& next : answer.runners_up) runners_up.push_back(candidate_json(next));
  return {{"scene", scene},
          {"best", candidate_json(answer.best)},
          {"runners_up", runners_up},
          {"plain_si", candidate_json(answer.plain_si)},
          {"box2d", candidate_json(answer.box2d)},
          {"nearest", candidate_json(answer.nearest)},
          {"build", build_json()},
          {"tried", answer.tried},
          {"complete", answer.complete}};
}

double seconds_to_tune(const Words& words, const SceneEntry& entry, const Wish& wish) {
  const double standard = std::max(entry.seconds, wish.stands.value_or(0));
  const double seconds = words.has("seconds") ? words.quantity("seconds", "s", 0, longest_run) : standard;
  if (wish.stands && seconds < *wish.stands) {
    words.refuse("seconds", "at least as long as --stands", *words.text("seconds"));
  }
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
  options.progress = [&bar](int tried, int total) {
    bar.expect(total);
    bar.advance(tried);
    return !interrupted();
  };
  return options;
}

int run_tune(const Words& words, Console& console) {
  const SceneEntry entry = scene_of(words, words.places.front());
  const Wish wish = wish_of(words);
  check_stands(words, entry);
  const double seconds = seconds_to_tune(words, entry, wish);
  Progress bar(words.console, "settings", 0);  // tune() knows how many
  const TunerOptions options = tuner_options(words, bar);
  console.narrate(fmt::format("{}: {}, for {:g} s from {}", entry.name, wish_text(wish), seconds,
                              starts_text(options.starts)));
  const TunerAnswer answer = tune(entry, seconds, wish, options, interrupted);
  bar.clear();
  if (interrupted()) {
    console.warn(fmt::format("stopped after {} settings", answer.tried));
    return stopped;
  }
  if (words.has("json")) {
    fmt::print("{}\n", answer_json(entry.name, answer).dump(1));
  } else {
    print_answer(answer, wish, console);
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
          "Tries solvers, sweeps, steps, substeps and policies from the least work to the most, and finds "
          "the one that costs the least processor time of those that do what you wish, from 16 starts a "
          "thousandth of a millimetre apart. Says what that costs beside plain SI (60 Hz, Baumgarte, more "
          "and more sweeps) and beside Box2D 2.4.1. Several wishes must all be met. Exit code 1 when "
          "nothing does. A scene stands while no body is farther from its place, aside or down, than it "
          "allows ([expect] stands in its file); places are those after the first second (or half of a "
          "shorter run). Until then, and upwards, a body may come as far as half its radius. Where the file "
          "says in which places bodies should end ([[expect.body]]), a run that ends with them there "
          "stands, and no other.",
      .flags = {{"penetration", "LENGTH", "no two shapes overlap by more, such as 2mm"},
                {"drift", "LENGTH", "no joint is farther off, such as 1mm"},
                {"residual", "R_E", "no solve leaves more, such as 0.01"},
                {"energy-gain", "SHARE", "kinetic and potential energy never rise by more, such as 1%"},
                {"stands", "TIME", "nothing leaves the place it settles in for so long, such as 10s"},
                {"seconds", "TIME", "of every run (the scene's own, or as long as it should stand)"},
                {"solvers", "NAME,NAME",
                 "to try (si, wide, block, block-contact, accelerated, wide-accelerated, newton)", true},
                {"starts", "N", "from which it must hold (16)"},
                {"time", "TIME", "for all of it, the rivals too (60s)"}},
      .examples = {"tune stack --penetration 2mm", "tune chain-bob --drift 5mm --energy-gain 1%",
                   "tune stack-ratio --stands 10s --json"},
      .run = run_tune};
}

}  // namespace cairn::sandbox
