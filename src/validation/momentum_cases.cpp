// Floor 8. Momentum of bodies that only have each other, and discs that pass it on along a line.
#include <fmt/format.h>

#include <random>
#include <stdexcept>

#include <cairn/geometry/shape.hpp>
#include <cairn/measure/energy.hpp>
#include <cairn/solvers/iterative/sequential_impulse.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/worst.hpp>
#include <cairn/world/world.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double drum_radius = 3;  // [m] of its inner side
const int drum_discs = 20;

/// The wall of a drum: 12 planks around the origin.
List<Shape<double>> drum_wall() {
  const int planks = 12;
  const double length = 2 * (drum_radius + 0.5) * std::tan(pi / planks);
  List<Shape<double>> shapes;
  for (int i = 0; i < planks; ++i) {
    const double angle = 2 * pi * i / planks;
    const Vec2<double> middle = (drum_radius + 0.25) * Vec2<double>(std::cos(angle), std::sin(angle));
    shapes.push_back(moved(box(0.5, length), middle, angle));
  }
  return shapes;
}

/// 20 elastic, rough discs that fly about in a drum, which floats freely itself, so that they never stop
/// hitting each other. Masses and inertias are powers of two: then 1 / m is exact in every number type, and
/// nothing but the rounding of sums can change a momentum.
Scene discs_in_drum() {
  Scene scene({.gravity = {0, 0}});
  scene.add(
      {.shapes = drum_wall(), .mass = 16, .inertia = 128, .material = {.friction = 0.5, .restitution = 1}});
  std::mt19937 random(20);
  const auto uniform = [&random] { return static_cast<double>(random()) / 4294967296.0; };  // in [0, 1)
  for (int i = 0; i < drum_discs; ++i) {
    const Vec2<double> place(-1.6 + 0.8 * (i % 5), -1.2 + 0.8 * (i / 5));
    const double u = 4 * uniform() - 1, v = 4 * uniform() - 2;
    scene.add({.shapes = {circle(0.25)},
               .position = place,
               .velocity = {u, v},
               .angular_velocity = 4 * uniform(),
               .mass = i % 2 == 0 ? 1.0 : 0.5,
               .inertia = 1.0 / 32,
               .material = {.friction = 0.5, .restitution = 1}});
  }
  return scene;
}

/// What momenta are made of, each with its size: sum m |v| and sum (m |x| |v| + I |w|).
Vec3<double> momentum_scale(const Snapshot& snapshot) {
  Vec3<double> sum = Vec3<double>::Zero();
  for (const SnapshotBody& body : snapshot.bodies) {
    const double p = body.mass * body.velocity.head<2>().norm();
    const double spin = body.inertia * std::abs(body.velocity.z());
    sum += Vec3<double>(p, p, body.pose.position.norm() * p + spin);
  }
  return sum;
}

struct DrumRun {
  Vec3<double> start = {0, 0, 0};   // [N s, N s, N m s]
  Vec3<double> change = {0, 0, 0};  // as shares of the scale
  double updates = 0;               // of rows
  int late_contacts = 0;            // in the last tenth of the steps
};

template <Scalar Real>
DrumRun run_drum(int steps) {
  World<Real> world(discs_in_drum());
  SequentialImpulse<Real> solver({.iterations = 10});
  DrumRun run;
  run.start = momentum(snapshot(world));
  Vec3<double> scale = momentum_scale(snapshot(world));
  if (run.start.cwiseAbs().minCoeff() < 0.01 * scale.maxCoeff()) {
    throw std::logic_error("run_drum: each momentum must be a hundredth of what it is made of, at least");
  }
  for (int step = 1; step <= steps; ++step) {
    const StepReport report = world.step(solver);
    run.updates += 10.0 * report.rows;
    if (step > steps * 9 / 10) run.late_contacts += report.contacts;
    if (step % 500 == 0) scale = scale.cwiseMax(momentum_scale(snapshot(world)));
  }
  if (run.late_contacts < 100) throw std::logic_error("run_drum: the discs must go on colliding");
  run.change = (momentum(snapshot(world)) - run.start).cwiseQuotient(scale);
  return run;
}

