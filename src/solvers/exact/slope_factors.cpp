// Floor 4. Rows become a matrix of blocks.
#include "solvers/exact/slope_factors.hpp"

#include <algorithm>

namespace cairn {

void SlopeFactors::find_pairs(const ProximalRows<double>& rows) {
  pairs_.clear();
  rows.for_each_terms([this](const auto& terms) {
    for (const auto& left : terms) {
      for (const auto& right : terms) {
        const std::pair pair(left.body, right.body);
        if (pair.first < pair.second && (pairs_.empty() || pairs_.back() != pair)) pairs_.push_back(pair);
      }
    }
  });
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  has_pairs_ = true;
}

}  // namespace cairn
