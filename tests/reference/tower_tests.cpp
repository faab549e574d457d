// The two engines' solvers, sweep for sweep: the loads inside a tower that has not converged yet.
#include "engines.hpp"
#include "testing.hpp"

namespace cairn::reference_tests {

namespace {

constexpr int boxes = 10;
constexpr double dt = 0.02;  // [s]

enum class Rotation { free, fixed };

/// Ten boxes of 1 kg, each touching the next one exactly.
Scene tower(Rotation rotation, bool warm_start) {
  Scene scene({.dt = dt, .stabilization = {.baumgarte = 0}, .warm_start = warm_start});
  scene.add_ground({.material = {.friction = 0.6}});
  for (int i = 0; i < boxes; ++i) {
    scene.add({.shapes = {box(1, 1)},
               .position = {0, 0.5 + i},
               .mass = 1,
               .material = {.friction = 0.6},
               .fixed_rotation = rotation == Rotation::fixed});
  }
  return scene;
}

/// The load [N] between box i and the one below it, or the ground for i = 1.
double load(const Snapshot& snapshot, int i) {
  return normal_impulse_between(snapshot, BodyId{i - 1}, BodyId{i}) / dt;
}

/// The largest difference of any of the loads 1 ... `interfaces` over 50 frames [N].
double largest_load_gap(Engines& engines, int interfaces) {
  double largest = 0;
  for (int frame = 0; frame < 50; ++frame) {
    engines.step();
    const Snapshot cairn = snapshot(engines.cairn);
    const Snapshot box2d = engines.box2d.snapshot();
    for (int i = 1; i <= interfaces; ++i)
      largest = std::max(largest, std::abs(load(cairn, i) - load(box2d, i)));
  }
  return largest;
}

/// Box2D rounds velocities of about 0.5 m/s to 3e-8 m/s: 1.5e-6 N for the row of two boxes of 1 kg. A sweep
/// takes cos^2(pi / 20) of an error over, so that those of about 41 sweeps of 10 rows add up, to 6e-4 N at
/// worst.
constexpr double load_tolerance = 1e-3;  // [N]

/// The same tower as masses on a line: velocity[i] and impulse[i] of mass i, and between it and the one
/// below. Velocities are solved by Gauss-Seidel from the ground up.
struct Line {
  List<double> velocity = List<double>(boxes + 1, 0.0);  // [m/s]; 0: the ground
  List<double> impulse = List<double>(boxes + 1, 0.0);   // [N s]

  void push(int i, double p) {
    velocity[i] += p;
    if (i > 1) velocity[i - 1] -= p;
    impulse[i] += p;
  }

  void step(bool warm_start) {
    const List<double> last = impulse;
    impulse.assign(boxes + 1, 0.0);
    for (int i = 1; i <= boxes; ++i) velocity[i] -= 10 * dt;
    for (int i = 1; i <= boxes && warm_start; ++i) push(i, last[i]);
    for (int sweep = 0; sweep < 10; ++sweep) {
      for (int i = 1; i <= boxes; ++i) {
        const double approach = velocity[i - 1] - velocity[i];
        push(i, std::max(approach / (i > 1 ? 2 : 1), -impulse[i]));
      }
    }
  }
};

// The tower carries 100 N in the end. Ten sweeps cannot know that in the first frame: its loads are those of
// the sweeps, and they agree only if both engines visit the same rows in the same order. Box2D then needs
//   - fixed rotation: the two rows of an interface are equal, and it solves the first alone, as good as both;
//   - bodies created from the top down, so that it walks from the ground up;
//   - no continuous collision, which would solve the ground's contact again after the sweeps.
// Cairn needs a speculative margin > 0, so that boxes that part by a hair keep their rows.

TEST_CASE("the loads of a tower agree with Box2D to 1e-3 N over 50 frames, warm and cold") {
  for (const bool warm_start : {true, false}) {
    CAPTURE(warm_start);
    Engines engines(tower(Rotation::fixed, warm_start));
    CHECK(largest_load_gap(engines, boxes) < load_tolerance);
  }
}

TEST_CASE("the loads of a tower are those of masses on a line, frame by frame, warm and cold") {
  for (const bool warm_start : {true, false}) {
    CAPTURE(warm_start);
    Engines engines(tower(Rotation::fixed, warm_start));
    Line line;
    for (int frame = 1; frame <= 50; ++frame) {
      CAPTURE(frame);
      engines.step();
      line.step(warm_start);
      const Snapshot cairn = snapshot(engines.cairn);
      for (int i = 1; i <= boxes; ++i) {
        // 41 sweeps of 10 rows, each rounding loads of up to 200 N.
        CHECK(std::abs(load(cairn, i) - line.impulse[i] / dt) < 410 * 200 * 2.2e-16);
      }
      CHECK(std::abs(load(engines.box2d.snapshot(), 1) - line.impulse[1] / dt) < load_tolerance);
    }
  }
}

TEST_CASE(
    "the load on the ground is the same whether a tower is solved from the ground up or from the top down") {
  for (const bool warm_start : {true, false}) {
    CAPTURE(warm_start);
    const Scene scene = tower(Rotation::fixed, warm_start);
    const Box2DSettings top_down = {.velocity_iterations = 10,
                                    .creation = Box2DSettings::Creation::first_first};
    Engines engines(scene, top_down);
    CHECK(largest_load_gap(engines, 1) < load_tolerance);
    Engines again(scene, top_down);
    CHECK(largest_load_gap(again, boxes) > 1);  // but not the loads further up
  }
}

TEST_CASE("where boxes can turn, Box2D solves the two points of an interface at once, and Cairn row by row") {
  Engines engines(tower(Rotation::free, true));
  Line line;
  for (int frame = 1; frame <= 5; ++frame) {
    CAPTURE(frame);
    engines.step();
    line.step(true);
    const double on_a_line = line.impulse[1] / dt;
    // Solved at once, the two points of a symmetric interface act like one that cannot turn.
    CHECK(std::abs(load(engines.box2d.snapshot(), 1) - on_a_line) < load_tolerance);
    // Solved one after the other, each turns the box and disturbs the other: ten sweeps come less far.
    CHECK(load(snapshot(engines.cairn), 1) < on_a_line - 1);
  }
}

}  // namespace

}  // namespace cairn::reference_tests
