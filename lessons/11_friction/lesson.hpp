// Lesson 11. A block on a slope: the scene, what Coulomb says of it, and what two engines make of it.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::friction {

inline constexpr BodyId first_block = {2};  // body 0 is the ground, body 1 the slope

/// A slope that goes down to the right, and how it is stepped.
struct Slope {
  double angle = 0;     // [rad]
  double gravity = 10;  // [m/s^2]
  double dt = 0.02;     // [s]
  int sweeps = 50;      // of the solver in each step
  int steps = 100;
  double length = 4;  // [m] of its surface

  Vec2<double> downhill() const { return {std::cos(angle), -std::sin(angle)}; }
  Vec2<double> normal() const { return {std::sin(angle), std::cos(angle)}; }
};

/// A unit box on the slope.
struct Block {
  double friction = 0.5;  // mu against the slope
  double mass = 1;        // [kg]
  double from_top = 1;    // [m] of its centre, along the slope
};

/// Coulomb's law for a block that starts at rest.
struct Coulomb {
  double load = 0;          // [N] m g cos: what the slope carries
  double needed = 0;        // [N] m g sin: the friction that would hold the block
  double limit = 0;         // [N] mu times the load
  double acceleration = 0;  // [m/s^2] downhill: g (sin - mu cos), or 0 where it holds

  double given() const { return acceleration > 0 ? limit : needed; }  // [N] by both corners
};

Coulomb coulomb(const Slope& slope, const Block& block);

/// The whole run of one block. Element k of each list is the state after k steps.
struct Slide {
  Slope slope = {};
  Block block = {};
  List<double> time = {};            // [s]
  List<Snapshot> frames = {};        // Cairn
  List<double> speed = {};           // [m/s] downhill
  List<double> way = {};             // [m] downhill
  List<Snapshot> box2d_frames = {};  // empty in a build without Box2D
  List<double> box2d_speed = {};
  List<SweepRecord> first_step = {};  // the impulses after each sweep of the first step
  // Of any row in any step:
  double worst_cone = -std::numeric_limits<double>::infinity();  // [N] the largest |lambda_t| - mu lambda_n
  double largest_power = -std::numeric_limits<double>::infinity();  // [W] of friction; below 0: it brakes
};

Scene slope_scene(const Slope& slope, const Block& block);
/// The impulses [N s] of all rows after each sweep of the first step, by the plain loop of lesson.cpp; 0:
/// none.
List<PerRow<double>> sweeps_by_hand(const Slope& slope, const Block& block);
/// The same step and all that follow, by the library's solver.
Slide slide(const Slope& slope, const Block& block);

/// Adds the state of the world as it is now.
void look(const World<double>& world, Slide& slide);
/// What the friction rows of the last step did: how far outside their bounds, and with what power.
void judge_rows(const World<double>& world, Slide& slide);
/// Adds Box2D's account of the same slide, where this build has it.
void ask_box2d(Slide& slide);

enum class Engine { cairn, box2d };
/// How far the block slides [m].
double way_in(Engine engine, const Slope& slope, const Block& block);
/// The angle [rad] above which the block slides, bisected between `low` and `high`.
double critical_angle(Engine engine, Slope slope, const Block& block, double low, double high);

/// Whether this build can ask Box2D.
bool has_box2d();
/// Snapshots of `steps` steps of Box2D, the start included. @throws std::logic_error without Box2D.
List<Snapshot> box2d_run(const Scene& scene, int steps, int sweeps);

// All that the lesson computes, before it tells or draws anything.

struct StudySettings {
  Slope slope = {};
  double slippery = 0.5;  // mu of the first block
  double rough = 0.6;     // mu of the second
  double mass = 2;        // [kg] of its heavy twin; the others have 1 kg
};

/// The angle above which a block slides [degrees].
struct Threshold {
  double friction = 0;  // mu
  double formula = 0;   // atan mu
  double cairn = 0;
  double box2d = 0;  // 0 without Box2D
};

struct Study {
  StudySettings settings = {};
  Slide slippery = {};
  List<PerRow<double>> by_hand = {};  // its first step, sweep by sweep, without the solver
  Slide rough = {};
  Slide heavy = {};                 // the rough block with more mass
  List<Threshold> thresholds = {};  // slippery, rough
};

/// The rows of a block, corner by corner.
enum CornerRow { upper_normal, upper_tangent, lower_normal, lower_tangent };
/// What the slippery block's row gives in the first step [N].
double first_force(const Study& study, CornerRow row);

Study make_study(const StudySettings& settings);

/// The velocity [m/s] that the sweeps of the first step, which begin at zero, may leave uncorrected.
double unfinished(const Slope& slope);
/// What rounding may add to a velocity up to the given one in the whole run [m/s].
double rounding(const Slope& slope, double speed);
/// By how much [degrees] a bisection that looks for 1 mm of way finds the critical angle too steep.
double blind_angle(const Slope& slope, double friction);

// What is printed, checked and drawn.

StudySettings settings_of(const Lesson& lesson);

void tell_scene(Lesson& lesson, const Study& study);
/// Needed, limit and verdict for one block.
void tell_law(Lesson& lesson, const Slide& slide);
/// The first step of the slippery block: how the bounds of the tangent rows move with the normal rows.
void tell_sweeps(Lesson& lesson, const Study& study);
/// Speeds, and the angles above which blocks slide.
void tell_run(Lesson& lesson, const Study& study);
void check_study(Lesson& lesson, const Study& study);
CsvTable table_of(const Study& study);

/// All frames, from the question to the answer.
List<Shot> pictures(const Study& study);

// The parts that pictures() puts together.

/// The slide in two engines.
List<Shot> slide_shots(const Study& study);

// Forces on the block, drawn upon the slope.

/// What is drawn at the two corners.
enum class Corners { asked, solved };
/// The friction of both corners: as a question, or with its bracket and the load.
void draw_corners(Page& page, const Rect& rect, const Slide& slide, Corners corners);

}  // namespace cairn::friction
