// The scenes, and counts by formula.
#include "lesson.hpp"

#include <cairn/solvers/body_rows.hpp>

namespace cairn::stored {

Scene pyramid_scene(int base, double spacing) {
  Scene scene({.gravity = {0, -10}, .dt = 0.02, .stabilization = {.policy = StabilizationPolicy::baumgarte}});
  scene.add_ground({.material = {.friction = 0}});
  for (int row = 0; row < base; ++row) {
    const int boxes = base - row;
    for (int i = 0; i < boxes; ++i) {
      const double x = spacing * (i - 0.5 * (boxes - 1));
      scene.add({.shapes = {box(1, 1)}, .position = {x, 0.5 + row}, .mass = 1, .material = {.friction = 0}});
    }
  }
  return scene;
}

Scene tray_scene(int boxes) {
  Scene scene({.gravity = {0, -10}, .dt = 0.02, .stabilization = {.policy = StabilizationPolicy::baumgarte}});
  constexpr double pitch = 1.25;  // [m]
  const double width = pitch * boxes;
  scene.add_ground({.half_width = width, .material = {.friction = 0}});
  scene.add({.shapes = {box(width, 0.5)}, .position = {0, 0.25}, .mass = 1, .material = {.friction = 0}});
  for (int i = 0; i < boxes; ++i) {
    const double x = pitch * (i - 0.5 * (boxes - 1));
    scene.add({.shapes = {box(1, 1)}, .position = {x, 1}, .mass = 1, .material = {.friction = 0}});
  }
  return scene;
}

Snapshot with_contacts(const Scene& scene) {
  World world(scene);
  SequentialImpulse solver({.iterations = 1});
  world.step(solver);
  Snapshot result = snapshot(scene);
  result.contacts = snapshot(world).contacts;
  return result;
}

Work work_of(const Count& count) {
  return {
      .naive = 6 * count.dense, .dense = count.dense, .sparse = count.pairs, .si = si_products * count.rows};
}

/// The lowest row stands on the ground; every other box on two.
double rows_by_formula(int base) { return 2.0 * base + 4 * (base * (base - 1) / 2.0); }

double pairs_by_formula(int base) {
  double sum = 0;
  double shared = 0;  // manifolds between two boxes
  for (int row = 0; row < base; ++row) {
    const int boxes = base - row;
    for (int i = 0; i < boxes; ++i) {
      const int below = row == 0 ? 1 : 2;
      const int above = (i > 0 ? 1 : 0) + (i + 1 < boxes ? 1 : 0);
      const double rows = 2.0 * (below + above);
      sum += rows * rows;
      shared += above;
    }
  }
  return sum - 4 * shared;
}

double count_entries(const Eigen::MatrixXd& matrix) {
  const double largest_entry = matrix.cwiseAbs().maxCoeff();
  return static_cast<double>((matrix.array().abs() > 1e-12 * largest_entry).count());
}

List<List<char>> pattern(const VelocityProblem<double>& problem) {
  List<List<char>> result;
  for (const ConstraintRow<double>& first : problem.rows) {
    List<char>& line = result.emplace_back();
    for (const ConstraintRow<double>& second : problem.rows)
      line.push_back(coupling(problem, first, second, problem.inverse_mass) != 0);
  }
  return result;
}

std::string bytes_text(double bytes) {
  if (bytes < 1024) return fmt::format("{:.0f} B", bytes);
  if (bytes < 1024 * 1024) return fmt::format("{:.1f} KiB", bytes / 1024);
  return fmt::format("{:.1f} MiB", bytes / 1024 / 1024);
}

}  // namespace cairn::stored
