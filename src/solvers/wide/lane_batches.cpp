// Floor 4. Colours, then batches.
#include "solvers/wide/lane_batches.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

#include "solvers/wide/lane_kinds.hpp"

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

std::size_t LaneBatches::bytes() const {
  return blocks_.bytes() + moves_.bytes() + batches_.bytes() + colours_.bytes() + kinds_.bytes() +
         single_blocks_.bytes() + single_rows_.bytes() + single_contacts_.bytes() + coloured_.bytes() +
         sorted_.bytes() + known_kinds_.bytes() + next_of_group_.bytes() + taken_.bytes() + next_level_.bytes() + in_lane_.bytes();
}

/// Who leans on a row of another block reads its impulse in the problem: neither lies in a lane.
void LaneBatches::single_out_what_is_leant_on() {
  in_lane_.assign(blocks_.size(), 1);
  for (const int row : leant_on_) {
    const auto after = std::upper_bound(blocks_.begin(), blocks_.end(), row,
                                        [](int i, const Block& block) { return i < block.first_row; });
    const int block = static_cast<int>(after - blocks_.begin()) - 1;
    if (block >= 0) in_lane_[block] = 0;
  }
}

void LaneBatches::colour() {
  single_out_what_is_leant_on();
  taken_.assign(moves_.size(), 0);
  next_level_.assign(moves_.size(), 0);
  const int colours = std::clamp(blocks_.size() / (2 * lane_count), 1, most_colours);
  coloured_.clear();
  for (int k = 0; k < blocks_.size(); ++k) {
    const Block& block = blocks_[k];
    if (block.kinds == 0 || in_lane_[k] == 0) continue;
    const std::uint64_t taken =
        (moves_[block.a] != 0 ? taken_[block.a] : 0) | (moves_[block.b] != 0 ? taken_[block.b] : 0);
    const int level = std::max(moves_[block.a] != 0 ? next_level_[block.a] : 0,
                               moves_[block.b] != 0 ? next_level_[block.b] : 0);
    const int colour = free_colour(taken, level % colours, colours);
    if (colour == most_colours) continue;
    next_level_[block.a] = next_level_[block.b] = level + 1 + (colour - level % colours + colours) % colours;
    const std::uint64_t bit = std::uint64_t{1} << colour;
    taken_[block.a] |= bit;
    taken_[block.b] |= bit;
    coloured_.push_back({colour, block.kinds, k});
  }
  sort_by_colour();
}

/// Colour by colour, and there kinds by kinds; what is of the same lies in the order of blocks as it is.
void LaneBatches::sort_by_colour() {
  known_kinds_.clear();
  for (const Coloured& each : coloured_) {
    const auto place = std::lower_bound(known_kinds_.begin(), known_kinds_.end(), each.kinds);
    if (place == known_kinds_.end() || *place != each.kinds) known_kinds_.insert(place, each.kinds);
  }
  const auto group_of = [&](const Coloured& each) {
    const auto place = std::lower_bound(known_kinds_.begin(), known_kinds_.end(), each.kinds);
    return each.colour * known_kinds_.size() + static_cast<int>(place - known_kinds_.begin());
  };
  next_of_group_.assign(most_colours * known_kinds_.size() + 1, 0);
  for (const Coloured& each : coloured_) ++next_of_group_[group_of(each) + 1];
  std::partial_sum(next_of_group_.begin(), next_of_group_.end(), next_of_group_.begin());
  sorted_.resize(coloured_.size());
  for (const Coloured& each : coloured_) sorted_[next_of_group_[group_of(each)]++] = each;
  coloured_.swap(sorted_);
}

/// Of a problem with so many rows.
void LaneBatches::make_batches(int rows) {
  batches_.clear();
  colours_.clear();
  kinds_.clear();
  single_blocks_.clear();
  single_rows_.clear();
  single_contacts_.clear();
  contact_batches_ = 0;
  lane_rows_ = 0;
  couplings_ = 0;
  in_lane_.assign(blocks_.size(), 0);
  int first = 0;
  while (first < coloured_.size()) {
    const Coloured& begin = coloured_[first];
    if (first == 0 || begin.colour != coloured_[first - 1].colour) colours_.push_back(batches_.size());
    int last = first + 1;
    while (last < coloured_.size() && last < first + lane_count && coloured_[last].colour == begin.colour &&
           coloured_[last].kinds == begin.kinds) {
      ++last;
    }
    if (last > first + 1) add_batch(first, last);  // one block is solved as fast without lanes
    first = last;
  }
  colours_.push_back(batches_.size());
  order_by_place();
  for (LaneBatch& batch : batches_) {
    for (int lane = 0; batch.contacts >= 0 && lane < lane_count; ++lane) batch.block[lane] -= joints_;
  }
  for (int k = 0; k < blocks_.size(); ++k) {
    if (in_lane_[k] != 0) continue;
    single_blocks_.push_back(k);
    const bool has_rows = !of_contacts_ || !blocks_[k].of_contact;
    if (!has_rows) single_contacts_.push_back(k - joints_);
    for (int i = 0; i < blocks_[k].rows; ++i)
      single_rows_.push_back(has_rows ? blocks_[k].first_row + i : rows++);
  }
}

/// Whatever their kinds: neighbours in the problem are near each other in every colour, and so are the bodies
/// that a thread finds in its cache.
void LaneBatches::order_by_place() {
  for (int k = 0; k + 1 < colours_.size(); ++k) {
    std::sort(batches_.begin() + colours_[k], batches_.begin() + colours_[k + 1],
              [](const LaneBatch& one, const LaneBatch& other) { return one.block[0] < other.block[0]; });
  }
}

void LaneBatches::add_batch(int first, int last) {
  const Block& model = blocks_[coloured_[first].block];
  const std::uint64_t kinds = model.kinds & ~contact_bit;
  LaneBatch batch = {.first_row = lane_rows_,
                     .rows = model.rows,
                     .is_contact = kinds == kinds_of_contact(model.rows),
                     .contacts = of_contacts_ && model.of_contact ? contact_batches_++ : -1,
                     .first_kind = kinds_.size(),
                     .first_coupling = couplings_,
                     .used = last - first,
                     .moves_a = 0,
                     .moves_b = 0,
                     .body_a = {},
                     .body_b = {},
                     .block_row = {},
                     .block = {}};
  for (int lane = 0; lane < lane_count; ++lane) {
    const bool is_used = lane < batch.used;
    const Block& block = blocks_[coloured_[is_used ? first + lane : first].block];
    batch.body_a[lane] = is_used ? block.a.index : moves_.size();
    batch.body_b[lane] = is_used ? block.b.index : moves_.size();
    batch.block_row[lane] = block.first_row;
    batch.block[lane] = coloured_[is_used ? first + lane : first].block;
    if (!is_used) continue;
    in_lane_[coloured_[first + lane].block] = 1;
    batch.moves_a |= moves_[block.a] != 0 ? 1u << lane : 0u;
    batch.moves_b |= moves_[block.b] != 0 ? 1u << lane : 0u;
  }
  for (int i = model.rows - 1; i >= 0; --i) kinds_.push_back(kind_of(kinds >> (bits_of_a_kind * i) & 511));
  lane_rows_ += model.rows;
  couplings_ += model.rows * (model.rows - 1) / 2;
  batches_.push_back(batch);
}

}  // namespace cairn
