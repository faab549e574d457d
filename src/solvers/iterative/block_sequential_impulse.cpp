// Floor 4. Algorithm 1 of the paper, block by block.
#include <cairn/solvers/iterative/block_sequential_impulse.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/solvers/body_rows.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

template <Scalar Real>
const ConstraintRow<Real>& block_row(const VelocityProblem<Real>& problem, int row) {
  return problem.rows[row];
}

/// A_ij (15), softness included.
template <Scalar Real>
Real block_entry(const VelocityProblem<Real>& problem, int i, int j) {
  const Real entry = coupling(problem, block_row(problem, i), block_row(problem, j), problem.inverse_mass);
  return i == j ? entry + block_row(problem, i).softness : entry;
}

/// A contact's normal, or a limit: its impulse may be anything that is not negative.
template <Scalar Real>
bool is_block_normal(const Bounds<Real>& bounds) {
  return bounds.is_unilateral() && bounds.upper == std::numeric_limits<Real>::infinity();
}

}  // namespace

template <Scalar Real>
BlockSequentialImpulse<Real>::BlockSequentialImpulse(const SolverSettings& settings, ContactBlock contact)
    : settings_(settings), contact_(contact) {
  check(settings, "BlockSequentialImpulse");
}

template <Scalar Real>
SolveReport BlockSequentialImpulse<Real>::solve(VelocityProblem<Real>& problem,
                                                SolveObserver<Real>* observer) {
  check_blocks(problem, "BlockSequentialImpulse");
  if (observer != nullptr) observer->before_solve(problem);
  if (is_prepared(problem)) {
    for (EqualityPair<Real>& pair : equality_pairs_) pair.take_bias(problem);
  } else {
    prepare(problem);
  }
  stopping_.begin(settings_, problem);
  apply_impulses(problem);  // warm start: those of last step act before the first sweep

  return stopping_.repeat_rows(problem, observer, sequence_, [&](int number, SolveObserver<Real>* watcher) {
    Real largest_change = 0;
    for (const int row : sequence_.rows) {
      const Turn turn = turns_[row];
      for (int k = turn.first; k < turn.last; ++k) {
        const Part& part = parts_[k];
        const Real change = update(number, part, problem, watcher);
        largest_change = std::max(largest_change, change);
      }
    }
    return largest_change;
  });
}

/// Matrices are those of before where only biases are others.
template <Scalar Real>
bool BlockSequentialImpulse<Real>::is_prepared(const VelocityProblem<Real>& problem) const {
  if (problem.number.value() == 0 || problem.number.value() != prepared_) return false;
  const auto same = [](const ConstraintRow<Real>& row, Real softness) { return row.softness == softness; };
  return std::equal(problem.rows.begin(), problem.rows.end(), softness_.begin(), softness_.end(), same);
}

template <Scalar Real>
std::size_t BlockSequentialImpulse<Real>::memory() const {
  return parts_.bytes() + turns_.bytes() + effective_mass_.bytes() + pairs_.bytes() +
         equality_pairs_.bytes() + factors_.bytes() + softness_.bytes() + partner_.bytes();
}

template <Scalar Real>
void BlockSequentialImpulse<Real>::prepare(const VelocityProblem<Real>& problem) {
  prepared_ = 0;  // until it is done
  parts_.clear();
  effective_mass_.clear();
  pairs_.clear();
  equality_pairs_.clear();
  factors_.clear();
  turns_.assign(problem.rows.size(), Turn{});
  softness_.clear();
  for (const ConstraintRow<Real>& row : problem.rows) softness_.push_back(row.softness);
  partner_.assign(problem.rows.size(), -1);
  for (const RowBlock& block : problem.blocks) {
    if (block.count == 0) continue;  // a degenerate joint
    const int first = parts_.size();
    find_partners(problem, block);
    add_parts(problem, block);
    turns_[block.first] = {first, parts_.size()};
  }
  prepared_ = problem.number.value();
}

