// Floor 4. The energy of impulses, row by row.
#include "solvers/impulse_energy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cairn {

namespace {

/// M^-1 J^T p.
template <Scalar Real>
void velocities_of_impulses(const VelocityProblem<Real>& problem, PerBody<Vec3<Real>>& velocity) {
  velocity.assign(problem.velocity.size(), Vec3<Real>::Zero());
  for (int i = 0; i < problem.row_count(); ++i) {
    for_each_term(problem, problem.rows[i], [&](BodyId body, const Vec3<Real>& jacobian) {
      velocity[body] += problem.inverse_mass[body].cwiseProduct(jacobian) * problem.impulse[i];
    });
  }
}

template <Scalar Real>
bool can_move(const VelocityProblem<Real>& problem, BodyId body) {
  return !problem.inverse_mass[body].isZero(0);
}

/// The first body of an island: no body names one behind itself.
BodyId first_of(PerBody<BodyId>& island, BodyId body) {
  while (island[body] != body) {
    island[body] = island[island[body]];
    body = island[body];
  }
  return body;
}

/// Joins the bodies of every row that can be moved.
template <Scalar Real>
void find_islands(const VelocityProblem<Real>& problem, PerBody<BodyId>& island) {
  island.resize(problem.velocity.size());
  for (const BodyId body : island.indices()) island[body] = body;
  const ConstraintRow<Real>* last = nullptr;
  for (const ConstraintRow<Real>& row : problem.rows) {
    const bool joins_the_same = last != nullptr && row.a == last->a && row.b == last->b;
    last = &row;
    if (joins_the_same && row.extra_count == 0) continue;
    std::optional<BodyId> known;
    for_each_term(problem, row, [&](BodyId body, const Vec3<Real>&) {
      if (!can_move(problem, body)) return;
      const BodyId other = first_of(island, body), first = known ? first_of(island, *known) : other;
      island[std::max(first, other)] = std::min(first, other);
      known = first;
    });
  }
  for (const BodyId body : island.indices()) island[body] = first_of(island, body);
}

/// The island of a row; that of a body that cannot be moved where none of its bodies can.
template <Scalar Real>
BodyId island_of(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row,
                 const PerBody<BodyId>& island) {
  BodyId found = row.a;
  for_each_term(problem, row, [&](BodyId body, const Vec3<Real>&) {
    if (can_move(problem, body)) found = island[body];
  });
  return found;
}

/// The shares of all islands, of which it returns the least, from M^-1 J^T p. lack(i, row, of_impulses) is
/// what row i lacks of what it asks for; of_impulses is its row of (A + gamma) p. Written so that a NaN
/// leaves things as they are: the step will report it.
template <Scalar Real, typename Lack>
Real find_shares(const VelocityProblem<Real>& problem, EnergyMemory<Real>& memory, const Lack& lack) {
  if (memory.island.empty()) find_islands(problem, memory.island);
  memory.energy.assign(problem.velocity.size(), {});
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    EnergySlope<Real>& energy = memory.energy[island_of(problem, row, memory.island)];
    const Real of_impulses = row_velocity(problem, row, memory.solved) + row.softness * problem.impulse[i];
    energy.slope += problem.impulse[i] * lack(i, row, of_impulses);
    energy.curvature += problem.impulse[i] * of_impulses;
  }
  Real least = 1;
  for (EnergySlope<Real>& energy : memory.energy) {
    if (energy.slope > 0 && energy.curvature > 0)
      energy.share = std::max(Real(0), 1 - energy.slope / energy.curvature);
    least = std::min(least, energy.share);
  }
  return least;
}

/// Whether the energy of any impulse is a number: the squares of smaller ones are 0, or slow to compute with.
template <Scalar Real>
bool have_energy(const PerRow<Real>& impulses) {
  const Real least = std::sqrt(std::numeric_limits<Real>::min());
  return std::any_of(impulses.begin(), impulses.end(), [least](Real p) { return !(std::abs(p) < least); });
}

template <Scalar Real>
void scale_impulses(VelocityProblem<Real>& problem, const EnergyMemory<Real>& memory) {
  for (int i = 0; i < problem.row_count(); ++i)
    problem.impulse[i] *= memory.energy[island_of(problem, problem.rows[i], memory.island)].share;
}

}  // namespace

