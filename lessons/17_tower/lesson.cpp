// Lesson 17. Three solvers, one tower: PGS, SI and Box2D 2.4.1 carry the same loads, converged or not.
#include "lessons/lesson.hpp"

#include <fmt/format.h>

#include <cmath>

#include "pictures.hpp"
#include "tower.hpp"

namespace {

using namespace cairn;
using namespace cairn::tower;

LessonInfo info() {
  return {.number = 17,
          .name = "tower",
          .title = "Three solvers, one tower",
          .idea =
              "Two costumes of one algorithm and a third program, written elsewhere, carry the same loads, "
              "number for number, even in steps where all of them are still far from the answer.",
          .paper = "paper 4.5, with Box2D 2.4.1",
          .equations = {"(22)  λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)      SI and Box2D",
                        "(28)  λᵢ = (bᵢ − Σ A_ij η_j) / A_ii + η_i   PGS"},
          .needs = {"lesson 06", "lesson 08"},
          .reads = {"src/reference/box2d_world.hpp", "tests/reference/tower_tests.cpp"},
          .question = "Will you be able to tell the three towers apart by eye? And by their numbers?",
          .hints = {"Lesson 08 says what PGS and SI have in common.",
                    "Box2D visits one row after the other too: what matters is the order of its visits.",
                    "Box2D computes in single precision: about 7 digits of 100 N."},
          .parameters = {{"bodies", 10, 1, 20, "", "boxes", Parameter::Kind::whole},
                         {"dt", 0.02, 0.001, 0.05, "s", "time step"},
                         {"gravity", 10, 0.1, 100, "m/s^2", "gravity, downwards"},
                         {"sweeps", 10, 1, 200, "", "sweeps in each step", Parameter::Kind::whole},
                         {"steps", 50, 10, 100, "", "steps of each run", Parameter::Kind::whole}},
          .cover = 51,
          .next = "lesson18_speed_accuracy   (what one more digit costs)"};
}

void print_loads(Lesson& lesson, std::string_view title, const std::vector<EngineRun>& runs) {
  lesson.print();
  lesson.print(fmt::format("{:<22}{:>12}{:>12}{:>14}   N on the lowest box", title, runs[0].name,
                           runs[1].name, runs[2].name));
  const int steps = static_cast<int>(runs[0].loads.size()) - 1;
  for (const int k : {1, 2, 3, 5, 10, 20, 50, 100}) {
    if (k > steps) break;
    const auto frame = static_cast<std::size_t>(k);
    lesson.print(fmt::format("  step {:>3}             {:>12.4f}{:>12.4f}{:>14.4f}", k,
                             runs[0].loads[frame][0], runs[1].loads[frame][0], runs[2].loads[frame][0]));
  }
}

/// PGS and SI differ by rounding: each of sweeps x rows visits a step rounds sums of loads at most as large
/// as twice the weight, and a sweep passes errors on to the next with a factor below 1, so at most some 4 /
/// rate sweeps count; all sweeps of all steps are a safe bound.
double rounding_bound(const TowerSettings& settings) {
  const double visits = double(settings.steps) * settings.sweeps * 2 * settings.boxes;
  return 2.3e-16 * 2 * settings.boxes * settings.gravity * visits;
}

void check_runs(Lesson& lesson, std::string_view start, const std::vector<EngineRun>& runs,
                const TowerSettings& settings) {
  const std::vector<std::vector<double>> by_hand = loads_by_hand(settings);
  const double bound = rounding_bound(settings);
  lesson.check_small(fmt::format("{}: PGS and SI carry the same loads (N)", start),
                     largest_gap(runs[0].loads, runs[1].loads, settings.steps), bound);
  lesson.check_small(fmt::format("{}: SI is Gauss-Seidel on masses on a line (N)", start),
                     largest_gap(runs[1].loads, by_hand, settings.steps), bound);
  // Box2D rounds to 24 bits; see tests/reference/tower_tests.cpp for 10 boxes. Weight and sweeps scale it.
  const double load_tolerance = 1e-3 * (settings.boxes * settings.gravity / 100) * (0.02 / settings.dt);
  lesson.check_small(fmt::format("{}: SI and Box2D carry the same loads (N)", start),
                     largest_gap(runs[1].loads, runs[2].loads, settings.steps), load_tolerance);
}

double top_of(const EngineRun& run) { return run.frames.back().bodies.back().pose.position.y() + 0.5; }

void print_ends(Lesson& lesson, const TowerRuns& runs) {
  lesson.print(
      fmt::format("Top of the tower at {:.2f} s:  warm {:.3f} m (SI) and {:.3f} m (Box2D), cold {:.3f} m and "
                  "{:.3f} m.",
                  runs.settings.steps * runs.settings.dt, top_of(runs.warm[1]), top_of(runs.warm[2]),
                  top_of(runs.cold[1]), top_of(runs.cold[2])));
  lesson.print(
      "Box2D wraps its shapes in a skin and pushes them apart by a pass of its own: compare loads, not "
      "heights.");
  const int asleep = box2d_falls_asleep(runs.settings, 500);
  if (asleep > 0)
    lesson.print(fmt::format("With sleeping allowed, Box2D stops simulating it after step {}.", asleep));
}

CsvTable loads_table(const TowerRuns& runs) {
  CsvTable table{.header = {"start", "step", "interface", "pgs_newton", "si_newton", "box2d_newton"}};
  for (const auto* engines : {&runs.warm, &runs.cold}) {
    for (std::size_t k = 1; k < (*engines)[0].loads.size(); ++k) {
      for (std::size_t i = 0; i < (*engines)[0].loads[k].size(); ++i) {
        table.rows.push_back({engines == &runs.warm ? "warm" : "cold", static_cast<long long>(k),
                              static_cast<long long>(i + 1), (*engines)[0].loads[k][i],
                              (*engines)[1].loads[k][i], (*engines)[2].loads[k][i]});
      }
    }
  }
  return table;
}

void run(Lesson& lesson) {
  TowerSettings settings{.boxes = lesson.whole("bodies"),
                         .dt = lesson.real("dt"),
                         .gravity = lesson.real("gravity"),
                         .sweeps = lesson.whole("sweeps"),
                         .steps = lesson.whole("steps")};
  lesson.print(
      fmt::format("Scene: {} boxes of 1 kg upon each other, touching, g = {:g} m/s², Δt = {:g} s, {} sweeps, "
                  "β = 0",
                  settings.boxes, settings.gravity, settings.dt, settings.sweeps));
  lesson.predict();

  TowerRuns runs{.settings = settings};
  runs.warm = {run_pgs(settings), run_si(settings), run_box2d(settings)};
  TowerSettings cold = settings;
  cold.warm_start = false;
  runs.cold = {run_pgs(cold), run_si(cold), run_box2d(cold)};

  print_loads(lesson, "warm start", runs.warm);
  print_loads(lesson, "cold start", runs.cold);
  lesson.print();
  print_ends(lesson, runs);
  lesson.print();

  check_runs(lesson, "warm", runs.warm, settings);
  check_runs(lesson, "cold", runs.cold, cold);
  const double first = runs.warm[1].loads[1][0];
  lesson.check_equal("step 1 is the same, warm or cold (N)", runs.cold[1].loads[1][0], first, 0);
  lesson.film(tower_shots(runs));
  lesson.data(loads_table(runs));
  lesson.fingerprint(runs.warm[1].frames.back());
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(info(), run, argc, argv); }
