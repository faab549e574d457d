// A rope round a post: how much more than the other side one side of it can hold (L. Euler, 1769).
#include "constraints/distance_joint.hpp"
#include "geometry/shape.hpp"
#include "problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double rope_friction = 0.3;
const double light_weight = 1;                     // [kg]
const double bead_mass = 0.5;                      // [kg]
const double post_radius = 1, bead_radius = 0.05;  // [m], in a world

/// The solvers of the paper.
std::vector<SolverMaker<double>> capstan_solvers() {
  return {maker<SequentialImpulse<double>, double>(), maker<ProjectedGaussSeidel<double>, double>()};
}

/// The ratio of tensions up to which friction holds a rope that bends by pi in n equal corners. At each one
/// the pulls T and T' press with (T + T') sin(h), h half the corner, and pull along with (T' - T) cos(h).
double capstan_ratio(int n) {
  const double bend = rope_friction * std::tan(pi / (2 * n));
  return std::pow((1 + bend) / (1 - bend), n);
}

/// The direction from the post's middle to bead i of n, counted from the right.
Vec2<double> bead_direction(int i, int n) {
  const double angle = (i + 0.5) * pi / n;
  return {std::cos(angle), std::sin(angle)};
}

/// The rod along u from a to b: it keeps their distance.
ConstraintRow<double> rod_row(BodyId a, BodyId b, const Vec2<double>& u) {
  ConstraintRow<double> row;
  row.a = a;
  row.b = b;
  row.jacobian_a = {-u.x(), -u.y(), 0};
  row.jacobian_b = {u.x(), u.y(), 0};
  return row;
}

/// n beads without weight on a round post, tied to each other by rods; from the first one hangs a weight of
/// `ratio` times that on the last one. All has fallen for one step from rest. Points: nothing turns.
VelocityProblem<double> rope_round_post(int n, double ratio) {
  VelocityProblem<double> problem = empty_problem<double>();
  const double fall = test_gravity * test_dt;
  const BodyId heavy = add_body<double>(problem, ratio * light_weight, 1, {0, -fall, 0});
  BodyId last = heavy;
  for (int i = 0; i < n; ++i) {
    const BodyId bead = add_body<double>(problem, bead_mass, 1, {0, 0, 0});
    const Vec2<double> out = bead_direction(i, n);
    const Vec2<double> way = i == 0 ? Vec2<double>(0, 1) : (out - bead_direction(i - 1, n)).normalized();
    add_row(problem, rod_row(last, bead, way));
    ConstraintRow<double> normal;
    normal.b = bead;
    normal.jacobian_b = {out.x(), out.y(), 0};
    normal.bounds = Bounds<double>::unilateral();
    const int place = add_row(problem, normal);
    ConstraintRow<double> friction = normal;
    friction.jacobian_b = {out.y(), -out.x(), 0};
    friction.bounds = Bounds<double>::coulomb(rope_friction, place);
    add_row(problem, friction);
    last = bead;
  }
  const BodyId light = add_body<double>(problem, light_weight, 1, {0, -fall, 0});
  add_row(problem, rod_row(last, light, {0, -1}));
  return problem;
}

/// The speed of the heavy weight after one step from rest, as a share of g dt.
double slip(const SolverMaker<double>& make, int n, double ratio) {
  VelocityProblem<double> problem = rope_round_post(n, ratio);
  // n + 2 points on a straight line cost 0.93 (n + 2)^2 sweeps a digit. Sharp corners and friction cost up to
  // three times as many; enough for 14 digits.
  make({.iterations = 40 * (n + 2) * (n + 2)})->solve(problem);
  return -problem.velocity[1].y() / (test_gravity * test_dt);
}

/// The same by the laws of motion, where the rope slips. All beads have one speed u along the post, and the
/// weights u cos(h), as the rods are at h to the tangents. The push T' - T at a bead, from T on the heavy
/// side:
///   bead m u / dt = (T - T') cos(h) - mu (T + T') sin(h)
/// T' is linear in u, and so is what the light weight asks for at the other end, T' = m (g + u cos(h) / dt).
double expected_slip(int n, double ratio) {
  const double h = pi / (2 * n), c = std::cos(h), s = std::sin(h);
  // Tensions are constant + slope * u, for g = dt = 1.
  double constant = ratio * light_weight, slope = -ratio * light_weight * c;
  for (int i = 0; i < n; ++i) {
    constant = constant * (c - rope_friction * s) / (c + rope_friction * s);
    slope = (slope * (c - rope_friction * s) - bead_mass) / (c + rope_friction * s);
  }
  const double u = (constant - light_weight) / (light_weight * c - slope);
  return u * c;
}

