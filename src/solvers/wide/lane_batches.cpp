// Floor 4. From colours to batches.
#include <cairn/solvers/wide/lane_batches.hpp>

#include <algorithm>

#include <cairn/solvers/wide/lane_kinds.hpp>

namespace cairn {

void LaneSingles::clear() {
  blocks.clear();
  rows.clear();
  contacts.clear();
}

void LaneSingles::add(int number, const LaneBlock& block) {
  blocks.push_back(number);
  for (int i = 0; i < block.rows; ++i) rows.push_back(block.first_row + i);
}

std::size_t LaneBatches::bytes() const {
  return blocks_.bytes() + moves_.bytes() + batches_.bytes() + colours_.bytes() + kinds_.bytes() +
         singles_.bytes() + in_lane_.bytes() + colouring_.bytes();
}

/// Who leans on a row of another block reads its impulse in the problem: neither lies in a lane.
void LaneBatches::single_out_what_is_leant_on() {
  in_lane_.assign(blocks_.size(), 1);
  for (const int row : leant_on_) {
    const auto after = std::upper_bound(blocks_.begin(), blocks_.end(), row,
                                        [](int i, const LaneBlock& block) { return i < block.first_row; });
    const int block = static_cast<int>(after - blocks_.begin()) - 1;
    if (block >= 0) in_lane_[block] = 0;
  }
}

void LaneBatches::make_batches() {
  single_out_what_is_leant_on();
  const List<ColouredBlock>& coloured = colouring_.colour(blocks_, moves_, in_lane_);
  batches_.clear();
  colours_.clear();
  kinds_.clear();
  singles_.clear();
  counts_ = {};
  in_lane_.assign(blocks_.size(), 0);
  int first = 0;
  while (first < coloured.size()) {
    const ColouredBlock& begin = coloured[first];
    if (first == 0 || begin.colour != coloured[first - 1].colour) colours_.push_back(batches_.size());
    int last = first + 1;
    while (last < coloured.size() && last < first + lane_count && coloured[last].colour == begin.colour &&
           coloured[last].kinds == begin.kinds) {
      ++last;
    }
    if (last > first + 1)
      add_batch({&coloured[first], last - first});  // one block is solved as fast without lanes
    first = last;
  }
  colours_.push_back(batches_.size());
  order_by_place();
  for (LaneBatch& batch : batches_) {
    for (int lane = 0; batch.contacts >= 0 && lane < lane_count; ++lane) batch.block[lane] -= joints_;
  }
  for (int k = 0; k < blocks_.size(); ++k) {
    if (in_lane_[k] != 0) continue;
    singles_.add(k, blocks_[k]);
    if (of_contacts_ && k >= joints_) singles_.contacts.push_back(k - joints_);
  }
}

/// Whatever their kinds: neighbours in the problem are near each other in every colour, and so are the bodies
/// that a sweep finds in the cache.
void LaneBatches::order_by_place() {
  for (int k = 0; k + 1 < colours_.size(); ++k) {
    std::sort(batches_.begin() + colours_[k], batches_.begin() + colours_[k + 1],
              [](const LaneBatch& one, const LaneBatch& other) { return one.block[0] < other.block[0]; });
  }
}

void LaneBatches::add_batch(Span<const ColouredBlock> blocks) {
  const LaneBlock& model = blocks_[blocks[0].block];
  const std::uint64_t kinds = model.kinds & ~contact_bit;
  LaneBatch batch = {.first_row = counts_.rows,
                     .rows = model.rows,
                     .is_contact = kinds == kinds_of_contact(model.rows),
                     .contacts = of_contacts_ && model.of_contact ? counts_.contact_batches++ : -1,
                     .first_kind = kinds_.size(),
                     .first_coupling = counts_.couplings,
                     .used = blocks.size(),
                     .moves_a = 0,
                     .moves_b = 0,
                     .body_a = {},
                     .body_b = {},
                     .block_row = {},
                     .block = {}};
  for (int lane = 0; lane < lane_count; ++lane) {
    const bool is_used = lane < batch.used;
    const int number = blocks[is_used ? lane : 0].block;
    const LaneBlock& block = blocks_[number];
    batch.body_a[lane] = is_used ? block.a.index : moves_.size();
    batch.body_b[lane] = is_used ? block.b.index : moves_.size();
    batch.block_row[lane] = block.first_row;
    batch.block[lane] = number;
    if (!is_used) continue;
    in_lane_[number] = 1;
    batch.moves_a |= moves_[block.a] != 0 ? 1u << lane : 0u;
    batch.moves_b |= moves_[block.b] != 0 ? 1u << lane : 0u;
  }
  for (int i = model.rows - 1; i >= 0; --i) kinds_.push_back(kind_of(kinds >> (bits_of_a_kind * i) & 511));
  counts_.rows += model.rows;
  counts_.couplings += model.rows * (model.rows - 1) / 2;
  batches_.push_back(batch);
}

}  // namespace cairn
