// Floor 8. A silo, whose walls carry most of what stands between them: B37.
#include <cmath>
#include <cstdint>

#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/case_scenes.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double silo_width = 5;  // [m] between the walls
const double silo_friction = 0.5;
const double silo_sinking = 0.1;  // [m/s] of the floor

struct SiloLoad {
  double height = 0;  // [m] of the filling, were it spread evenly
  double weight = 0;  // [N] of all discs
  double floor = 0;   // [N] that the floor carries
};

/// The mean of the last of 4 s, over fillings of the seeds 1, 2, ...
SiloLoad silo_load(const EngineMaker& make, int rows, double wall_friction, int fillings) {
  SiloLoad mean;
  for (int seed = 1; seed <= fillings; ++seed) {
    // Its floor sinks slowly, so that the discs rub on the walls everywhere.
    const Silo made = silo_before_settling({.rows = rows,
                                            .width = silo_width,
                                            .friction = silo_friction,
                                            .wall_friction = wall_friction,
                                            .floor_velocity = -silo_sinking,
                                            .seed = static_cast<std::uint64_t>(seed)});
    Motion motion(make, made.scene, 20);
    motion.run(3);
    for (int step = 0; step < 120; ++step) {
      motion.step();
      for (const SnapshotContact& contact : motion.now().contacts) {
        if (contact.a != made.floor && contact.b != made.floor) continue;
        mean.floor += contact.normal_impulse / motion.dt() / 120 / fillings;
      }
    }
    mean.height += made.weight / standard_gravity / silo_width / fillings;
    mean.weight += made.weight / fillings;
  }
  return mean;
}

/// Janssen: the floor carries w W / (2 mu K) (1 - e^(-2 mu K H / W)) of the weight w per length.
double janssen_floor(const SiloLoad& load, double k) {
  const double depth = 2 * silo_friction * k / silo_width;
  return load.weight * (1 - std::exp(-depth * load.height)) / (depth * load.height);
}

ValidationResult janssen(const EngineMaker& make) {
  const SiloLoad smooth = silo_load(make, 8, 0, 1);
  const SiloLoad low = silo_load(make, 10, silo_friction, 2), high = silo_load(make, 20, silo_friction, 2);
  const double k = bisected({1e-6, 20}, 1e-9, [&high](double try_k) {
                     return janssen_floor(high, try_k) < high.floor;
                   }).middle();
  return {.numbers = {measured("load of the floor between smooth walls", smooth.floor, "N")
                          .by("W", smooth.weight)
                          .within_share(silo_sinking / standard_gravity,
                                        "the mean of 1 s lacks a change of momentum, of 0.1 m/s: 0.1/g"),
                      measured("stress on a rough wall over stress along it, K, of 20 rows", k)
                          .by("0.3 .. 1.2 for grains", 0.75)
                          .within(0.45, "what grains have; 20 sweeps, two fillings"),
                      measured("load of the floor under half of the filling, with that K", low.floor, "N")
                          .by("w W/(2 mu K) (1 - e^(-2 mu K H/W))", janssen_floor(low, k))
                          .within_share(0.25, "25 %: fillings differ, and theory leaves that open")}};
}

}  // namespace

void add_silo_cases(ValidationCases& cases) {
  cases.push_back({.id = "B37",
                   .title = "Between rough walls the load of a silo's floor saturates as Janssen says",
                   .source = "H. A. Janssen, 1895",
                   .asks = Asks::any_engine,
                   .run = janssen});
}

}  // namespace cairn
