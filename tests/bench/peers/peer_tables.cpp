// Equal work and equal error: two tables, since neither says what the other does.
#include "peer_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "../table.hpp"

namespace cairn::bench {

namespace {

/// The median of the ratios, repetition by repetition: what disturbed one of them disturbed both.
std::string paired_ratio_cell(const List<double>& times, const List<double>& reference) {
  if (times.empty() || reference.empty()) return "-";
  List<double> ratios;
  for (int i = 0; i < times.size(); ++i) ratios.push_back(times[i] / reference[i]);
  const Times ratio = times_of(ratios);
  return ratio.noise() > largest_noise ? "noisy" : three_digits(ratio.median);
}

/// A length in mm; what nobody would see is not told apart.
std::string length_cell(double metres) {
  return std::abs(metres) < 1e-5 ? "< 0.01" : three_digits(1e3 * metres);
}

List<std::string> time_cells(const List<double>& times, const List<double>& reference) {
  if (times.empty()) return {"-", "-", "-"};
  const Times time = times_of(times);
  return {three_digits(time.median * 1e-3),
          fmt::format("{} - {}", three_digits(time.lower_quartile * 1e-3),
                      three_digits(time.upper_quartile * 1e-3)),
          paired_ratio_cell(times, reference)};
}

/// The worst error and that of the end, how far the top has sunk, and whether all stands.
List<std::string> error_cells(const PeerScene& scene, const Finding& finding) {
  const Errors& end = finding.end;
  if (end.exploded) return {"explodes", "-", "-", "-"};
  const std::string stands = !scene.stands ? "-" : end.aside > 0.5 ? "falls" : "yes";
  return {length_cell(finding.worst), length_cell(end.error),
          stands == "yes" ? length_cell(end.sinking) : "-", stands};
}

/// What takes part in a table, and what was found of it.
struct Entrants {
  List<Contestant> contestants = {};
  List<Finding> findings = {};
  List<std::string> notes = {};  // on those who do not
};

List<std::string> row(const PeerScene& entry, const Finding& finding, const List<double>& times,
                      const List<double>& reference) {
  if (finding.refused) return {"cannot", "-", "-", "-", "-", "-", "-", "-"};
  if (finding.too_slow) return {"too slow", "-", "-", "-", "-", "-", "-", "-"};
  List<std::string> cells = time_cells(times, reference);
  const List<std::string> errors = error_cells(entry, finding);
  cells.insert(cells.end(), errors.begin(), errors.end());
  cells.push_back(fmt::format("{:.0f}", finding.bytes / 1024));
  return cells;
}

/// Takes the times and prints a line for each.
void print_rows(const PeerScene& entry, const Scene& scene, const Entrants& entrants,
                const RunLength& length) {
  const auto& [contestants, findings, notes] = entrants;
  const List<List<double>> all_times = times(scene, contestants, findings, length);
  TextTable table({{"engine", ""},
                   {"step", "us"},
                   {"quartiles", "us"},
                   {"ratio", "to the first"},
                   {scene.joints().empty() ? "overlap" : "joint gap", "mm, worst"},
                   {"at the end", "mm"},
                   {"top sinks", "mm"},
                   {"stands", ""},
                   {"memory", "kB"}});
  for (int i = 0; i < contestants.size(); ++i) {
    List<std::string> cells = row(entry, findings[i], all_times[i], all_times.front());
    cells.insert(cells.begin(), contestants[i].name);
    table.add(cells);
  }
  fmt::print("{}", table.text());
  for (const std::string& note : notes) fmt::print("  {}\n", note);
  fmt::print("\n");
  std::fflush(stdout);
}

void print_work_in(const PeerScene& entry, const RunLength& length) {
  const Scene scene = entry.make();
  Entrants entrants = {.contestants = usual_contestants()};
  for (const Contestant& one : entrants.contestants) {
    entrants.findings.push_back(find_errors(scene, one, length));
    const std::optional<std::string>& refused = entrants.findings.back().refused;
    if (refused) entrants.notes.push_back(*refused);
  }
  fmt::print("{}: {} bodies, {} joints\n", entry.name, scene.bodies().size() - 1, scene.joints().size());
  print_rows(entry, scene, entrants, length);
}

/// The first setting of a method that reaches the target, or a note that none does.
void add_cheapest(const Scene& scene, const Method& method, const Target& target, const RunLength& length,
                  Entrants& entrants) {
  for (const Contestant& setting : method) {
    const Finding finding = find_errors(scene, setting, length, target);
    if (reaches(finding, target)) {
      entrants.contestants.push_back(setting);
      entrants.findings.push_back(finding);
      return;
    }
    if (finding.refused || finding.too_slow) {
      const std::string why = finding.refused ? "cannot run it" : "too slow";
      entrants.notes.push_back(fmt::format("{}: {}", setting.name, why));
      return;
    }
  }
  entrants.notes.push_back(fmt::format("not reached by {} to {}", method.front().name, method.back().name));
}

void print_error_in(const PeerScene& entry, const RunLength& length) {
  const Scene scene = entry.make();
  const Target& target = *entry.target;
  Entrants entrants;
  for (const Method& method : methods()) add_cheapest(scene, method, target, length, entrants);
  fmt::print("{}: {} at most {:g} mm", entry.name, scene.joints().empty() ? "overlap" : "joint gap",
             1e3 * target.error);
  if (target.sinking > 0) {
    fmt::print(", the top sinks or rises at most {:g} m, nothing goes more than 0.5 m aside", target.sinking);
  }
  fmt::print("\n");
  print_rows(entry, scene, entrants, length);
}

}  // namespace

void print_equal_work(const List<PeerScene>& scenes, const RunLength& length) {
  print_heading("1. Equal work: every engine as it comes");
  fmt::print(
      "Settings that users begin with. They are not equally hard work, so read times beside errors. A ratio\n"
      "above 1 is slower than the first line. Overlap (or joint gap) is the worst of every tenth step, "
      "measured\n"
      "by Cairn for all engines alike, without the skins that some engines add: their piles rise at first. A "
      "pile\n"
      "falls when a body has gone more than 0.5 m aside. Memory is what is on the heap at the end. Too slow: "
      "a run\n"
      "took more than {:g} s, and was broken off.\n\n",
      length.most);
  for (const PeerScene& scene : scenes) print_work_in(scene, length);
}

void print_equal_error(const List<PeerScene>& scenes, const RunLength& length) {
  const auto has_target = [](const PeerScene& scene) { return scene.target.has_value(); };
  if (std::none_of(scenes.begin(), scenes.end(), has_target)) return;
  print_heading("2. Equal error: what it costs to be as good");
  fmt::print(
      "Each engine works harder until its errors are within the limits, or its settings end. Here times may "
      "be\n"
      "compared.\n\n");
  for (const PeerScene& scene : scenes) {
    if (scene.target) print_error_in(scene, length);
  }
}

}  // namespace cairn::bench
