// Floor 4. Which rows meet on a body: the pattern of A without A.
#pragma once

#include <cstddef>

#include <cairn/constraints/row.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// J_i W J_j^T for a diagonal W of three numbers a body: an entry of A (15), without softness, where W is
/// M^-1; the product that eq. (30) prints where W is 1.
template <Scalar Real>
Real coupling(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& first,
              const ConstraintRow<Real>& second, const PerBody<Vec3<Real>>& weight);

/// For every body the rows that act on it, in ascending order. A row acts on a body when W j^T is not zero
/// there: not on the ground, whose inverse mass is 0. Two lists in one array each; O(n + m) to build and to
/// keep, and nothing is allocated for a problem no larger than the last.
class BodyRows {
 public:
  /// Finds the rows of every body anew. `weight`: the diagonal of W, for each body.
  template <Scalar Real>
  void build(const VelocityProblem<Real>& problem, const PerBody<Vec3<Real>>& weight);

  /// Appends the rows that share a body with row i, itself among them, in ascending order. None when the row
  /// acts on nothing.
  void append_neighbours(int i, List<int>& neighbours) const;
  /// Pairs of rows on a body, counted for each body: at least the neighbours of all rows together, and more
  /// by those that share more than one.
  std::ptrdiff_t pairs() const;
  std::size_t memory() const;  // bytes

 private:
  List<std::ptrdiff_t> first_body_;  // m + 1: where a row's bodies begin in bodies_
  List<BodyId> bodies_;              // those that a row acts on, each once
  List<std::ptrdiff_t> first_;       // n + 1: where a body's rows begin in rows_
  List<int> rows_;                   // as many as bodies_
};

}  // namespace cairn
