// Floor 4. A direct factorization, and enumerations of a few cases.
#include <cairn/solvers/iterative/block_solve.hpp>

#include <cmath>
#include <limits>

namespace cairn {

namespace {

/// Where row `row` of a strictly lower triangle begins when its rows stand one after the other.
constexpr int lower_row(int row) { return row * (row - 1) / 2; }

/// A x + q = 0, by elimination of the first unknown: small residuals even where A is nearly singular.
template <Scalar Real>
Vec2<Real> solve_both_rows(const PairMatrix<Real>& A, const Vec2<Real>& q) {
  const Real share = A.cross / A.first;
  const Real second = (share * q(0) - q(1)) / (A.second - share * A.cross);
  return {-(q(0) + A.cross * second) / A.first, second};
}

}  // namespace

template <Scalar Real>
bool BlockFactor<Real>::factorize(const BlockMatrix<Real>& A, int n) {
  count_ = n;
  BlockVector<Real> pivot = {};
  for (int i = 0; i < n; ++i) {
    pivot[i] = A[i][i];
    for (int k = 0; k < i; ++k) {
      Real entry = A[i][k];
      for (int l = 0; l < k; ++l) {
        entry -= lower_[lower_row(i) + l] * pivot[l] * lower_[lower_row(k) + l];
      }
      lower_[lower_row(i) + k] = entry * inverse_pivot_[k];
      pivot[i] -= lower_[lower_row(i) + k] * entry;
    }
    if (!(pivot[i] > singular_share(n) * A[i][i])) return false;
    inverse_pivot_[i] = 1 / pivot[i];
  }
  return true;
}

template <Scalar Real>
void BlockFactor<Real>::solve(BlockVector<Real>& x) const {
  const auto n = count_;
  for (int i = 1; i < n; ++i) {
    for (int k = 0; k < i; ++k) x[i] -= lower_[lower_row(i) + k] * x[k];
  }
  for (int i = 0; i < n; ++i) x[i] *= inverse_pivot_[i];
  for (int i = n; i-- > 0;) {
    for (int k = i + 1; k < n; ++k) x[i] -= lower_[lower_row(k) + i] * x[k];
  }
}

template <Scalar Real>
bool is_regular(const PairMatrix<Real>& A) {
  if (!(A.first > 0 && A.second > 0)) return false;
  return A.second - A.cross / A.first * A.cross > BlockFactor<Real>::singular_share(2) * A.second;
}

template <Scalar Real>
Vec2<Real> solve_coulomb(const PairMatrix<Real>& A, const Vec2<Real>& q, Real mu) {
  if (q(0) >= 0 && !std::isnan(q(1))) return {0, 0};  // open
  const Vec2<Real> stick = solve_both_rows(A, q);
  // Written so that a NaN comes out as it went in.
  if (!(stick(0) < 0) && !(std::abs(stick(1)) > mu * stick(0))) return stick;

  Vec2<Real> best = {0, 0};
  Real least = std::numeric_limits<Real>::infinity();
  for (const Real side : {Real(1), Real(-1)}) {
    const Real inverse_mass = A.first + side * mu * A.cross;
    if (!(inverse_mass > 0)) continue;  // Painleve: the impulse would press the bodies together
    const Vec2<Real> slip = {-q(0) / inverse_mass, side * mu * (-q(0) / inverse_mass)};
    const Real against = side * (A.cross * slip(0) + A.second * slip(1) + q(1));  // must be <= 0
    if (against >= least) continue;
    least = against;
    best = slip;
  }
  return best;
}

template <Scalar Real>
Vec2<Real> solve_two_normals(const PairMatrix<Real>& A, const Vec2<Real>& q) {
  if (q(0) >= 0 && q(1) >= 0) return {0, 0};
  const Vec2<Real> both = solve_both_rows(A, q);
  // Written so that a NaN comes out as it went in.
  if (!(both(0) < 0) && !(both(1) < 0)) return both;

  const Real first = -q(0) / A.first;
  // A contact that parts by itself gets no impulse; of two that do not, one holds the other up.
  const bool first_holds = q(0) < 0 && (q(1) >= 0 || A.cross * first + q(1) >= 0);
  if (first_holds) return {first, 0};
  return {0, -q(1) / A.second};
}

template class BlockFactor<float>;
template class BlockFactor<double>;
template bool is_regular(const PairMatrix<float>&);
template bool is_regular(const PairMatrix<double>&);
template Vec2<float> solve_coulomb(const PairMatrix<float>&, const Vec2<float>&, float);
template Vec2<double> solve_coulomb(const PairMatrix<double>&, const Vec2<double>&, double);
template Vec2<float> solve_two_normals(const PairMatrix<float>&, const Vec2<float>&);
template Vec2<double> solve_two_normals(const PairMatrix<double>&, const Vec2<double>&);

}  // namespace cairn
