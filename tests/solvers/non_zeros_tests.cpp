// How many entries of A are not zero: eq. (30) as printed, and as it should be.
#include "testing.hpp"

using namespace cairn;

namespace {

/// A normal row of two boxes that touch at height x [m]; the arms are measured from their middles.
template <Scalar Real>
ConstraintRow<Real> pyramid_contact(BodyId below, BodyId above, Real arm_below, Real arm_above) {
  ConstraintRow<Real> row;
  row.a = below;
  row.b = above;
  row.jacobian_a = {0, -1, -arm_below};
  row.jacobian_b = {0, 1, arm_above};
  row.bounds = Bounds<Real>::unilateral();
  return row;
}

/// Unit boxes of 1 kg side by side in rows of base, base - 1, ..., 1, each above the joint of two below, with
/// a contact at both ends of every overlap. The left corner stands `shift` right of the ground's origin.
template <Scalar Real>
VelocityProblem<Real> pyramid_of_boxes(int base, Real shift) {
  VelocityProblem<Real> problem;
  problem.inverse_mass = {Vec3<Real>::Zero()};
  const Real half = Real(0.5);
  for (int level = 0; level < base; ++level) {
    for (int i = 0; i < base - level; ++i) {
      const BodyId box = {problem.inverse_mass.size()};
      problem.inverse_mass.push_back({1, 1, 6});
      const Real x = shift + static_cast<Real>(i) + half;
      const BodyId left = {box.index - (base - level + 1)};
      const BodyId right = {left.index + 1};
      for (const Real end : {Real(0), half}) {
        if (level == 0) {
          problem.rows.push_back(pyramid_contact<Real>(ground, box, x - half + 2 * end, 2 * end - half));
        } else {
          problem.rows.push_back(pyramid_contact<Real>(left, box, end, end - half));
          problem.rows.push_back(pyramid_contact<Real>(right, box, end - half, end));
        }
      }
    }
  }
  problem.velocity.assign(problem.inverse_mass.size(), Vec3<Real>::Zero());
  problem.impulse.assign(problem.rows.size(), Real(0));
  return problem;
}

/// A body of the given mass and inertia with a contact at each of two arms, on a ground that is not in J.
VelocityProblem<double> body_on_two_points(double mass, double inertia, double first, double second) {
  VelocityProblem<double> problem;
  problem.inverse_mass = {Vec3<double>::Zero(), Vec3<double>(1 / mass, 1 / mass, 1 / inertia)};
  problem.velocity.assign(2, Vec3<double>::Zero());
  for (const double arm : {first, second}) {
    ConstraintRow<double> row;
    row.b = {1};
    row.jacobian_b = {0, 1, arm};
    problem.rows.push_back(row);
    problem.impulse.push_back(0);
  }
  return problem;
}

template <Scalar Real>
std::ptrdiff_t dense_non_zeros(const Matrix<Real>& matrix) {
  return (matrix.array() != Real(0)).count();
}

}  // namespace

// A box with k contacts couples k^2 pairs of rows. It has 2 or 4 above it and 2 or 4 below, the ends of each
// row of boxes fewer; pairs that share both of their bodies are counted once.
TEST_CASE_TEMPLATE("a pyramid of base n has 2 n^2 rows and 28 n^2 - 48 n + 24 entries in A that are not zero",
                   Real, float, double, long double) {
  for (const int n : {3, 5, 10, 20}) {
    CAPTURE(n);
    const VelocityProblem<Real> problem = pyramid_of_boxes<Real>(n, 0);
    CHECK(problem.rows.size() == 2 * n * n);
    CHECK(non_zeros(problem) == 28 * n * n - 48 * n + 24);
    CHECK(coupled_pairs(problem) == non_zeros(problem));  // nothing cancels here
    // Eq. (30) as printed couples all 2n rows on the ground, of which a box has 2 and couples 4 pairs anyway.
    CHECK(non_zeros_as_printed(problem) == non_zeros(problem) + 4 * n * n - 4 * n);
  }
}

TEST_CASE("the pyramids of base 3, 5, 10 and 20 have the numbers of non-zeros that the lesson quotes") {
  struct Count {
    int base = 0;
    int bodies = 0, rows = 0, dense = 0, printed = 0, exact = 0;
  };
  for (const Count& expected :
       {Count{3, 6, 18, 324, 156, 132}, Count{5, 15, 50, 2500, 564, 484},
        Count{10, 55, 200, 40000, 2704, 2344}, Count{20, 210, 800, 640000, 11784, 10264}}) {
    const VelocityProblem<double> problem = pyramid_of_boxes<double>(expected.base, 0);
    CHECK(problem.velocity.size() == expected.bodies + 1);  // and the ground
    CHECK(problem.rows.size() == expected.rows);
    CHECK(problem.rows.size() * problem.rows.size() == expected.dense);
    CHECK(non_zeros_as_printed(problem) == expected.printed);
    CHECK(non_zeros(problem) == expected.exact);
  }
}