template <Scalar Real>
Real limit_warm_start(VelocityProblem<Real>& problem, EnergyMemory<Real>& memory) {
  memory.island.clear();
  if (!have_energy(problem.impulse)) return 1;
  velocities_of_impulses(problem, memory.solved);
  const auto lack = [&](int, const ConstraintRow<Real>& row, Real of_impulses) {
    const bool may_push_out = row.bounds.is_unilateral() && row.softness == 0;  // a spring gives in as well
    const Real bias = may_push_out ? std::min(row.bias, Real(0)) : row.bias;
    return row_velocity(problem, row) + of_impulses - bias;
  };
  const Real share = find_shares(problem, memory, lack);
  if (share < 1) scale_impulses(problem, memory);
  return share;
}

template <Scalar Real>
Real limit_solved(VelocityProblem<Real>& problem, EnergyMemory<Real>& memory) {
  if (!have_energy(problem.impulse)) return 1;
  velocities_of_impulses(problem, memory.solved);
  const auto lack = [&](int i, const ConstraintRow<Real>& row, Real) {
    return row_velocity(problem, row) + row.softness * problem.impulse[i] - row.bias;
  };
  const Real share = find_shares(problem, memory, lack);
  if (!(share < 1)) return share;
  scale_impulses(problem, memory);
  for (const BodyId body : memory.solved.indices()) {
    const Real kept = memory.energy[memory.island[body]].share;
    problem.velocity[body] -= (1 - kept) * memory.solved[body];
  }
  return share;
}

namespace {

/// Whether the impulse of a row comes from a force that it has by itself: a spring, a motor.
template <Scalar Real>
bool pushes_by_itself(const ConstraintRow<Real>& row) {
  return row.softness > 0 || (std::isfinite(row.bounds.lower) && std::isfinite(row.bounds.upper));
}

/// The sum of m |v| [N s].
template <Scalar Real>
Real moving_momentum(const VelocityProblem<Real>& problem) {
  Real momentum = 0;
  for (const BodyId body : problem.velocity.indices()) {
    const Real inverse_mass = problem.inverse_mass[body].x();
    if (inverse_mass > 0) momentum += problem.velocity[body].template head<2>().norm() / inverse_mass;
  }
  return momentum;
}

}  // namespace

template <Scalar Real>
Real impulse_there_is(const VelocityProblem<Real>& problem) {
  Real sum = moving_momentum(problem);
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    sum += std::abs(row.bias) * effective_mass(problem, row);
    if (pushes_by_itself(row)) sum += std::abs(problem.impulse[i]);
  }
  return sum;
}

template <Scalar Real>
void limit_impulses(VelocityProblem<Real>& problem) {
  Real largest = 0;
  for (const Real impulse : problem.impulse) largest = std::max(largest, std::abs(impulse));
  const Real leverage = static_cast<Real>(most_leverage);
  if (!(largest > leverage * moving_momentum(problem))) return;
  const Real limit = leverage * impulse_there_is(problem);
  for (int i = 0; i < problem.row_count(); ++i) {
    if (!pushes_by_itself(problem.rows[i]))
      problem.impulse[i] = std::clamp(problem.impulse[i], -limit, limit);
  }
}

template float impulse_there_is(const VelocityProblem<float>&);
template double impulse_there_is(const VelocityProblem<double>&);
template long double impulse_there_is(const VelocityProblem<long double>&);
template void limit_impulses(VelocityProblem<float>&);
template void limit_impulses(VelocityProblem<double>&);
template void limit_impulses(VelocityProblem<long double>&);

template float limit_warm_start(VelocityProblem<float>&, EnergyMemory<float>&);
template double limit_warm_start(VelocityProblem<double>&, EnergyMemory<double>&);
template long double limit_warm_start(VelocityProblem<long double>&, EnergyMemory<long double>&);
template float limit_solved(VelocityProblem<float>&, EnergyMemory<float>&);
template double limit_solved(VelocityProblem<double>&, EnergyMemory<double>&);
template long double limit_solved(VelocityProblem<long double>&, EnergyMemory<long double>&);

}  // namespace cairn
