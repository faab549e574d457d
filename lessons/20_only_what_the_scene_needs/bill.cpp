// The scene, its parts, and what each switch makes of them.
#include "bill.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace cairn::needs {

namespace {

const double pitch = 1.2;                 // [m] from box to box in the pyramid
const double tower_at = 9;                // [m]
const double chain_at = 18;               // [m]
const double link = 0.8;                  // [m]
const double reference_tolerance = 1e-6;  // of R_E

void add_pyramid(Scene& scene, double friction) {
  for (int row = 0; row < base; ++row) {
    for (int i = 0; i < base - row; ++i) {
      const double x = (i - 0.5 * (base - row - 1)) * pitch;
      scene.add({.shapes = {box(1, 1)}, .position = {x, 0.5 + row}, .mass = 1, .friction = friction});
    }
  }
  scene.add({.shapes = {circle(0.4)},
             .position = {-9, 1},
             .velocity = {4.5, 9},
             .mass = 0.5,
             .friction = friction});
}

void add_tower(Scene& scene, int boxes, double friction) {
  for (int i = 0; i < boxes; ++i)
    scene.add({.shapes = {box(1, 1)}, .position = {tower_at, 0.5 + i}, .mass = 1, .friction = friction});
}

/// Level at first; its links do not touch each other.
void add_chain(Scene& scene, int links) {
  const double height = 1 + link * links;
  BodyId above = ground;
  for (int i = 0; i < links; ++i) {
    const BodyId body = scene.add({.shapes = {box(link, 0.2)},
                                   .position = {chain_at + (i + 0.5) * link, height},
                                   .mass = 1,
                                   .collides_with = 0});
    scene.join<RevoluteJoint>({.a = above, .b = body, .anchor = {chain_at + i * link, height}});
    above = body;
  }
}

/// Remembers the scale of R_E, which needs the velocities before the warm start.
class ScaleObserver final : public SolveObserver<double> {
 public:
  void before_solve(const VelocityProblem<double>& problem) override { scale_ = residual_scale(problem); }
  double scale() const { return scale_; }

 private:
  double scale_ = 0;
};

/// One scene of a run: the whole, or one of its islands.
struct Stage {
  World<double> world;
  SequentialImpulse<double> solver;
};

std::vector<Stage> stages_of(const NeedsSettings& settings, const Switches& switches, double tolerance) {
  using enum Thing;
  const std::vector<std::vector<Thing>> split = {{pyramid_and_ball}, {tower}, {chain}};
  const std::vector<std::vector<Thing>> whole = {{pyramid_and_ball, tower, chain}};
  std::vector<Stage> stages;
  for (const std::vector<Thing>& things : switches.by_island ? split : whole) {
    stages.push_back({World<double>(scene_of(settings, switches, things)),
                      SequentialImpulse<double>({.iterations = settings.sweeps, .tolerance = tolerance})});
  }
  return stages;
}

/// All stages as one world.
Snapshot together(const std::vector<Stage>& stages) {
  Snapshot all = snapshot(stages[0].world);
  for (std::size_t i = 1; i < stages.size(); ++i) {
    const Snapshot part = snapshot(stages[i].world);
    all.bodies.insert(all.bodies.end(), part.bodies.begin() + 1, part.bodies.end());
  }
  return all;
}

StepBill step_all(std::vector<Stage>& stages) {
  StepBill bill;
  for (Stage& stage : stages) {
    ScaleObserver observer;
    const StepReport report = stage.world.step(stage.solver, &observer);
    bill.rows += report.rows;
    bill.awake += report.awake.bodies;
    if (report.rows == 0) continue;
    bill.sweeps = std::max(bill.sweeps, report.sweeps);
    bill.updates += static_cast<long long>(report.rows) * report.sweeps;
    if (report.solve.converged) {
      const Residual<double> left = residual(stage.world.last_step().problem, observer.scale());
      bill.residual = std::max(bill.residual, left.energy);
    }
  }
  return bill;
}

BillRun run_one(const NeedsSettings& settings, const Switches& switches, double tolerance) {
  std::vector<Stage> stages = stages_of(settings, switches, tolerance);
  BillRun run{.switches = switches, .frames = {together(stages)}};
  for (int k = 1; k <= settings.steps; ++k) {
    const auto start = std::chrono::steady_clock::now();
    run.steps.push_back(step_all(stages));
    run.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    run.updates += run.steps.back().updates;
    run.frames.push_back(together(stages));
  }
  return run;
}

bool touches(const Snapshot& now, BodyId ball) {
  return std::any_of(now.contacts.begin(), now.contacts.end(), [ball](const SnapshotContact& contact) {
    return (contact.a == ball && contact.b != ground) || (contact.b == ball && contact.a != ground);
  });
}

}  // namespace

