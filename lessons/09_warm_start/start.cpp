// The runs of the engine, and the step whose rows come in another order.
#include "start.hpp"

#include <algorithm>

#include "lessons/lesson.hpp"

namespace cairn::warm {

namespace {

/// Sequential impulses that do not begin from what the world hands them.
class Misplaced final : public Solver<double> {
 public:
  enum class Mistake { one_place_on, by_number };
  Misplaced(int sweeps, Mistake mistake) : sweeps_({.iterations = sweeps}), mistake_(mistake) {}

  std::string name() const override { return "SI, misplaced"; }
  SolveReport solve(VelocityProblem<double>& problem, SolveObserver<double>* observer = nullptr) override {
    if (mistake_ == Mistake::one_place_on) {
      shift(problem);
    } else {
      kept_.resize(problem.impulse.size(), 0.0);
      problem.impulse = kept_;
    }
    const SolveReport report = sweeps_.solve(problem, observer);
    kept_ = problem.impulse;
    return report;
  }

 private:
  /// Every manifold but the first gets the impulses of the one before.
  static void shift(VelocityProblem<double>& problem) {
    const std::vector<double> right = problem.impulse;
    for (std::size_t block = 1; block < problem.blocks.size(); ++block) {
      const RowBlock& from = problem.blocks[block - 1];
      const RowBlock& to = problem.blocks[block];
      for (int i = 0; i < std::min(from.count, to.count); ++i) {
        problem.impulse[static_cast<std::size_t>(to.first + i)] =
            right[static_cast<std::size_t>(from.first + i)];
      }
    }
  }

  SequentialImpulse<double> sweeps_;
  Mistake mistake_;
  std::vector<double> kept_;
};

enum class Guest { none, ball };

/// The boxes do not turn and do not rub: both points of an interface ask for the same, and it counts as one
/// row.
Scene tower(const StartSettings& settings, Start start, Guest guest) {
  Scene scene({.gravity = {0, -gravity},
               .dt = settings.dt,
               .stabilization = {.baumgarte = 0},
               .warm_start = start != Start::cold});
  scene.add_ground({.friction = 0});
  if (guest == Guest::ball) {
    scene.add({.shapes = {circle(0.4)}, .position = {-1.6, 0.6}, .mass = 1, .friction = 0, .restitution = 1});
  }
  for (int i = 0; i < settings.boxes; ++i) {
    scene.add(
        {.shapes = {box(1, 1)}, .position = {0, 0.5 + i}, .mass = 1, .friction = 0, .fixed_rotation = true});
  }
  return scene;
}

/// `lowest`: the number of the lowest box.
std::vector<double> loads_of(const Snapshot& snapshot, const StartSettings& settings, int lowest) {
  std::vector<double> loads;
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
  if (world.step(solver).not_finite) throw Diverged("lesson09: the tower blew up");
}

StartRun run_tower(const StartSettings& settings, Start start, Solver<double>& solver, const char* name) {
  World world(tower(settings, start, Guest::none));
  StartRun run{.name = name, .comparable = settings.steps};
  for (int k = 0; k <= settings.steps; ++k) {
    if (k > 0) advance(world, solver);
    run.frames.push_back(snapshot(world));
    run.loads.push_back(loads_of(run.frames.back(), settings, 1));
    if (is_too_deep(run.frames.back())) run.comparable = std::min(run.comparable, k - 1);
  }
  return run;
}

GuestRun run_guest(const StartSettings& settings) {
  World keyed(tower(settings, Start::warm, Guest::ball));
  World numbered = keyed;
  SequentialImpulse right({.iterations = settings.sweeps});
  Misplaced wrong(settings.sweeps, Misplaced::Mistake::by_number);
  GuestRun run;
  for (int k = 0; k <= settings.steps; ++k) {
    if (k > 0) advance(keyed, right);
    if (k > 0) advance(numbered, wrong);
    run.frames.push_back(snapshot(numbered));
    run.by_key.push_back(loads_of(snapshot(keyed), settings, 2));
    run.by_number.push_back(loads_of(run.frames.back(), settings, 2));
    const std::vector<SnapshotContact>& contacts = run.frames.back().contacts;
    run.ball_touches.push_back(!contacts.empty() && contacts.front().b == BodyId{1});
  }
  return run;
}

std::vector<double> heights_per_second(const VelocityProblem<double>& problem) {
  std::vector<double> result;
  for (std::size_t box = 1; box < problem.velocity.size(); ++box) {
    result.push_back(problem.velocity[box].y());
  }
  return result;
}

ReversedStep reverse_rows(const StartSettings& settings) {
  VelocityProblem<double> problem = tower_rows(settings.boxes, settings.dt);
  Memory memory;
  std::vector<double> list;
  for (int i = 0; i < settings.boxes; ++i) {
    list.push_back((settings.boxes - i) * gravity * settings.dt);
    memory.emplace_back(problem.rows[static_cast<std::size_t>(i)].key, list.back());
  }
  std::reverse(problem.rows.begin(), problem.rows.end());

  VelocityProblem<double> by_key = problem;
  VelocityProblem<double> by_number = problem;
  ReversedStep step;
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    by_key.impulse[i] = remembered(memory, problem.rows[i].key);
    by_number.impulse[i] = list[i];
    step.by_key.push_back(by_key.impulse[i] / settings.dt);
    step.by_number.push_back(by_number.impulse[i] / settings.dt);
  }
  std::reverse(step.by_key.begin(), step.by_key.end());
  std::reverse(step.by_number.begin(), step.by_number.end());
  VelocityProblem<double> solved = by_number;
  apply_impulses(by_key);
  apply_impulses(by_number);
  step.velocity_by_key = heights_per_second(by_key);
  step.velocity_by_number = heights_per_second(by_number);
  SequentialImpulse({.iterations = settings.sweeps}).solve(solved);
  step.velocity_after = heights_per_second(solved);
  return step;
}

/// The relative error of the first row's impulse, sweep by sweep.
class LowestError final : public SolveObserver<double> {
 public:
  LowestError(double exact, std::vector<double>& error) : exact_(exact), error_(error) {}
  void before_solve(const VelocityProblem<double>&) override { error_.push_back(1); }
  void after_sweep(int, const VelocityProblem<double>& problem) override {
    error_.push_back(1 - problem.impulse.front() / exact_);
  }

