// LU factors in blocks, beside dense ones.
#include <Eigen/LU>
#include <random>
#include <set>

#include "testing.hpp"

using namespace cairn;

namespace {

/// A random graph of bodies, and the identity with blocks added where bodies are joined: those of one row for
/// two bodies, or of two such rows, left and right of each other.
struct BlocksToFactor {
  BlocksToFactor(int bodies, int joints, unsigned seed, bool is_symmetric)
      : full(Matrix<double>::Identity(3 * bodies, 3 * bodies)) {
    std::mt19937 random(seed);
    const auto number = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
    std::set<std::pair<int, int>> joined;
    for (int k = 0; k < joints; ++k) {
      const int a = static_cast<int>(random() % static_cast<unsigned>(bodies));
      const int b = static_cast<int>(random() % static_cast<unsigned>(bodies));
      if (a != b) joined.emplace(std::min(a, b), std::max(a, b));
    }
    pairs.assign(joined.begin(), joined.end());
    factors.begin(bodies, pairs);
    factors.set_identity(is_symmetric);
    for (const auto& [a, b] : pairs) {
      Eigen::Matrix<double, 6, 1> row, other;
      for (int i = 0; i < 6; ++i) row(i) = number();
      other = row;
      if (!is_symmetric) other += 0.1 * row.reverse();
      const Eigen::Matrix<double, 6, 6> product = row * other.transpose();
      add(a, a, product.topLeftCorner<3, 3>());
      add(a, b, product.topRightCorner<3, 3>());
      add(b, a, product.bottomLeftCorner<3, 3>());
      add(b, b, product.bottomRightCorner<3, 3>());
    }
    sides = Vector<double>::Zero(3 * bodies);
    for (Eigen::Index i = 0; i < sides.size(); ++i) sides(i) = number();
  }

  void add(int a, int b, const Eigen::Matrix3d& block) {
    factors.add(a, b, block);
    full.block<3, 3>(3 * a, 3 * b) += block;
  }

  Matrix<double> full;
  Vector<double> sides;
  List<std::pair<int, int>> pairs;
  BlockFactors factors;
};

}  // namespace

TEST_CASE("factors in blocks solve what dense factors solve, whoever is joined with whom, symmetric or not") {
  for (const bool is_symmetric : {true, false}) {
    CAPTURE(is_symmetric);
    for (unsigned seed = 1; seed <= 20; ++seed) {
      BlocksToFactor matrix(1 + static_cast<int>(seed), 2 * static_cast<int>(seed), seed, is_symmetric);
      Vector<double> x = matrix.sides;
      matrix.factors.factorize();
      matrix.factors.solve(x);
      const Vector<double> dense = matrix.full.partialPivLu().solve(matrix.sides);
      // Eigenvalues are from 1 to 1 + 40 joints of at most 6 / 4, of a matrix with at most 63 rows; a tenth
      // of a row, turned round, changes neither by much.
      const double roundings = 61 * 63 * 2.3e-16;
      CHECK((x - dense).norm() <= 4 * roundings * dense.norm());
    }
  }
}

TEST_CASE("a chain keeps one pair of blocks a joint, whatever the numbers of its bodies") {
  const int bodies = 50;
  List<std::pair<int, int>> pairs;
  for (int k = 0; k + 1 < bodies; ++k) {
    const int a = 7 * k % bodies, b = 7 * (k + 1) % bodies;  // 7 and 50 share no divisor: each body once
    pairs.emplace_back(std::min(a, b), std::max(a, b));
  }
  std::sort(pairs.begin(), pairs.end());
  BlockFactors factors;
  factors.begin(bodies, pairs);
  // A pair as given, its second body, and the same seen from there; of a body its place, the place's body,
  // two beginnings and a mark.
  const std::size_t order = (bodies - 1) * 5 * sizeof(int) + (5 * bodies + 2) * sizeof(int);
  CHECK(factors.memory() == (2 * (bodies - 1) + bodies) * 9 * sizeof(double) + order);
}

TEST_CASE("factors that would take too much memory are refused, and the next ones are as good as ever") {
  const int bodies = 2001;  // each joined with every other: 2 001 000 pairs
  List<std::pair<int, int>> pairs;
  for (int a = 0; a < bodies; ++a) {
    for (int b = a + 1; b < bodies; ++b) pairs.emplace_back(a, b);
  }
  BlockFactors factors;
  for (int again = 0; again < 2; ++again) CHECK_THROWS_AS(factors.begin(bodies, pairs), std::length_error);
  factors.begin(2, {{0, 1}});
  factors.set_identity(true);
  factors.add(1, 0, Eigen::Matrix3d::Identity() / 2);
  factors.add(0, 1, Eigen::Matrix3d::Identity() / 2);
  factors.factorize();
  Vector<double> x = Vector<double>::Constant(6, 1.5);
  factors.solve(x);
  CHECK((x - Vector<double>::Ones(6)).norm() <= 1e-14);
}

TEST_CASE("an order of elimination is kept while its pairs are enough, and half of them are used") {
  Elimination elimination;
  const List<std::pair<int, int>> square = {{0, 1}, {0, 3}, {1, 2}, {2, 3}};
  CHECK(elimination.begin(4, square));
  CHECK(elimination.pairs() == 5);  // whoever goes first joins its two neighbours
  CHECK_FALSE(elimination.begin(4, square));
  CHECK_FALSE(elimination.begin(4, {{0, 1}, {2, 3}}));
  CHECK(elimination.begin(4, {{0, 2}, {1, 2}}));
  CHECK(elimination.pairs() == 2);
  CHECK(elimination.begin(5, {{0, 2}, {1, 2}}));
  CHECK(elimination.begin(5, {}));
  CHECK(elimination.pairs() == 0);
}
