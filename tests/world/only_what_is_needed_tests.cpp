// Steps do what the scene asks for and nothing else: rows, pairs, bodies, solves and memory are counted.
#include <set>
#include <sstream>

#include <cairn/samples/samples.hpp>
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// Boxes one on the other, on the ground.
Scene tower_of_boxes(int boxes, double friction, const SceneSettings& settings = {}) {
  BodySpec lowest = samples::standing_box();
  lowest.material.friction = friction;
  return samples::stack(boxes, settings, lowest);
}

StepReport report_of_one_step(const Scene& scene, int iterations = 10) {
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = iterations});
  return world.step(solver);
}

/// What explain() lists and does not leave out, but for the count of bodies.
std::set<std::string> parts_in_use(const Scene& scene) {
  std::istringstream lines(explain(make_plan(scene)));
  std::set<std::string> parts;
  std::string line;
  std::getline(lines, line);  // "This scene needs"
  while (std::getline(lines, line)) {
    const std::string name = line.substr(2, line.find("  ", 2) - 2);
    if (name != "bodies" && line.find("left out") == std::string::npos) parts.insert(name);
  }
  return parts;
}

/// A disc that needs nothing at all.
BodySpec bare_disc(const Vec2<double>& position) {
  return {.shapes = {circle(0.5)}, .position = position, .material = {.friction = 0}, .fixed_rotation = true};
}

Scene bare_scene(SceneSettings settings = {}) {
  settings.gravity = {0, 0};
  settings.warm_start = false;
  return Scene(settings);
}

/// bare_scene with one body.
Scene scene_of(const BodySpec& spec) {
  Scene scene = bare_scene();
  scene.add(spec);
  return scene;
}

/// One body on a hinge at the ground, one on a slide: rows that the two joints write together.
int rows_of_hinge_and_slide(RevoluteJoint::Spec hinge, PrismaticJoint::Spec slide) {
  Scene scene = bare_scene();
  hinge.b = scene.add({.shapes = {circle(0.1)}, .position = {-5, 0}});
  hinge.anchor = {-5, 1};
  slide.b = scene.add({.shapes = {circle(0.1)}, .position = {5, 0}});
  slide.anchor = {5, 0};
  scene.join<RevoluteJoint>(hinge);
  scene.join<PrismaticJoint>(slide);
  return World<double>(scene).velocity_problem().row_count();
}

}  // namespace

TEST_CASE("a tower of n boxes has 2 n normal rows, and 2 n or n or 0 friction rows") {
  for (const int n : {1, 3, 10}) {
    CAPTURE(n);
    CHECK(report_of_one_step(tower_of_boxes(n, 0.5)).rows == 4 * n);
    CHECK(report_of_one_step(tower_of_boxes(n, 0.5, {.friction_rows = FrictionRows::per_manifold})).rows ==
          3 * n);
    CHECK(report_of_one_step(tower_of_boxes(n, 0)).rows == 2 * n);
    CHECK(report_of_one_step(tower_of_boxes(n, 0.5)).contacts == 2 * n);
  }
}

TEST_CASE("only the pairs that rub have friction rows, in a scene where some do") {
  // From below: 0.5 on 0.5, 0 on 0.5, 0.5 on 0. One of three interfaces rubs, with two points.
  Scene scene;
  scene.add_ground({.material = {.friction = 0.5}});
  const List<double> frictions = {0.5, 0, 0.5};
  for (int i = 0; i < frictions.size(); ++i) {
    scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5 + i}, .material = {.friction = frictions[i]}});
  }
  CHECK(report_of_one_step(scene).rows == 3 * 2 + 2);
}

TEST_CASE("a limit away from where the joint is, and a motor that is not there, have no rows") {
  // A pin has two rows, and so has a slide.
  const int bare = 4;
  CHECK(rows_of_hinge_and_slide({}, {}) == bare);
  CHECK(rows_of_hinge_and_slide({.lower = -2, .upper = 2}, {.lower = -3, .upper = 3}) == bare);
  CHECK(rows_of_hinge_and_slide({.lower = -0.1, .upper = 2}, {.lower = -3, .upper = 3}) == bare + 1);
  CHECK(rows_of_hinge_and_slide({.lower = -0.1, .upper = 2}, {.lower = -3, .upper = 0.1}) == bare + 2);
  CHECK(rows_of_hinge_and_slide({.motor = RevoluteJoint::Motor{.speed = 1, .max_torque = 1}}, {}) ==
        bare + 1);
  CHECK(rows_of_hinge_and_slide({}, {.motor = PrismaticJoint::Motor{.speed = 1, .max_force = 1}}) ==
        bare + 1);
}

