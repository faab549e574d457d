// The towers in a world, and a single step from zero.
#include "lesson.hpp"

#include <cairn/validation/column.hpp>

namespace cairn::warm {

namespace {

enum class Guest { none, ball };

/// The boxes do not turn and do not rub: both points of an interface ask for the same, and it counts as one
/// row.
Scene tower(const StartSettings& settings, Guest guest, bool warm_start = false) {
  Scene scene({.gravity = {0, -gravity},
               .dt = settings.dt,
               .stabilization = {.policy = StabilizationPolicy::baumgarte, .baumgarte = 0},
               .warm_start = warm_start});
  scene.add_ground({.material = {.friction = 0}});
  if (guest == Guest::ball) {
    scene.add({.shapes = {circle(0.4)},
               .position = {-1.6, 0.6},
               .mass = 1,
               .material = {.friction = 0, .restitution = 1}});
  }
  for (int i = 0; i < settings.boxes; ++i) {
    scene.add({.shapes = {box(1, 1)},
               .position = {0, 0.5 + i},
               .mass = 1,
               .material = {.friction = 0},
               .fixed_rotation = true});
  }
  return scene;
}

/// `lowest`: the number of the lowest box.
List<double> loads_of(const Snapshot& snapshot, const StartSettings& settings, int lowest) {
  List<double> loads;
  for (int i = 0; i < settings.boxes; ++i) {
    const BodyId below{i == 0 ? 0 : lowest + i - 1};
    loads.push_back(normal_impulse_between(snapshot, below, BodyId{lowest + i}) / settings.dt);
  }
  return loads;
}

bool is_too_deep(const Snapshot& snapshot) {
  for (const SnapshotContact& contact : snapshot.contacts) {
    if (contact.separation < -too_deep) return true;
  }
  return false;
}

void advance(World<double>& world, Solver<double>& solver) {
  if (world.step(solver).not_finite) throw Diverged("lesson08: the tower blew up");
}

/// The relative error of the first row's impulse, sweep by sweep.
class LowestError final : public SolveObserver<double> {
 public:
  LowestError(double exact, List<double>& error) : exact_(exact), error_(error) {}
  void before_solve(const VelocityProblem<double>&) override { error_.push_back(1); }
  void after_sweep(int, const VelocityProblem<double>& problem) override {
    error_.push_back(1 - problem.impulse.front() / exact_);
  }

 private:
  double exact_;  // [N s]
  List<double>& error_;
};

}  // namespace

StartRun follow_tower(const StartSettings& settings, Solver<double>& solver, const std::string& name) {
  World world(tower(settings, Guest::none));
  StartRun run{.name = name, .comparable = settings.steps};
  for (int k = 0; k <= settings.steps; ++k) {
    if (k > 0) advance(world, solver);
    run.frames.push_back(snapshot(world));
    run.loads.push_back(loads_of(run.frames.back(), settings, 1));
    if (is_too_deep(run.frames.back())) run.comparable = std::min(run.comparable, k - 1);
  }
  return run;
}

double lowest(const StartRun& run) {
  double least = 0;
  for (int k = 0; k < run.frames.size(); ++k) least = std::min(least, risen(run, k));
  return least;
}

double risen(const StartRun& run, int frame) {
  const auto top = [&run](int k) { return run.frames[k].bodies.back().pose.position.y(); };
  return 1000 * (top(frame) - top(0));
}

GuestRun follow_guest(const StartSettings& settings, Solver<double>& by_key, Solver<double>& by_number) {
  World keyed(tower(settings, Guest::ball));
  World numbered = keyed;
  GuestRun run;
  for (int k = 0; k <= settings.steps; ++k) {
    if (k > 0) advance(keyed, by_key);
    if (k > 0) advance(numbered, by_number);
    run.frames.push_back(snapshot(numbered));
    run.by_key.push_back(loads_of(snapshot(keyed), settings, 2));
    run.by_number.push_back(loads_of(run.frames.back(), settings, 2));
    const List<SnapshotContact>& contacts = run.frames.back().contacts;
    run.ball_touches.push_back(!contacts.empty() && contacts.front().b == BodyId{1});
  }
  return run;
}

LibraryRun run_library(const StartSettings& settings) {
  World world(tower(settings, Guest::none, true));
  SequentialImpulse solver({.iterations = settings.sweeps});
  LibraryRun run{.loads = {loads_of(snapshot(world), settings, 1)}};
  for (int k = 0; k < settings.steps; ++k) {
    advance(world, solver);
    run.loads.push_back(loads_of(snapshot(world), settings, 1));
  }
  world.set_dt(settings.dt / 2);
  const VelocityProblem<double> next = world.velocity_problem();
  double sum = 0;  // over the ground's two rows
  for (int i = 0; i < next.row_count(); ++i) {
    if (next.rows[i].a == ground) sum += next.impulse[i];
  }
  run.load_at_half_dt = sum / next.dt;
  return run;
}

ColdSweeps sweep_cold(int boxes, double dt) {
  List<double> errors;
  // One normal row for each interface of a tower that gravity has just made fall.
  VelocityProblem<double> problem = cases::column<double>(List<double>(boxes, 1.0), gravity, dt);
  LowestError observer(boxes * gravity * dt, errors);
  // Twice the formula's, to be sure to get there.
  const int enough = static_cast<int>(2 * needed_by_formula(boxes)) + 10;
  SequentialImpulse({.iterations = enough}).solve(problem, &observer);
  const auto there = std::ranges::find_if(errors, [](double error) { return error <= wanted_error; });
  return {.boxes = boxes, .needed = static_cast<int>(there - errors.begin())};
}

}  // namespace cairn::warm
