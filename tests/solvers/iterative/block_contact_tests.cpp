// Contacts solved as a whole: Coulomb's law at a point, and the two normals of a manifold.
#include <random>

#include "solvers/solver_list.hpp"
#include <cairn/samples/samples.hpp>
#include <cairn/validation/case_scenes.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

using BlockRandom = std::function<double(double, double)>;

/// The normal and friction rows of `points` contacts between two bodies, drawn at random; as one block.
template <Scalar Real>
VelocityProblem<Real> random_contacts(const BlockRandom& random, int points) {
  const auto any = [&](double low, double high) { return static_cast<Real>(random(low, high)); };
  VelocityProblem<Real> problem;
  for (int body = 0; body < 2; ++body) {
    const Real mass = any(0.1, 10);
    problem.inverse_mass.push_back({1 / mass, 1 / mass, 1 / (mass * any(0.01, 1))});
    problem.velocity.push_back({any(-2, 2), any(-2, 2), any(-4, 4)});
  }
  const Real angle = any(-3, 3);
  const Vec2<Real> n = {std::cos(angle), std::sin(angle)};
  const Vec2<Real> t = {n.y(), -n.x()};
  const Real friction = any(0, 3);
  for (int point = 0; point < points; ++point) {
    const Vec2<Real> r_a = {any(-1, 1), any(-1, 1)};
    const Vec2<Real> r_b = {any(-1, 1), any(-1, 1)};
    const int normal = problem.row_count();
    for (const Vec2<Real>& d : {n, t}) {
      problem.rows.push_back({.a = {0},
                              .b = {1},
                              .jacobian_a = {-d.x(), -d.y(), -cross<Real>(r_a, d)},
                              .jacobian_b = {d.x(), d.y(), cross<Real>(r_b, d)}});
    }
    problem.rows[normal].bounds = Bounds<Real>::unilateral();
    problem.rows[normal].bias = any(-1, 1);
    problem.rows.back().bounds = Bounds<Real>::coulomb(friction, normal);
    // A warm start that the block has to take back or to keep.
    problem.impulse.push_back(any(0, 3));
    problem.impulse.push_back(friction * problem.impulse.back() * any(-1, 1));
  }
  problem.blocks = {{0, problem.row_count()}};
  return problem;
}

/// What rounding may leave of a row's velocity error: 64 roundings of all that was added up in it, before
/// and after.
template <Scalar Real>
Real rounding_of(const VelocityProblem<Real>& start, const VelocityProblem<Real>& solved, int i) {
  Real sum = std::abs(start.rows[i].bias);
  for (int k = 0; k < start.rows.size(); ++k) {
    Real A_ik = 0;
    const ConstraintRow<Real>& row = start.rows[i];
    const ConstraintRow<Real>& other = start.rows[k];
    A_ik += row.jacobian_a.cwiseAbs().dot(start.inverse_mass[{0}].cwiseProduct(other.jacobian_a.cwiseAbs()));
    A_ik += row.jacobian_b.cwiseAbs().dot(start.inverse_mass[{1}].cwiseProduct(other.jacobian_b.cwiseAbs()));
    sum += A_ik * (std::abs(start.impulse[k]) + std::abs(solved.impulse[k]));
  }
  sum += start.rows[i].jacobian_a.cwiseAbs().dot(start.velocity[{0}].cwiseAbs());
  sum += start.rows[i].jacobian_b.cwiseAbs().dot(start.velocity[{1}].cwiseAbs());
  return 64 * std::numeric_limits<Real>::epsilon() * sum;
}

/// Impulse >= 0, w >= 0, and one of them 0.
template <Scalar Real>
bool obeys_signorini(const VelocityProblem<Real>& start, const VelocityProblem<Real>& solved, int i) {
  const Real w = row_velocity(solved, solved.rows[i]) - solved.rows[i].bias;
  const Real rounding = rounding_of(start, solved, i);
  return solved.impulse[i] >= 0 && w >= -rounding && (solved.impulse[i] == 0 || w <= rounding);
}

/// |impulse| <= mu normal, and a slip that friction resists with all it has, or none.
template <Scalar Real>
bool obeys_coulomb(const VelocityProblem<Real>& start, const VelocityProblem<Real>& solved, int i) {
  const Bounds<Real>& bounds = solved.rows[i].bounds;
  const Real limit = bounds.friction * solved.impulse[bounds.normal_row];
  const Real w = row_velocity(solved, solved.rows[i]) - solved.rows[i].bias;
  const Real rounding = rounding_of(start, solved, i);
  // At the limit: the impulse is reached by a change from where it began, and both are rounded.
  const Real begun = std::abs(start.impulse[i]) + bounds.friction * start.impulse[bounds.normal_row];
  const Real nearly = limit - 4 * std::numeric_limits<Real>::epsilon() * (limit + begun);
  if (std::abs(solved.impulse[i]) > limit) return false;
  if (w > rounding) return solved.impulse[i] <= -nearly;
  if (w < -rounding) return solved.impulse[i] >= nearly;
  return true;
}

