// Floor 5. Lengths and speeds that follow from the bodies of a scene.
#include <cairn/world/scene_length.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <cairn/math/list.hpp>

namespace cairn {

namespace {

constexpr double falls_in_steps = 300;
constexpr double margin_of_length = 0.02;
constexpr double usual_threshold = 0.5;  // [m/s] of L = 1 m and
constexpr double usual_gravity = 10;     // [m/s^2]

double nearest_power_of_two(double value) {
  int exponent = 0;
  const double share = std::frexp(value, &exponent);  // from 1/2 to 1
  return std::ldexp(1.0, share < std::sqrt(0.5) ? exponent - 1 : exponent);
}

std::string number_text(const std::optional<double>& given, double value, const char* unit) {
  return fmt::format("{:.3g} {}{}", value, unit, given ? " (as stated)" : "");
}

}  // namespace

double scene_length(const Scene& scene) {
  List<double> lengths;
  for (const SceneBody& body : scene.bodies()) {
    const bool counts = body.spec.type == BodyType::dynamic && !body.removed && body.area > 0;
    if (counts) lengths.push_back(std::sqrt(body.area));
  }
  if (lengths.empty()) return 1;
  double* const middle = lengths.data() + (lengths.size() - 1) / 2;
  std::nth_element(lengths.data(), middle, lengths.data() + lengths.size());
  return nearest_power_of_two(*middle);
}

double unit_length(const Scene& scene) {
  const SceneSettings& settings = scene.settings();
  const double substep = settings.dt / settings.substeps;
  return std::max(scene_length(scene), falls_in_steps * settings.gravity.norm() * (substep * substep));
}

SceneSettings full_settings(const SceneSettings& given, double length) {
  SceneSettings settings = given;
  const double gravity = settings.gravity.norm();
  const double falls =
      std::sqrt(gravity * length / usual_gravity);  // speeds of falls are so many times as fast
  const auto fill = [](std::optional<double>& number, double value) { number = number.value_or(value); };
  fill(settings.speculative_margin, margin_of_length * length);
  fill(settings.stabilization.slop, usual_slop * length);
  fill(settings.stabilization.max_speed, usual_max_speed * (gravity > 0 ? falls : length));
  fill(settings.restitution_threshold, usual_threshold * falls);
  return settings;
}

SceneSettings full_settings(const Scene& scene) {
  return full_settings(scene.settings(), unit_length(scene));
}

std::string lengths_text(const SceneSettings& given, double length) {
  const SceneSettings full = full_settings(given, length);
  const Stabilization &said = given.stabilization, &used = full.stabilization;
  return fmt::format("L is {:.3g} m: margin {}, slop {}, overlap goes by {} at most, rebound from {} on",
                     length, number_text(given.speculative_margin, *full.speculative_margin, "m"),
                     number_text(said.slop, *used.slop, "m"),
                     number_text(said.max_speed, *used.max_speed, "m/s"),
                     number_text(given.restitution_threshold, *full.restitution_threshold, "m/s"));
}

}  // namespace cairn
