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
void velocities_of_impulses(const VelocityProblem<Real>& problem, const List<RowRun>& runs,
                            PerBody<Vec3<Real>>& velocity) {
  velocity.assign(problem.velocity.size(), Vec3<Real>::Zero());
  for (const RowRun& run : runs) {
    const ConstraintRow<Real>& one = problem.rows[run.first];
    if (!run.has_two_bodies) {
      for_each_term(problem, one, [&](BodyId body, const Vec3<Real>& jacobian) {
        velocity[body] += problem.inverse_mass[body].cwiseProduct(jacobian) * problem.impulse[run.first];
      });
      continue;
    }
    const Vec3<Real>&mass_a = problem.inverse_mass[one.a], &mass_b = problem.inverse_mass[one.b];
    Vec3<Real> v_a = velocity[one.a], v_b = velocity[one.b];
    for (int i = run.first; i <= run.last; ++i) {
      v_a += mass_a.cwiseProduct(problem.rows[i].jacobian_a) * problem.impulse[i];
      v_b += mass_b.cwiseProduct(problem.rows[i].jacobian_b) * problem.impulse[i];
    }
    velocity[one.a] = v_a;
    velocity[one.b] = v_b;
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

template <Scalar Real>
void find_runs(const VelocityProblem<Real>& problem, List<RowRun>& runs) {
  runs.clear();
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    const bool has_two_bodies = row.extra_count == 0 && row.a != row.b;
    if (has_two_bodies && !runs.empty() && runs.back().has_two_bodies) {
      const ConstraintRow<Real>& before = problem.rows[i - 1];
      if (row.a == before.a && row.b == before.b) {
        runs.back().last = i;
        continue;
      }
    }
    runs.push_back({.first = i, .last = i, .has_two_bodies = has_two_bodies});
  }
}

/// Joins the bodies of every row that can be moved.
template <Scalar Real>
void find_islands(const VelocityProblem<Real>& problem, EnergyMemory<Real>& memory) {
  PerBody<BodyId>& island = memory.island;
  island.resize(problem.velocity.size());
  for (const BodyId body : island.indices()) island[body] = body;
  find_runs(problem, memory.runs);
  for (const RowRun& run : memory.runs) {
    std::optional<BodyId> known;
    for_each_term(problem, problem.rows[run.first], [&](BodyId body, const Vec3<Real>&) {
      if (!can_move(problem, body)) return;
      const BodyId other = first_of(island, body), first = known ? first_of(island, *known) : other;
      island[std::max(first, other)] = std::min(first, other);
      known = first;
    });
  }
  for (const BodyId body : island.indices()) island[body] = first_of(island, body);
  for (RowRun& run : memory.runs) {
    run.island = problem.rows[run.first].a;
    for_each_term(problem, problem.rows[run.first], [&](BodyId body, const Vec3<Real>&) {
      if (can_move(problem, body)) run.island = island[body];
    });
  }
}

/// The shares of all islands, of which it returns the least, from M^-1 J^T p. lack(row, impulse, jv,
/// of_impulses) is what a row lacks of what it asks for; of_impulses is its row of (A + gamma) p. Written so
/// that a NaN leaves things as they are: the step will report it.
template <Scalar Real, typename Lack>
Real find_shares(const VelocityProblem<Real>& problem, EnergyMemory<Real>& memory, const Lack& lack) {
  memory.energy.assign(problem.velocity.size(), {});
  for (const RowRun& run : memory.runs) {
    const ConstraintRow<Real>& one = problem.rows[run.first];
    EnergySlope<Real> energy = memory.energy[run.island];
    const auto add = [&](const ConstraintRow<Real>& row, Real impulse, Real jv, Real jv_solved) {
      const Real of_impulses = jv_solved + row.softness * impulse;
      energy.slope += impulse * lack(row, impulse, jv, of_impulses);
      energy.curvature += impulse * of_impulses;
    };
    if (run.has_two_bodies) {
      const Vec3<Real>&v_a = problem.velocity[one.a], &v_b = problem.velocity[one.b];
      const Vec3<Real>&solved_a = memory.solved[one.a], &solved_b = memory.solved[one.b];
      for (int i = run.first; i <= run.last; ++i) {
        const ConstraintRow<Real>& row = problem.rows[i];
        add(row, problem.impulse[i], dot(row.jacobian_a, v_a) + dot(row.jacobian_b, v_b),
            dot(row.jacobian_a, solved_a) + dot(row.jacobian_b, solved_b));
      }
    } else {
      add(one, problem.impulse[run.first], row_velocity(problem, one),
          row_velocity(problem, one, memory.solved));
    }
    memory.energy[run.island] = energy;
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
  for (const RowRun& run : memory.runs) {
    for (int i = run.first; i <= run.last; ++i) problem.impulse[i] *= memory.energy[run.island].share;
  }
}

}  // namespace

template <Scalar Real>
Real limit_warm_start(VelocityProblem<Real>& problem, EnergyMemory<Real>& memory) {
  memory.island.clear();
  if (!have_energy(problem.impulse)) return 1;
  find_islands(problem, memory);
  velocities_of_impulses(problem, memory.runs, memory.solved);
  const auto lack = [](const ConstraintRow<Real>& row, Real, Real jv, Real of_impulses) {
    const bool may_push_out = row.bounds.is_unilateral() && row.softness == 0;  // a spring gives in as well
    const Real bias = may_push_out ? std::min(row.bias, Real(0)) : row.bias;
    return jv + of_impulses - bias;
  };
  const Real share = find_shares(problem, memory, lack);
  if (share < 1) scale_impulses(problem, memory);
  return share;
}

template <Scalar Real>
Real limit_solved(VelocityProblem<Real>& problem, EnergyMemory<Real>& memory) {
  if (!have_energy(problem.impulse)) return 1;
  if (memory.island.empty()) find_islands(problem, memory);
  velocities_of_impulses(problem, memory.runs, memory.solved);
  const auto lack = [](const ConstraintRow<Real>& row, Real impulse, Real jv, Real) {
    return jv + row.softness * impulse - row.bias;
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
