// What it costs in accuracy, and saves in time, that manifolds last longer than a substep: in every scene.
#include <fmt/format.h>

#include <algorithm>

#include <cairn/math/list.hpp>
#include <cairn/scenes/scene_list.hpp>
#include <cairn/study/judgement.hpp>
#include <cairn/study/trial.hpp>
#include "table.hpp"
#include "tables.hpp"

namespace cairn::bench {

namespace {

constexpr int least_substeps = 4;

List<TrialResult> results_of(const SceneEntry& entry) {
  List<TrialResult> results;
  for (const ContactSearch search :
       {ContactSearch::every_substep, ContactSearch::every_step, ContactSearch::when_moved}) {
    Setting setting = entry.setting;
    if (setting.solver == "box2d") setting.solver = "si";
    setting.substeps = std::max(setting.substeps, least_substeps);
    setting.contact_search = search;
    results.push_back(run_trial(entry.make(), setting, trial_options(entry)));
  }
  return results;
}

/// "1.2  1.3  1.2": one for each search.
template <typename Number>
std::string three(const List<TrialResult>& results, const Number& number) {
  std::string text;
  for (const TrialResult& result : results) {
    const bool ended = result.status == TrialStatus::ok;
    text += fmt::format("{:>9}", ended ? number(result) : status_text(result.status));
  }
  return text;
}

}  // namespace

void print_search_table() {
  print_heading("9. How long manifolds last: every substep, every step, when moved");
  fmt::print(
      "Every scene under its own setting, with {} substeps where it has fewer. Three numbers each: contacts "
      "sought\n"
      "in every substep, once a step, and where bodies have moved beside each other. Times of one run: they "
      "say how\n"
      "much, not to the digit.\n\n",
      least_substeps);
  TextTable table({{"scene", ""},
                   {"step", "us"},
                   {"deepest overlap", "mm"},
                   {"worst drift", "mm, mrad"},
                   {"energy gained", "%"},
                   {"stands", "s"}});
  for (const SceneEntry& entry : scene_entries()) {
    const List<TrialResult> results = results_of(entry);
    table.add(
        {entry.name,
         three(results, [](const auto& r) { return fmt::format("{:.1f}", 1e6 * r.step_seconds / r.steps); }),
         three(results, [](const auto& r) { return fmt::format("{:.2f}", 1e3 * r.worst_penetration); }),
         three(results, [](const auto& r) { return fmt::format("{:.3g}", 1e3 * r.worst_drift); }),
         three(results, [](const auto& r) { return fmt::format("{:.2f}", 100 * r.energy_gain); }),
         three(results, [](const auto& r) { return fmt::format("{:.1f}", r.stands_until); })});
  }
  fmt::print("{}\n", table.text());
}

}  // namespace cairn::bench
