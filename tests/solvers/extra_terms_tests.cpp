// Rows on more than two bodies (paper 4.3 says only SI can have them): every solver here can.
#include "solver_list.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// A rope over and under fixed rollers that holds bodies of these masses: sum r_i y_i is kept, with r_i parts
/// of rope at each. After one step of falling.
template <Scalar Real>
VelocityProblem<Real> rope_over(const List<Real>& parts, const List<Real>& masses, Real g, Real dt) {
  VelocityProblem<Real> problem;
  problem.dt = dt;
  problem.velocity = {Vec3<Real>::Zero()};
  problem.inverse_mass = {Vec3<Real>::Zero()};
  for (const Real mass : masses) {
    problem.velocity.push_back({0, -g * dt, 0});
    problem.inverse_mass.push_back({1 / mass, 1 / mass, 1 / mass});
  }
  ConstraintRow<Real> row;
  row.a = {1};
  row.b = {2};
  row.jacobian_a = {0, parts[0], 0};
  row.jacobian_b = {0, parts[1], 0};
  for (int i = 2; i < parts.size(); ++i) problem.extra_terms.push_back({{i + 1}, {0, parts[i], 0}});
  row.extra_count = parts.size() - 2;
  problem.rows = {row};
  problem.blocks = {{0, 1}};
  problem.impulse = {0};
  return problem;
}

/// Three rows that share bodies through their extra terms: a rope on bodies 1, 2, 3 and contacts under each.
template <Scalar Real>
VelocityProblem<Real> rope_and_floor() {
  VelocityProblem<Real> problem = rope_over<Real>({1, 2, 1}, {1, 4, 3}, 10, Real(0.02));
  for (int body = 1; body <= 3; ++body) {
    ConstraintRow<Real> row;
    row.b = {body};
    row.jacobian_b = {0, 1, 0};
    row.bounds = Bounds<Real>::unilateral();
    row.bias = body == 1 ? Real(-1) : Real(0);
    problem.rows.push_back(row);
    problem.blocks.push_back({body, 1});
    problem.impulse.push_back(0);
  }
  return problem;
}

}  // namespace

TEST_CASE_TEMPLATE("rows that share a third body couple, and all solvers give the same sweeps", Real, float,
                   double) {
  const VelocityProblem<Real> start = rope_and_floor<Real>();
  for (const int sweeps : {1, 2, 5, 50}) {
    VelocityProblem<Real> expected = start;
    ProjectedGaussSeidel<Real>({.iterations = sweeps}).solve(expected);
    for (const SolverMaker<Real>& make : all_solvers<Real>()) {
      VelocityProblem<Real> problem = start;
      make({.iterations = sweeps})->solve(problem);
      const Real tolerance =
          64 * std::numeric_limits<Real>::epsilon() * Real(1 + sweeps);  // as for two bodies
      for (int i = 0; i < problem.impulse.size(); ++i) {
        CHECK(std::abs(problem.impulse[i] - expected.impulse[i]) <= tolerance);
      }
    }
  }
}

TEST_CASE("solvers that go their own way come to the same answer with a third body") {
  VelocityProblem<double> expected = rope_and_floor<double>();
  SequentialImpulse<double>({.iterations = 2000}).solve(expected);
  CHECK(residual(expected, residual_scale(rope_and_floor<double>())).energy <= 1e-14);
  for (const SolverMaker<double>& make : all_solvers<double>(Iterates::any)) {
    VelocityProblem<double> problem = rope_and_floor<double>();
    make({.iterations = 2000})->solve(problem);
    for (const BodyId body : problem.velocity.indices()) {
      CHECK((problem.velocity[body] - expected.velocity[body]).norm() <= 1e-12);
    }
  }
}

TEST_CASE("non-zeros, couplings and colours count a third body") {
  const VelocityProblem<double> problem = rope_and_floor<double>();
  // The rope meets the floor under each of its three bodies; floors meet nothing but themselves and the rope.
  CHECK(non_zeros(problem) == 4 + 2 * 3);
  CHECK(coupled_pairs(problem) == 4 + 2 * 3);
  const SystemMatrices<double> system = system_matrices(problem);
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) {
      CHECK(coupling(problem, problem.rows[i], problem.rows[k], problem.inverse_mass) ==
            doctest::Approx(system.A(i, k)).epsilon(1e-15));
    }
  }
  RowSequence sequence;
  order_rows(problem, RowOrder::coloured, 1, 1, sequence);
  CHECK(sequence.colours == List<int>{0, 1, 4});  // the rope alone, and the three floors together
}
