// Floor 4. Elimination, body by body.
#include "solvers/exact/block_factors.hpp"
#include "math/list.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>

namespace cairn {

namespace {

/// Sorted, without the two that are named.
List<int> joined_neighbours(const List<int>& one, const List<int>& other, int without, int nor) {
  List<int> all;
  std::set_union(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(all));
  erase_if(all, [&](int body) { return body == without || body == nor; });
  return all;
}

void require_room(int pairs, int most) {
  if (pairs <= most) return;
  throw std::length_error("NewtonSolver: factors for more than " + std::to_string(most) +
                          " pairs of bodies are above the limit; SequentialImpulse needs memory linear in "
                          "the rows");
}

}  // namespace

template <Scalar Real>
void BlockFactors<Real>::begin(int bodies, const List<std::pair<int, int>>& pairs) {
  if (bodies == bodies_ && pairs == pairs_) return;
  bodies_ = 0;  // until all of it is known
  pairs_.clear();
  eliminate(bodies, pairs);
  bodies_ = bodies;
  pairs_ = pairs;
}

/// Which blocks there will be: a body that is eliminated joins all neighbours that it has left.
template <Scalar Real>
void BlockFactors<Real>::eliminate(int bodies, const List<std::pair<int, int>>& pairs) {
  require_room(pairs.size(), max_pairs);
  List<List<int>> neighbours(bodies);
  for (const auto& [low, high] : pairs) {
    neighbours[low].push_back(high);
    neighbours[high].push_back(low);
  }
  std::set<std::pair<int, int>> waiting;  // by degree, then by number
  for (int body = 0; body < bodies; ++body) {
    List<int>& of_body = neighbours[body];
    std::sort(of_body.begin(), of_body.end());
    waiting.emplace(of_body.size(), body);
  }
  place_.assign(bodies, 0);
  body_.clear();
  int stored = 0;
  while (!waiting.empty()) {
    const int body = waiting.begin()->second;
    waiting.erase(waiting.begin());
    place_[body] = body_.size();
    body_.push_back(body);
    const List<int>& left = neighbours[body];
    require_room(stored += left.size(), max_pairs);
    for (const int other : left) {
      List<int>& of_other = neighbours[other];
      waiting.erase({of_other.size(), other});
      of_other = joined_neighbours(of_other, left, body, other);
      waiting.emplace(of_other.size(), other);
    }
  }
  first_.assign(1, 0);
  later_.clear();
  for (const int body : body_) {
    const int start = later_.size();
    for (const int other : neighbours[body]) later_.push_back(place_[other]);
    std::sort(later_.begin() + start, later_.end());
    first_.push_back(later_.size());
  }
  upper_.resize(later_.size());
  lower_.resize(later_.size());
  diagonal_.resize(bodies);
}

template <Scalar Real>
void BlockFactors<Real>::set_identity() {
  for (Block& block : upper_) block.setZero();
  for (Block& block : lower_) block.setZero();
  for (Block& block : diagonal_) block.setIdentity();
}

template <Scalar Real>
int BlockFactors<Real>::entry(int at, int later_place) const {
  const auto begin = later_.begin() + first_[at];
  const auto end = later_.begin() + first_[at + 1];
  const auto found = std::lower_bound(begin, end, later_place);
  assert(found != end && *found == later_place);
  return static_cast<int>(found - later_.begin());
}

template <Scalar Real>
typename BlockFactors<Real>::Block& BlockFactors<Real>::at(int row_body, int column_body) {
  const int row = place_[row_body];
  const int column = place_[column_body];
  if (row == column) return diagonal_[row];
  return row < column ? upper_[entry(row, column)] : lower_[entry(column, row)];
}

template <Scalar Real>
void BlockFactors<Real>::factorize() {
  for (int k = 0; k < diagonal_.size(); ++k) {
    const Block inverse = diagonal_[k].inverse();
    diagonal_[k] = inverse;
    for (int e = first_[k]; e < first_[k + 1]; ++e) {
      const Block scaled = lower_[e] * inverse;
      lower_[e] = scaled;
    }
    for (int e = first_[k]; e < first_[k + 1]; ++e) {
      const int i = later_[e];
      diagonal_[i].noalias() -= lower_[e] * upper_[e];
      int target = first_[i];  // what is left beside k is left beside i as well
      for (int f = e + 1; f < first_[k + 1]; ++f) {
        while (later_[target] != later_[f]) ++target;
        upper_[target].noalias() -= lower_[e] * upper_[f];
        lower_[target].noalias() -= lower_[f] * upper_[e];
      }
    }
  }
}

template <Scalar Real>
void BlockFactors<Real>::solve(Vector<Real>& x) const {
  const auto part = [this, &x](int place) { return x.template segment<3>(3 * body_[place]); };
  for (int k = 0; k < diagonal_.size(); ++k) {
    const Eigen::Matrix<Real, 3, 1> known = part(k);
    for (int e = first_[k]; e < first_[k + 1]; ++e) part(later_[e]) -= lower_[e] * known;
  }
  for (int k = diagonal_.size(); k-- > 0;) {
    Eigen::Matrix<Real, 3, 1> rest = part(k);
    for (int e = first_[k]; e < first_[k + 1]; ++e) rest -= upper_[e] * part(later_[e]);
    part(k) = diagonal_[k] * rest;
  }
}

template <Scalar Real>
std::size_t BlockFactors<Real>::memory() const {
  return upper_.bytes() + lower_.bytes() + diagonal_.bytes();
}

template class BlockFactors<double>;
template class BlockFactors<long double>;

}  // namespace cairn
