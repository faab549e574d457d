// Lemke's method on problems small enough to be solved by hand, and on many that are not.
#include <random>

#include <cairn/solvers/exact/lemke.hpp>
#include "testing.hpp"

using namespace cairn;

namespace {

using LongMatrix = Matrix<long double>;
using LongVector = Vector<long double>;

const long double lemke_epsilon = std::numeric_limits<long double>::epsilon();

LongVector long_numbers(std::initializer_list<long double> values) {
  LongVector vector(values.size());
  Eigen::Index i = 0;
  for (const long double value : values) vector(i++) = value;
  return vector;
}

/// Entries row by row.
LongMatrix square_matrix(int n, std::initializer_list<long double> values) {
  LongMatrix matrix(n, n);
  Eigen::Index i = 0;
  for (const long double value : values) {
    matrix(i / n, i % n) = value;
    ++i;
  }
  return matrix;
}

/// The largest violation of z >= 0, w >= 0 and z w = 0.
long double lemke_violation(const LongMatrix& M, const LongVector& q, const LongVector& z) {
  const LongVector w = M * z + q;
  long double largest = 0;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    largest = std::max(largest, std::abs(std::min(z(i), w(i))));
  }
  return largest;
}

}  // namespace

TEST_CASE("Lemke's method solves a problem of two unknowns: 2 x + y = 5, x + 2 y = 6") {
  const LemkeResult result = lemke(square_matrix(2, {2, 1, 1, 2}), long_numbers({-5, -6}));
  CHECK(result.status == LemkeStatus::solved);
  CHECK(static_cast<double>(result.z(0)) == doctest::Approx(4.0 / 3).epsilon(1e-15));
  CHECK(static_cast<double>(result.z(1)) == doctest::Approx(7.0 / 3).epsilon(1e-15));
}

TEST_CASE("Lemke's method answers at once with 0 where q >= 0, and for nothing at all") {
  const LemkeResult rest = lemke(square_matrix(2, {2, 1, 1, 2}), long_numbers({0, 3}));
  CHECK(rest.status == LemkeStatus::solved);
  CHECK(rest.z == LongVector::Zero(2));
  CHECK(rest.pivots == 0);
  CHECK(lemke(LongMatrix(0, 0), LongVector(0)).status == LemkeStatus::solved);
}

TEST_CASE("Lemke's method ends in a ray where there is no solution") {
  CHECK(lemke(square_matrix(1, {-1}), long_numbers({-1})).status ==
        LemkeStatus::ray);  // w = -z - 1 is never >= 0
  CHECK(lemke(square_matrix(1, {0}), long_numbers({-1})).status == LemkeStatus::ray);
  // x - y >= 1 and y - x >= 1
  CHECK(lemke(square_matrix(2, {1, -1, -1, 1}), long_numbers({-1, -1})).status == LemkeStatus::ray);
}

TEST_CASE("Lemke's method solves the cyclic problem on which simpler pivoting goes round for ever") {
  // By symmetry z_i = 1/3; M is a P-matrix, so that there is no other solution (K. G. Murty, 1974).
  const LongMatrix M = square_matrix(3, {1, 2, 0, 0, 1, 2, 2, 0, 1});
  const LemkeResult result = lemke(M, long_numbers({-1, -1, -1}));
  REQUIRE(result.status == LemkeStatus::solved);
  for (Eigen::Index i = 0; i < 3; ++i) CHECK(std::abs(result.z(i) - 1.0L / 3) <= 16 * lemke_epsilon);
}

TEST_CASE("ties in every ratio do not stop Lemke's method: many copies of one contact") {
  for (const int n : {2, 10, 60}) {
    const LongMatrix M = LongMatrix::Ones(n, n);
    const LemkeResult result = lemke(M, LongVector::Constant(n, -1));
    REQUIRE(result.status == LemkeStatus::solved);
    CHECK(std::abs(result.z.sum() - 1) <= n * lemke_epsilon);
    CHECK(lemke_violation(M, LongVector::Constant(n, -1), result.z) <= n * lemke_epsilon);
  }
}

TEST_CASE("other covering vectors find other solutions where there are some") {
  // x + 2 y = 1 or x = 0, 2 x + y = 1 or y = 0: (1, 0), (0, 1) and (1/3, 1/3).
  const LongMatrix M = square_matrix(2, {1, 2, 2, 1});
  const LongVector q = long_numbers({-1, -1});
  const LemkeResult first = lemke(M, q, long_numbers({1, 2}));
  const LemkeResult second = lemke(M, q, long_numbers({2, 1}));
  REQUIRE(first.status == LemkeStatus::solved);
  REQUIRE(second.status == LemkeStatus::solved);
  CHECK(lemke_violation(M, q, first.z) <= 4 * lemke_epsilon);
  CHECK(lemke_violation(M, q, second.z) <= 4 * lemke_epsilon);
  // The larger share of the cover keeps its row satisfied for longer; so the other one is solved for first.
  CHECK((first.z - second.z).cwiseAbs().maxCoeff() > 0.5L);
}

TEST_CASE("Lemke's method solves hundreds of positive semidefinite problems that have a solution") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int round = 0; round < 300; ++round) {
    const Eigen::Index n = 1 + round % 25, rank = 1 + round % 7;
    LongMatrix J(n, rank);
    LongVector z(n), w(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < rank; ++j) J(i, j) = number(random);
      const double value = number(random);
      z(i) = std::max(value, 0.0);
      w(i) = std::max(-value, 0.0);
    }
    const LongMatrix M = J * J.transpose();
    const LongVector q = w - M * z;  // so that z is a solution: w is the only one, z is not
    const LemkeResult result = lemke(M, q);
    REQUIRE(result.status == LemkeStatus::solved);
    // Each of some n pivots rounds numbers that pivots down to 1e-9 have made larger; they seldom have.
    const LongVector error = M * result.z + q - w;
    CHECK(error.cwiseAbs().maxCoeff() <= 1e-13L);
    CHECK(lemke_violation(M, q, result.z) <= 1e-13L);
  }
}

TEST_CASE("Lemke's method refuses what does not fit together, and covers that are not positive") {
  const LongMatrix M = square_matrix(2, {2, 1, 1, 2});
  CHECK_THROWS_AS(lemke(M, long_numbers({1, 2, 3})), std::invalid_argument);
  CHECK_THROWS_AS(lemke(M, long_numbers({-1, 2}), long_numbers({1})), std::invalid_argument);
  CHECK_THROWS_AS(lemke(M, long_numbers({-1, 2}), long_numbers({1, 0})), std::invalid_argument);
  CHECK_THROWS_AS(lemke(M, long_numbers({-1, 2}), long_numbers({1, std::nanl("")})), std::invalid_argument);
}
