// Floor 3. Rows of joints, written where a solver will read them.
#pragma once

#include <limits>

#include <cairn/constraints/constraint.hpp>
#include <cairn/constraints/stabilization.hpp>

namespace cairn {

/// What one row gave in the last step that it was written for.
template <Scalar Real>
struct RowImpulse {
  std::uint64_t part = 0;  // RowKey::part
  Real impulse = 0;        // [N s]
};

/// What a row is off by.
template <Scalar Real>
struct RowError {
  std::uint64_t part = 0;  // RigidRow::part
  Real error = 0;          // C [m or rad]
};

/// The arcs on which bodies go in a substep. Rows that follow them hold where the substep ends, and not only
/// to the first order: their bodies, which move along chords, keep their speed. Source: R. Weinstein, J.
/// Teran, R. Fedkiw, Dynamic Simulation of Articulated Rigid Bodies with Contact and Collision (2006), who
/// solve for joints at the end of the step.
template <Scalar Real>
struct Arcs {
  Placements<Real> ahead;        // where the velocities of before would take bodies
  const PerBody<char>& moves;    // whether they would take one anywhere
  List<RowError<Real>>& errors;  // scratch: of a joint, ahead
};

/// What all joints of a substep are written with.
template <Scalar Real>
struct RowWriting {
  const BodyState<Real>& begin;    // masses, and velocities before any force
  VelocityProblem<Real>& problem;  // with dt, masses and velocities of the step without constraints
  int& next;                       // the row that is written next, over an old one where there is one
  RowRule<Real> rule = {};         // of the joint's spring
  RowRule<Real> second_rule = {};  // in a second solve
  List<SecondRow<Real>>* second_rows = nullptr;  // for what rows are in that; null: there is none
  const Arcs<Real>* arcs = nullptr;              // null: nobody follows them
  const PerBody<Real>* radius = nullptr;         // [m] of circles around bodies; null: no joint is ever apart
};

/// Writes the rows of one joint: with their bias (7) and softness, the force of a motor as an impulse, and
/// with what they are in a second solve. A row that nothing can move is left out: no row names one like it
/// for its bounds. Of its error
///   a rigid equality     takes beta C / dt back, on a spring of the policy the spring's rate times C
///   a rigid inequality   as pushing_bias()
///   a spring of its own  as spring_row()
///   a servo              motor_of()
/// To this comes the speed that it asks for by itself. Where only positions are corrected, friction, motors
/// and springs do nothing, and an inequality takes no more than is still missing.
template <Scalar Real>
class ProblemRows final : public RowWriter<Real> {
 public:
  /// `joint` is asked where arcs lead; `last` is what its rows gave in the last step.
  ProblemRows(const RowWriting<Real>& writing, std::uint64_t source, const Constraint* joint = nullptr,
              Span<const RowImpulse<Real>> last = {});
  ProblemRows(RowWriting<Real>&&, std::uint64_t, const Constraint* = nullptr,
              Span<const RowImpulse<Real>> = {}) = delete;  // it would be gone

  void add(const RowSpec<Real>& spec) override;
  void add(const RigidRow<Real>& row) override;
  Vec3<Real> velocity(BodyId body) const override { return writing_.problem.velocity[body]; }
  Vec3<Real> inverse_mass(BodyId body) const override { return writing_.problem.inverse_mass[body]; }

  /// Whether rigid rows hold points that are farther apart than the circle around the smaller body reaches.
  bool is_apart() const { return gap_squared_ > most_gap_ * most_gap_; }

 private:
  void measure_gap(const RigidRow<Real>& row);
  bool moves_nothing(const RowSpec<Real>& spec) const;
  bool follows_arc(const RowSpec<Real>& spec) const;
  Real lost_on_arc(const RigidRow<Real>& row, Real jv);
  ConstraintRow<Real>& next_row(const RigidRow<Real>& row);
  void set_bounds(const RowSpec<Real>& spec, Bounds<Real>& bounds) const;

  const RowWriting<Real>& writing_;
  std::uint64_t source_;
  const Constraint* joint_;
  Span<const RowImpulse<Real>> last_;
  int first_;  // row of the joint
  bool knows_errors_ahead_ = false;
  Real gap_squared_ = 0;                                   // [m^2]
  Real most_gap_ = std::numeric_limits<Real>::infinity();  // [m]
};

}  // namespace cairn
