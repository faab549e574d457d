// Floor 4. Which blocks of rows can be solved at the same time.
#pragma once

#include <cstdint>

#include <cairn/math/list.hpp>
#include <cairn/dynamics/body.hpp>
#include <cairn/solvers/wide/lane_data.hpp>

namespace cairn {

/// All of a block that colouring looks at.
struct LaneBlock {
  int first_row = 0;        // of the problem
  int rows = 0;             // of the block
  BodyId a = {};            // the first body
  BodyId b = {};            // the second body
  bool of_contact = false;  // that needs no rows
  std::uint64_t kinds = 0;  // 9 bits a row, and one for such a contact; 0: its rows go one by one
  /// Member by member.
  bool operator==(const LaneBlock&) const = default;
};

/// A block that is to lie in a lane.
struct ColouredBlock {
  int colour = 0;           // from 0
  std::uint64_t kinds = 0;  // as in its block
  int block = 0;            // its number
};

/// Gives blocks colours: those of one colour share no body that can move. As many colours as fill a batch
/// each, 64 at most, are gone through over and over: each block as written takes the first colour that is
/// free at both its bodies, behind those of the blocks before it there. So a sweep, colour by colour, passes
/// impulses on as one in the order of the blocks does, through as many bodies as there are colours. Owns
/// scratch memory only.
class LaneColouring {
 public:
  /// Colour by colour, and there kinds by kinds; what is of the same lies in the order of blocks as it is.
  /// Left out are blocks that may not lie in a lane, those without kinds, and what finds no colour. Until the
  /// next call.
  const List<ColouredBlock>& colour(const List<LaneBlock>& blocks, const PerBody<char>& moves,
                                    const List<char>& may_lie);
  /// What it takes up [bytes].
  std::size_t bytes() const;

 private:
  void sort();

  List<ColouredBlock> coloured_;
  List<ColouredBlock> sorted_;
  List<std::uint64_t> known_kinds_;  // ascending
  List<int> next_of_group_;          // where the next block of a colour and of these kinds goes
  PerBody<std::uint64_t> taken_;     // the colours at a body, a bit each
  PerBody<int> next_level_;          // how many blocks follow each other up to here
};

}  // namespace cairn
