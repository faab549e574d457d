// Lesson 11. All that the lesson computes, before it tells or draws anything.
#pragma once

#include "math/list.hpp"
#include "slope.hpp"

namespace cairn::friction {

struct StudySettings {
  Slope slope = {};
  double slippery = 0.5;  // mu of the first block
  double rough = 0.6;     // mu of the second
  double mass = 2;        // [kg] of its heavy twin; the others have 1 kg
};

/// Two blocks, one slippery and one rough, on a slope of `degrees`.
struct Trial {
  double degrees = 0;
  Contest contest = {};
};

/// Accelerations over the angle, measured in both engines.
struct Curve {
  double friction = 0;  // mu
  List<double> degrees = {};
  List<double> cairn = {};  // [m/s^2]
  List<double> box2d = {};  // empty without Box2D
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
  Slide heavy = {};  // the rough block with more mass
  List<Trial> trials = {};
  List<Curve> curves = {};          // slippery, rough
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

}  // namespace cairn::friction
