// The exact methods against each other, and against sweeps, on random problems and on those of worlds.
#include <random>

#include "validation/problems.hpp"
#include <cairn/constraints/converted.hpp>
#include <cairn/samples/samples.hpp>
#include <cairn/solvers/exact/contact_modes.hpp>
#include <cairn/solvers/exact/newton.hpp>
#include <cairn/validation/case_scenes.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

/// Up to three bodies on, beside and above each other, with contacts at random places, some with friction,
/// some soft, and some joints.
VelocityProblem<double> random_contact_problem(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  VelocityProblem<double> problem = empty_problem<double>();
  const int bodies = 1 + static_cast<int>(random() % 3), contacts = 1 + static_cast<int>(random() % 3);
  for (int i = 0; i < bodies; ++i) {
    const double mass = std::pow(10, number(random)), inertia = mass * std::pow(3, number(random)) / 6;
    add_body<double>(problem, mass, inertia, {number(random), number(random) - 1, number(random)});
  }
  for (int c = 0; c < contacts; ++c) {
    const double angle = number(random) / 2;
    const Vec2<double> normal(std::sin(angle), std::cos(angle)), tangent = -perpendicular(normal);
    const Vec2<double> arm(number(random), -1 + number(random) / 2), arm_below(number(random), 1);
    const BodyId above = {1 + static_cast<int>(random() % static_cast<unsigned>(bodies))};
    ConstraintRow<double> row;
    row.b = above;
    row.a = {above.index - 1};
    row.jacobian_b = {normal.x(), normal.y(), cross(arm, normal)};
    row.jacobian_a = {-normal.x(), -normal.y(), -cross(arm_below, normal)};
    row.bounds = Bounds<double>::unilateral();
    row.bias = number(random) / 10;
    if (random() % 4 == 0) row.softness = 0.1;
    const int place = add_row(problem, row);
    if (random() % 3 == 0) continue;
    row.jacobian_b = {tangent.x(), tangent.y(), cross(arm, tangent)};
    row.jacobian_a = {-tangent.x(), -tangent.y(), -cross(arm_below, tangent)};
    row.bounds = Bounds<double>::coulomb(0.5 + number(random) / 2, place);
    row.bias = 0;
    row.softness = 0;
    add_row(problem, row);
  }
  if (random() % 2 == 0) {
    ConstraintRow<double> joint = vertical_row<double>({0}, {bodies}, Bounds<double>::equality());
    joint.jacobian_b.z() = number(random);
    if (random() % 2 == 0) joint.bounds = Bounds<double>::at_most(0.1);
    add_row(problem, joint);
  }
  return problem;
}

/// What the world hands to its solver after some steps, with nothing to start from.
VelocityProblem<double> cold_problem_after(const Scene& scene, int steps) {
  VelocityProblem<double> problem = problem_after(scene, steps);
  problem.impulse.assign(problem.row_count(), 0);
  return problem;
}

Scene box_pyramid(int base) { return samples::pyramid({.base = base, .pitch = 1.1}); }

Scene stone_arch(int stones) { return cases::masonry_arch({.stones = stones, .thickness = 0.12}); }

/// A chain of rods that hangs from the ground at an angle, with a heavy bob.
Scene chain_with_bob(int links, double bob) {
  Scene scene;
  const cases::ChainEnd end = cases::add_chain(scene, links, {0, 0});
  const BodyId ball = scene.add({.shapes = {circle(0.3)}, .position = end.place, .mass = bob});
  scene.join<RevoluteJoint>({.a = end.last, .b = ball, .anchor = end.place});
  return scene;
}

}  // namespace

TEST_CASE(
    "Lemke's method finds one of the listed solutions of hundreds of random problems, or there is none") {
  std::mt19937 random(11);
  int solved = 0, several = 0;
  for (int round = 0; round < 400; ++round) {
    const VelocityProblem<double> start = random_contact_problem(random);
    const ContactSolutions<double> all = all_contact_solutions(start);
    REQUIRE(all.complete);
    ReferenceSolver<double> solver({.max_modes = 0, .other_covers = 0});
    VelocityProblem<double> problem = start;
    const SolveReport report = solver.solve(problem);
    several += all.solutions.size() > 1 ? 1 : 0;
    for (const ContactSolution<double>& solution : all.solutions) CHECK(solution.residual <= 1e-14);
    CHECK(report.converged == !all.solutions.empty());
    if (!report.converged) continue;
    ++solved;
    double least = std::numeric_limits<double>::infinity();
    for (const ContactSolution<double>& solution : all.solutions) {
      least = std::min(least, largest_gap(problem.velocity, solution.velocity));
    }
    // Velocities up to 100 m/s and condition numbers up to 1e4, in long double; then they are rounded.
    CHECK(least <= 1e-12);
  }
  CHECK(solved > 380);
  CHECK(several > 0);
}

