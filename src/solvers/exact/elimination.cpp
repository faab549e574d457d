// Floor 4. An order by approximate minimum degree, and the pairs that elimination adds.
#include <cairn/solvers/exact/elimination.hpp>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <string>

namespace cairn {

namespace {

void require_room(int pairs) {
  if (pairs <= Elimination::max_pairs) return;
  throw std::length_error("NewtonSolver: factors for more than " + std::to_string(Elimination::max_pairs) +
                          " pairs of bodies are above the limit; SequentialImpulse needs memory linear in "
                          "the rows");
}

}  // namespace

bool Elimination::begin(int bodies, const List<std::pair<int, int>>& pairs) {
  if (holds(bodies, pairs)) return false;
  require_room(pairs.size());
  pairs_ = pairs;
  body_.clear();  // holds nothing until all of it is known
  order(bodies);
  find_later();
  find_earlier();
  return true;
}

bool Elimination::holds(int bodies, const List<std::pair<int, int>>& pairs) const {
  return bodies == body_.size() && 2 * pairs.size() >= pairs_.size() &&
         std::includes(pairs_.begin(), pairs_.end(), pairs.begin(), pairs.end());
}

void Elimination::order(int bodies) {
  List<Eigen::Triplet<int>> entries;
  for (int body = 0; body < bodies; ++body) entries.emplace_back(body, body, 1);
  for (const auto& [low, high] : pairs_) entries.emplace_back(high, low, 1);
  Eigen::SparseMatrix<int> graph(bodies, bodies);
  graph.setFromTriplets(entries.begin(), entries.end());
  Eigen::AMDOrdering<int>::PermutationType order;
  Eigen::AMDOrdering<int>()(graph.selfadjointView<Eigen::Lower>(), order);
  body_.assign(order.indices().begin(), order.indices().end());
  place_.resize(bodies);
  for (int place = 0; place < bodies; ++place) place_[body_[place]] = place;
}

/// A body that is eliminated joins all neighbours that it has left: the first of them takes them over.
void Elimination::find_later() {
  const int count = body_.size();
  List<List<int>> joined(count);  // later places that each one was given
  for (const auto& [low, high] : pairs_) {
    const auto [first, second] = std::minmax(place_[low], place_[high]);
    joined[first].push_back(second);
  }
  first_.assign(1, 0);
  later_.clear();
  for (int place = 0; place < count; ++place) {
    List<int>& of_place = joined[place];
    std::sort(of_place.begin(), of_place.end());
    of_place.erase(std::unique(of_place.begin(), of_place.end()), of_place.end());
    later_.insert(later_.end(), of_place.begin(), of_place.end());
    first_.push_back(later_.size());
    if (later_.size() > max_pairs) body_.clear();
    require_room(later_.size());
    if (of_place.empty()) continue;
    List<int>& next = joined[of_place.front()];
    next.insert(next.end(), of_place.begin() + 1, of_place.end());
    of_place = {};
  }
}

void Elimination::find_earlier() {
  const int count = body_.size();
  first_earlier_.assign(count + 1, 0);
  for (const int place : later_) ++first_earlier_[place + 1];
  for (int place = 0; place < count; ++place) first_earlier_[place + 1] += first_earlier_[place];
  earlier_.resize(later_.size());
  List<int> next(first_earlier_.begin(), first_earlier_.end());
  for (int place = 0; place < count; ++place) {
    for (int pair = first_[place]; pair < first_[place + 1]; ++pair) {
      earlier_[next[later_[pair]]++] = {place, pair};
    }
  }
}

int Elimination::pair_of(int place, int later_place) const {
  const auto begin = later_.begin() + first_[place];
  const auto end = later_.begin() + first_[place + 1];
  const auto found = std::lower_bound(begin, end, later_place);
  assert(found != end && *found == later_place);
  return static_cast<int>(found - later_.begin());
}

std::size_t Elimination::memory() const {
  return pairs_.bytes() + place_.bytes() + body_.bytes() + first_.bytes() + later_.bytes() +
         first_earlier_.bytes() + earlier_.bytes();
}

}  // namespace cairn
