// Cairn beside its peers: what a step costs, and what it is worth.
//   bash tests/run bench peers            the small scenes, at most 250 steps each: half an hour
//   bash tests/run bench peers --whole    all scenes, at most 500 steps each: some hours
//   bash tests/run bench peers NAME...    these scenes alone; "large" and "edit" are the tables 4 and 5
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>

#include "../machine.hpp"
#include "peer_list.hpp"
#include "peer_tables.hpp"

namespace cairn::bench {

namespace {

const RunLength quick = {.steps = 250, .repetitions = 5, .most = 7};
const RunLength whole = {.steps = 500, .repetitions = 5, .most = 60};

/// The scenes that were named, or else those of the length. @returns none for a name that is no scene.
List<PeerScene> wanted_scenes(const List<std::string>& names, bool all) {
  List<PeerScene> wanted;
  for (const PeerScene& scene : peer_scenes()) {
    const bool named = std::find(names.begin(), names.end(), scene.name) != names.end();
    if (named || (names.empty() && (all || scene.quick))) wanted.push_back(scene);
  }
  if (!names.empty() && wanted.size() != names.size()) return {};
  return wanted;
}

/// Whether a word is among them, which it is no longer.
bool take(const std::string& word, List<std::string>& words) {
  const int before = words.size();
  erase_if(words, [&word](const std::string& one) { return one == word; });
  return words.size() < before;
}

int refuse() {
  fmt::print(stderr, "cairn_peers: takes --whole and names of scenes and tables, each once; there are:");
  for (const PeerScene& scene : peer_scenes()) fmt::print(stderr, " {}", scene.name);
  fmt::print(stderr, " large edit\n");
  return 2;
}

int compare(List<std::string> words) {
  const bool all = take("--whole", words), none_named = words.empty();
  const bool large = take("large", words) || none_named, edit = take("edit", words) || none_named;
  List<PeerScene> scenes;
  if (none_named || !words.empty()) {
    scenes = wanted_scenes(words, all);
    if (scenes.empty()) return refuse();
  }
  const RunLength& length = all ? whole : quick;
  print_machine();
  for (const std::string& line : engine_lines()) fmt::print("{}\n", line);
  fmt::print(
      "Processor times of one thread, medians of at most {} runs in turn; at most {} steps of 1/60 s, of\n"
      "which the first tenth warms up. A ratio is \"noisy\" where its quartiles are more than {:.0f} %\n"
      "apart. Sleeping and continuous collision are off. Chipmunk is timed as it is installed: Debian's has\n"
      "its assertions on, which slow it, and says so here:\n",
      length.repetitions, length.steps, 100 * largest_noise);
  if (!adapters_agree()) return 1;
  if (!scenes.empty()) {
    print_equal_work(scenes, length);
    print_equal_error(scenes, length);
    print_phases(scenes, length);
  }
  if (large) print_large_pyramid(length);
  if (edit) print_edits();
  return 0;
}

}  // namespace

}  // namespace cairn::bench

int main(int argc, char** argv) {
  try {
    return cairn::bench::compare({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
