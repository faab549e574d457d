// Floor 5. Shock propagation, from the ground up.
#include "world/last_word.hpp"
#include "math/list.hpp"

#include <algorithm>
#include <limits>

namespace cairn {

namespace {

// Two points of one contact settle within a few sweeps; a cluster far from anything immovable needs more.
constexpr int most_last_sweeps = 50;

constexpr int no_level = std::numeric_limits<int>::max();

/// Gives a body one level more than the lower body of a contact: if it has none yet, or if a shorter
/// way leads to it. Levels that were there before stay.
template <Scalar Real, typename Counts>
void spread_levels(const VelocityProblem<Real>& problem, const List<ContactLimit<Real>>& contacts,
                   const Counts& counts, PerBody<int>& level) {
  const PerBody<int> fixed = level;
  for (bool changed = true; changed;) {
    changed = false;
    for (const ContactLimit<Real>& contact : contacts) {
      const ConstraintRow<Real>& row = problem.rows[contact.row];
      const BodyId higher = level[row.a] < level[row.b] ? row.b : row.a;
      const int lower = std::min(level[row.a], level[row.b]);
      if (!counts(contact) || lower == no_level || fixed[higher] != no_level) continue;
      if (level[higher] - 1 <= lower) continue;
      level[higher] = lower + 1;
      changed = true;
    }
  }
}

/// For each body, over how many contacts the nearest immovable one is; where there is none, all are alike.
/// What is still far from it counts only for bodies that touch nothing that is held.
template <Scalar Real>
PerBody<int> contact_levels(const VelocityProblem<Real>& problem, const List<ContactLimit<Real>>& contacts) {
  PerBody<int> level;
  for (const Vec3<Real>& inverse_mass : problem.inverse_mass)
    level.push_back(inverse_mass.x() > 0 ? no_level : 0);
  const auto is_near = [](const ContactLimit<Real>& contact) { return contact.separation < contact.depth; };
  spread_levels(problem, contacts, is_near, level);
  spread_levels(
      problem, contacts, [](const ContactLimit<Real>&) { return true; }, level);
  return level;
}

/// One body's part of a row.
template <Scalar Real>
struct RowSide {
  const Vec3<Real>& jacobian;
  const Vec3<Real>& inverse_mass;
  Vec3<Real>& velocity;

  Real speed() const { return dot(jacobian, velocity); }
  Real inverse_effective_mass() const { return dot<Real>(jacobian, inverse_mass.cwiseProduct(jacobian)); }
  void push(Real impulse) { velocity += inverse_mass.cwiseProduct(jacobian) * impulse; }
  /// Gives this side of the row another speed, as if the other one could not be moved.
  void set_speed(Real wanted) {
    const Real inverse = inverse_effective_mass();
    if (inverse > 0) push((wanted - speed()) / inverse);
  }
};

/// Stops the approach of one row, as far as that takes energy and gives none. `least` is what j v may be.
template <Scalar Real>
void stop_approach(RowSide<Real> near, RowSide<Real> far, bool is_immovable, Real least) {
  if (is_immovable) return far.set_speed(least - near.speed());
  far.set_speed(std::max(far.speed(), std::min(least - near.speed(), Real(0))));
  near.set_speed(std::max(near.speed(), std::min(least - far.speed(), Real(0))));
}

/// One sweep over contacts of one level; how fast the fastest of them approached [m/s].
template <Scalar Real>
Real last_sweep(const VelocityProblem<Real>& problem, const PerBody<int>& level,
                const ContactLimit<Real>* first, const ContactLimit<Real>* last,
                PerBody<Vec3<Real>>& velocity) {
  Real fastest = 0;
  for (const ContactLimit<Real>* contact = first; contact != last; ++contact) {
    const ConstraintRow<Real>& row = problem.rows[contact->row];
    const Real least = -std::max(contact->separation, Real(0)) / problem.dt;
    const Real missing = least - row_velocity(problem, row, velocity);
    if (!(missing > 0)) continue;
    fastest = std::max(fastest, missing);
    const BodyId a = row.a, b = row.b;
    RowSide<Real> side_a{row.jacobian_a, problem.inverse_mass[a], velocity[a]};
    RowSide<Real> side_b{row.jacobian_b, problem.inverse_mass[b], velocity[b]};
    if (level[a] == level[b]) {
      const Real impulse = missing * effective_mass(problem, row);
      side_a.push(impulse);
      side_b.push(impulse);
    } else if (level[a] < level[b]) {
      stop_approach(side_a, side_b, level[a] == 0, least);
    } else {
      stop_approach(side_b, side_a, level[b] == 0, least);
    }
  }
  return fastest;
}

}  // namespace

template <Scalar Real>
bool goes_too_deep(const VelocityProblem<Real>& problem, const ContactLimit<Real>& contact,
                   const PerBody<Vec3<Real>>& velocity) {
  const ConstraintRow<Real>& row = problem.rows[contact.row];
  const Real way = problem.dt * row_velocity(problem, row, velocity);
  return way < 0 && contact.separation + way < -contact.depth;
}

template <Scalar Real>
void keep_bodies_apart(const VelocityProblem<Real>& problem, List<ContactLimit<Real>> contacts,
                       PerBody<Vec3<Real>>& velocity) {
  const PerBody<int> level = contact_levels(problem, contacts);
  const auto level_of = [&](const ContactLimit<Real>& contact) {
    const ConstraintRow<Real>& row = problem.rows[contact.row];
    return std::min(level[row.a], level[row.b]);
  };
  std::stable_sort(contacts.begin(), contacts.end(),
                   [&](const auto& one, const auto& other) { return level_of(one) < level_of(other); });
  const ContactLimit<Real>* const end = contacts.data() + contacts.size();
  for (const ContactLimit<Real>* first = contacts.data(); first != end;) {
    const ContactLimit<Real>* last = first;
    Real least_depth = std::numeric_limits<Real>::infinity();
    for (; last != end && level_of(*last) == level_of(*first); ++last)
      least_depth = std::min(least_depth, last->depth);
    const Real slow = Real(1e-3) * least_depth / problem.dt;  // [m/s]
    for (int sweep = 0; sweep < most_last_sweeps; ++sweep) {
      if (!(last_sweep(problem, level, first, last, velocity) > slow)) break;
    }
    first = last;
  }
}

template bool goes_too_deep(const VelocityProblem<float>&, const ContactLimit<float>&,
                            const PerBody<Vec3<float>>&);
template void keep_bodies_apart(const VelocityProblem<float>&, List<ContactLimit<float>>,
                                PerBody<Vec3<float>>&);
template bool goes_too_deep(const VelocityProblem<double>&, const ContactLimit<double>&,
                            const PerBody<Vec3<double>>&);
template void keep_bodies_apart(const VelocityProblem<double>&, List<ContactLimit<double>>,
                                PerBody<Vec3<double>>&);
template bool goes_too_deep(const VelocityProblem<long double>&, const ContactLimit<long double>&,
                            const PerBody<Vec3<long double>>&);
template void keep_bodies_apart(const VelocityProblem<long double>&, List<ContactLimit<long double>>,
                                PerBody<Vec3<long double>>&);

}  // namespace cairn
