// A masonry arch: stones that only friction and thrust keep up.
#include "geometry/shape.hpp"
#include "problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double arch_radius = 5;   // [m] of the middle line
const double arch_slop = 1e-4;  // [m]

struct ArchSpec {
  int stones = 21;
  double thickness = 0.11;  // of the radius
  double friction = 0.8;
};

/// A semicircle of equal stones between radial joints, on the ground. The least thickness that stands is, by
/// linear programming over all lines of thrust, 0.10213 of the radius for 9 stones and 0.10679 for 21, on the
/// way to the 0.1075 of M. Milankovitch (1907) for many; about as thick, it slides apart below a friction of
/// 0.395.
Scene arch_of(const ArchSpec& spec) {
  Scene scene({.stabilization = {.slop = arch_slop}});
  scene.add_ground({.friction = spec.friction});
  const double inner = arch_radius * (1 - spec.thickness / 2), outer = arch_radius * (1 + spec.thickness / 2);
  for (int i = 0; i < spec.stones; ++i) {
    const double from = i * pi / spec.stones, to = (i + 1) * pi / spec.stones;
    const Vec2<double> start(std::cos(from), std::sin(from)), end(std::cos(to), std::sin(to));
    scene.add({.shapes = {polygon({inner * start, outer * start, outer * end, inner * end})},
               .friction = spec.friction});
  }
  return scene;
}

/// How far the stone at the crown has sunk after half a second and after a second [m].
struct Sinking {
  double soon = 0;
  double later = 0;
};

Sinking sinking_of_the_crown(const ArchSpec& spec) {
  World world(arch_of(spec));
  const BodyId crown = {(spec.stones + 1) / 2};
  const double start = pose_of(world, crown).position.y();
  SequentialImpulse<double> solver({.iterations = 500});
  Sinking sinking;
  run(world, solver, 0.5);
  sinking.soon = start - pose_of(world, crown).position.y();
  run(world, solver, 0.5);
  sinking.later = start - pose_of(world, crown).position.y();
  return sinking;
}

void check_arch_stands(const ArchSpec& spec) {
  const Sinking sinking = sinking_of_the_crown(spec);
  // While the first sweeps look for the thrust, every joint may close by the slop: that takes n + 1 times as
  // much from the length of the half circle, and a pi-th of it from the radius. Then nothing moves.
  CHECK(std::abs(sinking.soon) <= (spec.stones + 1) * arch_slop / pi);
  CHECK(std::abs(sinking.later - sinking.soon) <= 1e-6);
}

void check_arch_collapses(const ArchSpec& spec) {
  const Sinking sinking = sinking_of_the_crown(spec);
  // Hinges or slides open faster and faster: far beyond any slop.
  CHECK(sinking.later >= 0.1);
  CHECK(sinking.later >= 4 * sinking.soon);
}

}  // namespace

// B36
TEST_CASE("an arch of 9 stones stands where it is 0.105 of its radius thick, and collapses at 0.100") {
  check_arch_stands({.stones = 9, .thickness = 0.105});
  check_arch_collapses({.stones = 9, .thickness = 0.100});
}

// B36
TEST_CASE("an arch of 21 stones stands where it is 0.110 of its radius thick, and collapses at 0.105") {
  check_arch_stands({.stones = 21, .thickness = 0.110});
  check_arch_collapses({.stones = 21, .thickness = 0.105});
}

// B36
TEST_CASE("an arch as thin as that stands on a friction of 0.41 and slides apart on 0.38") {
  check_arch_stands({.friction = 0.41});
  check_arch_collapses({.friction = 0.38});
}
