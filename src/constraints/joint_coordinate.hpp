// Floor 3. What may be asked of the one coordinate of a joint: limits, a motor, a spring, a ratchet.
#pragma once

#include <optional>

#include <cairn/constraints/joint_rows.hpp>

namespace cairn {

/// A spring along the coordinate of a joint.
struct JointSpring {
  Softness softness = SpringSoftness{.stiffness = 1};  // of an angle [N m/rad] and [N m s/rad]
  double rest = 0;                                     // [rad or m] where it neither pushes nor pulls
};

/// An angle q of b against a [rad], or how far b has slid along a [m], and what is asked of it. With j_q, its
/// row:
///   lower limit  C = q - lower >= 0,  j = j_q,   impulse >= 0
///   upper limit  C = upper - q >= 0,  j = -j_q,  impulse >= 0
///   motor        no C,                j = j_q,   j v = speed, |impulse| <= max_force dt
///   servo        C = q - target,      j = j_q,   j v as below,  |impulse| <= max_force dt
///   spring       C = q - rest,        j = j_q,   soft
///   ratchet      C = q - n tooth >= 0,  j = j_q,   impulse >= 0
/// A servo is a motor with a target. Its speed follows what is missing, rather than its force: so it holds
/// the target itself under any load below max_force, where a spring would give way. It goes by
///   |j v| = min(speed, rate |C|, sqrt(|C| max_force / m))
/// with what m of both bodies resists, where the joint's own rows hold: half of max_force stops that in time,
/// so it does not overshoot while the load leaves the other half. What hangs on other joints is not in m. A
/// rate of more than 1 / dt is 1 / dt.
/// A ratchet of positive teeth lets q grow, and holds it at the last tooth n that it has passed; of negative
/// ones the other way round. It knows the tooth by q alone: one that has been pressed back by less than
/// ratchet_play of a tooth is still on it. Sources: the bounds as in E. Catto, Modeling and Solving
/// Constraints (2009); a speed that follows the error as in E. Catto, Box2D manual, Revolute Joint, and as a
/// line that a limited force slides along in V. Utkin, Variable Structure Systems with Sliding Modes (1977).
class JointCoordinate {
 public:
  /// Of a tooth: a pawl that is this deep in it holds it.
  static constexpr double ratchet_play = 0.02;

  /// Nothing is asked.
  JointCoordinate() = default;
  /// `place` and `unit`, "rad" or "m", are what messages say.
  /// @throws std::invalid_argument for limits, motor, spring or ratchet that are out of range.
  JointCoordinate(const JointLimits& limits, const std::optional<JointMotor>& motor,
                  const std::optional<JointSpring>& spring, const std::optional<double>& ratchet,
                  const char* place, const char* unit);

  /// Whether nothing is asked.
  bool is_free() const { return !limits_.lower && !limits_.upper && !motor_ && !spring_ && !ratchet_; }
  /// The range that it is kept in.
  const JointLimits& limits() const { return limits_; }
  /// Its motor, if it has one.
  const std::optional<JointMotor>& motor() const { return motor_; }
  /// Its spring, if it has one.
  const std::optional<JointSpring>& spring() const { return spring_; }
  /// The tooth of its ratchet, if it has one [rad or m].
  const std::optional<double>& ratchet() const { return ratchet_; }
  /// Gives it another motor, or none. @throws std::invalid_argument as the constructor.
  void change(const std::optional<JointMotor>& motor);
  /// Says what it has in the traits of its joint.
  JointTraits marked(JointTraits traits) const;

  /// Writes the rows of what is asked: `coordinate` is the row of q, `held` are those that
  /// the joint keeps.
  template <Scalar Real>
  void add_rows(const RigidRow<Real>& coordinate, Span<const RigidRow<Real>> held,
                RowWriter<Real>& rows) const;
  /// [N m or N] What they gave together, along the coordinate.
  template <Scalar Real>
  Real force(const RowForces<Real>& forces) const;

 private:
  void require_motor() const;

  JointLimits limits_;
  std::optional<JointMotor> motor_;
  std::optional<JointSpring> spring_;
  std::optional<double> ratchet_;
  const char* place_ = "";
  const char* unit_ = "";
};

}  // namespace cairn
