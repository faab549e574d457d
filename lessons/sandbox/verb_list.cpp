// cairn list: what there is to choose from.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "lessons/kit/words.hpp"
#include "lessons/sandbox/scene_words.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>
#include <cairn/scenes/solver_list.hpp>

namespace cairn::sandbox {
namespace {

using Json = nlohmann::ordered_json;

constexpr int list_columns = 100;

Json scenes_json() {
  Json all = Json::array();
  for (const SceneEntry& scene : scene_entries()) {
    all.push_back({{"name", scene.name},
                   {"title", scene.title},
                   {"look", scene.look},
                   {"seconds", scene.seconds},
                   {"setting", setting_text(scene.setting)}});
  }
  return all;
}

Json solvers_json() {
  Json all = Json::array();
  for (const std::string& name : contestant_names()) {
    const SolverEntry& solver = solver_entry(name);
    all.push_back({{"name", name}, {"title", solver.title}, {"cost", solver.cost}});
  }
  return all;
}

Json stabilizations_json() {
  Json all = Json::array();
  for (const auto& policy : named_values(StabilizationPolicy()))
    all.push_back({{"name", policy.word}, {"title", policy.meaning}});
  return all;
}

void print_choices(const Json& all, const std::string& heading, Console& console) {
  int width = 0;
  for (const Json& one : all) width = std::max(width, display_width(one["name"].get<std::string>()));
  console.result(console.colored(heading, Console::Color::bold));
  for (const Json& one : all) {
    std::string what = one["title"].get<std::string>();
    const std::string cost = one.contains("cost") ? one["cost"].get<std::string>() : "";
    if (!cost.empty()) what += ": " + cost;
    const std::string line = "  " + padded(one["name"].get<std::string>(), width + 2) +
                             wrapped(what, list_columns - width - 4, width + 4);
    console.result(console.spelt(line));
  }
}

int run_list(const Words& words, Console& console) {
  const List<std::string> kinds = {"scenes", "solvers", "stabilizations"};
  const std::string kind = words.places.empty() ? "" : words.places.front();
  if (!kind.empty() && std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
    const std::string meant = nearest(kind, kinds);
    throw UsageError(
        "cairn list: there is no list of " + kind +
        (meant.empty() ? "; there are " + joined(kinds, ", ") : "; did you mean " + meant + "?"));
  }
  const Json lists = {
      {"scenes", scenes_json()}, {"solvers", solvers_json()}, {"stabilizations", stabilizations_json()}};
  if (words.has("json")) {
    fmt::print("{}\n", (kind.empty() ? lists : lists[kind]).dump(1));
    return all_well;
  }
  const List<std::string> headings = {"scenes (cairn run SCENE)", "solvers (--solver; m rows, n bodies)",
                                      "stabilizations (--stabilization)"};
  for (int i = 0; i < kinds.size(); ++i) {
    if (kind.empty() || kind == kinds[i]) print_choices(lists[kinds[i]], headings[i], console);
  }
  return all_well;
}

}  // namespace

Verb list_verb() {
  return {.name = "list",
          .places = "[KIND]",
          .fewest_places = 0,
          .most_places = 1,
          .summary = "the scenes, solvers and stabilizations there are",
          .idea =
              "What can be named behind the other verbs and their flags, each with a word on what it is. "
              "KIND: scenes, solvers or stabilizations; all of them without it.",
          .flags = {},
          .examples = {"list", "list solvers", "list scenes --json"},
          .run = run_list};
}

}  // namespace cairn::sandbox