/// Rows that ContactBlock joins know each other afterwards.
template <Scalar Real>
void BlockSequentialImpulse<Real>::find_partners(const VelocityProblem<Real>& problem,
                                                 const RowBlock& block) {
  const auto join = [this](int first, int second) {
    partner_[first] = second;
    partner_[second] = first;
  };
  int normals = 0, before = 0, last = 0, equalities = 0;
  for (int i = block.first; i < block.first + block.count; ++i) {
    const Bounds<Real>& bounds = block_row(problem, i).bounds;
    equalities += bounds.is_equality();
    if (is_block_normal(bounds)) {
      normals += 1;
      before = last;
      last = i;
    }
    if (contact_ != ContactBlock::normal_and_friction || !bounds.is_friction()) continue;
    if (bounds.second_normal_row != Bounds<Real>::none) continue;  // it leans on two: no pair
    const int normal = bounds.normal_row;
    const bool is_here = normal >= block.first && normal < block.first + block.count;
    // One friction row a contact: in the plane there is no second.
    if (is_here && is_block_normal(block_row(problem, normal).bounds) && partner_[normal] < 0) {
      join(normal, i);
    }
  }
  // Two limits of a joint are no contacts: its equality rows have the last word.
  if (contact_ == ContactBlock::two_normals && normals == 2 && equalities == 0) join(before, last);
}

template <Scalar Real>
void BlockSequentialImpulse<Real>::add_parts(const VelocityProblem<Real>& problem, const RowBlock& block) {
  const Kind kind = contact_ == ContactBlock::two_normals ? Kind::two_normals : Kind::contact;
  equalities_.clear();
  const auto add_if_not_joined = [&](int i) {
    const int partner = partner_[i];
    if (partner < 0) return add_row(problem, i);
    // The pair stands where the normal row, or the first of two, is written.
    const bool leads = kind == Kind::contact ? is_block_normal(block_row(problem, i).bounds) : i < partner;
    if (!leads || add_pair(problem, kind, i, partner)) return;
    add_row(problem, i);
    add_row(problem, partner);
  };
  const auto is_friction = [&](int i) { return block_row(problem, i).bounds.is_friction(); };
  for (int i = block.first; i < block.first + block.count; ++i) {
    if (block_row(problem, i).bounds.is_equality()) {
      equalities_.push_back(i);
    } else if (kind == Kind::contact || !is_friction(i)) {
      add_if_not_joined(i);
    }
  }
  for (int i = block.first; kind == Kind::two_normals && i < block.first + block.count; ++i) {
    if (is_friction(i)) add_row(problem, i);  // friction after the normals that bound it
  }
  if (add_equalities(problem, equalities_)) return;
  for (const int i : equalities_) add_row(problem, i);
}

template <Scalar Real>
void BlockSequentialImpulse<Real>::add_row(const VelocityProblem<Real>& problem, int row) {
  parts_.push_back({Kind::row, 1, effective_mass_.size(), {row}});
  effective_mass_.push_back(effective_mass(problem, block_row(problem, row)));
}

template <Scalar Real>
bool BlockSequentialImpulse<Real>::add_pair(const VelocityProblem<Real>& problem, Kind kind, int first,
                                            int second) {
  const PairMatrix<Real> A{.first = block_entry(problem, first, first),
                           .cross = block_entry(problem, first, second),
                           .second = block_entry(problem, second, second)};
  if (!is_regular(A)) return false;
  parts_.push_back({kind, 2, pairs_.size(), {first, second}});
  pairs_.push_back(A);
  return true;
}