/// A rope of n discs on a round post in a world, from rest.
World<double> world_with_rope(int n, double ratio) {
  const double reach = post_radius + bead_radius;
  Scene scene({.stabilization = {.slop = 1e-4}});
  scene.add({.type = BodyType::static_body, .shapes = {circle(post_radius)}, .friction = rope_friction});
  const auto hang = [&](double x, double mass) {
    return scene.add({.shapes = {circle(bead_radius)}, .position = {x, -2}, .mass = mass});
  };
  const auto tie = [&](BodyId a, const Vec2<double>& from, BodyId b, const Vec2<double>& to) {
    scene.join<DistanceJoint>({.a = a, .b = b, .anchor_a = from, .anchor_b = to});
  };
  Vec2<double> place(reach * bead_direction(0, n).x(), -2);
  BodyId last = hang(place.x(), ratio * light_weight);
  for (int i = 0; i < n; ++i) {
    const Vec2<double> next_place = reach * bead_direction(i, n);
    const BodyId next = scene.add({.shapes = {circle(bead_radius)},
                                   .position = next_place,
                                   .mass = bead_mass,
                                   .friction = rope_friction,
                                   .gravity_scale = 0,
                                   .fixed_rotation = true});
    tie(last, place, next, next_place);
    last = next;
    place = next_place;
  }
  const Vec2<double> end(-reach * bead_direction(0, n).x(), -2);
  tie(last, place, hang(end.x(), light_weight), end);
  return World(scene);
}

}  // namespace

// B32
TEST_CASE(
    "a rope with n corners round a post holds ((1 + mu tan h) / (1 - mu tan h))^n times the other pull") {
  for (const int n : {3, 6, 12}) {
    const double ratio = capstan_ratio(n);
    for (const SolverMaker<double>& make : capstan_solvers()) {
      CAPTURE(n);
      CHECK(std::abs(slip(make, n, 0.9999 * ratio)) <= 1e-10);
      CHECK(slip(make, n, 1.0001 * ratio) >= 0.9 * expected_slip(n, 1.0001 * ratio));
    }
  }
  // e^(mu pi) in the limit; tan(h) = h + h^3 / 3 and atanh(x) = x + x^3 / 3 add mu (1 + mu^2) pi^3 / 12 n^2.
  const double limit = std::exp(rope_friction * pi);
  const double excess = rope_friction * (1 + rope_friction * rope_friction) * pi * pi * pi / (12 * 24 * 24);
  CHECK(capstan_ratio(24) / limit - 1 == doctest::Approx(excess).epsilon(0.01));
}

// B32
TEST_CASE("a rope that slips round a post speeds up as the laws of motion say") {
  for (const int n : {3, 6, 12}) {
    for (const double overload : {1.01, 2.0}) {
      const double ratio = overload * capstan_ratio(n);
      for (const SolverMaker<double>& make : capstan_solvers()) {
        CHECK(slip(make, n, ratio) == doctest::Approx(expected_slip(n, ratio)).epsilon(1e-9));
      }
    }
  }
}

// B32
TEST_CASE("in a world a rope with six corners stays at 3 % less than its limit, and slips at 3 % more") {
  const int n = 6;
  for (const double overload : {-0.03, 0.03}) {
    const double ratio = (1 + overload) * capstan_ratio(n);
    World world = world_with_rope(n, ratio);
    SequentialImpulse<double> solver({.iterations = 300});
    const double start = world.bodies().pose[2].position.y();
    run(world, solver, 0.25);
    const double way = start - world.bodies().pose[2].position.y();
    if (overload < 0) {
      CHECK(std::abs(way) <= 1e-6);  // 300 sweeps are not enough for the first steps
      continue;
    }
    const double a = expected_slip(n, ratio) * test_gravity;
    const double expected = a * world.time() * (world.time() + world.dt()) / 2;
    // The beads go round by the way over the radius, 2.5 mrad, while the weights still hang straight down.
    // Each of the two last rods pulls by sin(h) of that angle more than at first, which adds to the overload.
    const double turned = expected / (post_radius + bead_radius);
    CHECK(way == doctest::Approx(expected).epsilon(2 * std::sin(pi / (2 * n)) * turned / overload));
  }
}
