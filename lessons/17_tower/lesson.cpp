// Lesson 17. Three solvers, one tower: PGS, SI and Box2D 2.4.1 carry the same loads, converged or not.
// Ten sweeps are not enough for ten boxes. The loads that they arrive at are wrong, and wrong in a way that
// tells which algorithm has been at work, in which order, with how many sweeps. So the same tower is stepped
// by PGS, by SI, by a program that somebody else wrote, and by fifteen lines of plain loops, once with a warm
// start and once without; and then their loads are laid beside each other, step by step.
#include "lesson.hpp"

namespace {

using namespace cairn;
using namespace cairn::tower;

/// One solver of ours, watched: what each box pushes on the next, after every step.
EngineRun watch(const TowerSettings& settings, Solver<double>& solver) {
  // [steps]
  World world(tower_scene(settings));
  EngineRun run{.name = solver.name()};
  record(run, snapshot(world), settings);
  for (int k = 0; k < settings.steps; ++k) {
    if (world.step(solver).not_finite)
      throw Diverged("lesson17: the tower under " + solver.name() + " blew up");
    record(run, snapshot(world), settings);  // λ = normal impulse / Δt, for each interface
  }
  // [/steps]
  return run;
}

List<EngineRun> watch_all(const TowerSettings& settings) {
  ProjectedGaussSeidel pgs({.iterations = settings.sweeps});  // A λ = b, swept with (28)
  SequentialImpulse si({.iterations = settings.sweeps});      // contact after contact, with (22)
  return {watch(settings, pgs), watch(settings, si), run_box2d(settings)};
}

/// The same tower without any engine: masses of 1 kg on a line, Gauss-Seidel from the ground up.
Loads loads_by_hand(const TowerSettings& settings) {
  const int n = settings.boxes;
  Loads loads(1, List<double>(n, 0.0));
  List<double> v(n + 1, 0.0);        // [m/s] of each box; v[0]: the ground
  List<double> impulse(n + 1, 0.0);  // [N s] between box i and the one below
  const auto push = [&](int i, double p) {
    v[i] += p;
    if (i > 1) v[i - 1] -= p;
  };
  for (int k = 0; k < settings.steps; ++k) {
    for (int i = 1; i <= n; ++i) v[i] -= settings.gravity * settings.dt;
    for (int i = 1; i <= n; ++i) {
      if (!settings.warm_start) impulse[i] = 0;
      push(i, impulse[i]);
    }
    for (int sweep = 0; sweep < settings.sweeps; ++sweep) {
      for (int i = 1; i <= n; ++i) {
        // [by_hand]
        const double corrective = (v[i - 1] - v[i]) / (i > 1 ? 2 : 1);  // (22), times Δt
        const double sum = std::max(impulse[i] + corrective, 0.0);
        // [/by_hand]
        push(i, sum - impulse[i]);
        impulse[i] = sum;
      }
    }
    List<double>& load = loads.emplace_back();
    for (int i = 1; i <= n; ++i) load.push_back(impulse[i] / settings.dt);
  }
  return loads;
}

EngineRun watch_si(const TowerSettings& settings, RowOrder order) {
  SequentialImpulse si({.iterations = settings.sweeps, .order = order});
  return watch(settings, si);
}

/// SI and Box2D, from the top down.
List<EngineRun> watch_from_top(const TowerSettings& settings) {
  return {watch_si(settings, RowOrder::reverse), run_box2d(settings, true)};
}

void run(Lesson& lesson) {
  const TowerSettings warm{.boxes = lesson.whole("bodies"),
                           .dt = lesson.real("dt"),
                           .gravity = lesson.real("gravity"),
                           .sweeps = lesson.whole("sweeps"),
                           .steps = lesson.whole("steps")};
  TowerSettings cold = warm;
  cold.warm_start = false;
  TowerSettings longer = warm;
  longer.sweeps += 1;
  lesson.print(
      fmt::format("Scene: {} boxes of 1 kg upon each other, touching, g = {:g} m/s², Δt = {:g} s, {} sweeps, "
                  "β = 0",
                  warm.boxes, warm.gravity, warm.dt, warm.sweeps));
  lesson.predict();
  const TowerRuns runs{.settings = warm,
                       .warm = watch_all(warm),
                       .cold = watch_all(cold),
                       .warm_by_hand = loads_by_hand(warm),
                       .cold_by_hand = loads_by_hand(cold),
                       .from_top = watch_from_top(warm),
                       .one_more = watch_si(longer, {})};
  report(lesson, runs);
  lesson.film(tower_shots(runs));
  lesson.data(loads_table(runs));
  lesson.fingerprint(runs.warm[1].frames.back());
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(cairn::card(), run, argc, argv); }
