// The landing as two rows by hand, its formulas, and the box let go in a world.
#include "lesson.hpp"

namespace cairn::feet {

namespace {

constexpr double foot_radius = 0.054, leg = 0.066;  // [m] the middle of a foot is a leg below the box

/// A box on two round feet: each touches the ground in one point. Two more, above, put the centre of mass
/// into its middle.
BodySpec box_on_feet(const Pair& foot, double speed) {
  const double at = 0.5 + leg;
  return {.shapes = {circle(foot_radius, {foot[0], -at}), circle(foot_radius, {foot[1], -at}),
                     circle(foot_radius, {-foot[0], at}), circle(foot_radius, {-foot[1], at})},
          .position = {0, at + foot_radius},
          .velocity = {0, -speed},
          .mass = box_mass,
          .inertia = box_inertia,
          .material = {.friction = 0}};
}

/// The same after its landing, with corners that touch the ground, too. While it lands they must not: its
/// feet alone are to stop it, and the wrong clamp leaves such speeds within that step that a corner would
/// help.
BodySpec with_corners(BodySpec box, const Pose<double>& pose, const Vec3<double>& velocity) {
  constexpr double radius = 0.02;
  List<Shape<double>> shapes(box.shapes.begin(), box.shapes.end());
  for (const double x : {-1, 1})
    for (const double y : {-1, 1}) shapes.push_back(circle(radius, {(0.5 - radius) * x, (0.5 - radius) * y}));
  box.shapes = shapes;
  box.position = pose.position;
  box.angle = pose.angle;
  box.velocity = velocity.head<2>();
  box.angular_velocity = velocity.z();
  return box;
}

Scene on_the_ground(const BodySpec& box) {
  Scene scene({.gravity = {0, -gravity},
               .dt = time_step,
               .stabilization = {.policy = StabilizationPolicy::baumgarte},
               .warm_start = false});
  scene.add_ground({.material = {.friction = 0}});
  scene.add(box);
  return scene;
}

/// As it is drawn: with the box.
Snapshot with_box(Snapshot now) {
  List<Shape<double>> shapes = {box(1, 1)};
  for (int foot = 0; foot < 2; ++foot) shapes.push_back(now.bodies[{1}].shapes[foot]);
  now.bodies[{1}].shapes = shapes;
  return now;
}

List<Snapshot> followed(const FeetSettings& settings, Clamp clamp) {
  // Gravity acts before the solve: it lands with `speed`.
  const BodySpec box = box_on_feet({-settings.foot, settings.foot}, settings.speed - gravity * time_step);
  World landing(on_the_ground(box));
  SequentialImpulse solver({.iterations = settings.sweeps}, {.clamp = clamp});
  List<Snapshot> motion = {with_box(snapshot(landing))};
  landing.step(solver);
  motion.push_back(with_box(snapshot(landing)));
  const SnapshotBody& landed = motion.back().bodies[{1}];
  World world(on_the_ground(with_corners(box, landed.pose, landed.velocity)));
  for (int step = 1; step < motion_steps; ++step) {
    world.step(solver);
    motion.push_back(with_box(snapshot(world)));
  }
  return motion;
}

double height_of(const List<Snapshot>& motion) {
  double highest = 0;
  for (const Snapshot& moment : motion)
    highest =
        std::max(highest, moment.bodies[{1}].pose.position.y() - motion[0].bodies[{1}].pose.position.y());
  return highest;
}

}  // namespace

double Landing::energy() const {
  return 0.5 * box_mass * (velocity.x() * velocity.x() + velocity.y() * velocity.y()) +
         0.5 * box_inertia * velocity.z() * velocity.z();
}

VelocityProblem<double> landing_problem(const Pair& foot, double speed) {
  VelocityProblem<double> problem;
  problem.dt = time_step;
  problem.inverse_mass = {{0, 0, 0}, {1 / box_mass, 1 / box_mass, 1 / box_inertia}};  // the ground, the box
  problem.velocity = {{0, 0, 0}, {0, -speed, 0}};
  problem.impulse = {0, 0};
  for (const double x : foot) {
    ConstraintRow<double> row;
    row.a = {0};
    row.b = {1};
    row.jacobian_a = {0, -1, 0};
    row.jacobian_b = {0, 1, x};
    row.bounds = Bounds<double>::unilateral();
    row.key = {.source = static_cast<std::uint64_t>(problem.row_count())};
    problem.blocks.push_back({problem.row_count(), 1});
    problem.rows.push_back(row);
  }
  return problem;
}

BoxRun box_at(const Pair& foot, const FeetSettings& settings) {
  BoxRun run{.foot = foot};
  const VelocityProblem<double> problem = landing_problem(foot, settings.speed);
  const SystemMatrices<double> system = system_matrices(problem);
  run.A11 = system.A(0, 0);
  run.A12 = system.A(0, 1);
  run.A22 = system.A(1, 1);
  run.exact = {settings.speed / (run.A11 + run.A12), settings.speed / (run.A11 + run.A12)};
  VelocityProblem<double> twin = problem;
  ProjectedGaussSeidel<double>({.iterations = settings.sweeps}).solve(twin);
  run.of_matrix = {twin.impulse[0], twin.impulse[1]};
  run.snapshot = with_box(snapshot(on_the_ground(box_on_feet(foot, settings.speed))));
  return run;
}

Spread spread_of(const BoxRun& box, double speed) {
  const Landing& naive = box.by(Clamped::increment);
  Spread spread{.foot = box.foot[1],
                .ratio = box.A12 / box.A11,
                .speed = naive.velocity.y(),
                .spin = naive.velocity.z()};
  const double q = std::max(spread.ratio, 0.0);
  spread.formula_speed = speed * q * (1 - q) / 2;
  spread.formula_spin = -spread.foot * speed * q / (box.A11 * box_inertia);
  for (int i = 0; i < 2; ++i)
    spread.gap = std::max(spread.gap, std::abs(naive.impulse[i] - box.by(Clamped::sum).impulse[i]));
  return spread;
}

void follow_in_a_world(FeetRun& run) {
  run.hop = followed(run.settings, Clamp::increment);
  run.still = followed(run.settings, Clamp::accumulated);
  run.hop_height = height_of(run.hop);
  run.still_height = height_of(run.still);
}

Pair increments_by_formula(const BoxRun& box, double speed) {
  const double first = speed / box.A11;
  return {first, (speed - box.A12 * first) / box.A22};
}

Pair sums_by_formula(const BoxRun& box, double speed, int sweep) {
  const double q = box.A12 / box.A11;
  const double each = speed / (box.A11 + box.A12);
  return {each * (1 + std::pow(q, 2 * sweep - 1)), each * (1 - std::pow(q, 2 * sweep))};
}

double harmless_distance() { return std::sqrt(box_inertia / box_mass); }

}  // namespace cairn::feet
