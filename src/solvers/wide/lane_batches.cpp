// Floor 4. Colours, then batches.
#include "solvers/wide/lane_batches.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

#include "solvers/solver.hpp"

namespace cairn {

namespace {

const int bits_of_a_kind = 9;  // 1 + bounds, two rows of the block

std::uint64_t code_of(LaneKind kind) {
  return (static_cast<std::uint64_t>(kind.bounds) + 1) | (static_cast<std::uint64_t>(kind.normal) << 3) |
         (static_cast<std::uint64_t>(kind.second_normal) << 6);
}

LaneKind kind_of(std::uint64_t code) {
  return {.bounds = static_cast<LaneBounds>((code & 7) - 1),
          .normal = static_cast<std::uint8_t>((code >> 3) & 7),
          .second_normal = static_cast<std::uint8_t>((code >> 6) & 7)};
}

/// Of a contact with friction: a normal row and one of friction for each point.
std::uint64_t kinds_of_contact(int rows) {
  std::uint64_t kinds = 0;
  for (int i = 0; i + 1 < rows; i += 2) {
    const LaneKind friction = {.bounds = LaneBounds::friction, .normal = static_cast<std::uint8_t>(i)};
    kinds = kinds << bits_of_a_kind | code_of({.bounds = LaneBounds::lower});
    kinds = kinds << bits_of_a_kind | code_of(friction);
  }
  return kinds;
}

}  // namespace

template <Scalar Real>
void LaneBatches::arrange(const VelocityProblem<Real>& problem) {
  check_blocks(problem, "WideSequentialImpulse");
  sees_other_bodies(problem);
  of_contacts_ = false;
  leant_on_.clear();
  blocks_.clear();
  for (const RowBlock& block : problem.blocks) blocks_.push_back(seen(problem, block));
  colour();
  make_batches();
}

template <Scalar Real>
bool LaneBatches::arrange(const ContactProblem<Real>& problem) {
  bool changed =
      sees_other_bodies(*problem.problem) || !of_contacts_ || blocks_.size() != problem.contacts.size();
  blocks_.resize(problem.contacts.size());
  int next = 0;
  for (int k = 0; k < blocks_.size(); ++k) {
    const Block block = seen(problem.contacts[k], problem.manifolds[k].count, next);
    changed = changed || block != blocks_[k];
    blocks_[k] = block;
    next += block.rows;
  }
  if (!changed) return false;
  of_contacts_ = true;
  leant_on_.clear();
  colour();
  make_batches();
  for (int i = 0; i < single_rows_.size(); ++i) single_rows_[i] = i;
  return true;
}

template <Scalar Real>
bool LaneBatches::may_be_same(const VelocityProblem<Real>& problem) {
  if (sees_other_bodies(problem) || of_contacts_ || !has_same_blocks(problem)) return false;
  leant_on_before_.swap(leant_on_);
  leant_on_.clear();
  for (const int k : single_blocks_) {
    if (seen(problem, problem.blocks[k]) != blocks_[k]) return false;
  }
  return leant_on_ == leant_on_before_;
}

std::size_t LaneBatches::bytes() const {
  return blocks_.bytes() + moves_.bytes() + batches_.bytes() + colours_.bytes() + kinds_.bytes() +
         single_blocks_.bytes() + single_rows_.bytes() + coloured_.bytes() + sorted_.bytes() +
         known_kinds_.bytes() + next_of_group_.bytes() + taken_.bytes() + in_lane_.bytes();
}

template <Scalar Real>
bool LaneBatches::sees_other_bodies(const VelocityProblem<Real>& problem) {
  bool others = moves_.size() != problem.inverse_mass.size();
  moves_.resize(problem.inverse_mass.size());
  for (const BodyId body : moves_.indices()) {
    const Vec3<Real>& inverse = problem.inverse_mass[body];
    const char moves = inverse.x() != 0 || inverse.y() != 0 || inverse.z() != 0;
    others = others || moves != moves_[body];
    moves_[body] = moves;
  }
  return others;
}

template <Scalar Real>
bool LaneBatches::has_same_blocks(const VelocityProblem<Real>& problem) const {
  bool same = blocks_.size() == problem.blocks.size();
  for (int k = 0; same && k < blocks_.size(); ++k) {
    same = blocks_[k].first_row == problem.blocks[k].first && blocks_[k].rows == problem.blocks[k].count;
  }
  const RowBlock last = problem.blocks.empty() ? RowBlock{} : problem.blocks.back();
  return same && last.first + last.count == problem.row_count();
}

template <Scalar Real>
LaneBatches::Block LaneBatches::seen(const VelocityProblem<Real>& problem, const RowBlock& block) {
  Block result = {.first_row = block.first, .rows = block.count};
  if (block.count == 0) return result;  // a degenerate joint
  result.a = problem.rows[block.first].a;
  result.b = problem.rows[block.first].b;
  const bool fits = block.count <= most_lane_rows && result.a != result.b;
  bool fit_all = fits;
  for (int i = block.first; i < block.first + block.count; ++i) {
    const std::uint64_t kind = seen_kind(problem, block, i);
    fit_all = fit_all && kind != 0;
    result.kinds = result.kinds << bits_of_a_kind | kind;
  }
  if (!fit_all) result.kinds = 0;
  return result;
}

template <Scalar Real>
LaneBatches::Block LaneBatches::seen(const Contact<Real>& contact, int points, int first_row) {
  Block result = {.first_row = first_row, .rows = contact.count};
  if (contact.count == 0) return result;
  result.a = contact.a;
  result.b = contact.b;
  if (contact.friction > 0) {
    result.kinds = kinds_of_contact(2 * points);
  } else {
    for (int i = 0; i < points; ++i) {
      result.kinds = result.kinds << bits_of_a_kind | code_of({.bounds = LaneBounds::lower});
    }
  }
  return result;
}

/// 0: it fits into no lane.
template <Scalar Real>
std::uint64_t LaneBatches::seen_kind(const VelocityProblem<Real>& problem, const RowBlock& block, int i) {
  const ConstraintRow<Real>& row = problem.rows[i];
  const ConstraintRow<Real>& first = problem.rows[block.first];
  LaneKind kind = {.bounds = lane_bounds(row.bounds)};
  bool fits = row.extra_count == 0 && row.a == first.a && row.b == first.b;
  if (!row.bounds.is_friction()) return fits ? code_of(kind) : 0;

  // Lanes take for granted that a normal impulse is clamped first, and never below 0.
  const auto lean = [&](int normal) {
    if (normal < block.first || normal >= block.first + block.count) leant_on_.push_back(normal);
    fits = fits && normal >= block.first && normal < i && problem.rows[normal].bounds.is_unilateral();
    return static_cast<std::uint8_t>((normal - block.first) & 7);
  };
  kind.normal = lean(row.bounds.normal_row);
  if (kind.bounds == LaneBounds::friction_of_two) kind.second_normal = lean(row.bounds.second_normal_row);
  return fits && !(row.bounds.disc > 0) ? code_of(kind) : 0;
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
  coloured_.clear();
  for (int k = 0; k < blocks_.size(); ++k) {
    const Block& block = blocks_[k];
    if (block.kinds == 0 || in_lane_[k] == 0) continue;
    const std::uint64_t taken =
        (moves_[block.a] != 0 ? taken_[block.a] : 0) | (moves_[block.b] != 0 ? taken_[block.b] : 0);
    const int colour = std::countr_one(taken);
    if (colour == 64) continue;
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
  next_of_group_.assign(64 * known_kinds_.size() + 1, 0);
  for (const Coloured& each : coloured_) ++next_of_group_[group_of(each) + 1];
  std::partial_sum(next_of_group_.begin(), next_of_group_.end(), next_of_group_.begin());
  sorted_.resize(coloured_.size());
  for (const Coloured& each : coloured_) sorted_[next_of_group_[group_of(each)]++] = each;
  coloured_.swap(sorted_);
}

void LaneBatches::make_batches() {
  batches_.clear();
  colours_.clear();
  kinds_.clear();
  single_blocks_.clear();
  single_rows_.clear();
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
  for (int k = 0; k < blocks_.size(); ++k) {
    if (in_lane_[k] != 0) continue;
    single_blocks_.push_back(k);
    for (int i = 0; i < blocks_[k].rows; ++i) single_rows_.push_back(blocks_[k].first_row + i);
  }
}

/// Whatever their kinds: neighbours in the problem are near each other in every colour, and so are the bodies
/// that a thread finds in its cache.
void LaneBatches::order_by_place() {
  for (int k = 0; k + 1 < colours_.size(); ++k) {
    std::sort(
        batches_.begin() + colours_[k], batches_.begin() + colours_[k + 1],
        [](const LaneBatch& one, const LaneBatch& other) { return one.block_row[0] < other.block_row[0]; });
  }
}

void LaneBatches::add_batch(int first, int last) {
  const Block& model = blocks_[coloured_[first].block];
  LaneBatch batch = {.first_row = lane_rows_,
                     .rows = model.rows,
                     .is_contact = model.kinds == kinds_of_contact(model.rows),
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
  for (int i = model.rows - 1; i >= 0; --i)
    kinds_.push_back(kind_of(model.kinds >> (bits_of_a_kind * i) & 1023));
  lane_rows_ += model.rows;
  couplings_ += model.rows * (model.rows - 1) / 2;
  batches_.push_back(batch);
}

template bool LaneBatches::arrange(const ContactProblem<float>&);
template bool LaneBatches::arrange(const ContactProblem<double>&);
template bool LaneBatches::arrange(const ContactProblem<long double>&);
template void LaneBatches::arrange(const VelocityProblem<float>&);
template bool LaneBatches::may_be_same(const VelocityProblem<float>&);
template void LaneBatches::arrange(const VelocityProblem<double>&);
template bool LaneBatches::may_be_same(const VelocityProblem<double>&);
template void LaneBatches::arrange(const VelocityProblem<long double>&);
template bool LaneBatches::may_be_same(const VelocityProblem<long double>&);

}  // namespace cairn
