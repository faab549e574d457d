// Floor 8. Scenes that closed forms, frozen problems and tests share.
//
// A header without a source file: the tests of the core link nothing of this room.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <random>

#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/constraints/weld_joint.hpp>
#include <cairn/geometry/shape.hpp>
#include <cairn/math/list.hpp>
#include <cairn/samples/samples.hpp>
#include <cairn/world/scene.hpp>

namespace cairn::cases {

/// Numbers between two others that are the same on every machine, which those of the distributions of the
/// standard library are not.
inline std::function<double(double, double)> uniform_numbers(std::uint64_t seed) {
  return [engine = std::mt19937_64(seed)](double lower, double upper) mutable {
    return lower + (upper - lower) * std::ldexp(static_cast<double>(engine() >> 11), -53);
  };
}

/// Boxes of 1 m on the ground, one on the other, with these masses [kg] from the lowest up; `shift` [m] to
/// the left and to the right in turn; the ground as wide to both sides as `half_width` [m].
inline Scene box_column(const List<double>& masses, double shift = 0, double half_width = 50) {
  Scene scene;
  scene.add_ground({.half_width = half_width});
  for (int i = 0; i < masses.size(); ++i) {
    const double x = i % 2 == 0 ? -shift : shift;
    scene.add({.shapes = {box(1, 1)}, .position = {x, 0.5 + static_cast<double>(i)}, .mass = masses[i]});
  }
  return scene;
}

struct ArchSpec {
  int stones = 21;          // odd: one of them is the crown
  double thickness = 0.11;  // of the radius
  double friction = 0.8;
  double radius = 5;   // [m] of the middle line
  double slop = 1e-4;  // [m]
};

/// The corners of stone i [m], counted from the right: straight edges between radial joints.
inline List<Vec2<double>> arch_stone(const ArchSpec& spec, int i) {
  const double from = i * pi / spec.stones, to = (i + 1) * pi / spec.stones;
  const double inner = spec.radius * (1 - spec.thickness / 2), outer = spec.radius * (1 + spec.thickness / 2);
  const Vec2<double> start(std::cos(from), std::sin(from)), end(std::cos(to), std::sin(to));
  return {inner * start, outer * start, outer * end, inner * end};
}

/// A semicircle of equal stones between radial joints, on the ground. The least thickness for which a line of
/// thrust runs inside of it is 0.10153 of the radius for 9 of these straight stones and 0.10670 for 21 (a
/// little more for stones bent along arcs), on the way to the 0.1075 of M. Milankovitch (1907) for many; 21
/// stones of 0.11 slide apart below a friction of 0.3918.
inline Scene masonry_arch(const ArchSpec& spec) {
  Scene scene({.stabilization = {.slop = spec.slop}});
  scene.add_ground({.material = {.friction = spec.friction}});
  for (int i = 0; i < spec.stones; ++i) {
    scene.add({.shapes = {polygon(arch_stone(spec, i))}, .material = {.friction = spec.friction}});
  }
  return scene;
}

/// Boxes of 1 m and 1 kg in a horizontal row, the first welded to the ground.
inline Scene welded_beam(int boxes) {
  Scene scene;
  BodyId last = ground;
  for (int k = 0; k < boxes; ++k) {
    const BodyId next = scene.add({.shapes = {box(1, 1)}, .position = {k + 0.5, 0}, .mass = 1});
    scene.join<WeldJoint>({.a = last, .b = next, .anchor = {static_cast<double>(k), 0}});
    last = next;
  }
  return scene;
}

/// Boxes of 1 m in rows of base, base - 1, ..., 1 on the ground, neighbours 0.1 m apart.
inline void add_pyramid(Scene& scene, int base) {
  scene.add_ground({.half_width = 0.6 * base + 10});
  samples::add_pyramid(scene, {.base = base, .pitch = 1.1});
}

/// The free end of a chain.
struct ChainEnd {
  BodyId last = {};
  Vec2<double> place = {0, 0};  // [m]
};

/// Rods of 0.5 m that hang from the ground at `top`, each below the one before, and swing from an angle at
/// which none of its numbers vanishes.
inline ChainEnd add_chain(Scene& scene, int links, const Vec2<double>& top) {
  const double link_length = 0.5;  // [m]
  const double angle = 0.5;        // [rad] from the vertical
  const Vec2<double> down(std::sin(angle), -std::cos(angle));
  ChainEnd end{.last = ground, .place = top};
  for (int i = 0; i < links; ++i) {
    const Vec2<double> anchor = top + i * link_length * down;
    const BodyId link = scene.add(
        {.shapes = {box(0.1, link_length)}, .position = anchor + link_length / 2 * down, .angle = angle});
    scene.join<RevoluteJoint>({.a = end.last, .b = link, .anchor = anchor});
    end = {link, top + (i + 1) * link_length * down};
  }
  return end;
}

struct SiloSpec {
  int rows = 15;               // of four discs
  double width = 5;            // [m] between the walls
  double friction = 0.5;       // of a disc on a disc
  double wall_friction = 0.5;  // of a disc on a wall
  double floor_velocity = 0;   // [m/s] upwards
  std::uint64_t seed = 1;      // of the places and sizes of the discs
};

struct Silo {
  Scene scene;
  BodyId floor = {};  // kinematic, without friction
  double weight = 0;  // [N] of all discs
};

/// Discs of 0.8 to 1 m above a floor between two walls, 0.05 m to the side and back at random.
inline Silo silo_before_settling(const SiloSpec& spec) {
  const std::function<double(double, double)> uniform = uniform_numbers(spec.seed);
  Silo silo{.scene = Scene({.dt = 1.0 / 120})};
  Scene& scene = silo.scene;
  const double tall = 1.1 * spec.rows + 5;
  silo.floor = scene.add({.type = BodyType::kinematic,
                          .shapes = {box(spec.width - 0.02, 1)},
                          .position = {0, -0.5},
                          .velocity = {0, spec.floor_velocity},
                          .material = {.friction = 0}});
  for (const double side : {-1.0, 1.0}) {
    scene.add({.type = BodyType::static_body,
               .shapes = {box(2, tall)},
               .position = {side * (spec.width / 2 + 1), tall / 2 - 2},
               // mixed: the square root of both
               .material = {.friction = spec.wall_friction * spec.wall_friction / spec.friction}});
  }
  for (int row = 0; row < spec.rows; ++row) {
    for (int i = 0; i < 4; ++i) {
      const double radius = uniform(0.4, 0.5);
      const double x = -spec.width / 2 + 0.6 + 1.25 * i + uniform(-0.05, 0.05);
      scene.add({.shapes = {circle(radius)},
                 .position = {x, 0.6 + 1.05 * row},
                 .material = {.friction = spec.friction}});
      silo.weight += pi * radius * radius * scene.settings().gravity.norm();
    }
  }
  return silo;
}

}  // namespace cairn::cases
