// Floor 3. The rows that several joints share: a pin, a kept angle, limits, a motor.
#pragma once

#include <optional>
#include <string>

#include <cairn/constraints/constraint.hpp>

namespace cairn {

/// Names of rows within a joint, from step to step.
enum class JointPart : std::uint64_t { x, y, angle, lower_limit, upper_limit, motor, spring, ratchet };

/// The range that a coordinate of a joint is kept in: a length [m] or an angle [rad].
struct JointLimits {
  std::optional<double> lower = {};  // [m or rad]; none: no limit
  std::optional<double> upper = {};  // [m or rad]
  double margin = 0;  // a limit this close has a row: it stops the bodies without ever being passed
};

/// Where the anchors of two bodies are now, seen from the centres of mass and from the anchor of a.
template <Scalar Real>
struct JointArms {
  Vec2<Real> r_a;  // [m] from the centre of mass of a to its anchor
  Vec2<Real> r_b;  // [m]
  Vec2<Real> d;    // [m] from the anchor of a to the anchor of b
};

/// [N] What the two rows of a pin gave: on b.
template <Scalar Real>
Vec2<Real> pin_force(const RowForces<Real>& forces) {
  return {forces.of(static_cast<std::uint64_t>(JointPart::x)),
          forces.of(static_cast<std::uint64_t>(JointPart::y))};
}

/// The arms of a joint whose anchors are given in the frames of its bodies [m].
template <Scalar Real>
JointArms<Real> joint_arms(const Placement<Real>& a, const Placement<Real>& b, const Vec2<double>& local_a,
                           const Vec2<double>& local_b) {
  JointArms<Real> arms;
  arms.r_a = a.rotation * local_a.template cast<Real>();
  arms.r_b = b.rotation * local_b.template cast<Real>();
  arms.d = b.position + arms.r_b - a.position - arms.r_a;
  return arms;
}

/// Two bodies, where a joint is fastened to each, and how they stood when it was made.
struct JointEnds {
  BodyId a = {};                  // the first body
  BodyId b = {};                  // the second body
  Vec2<double> local_a = {0, 0};  // [m] the anchor in the frame of a
  Vec2<double> local_b = {0, 0};  // [m]
  double reference_angle = 0;     // [rad] q_0: of b against a, where the joint was made

  JointEnds() = default;
  /// Anchors are in world coordinates [m]; `poses` are those that the bodies start from.
  JointEnds(BodyId first, BodyId second, const Vec2<double>& anchor_a, const Vec2<double>& anchor_b,
            PerBodySpan<const Pose<double>> poses);

  /// Both ends.
  List<Attachment> attachments() const { return {{a, local_a}, {b, local_b}}; }
  /// The arms now.
  template <Scalar Real>
  JointArms<Real> arms(const Placements<Real>& at) const {
    return joint_arms<Real>(at[a], at[b], local_a, local_b);
  }
  /// [rad] q: by how much b has turned against a since the joint was made.
  template <Scalar Real>
  Real angle(const Placements<Real>& at) const {
    return at[b].angle - at[a].angle - static_cast<Real>(reference_angle);
  }
};

/// C = d, two rows: dC/dt = v_b + w_b x r_b - v_a - w_a x r_a.
///   j = (-1, 0, r_a.y, 1, 0, -r_b.y) for x,   (0, -1, -r_a.x, 0, 1, r_b.x) for y
template <Scalar Real>
FixedList<RigidRow<Real>, 2> pin_rows(BodyId a, BodyId b, const JointArms<Real>& arms);

/// C = angle, which is angle_b - angle_a less a constant: j = (0, 0, -1, 0, 0, 1). Angles are continuous, so
/// that a whole turn is an error too.
template <Scalar Real>
RigidRow<Real> angle_row(BodyId a, BodyId b, Real angle);

/// Writes the limits of the coordinate whose row is `coordinate`: C = coordinate - lower >= 0 with the same
/// j, and C = upper - coordinate >= 0 with -j. A limit that is further away than the margin has no row.
/// Limits that coincide are one equality, C = coordinate - lower.
template <Scalar Real>
void add_limit_rows(const RigidRow<Real>& coordinate, const JointLimits& limits, RowWriter<Real>& rows);

/// Writes the motor of the coordinate whose row is `coordinate`: the same j and |impulse| <= max_force dt. Of
/// a servo C is what is missing to its target; of any other motor there is none, and j v = speed.
/// `inverse_mass`: of what a servo has to brake [1/kg or 1/(kg m^2)]; 0: not known.
template <Scalar Real>
void add_motor_row(const RigidRow<Real>& coordinate, const JointMotor& motor, RowWriter<Real>& rows,
                   Real inverse_mass = 0);

/// j M^-1 j^T of a row, where one or two others of the same bodies hold: how little the coordinate of a joint
/// resists.
template <Scalar Real>
Real inverse_mass_beside(const RigidRow<Real>& row, Span<const RigidRow<Real>> held,
                         const RowWriter<Real>& rows);

/// The geometric stiffness of a pin that pushes b with the force F [N], and a with -F: arms turn with their
/// bodies, and nothing else of C has a second derivative.
///   K_q of a = |r_a . F|,   K_q of b = |r_b . F|
template <Scalar Real>
void add_pin_stiffness(BodyId a, BodyId b, const JointArms<Real>& arms, const Vec2<Real>& force_on_b,
                       PerBody<Vec3<Real>>& stiffness);

/// The geometric stiffness of a straight line of length L [m] that pulls with the force T [N], for the body
/// at one of its ends, which has the arm r [m] and s = |r . u| along the direction u of the line. Across the
/// line its ends x_1 and x_2 have the energy T (x_1 - x_2)^2 / 2 L, no more than T (x_1^2 + x_2^2) / L. With
/// an arm an end is where the body's centre x and its angle q take it, and (x + s q)^2 is at most (1 + s / l)
/// x^2 + s (s + l) q^2 for any length l, here the longer one of L and s. The arm turns, too:
///   K_x = K_y = 2 T / L (1 + s / l),   K_q = 2 T / L s (s + l) + T s
template <Scalar Real>
void add_line_stiffness(BodyId body, const Vec2<Real>& arm, const Vec2<Real>& direction, Real length,
                        Real tension, PerBody<Vec3<Real>>& stiffness);

/// @throws std::invalid_argument unless lower and upper are finite, lower <= upper, and margin is finite and
/// not negative. `unit` as in "m".
void require_limits(const JointLimits& limits, const std::string& place, const std::string& unit);

}  // namespace cairn
