// The scene, the three engines, and a fourth account of it by hand.
#include "tower.hpp"

#include <algorithm>
#include <cmath>

#include "lessons/lesson.hpp"
#ifdef CAIRN_HAVE_BOX2D
#include "reference/box2d_world.hpp"
#endif

namespace cairn::tower {

namespace {

std::vector<double> loads_of(const Snapshot& snapshot, const TowerSettings& settings) {
  std::vector<double> loads;
  for (int i = 1; i <= settings.boxes; ++i) {
    loads.push_back(normal_impulse_between(snapshot, BodyId{i - 1}, BodyId{i}) / settings.dt);
  }
  return loads;
}

void record(EngineRun& run, const Snapshot& snapshot, const TowerSettings& settings) {
  run.loads.push_back(loads_of(snapshot, settings));
  run.frames.push_back(snapshot);
}

EngineRun run_cairn(const TowerSettings& settings, Solver<double>& solver) {
  World world(tower_scene(settings));
  EngineRun run{.name = solver.name()};
  record(run, snapshot(world), settings);
  for (int k = 0; k < settings.steps; ++k) {
    if (world.step(solver).not_finite)
      throw Diverged("lesson17: the tower under " + solver.name() + " blew up");
    record(run, snapshot(world), settings);
  }
  return run;
}

}  // namespace

Scene tower_scene(const TowerSettings& settings) {
  Scene scene({.gravity = {0, -settings.gravity},
               .dt = settings.dt,
               .stabilization = {.baumgarte = 0},  // Box2D has no such term in its velocities
               .warm_start = settings.warm_start});
  scene.add_ground({.friction = 0.6});
  for (int i = 0; i < settings.boxes; ++i) {
    scene.add({.shapes = {box(1, 1)},
               .position = {0, 0.5 + i},
               .mass = 1,
               .friction = 0.6,
               .fixed_rotation = true});
  }
  return scene;
}

EngineRun run_pgs(const TowerSettings& settings) {
  ProjectedGaussSeidel solver({.iterations = settings.sweeps});
  return run_cairn(settings, solver);
}

EngineRun run_si(const TowerSettings& settings) {
  SequentialImpulse solver({.iterations = settings.sweeps});
  return run_cairn(settings, solver);
}

#ifdef CAIRN_HAVE_BOX2D

EngineRun run_box2d(const TowerSettings& settings) {
  Box2DWorld world(tower_scene(settings), {.velocity_iterations = settings.sweeps});
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

EngineRun run_box2d(const TowerSettings&) {
  throw Skipped("lesson17 compares with Box2D, and this build has none: apt-get install libbox2d-dev");
}

int box2d_falls_asleep(const TowerSettings&, int) { return -1; }

#endif

std::vector<std::vector<double>> loads_by_hand(const TowerSettings& settings) {
  const auto n = static_cast<std::size_t>(settings.boxes);
  std::vector<double> v(n + 1, 0.0);        // [m/s] of each box; v[0]: the ground
  std::vector<double> impulse(n + 1, 0.0);  // [N s] between box i and the one below
  const auto push = [&](std::size_t i, double p) {
    v[i] += p;
    if (i > 1) v[i - 1] -= p;
  };
  std::vector<std::vector<double>> loads(1, std::vector<double>(n, 0.0));
  for (int k = 0; k < settings.steps; ++k) {
    for (std::size_t i = 1; i <= n; ++i) v[i] -= settings.gravity * settings.dt;
    for (std::size_t i = 1; i <= n; ++i) {
      if (!settings.warm_start) impulse[i] = 0;
      push(i, impulse[i]);
    }
    for (int sweep = 0; sweep < settings.sweeps; ++sweep) {
      for (std::size_t i = 1; i <= n; ++i) {
        const double corrective = (v[i - 1] - v[i]) / (i > 1 ? 2 : 1);  // eq (22), masses of 1 kg
        const double sum = std::max(impulse[i] + corrective, 0.0);
        push(i, sum - impulse[i]);
        impulse[i] = sum;
      }
    }
    std::vector<double>& load = loads.emplace_back();
    for (std::size_t i = 1; i <= n; ++i) load.push_back(impulse[i] / settings.dt);
  }
  return loads;
}

double largest_gap(const std::vector<std::vector<double>>& first,
                   const std::vector<std::vector<double>>& second, int frames) {
  double largest = 0;
  for (std::size_t k = 1; k <= static_cast<std::size_t>(frames) && k < first.size(); ++k) {
    for (std::size_t i = 0; i < first[k].size(); ++i) {
      largest = std::max(largest, std::abs(first[k][i] - second[k][i]));
    }
  }
  return largest;
}

}  // namespace cairn::tower
