// Floor 4. Rows become a matrix of blocks.
#include <cairn/solvers/exact/slope_factors.hpp>

#include <algorithm>

namespace cairn {

void SlopeFactors::find_pairs(const ScaledRows<double>& rows) {
  pairs_.clear();
  for (const auto& row : rows.rows()) {
    for (const auto& left : rows.terms_of(row)) {
      for (const auto& right : rows.terms_of(row)) {
        const std::pair pair(left.body, right.body);
        if (pair.first < pair.second && (pairs_.empty() || pairs_.back() != pair)) pairs_.push_back(pair);
      }
    }
  }
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  has_pairs_ = true;
}

}  // namespace cairn
