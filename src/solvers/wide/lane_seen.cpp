// Floor 4. What colouring sees of a problem.
#include <algorithm>

#include <cairn/solvers/solver.hpp>
#include <cairn/solvers/wide/lane_batches.hpp>
#include <cairn/solvers/wide/lane_kinds.hpp>

namespace cairn {

template <Scalar Real>
void LaneBatches::arrange(const VelocityProblem<Real>& problem) {
  check_blocks(problem, "WideSequentialImpulse");
  sees_other_bodies(problem);
  of_contacts_ = false;
  leant_on_.clear();
  blocks_.clear();
  for (const RowBlock& block : problem.blocks) blocks_.push_back(seen(problem, block));
  make_batches();
}

template <Scalar Real>
bool LaneBatches::arrange_contacts(const VelocityProblem<Real>& problem) {
  const int count = problem.blocks.size(), joints = problem.joint_blocks();
  bool changed = sees_other_bodies(problem) || !of_contacts_ || joints != joints_ || blocks_.size() != count;
  blocks_.resize(count);
  leant_on_.clear();
  for (int k = 0; k < count; ++k) {
    const LaneBlock block =
        k < joints ? seen(problem, problem.blocks[k]) : seen(problem.contacts[k - joints], problem.blocks[k]);
    changed = changed || block != blocks_[k];
    blocks_[k] = block;
  }
  if (!changed && leant_on_.empty()) return false;
  of_contacts_ = true;
  joints_ = joints;
  make_batches();
  return true;
}

template <Scalar Real>
bool LaneBatches::may_be_same(const VelocityProblem<Real>& problem) {
  if (sees_other_bodies(problem) || of_contacts_ || !has_same_blocks(problem)) return false;
  leant_on_before_.swap(leant_on_);
  leant_on_.clear();
  for (const int k : singles_.blocks) {
    if (seen(problem, problem.blocks[k]) != blocks_[k]) return false;
  }
  return leant_on_ == leant_on_before_;
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
    const RowBlock& block = problem.blocks[k];
    same = blocks_[k].first_row == block.first && blocks_[k].rows == block.count &&
           blocks_[k].of_contact == block.of_contact;
  }
  const RowBlock last = problem.blocks.empty() ? RowBlock{} : problem.blocks.back();
  return same && last.first + last.count == problem.row_count();
}

template <Scalar Real>
LaneBlock LaneBatches::seen(const VelocityProblem<Real>& problem, const RowBlock& block) {
  LaneBlock result = {.first_row = block.first, .rows = block.count, .of_contact = block.of_contact};
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
  if (block.of_contact) result.kinds |= contact_bit;
  if (!fit_all) result.kinds = 0;
  return result;
}

template <Scalar Real>
LaneBlock LaneBatches::seen(const Contact<Real>& contact, const RowBlock& block) {
  LaneBlock result = {.first_row = block.first, .rows = block.count, .of_contact = true};
  if (block.count == 0) return result;
  result.a = contact.a;
  result.b = contact.b;
  if (contact.friction > 0) {
    result.kinds = kinds_of_contact(block.count);
  } else {
    for (int i = 0; i < block.count; ++i)
      result.kinds = result.kinds << bits_of_a_kind | code_of({.bounds = LaneBounds::lower});
  }
  result.kinds |= contact_bit;
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

template bool LaneBatches::arrange_contacts(const VelocityProblem<float>&);
template bool LaneBatches::arrange_contacts(const VelocityProblem<double>&);
template void LaneBatches::arrange(const VelocityProblem<float>&);
template bool LaneBatches::may_be_same(const VelocityProblem<float>&);
template void LaneBatches::arrange(const VelocityProblem<double>&);
template bool LaneBatches::may_be_same(const VelocityProblem<double>&);

}  // namespace cairn