/// Painleve's rod, as a block: its lower end slides along the ground at 1 m/s, to the right or to the left.
VelocityProblem<double> rod_in_a_block(double speed, double mu) {
  VelocityProblem<double> problem = painleve_rod<double>(speed, mu);
  problem.blocks = {{0, 2}};
  return problem;
}

}  // namespace

TEST_CASE_TEMPLATE("one sweep gives 1000 random contacts their answer by Coulomb's law", Real, float,
                   double) {
  const BlockRandom random = uniform_numbers(1);
  int open = 0, sticking = 0, slipping = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const VelocityProblem<Real> start = random_contacts<Real>(random, 1);
    VelocityProblem<Real> solved = start;
    BlockSequentialImpulse<Real>({.iterations = 1}).solve(solved);
    CAPTURE(trial);
    CHECK(obeys_signorini(start, solved, 0));
    CHECK(obeys_coulomb(start, solved, 1));
    const Real slip = std::abs(row_velocity(solved, solved.rows[1]));
    open += solved.impulse[0] == 0;
    sticking += solved.impulse[0] > 0 && slip <= rounding_of(start, solved, 1);
    slipping += solved.impulse[0] > 0 && slip > rounding_of(start, solved, 1);
  }
  CHECK(open >= 100);  // every mode was there, and none hardly ever
  CHECK(sticking >= 100);
  CHECK(slipping >= 100);
}

TEST_CASE_TEMPLATE("one sweep gives the two normals of 1000 random manifolds their answer", Real, float,
                   double) {
  const BlockRandom random = uniform_numbers(2);
  int held[3] = {0, 0, 0};
  for (int trial = 0; trial < 1000; ++trial) {
    VelocityProblem<Real> start = random_contacts<Real>(random, 2);
    start.rows.erase(start.rows.begin() + 3);  // without friction: two normal rows
    start.rows.erase(start.rows.begin() + 1);
    start.impulse = {start.impulse[0], start.impulse[2]};
    start.blocks = {{0, 2}};
    VelocityProblem<Real> solved = start;
    BlockSequentialImpulse<Real>({.iterations = 1}, ContactBlock::two_normals).solve(solved);
    CAPTURE(trial);
    CHECK(obeys_signorini(start, solved, 0));
    CHECK(obeys_signorini(start, solved, 1));
    held[(solved.impulse[0] > 0) + (solved.impulse[1] > 0)] += 1;
  }
  for (const int count : held) CHECK(count >= 50);  // none, one and both of the contacts
}

TEST_CASE_TEMPLATE("a box that lands on two contacts is at rest on both after one sweep", Real, float,
                   double) {
  VelocityProblem<Real> problem = box_on_feet<Real>({Real(-0.5), Real(0.5)}, {0, -1, Real(0.5)});
  problem.blocks = {{0, 2}};
  VelocityProblem<Real> scalar = problem;
  BlockSequentialImpulse<Real>({.iterations = 1}, ContactBlock::two_normals).solve(problem);
  // p_1 + p_2 = m v = 1 and (p_2 - p_1) / 2 = -I w = -1/12; both below 1 N s, A below 4 1/kg.
  const Real rounding = 16 * std::numeric_limits<Real>::epsilon();
  CHECK(std::abs(problem.impulse[0] - Real(7) / 12) <= rounding);
  CHECK(std::abs(problem.impulse[1] - Real(5) / 12) <= rounding);
  CHECK(problem.velocity[{1}].norm() <= 4 * rounding);
  SequentialImpulse<Real>({.iterations = 1}).solve(scalar);
  CHECK(scalar.velocity[{1}].norm() > Real(0.01));  // the second contact tilts the box off the first
}

TEST_CASE("two normals first, then friction inside the bounds that they gave") {
  const BlockRandom random = uniform_numbers(3);
  for (int trial = 0; trial < 200; ++trial) {
    VelocityProblem<double> problem = random_contacts<double>(random, 2);
    BlockSequentialImpulse<double>({.iterations = 1}, ContactBlock::two_normals).solve(problem);
    for (const int friction : {1, 3}) {
      const Bounds<double>& bounds = problem.rows[friction].bounds;
      CHECK(problem.impulse[friction] == bounds.clamp(problem.impulse[friction], problem.impulse));
    }
  }
}

TEST_CASE("Painleve's rod: for mu above 4/3 row by row goes round in a circle, the block slips") {
  for (const double mu : {1.4, 2.0}) {
    VelocityProblem<double> scalar = rod_in_a_block(-1, mu);
    const SolveReport report =
        SequentialImpulse<double>({.iterations = 100000, .patience = 10}).solve(scalar);
    CHECK(report.stop == Stop::cycle);  // normal and friction take turns: mu A_nt > A_nn
    CHECK(report.largest_change > 0.001);
    VelocityProblem<double> block = rod_in_a_block(-1, mu);
    BlockSequentialImpulse<double>({.iterations = 1}).solve(block);
    CHECK(block.impulse[0] == doctest::Approx(0.01 / (1.6 + 1.2 * mu)).epsilon(1e-14));
    CHECK(block.impulse[1] == doctest::Approx(mu * block.impulse[0]).epsilon(1e-14));
  }
}

