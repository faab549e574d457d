// Floor 5. What rows gave, by their names: with it the next substep begins.
#pragma once

#include <cstdint>

#include "constraints/problem_rows.hpp"
#include "math/list.hpp"

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

/// Keeps what the rows of a block have given: row(k) is the k-th. Rows that have vanished are forgotten. What
/// a step has added to an impulse made good for errors of the velocities, which do not grow with dt as forces
/// do. After a shorter step than the last one, only a share of it is kept: as much as it will be again when
/// it is scaled for a longer one.
template <typename Impulses, Scalar Real, typename Row>
void remember(Impulses& impulses, int count, Real dt, const Row& row) {
  const Real share = impulses.count > 0 ? dt / impulses.dt : Real(1);
  Impulses before;
  if (share < 1) before = impulses;
  impulses.count = count;
  impulses.dt = dt;
  if constexpr (requires { impulses.rows.resize(0); }) impulses.rows.resize(count);
  for (int k = 0; k < count; ++k) {
    RowImpulse<Real> now = row(k);
    const RowImpulse<Real>* old = before.find(now.part, k);
    if (old) now.impulse = share * (old->impulse + now.impulse - share * old->impulse);
    impulses.rows[k] = now;
  }
}

/// Gives the rows of a block, which are named, the impulses that rows of the same name had in the last step,
/// or 0 (paper 2.3), and says in `is_new` which had none. An impulse grows with dt, so it is scaled when dt
/// has changed; the paper's lambda, a force, would stay as it is.
template <typename Impulses, Scalar Real>
void start_rows(const Impulses& before, const RowBlock& block, bool is_warm, VelocityProblem<Real>& problem,
                PerRow<char>& is_new) {
  const Real scale = before.count > 0 ? problem.dt / before.dt : Real(1);
  for (int k = 0; k < block.count; ++k) {
    const int row = block.first + k;
    const RowImpulse<Real>* last = before.find(problem.rows[row].key.part, k);
    is_new[row] = last == nullptr;
    problem.impulse[row] = last && is_warm ? scale * last->impulse : Real(0);
  }
}

/// Keeps what the rows of a block of the problem have given, as remember().
template <typename Impulses, Scalar Real>
void remember_rows(Impulses& impulses, const RowBlock& block, const VelocityProblem<Real>& problem) {
  remember(impulses, block.count, problem.dt, [&](int k) {
    return RowImpulse<Real>{problem.rows[block.first + k].key.part, problem.impulse[block.first + k]};
  });
}

/// Whose forces geometric stiffness is of.
enum class ForcesOf { last_substep, this_substep };

/// The forces [N, or N m] of a block's rows: those that it gave in the last substep, or those that it has in
/// the problem.
template <typename Impulses, Scalar Real>
void take_forces(ForcesOf when, const Impulses& before, const VelocityProblem<Real>& problem, int block,
                 RowForces<Real>& forces) {
  forces.rows.clear();
  if (when == ForcesOf::last_substep) {
    for (int k = 0; k < before.count; ++k)
      forces.rows.push_back({before.rows[k].part, before.rows[k].impulse / before.dt});
    return;
  }
  const RowBlock& rows = problem.blocks[block];
  for (int row = rows.first; row < rows.first + rows.count; ++row)
    forces.rows.push_back({problem.rows[row].key.part, problem.impulse[row] / problem.dt});
}

}  // namespace cairn
