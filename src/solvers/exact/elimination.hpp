// Floor 4. In which order bodies are eliminated, and which of them have to do with each other then.
#pragma once

#include <cstddef>
#include <utility>

#include <cairn/math/list.hpp>

namespace cairn {

/// What elimination needs to know before any number: bodies in an approximate minimum degree order (P.
/// Amestoy, T. Davis, I. Duff, An approximate minimum degree ordering algorithm, 1996), and for each the
/// neighbours that it has left when its turn comes. Bodies are eliminated, not their 3 n velocities: a ninth
/// of the graph.
class Elimination {
 public:
  /// Above so many pairs, those that elimination adds among them, factors would take 300 MB in double.
  static constexpr int max_pairs = 2'000'000;

  /// One pair of a body and a neighbour left to it.
  struct Earlier {
    int place = 0;  // of the body that is eliminated first
    int pair = 0;   // its place in later()
  };

  /// The bodies, and the pairs (lower, higher) of those that share a row, sorted and each once. What is known
  /// already is kept while the pairs are among those known, and not less than half of them.
  /// @returns whether it was made anew. @throws std::length_error for more than max_pairs pairs.
  bool begin(int bodies, const List<std::pair<int, int>>& pairs);

  /// How many bodies there are.
  int bodies() const { return body_.size(); }
  /// How many pairs there are.
  int pairs() const { return later_.size(); }
  /// The place of a body in the order.
  int place(int body) const { return place_[body]; }
  /// The body at a place.
  int body(int place) const { return body_[place]; }
  /// Where the pairs of a place begin in later(); they end where those of the next begin.
  int first(int place) const { return first_[place]; }
  /// The place of the second of a pair: increasing among those of one place.
  int later(int pair) const { return later_[pair]; }
  /// The pairs of which the body at a place is the second.
  Span<const Earlier> earlier(int place) const {
    return {earlier_.data() + first_earlier_[place], first_earlier_[place + 1] - first_earlier_[place]};
  }
  /// The pair of two places, the first of which is eliminated first. They must have to do with each other.
  int pair_of(int place, int later_place) const;
  /// Bytes of all this.
  std::size_t memory() const;

 private:
  bool holds(int bodies, const List<std::pair<int, int>>& pairs) const;
  void order(int bodies);
  void find_later();
  void find_earlier();

  List<std::pair<int, int>> pairs_;  // as given
  List<int> place_;                  // of each body
  List<int> body_;                   // at each place
  List<int> first_;                  // of each place in later_, and one beyond the last
  List<int> later_;
  List<int> first_earlier_;
  List<Earlier> earlier_;
};

}  // namespace cairn
