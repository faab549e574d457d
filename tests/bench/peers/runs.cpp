// Engines are made, stepped and looked at; only their steps are timed.
#include "runs.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cairn::bench {

namespace {

const int look_every = 10;  // steps

int warm_up(const RunLength& length) { return length.steps / 10; }

/// Seconds of a step, the steps of the warm-up left out.
double seconds_of_a_step(const Scene& scene, const Contestant& contestant, const RunLength& length) {
  const std::unique_ptr<Engine> engine = contestant.make(scene);
  for (int step = 0; step < warm_up(length); ++step) engine->step();
  const Stopwatch watch;
  for (int step = warm_up(length); step < length.steps; ++step) engine->step();
  return watch.seconds() / (length.steps - warm_up(length));
}

/// None where the engine refuses the scene.
std::unique_ptr<Engine> made(const Contestant& contestant, const Scene& scene,
                             std::optional<std::string>& refused) {
  try {
    return contestant.make(scene);
  } catch (const std::invalid_argument& refusal) {
    refused = refusal.what();
    return nullptr;
  }
}

}  // namespace

Task::Task(const PeerScene& from, const RunLength& usual) : entry(from), scene(from.make()), length(usual) {
  if (entry.steps > 0) length.steps = std::min(length.steps, entry.steps);
}

bool reaches(const Finding& finding, const Target& target) {
  const Errors& end = finding.end;
  const bool held = std::max(finding.worst_overlap, finding.worst_gap) <= target.error;
  const bool stood = target.sinking == 0 || (std::abs(end.sinking) <= target.sinking && end.aside <= 0.5);
  return !finding.refused && !finding.too_slow && !end.exploded && held && stood;
}

Finding find_errors(const Task& task, const Contestant& contestant, const std::optional<Target>& target) {
  const RunLength& length = task.length;
  Finding finding;
  Ruler ruler(task.entry, task.scene);
  const double before = heap_in_use();
  const std::unique_ptr<Engine> engine = made(contestant, task.scene, finding.refused);
  if (!engine) return finding;
  double all = 0, warm = 0;  // [s] of all steps, and of those after the warm-up
  int step = 0;
  const auto goes_on = [&] {
    if (finding.end.exploded || (target && !reaches(finding, *target))) return false;
    finding.too_slow = all > length.most;
    return step < length.steps && !finding.too_slow;
  };
  while (goes_on()) {
    const Stopwatch watch;
    try {
      engine->step();
    } catch (const std::length_error&) {  // more contacts than a step takes: bodies are in one place
      finding.end.exploded = true;
      return finding;
    }
    const double seconds = watch.seconds();
    all += seconds;
    if (step >= warm_up(length)) warm += seconds;
    step += 1;
    const bool looks = step > warm_up(length) && (step % look_every == 0 || step == length.steps);
    if (!looks) continue;
    finding.end = ruler.errors(*engine);
    finding.worst_overlap = std::max(finding.worst_overlap, finding.end.overlap);
    finding.worst_gap = std::max(finding.worst_gap, finding.end.gap);
  }
  finding.seconds = warm / std::max(1, step - warm_up(length));
  finding.bytes = heap_in_use() - before;
  return finding;
}

List<List<double>> times(const Task& task, const List<Contestant>& contestants,
                         const List<Finding>& findings) {
  const RunLength& length = task.length;
  List<List<double>> all(contestants.size());
  for (int repetition = 0; repetition < length.repetitions; ++repetition) {
    for (int turn = 0; turn < contestants.size(); ++turn) {
      const int i = (repetition + turn) % contestants.size();
      if (findings[i].refused || findings[i].too_slow || findings[i].end.exploded) continue;
      const double run_time = findings[i].seconds * length.steps;
      if (2 * run_time > length.most) {
        if (repetition == 0) all[i].push_back(findings[i].seconds * 1e9);
        continue;
      }
      if ((repetition + 1) * run_time > length.most) continue;
      // A short run is done again until it fills what can be timed.
      const auto runs = std::min<std::int64_t>(100, iterations_for(run_time));
      double sum = 0;
      for (int run = 0; run < runs; ++run) sum += seconds_of_a_step(task.scene, contestants[i], length);
      all[i].push_back(sum / static_cast<double>(runs) * 1e9);
    }
  }
  return all;
}

}  // namespace cairn::bench
