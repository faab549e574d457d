// Floor 4. Colours for blocks.
#include <cairn/solvers/wide/lane_colouring.hpp>

#include <algorithm>
#include <bit>
#include <numeric>

namespace cairn {

namespace {

constexpr int most_colours = 64;

/// The first colour from this one on that is not taken, going round after the last of so many; where all of
/// those are taken, the first of all that is free.
int free_colour(std::uint64_t taken, int from, int colours) {
  for (const int first : {from, 0}) {
    const int colour = first + std::countr_one(taken >> first);
    if (colour < colours) return colour;
  }
  return std::countr_one(taken);
}

}  // namespace

std::size_t LaneColouring::bytes() const {
  return coloured_.bytes() + sorted_.bytes() + known_kinds_.bytes() + next_of_group_.bytes() +
         taken_.bytes() + next_level_.bytes();
}

const List<ColouredBlock>& LaneColouring::colour(const List<LaneBlock>& blocks, const PerBody<char>& moves,
                                                 const List<char>& may_lie) {
  taken_.assign(moves.size(), 0);
  next_level_.assign(moves.size(), 0);
  const int colours = std::clamp(blocks.size() / lane_count, 1, most_colours);
  coloured_.clear();
  for (int k = 0; k < blocks.size(); ++k) {
    const LaneBlock& block = blocks[k];
    if (block.kinds == 0 || may_lie[k] == 0) continue;
    const std::uint64_t taken =
        (moves[block.a] != 0 ? taken_[block.a] : 0) | (moves[block.b] != 0 ? taken_[block.b] : 0);
    const int level = std::max(moves[block.a] != 0 ? next_level_[block.a] : 0,
                               moves[block.b] != 0 ? next_level_[block.b] : 0);
    const int colour = free_colour(taken, level % colours, colours);
    if (colour == most_colours) continue;
    next_level_[block.a] = next_level_[block.b] = level + 1 + (colour - level % colours + colours) % colours;
    const std::uint64_t bit = std::uint64_t{1} << colour;
    taken_[block.a] |= bit;
    taken_[block.b] |= bit;
    coloured_.push_back({colour, block.kinds, k});
  }
  sort();
  return coloured_;
}

/// Colour by colour, and there kinds by kinds; what is of the same lies in the order of blocks as it is.
void LaneColouring::sort() {
  known_kinds_.clear();
  for (const ColouredBlock& each : coloured_) {
    const auto place = std::lower_bound(known_kinds_.begin(), known_kinds_.end(), each.kinds);
    if (place == known_kinds_.end() || *place != each.kinds) known_kinds_.insert(place, each.kinds);
  }
  const auto group_of = [&](const ColouredBlock& each) {
    const auto place = std::lower_bound(known_kinds_.begin(), known_kinds_.end(), each.kinds);
    return each.colour * known_kinds_.size() + static_cast<int>(place - known_kinds_.begin());
  };
  next_of_group_.assign(most_colours * known_kinds_.size() + 1, 0);
  for (const ColouredBlock& each : coloured_) ++next_of_group_[group_of(each) + 1];
  std::partial_sum(next_of_group_.begin(), next_of_group_.end(), next_of_group_.begin());
  sorted_.resize(coloured_.size());
  for (const ColouredBlock& each : coloured_) sorted_[next_of_group_[group_of(each)]++] = each;
  coloured_.swap(sorted_);
}

}  // namespace cairn
