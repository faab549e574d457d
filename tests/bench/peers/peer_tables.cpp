// Equal work and equal error: two tables, since neither says what the other does.
#include "peer_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "../table.hpp"

namespace cairn::bench {

namespace {

/// The median of the ratios, repetition by repetition: what disturbed one of them disturbed both.
std::string paired_ratio_cell(const List<double>& times, const List<double>& reference) {
  if (times.empty() || reference.empty()) return "-";
  List<double> ratios;
  for (int i = 0; i < std::min(times.size(), reference.size()); ++i)
    ratios.push_back(times[i] / reference[i]);
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

/// A column of what was found, where nothing exploded.
struct Measure {
  Column column = {};
  std::function<std::string(const Finding&)> cell = {};
};

std::string stands_cell(const Finding& finding) { return finding.end.aside > 0.5 ? "falls" : "yes"; }

std::string sinks_cell(const Finding& finding) {
  return stands_cell(finding) == "yes" ? length_cell(finding.end.sinking) : "-";
}

/// Of one kind of error: the worst, and that at the end.
void add_error(const std::string& name, double Finding::*worst, double Errors::*end,
               List<Measure>& measures) {
  measures.push_back({{name, "mm, worst"}, [worst](const Finding& f) { return length_cell(f.*worst); }});
  measures.push_back({{"at the end", "mm"}, [end](const Finding& f) { return length_cell(f.end.*end); }});
}

/// Those that say something of the scene.
List<Measure> measures_of(const Task& task) {
  List<Measure> measures;
  add_error("overlap", &Finding::worst_overlap, &Errors::overlap, measures);
  if (!task.scene.joints().empty()) add_error("joint gap", &Finding::worst_gap, &Errors::gap, measures);
  if (task.entry.stands) {
    measures.push_back({{"top sinks", "mm"}, sinks_cell});
    measures.push_back({{"stands", ""}, stands_cell});
  }
  if (task.entry.outside) {
    measures.push_back({{"outside", "bodies"}, [](const Finding& f) { return grouped(f.end.outside); }});
  }
  return measures;
}

/// What takes part in a table, and what was found of it.
struct Entrants {
  List<Contestant> contestants = {};
  List<Finding> findings = {};
  List<std::string> notes = {};  // on those who do not
};

List<std::string> row(const Finding& finding, const List<Measure>& measures, const List<double>& times,
                      const List<double>& reference) {
  List<std::string> cells = finding.refused    ? List<std::string>{"cannot", "-", "-"}
                            : finding.too_slow ? List<std::string>{"too slow", "-", "-"}
                                               : time_cells(times, reference);
  const bool ran = !finding.refused && !finding.too_slow;
  for (const Measure& measure : measures) {
    cells.push_back(ran && !finding.end.exploded ? measure.cell(finding) : "-");
  }
  if (finding.end.exploded) cells.front() = "explodes";
  cells.push_back(ran ? fmt::format("{:.0f}", finding.bytes / 1024) : "-");
  return cells;
}

/// Takes the times and prints a line for each.
void print_rows(const Task& task, const Entrants& entrants) {
  const auto& [contestants, findings, notes] = entrants;
  const List<List<double>> all_times = times(task, contestants, findings);
  const List<Measure> measures = measures_of(task);
  List<Column> columns = {{"engine", ""}, {"step", "us"}, {"quartiles", "us"}, {"ratio", "to the first"}};
  for (const Measure& measure : measures) columns.push_back(measure.column);
  columns.push_back({"memory", "kB"});
  TextTable table(columns);
  for (int i = 0; i < contestants.size(); ++i) {
    List<std::string> cells = row(findings[i], measures, all_times[i], all_times.front());
    cells.insert(cells.begin(), contestants[i].name);
    table.add(cells);
  }
  fmt::print("{}", table.text());
  for (const std::string& note : notes) fmt::print("  {}\n", note);
  fmt::print("\n");
  std::fflush(stdout);
}

/// Of the settings of Cairn, those that texts compare with the first line.
bool is_among_few(const std::string& name) {
  const List<std::string> few = {"Cairn, the default", "Cairn newton to 1e-06",
                                 "Cairn newton to 1e-06, moved", "Cairn wide to 0.001, moved",
                                 "Cairn wide x1, 4 substeps, moved, soft"};
  return std::find(few.begin(), few.end(), name) != few.end();
}

void print_work_in(const PeerScene& entry, const List<Contestant>& contestants, const RunLength& length) {
  const Task task(entry, length);
  Entrants entrants = {.contestants = contestants};
  for (const Contestant& one : entrants.contestants) {
    entrants.findings.push_back(find_errors(task, one));
    const std::optional<std::string>& refused = entrants.findings.back().refused;
    if (refused) entrants.notes.push_back(*refused);
  }
  fmt::print("{}: {}\n{} bodies, {} joints, {} steps\n", entry.name, entry.about,
             task.scene.bodies().size() - 1, task.scene.joints().size(), task.length.steps);
  print_rows(task, entrants);
}

/// The first setting of a method that reaches the target, or a note that none does.
void add_cheapest(const Task& task, const Method& method, const Target& target, Entrants& entrants) {
  for (const Contestant& setting : method) {
    const Finding finding = find_errors(task, setting, target);
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
  const Task task(entry, length);
  const Target& target = *entry.target;
  Entrants entrants;
  for (const Method& method : methods()) add_cheapest(task, method, target, entrants);
  fmt::print("{}: {} at most {:g} mm", entry.name, task.scene.joints().empty() ? "overlap" : "joint gap",
             1e3 * target.error);
  if (target.sinking > 0) {
    fmt::print(", the top sinks or rises at most {:g} m, nothing goes more than 0.5 m aside", target.sinking);
  }
  fmt::print("\n");
  print_rows(task, entrants);
}

}  // namespace

void print_equal_work(const List<PeerScene>& scenes, const RunLength& length) {
  print_heading("1. Equal work: every engine as it comes");
  fmt::print(
      "Settings that users begin with. They are not equally hard work, so read times beside errors. A\n"
      "ratio above 1 is slower than the first line. Overlaps and gaps of joints are the worst of every\n"
      "tenth step, measured by Cairn for all engines alike, without the skins that some engines add: their\n"
      "piles rise at first. A pile falls when a body has gone more than 0.5 m aside. Outside are the bodies\n"
      "that are behind a wall at the end. Memory is what is on the heap then. Too slow: a run took more\n"
      "than {:g} s, and was broken off. Where all runs of a line would take longer than that, there are\n"
      "fewer, and where two would, its time is that of the run whose errors were measured.\n\n",
      length.most);
  for (const PeerScene& scene : scenes) print_work_in(scene, usual_contestants(), length);
}

void print_large_pyramid(const RunLength& usual) {
  RunLength length = usual;
  length.most = std::max(usual.most, 20.0);
  print_heading("4. A large pyramid");
  fmt::print("As in 1, for fewer settings. A run may take {:g} s.\n\n", length.most);
  List<Contestant> contestants;
  for (const Contestant& one : usual_contestants()) {
    if (contestants.empty() || is_among_few(one.name)) contestants.push_back(one);
  }
  for (const PeerScene& scene : peer_scenes()) {
    if (scene.name == "pyramid-100") print_work_in(scene, contestants, length);
  }
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
