// Floor 4. In which order a Gauss-Seidel sweep visits its rows.
#pragma once

#include <cstdint>

#include <cairn/constraints/row.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// The order changes the answer of a few sweeps (the row solved last is the one that is satisfied) and the
/// number of sweeps that are needed, never the velocities that many sweeps lead to without friction.
enum class RowOrder {
  as_written,   // first to last
  reverse,      // last to first
  alternating,  // odd sweeps first to last, even sweeps last to first
  shuffled,     // a new permutation for every sweep, drawn from the seed: every order equally likely
  coloured,     // colour by colour: rows of one colour share no body that can move
};

/// The rows of one sweep in the order of their turns. Keeps its memory from sweep to sweep.
struct RowSequence {
  List<int> rows = {};  // their places in the problem, in the order of their turns
  /// For RowOrder::coloured: where in `rows` each colour begins, then the number of rows. Otherwise empty.
  List<int> colours = {};
  List<int> waiting = {};      // scratch: rows without a colour yet
  PerBody<int> taken_by = {};  // scratch, for each body: the newest colour that has a row at it
};

/// Writes the order of `sweep` (from 1) into `sequence`; sweeps of one problem are asked for from 1 upwards.
/// Depends on its arguments only: the same seed shuffles in the same way in every solve and on every machine.
/// O(m) for sweep 1, afterwards O(m) for alternating and shuffled and nothing for the others; allocates in
/// sweep 1 only. Colours are given greedily: each row, as written, takes the first that is free at both its
/// bodies. With d rows at the busiest body that makes d colours at least and 2d - 1 at most, O(m) for each.
template <Scalar Real>
void order_rows(const VelocityProblem<Real>& problem, RowOrder order, std::uint64_t seed, int sweep,
                RowSequence& sequence);

}  // namespace cairn