template <Scalar Real>
void add_drum_numbers(List<Measured>& numbers, const std::string& scalar, int steps) {
  const DrumRun run = run_drum<Real>(steps);
  const double epsilon = static_cast<double>(std::numeric_limits<Real>::epsilon());
  const auto add = [&](const std::string& what, double change) {
    numbers.push_back(
        measured(what + fmt::format(", lost in {} steps, in {}", steps, scalar), change)
            .zero_within(5 * 0.29 * std::sqrt(2 * run.updates) * epsilon,
                         "5 deviations of a sum of 0.29 epsilon for 2 bodies in every row update"));
  };
  add("momentum along x over sum m |v|", run.change.x());
  add("momentum along y over sum m |v|", run.change.y());
  add("angular momentum over sum m |x| |v| + I |w|", run.change.z());
}

// Newton's third law, row by row: j has equal and opposite parts, and equal moments about the origin.
ValidationResult floating_drum(const EngineMaker&) {
  ValidationResult result;
  add_drum_numbers<double>(result.numbers, "double", 10000);
  add_drum_numbers<float>(result.numbers, "float", 10000);
  return result;
}

const double cradle_speed = 2;  // [m/s] of the first disc

/// Discs of radius 0.2 m on a line with 0.3 m between them: more than any of them goes in a step. The first
/// comes, the others are at rest.
Scene cradle_with_gaps(const List<double>& masses) {
  Scene scene({.gravity = {0, 0}});
  double x = 0;
  for (const double mass : masses) {
    scene.add({.shapes = {circle(0.2)},
               .position = {x, 0},
               .velocity = {x > 0 ? 0.0 : cradle_speed, 0},
               .mass = mass,
               .material = {.restitution = 1}});
    x += 0.7;
  }
  return scene;
}

/// After any step, one disc has all of the speed: the largest deviation from that. And how many have had it.
Measured equal_cradle(const EngineMaker& make, int n) {
  const std::unique_ptr<Engine> cradle = make(cradle_with_gaps(List<double>(n, 1.0)), 5);
  int moving = 0;
  List<double> errors;
  for (int step = 0; step < 100; ++step) {  // each is hit 8 or 9 steps after the one before
    cradle->step();
    const PerBody<SnapshotBody> bodies = cradle->snapshot().bodies;
    if (moving + 1 < n && bodies[{moving + 1}].velocity.x() < cradle_speed / 2) ++moving;
    for (int i = 0; i < n; ++i) {
      errors.push_back(bodies[{i + 1}].velocity.x() - (i == moving ? cradle_speed : 0));
    }
  }
  errors.push_back(static_cast<double>(n - 1 - moving));  // it must come to the last one
  return measured(fmt::format("worst speed error of {} equal discs, in any of 100 steps", n),
                  farthest(0, errors), "m/s")
      .by("(0, .., v, .., 0)", 0)
      .within(1e-12, "rounding of 2 m/s in 5 sweeps a step");
}

// m on r m at rest, elastic: m keeps (1 - r)/(1 + r) of its speed, and r m takes 2/(1 + r) of it.
ValidationResult cradles(const EngineMaker& make) {
  ValidationResult result;
  for (const int n : {2, 3, 5, 8}) result.add(equal_cradle(make, n));
  const int n = 6;
  for (const double r : {0.5, 0.8}) {  // each disc has r times the mass of the one before
    List<double> masses;
    for (int i = 0; i < n; ++i) masses.push_back(std::pow(r, i));
    const Snapshot end = run_scene(make, cradle_with_gaps(masses), 5, 2);
    double speed = cradle_speed;
    for (int i = 1; i <= n; ++i) {
      const double expected = i < n ? speed * (1 - r) / (1 + r) : speed;
      result.add(measured(fmt::format("speed of disc {} of {}, each {} of the mass before it", i, n, r),
                          end.bodies[{i}].velocity.x(), "m/s")
                     .by(i < n ? "v (2/(1 + r))^(i-1) (1 - r)/(1 + r)" : "v (2/(1 + r))^(n-1)", expected)
                     .within(1e-12 * expected, "no error but rounding, in 5 sweeps a step"));
      speed *= 2 / (1 + r);
    }
  }
  return result;
}

}  // namespace

void add_momentum_cases(ValidationCases& cases) {
  cases.push_back({.id = "B2",
                   .title = "Twenty discs that collide in a floating drum keep their momenta",
                   .run = floating_drum});
  cases.push_back({.id = "B42",
                   .title = "Along a row of elastic discs with gaps one after the other takes the speed",
                   .asks = Asks::any_engine,
                   .run = cradles});
}

}  // namespace cairn
