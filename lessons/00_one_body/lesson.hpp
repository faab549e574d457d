// Lesson 00. One box in free flight: as Cairn steps it, by explicit Euler, and exactly.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::one_body {

/// How the box is thrown. It is a unit box of 1 kg: 1 m wide, 1 m high.
struct Throw {
  Vec2<double> start = {-4, 1};        // [m] of its centre
  Vec3<double> velocity = {4, 6, -1};  // [m/s, m/s, rad/s]
  double gravity = 10;                 // [m/s^2], downwards
  double dt = 0.02;                    // [s]
  int steps = 60;
};

/// The whole flight; each list has an element for every instant, the start included.
struct Flight {
  Throw thrown = {};
  Vec3<double> inverse_mass = {0, 0, 0};   // Cairn's diagonal of M^-1, eq. (2)
  List<double> time = {};                  // [s]
  List<Snapshot> cairn = {};               // semi-implicit Euler
  List<Vec2<double>> semi_implicit = {};   // [m] centres of the above
  List<Vec2<double>> explicit_euler = {};  // [m]
  List<Vec2<double>> exact = {};           // [m]
  double gap = 0;  // [m] the largest between Cairn's box and semi-implicit Euler by hand
};

/// The centre of the box, moved by hand.
struct Particle {
  Vec2<double> position = {0, 0};  // [m]
  Vec2<double> velocity = {0, 0};  // [m/s]
};

/// The box on a spring; an element for every instant, the start included.
struct Swing {
  List<double> x = {};  // [m]
  List<double> v = {};  // [m/s]
};

/// The same spring with the two lines of a step in either order.
struct Springs {
  double dt = 0.02;           // [s]
  Swing explicit_euler = {};  // position first
  Swing semi_implicit = {};   // velocity first
};

inline constexpr double swing_seconds = 2;

/// A box that swings twice a second, for swing_seconds, from x = 1 m at rest.
Springs swing(double dt);

/// How far to each side it swings, if it goes on without error from a step, or from the end [m].
double swing_at(const Swing& swing, int step);
double swing_at_end(const Swing& swing);

/// Appends an instant to the flight.
void record(Flight& flight, const World<double>& world, const Particle& semi_implicit,
            const Particle& explicit_euler);

/// Where the exact parabola is at time t [s].
Vec2<double> parabola(const Throw& thrown, double t);

/// How far above the parabola (negative: below) a method ends [m].
double final_error(const Flight& flight, const List<Vec2<double>>& path);

/// What rounding alone may add to a height of the flight [m].
double rounding_of_height(const Flight& flight);

// What is printed, checked and drawn.

void tell_scene(Lesson& lesson, const Flight& flight);
void tell_steps(Lesson& lesson, const Flight& flight);
void tell_springs(Lesson& lesson, const Springs& springs);
void check_claims(Lesson& lesson, const Flight& flight);
void check_springs(Lesson& lesson, const Springs& springs);
CsvTable table_of(const Flight& flight);

/// What all frames share.
struct Story {
  Flight flight = {};
  Springs springs = {};
};

/// All frames, from the question to the answer.
List<Shot> pictures(const Story& story);

// The flight so far, where its three methods are, and how far they miss.

struct SceneLook {
  int step = 0;
  bool velocity = true;  // the arrow
};

/// The box with up to seven earlier outlines and the paths so far; once they part, their ends enlarged.
void draw_scene(Page& page, const Rect& rect, const Story& story, const SceneLook& look);

/// The two orders look the same in all pictures.
SeriesStyle semi_implicit_style(const Page& page);
SeriesStyle explicit_style(const Page& page);

/// The box on its spring, pulled aside, and what is asked.
void draw_spring_question(Page& page, const Rect& rect);

/// Where the box is on its spring, over time, in either order.
void draw_swings(Page& page, const Rect& rect, const Springs& springs);

/// The first swing, velocity against position: a spiral and an ellipse.
void draw_loops(Page& page, const Springs& springs);

/// Height above the parabola over time, up to `step`.
void draw_errors(Page& page, const Rect& rect, const Story& story, int step);

}  // namespace cairn::one_body
