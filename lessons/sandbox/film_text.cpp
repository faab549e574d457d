// Words and numbers in the frames of a film.
#include "lessons/sandbox/film_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cairn::sandbox {
namespace {

/// What markup would read as a subscript is taken literally.
std::string literal(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    if (letter == '_' || letter == '^') out += '\\';
    out += letter;
  }
  return out;
}

/// "body 3 (bomb)".
std::string body_text(const SceneEntry& scene, BodyId body) {
  const bool is_named = body.index < scene.body_names.size() && !scene.body_names[body].empty();
  return fmt::format("body {}", body.index) + (is_named ? " (" + literal(scene.body_names[body]) + ")" : "");
}

/// The fastest body, as run_trial() judges it.
std::string fastest_text(const SceneEntry& scene, const Snapshot& snapshot) {
  BodyId fastest = ground;
  double speed = 0;
  bool spins = false;
  for (const BodyId body : snapshot.bodies.indices()) {
    const Vec3<double>& v = snapshot.bodies[body].velocity;
    const double along = std::hypot(v.x(), v.y()), around = std::abs(v.z());
    if (std::max(along, around) > speed) {
      speed = std::max(along, around);
      spins = around > along;
      fastest = body;
    }
  }
  return body_text(scene, fastest) +
         fmt::format(" {} {:.2g} {}", spins ? "spins at" : "moves at", speed, spins ? "rad/s" : "m/s");
}

}  // namespace

std::string error_text(double metres) {
  const double value = 1e3 * metres;
  if (!std::isfinite(value)) return "not finite";
  if (value >= 1e5) return fmt::format("{:.2g} mm", value);
  return fmt::format("{:6.2f} mm", value);
}

std::string time_text(const Snapshot& now, const Snapshot& last) {
  const std::string step = fmt::format(" s · step {:4}", now.step);
  if (last.time >= 1e6) return fmt::format("t = {:.6g}", now.time) + step;
  const double per_step = last.step > 0 ? last.time / last.step : 1;  // [s]
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(std::max(per_step, 1e-12)))), 3, 9);
  const std::size_t width = fmt::format("{:.{}f}", last.time, decimals).size();
  return fmt::format("t = {:{}.{}f}", now.time, std::max<std::size_t>(width, 6), decimals) + step;
}

std::string ending_text(const SceneEntry& scene, const SceneRun& run) {
  if (run.result.status == TrialStatus::ok) return "";
  const std::string when = fmt::format("stopped at t = {:.4g} s: ", run.result.seconds);
  if (run.result.not_finite) return when + body_text(scene, *run.result.not_finite) + " would not be finite";
  if (run.result.status == TrialStatus::diverged && !run.frames.empty())
    return when + fastest_text(scene, run.frames.back());
  return when + status_text(run.result.status);
}

}  // namespace cairn::sandbox
