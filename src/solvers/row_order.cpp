// Floor 4. Orders of rows: as written, backwards, shuffled, or coloured.
#include <cairn/solvers/row_order.hpp>
#include <cairn/math/list.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace cairn {

namespace {

/// splitmix64 (G. L. Steele, D. Lea and C. H. Flood, 2014): a stream of 64 random bits a call.
std::uint64_t next_splitmix64(std::uint64_t& state) {
  state += 0x9E3779B97F4A7C15u;
  std::uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

/// Fisher-Yates. The remainder favours small numbers by less than count / 2^64: nothing that can be seen.
void shuffle_rows(std::uint64_t seed, int sweep, List<int>& rows) {
  // Two rounds, so that neither seeds nor sweeps that follow each other give streams that overlap.
  std::uint64_t state = seed;
  state = next_splitmix64(state) + static_cast<std::uint64_t>(sweep);
  state = next_splitmix64(state);
  for (int last = rows.size(); last > 1; --last) {
    const std::uint64_t other = next_splitmix64(state) % static_cast<std::uint64_t>(last);
    std::swap(rows[last - 1], rows[static_cast<int>(other)]);
  }
}

/// Greedy colouring, one colour after the other: each takes every waiting row that finds all its bodies free.
template <Scalar Real>
void colour_rows(const VelocityProblem<Real>& problem, RowSequence& sequence) {
  const auto can_move = [&](BodyId body) { return (problem.inverse_mass[body].array() != Real(0)).any(); };
  sequence.taken_by.assign(problem.velocity.size(), -1);
  sequence.waiting.assign(sequence.rows.begin(), sequence.rows.end());
  sequence.rows.clear();
  sequence.colours.assign(1, 0);
  for (int colour = 0; !sequence.waiting.empty(); ++colour) {
    int still_waiting = 0;
    for (const int i : sequence.waiting) {
      const ConstraintRow<Real>& row = problem.rows[i];
      bool is_free = true;
      for_each_term(problem, row, [&](BodyId body, const Vec3<Real>&) {
        is_free = is_free && sequence.taken_by[body] != colour;
      });
      if (!is_free) {
        sequence.waiting[still_waiting++] = i;
        continue;
      }
      for_each_term(problem, row, [&](BodyId body, const Vec3<Real>&) {
        // The ground couples none of the rows that share it.
        if (can_move(body)) sequence.taken_by[body] = colour;
      });
      sequence.rows.push_back(i);
    }
    sequence.waiting.resize(still_waiting);
    sequence.colours.push_back(sequence.rows.size());
  }
}

}  // namespace

template <Scalar Real>
void order_rows(const VelocityProblem<Real>& problem, RowOrder order, std::uint64_t seed, int sweep,
                RowSequence& sequence) {
  const bool changes = order == RowOrder::alternating || order == RowOrder::shuffled;
  if (sweep > 1 && !changes) return;

  sequence.colours.clear();
  sequence.rows.resize(problem.rows.size());
  std::iota(sequence.rows.begin(), sequence.rows.end(), 0);
  const bool backwards = order == RowOrder::reverse || (order == RowOrder::alternating && sweep % 2 == 0);
  if (backwards) std::reverse(sequence.rows.begin(), sequence.rows.end());
  if (order == RowOrder::shuffled) shuffle_rows(seed, sweep, sequence.rows);
  if (order == RowOrder::coloured) colour_rows(problem, sequence);
}

template void order_rows(const VelocityProblem<float>&, RowOrder, std::uint64_t, int, RowSequence&);
template void order_rows(const VelocityProblem<double>&, RowOrder, std::uint64_t, int, RowSequence&);
template void order_rows(const VelocityProblem<long double>&, RowOrder, std::uint64_t, int, RowSequence&);

}  // namespace cairn