 private:
  double exact_;  // [N s]
  std::vector<double>& error_;
};

ColdSweeps sweep_cold(int boxes, double dt) {
  ColdSweeps result{.boxes = boxes};
  VelocityProblem<double> problem = tower_rows(boxes, dt);
  LowestError observer(boxes * gravity * dt, result.error);
  // Twice the formula's, to be sure to get there.
  const int enough = static_cast<int>(2 * needed_by_formula(boxes)) + 10;
  SequentialImpulse({.iterations = enough}).solve(problem, &observer);
  const auto there = std::find_if(result.error.begin(), result.error.end(),
                                  [](double error) { return error <= wanted_error; });
  result.needed = static_cast<int>(there - result.error.begin());
  return result;
}

/// The sum of the first guesses of the ground's two rows.
double guess_at_half_dt(const StartSettings& settings) {
  World world(tower(settings, Start::warm, Guest::none));
  SequentialImpulse solver({.iterations = settings.sweeps});
  for (int k = 0; k < settings.steps; ++k) advance(world, solver);
  world.set_dt(settings.dt / 2);
  const VelocityProblem<double> next = world.velocity_problem();
  double sum = 0;
  for (std::size_t i = 0; i < next.rows.size(); ++i) {
    if (next.rows[i].a == ground) sum += next.impulse[i];
  }
  return sum / next.dt;
}

}  // namespace

VelocityProblem<double> tower_rows(int boxes, double dt) {
  const auto n = static_cast<std::size_t>(boxes);
  VelocityProblem<double> problem;
  problem.dt = dt;
  problem.inverse_mass.assign(n + 1, {1, 1, 0});
  problem.inverse_mass[0] = {0, 0, 0};  // the ground
  problem.velocity.assign(n + 1, {0, -gravity * dt, 0});
  problem.velocity[0] = {0, 0, 0};
  problem.impulse.assign(n, 0.0);
  for (int i = 0; i < boxes; ++i) {
    ConstraintRow<double> row;
    row.a = {i};
    row.b = {i + 1};
    row.jacobian_a = {0, -1, 0};
    row.jacobian_b = {0, 1, 0};
    row.bounds = Bounds<double>::unilateral();
    row.key = {.source = static_cast<std::uint64_t>(i)};
    problem.blocks.push_back({i, 1});
    problem.rows.push_back(row);
  }
  return problem;
}

double remembered(const Memory& memory, const RowKey& key) {
  const auto found =
      std::lower_bound(memory.begin(), memory.end(), key,
                       [](const auto& entry, const RowKey& wanted) { return entry.first < wanted; });
  return found != memory.end() && found->first == key ? found->second : 0;
}

WarmStart run_all(const StartSettings& settings) {
  WarmStart all{.settings = settings};
  SequentialImpulse sweeps({.iterations = settings.sweeps});
  Misplaced shifted(settings.sweeps, Misplaced::Mistake::one_place_on);
  all.cold = run_tower(settings, Start::cold, sweeps, "cold");
  all.warm = run_tower(settings, Start::warm, sweeps, "warm");
  all.shifted = run_tower(settings, Start::shifted, shifted, "one row off");
  all.guest = run_guest(settings);
  all.reversed = reverse_rows(settings);
  for (const int boxes : {3, 5, 10, 20}) all.sweeps.push_back(sweep_cold(boxes, settings.dt));
  all.own = sweep_cold(settings.boxes, settings.dt);
  all.load_at_half_dt = guess_at_half_dt(settings);
  return all;
}

}  // namespace cairn::warm
