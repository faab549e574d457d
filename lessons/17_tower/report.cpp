// What lesson 17 prints, and the claims that it makes.
#include "lesson.hpp"

namespace cairn::tower {

namespace {

void print_loads(Lesson& lesson, std::string_view title, const List<EngineRun>& runs) {
  lesson.print();
  lesson.print(fmt::format("{:<22}{:>12}{:>12}{:>14}   N on the lowest box", title, runs[0].name,
                           runs[1].name, runs[2].name));
  const int steps = runs[0].loads.size() - 1;
  for (const int k : {1, 2, 3, 5, 10, 20, 50, 100}) {
    if (k > steps) break;
    lesson.print(fmt::format("  step {:>3}             {:>12.4f}{:>12.4f}{:>14.4f}", k, runs[0].loads[k][0],
                             runs[1].loads[k][0], runs[2].loads[k][0]));
  }
}

/// PGS and SI differ by rounding: each of sweeps x rows visits a step rounds sums of loads at most as large
/// as twice the weight, and a sweep passes errors on to the next with a factor below 1, so at most some 4 /
/// rate sweeps count; all sweeps of all steps are a safe bound.
double rounding_bound(const TowerSettings& settings) {
  const double visits = double(settings.steps) * settings.sweeps * 2 * settings.boxes;
  return 2.3e-16 * 2 * settings.boxes * settings.gravity * visits;
}

/// Box2D rounds to 24 bits; see tests/reference/tower_tests.cpp for 10 boxes. Weight and steps scale it.
double box2d_bound(const TowerSettings& settings) {
  return 1e-3 * (settings.boxes * settings.gravity / 100) * (0.02 / settings.dt);
}

void check_runs(Lesson& lesson, std::string_view start, const List<EngineRun>& runs, const Loads& by_hand,
                const TowerSettings& settings) {
  const double bound = rounding_bound(settings);
  const int steps = steps_as_tower(runs);
  const std::string loads = steps == settings.steps ? "loads (N)" : fmt::format("loads, {} steps (N)", steps);
  lesson.check_small(fmt::format("{}: PGS and SI carry the same {}", start, loads),
                     largest_gap(runs[0].loads, runs[1].loads, steps), bound);
  lesson.check_small(fmt::format("{}: SI is Gauss-Seidel on masses on a line{}", start, loads.substr(5)),
                     largest_gap(runs[1].loads, by_hand, steps), bound);
  lesson.check_small(fmt::format("{}: SI and Box2D carry the same {}", start, loads),
                     largest_gap(runs[1].loads, runs[2].loads, steps), box2d_bound(settings));
}

void check_order(Lesson& lesson, const TowerRuns& runs) {
  const List<EngineRun>& from_top = runs.from_top;
  const double bound = box2d_bound(runs.settings);
  lesson.check_small("from the top down: SI and Box2D carry the same loads (N)",
                     largest_gap(from_top[0].loads, from_top[1].loads, steps_as_tower(from_top)), bound);
  double ground = 0;
  for (int k = 0; k < from_top[1].loads.size(); ++k)
    ground = std::max(ground, std::abs(from_top[1].loads[k][0] - runs.warm[1].loads[k][0]));
  lesson.check_small("either order: the same load at the ground (N)", ground, bound);
  if (runs.settings.boxes < 3 || runs.settings.sweeps > 20) return;  // where the order matters little
  lesson.check_that("one from the ground up, one from the top down: they differ by far more (N)",
                    gap_of_orders(runs) > 10 * bound, fmt::format("{:.1f}", gap_of_orders(runs)));
  const double more = std::abs(runs.one_more.loads[asked_step][0] - runs.warm[1].loads[asked_step][0]);
  lesson.check_that("one sweep more: another load at the ground (N)", more > 10 * bound,
                    fmt::format("{:.2f}", more));
}

double top_of(const EngineRun& run) { return run.frames.back().bodies.back().pose.position.y() + 0.5; }

void print_ends(Lesson& lesson, const TowerRuns& runs) {
  lesson.print(fmt::format(
      "Top of the tower at {:.2f} s:  warm {:.3f} m (SI) and {:.3f} m (Box2D), cold {:.3f} m and {:.3f} m.",
      runs.settings.steps * runs.settings.dt, top_of(runs.warm[1]), top_of(runs.warm[2]),
      top_of(runs.cold[1]), top_of(runs.cold[2])));
  const int cold = steps_as_tower(runs.cold);
  if (cold < runs.settings.steps)
    lesson.print(fmt::format(
        "Cold, boxes overlap by half from step {} on: from then on it is no longer a tower.", cold));
  lesson.print(
      "Box2D wraps its shapes in a skin and pushes them apart by a pass of its own: compare loads, not "
      "heights.");
  const int asleep = box2d_falls_asleep(runs.settings, 500);
  if (asleep > 0)
    lesson.print(fmt::format("With sleeping allowed, Box2D stops simulating it after step {}.", asleep));
}

/// What each way to step the tower finds in the asked step, and how far it is from SI in any step.
void print_fingerprints(Lesson& lesson, const TowerRuns& runs) {
  const int middle = middle_box(runs);
  lesson.print(
      fmt::format("In step {}, warm (N):               ground{:>10}   any load, any step: from SI by",
                  asked_step, fmt::format("box {}", middle + 1)));
  const auto line = [&](const std::string& name, const Loads& loads) {
    const double gap = largest_gap(runs.warm[1].loads, loads, steps_as_tower(runs.warm));
    lesson.print(fmt::format("  {:<30}{:>10.2f}{:>10.2f}{:>31.2g}", name, loads[asked_step][0],
                             loads[asked_step][middle], gap));
  };
  line("SI, from the ground up", runs.warm[1].loads);
  line("Box2D, single precision", runs.warm[2].loads);
  line("PGS, with A and b", runs.warm[0].loads);
  line("Box2D, from the top down", runs.from_top[1].loads);
  line(fmt::format("SI with {} sweeps", runs.settings.sweeps + 1), runs.one_more.loads);
  const auto steps = [&](const std::string& name, const Loads& loads) {
    std::string text = fmt::format("  {:<30}", name);
    for (int k = 1; k <= asked_step; ++k) text += fmt::format("{:>10.2f}", loads[k][middle]);
    lesson.print(text);
  };
  lesson.print(fmt::format("Under box {}, in steps 1 to {} (N):", middle + 1, asked_step));
  steps("SI, from the ground up", runs.warm[1].loads);
  steps("Box2D, from the top down", runs.from_top[1].loads);
  lesson.print();
}

}  // namespace

void report(Lesson& lesson, const TowerRuns& runs) {
  print_loads(lesson, "warm start", runs.warm);
  print_loads(lesson, "cold start", runs.cold);
  lesson.print();
  print_ends(lesson, runs);
  lesson.print();
  print_fingerprints(lesson, runs);
  const List<TurningRun> turning = run_turning();
  print_turning(lesson, turning);
  lesson.answer(
      {3}, 0,
      "From the top down, what the ground gives climbs by one contact a sweep: in step 1 the load under a "
      "box in the middle comes late, and that at the ground does not.");
  check_runs(lesson, "warm", runs.warm, runs.warm_by_hand, runs.settings);
  check_runs(lesson, "cold", runs.cold, runs.cold_by_hand, runs.settings);
  check_order(lesson, runs);
  check_turning(lesson, turning);
  const double first = runs.warm[1].loads[1][0];
  lesson.check_equal("step 1 is the same, warm or cold (N)", runs.cold[1].loads[1][0], first, 0);
}

CsvTable loads_table(const TowerRuns& runs) {
  CsvTable table{.header = {"start", "step", "interface", "pgs_newton", "si_newton", "box2d_newton"}};
  for (const auto* engines : {&runs.warm, &runs.cold}) {
    for (int k = 1; k < (*engines)[0].loads.size(); ++k) {
      for (int i = 0; i < (*engines)[0].loads[k].size(); ++i) {
        table.rows.push_back({engines == &runs.warm ? "warm" : "cold", k, i + 1, (*engines)[0].loads[k][i],
                              (*engines)[1].loads[k][i], (*engines)[2].loads[k][i]});
      }
    }
  }
  return table;
}

}  // namespace cairn::tower
