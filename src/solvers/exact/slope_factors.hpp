// Floor 4. The matrix of Newton's method in factors, which outlive the rows that they were made for.
#pragma once

#include <utility>

#include <cairn/solvers/exact/block_factors.hpp>
#include <cairn/solvers/exact/scaled_rows.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// dF/du of ProximalMap, factorized. From one step to the next that matrix hardly changes, and an old one
/// still says well which way to go (simplified Newton's method: P. Deuflhard, Newton Methods for Nonlinear
/// Problems, 2004): so it stays until who asks has it made anew. So does the order of elimination, while the
/// pairs of bodies are among those that it was made for.
class SlopeFactors {
 public:
  /// From here on rows are those of another problem, whose pairs of bodies are not known yet.
  void begin() { has_pairs_ = false; }
  /// Made anew from slopes between those rows, ProximalMap or InteriorRows, so soft; 0: of no proximal
  /// problem.
  /// @throws std::length_error as BlockFactors does.
  template <typename Slopes>
  void factorize(const ScaledRows<double>& rows, const Slopes& slopes, double softness);
  /// Whether there are any, for as many bodies.
  bool are_for(const ScaledRows<double>& rows) const {
    return factors_.factorized_bodies() > 0 && 3 * factors_.factorized_bodies() == rows.freedoms();
  }
  /// How soft rows were when they were made; 0: they are of no proximal problem.
  double softness() const { return softness_; }
  /// x = matrix^-1 x.
  void solve(Vector<double>& x) const { factors_.solve(x); }
  /// Bytes of all that is kept.
  std::size_t memory() const { return pairs_.bytes() + factors_.memory(); }

 private:
  void find_pairs(const ScaledRows<double>& rows);

  BlockFactors factors_;
  double softness_ = 0;
  List<std::pair<int, int>> pairs_;  // of bodies that share a row
  bool has_pairs_ = false;           // of the rows as they are
};

template <typename Slopes>
void SlopeFactors::factorize(const ScaledRows<double>& rows, const Slopes& slopes, double softness) {
  if (!has_pairs_) find_pairs(rows);
  factors_.begin(static_cast<int>(rows.freedoms() / 3), pairs_);
  factors_.set_identity(slopes.has_symmetric_slope(rows));
  slopes.for_each_slope(rows, [this](const auto& left, const auto& right, double factor) {
    for (const auto& l : left) {
      for (const auto& r : right) factors_.add(l.body, r.body, factor * l.value * r.value.transpose());
    }
  });
  factors_.factorize();
  softness_ = softness;
}

}  // namespace cairn
