// The scene, the loads of a snapshot, and Box2D.
#include "lesson.hpp"

#ifdef CAIRN_HAVE_BOX2D
#include <cairn/reference/box2d_world.hpp>
#endif

namespace cairn::tower {

namespace {

List<double> loads_of(const Snapshot& snapshot, const TowerSettings& settings) {
  List<double> loads;
  for (int i = 1; i <= settings.boxes; ++i) {
    loads.push_back(normal_impulse_between(snapshot, BodyId{i - 1}, BodyId{i}) / settings.dt);
  }
  return loads;
}

}  // namespace

void record(EngineRun& run, const Snapshot& snapshot, const TowerSettings& settings) {
  run.loads.push_back(loads_of(snapshot, settings));
  run.frames.push_back(snapshot);
}

Scene tower_scene(const TowerSettings& settings) {
  Scene scene({.gravity = {0, -settings.gravity},
               .dt = settings.dt,
               .stabilization = {.policy = StabilizationPolicy::baumgarte,
                                 .baumgarte = 0},  // Box2D has no such term in its velocities
               .warm_start = settings.warm_start});
  scene.add_ground({.material = {.friction = 0.6}});
  for (int i = 0; i < settings.boxes; ++i) {
    scene.add({.shapes = {box(1, 1)},
               .position = {0, 0.5 + i},
               .mass = 1,
               .material = {.friction = 0.6},
               .fixed_rotation = true});
  }
  return scene;
}

#ifdef CAIRN_HAVE_BOX2D

EngineRun run_box2d(const TowerSettings& settings, bool from_top) {
  using Creation = Box2DSettings::Creation;
  // [creation]
  const Box2DSettings foreign{.velocity_iterations = settings.sweeps,
                              .creation = from_top ? Creation::first_first : Creation::last_first};
  Box2DWorld world(tower_scene(settings), foreign);
  // [/creation]
  EngineRun run{.name = "Box2D 2.4.1"};
  record(run, world.snapshot(), settings);
  for (int k = 0; k < settings.steps; ++k) {
    world.step();
    record(run, world.snapshot(), settings);
  }
  return run;
}

int box2d_falls_asleep(const TowerSettings& settings, int limit) {
  Box2DWorld world(tower_scene(settings), {.velocity_iterations = settings.sweeps, .sleeping = true});
  for (int k = 1; k <= limit; ++k) {
    world.step();
    if (!world.is_awake(BodyId{1})) return k;
  }
  return -1;
}

#else

EngineRun run_box2d(const TowerSettings&, bool) {
  throw Skipped("lesson17 compares with Box2D, and this build has none: apt-get install libbox2d-dev");
}

int box2d_falls_asleep(const TowerSettings&, int) { return -1; }

#endif

double largest_gap(const Loads& first, const Loads& second, int frames) {
  double largest = 0;
  for (int k = 1; k <= frames && k < first.size(); ++k) {
    for (int i = 0; i < first[k].size(); ++i) {
      largest = std::max(largest, std::abs(first[k][i] - second[k][i]));
    }
  }
  return largest;
}

int steps_as_tower(const List<EngineRun>& runs) {
  const int steps = runs[0].frames.size() - 1;
  for (int k = 1; k <= steps; ++k) {
    for (const EngineRun& run : runs) {
      double below = -0.5;  // [m] where the ground would be if it were a box
      const PerBody<SnapshotBody>& bodies = run.frames[k].bodies;
      for (const BodyId body : bodies.indices()) {
        if (body == ground) continue;
        const double here = bodies[body].pose.position.y();
        if (here - below < 0.5) return k;
        below = here;
      }
    }
  }
  return steps;
}

double gap_to_box2d(const TowerRuns& runs) {
  return std::max(largest_gap(runs.warm[1].loads, runs.warm[2].loads, steps_as_tower(runs.warm)),
                  largest_gap(runs.cold[1].loads, runs.cold[2].loads, steps_as_tower(runs.cold)));
}

int middle_box(const TowerRuns& runs) { return (runs.settings.boxes - 1) / 2; }

double gap_of_orders(const TowerRuns& runs) {
  return largest_gap(runs.warm[1].loads, runs.from_top[1].loads, steps_as_tower(runs.from_top));
}

}  // namespace cairn::tower
