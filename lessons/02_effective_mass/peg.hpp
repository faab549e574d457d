// A box that falls on a peg: one row, one push, and how heavy the box is for it.
#pragma once

#include <string>

#include "cairn.hpp"
#include "math/list.hpp"

namespace cairn::one_push {

struct PegSettings {
  double mass = 6;   // [kg] of the unit box
  double speed = 1;  // [m/s] at which it falls
  double dt = 0.02;  // [s]
  double x = 0.5;    // [m] of the peg to the right of the centre
};

/// A push as (19)-(22) say, without the solver.
struct HandPush {
  double impulse = 0;            // lambda dt [N s]
  Vec3<double> v_a = {0, 0, 0};  // of the peg, after it
  Vec3<double> v_b = {0, 0, 0};  // of the box
};

/// Everything about one push.
struct Push {
  double x = 0;                             // [m] of the peg
  ConstraintRow<double> row = {};           // of the contact: a is the peg, b the box
  Snapshot before = {};                     // with v_1
  Snapshot after = {};                      // the same poses with v_2
  PerBody<Vec3<double>> inverse_mass = {};  // the diagonal of M^-1 (17), of ground, peg and box
  double inverse = 0;                       // j M^-1 j^T [1/kg], from the row
  double by_matrices = 0;                   // the same entry of A = J M^-1 J^T (15)
  double impulse = 0;                       // lambda dt [N s], as the solver found it
  HandPush by_hand = {};
  double rate_before = 0, rate_after = 0;  // j·v_1, j·v_2 [m/s]
};

/// The peg held by something of finite mass.
struct OtherMass {
  double mass = 0;       // [kg]; 0: it cannot be moved
  double effective = 0;  // [kg] of box and peg together, in the middle
};

struct Pushes {
  PegSettings settings = {};
  List<Push> at = {};  // x = 0, half of settings.x, settings.x
  Push mirrored = {};  // x = -settings.x
  List<OtherMass> others = {};
  double sideways = 0;  // [kg] of the friction row in the middle of the underside
};

/// 1 / (1/m + (r x d)^2 / I) [kg]: the effective mass at the arm r in the direction d, by hand.
double mass_at(double mass, const Vec2<double>& arm, const Vec2<double>& direction);
/// I of the unit box [kg m^2].
double inertia_of(double mass);

}  // namespace cairn::one_push
