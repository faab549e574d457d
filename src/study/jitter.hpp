// Floor 9. A scene that begins a little elsewhere.
#pragma once

#include <cstdint>

#include <cairn/world/scene.hpp>

namespace cairn {

/// Every dynamic body moved by up to `size` [m] along x and along y, uniformly; angles stay. The same bits
/// for the same seed with every standard library. Joints keep their places on the bodies, and so begin with
/// an error of that size.
/// @throws std::invalid_argument unless size is a finite number >= 0.
Scene jittered(const Scene& scene, double size, std::uint64_t seed);

/// One of many starts that should come to the same: 0 is the scene as it is, the others are a micrometre off.
Scene nth_start(const Scene& scene, std::uint64_t start);

}  // namespace cairn
