// cairn compare: one scene, several solvers, one table; and a film with all of them side by side.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "lessons/kit/words.hpp"
#include "lessons/sandbox/film_files.hpp"
#include "lessons/sandbox/interrupt.hpp"
#include "lessons/sandbox/run_table.hpp"
#include "lessons/sandbox/scene_words.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>
#include <cairn/study/contestant.hpp>

namespace cairn::sandbox {
namespace {

List<Flag> compare_flags() {
  List<Flag> flags = {{"solvers", "NAME,NAME",
                       "each with sweeps of its own if you like: si,si:100 (si,pgs,accelerated,box2d)",
                       true}};
  for (const Flag& flag : setting_flags()) {
    if (flag.name != "solver") flags.push_back(flag);
  }
  flags.push_back({"seconds", "TIME", "to simulate (the scene's own)"});
  return joined_flags(joined_flags(flags, film_flags()), look_flags());
}

/// A run that nobody could begin, with the reason.
SceneRun left_out(Setting setting, const std::string& reason) {
  SceneRun run{.setting = std::move(setting)};
  run.result.status = TrialStatus::refused;
  run.result.reason = reason;
  run.judgement = judge(run.result, {});
  return run;
}

/// The settings, in the order asked for.
List<Setting> compared_settings(const Words& words, const SceneEntry& scene) {
  const List<std::string> asked =
      words.has("solvers") ? words.texts("solvers") : List<std::string>{"si", "pgs", "accelerated", "box2d"};
  const auto has_sweeps = [](const std::string& text) { return text.find(':') != std::string::npos; };
  if (std::all_of(asked.begin(), asked.end(), has_sweeps)) {
    words.refuse_beside("sweeps", "where every solver has sweeps of its own");
  }
  List<Setting> settings;
  List<std::string> solvers;
  for (const std::string& text : asked) {
    Setting setting = common_setting(words, scene);
    if (text.substr(0, text.find(':')) == "box2d" && !has_box2d()) {
      setting.solver = "box2d";
    } else {
      setting = with_solver(words, "solvers", setting, text);
    }
    settings.push_back(setting);
    solvers.push_back(setting.solver);
  }
  refuse_idle_flags(words, solvers);
  return settings;
}

void write_compare_film(const Words& words, const SceneEntry& scene, const List<SceneRun>& runs,
                        const FilmFiles& files, const RunWish& wish, Console& console, bool& is_stopped) {
  List<SceneRun> shown;
  for (const SceneRun& run : runs) {
    if (run.result.status != TrialStatus::refused) shown.push_back(run);
  }
  if (shown.empty()) return;
  const FilmLook look = look_of(words, files.frames ? "medium" : "640x360");
  SceneFilm film(scene, shown, look);
  const FilmOutcome outcome = write_film(film, film_identity(scene, shown, look, files.frames_per_second),
                                         files, wish.stops, words.console);
  is_stopped = outcome.stopped;
  if (is_stopped) {
    console.warn(stopped_text(files, outcome));
  } else {
    console.narrate(film_text(outcome));
  }
}

void print_comparison(const Words& words, const SceneEntry& scene, const List<SceneRun>& runs, double seconds,
                      Console& console) {
  if (words.has("json")) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const SceneRun& run : runs) all.push_back(run_json(scene, run));
    fmt::print("{}\n", all.dump(1));
    return;
  }
  const auto is_refused = [](const SceneRun& run) { return run.result.status == TrialStatus::refused; };
  if (std::all_of(runs.begin(), runs.end(), is_refused)) return;
  // The rest of the settings, which all have.
  const std::string setting = setting_text(runs.front().setting);
  const std::string common = setting.substr(std::min(setting.size(), setting.find(", ")));
  console.result(console.spelt(fmt::format("{}: {}, {:g} s{}", scene.name, scene.title, seconds, common)));
  print_runs(scene, runs, console);
  for (const SceneRun& run : runs) {
    if (is_refused(run)) continue;
    for (const std::string& line : known_differences(scene.make(), run.setting))
      console.result(console.spelt(run.setting.solver + ": " + line));
  }
}

/// The worst of those that ran. What the scene expects does not count, for a comparison is no test of its
/// contestants; failures that no scene should show do.
int compare_code(const List<SceneRun>& runs) {
  bool any = false, fails = false;
  for (const SceneRun& run : runs) {
    const TrialStatus status = run.result.status;
    if (status == TrialStatus::diverged || status == TrialStatus::nan) return diverged;
    if (status == TrialStatus::refused) continue;
    any = true;
    fails = fails || run.judgement.fails();
  }
  if (!any) return bad_usage;
  return fails ? check_failed : all_well;
}

int run_compare(const Words& words, Console& console) {
  const SceneEntry scene = scene_of(words, words.places.front());
  const List<Setting> settings = compared_settings(words, scene);
  const FilmFiles files = film_files(words);
  (void)look_of(words, "medium");  // refuses before any work is done
  if (files.any() && settings.size() > SceneFilm::most_panels)
    words.refuse("solvers", "at most 4 where there are pictures", fmt::format("{}", settings.size()));
  const RunWish wish{.seconds = seconds_of(words, scene),
                     .frames_per_second = files.any() ? files.frames_per_second : 0,
                     .stops = interrupted};
  List<SceneRun> runs;
  for (const Setting& setting : settings) {
    const bool is_missing = setting.solver == "box2d" && !has_box2d();
    runs.push_back(is_missing ? left_out(setting, "Cairn was built without Box2D")
                              : run_scene(scene, setting, wish, words.console));
    if (!runs.back().stopped) continue;
    console.warn("stopped before the runs were over; nothing is written");
    return stopped;
  }
  for (const SceneRun& run : runs) {
    if (run.result.status == TrialStatus::refused)
      console.warn("cairn compare: " + refusal_text(scene, run) + "; it is left out");
  }
  print_comparison(words, scene, runs, wish.seconds, console);
  bool is_stopped = false;
  if (files.any()) write_compare_film(words, scene, runs, files, wish, console, is_stopped);
  return is_stopped ? stopped : compare_code(runs);
}

}  // namespace

Verb compare_verb() {
  return {
      .name = "compare",
      .places = "SCENE",
      .fewest_places = 1,
      .most_places = 1,
      .summary = "one scene under several solvers: a table, and a film side by side",
      .idea =
          "Runs the scene under each solver, everything else alike, and puts what it cost beside what came "
          "out. Box2D 2.4.1 runs with the steps and substeps that are asked for and as many velocity "
          "iterations as sweeps; where it cannot run the scene it is left out, with the reason. Exit code 1 "
          "when bodies went through each other, began below the ground or fell out of the scene or for ever, "
          "joints came apart or stayed off, or energy came from nowhere, 4 when one diverges.",
      .flags = compare_flags(),
      .examples = {"compare stack", "compare chain-bob --solvers si:20,block:20,accelerated:20,box2d:20",
                   "compare stack-ratio --solvers si:10,accelerated:10 --frames out/ratio"},
      .run = run_compare};
}

}  // namespace cairn::sandbox
