// Floor 4. Which block of rows lies in which lane.
#pragma once

#include <cstdint>
#include <limits>

#include <cairn/constraints/row.hpp>
#include <cairn/math/list.hpp>
#include <cairn/solvers/wide/lane_colouring.hpp>

namespace cairn {

/// What a row with these bounds compares its impulse with.
template <Scalar Real>
LaneBounds lane_bounds(const Bounds<Real>& bounds) {
  if (bounds.is_friction()) {
    return bounds.second_normal_row == Bounds<Real>::none ? LaneBounds::friction
                                                          : LaneBounds::friction_of_two;
  }
  const Real infinity = std::numeric_limits<Real>::infinity();
  if (bounds.upper != infinity) return LaneBounds::both;
  return bounds.lower == -infinity ? LaneBounds::none : LaneBounds::lower;
}

/// How much there is of something in all batches.
struct LaneCounts {
  int rows = 0;             // rows
  int couplings = 0;        // pairs of rows of one block
  int contact_batches = 0;  // batches of contacts without rows
};

/// What goes one by one, block by block.
struct LaneSingles {
  List<int> blocks = {};    // of the problem
  List<int> rows = {};      // of these blocks, written or not
  List<int> contacts = {};  // without rows, of these blocks

  /// Nothing does.
  void clear();
  /// A block of the problem does, with its rows.
  void add(int number, const LaneBlock& block);
  /// What it takes up [bytes].
  std::size_t bytes() const { return blocks.bytes() + rows.bytes() + contacts.bytes(); }
};

/// Blocks in colours (LaneColouring): those of one are solved at the same time where they have rows of the
/// same kinds. Rows go one by one if their block has more than two bodies, more than 6 rows, a disc of
/// friction or friction that leans on another block; or if it finds no colour, or nobody of its colour and
/// kinds. Contacts that need no rows lie in batches of their own. All of it is a function of the problem:
/// never of those before it.
class LaneBatches {
 public:
  /// Made anew for this problem, which has rows.
  /// @throws std::invalid_argument unless the problem's blocks follow each other and cover all rows.
  template <Scalar Real>
  void arrange(const VelocityProblem<Real>& problem);
  /// Whether arrange() would change nothing, if is_same_row() holds for all rows in lanes. It looks at no row
  /// in a lane: whoever fills lanes looks at them anyway.
  template <Scalar Real>
  bool may_be_same(const VelocityProblem<Real>& problem);
  /// Made anew for a problem whose contacts have no rows, as if they had; false: nothing has changed.
  template <Scalar Real>
  bool arrange_contacts(const VelocityProblem<Real>& problem);
  /// Whether a row of a batch still is what its lane is made for. Only where may_be_same().
  template <Scalar Real>
  bool is_same_row(const VelocityProblem<Real>& problem, const LaneBatch& batch, int number, int lane) const;

  /// Colour by colour.
  const List<LaneBatch>& batches() const { return batches_; }
  /// The first batch of each colour, and the end of the last.
  const List<int>& colours() const { return colours_; }
  /// Of the rows of all batches.
  const List<LaneKind>& kinds() const { return kinds_; }
  /// What lies in no lane.
  const LaneSingles& singles() const { return singles_; }
  /// Of all batches.
  const LaneCounts& counts() const { return counts_; }
  /// What it takes up [bytes].
  std::size_t bytes() const;

 private:
  template <Scalar Real>
  LaneBlock seen(const VelocityProblem<Real>& problem, const RowBlock& block);
  template <Scalar Real>
  static LaneBlock seen(const Contact<Real>& contact, const RowBlock& block);
  template <Scalar Real>
  std::uint64_t seen_kind(const VelocityProblem<Real>& problem, const RowBlock& block, int row);
  template <Scalar Real>
  bool sees_other_bodies(const VelocityProblem<Real>& problem);
  template <Scalar Real>
  bool has_same_blocks(const VelocityProblem<Real>& problem) const;
  void single_out_what_is_leant_on();
  void make_batches();
  void order_by_place();
  void add_batch(Span<const ColouredBlock> blocks);

  List<LaneBlock> blocks_;
  bool of_contacts_ = false;  // which had no rows
  int joints_ = 0;            // of the blocks, before those of contacts
  PerBody<char> moves_;       // whether a body can move
  List<int> leant_on_;        // rows that friction of another block leans on
  List<LaneBatch> batches_;
  List<int> colours_;
  List<LaneKind> kinds_;
  LaneSingles singles_;
  LaneCounts counts_;
  List<int> leant_on_before_;  // scratch
  List<char> in_lane_;         // scratch, for each block
  LaneColouring colouring_;
};

// Here, so that filling lanes need not call it for every row.
template <Scalar Real>
inline bool LaneBatches::is_same_row(const VelocityProblem<Real>& problem, const LaneBatch& batch, int number,
                                     int lane) const {
  const int first = batch.block_row[lane];
  const ConstraintRow<Real>& row = problem.rows[first + number];
  const Bounds<Real>& bounds = row.bounds;
  const LaneKind kind = kinds_[batch.first_kind + number];
  const bool same = row.a.index == batch.body_a[lane] && row.b.index == batch.body_b[lane] &&
                    row.extra_count == 0 && lane_bounds(bounds) == kind.bounds;
  if (kind.bounds < LaneBounds::friction) return same;
  const auto leans_on = [&](int normal, int expected) {
    return normal == first + expected && problem.rows[normal].bounds.is_unilateral();
  };
  return same && !(bounds.disc > 0) && leans_on(bounds.normal_row, kind.normal) &&
         (kind.bounds == LaneBounds::friction || leans_on(bounds.second_normal_row, kind.second_normal));
}

}  // namespace cairn
