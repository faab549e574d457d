// Lesson 04. A box that lands on two feet, and two places to put the clamp.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::feet {

inline constexpr double box_mass = 6;      // [kg]
inline constexpr double box_inertia = 1;   // [kg m^2]: the box is 1 m by 1 m
inline constexpr double gravity = 10;      // [m/s^2]
inline constexpr double time_step = 0.02;  // [s]
inline constexpr int motion_steps = 40;    // that are followed after the impact

/// Two numbers, one for each foot: the left one first.
using Pair = FixedList<double, 2>;

/// What is cut off below zero.
enum class Clamped {
  increment,  // every single push: a mistake
  sum,        // what a foot has given in total: Algorithm 1
};

struct FeetSettings {
  double foot = 0.25;  // [m] from the middle of the box to each foot
  double speed = 10;   // [m/s] at which it lands
  int sweeps = 10;
};

/// One row update.
struct Visit {
  int sweep = 0;     // from 1
  int foot = 0;      // 0 or 1
  double jv = 0;     // [m/s] of the foot before, upwards
  double asked = 0;  // [N s] what would stop it
  Pair before = {};  // [N s] sums
  Pair after = {};   // [N s] sums
  double given() const { return after[foot] - before[foot]; }
};

/// One way to solve one landing.
struct Landing {
  Clamped clamped = Clamped::sum;
  List<Visit> visits = {};
  Pair impulse = {};                  // [N s] in the end
  Vec3<double> velocity = {0, 0, 0};  // of the box afterwards
  Pair foot_velocity = {};            // [m/s] of the feet afterwards, upwards
  double together() const { return impulse[0] + impulse[1]; }
  double energy() const;  // [J] afterwards
};

/// One box, landing with both feet together.
struct BoxRun {
  Pair foot = {};                       // [m] right of the middle
  double A11 = 0, A12 = 0, A22 = 0;     // [1/kg]
  Pair exact = {};                      // [N s] by formula
  Pair of_matrix = {};                  // [N s] of projected Gauss-Seidel on A, after as many sweeps
  FixedList<Landing, 2> landings = {};  // in the order of Clamped
  Snapshot snapshot = {};               // as it lands
  const Landing& by(Clamped clamped) const { return landings[static_cast<int>(clamped)]; }
  Landing& by(Clamped clamped) { return landings[static_cast<int>(clamped)]; }
};

/// What naive clamping does for feet at some distance.
struct Spread {
  double foot = 0;   // [m]
  double ratio = 0;  // A_12 / A_11
  double speed = 0;  // [m/s] upwards, afterwards
  double spin = 0;   // [rad/s]
  double formula_speed = 0;
  double formula_spin = 0;
  double gap = 0;  // [N s] to the clamp on the sum
};

struct FeetRun {
  FeetSettings settings = {};
  BoxRun box = {};
  List<Spread> spreads = {};
  List<Snapshot> hop = {};    // after 0, 1, ... steps with the clamp on the increment
  List<Snapshot> still = {};  // and with the clamp on the sum
  double hop_height = 0;      // [m] the most that the middle of the box rises
  double still_height = 0;
};

/// The two rows of a landing: gravity apart, a box that comes down with `speed`, and has to be stopped.
VelocityProblem<double> landing_problem(const Pair& foot, double speed);
/// A box and its A, with what formulas and PGS say, and not landed yet.
BoxRun box_at(const Pair& foot, const FeetSettings& settings);
/// What the clamp on the increment did to a box that has landed.
Spread spread_of(const BoxRun& box, double speed);
/// Lets the box go in a world, with either clamp.
void follow_in_a_world(FeetRun& run);

/// Clamp on the increment: one visit of each foot, and nothing after if A_12 >= 0 [N s].
Pair increments_by_formula(const BoxRun& box, double speed);
/// Clamp on the sum, after so many sweeps [N s].
Pair sums_by_formula(const BoxRun& box, double speed, int sweep);
/// From this distance on, A_12 <= 0: what one foot gives, the other has to give too [m].
double harmless_distance();

/// Without the sign that rounding leaves on what is zero in four decimals.
inline double cleaned(double value) { return std::abs(value) < 5e-5 ? 0 : value; }

/// The same on the page, in the pictures and in the table.
inline const char* name_of_foot(int foot) { return foot == 0 ? "left" : "right"; }

// What is printed, checked and drawn.

/// The question of the card with the numbers of this landing.
std::string question_of(const FeetRun& run);

void tell_scene(Lesson& lesson, const FeetRun& run);
void tell_visits(Lesson& lesson, const FeetRun& run);
void tell_landings(Lesson& lesson, const FeetRun& run);
void tell_motion(Lesson& lesson, const FeetRun& run);
void check_claims(Lesson& lesson, const FeetRun& run);
CsvTable table_of(const FeetRun& run);

/// Visit by visit with both clamps side by side, what becomes of the box, and why.
List<Shot> feet_shots(const FeetRun& run);

/// Their part that comes after the visits.
List<Shot> motion_shots(const FeetRun& run);
Shot spread_shot(const FeetRun& run);

/// What a box shows: sums and what was given last, and how fast its feet move.
struct BoxView {
  Pair impulse = {};        // [N s]
  int foot = -1;            // the one that was visited last; -1: none
  double before = 0;        // [N s] its sum before
  Pair foot_velocity = {};  // [m/s] upwards
  double fastest = 10;      // [m/s] of all that is shown
  bool asks = false;        // with a question mark at the left foot
};
void draw_box(Page& page, const Rect& rect, const BoxRun& box, double largest, const BoxView& view);

/// A panel with a bar in the colour of what is clamped on top, and its name. Returns what is free inside.
Rect clamp_panel(Page& page, const Rect& rect, Clamped clamped);
SeriesStyle style_of(const Theme& theme, Clamped clamped);

}  // namespace cairn::feet
