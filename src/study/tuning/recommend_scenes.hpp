// Floor 9. The scenes that recommendations and targets are tried with.
#pragma once

#include <cairn/world/scene.hpp>

namespace cairn {

/// Boxes of 1 m and 1 kg on the ground, under a last one of `top` kg. Each is up to 1 um off, so that nothing
/// stands by symmetry alone.
Scene tower_of_boxes(int boxes, double top = 1);

enum class ChainStart { level, hanging };
/// Links of 0.5 m and 1 kg from a pin, and a bob. They do not bump into each other.
Scene chain_with_bob(int links, double bob, ChainStart start);

/// Rows of boxes, each with one less than that below it.
Scene pyramid_of_boxes(int rows);
/// Discs and boxes of 0.9 m that fall into a bin of 9 m.
Scene bin_of_bodies(int bodies);
/// A fast body of about 0.2 m, 3.3 m before a wall of 0.1 m at x = 0, on its way along x; the last body.
Scene shot_at_wall(double speed, const Shape<double>& shape, double restitution);
/// Three boxes of 1 m on a table at (x, x).
Scene boxes_far_off(double x);

}  // namespace cairn
