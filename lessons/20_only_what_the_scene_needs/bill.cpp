// The scene, its parts, and what each switch makes of them.
#include "lesson.hpp"

namespace cairn::needs {

namespace {

const double pitch = 1.2;    // [m] from box to box in the pyramid
const double tower_at = 9;   // [m]
const double chain_at = 18;  // [m]
const double link = 0.8;     // [m]
const double friction = 0.6;

void add_pyramid(Scene& scene) {
  for (int row = 0; row < base; ++row) {
    for (int i = 0; i < base - row; ++i) {
      const double x = (i - 0.5 * (base - row - 1)) * pitch;
      scene.add(
          {.shapes = {box(1, 1)}, .position = {x, 0.5 + row}, .mass = 1, .material = {.friction = friction}});
    }
  }
  scene.add({.shapes = {circle(0.4)},
             .position = {-9, 1},
             .velocity = {4.5, 9},
             .mass = 0.5,
             .material = {.friction = friction}});
}

void add_tower(Scene& scene, int boxes) {
  for (int i = 0; i < boxes; ++i)
    scene.add({.shapes = {box(1, 1)},
               .position = {tower_at, 0.5 + i},
               .mass = 1,
               .material = {.friction = friction}});
}

/// Level at first; its links do not touch each other.
void add_chain(Scene& scene, int links) {
  const double height = 1 + link * links;
  BodyId above = ground;
  for (int i = 0; i < links; ++i) {
    const BodyId body = scene.add({.shapes = {box(link, 0.2)},
                                   .position = {chain_at + (i + 0.5) * link, height},
                                   .mass = 1,
                                   .filter = {.collides_with = 0}});
    scene.join<RevoluteJoint>({.a = above, .b = body, .anchor = {chain_at + i * link, height}});
    above = body;
  }
}

bool touches(const Snapshot& now, BodyId ball) {
  return std::any_of(now.contacts.begin(), now.contacts.end(), [ball](const SnapshotContact& contact) {
    return (contact.a == ball && contact.b != ground) || (contact.b == ball && contact.a != ground);
  });
}

}  // namespace

List<Switches> all_switches() {
  return {{.name = "everything"},
          {.name = "early exit", .ends_early = true},
          {.name = "exit by island", .ends_early = true, .by_island = true},
          {.name = "sleep", .by_island = true, .sleeps = true}};
}

Group group_of(const NeedsSettings& settings, BodyId body) {
  const int index = body.index;
  if (index < 1 || index == pyramid_boxes + 1) return Group::loose;
  if (index <= pyramid_boxes) return Group::pyramid;
  return index <= pyramid_boxes + 1 + settings.tower ? Group::tower : Group::chain;
}

BodyId ball_of(const NeedsSettings&) { return {pyramid_boxes + 1}; }

Scene scene_of(const NeedsSettings& settings, const Switches& switches, const List<Thing>& things) {
  SceneSettings rules{
      .gravity = {0, -10}, .dt = time_step, .stabilization = {.policy = StabilizationPolicy::baumgarte}};
  if (switches.sleeps) rules.sleeping = Sleeping{};
  Scene scene(rules);
  scene.add_ground({.material = {.friction = friction}});
  for (const Thing thing : things) {
    if (thing == Thing::pyramid_and_ball) add_pyramid(scene);
    if (thing == Thing::tower) add_tower(scene, settings.tower);
    if (thing == Thing::chain) add_chain(scene, settings.links);
  }
  return scene;
}

double largest_distance(const List<Snapshot>& first, const List<Snapshot>& second, int from, int last,
                        int bodies) {
  double largest = 0;
  for (int k = from; k <= last; ++k) {
    for (BodyId body{1}; body.index <= bodies; ++body.index) {
      const Vec2<double> gap = first[k].bodies[body].pose.position - second[k].bodies[body].pose.position;
      largest = std::max(largest, gap.norm());
    }
  }
  return largest;
}

int rows_by_formula(const NeedsSettings& settings) {
  const int manifolds = base * base + settings.tower;
  return 4 * manifolds + 2 * settings.links;
}

StageMean mean_of(const BillRun& run, int stage) {
  StageMean mean;
  for (const StepBill& bill : run.steps) {
    mean.sweeps += 1.0 * bill.stages[stage].sweeps / run.steps.size();
    mean.updates += 1.0 * bill.stages[stage].rows * bill.stages[stage].sweeps / run.steps.size();
  }
  return mean;
}

int least_rows(const BillRun& run) {
  int least = run.steps[0].rows;
  for (const StepBill& bill : run.steps) least = std::min(least, bill.rows);
  return least;
}

List<Stage> stages_of(const NeedsSettings& settings, const Switches& switches, double tolerance) {
  using enum Thing;
  List<Stage> stages;
  // [islands]
  const List<List<Thing>> split = {{pyramid_and_ball}, {tower}, {chain}};
  const List<List<Thing>> whole = {{pyramid_and_ball, tower, chain}};
  for (const List<Thing>& things : switches.by_island ? split : whole) {
    stages.push_back({World<double>(scene_of(settings, switches, things)),
                      SequentialImpulse<double>({.iterations = settings.sweeps, .tolerance = tolerance})});
  }
  // [/islands]
  return stages;
}

Snapshot together(const List<Stage>& stages) {
  Snapshot all = snapshot(stages[0].world);
  for (int i = 1; i < stages.size(); ++i) {
    const Snapshot part = snapshot(stages[i].world);
    all.bodies.insert(all.bodies.end(), part.bodies.begin() + 1, part.bodies.end());
  }
  return all;
}

double residual_left(const Stage& stage) {
  return residual(stage.world.last_step().problem, stage.scale.scale()).energy;
}

int first_touch(const List<Snapshot>& frames, BodyId ball) {
  for (int k = 1; k < frames.size(); ++k) {
    if (touches(frames[k], ball)) return k;
  }
  return 0;
}

}  // namespace cairn::needs