TEST_CASE("Painleve's rod on the other side: an impact without a collision, the same for every mu > 4/3") {
  // It sticks: w = 0. lambda_n = (A_tt g dt + |A_nt| v_t) / (A_nn A_tt - A_nt^2) = 0.3085.
  const double expected = (3.4 * 0.01 + 1.2 * 1) / (1.6 * 3.4 - 1.2 * 1.2);
  for (const double mu : {1.34, 1.4, 2.0, 1e6}) {
    VelocityProblem<double> block = rod_in_a_block(1, mu);
    BlockSequentialImpulse<double>({.iterations = 1}).solve(block);
    CHECK(block.impulse[0] == doctest::Approx(expected).epsilon(1e-13));  // the determinant is a third of A's
    CHECK(std::abs(row_velocity(block, block.rows[1])) <= 1e-14);
  }
}

TEST_CASE("where open, stick and slip are all answers, bodies that part are given no impulse") {
  // Painleve's indeterminate case: q_n > 0, but sliding friction would press the rod to the ground.
  VelocityProblem<double> rod = rod_in_a_block(1, 2);
  rod.velocity[{1}].y() = 0.01;
  rod.impulse = {0.3, -0.4};  // begun from close to where it sticks, which is an answer too
  BlockSequentialImpulse<double>({.iterations = 1}).solve(rod);
  CHECK(rod.impulse == PerRow<double>{0, 0});
  const double stick = (-3.4 * 0.01 + 1.2 * 1) / (1.6 * 3.4 - 1.2 * 1.2);  // lambda_n where it sticks
  CHECK(stick > 0);
}

TEST_CASE("blocks and SI come to the same velocities where there is one answer only") {
  // Friction moves normals by mu |A_nt| < A_nn: one answer, and both methods contract.
  const BlockRandom random = uniform_numbers(4);
  int compared = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const VelocityProblem<double> start = random_contacts<double>(random, 1);
    const SystemMatrices<double> system = system_matrices(start);
    if (!(start.rows[1].bounds.friction * std::abs(system.A(0, 1)) < 0.8 * system.A(0, 0))) continue;
    VelocityProblem<double> scalar = start;
    SequentialImpulse<double>({.iterations = 2000}).solve(scalar);
    for (const ContactBlock contact :
         {ContactBlock::none, ContactBlock::normal_and_friction, ContactBlock::two_normals}) {
      VelocityProblem<double> block = start;
      BlockSequentialImpulse<double>({.iterations = 2000}, contact).solve(block);
      const double rounding = rounding_of(start, block, 0) + rounding_of(start, block, 1);
      for (const int row : {0, 1}) {
        const double difference =
            row_velocity(block, block.rows[row]) - row_velocity(scalar, scalar.rows[row]);
        CHECK(std::abs(difference) <= rounding);
      }
    }
    compared += 1;
  }
  CHECK(compared >= 100);
}

TEST_CASE(
    "a straight stack with friction converges like one row an interface when normals are solved in twos") {
  // Two equal normal impulses tilt nothing, so that friction has nothing to do: the rate is cos^2(pi / 2 n).
  // Row by row the first of two normals tilts its box, and the slow modes of friction are awake.
  constexpr int boxes = 10;
  VelocityProblem<double> problem = problem_after(samples::stack(boxes), 0);
  CHECK(problem.row_count() == 4 * boxes);
  SweepRecorder<double> recorder;
  BlockSequentialImpulse<double>({.iterations = 200}, ContactBlock::two_normals).solve(problem, &recorder);
  const double shrunk = recorder.sweeps()[200].residual_energy / recorder.sweeps()[50].residual_energy;
  const double cosine = std::cos(pi / (2 * boxes));
  // By sweep 50 the second slowest mode, cos^2(3 pi / 2 n), is 4e-5 of the slowest.
  CHECK(std::pow(shrunk, 1.0 / 150) == doctest::Approx(cosine * cosine).epsilon(1e-4));
}

TEST_CASE_TEMPLATE("a NaN is still a NaN after the modes of contact were tried", Real, float, double) {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const PairMatrix<Real> A{.first = 2, .cross = Real(0.5), .second = 3};
  for (const Real other : {Real(-1), Real(1)}) {
    for (const Vec2<Real>& q : {Vec2<Real>(nan, other), Vec2<Real>(other, nan)}) {
      CHECK(std::isnan(solve_coulomb<Real>(A, q, Real(0.5)).sum()));
      CHECK(std::isnan(solve_two_normals<Real>(A, q).sum()));
    }
  }
}