template <Scalar Real>
bool BlockSequentialImpulse<Real>::add_equalities(const VelocityProblem<Real>& problem,
                                                  const List<int>& rows) {
  const int count = rows.size();
  if (count < 2 || count > max_block_rows) return false;
  if (EqualityPair<Real> pair; count == 2 && pair.begin(problem, rows[0], rows[1])) {
    parts_.push_back({Kind::equality_pair, count, equality_pairs_.size(), {rows[0], rows[1]}});
    equality_pairs_.push_back(pair);
    return true;
  }
  Part part{Kind::equalities, count, factors_.size(), {}};
  BlockMatrix<Real> A = {};
  for (int i = 0; i < rows.size(); ++i) {
    part.rows[i] = rows[i];
    for (int k = 0; k <= i; ++k) A[i][k] = block_entry(problem, rows[i], rows[k]);
  }
  BlockFactor<Real> factor;
  if (!factor.factorize(A, count)) return false;
  parts_.push_back(part);
  factors_.push_back(factor);
  return true;
}

/// One update of (22) for all rows of a part at once; returns the largest change of an impulse.
template <Scalar Real>
Real BlockSequentialImpulse<Real>::update(int number, const Part& part, VelocityProblem<Real>& problem,
                                          SolveObserver<Real>* watcher) {
  if (watcher == nullptr && part.kind == Kind::equality_pair) {
    return equality_pairs_[part.matrix].update(problem, Real(settings_.relaxation));
  }
  const auto count = part.count;
  BlockVector<Real> jv, corrective, old;
  for (int k = 0; k < count; ++k) {
    const auto i = part.rows[k];
    const ConstraintRow<Real>& row = problem.rows[i];
    old[k] = problem.impulse[i];
    jv[k] = row_velocity(problem, row);
    corrective[k] = row.bias - jv[k] - row.softness * old[k];
  }
  correct(part, problem, corrective);
  Real largest_change = 0;
  for (int k = 0; k < count; ++k) {
    const auto i = part.rows[k];
    const ConstraintRow<Real>& row = problem.rows[i];
    corrective[k] *= Real(settings_.relaxation);
    problem.impulse[i] = row.bounds.clamp(old[k] + corrective[k], problem.impulse);
    apply_impulse(problem, row, problem.impulse[i] - old[k]);  // (19), (21)
    largest_change = std::max(largest_change, std::abs(problem.impulse[i] - old[k]));
  }
  if (watcher != nullptr) {
    for (int k = 0; k < count; ++k) {
      const int i = part.rows[k];
      watcher->after_row(
          {number, i, jv[k], block_entry(problem, i, i), corrective[k], old[k], problem.impulse[i]}, problem);
    }
  }
  return largest_change;
}

/// From the velocity errors of a part's rows, zeta - j v - softness * impulse, to the changes of their
/// impulses that take these errors away, or leave what the rows' bounds must leave.
template <Scalar Real>
void BlockSequentialImpulse<Real>::correct(const Part& part, const VelocityProblem<Real>& problem,
                                           BlockVector<Real>& error) const {
  const auto matrix = part.matrix;
  if (part.kind == Kind::row) {
    error[0] *= effective_mass_[matrix];
    return;
  }
  if (part.kind == Kind::equality_pair) {
    equality_pairs_[matrix].solve(error[0], error[1]);
    return;
  }
  if (part.kind == Kind::equalities) {
    factors_[matrix].solve(error);
    return;
  }
  const PairMatrix<Real>& A = pairs_[matrix];
  const Vec2<Real> old = {problem.impulse[part.rows[0]], problem.impulse[part.rows[1]]};
  // w = A impulse + q: what would be left of the errors if the two rows gave nothing.
  const Vec2<Real> q = {-error[0] - A.first * old(0) - A.cross * old(1),
                        -error[1] - A.cross * old(0) - A.second * old(1)};
  Vec2<Real> impulse;
  if (part.kind == Kind::contact) {
    impulse = solve_coulomb(A, q, block_row(problem, part.rows[1]).bounds.friction);
  } else {
    impulse = solve_two_normals(A, q);
  }
  error[0] = impulse(0) - old(0);
  error[1] = impulse(1) - old(1);
}

template class BlockSequentialImpulse<float>;
template class BlockSequentialImpulse<double>;

}  // namespace cairn
