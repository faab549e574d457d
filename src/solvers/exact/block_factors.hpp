// Floor 4. LU factors of a sparse matrix of 3 x 3 blocks, one row of blocks a body.
#pragma once

#include <Eigen/Core>
#include <utility>

#include "solvers/system_matrix.hpp"
#include "math/list.hpp"

namespace cairn {

/// For matrices whose blocks (i, j) and (j, i) are there together: where bodies i and j share a row. Bodies
/// are eliminated in the order of minimum degree (W. Tinney, J. Walker, Direct solutions of sparse network
/// equations, 1967), which is found anew only where the pairs have changed. There are no pivots between
/// blocks: for a positive definite matrix none are needed, and for another one the answer may have lost
/// digits, or not be finite, so that who asks must look at it.
///
/// Cost: with d neighbours left to a body when it is eliminated, 27 d^2 multiply-adds. A chain or a stack has
/// d = 1: linear in bodies. Memory: 18 d numbers a body.
template <Scalar Real>
class BlockFactors {
 public:
  /// Above so many pairs, those that elimination adds among them, the factors would take 300 MB in double.
  static constexpr int max_pairs = 2'000'000;

  /// What one body has to do with another, or with itself.
  using Block = Eigen::Matrix<Real, 3, 3>;

  /// The bodies, and the pairs (lower, higher) of those that share a row, sorted and each once.
  /// @throws std::length_error for more than max_pairs pairs: before the factors are allocated.
  void begin(int bodies, const List<std::pair<int, int>>& pairs);
  /// The identity, to which blocks are added.
  void set_identity();
  /// The block of two bodies that share a row, or of one.
  Block& at(int row_body, int column_body);
  /// Replaces the matrix by its factors.
  void factorize();
  /// x = matrix^-1 x.
  void solve(Vector<Real>& x) const;
  /// Bytes of the factors.
  std::size_t memory() const;

 private:
  void eliminate(int bodies, const List<std::pair<int, int>>& pairs);
  int entry(int place, int later_place) const;

  int bodies_ = 0;
  List<std::pair<int, int>> pairs_;
  List<int> place_;       // of each body in the order of elimination
  List<int> body_;        // at each place
  List<int> first_;       // of each place in later_, and one beyond the last
  List<int> later_;       // places of the neighbours left, sorted
  List<Block> upper_;     // block (place, later), for each of later_
  List<Block> lower_;     // block (later, place)
  List<Block> diagonal_;  // for each place; its inverse once factorized
};

}  // namespace cairn