TEST_CASE("a slack rope has no row until its slack is within the margin") {
  Scene scene({.gravity = {0, 0}});
  const double length = 3, margin = 0.25, speed = 1.7;
  const BodyId body = scene.add({.shapes = {circle(0.1)}, .position = {1, 0}, .velocity = {speed, 0}});
  DistanceJoint::Spec rope = samples::rope(length);
  rope.slack_margin = margin;
  samples::hang(scene, body, {0, 0}, rope);
  World world(scene);
  SequentialImpulse<double> solver;
  int with_row = 0;
  for (int step = 0; step < 65; ++step) {
    const double slack = length - world.bodies().pose[{1}].position.x();
    const int rows = world.step(solver).rows;
    CHECK(rows == (slack < margin ? 1 : 0));
    with_row += rows;
  }
  // Slack is 2 - 1.7 t: below the margin from 1.0294 s on, which is step 62 of those from 0.
  CHECK(with_row == 65 - 62);
}

TEST_CASE("bodies that cannot move never meet each other, and every row has a body that can") {
  Scene scene;
  scene.add_ground();
  for (int i = 0; i < 8; ++i) {
    const BodyType type = i % 2 == 0 ? BodyType::static_body : BodyType::kinematic;
    scene.add(
        {.type = type, .shapes = {box(1, 1)}, .position = {0.1 * i, 0}});  // in each other and the ground
  }
  scene.add({.shapes = {circle(0.5)}, .position = {0.4, 0.2}});
  for (const int more_shapes : {0, 40}) {  // few are compared each with each, many are sorted
    for (int i = 0; i < more_shapes; ++i) {
      scene.add({.type = BodyType::static_body, .shapes = {box(1, 1)}, .position = {100 + 0.1 * i, 0}});
    }
    World<double> world = world_after(scene, 1);
    CHECK(world.last_step().problem.contacts.size() == 9);  // the disc with the ground and the eight
    for (const ConstraintRow<double>& row : world.last_step().problem.rows) {
      CHECK(inverse_effective_mass(world.last_step().problem, row) > 0);
    }
  }
}

TEST_CASE("a static body stays where it is to the last bit, whatever presses on it") {
  Scene scene;
  const BodyId shelf = scene.add(
      {.type = BodyType::static_body, .shapes = {box(4, 0.2)}, .position = {0.3, 0.7}, .angle = 0.1});
  for (int i = 0; i < 4; ++i) scene.add({.shapes = {box(1, 1)}, .position = {0.3, 1.4 + 1.1 * i}});
  World world(scene);
  const Pose<double> start = world.bodies().pose[shelf];
  take_steps(world, 60);
  CHECK(world.last_step().problem.row_count() > 0);
  CHECK(world.bodies().pose[shelf].position == start.position);
  CHECK(world.bodies().pose[shelf].angle == start.angle);
  CHECK(world.bodies().velocity[shelf] == Vec3<double>::Zero());
}

TEST_CASE("rotation that is fixed has 1/I = 0 in the problem, and the mass stays") {
  Scene scene;
  const BodyId fixed = scene.add({.shapes = {box(1, 1)}, .density = 4, .fixed_rotation = true});
  const BodyId turns = scene.add({.shapes = {box(1, 1)}, .position = {5, 0}, .density = 4});
  const VelocityProblem<double> problem = World<double>(scene).velocity_problem();
  CHECK(problem.inverse_mass[fixed] == Vec3<double>(0.25, 0.25, 0));
  // I of a square of side 1 is m / 6: 1/I = 6/4, to a few roundings.
  CHECK(problem.inverse_mass[turns].z() == doctest::Approx(1.5).epsilon(1e-14));
}

