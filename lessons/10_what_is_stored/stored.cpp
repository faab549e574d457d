// The scenes, the three pairs, and counts by formula.
#include "lesson.hpp"

#include <cairn/solvers/body_rows.hpp>

namespace cairn::stored {

namespace {

constexpr double height = 0.5;  // [m]

/// A body for a case: a uniform box about `x`, and two arms without mass below its sides.
struct CaseBody {
  double x = 0;
  double width = 1;
  double mass = 1;
  double reach = 0;  // [m] from one end of the arms to the other; 0: none

  double inertia() const { return mass * (width * width + height * height) / 12; }
};

/// A point where the ground pushes body `body` (from 1) upwards.
struct CaseContact {
  int body = 1;
  double x = 0;
};

List<Shape<double>> shapes_of(const CaseBody& body) {
  List<Shape<double>> shapes = {box(body.width, height)};
  const double low = -height / 2, half = body.reach / 2;
  if (half > 0) shapes.push_back(polygon({{-half, low}, {half, low}, {half, low + 0.1}, {-half, low + 0.1}}));
  return shapes;
}

PairCase pair_case(const std::string& title, const List<CaseBody>& bodies,
                   const List<CaseContact>& contacts) {
  Scene scene({.stabilization = {.policy = StabilizationPolicy::baumgarte}});
  scene.add_ground();
  for (const CaseBody& body : bodies) {
    scene.add({.shapes = shapes_of(body),
               .position = {body.x, height / 2},
               .mass = body.mass,
               .inertia = body.inertia()});
  }
  PairCase result{.title = title, .snapshot = snapshot(scene)};
  VelocityProblem<double>& problem = result.problem;
  problem.inverse_mass.push_back({0, 0, 0});
  for (const CaseBody& body : bodies) {
    problem.inverse_mass.push_back({1 / body.mass, 1 / body.mass, 1 / body.inertia()});
  }
  problem.velocity.assign(problem.inverse_mass.size(), Vec3<double>::Zero());
  problem.impulse.assign(contacts.size(), 0.0);
  for (const CaseContact& contact : contacts) {
    const double arm = contact.x - bodies[contact.body - 1].x;
    ConstraintRow<double> row;
    row.a = ground;
    row.b = {contact.body};
    row.jacobian_a = {0, -1, -contact.x};  // about the origin of the ground
    row.jacobian_b = {0, 1, arm};
    row.bounds = Bounds<double>::unilateral();
    problem.blocks.push_back({problem.row_count(), 1});
    problem.rows.push_back(row);
    result.snapshot.contacts.push_back(
        {.a = ground, .b = {contact.body}, .position = {contact.x, 0}, .normal = {0, 1}});
  }
  const PerBody<Vec3<double>> ones(problem.inverse_mass.size(), Vec3<double>::Ones());
  result.printed = coupling(problem, problem.rows[0], problem.rows[1], ones);
  result.coupling = coupling(problem, problem.rows[0], problem.rows[1], problem.inverse_mass);
  return result;
}

}  // namespace

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

/// J_1 . J_2 has a share 1 + r_1 r_2 of the body, with arms from its centre, and a share 1 + x_1 x_2 of the
/// ground, with places from its origin: below the centre in the first two cases, so that both say the same.
List<PairCase> pair_cases() {
  const CaseBody struck{.x = 0, .width = std::sqrt(1.75), .mass = 6};  // I = 1 kg m^2, r_1 r_2 = -I / m
  CaseBody armed = struck;                                             // r_1 r_2 = -1
  armed.reach = 4.4;
  const CaseBody left{.x = -1, .width = 1, .mass = 1};
  const CaseBody right{.x = 1.5, .width = 1, .mass = 1};
  return {pair_case("counted as 0, and is not", {armed}, {{1, -2}, {1, 0.5}}),
          pair_case("counted, and is 0", {struck}, {{1, -1.0 / 3}, {1, 0.5}}),
          pair_case("counted, though only the ground is shared", {left, right}, {{1, -1}, {2, 1.5}})};
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

List<List<Entry>> pattern(const VelocityProblem<double>& problem) {
  const PerBody<Vec3<double>> ones(problem.inverse_mass.size(), Vec3<double>::Ones());
  List<List<Entry>> result;
  for (const ConstraintRow<double>& first : problem.rows) {
    List<Entry>& line = result.emplace_back();
    for (const ConstraintRow<double>& second : problem.rows) {
      const bool is_true = coupling(problem, first, second, problem.inverse_mass) != 0;
      const bool is_printed = coupling(problem, first, second, ones) != 0;
      line.push_back(is_true ? (is_printed ? Entry::true_entry : Entry::missed)
                             : (is_printed ? Entry::printed_only : Entry::zero));
    }
  }
  return result;
}

std::string bytes_text(double bytes) {
  if (bytes < 1024) return fmt::format("{:.0f} B", bytes);
  if (bytes < 1024 * 1024) return fmt::format("{:.1f} KiB", bytes / 1024);
  return fmt::format("{:.1f} MiB", bytes / 1024 / 1024);
}

}  // namespace cairn::stored
