// Floor 9. Jitter from a generator whose numbers the C++ standard fixes.
#include <cairn/study/jitter.hpp>

#include <cmath>
#include <random>

#include <cairn/math/check.hpp>

namespace cairn {

namespace {

/// Uniform in [-1, 1), in steps of 2^-52: std::uniform_real_distribution is not the same everywhere.
double uniform_jitter(std::mt19937_64& generator) {
  return static_cast<double>(generator() >> 11) * 0x1p-52 - 1;
}

}  // namespace

Scene jittered(const Scene& scene, double size, std::uint64_t seed) {
  require(size >= 0 && std::isfinite(size), "jittered", "size", "a finite number >= 0 m", size);
  Scene result = scene;
  std::mt19937_64 generator(seed);
  for (const BodyId body : scene.bodies().indices()) {
    if (scene.bodies()[body].spec.type != BodyType::dynamic) continue;
    const double x = uniform_jitter(generator);
    const double y = uniform_jitter(generator);
    displace(result, {body}, {size * x, size * y});
  }
  return result;
}

Scene nth_start(const Scene& scene, std::uint64_t start) {
  return start == 0 ? scene : jittered(scene, 1e-6, start);
}

}  // namespace cairn
