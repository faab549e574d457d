// Lesson 15. A puck on a table, seen from above, and the three limits that its friction may have.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::top_view {

inline constexpr double puck_mass = 1;   // [kg]
inline constexpr double puck_load = 10;  // [N] what presses it onto the table: N = m g

enum class Method { sequential_impulses, projected_gauss_seidel };

struct SlideSettings {
  double dt = 0.02;  // [s]
  double mu = 0.5;
  Vec2<double> velocity = {3, 4};  // [m/s] at the start

  double limit() const { return mu * puck_load; }                          // [N] mu N
  double slowing() const { return limit() / puck_mass; }                   // [m/s^2] mu g
  double speed() const { return velocity.norm(); }                         // [m/s]
  double distance() const { return speed() * speed() / (2 * slowing()); }  // [m] v^2 / 2 mu g
  double puck_radius() const { return 0.04 * distance(); }  // [m] to be seen; the puck does not turn
  double degrees() const { return std::atan2(velocity.y(), velocity.x()) * 180 / pi; }
};

/// What one step left behind.
struct SlideStep {
  Vec2<double> place = {0, 0};     // [m]
  Vec2<double> velocity = {0, 0};  // [m/s]
  Vec2<double> lambda = {0, 0};    // [N] the friction that acted, along x and y
  Snapshot snapshot = {};
};

/// One puck from its start until it rests: steps[0] is the start.
struct Slide {
  FrictionShape shape = FrictionShape::circle;
  List<SlideStep> steps = {};
};

/// Where the pucks that start in one direction come to rest [m].
struct Direction {
  double degrees = 0;
  Vec2<double> velocity = {0, 0};  // [m/s]
  Vec2<double> circle = {0, 0};
  Vec2<double> square = {0, 0};
  Vec2<double> aligned = {0, 0};
};

struct Slides {
  SlideSettings settings = {};
  VelocityProblem<double> first = {};      // of the square, before its first sweep: row 0 is x, row 1 is y
  Slide circle = {};                       // by sequential impulses, where the paper clamps the vector
  Slide square = {};                       // by PGS, whose rows the paper clamps one by one
  Slide aligned = {};                      // by PGS, its first row along the velocity
  List<Vec2<double>> circle_by_hand = {};  // [m] where the puck is after each step, by a plain loop
  List<Vec2<double>> square_by_hand = {};
  double solver_gap = 0;            // [m] between the two solvers, each with all three shapes
  List<Direction> directions = {};  // all around, every 15 degrees
};

Slides run_slides(const SlideSettings& settings);

/// -m v / dt: the friction that would stop the puck within a step [N]. Both rows have the inverse mass 1/m.
Vec2<double> stopping_lambda(const SlideSettings& settings, const Vec2<double>& velocity);
/// Each part clamped to mu N: the square.
Vec2<double> parts_clamped(const SlideSettings& settings, const Vec2<double>& lambda);
/// The length clamped to mu N, the direction kept: the circle (paper 4.5).
Vec2<double> vector_clamped(const SlideSettings& settings, const Vec2<double>& lambda);

/// One of the two.
using Limit = Vec2<double> (*)(const SlideSettings& settings, const Vec2<double>& lambda);

/// The puck's place [m] after each step, in a plain loop.
List<Vec2<double>> slide_by_hand(const SlideSettings& settings, Limit clamped);
/// The same by the library.
Scene puck_on_table(const SlideSettings& settings, FrictionShape shape);
Slide slide_once(const SlideSettings& settings, FrictionShape shape, Method method);
SlideStep look_from_above(const World<double>& world);

/// Until the puck that gets farthest has been at rest for two steps.
int step_count(const SlideSettings& settings);

/// How far something with this speed gets that loses mu g dt in a step [m]: semi-implicit Euler's answer.
double stopping_distance(const SlideSettings& settings, double speed);

/// The same for x and y, each by itself: where the puck with the square stops [m].
Vec2<double> stop_on_rails(const SlideSettings& settings, const Vec2<double>& velocity);

// What is printed, checked and drawn.

SlideSettings settings_of(const Lesson& lesson);

/// "(−3.00, −4.00)"
std::string pair_text(const Vec2<double>& pair, int decimals);

void print_scene(Lesson& lesson, const SlideSettings& settings);
void print_slides(Lesson& lesson, const Slides& all);
void check_slides(Lesson& lesson, const Slides& all);
CsvTable steps_table(const Slides& all);

/// One row at a time in the first step, then the slide, then all directions.
List<Shot> slide_shots(const Slides& all);

// The parts of the frames of lesson 15.

/// What of the plane of the friction forces is shown beside its limits.
struct Forces {
  List<Vec2<double>> grey = {};    // [N]
  List<Vec2<double>> active = {};  // [N]
  Vec2<double> velocity = {0, 0};  // [m/s] with a dashed line against it; 0: none
};

/// The pucks where they are after step k, their paths, what moves them and what holds them.
Camera draw_table(Page& page, const Rect& rect, const Slides& all, int k);

/// The names of both limits, in their colours.
/// How the circle looks, or the square: in what is drawn, and in the names of it.
SeriesStyle limit_style(const Page& page, bool is_circle);
TextStyle name_style(const Page& page, double size, const Color& color);

/// From the start to where a puck stops: a line `aside` px beside its way, and words beside it.
void draw_dimension(Page& page, const Camera& camera, const Vec2<double>& end, double aside,
                    const List<std::string>& lines, const Color& color);

/// The plane of the friction forces with the square, the circle, and some forces.
Camera draw_limits(Page& page, const Rect& rect, const Slides& all, const Forces& forces);

/// Where the pucks stop in the first `count` directions, and how far and where to over the direction.
void draw_directions(Page& page, const Slides& all, int count);

}  // namespace cairn::top_view
