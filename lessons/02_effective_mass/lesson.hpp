// Lesson 02. A box that falls on a peg: one row, one push, and how heavy the box is for it.
#pragma once

#include "lessons/kit/kit.hpp"

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

// What is printed, checked and drawn.

void print_scene(Lesson& lesson, const PegSettings& settings);
/// The push at the last place, for both bodies.
void print_pair(Lesson& lesson, const Pushes& all);
void print_places(Lesson& lesson, const Pushes& all);
void check_row(Lesson& lesson, const Pushes& all);
void check_motion(Lesson& lesson, const Pushes& all);
void check_others(Lesson& lesson, const Pushes& all);
CsvTable places_table(const Pushes& all);

/// The peg at three places, and the mass that it feels at all.
List<Shot> peg_shots(const Pushes& all);

/// The box on its peg.
struct PegLook {
  bool push = false;        // the impulse as an arrow
  bool asked = false;       // the impulse as a number below the peg, or a question mark
  bool after = false;       // the velocities after it, and where they lead
  bool masses = false;      // bars under the underside: the effective mass there
  bool named = false;       // where the peg is, as the title
  bool directions = false;  // the curve of the effective mass in all directions
};

/// The box, the peg and arrows, in a panel.
void draw_push(Page& page, const Rect& rect, const Pushes& all, const Push& push, const PegLook& look);

}  // namespace cairn::one_push