std::vector<Switches> all_switches() {
  return {
      {.name = "everything", .what = "every row, every sweep"},
      {.name = "shared friction",
       .what = "one friction row a manifold",
       .friction_rows = FrictionRows::per_manifold},
      {.name = "no friction", .what = "and none at all", .friction = 0},
      {.name = "early exit", .what = "sweeps end at R_E", .ends_early = true},
      {.name = "exit by island", .what = "each island ends by itself", .ends_early = true, .by_island = true},
      {.name = "sleep", .what = "islands at rest are left out", .sleeps = true},
      {.name = "together",
       .what = "all of them but no friction",
       .friction_rows = FrictionRows::per_manifold,
       .ends_early = true,
       .by_island = true,
       .sleeps = true}};
}

Group group_of(const NeedsSettings& settings, std::size_t body) {
  const int index = static_cast<int>(body);
  if (index < 1 || index == pyramid_boxes + 1) return Group::loose;
  if (index <= pyramid_boxes) return Group::pyramid;
  return index <= pyramid_boxes + 1 + settings.tower ? Group::tower : Group::chain;
}

BodyId ball_of(const NeedsSettings&) { return {pyramid_boxes + 1}; }

Scene scene_of(const NeedsSettings& settings, const Switches& switches, const std::vector<Thing>& things) {
  SceneSettings rules{.gravity = {0, -10}, .dt = time_step, .friction_rows = switches.friction_rows};
  if (switches.sleeps) rules.sleeping = Sleeping{};
  Scene scene(rules);
  scene.add_ground({.friction = switches.friction});
  for (const Thing thing : things) {
    if (thing == Thing::pyramid_and_ball) add_pyramid(scene, switches.friction);
    if (thing == Thing::tower) add_tower(scene, settings.tower, switches.friction);
    if (thing == Thing::chain) add_chain(scene, settings.links);
  }
  return scene;
}

double largest_distance(const std::vector<Snapshot>& first, const std::vector<Snapshot>& second,
                        std::size_t from, std::size_t last) {
  double largest = 0;
  for (std::size_t k = from; k <= last; ++k) {
    for (std::size_t i = 1; i < first[k].bodies.size(); ++i) {
      const Vec2<double> gap = first[k].bodies[i].pose.position - second[k].bodies[i].pose.position;
      largest = std::max(largest, gap.norm());
    }
  }
  return largest;
}

int rows_by_formula(const NeedsSettings& settings, const Switches& switches) {
  const int manifolds = base * base + settings.tower;
  int rows = 2 * manifolds;  // normals
  if (switches.friction > 0) {
    const bool shared = switches.friction_rows == FrictionRows::per_manifold;
    rows += shared ? manifolds : 2 * manifolds;
  }
  return rows + 2 * settings.links;
}

NeedsRun run_bills(const NeedsSettings& settings) {
  NeedsRun all{.settings = settings};
  NeedsSettings thorough = settings;
  thorough.sweeps = 2000;
  const std::vector<Switches> switches = all_switches();
  all.reference = run_one(thorough, switches[by_islands], reference_tolerance);
  for (std::size_t k = 1; k < all.reference.frames.size() && all.touch == 0; ++k) {
    if (touches(all.reference.frames[k], ball_of(settings))) all.touch = static_cast<int>(k);
  }
  const auto last = static_cast<std::size_t>(settings.steps);
  const BillRun alone = run_one(settings, {.by_island = true}, 0);
  const std::size_t before = all.touch > 0 ? static_cast<std::size_t>(all.touch) - 1 : last;
  for (const Switches& each : switches) {
    BillRun run = run_one(settings, each, each.ends_early ? settings.tolerance : 0);
    run.off_before = largest_distance(run.frames, all.reference.frames, 1, before);
    run.off_after = largest_distance(run.frames, all.reference.frames, before, last);
    all.runs.push_back(run);
  }
  all.alone = largest_distance(alone.frames, all.runs[everything].frames, 1, last);
  return all;
}

}  // namespace cairn::needs