TEST_CASE("accelerated PGS, once converged, has the velocities of the exact answer where they are unique") {
  std::mt19937 random(13);
  int compared = 0;
  for (int round = 0; round < 100; ++round) {
    const VelocityProblem<double> start = random_contact_problem(random);
    VelocityProblem<double> exact = start, swept = start;
    ReferenceSolver<double> solver;
    const bool is_exact = solver.solve(exact).converged;
    AcceleratedProjectedGaussSeidel<double> sweeps({.iterations = 3000, .tolerance = 1e-13});
    const bool has_converged = sweeps.solve(swept).converged;
    if (!is_exact || !has_converged || solver.report().velocity.verdict != Uniqueness::unique) continue;
    ++compared;
    // |dv| is at most the condition number times R_E, which is 1e-13.
    CHECK(largest_gap(exact.velocity, swept.velocity) <= 1e-9);
  }
  CHECK(compared > 80);
}

TEST_CASE("the reference solver always gives the same bits, whatever the impulses to start from") {
  std::mt19937 random(17);
  for (int round = 0; round < 20; ++round) {
    const VelocityProblem<double> start = random_contact_problem(random);
    VelocityProblem<double> first = start, second = start;
    for (double& impulse : second.impulse) impulse = 0.3;
    ReferenceSolver<double>().solve(first);
    ReferenceSolver<double>().solve(second);
    CHECK(first.impulse == second.impulse);
    CHECK(first.velocity == second.velocity);
  }
}

TEST_CASE("pyramids and arches from worlds are solved by Lemke's method until R_E is at most 1e-12") {
  for (const Scene& scene : {box_pyramid(3), box_pyramid(4), stone_arch(9), stone_arch(13)}) {
    VelocityProblem<double> problem = cold_problem_after(scene, 3);
    const double scale = residual_scale(problem);
    ReferenceSolver<double> solver({.other_covers = 0});
    CHECK(solver.solve(problem).converged);
    CHECK(solver.report().method == ReferenceMethod::lemke);
    CHECK(solver.report().residual <= 1e-12);
    CHECK(residual(problem, scale).energy <= 1e-12);  // of what was returned
    // Two contacts and two frictions at three freedoms.
    CHECK(solver.report().impulse.verdict == Uniqueness::not_unique);
  }
}

TEST_CASE(
    "a chain with a bob of a million links' mass is solved alike by elimination and by Newton's method") {
  const VelocityProblem<double> start = cold_problem_after(chain_with_bob(10, 1e6), 1);
  VelocityProblem<double> direct = start, iterated = start;
  ReferenceSolver<double> solver;
  CHECK(solver.solve(direct).converged);
  CHECK(solver.report().impulse.verdict == Uniqueness::unique);
  ReferenceSolver<double> newton_solver({.max_rows = 0});
  CHECK(newton_solver.solve(iterated).converged);
  CHECK(newton_solver.report().method == ReferenceMethod::newton);
  CHECK(newton_solver.report().velocity.verdict == Uniqueness::unique);
  // R_E of 1e-12 at most, times a condition of 10^2 links and, by its root, the mass ratio.
  CHECK(largest_gap(direct.velocity, iterated.velocity) <= 1e-7);
}

TEST_CASE("Newton's method agrees with Lemke's at a hundred rows and more, without and with friction") {
  for (const double mu : {0.0, 0.5}) {
    Scene scene = chain_with_bob(50, 10);
    SceneSettings settings = scene.settings();  // the bob is deep in the ground: once out, there is an answer
    settings.stabilization.max_speed = std::numeric_limits<double>::infinity();
    scene.set_settings(settings);
    for (int i = 0; i < 30; ++i) {
      const double speed = i % 3;  // [m/s]
      scene.add({.shapes = {box(1, 1)},
                 .position = {5.0 + 2 * i, 0.5},
                 .velocity = {speed, 0},
                 .material = {.friction = mu}});
    }
    scene.add_ground({.half_width = 100, .material = {.friction = mu}});
    const VelocityProblem<double> start = cold_problem_after(scene, 2);
    REQUIRE(start.row_count() >= 100);
    VelocityProblem<double> direct = start, iterated = start;
    ReferenceSolver<double> solver({.newton_rows = 400, .other_covers = 0});
    REQUIRE(solver.solve(direct).converged);
    CHECK(solver.report().method == ReferenceMethod::lemke);
    ReferenceSolver<double> newton_solver({.max_rows = 0});
    REQUIRE(newton_solver.solve(iterated).converged);
    CHECK(newton_solver.report().method == ReferenceMethod::newton);
    // R_E of 1e-12 at most, times the condition: 50 links, 10 times heavier at the end.
    CHECK(largest_gap(direct.velocity, iterated.velocity) <= 1e-8);
  }
}

