// Floor 3. How errors go, in plain numbers: the law for a row, whether it stands alone or in a lane.
#pragma once

namespace cairn {

/// What the bias and the softness of rows are made from, which all contacts of a substep share, and all
/// joints on the same spring. Whoever has many rows side by side, compiled for several instruction sets,
/// computes with it too: the functions that read it are part of those that call them, and need no library.
template <typename Real>
struct RowRule {
  Real dt = 0;                 // [s]
  bool only_corrects = false;  // positions: no friction, no motor, no rebound
  Real slop = 0;               // [m] that is left alone, but not on springs
  Real rigid_rate = 0;         // [1/s] beta / dt of (7); 0 where errors are not to go now
  bool has_springs = false;    // errors are on springs
  Real spring_rate = 0;        // [1/s] of these, what beta / dt is to rigid rows
  Real spring_divisor = 1;     // of what a row carries [1/kg], gives the softness of its spring
  Real most_softness = 0;      // [1/kg]
  Real most_speed = 0;         // [m/s] with which overlap is taken back
  Real gravity = 0;  // [m/s^2] no faster than half of a fall through the overlap under this; 0: no such rule
};

/// [1/s] The share of its error that a row takes back in a second.
template <typename Real>
[[gnu::always_inline]] inline Real error_rate(const RowRule<Real>& rule, bool on_spring) {
  return on_spring ? rule.spring_rate : rule.rigid_rate;
}

/// std::sqrt.
[[gnu::always_inline]] inline float square_root(float x) { return __builtin_sqrtf(x); }
/// std::sqrt.
[[gnu::always_inline]] inline double square_root(double x) { return __builtin_sqrt(x); }

/// zeta (7) [m/s] of a row that only pushes:
///   with room left (C > 0)        -C / dt: it may use its room up, and no more
///   where it is violated (C < 0)  beta max(0, -C - slop) / dt, on a spring its rate times -C; but no faster
///                                 than the rule allows
template <typename Real>
[[gnu::always_inline]] inline Real pushing_bias(const RowRule<Real>& rule, Real room, Real slop_limit,
                                                bool on_spring) {
  const Real slop = slop_limit < rule.slop ? slop_limit : rule.slop;
  const Real beyond = on_spring ? -room : -room - slop;
  const Real overlap = 0 < beyond ? beyond : Real(0);
  const Real fall = square_root(rule.gravity * overlap / 2);
  const Real most_speed = rule.gravity > 0 && fall < rule.most_speed ? fall : rule.most_speed;
  const Real wish = error_rate(rule, on_spring) * overlap;
  return room < 0 ? (most_speed < wish ? most_speed : wish) : -room / rule.dt;
}

/// zeta [m/s] of the normal row of a contact: pushing_bias(), and at least its rebound [m/s]. In the second
/// solve only the rebound is asked for, and room may be used.
template <typename Real>
[[gnu::always_inline]] inline Real contact_bias(const RowRule<Real>& rule, Real separation, Real slop_limit,
                                                Real rebound, bool on_spring, bool is_second) {
  const Real bias = pushing_bias(rule, separation, slop_limit, on_spring);
  const Real only_room = bias > 0 ? Real(0) : bias;
  const Real wish = is_second ? only_room : bias;
  return rebound > 0 && (is_second || wish < rebound) ? rebound : wish;
}

/// gamma [1/kg] of a row on a spring of the rule that carries this [1/kg].
template <typename Real>
[[gnu::always_inline]] inline Real spring_softness(const RowRule<Real>& rule, Real carried) {
  const Real softness = carried / rule.spring_divisor;
  return rule.most_softness < softness ? rule.most_softness : softness;
}

}  // namespace cairn
