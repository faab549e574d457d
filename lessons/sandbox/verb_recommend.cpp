// cairn recommend: which setting for which kind of scene, with the runs that speak for it.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "lessons/sandbox/scene_words.hpp"
#include "lessons/sandbox/study_words.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>
#include <cairn/measure/whole_file.hpp>
#include <cairn/scenes/default_setting.hpp>
#include <cairn/study/tuning/recommend.hpp>

namespace cairn::sandbox {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Color = Console::Color;

constexpr int most_runners_up = 3;

std::string wish_line(const RecommendRun& run) {
  std::string text;
  if (run.wish.stands)
    text += fmt::format(", nothing more than {:g} mm from where it settled", 1e3 * run.stand_distance);
  if (run.wish.penetration) text += fmt::format(", overlap up to {:g} mm", 1e3 * *run.wish.penetration);
  if (run.wish.drift) text += fmt::format(", joints within {:g} mm", 1e3 * *run.wish.drift);
  if (run.wish.energy_gain) text += fmt::format(", energy gain up to {:g} %", 100 * *run.wish.energy_gain);
  return text.substr(2);
}

/// A table of its own below who it is about, and then what was missed.
void print_candidate(const std::string& who, const RecommendCandidate& candidate, Color color,
                     Console& console) {
  console.result(console.colored(console.spelt("  " + who + candidate.setting), color));
  std::string table = fmt::format("    {:<38}  {:>10}  {:>8}  {:>6}  {:>8}  {:>8}  {:>9}", "run",
                                  "overlap mm", "drift mm", "gain %", "stands s", "ms per s", "updates/s");
  std::string missed;
  for (const RecommendFinding& found : candidate.findings) {
    table += fmt::format("\n    {:<38}  {:>10.3g}  {:>8.3g}  {:>6.3g}  {:>8.3g}  {:>8.3g}  {:>9.3g}",
                         found.run, 1e3 * found.penetration, 1e3 * found.drift, 100 * found.energy_gain,
                         found.stands_until, 1e3 * found.cost, found.row_updates);
    if (!found.missed.empty()) missed += fmt::format("\n    {} misses: {}", found.run, found.missed);
  }
  console.result(console.spelt(table));
  if (!missed.empty()) console.result(console.spelt(missed.substr(1)));
}

/// The flags of a setting that is still one of those that are tried.
void print_flags(const std::string& setting, Console& console) {
  for (const Setting& tried : recommend_settings()) {
    if (setting_text(tried) == setting)
      console.result("  with a scene of yours: cairn run FILE " +
                     flags_text(tried, default_setting(Scene()).setting));
  }
}

const RecommendCandidate* plain_candidate(const Recommendation& of_kind) {
  for (const RecommendCandidate& candidate : of_kind.candidates) {
    if (candidate.setting == setting_text(plain_setting())) return &candidate;
  }
  return nullptr;
}

void print_kind(const Recommendation& of_kind, Console& console) {
  const RecommendKind& kind = recommend_kind(of_kind.kind);
  console.result(console.spelt(fmt::format("{}: {}", kind.name, kind.title)));
  console.result(console.spelt(fmt::format("  required of each run: {}", wish_line(kind.runs.front()))));
  const List<RecommendCandidate> best = of_kind.ranked();
  if (best.empty()) {
    console.result(console.colored("  Nothing that was tried meets all of its runs.", Color::bad));
  } else {
    print_candidate("recommended: ", best.front(), Color::good, console);
    print_flags(best.front().setting, console);
  }
  for (int i = 1; i < std::min(best.size(), most_runners_up + 1); ++i) {
    console.result(console.spelt(fmt::format("  runner-up: {}, {:.2f} times the cost", best[i].setting,
                                             best[i].cost() / best.front().cost())));
  }
  const RecommendCandidate* plain = plain_candidate(of_kind);
  const bool is_best = plain != nullptr && !best.empty() && plain->setting == best.front().setting;
  if (plain != nullptr && !is_best) print_candidate("plain SI: ", *plain, Color::faint, console);
}

Json kind_json(const Recommendation& of_kind) {
  const Json all = Json::parse(recommendations_json({of_kind}));
  Json json = {{"kind", of_kind.kind}, {"title", recommend_kind(of_kind.kind).title}};
  const List<RecommendCandidate> best = of_kind.ranked();
  json["recommended"] = best.empty() ? Json(nullptr) : Json(best.front().setting);
  json["runners_up"] = Json::array();
  for (int i = 1; i < std::min(best.size(), most_runners_up + 1); ++i)
    json["runners_up"].push_back(best[i].setting);
  json["candidates"] = all.at("recommendations").front().at("candidates");
  return json;
}

int renew(const Words& words, Console& console) {
  for (const char* flag : {"from", "json"}) words.refuse_beside(flag, "beside --renew");
  if (!words.places.empty())
    words.refuse("renew", "given without a kind: it renews all", words.places.front());
  const fs::path target = words.text("out").value_or(recommended_file().string());
  fs::path part = target;
  part += ".renewing";
  const Study study = recommend_study();
  const std::string goes_on = "stopped; the same command goes on from " + part.string();
  Journal journal = open_journal(words, part, study, goes_on);
  if (journal.size() > 0) console.narrate("goes on from " + part.string());
  if (!run_or_merge(words, study, {}, journal, "settings", goes_on)) return stopped;
  write_whole_file(target, recommendations_json(recommendations_of(journal.csv())));
  fs::remove(part);
  console.result(console.spelt("wrote " + target.string()));
  return all_well;
}

int run_recommend(const Words& words, Console& console) {
  if (words.has("renew")) return renew(words, console);
  words.refuse_beside("out", "without --renew");
  const fs::path file = words.text("from").value_or(recommended_file().string());
  const std::string wanted = words.places.empty() ? "" : recommend_kind(words.places.front()).name;
  Json json = Json::array();
  for (const Recommendation& of_kind : read_recommendations(file)) {
    if (!wanted.empty() && of_kind.kind != wanted) continue;
    if (words.has("json"))
      json.push_back(kind_json(of_kind));
    else
      print_kind(of_kind, console);
  }
  if (words.has("json")) fmt::print("{}\n", json.dump(1));
  console.narrate("from " + file.string() + "; times are those of the machine that made it");
  return all_well;
}

}  // namespace

Verb recommend_verb() {
  return {.name = "recommend",
          .places = "[KIND]",
          .fewest_places = 0,
          .most_places = 1,
          .summary = "which setting for which kind of scene, and why",
          .idea =
              "For stacks, chains, mechanisms, granular piles, fast bodies and places far from the "
              "origin: the cheapest of a short list of settings that does what is wished in all runs of "
              "the kind, up to the extremes, with what each run came to. The next cheapest follow, and "
              "plain SI beside them, up to the first run that it misses. All numbers come from runs that "
              "--renew does again.",
          .flags = {{"renew", "", "does all runs again, some minutes of them, and writes the file"},
                    {"out", "FILE", "where --renew writes (the file that comes with Cairn)"},
                    {"from", "FILE", "recommendations to show, other than those that come with Cairn"}},
          .examples = {"recommend stack", "recommend --json", "recommend --renew"},
          .run = run_recommend};
}

}  // namespace cairn::sandbox
