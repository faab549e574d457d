// What the guards of a step cost: the check for numbers that are not finite, and the watch over warm starts.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "cairn.hpp"
#include "measure.hpp"
#include "table.hpp"
#include "tables.hpp"

namespace cairn::bench {

namespace {

/// Towers of ten boxes side by side, or the same boxes in flight, where nothing touches.
Scene guarded_scene(int bodies, bool touching, bool watches) {
  Scene scene({.guarded = watches});
  scene.add_ground({.half_width = bodies + 10.0});
  for (int i = 0; i < bodies; ++i) {
    const int tower = i / 10, level = i % 10;
    const double height = touching ? 0.5 + level : 1e4 + 2 * level;
    scene.add({.shapes = {box(1, 1)}, .position = {2.0 * tower - bodies / 10.0, height}});
  }
  return scene;
}

/// A copy of World::first_not_finite(), which is private: the sum in place of the state it would lead to.
int first_not_finite(const BodyState<double>& bodies, const PerBody<Vec3<double>>& moving, double dt) {
  for (const BodyId body : bodies.pose.indices()) {
    const Pose<double>& pose = bodies.pose[body];
    const Vec3<double>& v = moving[body];
    const bool finite = std::isfinite(pose.position.x() + dt * v.x()) &&
                        std::isfinite(pose.position.y() + dt * v.y()) &&
                        std::isfinite(pose.angle + dt * v.z()) && bodies.velocity[body].allFinite();
    if (!finite) return body.index;
  }
  return bodies.pose.size();
}

World<double> settled(const Scene& scene) {
  World<double> world(scene);
  SequentialImpulse<double> solver;
  for (int step = 0; step < 20; ++step) world.step(solver);
  return world;
}

/// Ten steps that always begin where the first twenty ended.
class Steps {
 public:
  explicit Steps(const Scene& scene) : start_(settled(scene)), world_(start_) {}

  /// Of one step [s].
  double seconds() {
    world_ = start_;
    const Stopwatch stopwatch;
    for (int step = 0; step < 10; ++step) world_.step(solver_);
    return stopwatch.seconds() / 10;
  }
  /// Of one check [s].
  double check_seconds() const {
    const BodyState<double>& bodies = world_.bodies();
    const int turns = 10000 / bodies.pose.size() + 1;
    const Stopwatch stopwatch;
    for (int turn = 0; turn < turns; ++turn) {
      int found = first_not_finite(bodies, bodies.velocity, world_.dt());
      benchmark::DoNotOptimize(found);
      benchmark::ClobberMemory();
    }
    return stopwatch.seconds() / turns;
  }

 private:
  World<double> start_, world_;
  SequentialImpulse<double> solver_{{.iterations = 10}};
};

/// What is compared is timed in turns, so that what disturbs the machine disturbs all of it.
Case guard_case(int bodies, bool touching) {
  const auto plain = std::make_shared<Steps>(guarded_scene(bodies, touching, false));
  const auto watched = std::make_shared<Steps>(guarded_scene(bodies, touching, true));
  watched->seconds();
  plain->seconds();  // all memory is touched now
  const double pilot = plain->seconds();
  const auto run = [plain, watched](benchmark::State& state) {
    double step = 0, check = 0, with_watch = 0;
    for (auto _ : state) {
      const double seconds = plain->seconds();
      state.SetIterationTime(seconds);
      step += seconds;
      check += plain->check_seconds();
      with_watch += watched->seconds();
    }
    state.counters["check"] = check / static_cast<double>(state.iterations());
    state.counters["share"] = check / step;
    state.counters["watched"] = with_watch / step;
  };
  return {.name = "guards", .run = run, .iterations = iterations_for(20 * pilot), .repetitions = 31};
}

void add_guard_row(TextTable& table, int bodies, bool touching) {
  const Outcome outcome = measure({guard_case(bodies, touching)}).at("guards");
  table.add({fmt::format("{} {}", bodies, touching ? "in towers of ten" : "in flight"),
             three_digits(outcome.time.median / 1000), noise_cell(outcome.time),
             three_digits(outcome.counters.at("check") * 1e9 / (bodies + 1)),
             fmt::format("{:.2f} %", 100 * outcome.counters.at("share")),
             three_digits(outcome.counters.at("watched"))});
}

}  // namespace

void print_guard_table() {
  print_heading("9. Guards: what it costs that a step is safe");
  fmt::print(
      "Every substep asks of every body, before it moves, whether its new position and its new velocity are\n"
      "finite numbers; that cannot be switched off, so a copy of the check is timed beside the whole step\n"
      "(SequentialImpulse, 10 sweeps) that has it in it. Where a scene asks for it, failed solves are "
      "caught:\n"
      "one more pass over the rows before the solve, and one behind it. The three are timed in turns: ratios "
      "are medians of "
      "31.\n\n");
  TextTable table({{"boxes", ""},
                   {"step", "us"},
                   {"noise", ""},
                   {"finite check", "ns/body"},
                   {"share", "of the step"},
                   {"guarded", "to the step"}});
  for (const bool touching : {false, true}) {
    for (const int bodies : {10, 1000}) add_guard_row(table, bodies, touching);
  }
  fmt::print("{}\n", table.text());
}

}  // namespace cairn::bench
