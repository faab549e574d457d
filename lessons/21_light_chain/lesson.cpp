// Lesson 21. A light chain: exactly solved, and torn all the same.
// Light beads hang on rods, and a heavy weight below them. Up to some load the chain hangs still. A little
// more, and it goes to pieces, with ten sweeps, with ten thousand, and with a solver that leaves no error at
// all. What fails is not the solve, but the step: it takes the directions of the rods for constant.
#include "lesson.hpp"

namespace cairn::taut {

namespace {

/// [m] of the bead that is farthest from the line, and whether all numbers still are numbers.
double farthest(const BodyState<double>& bodies) {
  double most = 0;
  for (const Pose<double>& pose : bodies.pose) {
    if (!pose.position.allFinite()) return std::numeric_limits<double>::infinity();
    most = std::max(most, std::abs(pose.position.x()));
  }
  return most;
}

/// [m] The chain begins so little bent that it grows a thousandfold and still is straight for all that
/// counts.
constexpr double hardly_bent = 1e-9;
constexpr int watched_steps = 150;

bool holds(const ChainSettings& settings) {
  World world(chain_scene(settings, {.bent = hardly_bent}));
  NewtonSolver<double> exact({.iterations = 20});
  for (int k = 0; k < watched_steps; ++k) {
    world.step(exact);
    if (farthest(world.bodies()) > 1000 * hardly_bent) return false;
  }
  return true;
}

Critical find_critical(ChainSettings settings) {
  Critical critical{.dt = settings.dt, .rule = load_by_rule(settings), .predicted = critical_load(settings)};
  double low = 0.8 * critical.predicted, high = 1.2 * critical.predicted;
  while (high - low > 2e-4 * high) {
    settings.load = (low + high) / 2;
    (holds(settings) ? low : high) = settings.load;
  }
  critical.measured = (low + high) / 2;
  return critical;
}

/// Steps the chain until the fastest swing has outgrown all others.
Growth measure_growth(const ChainSettings& settings) {
  Growth growth{.load = settings.load,
                .angle = fastest_angle(settings),
                .predicted = growth_by_formula(fastest_angle(settings))};
  World world(chain_scene(settings, {.bent = 1e-12}));
  NewtonSolver<double> exact({.iterations = 20});
  double before = 0, now = 0;
  for (int k = 0; k < 400 && now < 1e-5; ++k) {
    before = now;
    world.step(exact);
    now = farthest(world.bodies());
  }
  growth.measured = now < 1e-5 ? 1 : now / before;
  return growth;
}

List<ChainRun> run_sweeps(const ChainSettings& settings, int steps) {
  List<ChainRun> runs;
  for (const int sweeps : {10, 100, 10'000}) {
    SequentialImpulse<double> si({.iterations = sweeps});
    runs.push_back(run_chain(fmt::format("{} sweeps", spaced(sweeps)), settings, {}, si, steps));
  }
  NewtonSolver<double> exact({.iterations = 20});
  runs.push_back(run_chain("exact", settings, {}, exact, steps));
  return runs;
}

List<ChainRun> run_cures(const ChainSettings& settings, int steps) {
  NewtonSolver<double> exact({.iterations = 20});
  const auto run = [&](const std::string& name, const ChainRules& rules) {
    return run_chain(name, settings, rules, exact, steps);
  };
  ChainSettings twice = settings;
  twice.bead *= 2;
  return {run_chain("beads of twice the mass", twice, {}, exact, steps),
          run("enough mass", {.masses = masses_needed(settings)}),
          run("steps of " + part_name(settings), {.substeps = settings.parts}),
          run("the default", {.policy = StabilizationPolicy::relaxed})};
}

void run(Lesson& lesson) {
  const ChainSettings settings{.beads = lesson.whole("beads"),
                               .bead = lesson.real("bead"),
                               .load = lesson.real("load"),
                               .dt = lesson.real("dt"),
                               .parts = lesson.whole("parts")};
  lesson.print(fmt::format("Scene: {} beads of {:g} kg on rods of {:g} m, a load below them, Δt = {:g} s",
                           settings.beads, settings.bead, rod_length, settings.dt));
  lesson.predict();
  ChainRuns runs{.settings = settings};
  for (const int parts : {1, 2, settings.parts}) {
    ChainSettings finer = settings;
    finer.dt /= parts;
    runs.criticals.push_back(find_critical(finer));
  }
  for (const double share : {0.5, 0.9, 1.05, 1.1, 1.25, 1.5, 2.0}) {
    ChainSettings loaded = settings;
    loaded.load = share * runs.criticals[0].predicted;
    runs.growths.push_back(measure_growth(loaded));
  }
  runs.sweeps = run_sweeps(settings, film_steps);
  runs.cures = run_cures(settings, film_steps);
  report(lesson, runs);
  lesson.film(chain_shots(runs));
  lesson.data(numbers_table(runs));
  lesson.fingerprint(runs.cures.back().frames.back());
}

}  // namespace

std::string part_name(const ChainSettings& settings) {
  return settings.parts == 4 ? "a quarter" : fmt::format("1/{}", settings.parts);
}

ChainRun run_chain(const std::string& name, const ChainSettings& settings, const ChainRules& rules,
                   Solver<double>& solver, int steps) {
  World world(chain_scene(settings, rules));
  ChainRun run{.name = name, .frames = {snapshot(world)}, .off = {rules.bent}};
  for (int k = 1; k <= steps; ++k) {
    world.step(solver);
    run.frames.push_back(snapshot(world));
    run.off.push_back(farthest(world.bodies()));
    if (run.torn < 0 && !(run.off.back() < lost)) run.torn = k;
  }
  return run;
}

}  // namespace cairn::taut

int main(int argc, char** argv) { return cairn::run_lesson(cairn::card(), cairn::taut::run, argc, argv); }
