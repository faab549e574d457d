// Floor 5. What rows gave, by their names: with it the next substep begins.
#pragma once

#include <cstdint>

#include <cairn/constraints/problem_rows.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// What the rows of one block gave, a contact's or a joint's, and in which order.
template <typename Rows, Scalar Real>
struct BlockImpulses {
  Rows rows = {};  // the first `count` of them are in use
  int count = 0;   // of rows
  Real dt = 0;     // [s] of the substep that they are of

  /// Null where there was no row of that part. Rows mostly keep their place: `place` is where to look first.
  const RowImpulse<Real>* find(std::uint64_t part, int place) const {
    if (place < count && rows[place].part == part) return &rows[place];
    for (int i = 0; i < count; ++i) {
      if (rows[i].part == part) return &rows[i];
    }
    return nullptr;
  }
};

/// Gives the rows of a block, which are named part(k), the impulses that rows of the same name had in the
/// last step, or 0 (paper 2.3), and says in `is_new` which had none. An impulse grows with dt, so it is
/// scaled when dt has changed; the paper's lambda, a force, would stay as it is.
template <typename Impulses, typename Part, Scalar Real>
void start_rows(const Impulses& before, const RowBlock& block, const Part& part, bool is_warm,
                VelocityProblem<Real>& problem, PerRow<char>& is_new) {
  const Real scale = before.count > 0 ? problem.dt / before.dt : Real(1);
  for (int k = 0; k < block.count; ++k) {
    const int row = block.first + k;
    const RowImpulse<Real>* last = before.find(part(k), k);
    is_new[row] = last == nullptr;
    problem.impulse[row] = last && is_warm ? scale * last->impulse : Real(0);
  }
}

/// Keeps what the rows of a block of the problem have given. Rows that have vanished are forgotten. What a
/// step has added to an impulse made good for errors of the velocities, which do not grow with dt as forces
/// do. After a shorter step than the last one, only a share of it is kept: as much as it will be again when
/// it is scaled for a longer one.
template <typename Impulses, typename Part, Scalar Real>
void remember_rows(Impulses& impulses, const RowBlock& block, const Part& part,
                   const VelocityProblem<Real>& problem) {
  const Real share = impulses.count > 0 ? problem.dt / impulses.dt : Real(1);
  Impulses before;
  if (share < 1) before = impulses;
  impulses.count = block.count;
  impulses.dt = problem.dt;
  if constexpr (requires { impulses.rows.resize(0); }) impulses.rows.resize(block.count);
  for (int k = 0; k < block.count; ++k) {
    RowImpulse<Real> now = {part(k), problem.impulse[block.first + k]};
    const RowImpulse<Real>* old = before.find(now.part, k);
    if (old) now.impulse = share * (old->impulse + now.impulse - share * old->impulse);
    impulses.rows[k] = now;
  }
}

/// Whose forces geometric stiffness is of.
enum class ForcesOf { last_substep, this_substep };

/// The forces [N, or N m] of a block's rows: those that it gave in the last substep, or those that it has in
/// the problem, where part(block, k) names its rows.
template <typename Impulses, typename Part, Scalar Real>
void take_forces(ForcesOf when, const Impulses& before, const VelocityProblem<Real>& problem, int block,
                 const Part& part, RowForces<Real>& forces) {
  forces.rows.clear();
  if (when == ForcesOf::last_substep) {
    for (int k = 0; k < before.count; ++k)
      forces.rows.push_back({before.rows[k].part, before.rows[k].impulse / before.dt});
    return;
  }
  const RowBlock& rows = problem.blocks[block];
  for (int k = 0; k < rows.count; ++k)
    forces.rows.push_back({part(rows, k), problem.impulse[rows.first + k] / problem.dt});
}

}  // namespace cairn
