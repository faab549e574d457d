// Floor 4. The small systems inside a block of rows, each solved exactly.
#pragma once

#include <limits>

#include <cairn/math/math.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Rows that are solved together at most: a weld has three.
inline constexpr int max_block_rows = 4;

/// A number for each row of a block.
template <Scalar Real>
using BlockVector = FixedList<Real, max_block_rows>;
/// A_BB, row by row.
template <Scalar Real>
using BlockMatrix = FixedList<BlockVector<Real>, max_block_rows>;

/// A_BB = L D L^T of a symmetric positive definite A_BB: what the paper (4.3) would invert once per step. No
/// pivoting: a positive definite matrix needs none, and the ratio of a pivot to its diagonal entry does not
/// change with the units of the rows.
template <Scalar Real>
class BlockFactor {
 public:
  /// False when A is singular but for rounding: some pivot is at most 8 count roundings of its diagonal
  /// entry. Above that the factor is good enough for a further sweep to correct what this one left.
  bool factorize(const BlockMatrix<Real>& A, int count);

  /// x becomes A^-1 x.
  void solve(BlockVector<Real>& x) const;

  /// Of its diagonal entry: where a pivot of `count` rows is no larger, the matrix counts as singular.
  static constexpr Real singular_share(int count) {
    return Real(8 * count) * std::numeric_limits<Real>::epsilon();
  }

 private:
  int count_ = 0;
  BlockVector<Real> inverse_pivot_ = {};  // of D
  FixedList<Real, 6> lower_ = {};         // of L, below its diagonal of ones, row by row
};

/// A_BB of two rows [1/kg], softness included.
template <Scalar Real>
struct PairMatrix {
  Real first = 0;   // A_11
  Real cross = 0;   // A_12 = A_21
  Real second = 0;  // A_22
};

/// Whether the matrix is positive definite by more than rounding, as BlockFactor has it.
template <Scalar Real>
bool is_regular(const PairMatrix<Real>& A);

/// Coulomb's law at one contact, exactly. Finds impulses (x, y), normal and friction, with
///   w = A (x, y) + q,   x >= 0,  w_n >= 0,  x w_n = 0,   |y| <= mu x,
///   w_t = 0 where |y| < mu x,   w_t <= 0 where y = mu x,   w_t >= 0 where y = -mu x.
/// Tries the modes one after the other: open (x = y = 0), stick (w = 0), slip (w_n = 0, y = +-mu x).
///
/// For a regular A there is always an answer. Let y follow x as friction alone would choose it: then w_n is
/// q_n at x = 0 and grows without bound, so that it has a root unless q_n >= 0. Along the way w_n may fall
/// first, while the contact slips and mu |A_nt| > A_nn (P. Painleve, 1895), but from where it sticks it only
/// rises. So the answer is the only one where q_n < 0. Where q_n >= 0 open is one, with up to two more in
/// Painleve's case: open is taken, as bodies that part without an impulse are given none. Modes as in
/// D. Stewart and J. Trinkle, An implicit time-stepping scheme for rigid body dynamics with inelastic
/// collisions and Coulomb friction (1996), of whose problem this is the smallest one.
///
/// Rounding can deny every mode at the border of two of them; slip with the smaller error is taken then.
/// A NaN gives NaN.
template <Scalar Real>
Vec2<Real> solve_coulomb(const PairMatrix<Real>& A, const Vec2<Real>& q, Real mu);

/// Two contacts without friction, exactly: x >= 0, w = A x + q >= 0, x w = 0 for both. Tries none, both, the
/// first alone, the second alone. The answer exists and is the only one for a regular A. As E. Catto solves
/// the two points of a manifold (Box2D, 2007). A NaN gives NaN.
template <Scalar Real>
Vec2<Real> solve_two_normals(const PairMatrix<Real>& A, const Vec2<Real>& q);

}  // namespace cairn
