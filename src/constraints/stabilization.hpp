// Floor 3. How fast errors go: policies, the rules that they make, and what these do to contacts.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include <cairn/constraints/row.hpp>
#include <cairn/constraints/row_rule.hpp>
#include <cairn/constraints/softness.hpp>

namespace cairn {

/// What becomes of errors in positions, which velocities alone never take back.
enum class StabilizationPolicy {
  none,           // nothing: they stay, and grow by the error of integration
  baumgarte,      // (4), (7): velocities carry a share beta / dt of them; they keep that speed afterwards
  relaxed,        // as baumgarte; a second solve, without that share, takes the speed out; joints follow
                  // their arcs, and where there are any, bodies take part with the mass max(M, dt^2 K):
                  // Constraint::add_stiffness, add_contact_stiffness
  soft,           // stiff springs in the rows; a second solve, without springs, takes their speed out again
  split_impulse,  // velocities of their own, which move the bodies once and are forgotten
};

/// Which velocities a row is written for.
enum class StabilizationPass {
  velocity,  // those of the step
  second,    // of the policies relaxed and soft: those that stay once positions have moved
  position,  // of the policy split_impulse: those that only correct positions
};

/// [m] Stabilization::slop where it is left out, of bodies that are 1 m long.
inline constexpr double usual_slop = 0.005;
/// [m/s] Stabilization::max_speed likewise.
inline constexpr double usual_max_speed = 4;

/// How errors go. Rigid contacts may keep `slop` of overlap, so that they do not flicker; the springs of
/// policy soft give way by themselves and leave none. Sources: J. Baumgarte (1972); E. Catto, Solver2D
/// (2024), for soft rows with a relaxing solve; E. Coumans' Bullet for split impulses.
struct Stabilization {
  StabilizationPolicy policy = StabilizationPolicy::relaxed;  // what becomes of errors
  double baumgarte = 0.2;  // beta: the share of an error that one step removes
  /// [m] Overlap of rigid contacts that is left alone; less of small ones. Left out: 5 mm, or, in a world,
  /// 0.005 of its unit of length (world/scene_length.hpp).
  std::optional<double> slop = {};
  /// [m/s] Left out: 4, or, in a world, the speed of a fall through 0.8 of that length. Contacts take overlap
  /// back no faster than this, nor under baumgarte than by sqrt(g depth / 2), half the speed of a
  /// fall through it: it lifts a body out and no higher, however short the step. Infinite: neither holds.
  std::optional<double> max_speed = {};
  /// Springs of policy soft: of contacts, and of joints, which carry more and rattle less. Neither swings
  /// more often than 0.25 / dt.
  SwingSoftness soft = {.frequency = 30, .damping_ratio = 10};
  SwingSoftness joint_soft = {.frequency = 60, .damping_ratio = 5};  // of joints, and their limits

  /// Member by member.
  bool operator==(const Stabilization&) const = default;
};

/// [m/s] What max_speed is.
inline double most_speed(const Stabilization& stabilization) {
  return stabilization.max_speed.value_or(usual_max_speed);
}

/// A spring of policy soft in steps of dt [s]: at most one swing in four steps, for steps could not follow a
/// faster one.
SwingSoftness spring_in_steps(SwingSoftness spring, double dt);

/// [m] By how much a spring gives way at rest in such steps, g / omega^2, where a load would accelerate what
/// it acts on by `acceleration` [m/s^2].
double spring_sag(const SwingSoftness& spring, double dt, double acceleration);

/// The rule for the rows of contacts in a step of dt [s], of bodies that rise against `gravity` [m/s^2].
template <Scalar Real>
RowRule<Real> contact_rule(const Stabilization& stabilization, StabilizationPass pass, Real dt,
                           double gravity);
/// The rule for the rows of joints on this spring, Stabilization::joint_soft.
template <Scalar Real>
RowRule<Real> joint_rule(const Stabilization& stabilization, StabilizationPass pass, Real dt);

}  // namespace cairn
