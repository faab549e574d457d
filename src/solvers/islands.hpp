// Floor 4. The islands of a problem.
#pragma once

#include <cstddef>

#include <cairn/constraints/row.hpp>
#include <cairn/dynamics/connected_bodies.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// One island as a problem of its own, in double, without blocks and contacts.
template <Scalar Real>
struct IslandProblem {
  List<int> rows = {};                   // of each of its rows, the number in the whole problem
  List<BodyId> bodies = {};              // of each of its bodies likewise, with those that cannot be moved
  VelocityProblem<double> problem = {};  // of those

  /// Takes the biases, softness, impulses and velocities of the whole: all that differs between two problems
  /// of one number.
  void take_again(const VelocityProblem<Real>& whole);
  /// Gives the whole its impulses and velocities.
  void give(VelocityProblem<Real>& whole) const;
  /// Bytes of all this.
  std::size_t memory() const;
};

/// Finds the islands: rows that bodies connect with each other. A body that cannot be moved connects nothing,
/// and a row between two of those is in no island.
class Islands {
 public:
  /// Those of a problem with all its rows, in the order of their lowest bodies that can be moved.
  template <Scalar Real>
  void find(const VelocityProblem<Real>& problem);
  /// How many there are.
  int count() const { return first_.size(); }
  /// Whether there is one, and nothing beside it.
  bool are_one() const { return are_one_; }
  /// The lowest body of an island that can be moved.
  BodyId lowest_body(int island) const { return lowest_[island]; }
  /// Makes it a problem, whose memory is used again.
  template <Scalar Real>
  void copy(int island, const VelocityProblem<Real>& whole, IslandProblem<Real>& result);

 private:
  template <typename Problem>
  BodyId lowest_of_row(const Problem& problem, int row);
  template <typename Problem>
  void sort_rows(const Problem& problem);

  ConnectedBodies connected_;
  PerBody<int> number_;  // of each body in the island that is copied; below 0: none
  List<BodyId> of_row_;  // of each row, the lowest of its island; below 0: nothing that it pushes can move
  PerBody<int> next_;    // of each lowest body, the place of its next row
  List<BodyId> lowest_;  // of each island
  List<int> first_;      // of each island, in rows_
  List<int> rows_;       // island by island
  bool are_one_ = false;
};

}  // namespace cairn
