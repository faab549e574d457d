// Lesson 11. All that the lesson computes, before it tells or draws anything.
#include "lesson.hpp"

namespace cairn::friction {

namespace {

constexpr double degree = pi / 180;

/// A slope on which the faster block has room until the end.
Slope long_enough(Slope slope, const Block& block) {
  const double time = slope.steps * slope.dt;
  const double way = coulomb(slope, block).acceleration * time * (time + slope.dt) / 2;
  slope.length = std::max(slope.length, block.from_top + way + 1);
  return slope;
}

Trial trial(const StudySettings& settings, double degrees) {
  Slope slope = settings.slope;
  slope.angle = degrees * degree;
  // The slippery block stands below the rough one, so that it has its way free.
  const Block rough = {.friction = settings.rough, .from_top = 0.7};
  const Block slippery = {.friction = settings.slippery, .from_top = 1.9};
  slope = long_enough(slope, slippery);
  return {.degrees = degrees, .contest = contest(slope, {rough, slippery})};
}

List<Trial> make_trials(const StudySettings& settings) {
  const double first = std::atan(settings.slippery) / degree;
  const double second = std::atan(settings.rough) / degree;
  List<Trial> trials;
  for (const double degrees :
       {std::floor(first) - 1, std::ceil(first), std::floor(second), std::ceil(second)}) {
    trials.push_back(trial(settings, std::max(1.0, degrees)));
  }
  return trials;
}

Curve make_curve(const StudySettings& settings, double friction) {
  Curve curve = {.friction = friction};
  const double first = std::max(2.0, std::atan(settings.slippery) / degree - 6);
  const double last = std::atan(settings.rough) / degree + 5;
  const int points = 12;
  for (int i = 0; i < points; ++i) {
    const double degrees = first + (last - first) * i / (points - 1);
    Slope slope = settings.slope;
    slope.angle = degrees * degree;
    const Block block = {.friction = friction};
    slope = long_enough(slope, block);
    curve.degrees.push_back(degrees);
    curve.cairn.push_back(acceleration_in(Engine::cairn, slope, block));
    if (has_box2d()) curve.box2d.push_back(acceleration_in(Engine::box2d, slope, block));
  }
  return curve;
}

Threshold make_threshold(const Slope& slope, double friction) {
  const double formula = std::atan(friction);
  const double low = std::max(0.5 * degree, formula - 4 * degree);
  const double high = formula + 4 * degree;
  const Block block = {.friction = friction};
  Threshold result = {.friction = friction, .formula = formula / degree};
  result.cairn = critical_angle(Engine::cairn, slope, block, low, high) / degree;
  if (has_box2d()) result.box2d = critical_angle(Engine::box2d, slope, block, low, high) / degree;
  return result;
}

}  // namespace

Study make_study(const StudySettings& settings) {
  const Block slippery = {.friction = settings.slippery};
  const Block rough = {.friction = settings.rough};
  const Block heavy = {.friction = settings.rough, .mass = settings.mass};
  const Slope slope = long_enough(settings.slope, slippery);
  Study study;
  study.settings = settings;
  study.settings.slope = slope;
  study.slippery = slide(slope, slippery);
  study.by_hand = sweeps_by_hand(slope, slippery);
  study.rough = slide(slope, rough);
  study.heavy = slide(slope, heavy);
  study.trials = make_trials(settings);
  for (const double friction : {settings.slippery, settings.rough}) {
    study.curves.push_back(make_curve(settings, friction));
    study.thresholds.push_back(make_threshold(slope, friction));
  }
  return study;
}

double first_force(const Study& study, CornerRow row) {
  return study.by_hand.back()[row] / study.settings.slope.dt;
}

double unfinished(const Slope& slope) {
  // A sweep over the four rows of a block leaves at most 0.65 of the error (measured for every mu up to 0.9
  // and every angle up to 40 degrees); the error begins as the g dt that one step of gravity gives.
  return slope.gravity * slope.dt * std::pow(0.7, slope.sweeps);
}

double rounding(const Slope& slope, double speed) {
  // In each step the velocity is rounded once for gravity, once for each of four rows of the warm start, and
  // a few times more in sweeps that hardly change it: 16 half ulps.
  const double largest = speed + slope.gravity * slope.dt;
  return 8 * epsilon * largest * slope.steps;
}

double blind_angle(const Slope& slope, double friction) {
  // d above the critical angle the way is g d (cos + mu sin) t^2 / 2, and tan = mu there; the bisection adds
  // 0.001.
  const double time = slope.steps * slope.dt;
  return 1e-3 / (slope.gravity * std::hypot(1.0, friction) * time * time / 2) / degree + 0.001;
}

}  // namespace cairn::friction
