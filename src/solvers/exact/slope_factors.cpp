// Floor 4. Rows become a matrix of blocks.
#include "solvers/exact/slope_factors.hpp"

#include <algorithm>

namespace cairn {

template <Scalar Real>
void SlopeFactors<Real>::factorize(const ProximalRows<Real>& rows) {
  if (!has_pairs_) find_pairs(rows);
  factors_.begin(static_cast<int>(rows.freedoms() / 3), pairs_);
  factors_.set_identity(rows.has_symmetric_slope());
  rows.for_each_slope([this](const auto& left, const auto& right, Real factor) {
    for (const auto& l : left) {
      for (const auto& r : right) factors_.add(l.body, r.body, factor * l.value * r.value.transpose());
    }
  });
  factors_.factorize();
  softness_ = rows.softness();
}

template <Scalar Real>
void SlopeFactors<Real>::find_pairs(const ProximalRows<Real>& rows) {
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

template class SlopeFactors<double>;
template class SlopeFactors<long double>;

}  // namespace cairn