TEST_CASE("each part of a scene switches on its own lines of the plan, and no others") {
  using Parts = std::set<std::string>;
  CHECK(parts_in_use(scene_of(bare_disc({0, 0}))).empty());

  BodySpec disc = bare_disc({0, 0});
  disc.fixed_rotation = false;
  CHECK(parts_in_use(scene_of(disc)) == Parts{"rotation"});
  disc = bare_disc({0, 0});
  disc.damping.linear = 0.1;
  CHECK(parts_in_use(scene_of(disc)) == Parts{"damping"});

  Scene second = scene_of(bare_disc({0, 0}));
  second.set_settings(
      {.gravity = {0, 0}, .stabilization = {.policy = StabilizationPolicy::baumgarte}, .warm_start = false});
  second.add(bare_disc({3, 0}));
  CHECK(parts_in_use(second) == Parts{"collision"});
  disc = bare_disc({6, 0});
  disc.material.restitution = 0.5;
  second.add(disc);
  CHECK(parts_in_use(second) == Parts{"collision", "restitution"});
  disc = bare_disc({9, 0});
  disc.material.friction = 0.5;
  second.add(disc);
  CHECK(parts_in_use(second) == Parts{"collision", "restitution"});  // mu is 0 on the other side still
  disc.position = {12, 0};
  second.add(disc);
  CHECK(parts_in_use(second) == Parts{"collision", "friction", "restitution"});
  second.set_settings({.gravity = {0, 0}, .warm_start = false});
  CHECK(parts_in_use(second) == Parts{"collision", "friction", "restitution", "second solve"});

  Scene joined = scene_of(bare_disc({0, 0}));
  joined.join<DistanceJoint>({.a = ground, .b = {1}, .anchor_a = {0, 2}});
  CHECK(parts_in_use(joined) == Parts{"joints", "second solve"});
  joined.set_settings(
      {.gravity = {0, 0}, .stabilization = {.policy = StabilizationPolicy::baumgarte}, .warm_start = false});
  CHECK(parts_in_use(joined) == Parts{"joints"});
}

TEST_CASE("each setting of a scene switches on its own line of the plan, and no other") {
  using Parts = std::set<std::string>;
  const auto parts = [](const SceneSettings& settings) {
    Scene scene(settings);
    scene.add(bare_disc({0, 0}));
    return parts_in_use(scene);
  };
  const Vec2<double> no_gravity(0, 0);
  CHECK(parts({.gravity = {0, -1}, .warm_start = false}) == Parts{"gravity"});
  CHECK(parts({.gravity = no_gravity, .warm_start = true}) == Parts{"warm start"});
  CHECK(parts({.gravity = no_gravity, .substeps = 2, .warm_start = false}) == Parts{"substeps"});
  for (const StabilizationPolicy policy : {StabilizationPolicy::soft, StabilizationPolicy::split_impulse}) {
    CHECK(parts({.gravity = no_gravity, .stabilization = {.policy = policy}, .warm_start = false}) ==
          Parts{"second solve"});
  }
}

TEST_CASE("the plan says where friction has one row for two points") {
  const std::string per_point = explain(make_plan(tower_of_boxes(1, 0.5)));
  const std::string per_manifold =
      explain(make_plan(tower_of_boxes(1, 0.5, {.friction_rows = FrictionRows::per_manifold})));
  CHECK(per_point.find("one row a contact point, where mu > 0") != std::string::npos);
  CHECK(per_manifold.find("one row a manifold, where mu > 0") != std::string::npos);
}

TEST_CASE("a step solves once a substep, and twice only where the policy needs it") {
  const int iterations = 7;
  for (const int substeps : {1, 3}) {
    const auto sweeps = [&](StabilizationPolicy policy) {
      const SceneSettings settings = {.substeps = substeps, .stabilization = {.policy = policy}};
      return report_of_one_step(tower_of_boxes(3, 0.5, settings), iterations).sweeps;
    };
    CHECK(sweeps(StabilizationPolicy::none) == substeps * iterations);
    CHECK(sweeps(StabilizationPolicy::baumgarte) == substeps * iterations);
    CHECK(sweeps(StabilizationPolicy::relaxed) == 2 * substeps * iterations);
    CHECK(sweeps(StabilizationPolicy::soft) == 2 * substeps * iterations);
    CHECK(sweeps(StabilizationPolicy::split_impulse) == 2 * substeps * iterations);
  }
}

TEST_CASE("sequential impulses keep one number a row of a world, and never a matrix") {
  for (const int n : {1, 10, 30}) {
    World world(tower_of_boxes(n, 0.5));
    SequentialImpulse<double> impulses;
    ProjectedGaussSeidel<double> matrices({.iterations = 1});
    const int rows = world.step(impulses).rows;
    CHECK(rows == 4 * n);
    const auto m = static_cast<std::size_t>(rows);
    CHECK(impulses.memory() == m * sizeof(double));
    world.step(matrices);
    CHECK(matrices.memory() > m * m * sizeof(double));  // A alone
  }
}
