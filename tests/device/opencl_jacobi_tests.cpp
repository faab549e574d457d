// Jacobi on a device against Jacobi here: the same bits. Skipped, with a word, where there is no device.
#include <cairn/device/opencl_jacobi.hpp>

#include <random>

#include "../validation/problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

template <Scalar Real>
bool skipped() {
  if (has_opencl_device<Real>()) return false;
  MESSAGE("skipped: no OpenCL device for this precision");
  return true;
}

/// Bodies of all masses, rows of all kinds between any two of them: contacts with friction, discs, springs,
/// equalities, motors, and rows on three bodies; and impulses to begin from.
template <Scalar Real>
VelocityProblem<Real> tangle(int bodies, int rows, unsigned seed) {
  std::mt19937 random(seed);
  const auto number = [&] { return Real(static_cast<int>(random() % 2001) - 1000) / Real(1024); };
  const auto vector = [&] { return Vec3<Real>(number(), number(), number()); };
  const auto some_body = [&] { return static_cast<int>(random() % static_cast<unsigned>(bodies + 1)); };
  VelocityProblem<Real> problem = empty_problem<Real>();
  for (int i = 0; i < bodies; ++i) {
    add_body<Real>(problem, Real(1 + static_cast<int>(random() % 9)) / 2, Real(1) / 3, vector());
  }
  for (int i = 0; i < rows; ++i) {
    ConstraintRow<Real> row;
    row.a = BodyId{some_body()};
    row.b = BodyId{some_body()};
    row.jacobian_a = vector();
    row.jacobian_b = vector();
    row.bias = number();
    switch (random() % 6) {
      case 0:
        row.bounds = Bounds<Real>::unilateral();
        break;
      case 1:
        row.bounds = Bounds<Real>::at_most(Real(0.25));
        break;
      case 2:
        row.softness = Real(0.5);
        break;
      case 3:
        if (i > 1) row.bounds = Bounds<Real>::coulomb(Real(0.5), i - 1, i % 2 ? i - 2 : Bounds<Real>::none);
        break;
      case 4:
        if (i > 0) row.bounds = Bounds<Real>::rest_of_disc(Real(0.75), i - 1);
        break;
      default:
        row.first_extra = problem.extra_terms.size();
        row.extra_count = 1;
        problem.extra_terms.push_back({BodyId{some_body()}, vector()});
    }
    add_row(problem, row);
    problem.impulse[i] = row.bounds.is_equality() ? number() : Real(0);
  }
  return problem;
}

template <Scalar Real>
void check_same(const VelocityProblem<Real>& problem, const SolverSettings& settings) {
  VelocityProblem<Real> here = problem, there = problem;
  const SolveReport report = Jacobi<Real>(settings, Splitting::mass).solve(here);
  const SolveReport again = OpenClJacobi<Real>(settings).solve(there);
  CHECK(here.impulse == there.impulse);
  CHECK(here.velocity == there.velocity);
  CHECK(report.iterations == again.iterations);
  CHECK(report.largest_change == again.largest_change);
  CHECK(report.stop == again.stop);
}

}  // namespace

TEST_CASE_TEMPLATE("Jacobi on a device gives the bits of Jacobi here, for rows of every kind", Real, float,
                   double) {
  if (skipped<Real>()) return;
  for (const int sweeps : {0, 1, 2, 25}) {
    for (const unsigned seed : {1u, 2u, 3u})
      check_same<Real>(tangle<Real>(40, 120, seed), {.iterations = sweeps});
  }
  check_same<Real>(tangle<Real>(5, 0, 4), {.iterations = 5});
  check_same<Real>(tangle<Real>(300, 5000, 5), {.iterations = 10, .relaxation = 1.5});
}

TEST_CASE_TEMPLATE("Jacobi on a device stops where Jacobi stops", Real, float, double) {
  if (skipped<Real>()) return;
  const VelocityProblem<Real> stack = hand_made_stack<Real>(5, 10, 1);
  check_same<Real>(stack, {.iterations = 1000, .tolerance = 1e-3});
  check_same<Real>(stack, {.iterations = 100000, .patience = 5});
}

TEST_CASE("one solver on a device solves problems of several sizes, one after the other") {
  if (skipped<double>()) return;
  OpenClJacobi<double> solver({.iterations = 8});
  Jacobi<double> here({.iterations = 8}, Splitting::mass);
  for (const int boxes : {3, 12, 2}) {
    VelocityProblem<double> one = hand_made_stack<double>(boxes, 10, 1), other = one;
    solver.solve(one);
    here.solve(other);
    CHECK(one.impulse == other.impulse);
    CHECK(one.velocity == other.velocity);
  }
}
