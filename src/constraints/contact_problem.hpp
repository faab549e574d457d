// Floor 3. Contacts as they are, for solvers that need no rows of them.
#pragma once

#include <cstdint>
#include <memory>

#include "collision/kept_manifold.hpp"
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
  Real slop_limit = 0;              // [m] no slop above this
  FixedList<Real, 4> start = {};    // [N s] the warm start
  FixedList<Real, 4> impulse = {};  // [N s] the answer
  int count = 0;                    // of rows; 0 between bodies that nothing moves
  Real deepest = 0;                 // [m] of overlap in which it may be followed
  /// What its manifold is wherever the bodies go, as long as all of its points are near; null: nobody but the
  /// world can tell.
  const KeptManifold<Real>* kept = nullptr;
};

/// Says which solve of which solver contacts were in last.
struct ContactTicket {
  std::shared_ptr<const char> holder = {};  // the solver's own; null: there was none
  std::int64_t solve = 0;                   // its number

  bool operator==(const ContactTicket&) const = default;  // whether both are of one solve
};

/// What impulses the second solve of a substep begins from.
enum class SecondStart {
  of_first_start,   // those that the first one began from, so that nothing of its answer stays
  of_first_answer,  // those that the first one found, so that the second ends what it has begun
};

/// A step in which contacts are all that is to be solved: with a row of friction for each point, and without
/// restitution.
template <Scalar Real>
struct ContactProblem {
  Span<Contact<Real>> contacts = {};             // in the order in which their rows would be written
  Span<const Manifold<Real>> manifolds = {};     // of each contact
  const PerBody<Pose<Real>>* poses = nullptr;    // of all bodies
  const PerBody<Frame<Real>>* frames = nullptr;  // the same, for those who follow contacts
  Real margin = 0;                               // [m] below which kept points are near
  const ContactStabilization<Real>* stabilization = nullptr;  // how errors go
  Real gravity = 0;  // [m/s^2] that a body in overlap has to rise against
  /// dt, inverse masses and velocities, as in any problem; of rows those that the solver likes to have.
  VelocityProblem<Real>* problem = nullptr;
  SecondStart second_start = SecondStart::of_first_start;  // of relax()
  ContactTicket ticket = {};                               // of these contacts
};

}  // namespace cairn
