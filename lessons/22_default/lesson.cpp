// Lesson 22. The default setting, and what all rows at once are good for.
// Sweeps carry a pull from joint to joint. So a bridge sinks under them, and hangs level if all its rows are
// solved at once. Then the other parts of the default are switched off, one at a time, and the scenes beyond
// its border.
#include "lesson.hpp"

#include <chrono>

namespace cairn::usual {

namespace {

Trials try_parts(const Kind& kind, const List<Part>& tried) {
  Trials trials{.kind = kind, .usual = default_setting(kind.scene)};
  for (const Part& part : tried) {
    Setting setting = trials.usual.setting;
    part.change(setting);
    trials.outcomes.push_back(try_setting(kind, setting, seconds));
    trials.outcomes.back().name = part.name;
  }
  return trials;
}

/// The default, which sweeps here, and all rows at once in its place.
Trials try_beyond(const Kind& kind, double duration) {
  Trials trials{.kind = kind, .usual = default_setting(kind.scene)};
  Setting exact = trials.usual.setting;
  exact.solver = "newton";
  trials.outcomes = {try_setting(kind, trials.usual.setting, duration), try_setting(kind, exact, duration)};
  trials.outcomes[0].name = "default";
  trials.outcomes[1].name = "newton";
  return trials;
}

SweepTrial try_sweeps(const Kind& kind, int sweeps) {
  Setting setting = default_setting(kind.scene).setting;
  setting.solver = "wide";
  setting.sweeps.iterations = sweeps;
  const Outcome outcome = try_setting(kind, setting, seconds);
  return {sweeps, outcome.sunk, outcome.work};
}

/// [m] How far bodies are from where they are in a Simulation, which chooses by itself.
double gap_to_simulation(const Trials& trials) {
  Simulation simulation(trials.kind.scene);
  const Outcome& usual = trials.outcomes[nothing_off];
  for (int k = 0; k < usual.sunk_by_step.size(); ++k) simulation.step();
  double gap = 0;
  for (const BodyId body : usual.last.bodies.indices()) {
    const Vec2<double> here = simulation.world().bodies().pose[body].position;
    gap = std::max(gap, (here - usual.last.bodies[body].pose.position).norm());
  }
  return gap;
}

void run(Lesson& lesson) {
  const DefaultSettings settings{
      .planks = lesson.whole("planks"), .density = lesson.real("density"), .tower = lesson.whole("tower")};
  const Kind loaded = bridge(settings.planks, settings.density);
  lesson.print(fmt::format(
      "Scene: {} planks on pins between two banks, with three loads of {:.3g} kg; {:g} s at 60 Hz",
      settings.planks, settings.density * 0.64, seconds));
  lesson.print("Its default: " + default_setting(loaded.scene).reason);
  lesson.predict();
  DefaultRuns runs{.settings = settings};
  runs.bridge = try_parts(loaded, parts());
  runs.beam = try_parts(beam(20), {parts().front(), parts().back()});
  runs.from_simulation = gap_to_simulation(runs.bridge);
  runs.large = {try_beyond(tower(settings.tower), 9), try_beyond(pile(102), 1)};
  for (int sweeps = 10; sweeps <= 640; sweeps *= 2) runs.sweeps.push_back(try_sweeps(loaded, sweeps));
  report(lesson, runs);
  lesson.film(default_shots(runs));
  lesson.data(outcomes_table(runs));
  lesson.fingerprint(runs.bridge.outcomes[nothing_off].last);
}

}  // namespace

List<Part> parts() {
  return {
      {"default", [](Setting&) {}},
      {"one substep", [](Setting& setting) { setting.substeps = 1; }},
      {"one solve", [](Setting& setting) { setting.stabilization.policy = StabilizationPolicy::baumgarte; }},
      {"one system", [](Setting& setting) { setting.sweeps.iterations = 1; }},
      {"20 sweeps", [](Setting& setting) { setting.solver = "wide"; }}};
}

Outcome try_setting(const Kind& kind, const Setting& setting, double duration) {
  Scene scene = kind.scene;
  scene.set_settings(with_setting(scene.settings(), setting));
  World world(scene);
  const std::unique_ptr<Solver<double>> solver = make_solver<double>(setting.solver, setting.sweeps);
  const double price = solver_entry(setting.solver).work_of_a_sweep;
  const int steps = static_cast<int>(std::lround(duration / setting.dt));
  Outcome outcome;
  const double place = snapshot(world).bodies[kind.watched].pose.position.y();
  for (int k = 0; k < steps; ++k) {
    const auto begin = std::chrono::steady_clock::now();
    const StepReport step = world.step(*solver);
    outcome.work += price * static_cast<double>(step.row_sweeps) + static_cast<double>(step.extra_row_sweeps);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    outcome.milliseconds += 1000 * taken.count();
    outcome.last = snapshot(world);
    outcome.overlap_by_step.push_back(worst_penetration(outcome.last));
    const double sunk = place - outcome.last.bodies[kind.watched].pose.position.y();
    if (k == 0 || sunk >= outcome.sunk) outcome.lowest = outcome.last;
    outcome.sunk = std::max(outcome.sunk, sunk);
    outcome.sunk_by_step.push_back(sunk);
    outcome.gap = std::max(outcome.gap, worst_joint_drift(outcome.last));
  }
  outcome.overlap = *std::max_element(outcome.overlap_by_step.begin(), outcome.overlap_by_step.end());
  outcome.work /= steps;
  outcome.milliseconds /= steps;
  return outcome;
}

}  // namespace cairn::usual

int main(int argc, char** argv) { return cairn::run_lesson(cairn::card(), cairn::usual::run, argc, argv); }
