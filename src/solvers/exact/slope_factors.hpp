// Floor 4. The matrix of Newton's method in factors, which outlive the rows that they were made for.
#pragma once

#include <utility>

#include "solvers/exact/block_factors.hpp"
#include "solvers/exact/proximal_rows.hpp"
#include "math/list.hpp"

namespace cairn {

/// dF/du of ProximalRows, factorized. From one step to the next that matrix hardly changes, and an old one
/// still says well which way to go (simplified Newton's method: P. Deuflhard, Newton Methods for Nonlinear
/// Problems, 2004): so it stays until who asks has it made anew. So does the order of elimination, while the
/// pairs of bodies are among those that it was made for.
template <Scalar Real>
class SlopeFactors {
 public:
  /// From here on rows are those of another problem, whose pairs of bodies are not known yet.
  void begin() { has_pairs_ = false; }
  /// Made anew from the last evaluation. @throws std::length_error as BlockFactors does.
  void factorize(const ProximalRows<Real>& rows);
  /// Whether there are any, for as many bodies.
  bool are_for(const ProximalRows<Real>& rows) const {
    return factors_.factorized_bodies() > 0 && 3 * factors_.factorized_bodies() == rows.freedoms();
  }
  /// How soft rows were when they were made.
  Real softness() const { return softness_; }
  /// x = matrix^-1 x.
  void solve(Vector<Real>& x) const { factors_.solve(x); }
  /// Bytes of all that is kept.
  std::size_t memory() const { return pairs_.bytes() + factors_.memory(); }

 private:
  void find_pairs(const ProximalRows<Real>& rows);

  BlockFactors<Real> factors_;
  Real softness_ = 0;
  List<std::pair<int, int>> pairs_;  // of bodies that share a row
  bool has_pairs_ = false;           // of the rows as they are
};

}  // namespace cairn
