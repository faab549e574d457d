// Scene files and frozen problems, and what all targets share.
#include "fuzz/fuzz_target.hpp"

#include <functional>
#include <sstream>

#include <cairn/study/frozen/frozen_problem.hpp>
#include "fuzz/fuzz_words.hpp"
#include "fuzz/random_world.hpp"
#include <cairn/math/check.hpp>
#include <cairn/scenes/scene_file.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/solvers/iterative/sequential_impulse.hpp>
#include <cairn/world/world.hpp>

namespace cairn::fuzz {

namespace {

const std::size_t longest_message = 600;  // [bytes]
const int most_bodies = 60;               // of a scene that is stepped, and as many joints
const int most_dense_rows = 300;          // of a problem that every solver is given
const int most_exact_rows = 12;           // of one for the exact solver too
const int most_fuzz_substeps = 4;

/// Refusals are one line for people: where, what, and which rule.
Outcome refused(const std::string& message) {
  if (message.empty() || message.size() > longest_message || message.find('\n') != std::string::npos) {
    throw Finding("a refusal is no line: " + message);
  }
  if (message.find(": ") == std::string::npos) throw Finding("a refusal names no place: " + message);
  return {.accepted = false, .message = message};
}

Outcome outcome_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Finding&) {
    throw;
  } catch (const std::invalid_argument& error) {
    return refused(error.what());
  } catch (const std::length_error& error) {
    return refused(error.what());
  } catch (const std::exception& error) {
    throw Finding(std::string("an exception of another kind: ") + error.what());
  }
  return {.accepted = true};
}

template <Scalar Real>
void require_finite_bodies(const World<Real>& world, const char* scalar) {
  for (const BodyId body : world.bodies().pose.indices()) {
    const Pose<Real>& pose = world.bodies().pose[body];
    if (pose.position.allFinite() && std::isfinite(pose.angle) && world.bodies().velocity[body].allFinite()) {
      continue;
    }
    throw Finding(std::string("in ") + scalar + " body " + std::to_string(body.index) +
                  " is not finite, and no report says so");
  }
}

template <Scalar Real>
void step_a_little(const Scene& scene, const char* scalar) {
  World<Real> world(scene);
  SequentialImpulse<Real> solver({.iterations = 3});
  for (int step = 0; step < 5; ++step) {
    world.step(solver);  // what it reports, it has not done
    require_finite_bodies(world, scalar);
  }
  snapshot(world);
}

void feed_scene(const std::string& text) {
  const SceneEntry entry = read_scene_text(text, "fuzz.toml");
  Scene scene = entry.make();
  if (scene.bodies().size() > most_bodies || scene.joints().size() > most_bodies) return;
  SceneSettings settings = scene.settings();
  settings.substeps = std::min(settings.substeps, most_fuzz_substeps);
  scene.set_settings(settings);
  step_a_little<double>(scene, "double");
  const Outcome in_float = outcome_of([&] { step_a_little<float>(scene, "float"); });
  if (!in_float.accepted && in_float.message.find("World: ") != 0) throw Finding(in_float.message);
}

/// A solver may leave what is not finite of numbers near the largest ones; the world looks for it after every
/// solve. Of moderate numbers it may not.
bool is_moderate(const VelocityProblem<double>& problem) {
  const double least = 1e-15, most = 1e15;
  const auto fits = [&](double x) { return x == 0 || (std::abs(x) >= least && std::abs(x) <= most); };
  const auto all_fit = [&](const Vec3<double>& v) { return fits(v.x()) && fits(v.y()) && fits(v.z()); };
  const auto fits_bound = [&](double x) { return fits(x) || std::isinf(x); };
  bool moderate = fits(problem.dt);
  for (const Vec3<double>& velocity : problem.velocity) moderate &= all_fit(velocity);
  for (const Vec3<double>& inverse_mass : problem.inverse_mass) moderate &= all_fit(inverse_mass);
  for (const double impulse : problem.impulse) moderate &= fits(impulse);
  for (const RowTerm<double>& term : problem.extra_terms) moderate &= all_fit(term.jacobian);
  for (const ConstraintRow<double>& row : problem.rows) {
    moderate &= all_fit(row.jacobian_a) && all_fit(row.jacobian_b) && fits(row.bias) && fits(row.softness);
    moderate &= fits(row.bounds.friction) && fits(row.bounds.disc);
    moderate &= fits_bound(row.bounds.lower) && fits_bound(row.bounds.upper);
  }
  return moderate;
}

void solve_a_little(const VelocityProblem<double>& given, const SolverEntry& entry) {
  VelocityProblem<double> problem = given;
  make_solver<double>(entry.name, {.iterations = 3})->solve(problem);
  if (!is_moderate(given)) return;
  for (const Vec3<double>& velocity : problem.velocity) {
    if (!velocity.allFinite()) throw Finding(entry.name + " leaves a velocity that is not finite");
  }
  for (const double impulse : problem.impulse) {
    if (!std::isfinite(impulse)) throw Finding(entry.name + " leaves an impulse that is not finite");
  }
}

void feed_frozen(const std::string& text) {
  std::istringstream in(text);
  const FrozenProblem frozen = read_frozen(in, "fuzz.json");
  for (const SolverEntry& entry : solver_entries()) {
    const bool is_exact = entry.name == "reference";
    if (frozen.problem.row_count() > (is_exact ? most_exact_rows : most_dense_rows)) continue;
    solve_a_little(frozen.problem, entry);
  }
  std::ostringstream out;
  write_frozen(out, frozen);  // what was read can be written
}

}  // namespace

const List<std::string>& target_names() {
  static const List<std::string> names = {"scene", "frozen", "words", "world"};
  return names;
}

Target target_of(const std::string& name) {
  for (int i = 0; i < target_names().size(); ++i) {
    if (target_names()[i] == name) return static_cast<Target>(i);
  }
  require(false, "cairn_fuzz", "target", "scene, frozen, words or world", name);
  return Target::scene;
}

Outcome feed(Target target, const std::string& bytes) {
  if (target == Target::words) return feed_words(bytes);
  if (target == Target::world) return feed_world(bytes);
  return outcome_of([&] { target == Target::scene ? feed_scene(bytes) : feed_frozen(bytes); });
}

}  // namespace cairn::fuzz
