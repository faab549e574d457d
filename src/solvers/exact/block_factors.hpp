// Floor 4. Factors of a sparse matrix of 3 x 3 blocks, one row of blocks a body.
#pragma once

#include <Eigen/Core>
#include <utility>

#include <cairn/solvers/exact/elimination.hpp>
#include <cairn/solvers/system_matrix.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// For matrices whose blocks (i, j) and (j, i) are there together: where bodies i and j share a row. A
/// symmetric matrix becomes L D L^T by blocks, another one L U with twice the work. The order is that of
/// Elimination. There are no pivots between blocks: for a positive definite matrix none are needed, and for
/// another one the answer may have lost digits, or not be finite, so that who asks must look at it.
///
/// Cost: with d neighbours left to a body when it is eliminated, 27 d^2 multiply-adds, or half of them. A
/// chain or a stack has d = 1: linear in bodies. Memory: 18 d numbers a body, and 3 d integers.
class BlockFactors {
 public:
  /// What one body has to do with another, or with itself.
  using Block = Eigen::Matrix<double, 3, 3>;

  /// The bodies, and the pairs (lower, higher) of those that share a row, sorted and each once.
  /// @throws std::length_error for more than Elimination::max_pairs pairs: before factors are allocated, and
  /// with those of before gone.
  void begin(int bodies, const List<std::pair<int, int>>& pairs);
  /// The identity, to which blocks are added. What is added to it from now on is symmetric, or not.
  void set_identity(bool is_symmetric);
  /// Adds to the block of two bodies that share a row, or of one. Of a symmetric matrix both (i, j) and
  /// (j, i) have to be added; one of them is passed over.
  void add(int row_body, int column_body, const Block& more);
  /// Replaces the matrix by its factors.
  void factorize();
  /// Of how many bodies there are factors; 0: there are none.
  int factorized_bodies() const { return is_factorized_ ? elimination_.bodies() : 0; }
  /// x = matrix^-1 x.
  void solve(Vector<double>& x) const;
  /// Bytes of the factors and of their order.
  std::size_t memory() const;

 private:
  void take_out(int place);
  void scale(int place);

  Elimination elimination_;
  bool is_symmetric_ = false;
  bool is_factorized_ = false;
  List<Block> upper_;     // block (place, later), for each pair
  List<Block> lower_;     // block (later, place)
  List<Block> diagonal_;  // for each place; its inverse once factorized
  List<int> pair_at_;     // of the place that is eliminated, with each later one
};

}  // namespace cairn
