// Two engines side by side on one scene.
#pragma once

#include <cairn/cairn.hpp>
#include <cairn/reference/box2d_world.hpp>

namespace cairn::reference_tests {

/// Cairn in double with sequential impulses, and Box2D with as many velocity iterations.
struct Engines {
  explicit Engines(const Scene& scene, const Box2DSettings& settings = {.velocity_iterations = 10})
      : cairn(scene), solver({.iterations = settings.velocity_iterations}), box2d(scene, settings) {}

  void step(int steps = 1) {
    for (int i = 0; i < steps; ++i) {
      cairn.step(solver);
      box2d.step();
    }
  }

  World<double> cairn;
  SequentialImpulse<double> solver;
  Box2DWorld box2d;
};

// Box2D's constants [m], from its b2_common.h.
inline constexpr double box2d_skin = 0.01;   // around every polygon
inline constexpr double box2d_slop = 0.005;  // overlap of skins that is left alone
/// Two polygons come to rest this far apart [m]: their skins overlap by the slop.
inline constexpr double box2d_polygon_gap = 2 * box2d_skin - box2d_slop;

/// Half a unit in the last place of a float near 1: what one rounding may change, relative.
inline constexpr double float_rounding = 6e-8;

inline constexpr double degree = pi / 180;

inline const SnapshotBody& body(const Snapshot& snapshot, BodyId id) { return snapshot.bodies[id]; }

/// Bodies of a box on a plane, and how they were placed.
struct Slope {
  Scene scene = Scene();
  BodyId box = {};
  Vec2<double> start = {0, 0};     // [m] of the box
  Vec2<double> downhill = {1, 0};  // unit
};

struct SlopeSpec {
  double angle = 0;            // [rad], downhill to the right
  Vec2<double> size = {1, 1};  // [m] of the box: along the slope, and across
  double friction = 0;         // mu
  double velocity = 0;         // [m/s] downhill
};

inline Slope box_on_slope(const SlopeSpec& spec) {
  Slope slope;
  slope.downhill = {std::cos(spec.angle), -std::sin(spec.angle)};
  const Vec2<double> normal = perpendicular<double>(slope.downhill);
  slope.start = spec.size.y() / 2 * normal;
  slope.scene.add({.type = BodyType::static_body,
                   .shapes = {box(60, 1)},
                   .position = -0.5 * normal,
                   .angle = -spec.angle,
                   .material = {.friction = spec.friction}});
  slope.box = slope.scene.add({.shapes = {box(spec.size.x(), spec.size.y())},
                               .position = slope.start,
                               .angle = -spec.angle,
                               .velocity = spec.velocity * slope.downhill,
                               .material = {.friction = spec.friction}});
  return slope;
}

}  // namespace cairn::reference_tests