TEST_CASE("the counts are those of the dense matrices") {
  for (const int base : {1, 3, 5, 10}) {
    CAPTURE(base);
    const VelocityProblem<double> problem = pyramid_of_boxes<double>(base, 0);
    const SystemMatrices<double> system = system_matrices(problem);
    CHECK(non_zeros(problem) == dense_non_zeros<double>(system.A));
    CHECK(non_zeros_as_printed(problem) == dense_non_zeros<double>(system.J * system.J.transpose()));
  }
}

TEST_CASE("a world's pyramid has the non-zeros of the one written by hand") {
  const int n = 10;
  Scene scene;
  scene.add_ground({.material = {.friction = 0}});
  for (int level = 0; level < n; ++level) {
    for (int i = 0; i + level < n; ++i) {
      // A spacing of 1.1 m, so that neighbours do not touch.
      const double x = 1.1 * (i + 0.5 * level + 0.5);
      scene.add({.shapes = {box(1, 1)}, .position = {x, level + 0.5}, .material = {.friction = 0}});
    }
  }
  const VelocityProblem<double> problem = World<double>(scene).velocity_problem();
  CHECK(problem.rows.size() == 2 * n * n);
  CHECK(coupled_pairs(problem) == 28 * n * n - 48 * n + 24);
  CHECK(non_zeros(problem) == coupled_pairs(problem));
}

TEST_CASE("eq. (30) as printed misses two contacts that A couples") {
  // Half a metre right and two metres left of the middle of 6 kg with 1 kg m^2.
  const VelocityProblem<double> problem = body_on_two_points(6, 1, 0.5, -2);
  CHECK(problem.rows[0].jacobian_b.dot(problem.rows[1].jacobian_b) == 0);
  CHECK(system_matrices(problem).A(0, 1) == doctest::Approx(1.0 / 6 - 1).epsilon(1e-15));
  CHECK(non_zeros_as_printed(problem) == 2);
  CHECK(non_zeros(problem) == 4);
}

TEST_CASE(
    "eq. (30) as printed counts two contacts that A does not couple: one at the other's centre of "
    "percussion") {
  const double mass = 4, inertia = 1, first = 0.5;
  const VelocityProblem<double> problem = body_on_two_points(mass, inertia, first, -inertia / mass / first);
  CHECK(problem.rows[0].jacobian_b.dot(problem.rows[1].jacobian_b) == 0.75);
  CHECK(system_matrices(problem).A(0, 1) == 0);
  CHECK(non_zeros_as_printed(problem) == 4);
  CHECK(non_zeros(problem) == 2);
  CHECK(coupled_pairs(problem) == 4);  // a sparse A has a place for them nevertheless
}

TEST_CASE("eq. (30) as printed depends on where the ground has its origin, and A does not") {
  const VelocityProblem<double> beside = pyramid_of_boxes<double>(10, 0);
  const VelocityProblem<double> around = pyramid_of_boxes<double>(10, -5);
  CHECK(non_zeros(around) == non_zeros(beside));
  CHECK(system_matrices(around).A == system_matrices(beside).A);
  // Two rows 1 m left of the origin and two 1 m right of it: 1 + (-1)(1) = 0, in both orders.
  CHECK(non_zeros_as_printed(around) == non_zeros_as_printed(beside) - 8);
}

TEST_CASE("a row between two bodies that cannot be moved has no entry in A, and one in eq. (30)") {
  VelocityProblem<double> problem = body_on_two_points(1, 1, 0.5, 0.25);
  problem.inverse_mass[{1}].setZero();
  CHECK(non_zeros(problem) == 0);
  CHECK(coupled_pairs(problem) == 0);
  CHECK(non_zeros_as_printed(problem) == 4);
}

TEST_CASE("no rows have no non-zeros") {
  CHECK(non_zeros(VelocityProblem<double>{}) == 0);
  CHECK(coupled_pairs(VelocityProblem<double>{}) == 0);
  CHECK(non_zeros_as_printed(VelocityProblem<double>{}) == 0);
}