TEST_CASE("two rows that share a disc are solved by Newton's method: friction against the velocity") {
  // Seen from above: a body slides at (3, 4) m/s, and friction may give 2 N s in all.
  VelocityProblem<double> problem = empty_problem<double>();
  const BodyId body = add_body<double>(problem, 1, 1, {3, 4, 0});
  ConstraintRow<double> row;
  row.b = body;
  row.jacobian_b = {1, 0, 0};
  row.bounds = Bounds<double>::rest_of_disc(2, 1);
  add_row(problem, row);
  row.jacobian_b = {0, 1, 0};
  row.bounds = Bounds<double>::at_most(1.6);  // what the direction leaves to y: 2 * 4/5
  add_row(problem, row);
  ReferenceSolver<double> solver;
  CHECK(solver.solve(problem).converged);
  CHECK(solver.report().method == ReferenceMethod::newton);
  CHECK(problem.impulse[0] == doctest::Approx(-1.2).epsilon(1e-14));
  CHECK(problem.impulse[1] == doctest::Approx(-1.6).epsilon(1e-14));
}

TEST_CASE("where rows contradict each other nothing is called solved, by any method") {
  // v >= 1 and v <= 0
  VelocityProblem<double> problem = empty_problem<double>();
  const BodyId body = add_body<double>(problem, 1, 1, {0, 0, 0});
  ConstraintRow<double> row = floor_row<double>(body, 0);
  row.bias = 1;
  add_row(problem, row);
  row.jacobian_b = {0, -1, 0};
  row.bias = 0;
  add_row(problem, row);
  for (const ReferenceSettings& settings :
       {ReferenceSettings{}, ReferenceSettings{.max_modes = 0}, ReferenceSettings{.max_rows = 0}}) {
    VelocityProblem<double> copy = problem;
    ReferenceSolver<double> solver(settings);
    CHECK_FALSE(solver.solve(copy).converged);
    CHECK(solver.report().method == ReferenceMethod::none);
    CHECK(solver.report().residual > 0.1);
    CHECK(solver.report().velocity.verdict == Uniqueness::unknown);
  }
}

TEST_CASE("pyramids of 256, 400 and 784 rows, at rest and in motion, are solved beyond Lemke's reach") {
  for (const int base : {8, 10, 14}) {
    for (const int steps : {0, 3}) {
      if (base == 14 && steps == 3) continue;  // takes longer than all others together
      VelocityProblem<double> problem = cold_problem_after(box_pyramid(base), steps);
      REQUIRE(problem.row_count() == 4 * base * base);  // two contacts a box below, base + base (base - 1)
      VelocityProblem<long double> exact = converted<long double>(problem);
      const long double scale = residual_scale(exact);
      const NewtonResult result = newton(exact, {.tolerance = 1e-12});
      CHECK(result.converged);
      CHECK(residual(exact, scale).energy <= 1e-12L);  // of what was returned
    }
  }
}

TEST_CASE(
    "a hundred boxes on each other are solved however high: n rows of contacts that repeat each other") {
  const VelocityProblem<double> problem = problem_after(samples::stack(100), 0);
  REQUIRE(problem.row_count() == 400);
  VelocityProblem<long double> exact = converted<long double>(problem);
  CHECK(newton(exact).converged);
  // Two normal impulses of interface j carry the boxes above it, if the top ones stay: none does leave.
  for (int body = 1; body < exact.body_count(); ++body) {
    // R_E is 1e-15; velocities may be off by that times the root of the condition, 100^2, and of the sum.
    CHECK(std::abs(static_cast<double>(exact.velocity[{body}].y())) <= 1e-10);
  }
}

TEST_CASE("Newton's method lists one of the solutions of random problems, nearly always") {
  std::mt19937 random(19);
  int solvable = 0, solved = 0;
  for (int round = 0; round < 150; ++round) {
    const VelocityProblem<double> start = random_contact_problem(random);
    const ContactSolutions<double> all = all_contact_solutions(start);
    VelocityProblem<long double> problem = converted<long double>(start);
    const NewtonResult result = newton(problem, {.iterations = 300});
    solvable += all.solutions.empty() ? 0 : 1;
    if (!result.converged) continue;
    ++solved;
    double least = std::numeric_limits<double>::infinity();
    for (const ContactSolution<double>& solution : all.solutions) {
      const VelocityProblem<double> rounded = converted<double>(problem);
      least = std::min(least, largest_gap(rounded.velocity, solution.velocity));
    }
    // R_E of 1e-15, velocities up to 100 m/s and condition numbers up to 1e4.
    CHECK(least <= 1e-10);
  }
  CHECK(solved <= solvable);
  CHECK(solved >= solvable - 10);
}
