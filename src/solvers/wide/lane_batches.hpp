// Floor 4. Which block of rows lies in which lane.
#pragma once

#include <cstdint>

#include "constraints/row.hpp"
#include "math/list.hpp"
#include "solvers/wide/lane_data.hpp"

namespace cairn {

/// Blocks in colours: those of one colour share no body that can move, and are solved at the same time where
/// they have rows of the same kinds. Colours are given greedily, each block as written taking the first of 64
/// that is free at both its bodies. Rows go one by one if their block has more than two bodies, more than 6
/// rows, a disc of friction or friction that leans on another block; or if it finds no colour, or nobody of
/// its colour and kinds. All of it is a function of the problem: never of those before it.
class LaneBatches {
 public:
  /// For this problem; keeps what it has where bodies and kinds are still the same. Returns whether they are.
  /// @throws std::invalid_argument unless the problem's blocks follow each other and cover all rows.
  template <Scalar Real>
  bool arrange(const VelocityProblem<Real>& problem);

  /// Colour by colour.
  const List<LaneBatch>& batches() const { return batches_; }
  /// Of the rows of all batches.
  const List<LaneKind>& kinds() const { return kinds_; }
  /// The rows of the problem that go one by one, as written.
  const List<int>& single_rows() const { return single_rows_; }
  /// Rows in all batches.
  int lane_rows() const { return lane_rows_; }
  /// Pairs of rows in the blocks of all batches.
  int couplings() const { return couplings_; }
  /// What it takes up [bytes].
  std::size_t bytes() const;

 private:
  /// All that the colouring looks at.
  struct Block {
    int first_row = 0;
    int rows = 0;
    BodyId a = {};
    BodyId b = {};
    std::uint64_t kinds = 0;  // 10 bits a row; 0: its rows go one by one
    bool operator==(const Block&) const = default;
  };
  /// A block that is to lie in a lane.
  struct Coloured {
    int colour = 0;
    int block = 0;
  };

  template <Scalar Real>
  Block seen(const VelocityProblem<Real>& problem, const RowBlock& block);
  template <Scalar Real>
  std::uint64_t seen_kind(const VelocityProblem<Real>& problem, const RowBlock& block, int row);
  template <Scalar Real>
  bool sees_other_bodies(const VelocityProblem<Real>& problem);
  void single_out_what_is_leant_on();
  void colour();
  void make_batches();
  void add_batch(int first, int last);

  List<Block> blocks_;
  PerBody<char> moves_;  // whether a body can move
  List<int> leant_on_;   // rows that friction of another block leans on
  List<LaneBatch> batches_;
  List<LaneKind> kinds_;
  List<int> single_rows_;
  int lane_rows_ = 0;
  int couplings_ = 0;
  List<int> leant_on_before_;     // scratch
  List<Coloured> coloured_;       // scratch
  List<char> in_lane_;            // scratch, for each block
  PerBody<std::uint64_t> taken_;  // scratch: the colours at a body, a bit each
};

}  // namespace cairn
