// Floor 3. Contacts as they are, for solvers that need no rows of them.
#pragma once

#include <optional>

#include "constraints/contact.hpp"
#include "constraints/row.hpp"
#include "math/list.hpp"

namespace cairn {

/// Two bodies in contact, and what the rows of that contact would give: of every point the normal impulse,
/// then that of friction where there is any.
template <Scalar Real>
struct Contact {
  BodyId a = {};                    // the first body
  BodyId b = {};                    // the second body
  Real friction = 0;                // mu
  Real restitution = 0;             // e
  Real slop_limit = 0;              // [m] no slop above this
  FixedList<Real, 4> start = {};    // [N s] the warm start
  FixedList<Real, 4> impulse = {};  // [N s] the answer
  int count = 0;                    // of rows; 0 between bodies that nothing moves
  /// The block of the problem that has its rows; none: it has no rows, and the two above are its impulses.
  std::optional<int> block = {};
};

/// What impulses the second solve of a substep begins from.
enum class SecondStart {
  of_first_start,   // those that the first one began from, so that nothing of its answer stays
  of_first_answer,  // those that the first one found, so that the second ends what it has begun
};

/// A step whose contacts have no rows, where they can do without: with a row of friction for each point, and
/// without restitution. Joints and all other contacts have rows, in blocks of the problem: those of joints
/// first, and those of contacts in the order of contacts.
template <Scalar Real>
struct ContactProblem {
  Span<Contact<Real>> contacts = {};           // in the order in which their rows would be written
  Span<const Manifold<Real>> manifolds = {};   // of each contact
  const PerBody<Pose<Real>>* poses = nullptr;  // of all bodies
  RowRule<Real> rule = {};                     // how errors of contacts go
  /// As any problem, with the rows that are not left out; the solver may put others behind them.
  VelocityProblem<Real>* problem = nullptr;
  int joints = 0;  // of the problem's blocks, those before the contacts'
  int rows = 0;    // of the problem, which are not the solver's
  SecondStart second_start = SecondStart::of_first_start;  // of relax()
};

}  // namespace cairn
