// How fast errors go: the biases of rows, and what a world does with them.
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// A row between the ground and body 1 along y.
RowSpec<double> row_along_y(double error, const Bounds<double>& bounds) {
  RowSpec<double> spec;
  spec.b = {1};
  spec.error = error;
  spec.jacobian_a = {0, -1, 0};
  spec.jacobian_b = {0, 1, 0};
  spec.bounds = bounds;
  return spec;
}

const Stabilization quarter_and_eighth = {.baumgarte = 0.25, .slop = 0.125};  // powers of two: exact results
const double half_second = 0.5;                                               // [s]

/// A step of half a second in which body 1, of 1 kg, would go along y at v without constraints.
VelocityProblem<double> problem_at(double v) {
  VelocityProblem<double> problem;
  problem.dt = half_second;
  problem.velocity = {Vec3<double>::Zero(), Vec3<double>(0, v, 0)};
  problem.inverse_mass = {Vec3<double>::Zero(), Vec3<double>(1, 1, 1)};
  return problem;
}

/// The row of a joint, as it is written behind ten others.
ConstraintRow<double> written(const RowSpec<double>& spec) {
  VelocityProblem<double> problem = problem_at(0);
  problem.rows.resize(10);
  const BodyState<double> begin = {{}, problem.velocity, problem.inverse_mass};
  const RowRule<double> rule = joint_rule(quarter_and_eighth, StabilizationPass::velocity, half_second);
  int next = 10;
  const RowWriting<double> writing{.begin = begin, .problem = problem, .next = next, .rule = rule};
  ProblemRows<double>(writing, 17).add(spec);
  return problem.rows[10];
}
double bias_of(const RowSpec<double>& spec) { return written(spec).bias; }

/// One point of a contact.
struct Touch {
  double separation = 0;  // [m]
  double rebound = 0;     // [m/s] that it asks for, if the bodies meet
  double slop_limit = std::numeric_limits<double>::infinity();
};

struct StabilizedContact {
  double bias = 0, softness = 0;  // in the first solve
  SecondRow<double> second = {};
};

/// The contact of body 1, which goes along y at v, with the ground, under a gravity of 8 m/s^2. Before it was
/// as fast as rebounds ask for.
StabilizedContact contact_at(const Touch& touch, double v, const Stabilization& how,
                             StabilizationPass pass = StabilizationPass::velocity) {
  Contact<double> contact{.a = {0}, .b = {1}, .restitution = 1, .slop_limit = touch.slop_limit};
  contact.manifold.count = 1;
  contact.manifold.normal = {0, 1};
  contact.manifold.points[0].separation = touch.separation;
  VelocityProblem<double> problem = problem_at(v);
  problem.rule = contact_rule(how, pass, half_second, 8);
  const PerBody<Vec3<double>> before = {Vec3<double>::Zero(), Vec3<double>(0, -touch.rebound, 0)};
  meet(contact, before, 0.0, problem);
  List<SecondRow<double>> second;
  int next = 0;
  write_contact_rows(contact, problem, next, &second);
  const StabilizedContact result = {problem.rows[0].bias, problem.rows[0].softness, second[0]};
  if (pass == StabilizationPass::position) return result;
  problem.is_second = true;
  next = 0;
  write_contact_rows(contact, problem, next);
  CHECK(problem.rows[0].bias == result.second.bias);
  CHECK(problem.rows[0].softness == result.second.softness);
  return result;
}

double contact_bias(double separation, double rebound = 0, double v = 0) {
  return contact_at({separation, rebound}, v, quarter_and_eighth).bias;
}

}  // namespace

TEST_CASE("an equality asks for a share beta of its error to go in one step, in either direction") {
  const Bounds<double> bounds = Bounds<double>::equality();
  CHECK(bias_of(row_along_y(2, bounds)) == -0.25 * 2 / half_second);
  CHECK(bias_of(row_along_y(-2, bounds)) == 0.25 * 2 / half_second);
  CHECK(bias_of(row_along_y(0, bounds)) == 0);
}

TEST_CASE("an inequality may use up the room that it has, and no more") {
  for (const double room : {2.0, 0.0}) {
    CHECK(bias_of(row_along_y(room, Bounds<double>::unilateral())) == -room / half_second);
    CHECK(contact_bias(room) == -room / half_second);
  }
}

TEST_CASE("an overlap within the slop is left alone, and of the rest beta goes in one step") {
  for (const double depth : {0.0625, 0.125, 1.125}) {
    const double expected = 0.25 * std::max(0.0, depth - 0.125) / half_second;
    CHECK(bias_of(row_along_y(-depth, Bounds<double>::unilateral())) == expected);
    CHECK(contact_bias(-depth) == expected);
  }
  RowSpec<double> tight = row_along_y(-1, Bounds<double>::unilateral());
  tight.keeps_slop = false;
  CHECK(bias_of(tight) == 0.25 / half_second);
  CHECK(contact_at({.separation = -1, .slop_limit = 0.0625}, 0, quarter_and_eighth).bias ==
        0.25 * (1 - 0.0625) / half_second);
}

TEST_CASE("a rebound counts where the bodies would meet within the step, as far as it is the faster") {
  CHECK(contact_bias(1, 3, -4) == 3);                    // 1 m away at 4 m/s: they meet in 0.25 s
  CHECK(contact_bias(1, 3, -1) == -1 / half_second);     // in 1 s: not in this step
  CHECK(contact_bias(1, 3, 4) == -1 / half_second);      // they part
  const double push = 0.25 * (7 - 0.125) / half_second;  // deep overlap: stabilization is faster
  CHECK(contact_bias(-7, 3, -4) == push);
}

TEST_CASE("contacts take overlap back no faster than they may") {
  CHECK(contact_bias(-81) == usual_max_speed);
  Stabilization how = quarter_and_eighth;
  how.max_speed = std::numeric_limits<double>::infinity();
  CHECK(contact_at({-81}, 0, how).bias == 0.25 * (81 - 0.125) / half_second);
  how = {.policy = StabilizationPolicy::baumgarte, .baumgarte = 1, .slop = 0, .max_speed = 4};
  CHECK(contact_at({-0.25}, 0, how).bias == 0.25 / half_second);
  CHECK(contact_at({-1}, 0, how).bias == 1 / half_second);
  // sqrt(g d / 2), half of a fall through it: at d = 2.25 m 3 m/s; and 4 m/s at most.
  CHECK(contact_at({-2.25}, 0, how).bias == 3);
  CHECK(contact_at({-16}, 0, how).bias == 4);
}

TEST_CASE("what a contact asks for in the second solve is its rebound, or no more than its room") {
  const auto second = [](double separation, double rebound, double v) {
    const SecondRow<double> row = contact_at({separation, rebound}, v, quarter_and_eighth).second;
    CHECK(row.softness == 0);
    return row.bias;
  };
  CHECK(second(2, 0, 0) == -2 / half_second);
  CHECK(second(-1, 0, 0) == 0);
  CHECK(second(1, 3, -4) == 3);
  CHECK(second(-1, 3, -1) == 3);
}

TEST_CASE(
    "where only positions are corrected, a contact moves by what is still missing, and rebounds never") {
  const Stabilization how = {.policy = StabilizationPolicy::split_impulse, .baumgarte = 0.25, .slop = 0.125};
  const auto bias = [&](double separation, double v) {
    return contact_at({separation, 3}, v, how, StabilizationPass::position).bias;
  };
  CHECK(bias(1, -4) == -1 / half_second + 4);
  CHECK(bias(-1.125, 0.25) == 0.25 / half_second - 0.25);
  CHECK(contact_at({-1.125}, 0.25, how).bias == 0);  // velocities never have that speed
}

TEST_CASE("overlap stands on a spring of the policy soft, but for what rebounds or strikes") {
  Stabilization how = {.policy = StabilizationPolicy::soft, .slop = 0.125, .max_speed = 4};
  how.soft = {.frequency = 0.25, .damping_ratio = 2};
  // w = 2 pi f; gamma = 1 / (m h w (2 zeta + h w)), rate = w / (2 zeta + h w), of 1 kg.
  const double w = 2 * pi * 0.25, resisting = 2 * 2 + half_second * w;
  const StabilizedContact sprung = contact_at({-0.5}, -1, how);
  CHECK(sprung.bias == doctest::Approx(0.5 * w / resisting).epsilon(1e-15));
  CHECK(sprung.softness == doctest::Approx(1 / (half_second * w * resisting)).epsilon(1e-15));
  CHECK(sprung.second.bias == 0);
  for (const StabilizedContact& rigid :
       {contact_at({-0.5}, -4.5, how), contact_at({-0.5, 2}, -1, how), contact_at({0.5}, -1, how)})
    CHECK(rigid.softness == 0);
  CHECK(contact_at({-0.5}, -4.5, how).bias == 0);
  CHECK(contact_at({-0.5, 2}, -1, how).bias == 2);
}

TEST_CASE("a stabilized row is its spec with a bias, a key, and its normal row found in the problem") {
  const RowSpec<double> spec = row_along_y(0, Bounds<double>::coulomb(0.5, 2));
  const ConstraintRow<double> row = written(spec);
  CHECK(row.bounds.normal_row == 12);
  CHECK(row.bounds.friction == 0.5);
  CHECK(row.key == RowKey{17, spec.part});
  CHECK(row.bias == 0);
  CHECK(row.softness == 0);
  CHECK(row.jacobian_b == spec.jacobian_b);
}

TEST_CASE("a stretched rod loses a share beta of its error in every step") {
  for (const double beta : {0.0, 0.1, 0.2, 1.0}) {
    Scene scene(
        {.gravity = {0, 0}, .stabilization = {.policy = StabilizationPolicy::baumgarte, .baumgarte = beta}});
    const BodyId ball = scene.add({.shapes = {circle(0.1)}, .position = {3, 0}, .mass = 2});
    const double length = 2.5;
    scene.join<DistanceJoint>({.a = ground, .b = ball, .anchor_b = {3, 0}, .length = length});
    World world(scene);
    SequentialImpulse<double> solver({.iterations = 1});  // one row: solved in one sweep
    for (int k = 1; k <= 40; ++k) {
      world.step(solver);
      const double error = world.bodies().pose[{1}].position.x() - length;
      // Rounding of 3 m in each step.
      const double tolerance = 4 * std::numeric_limits<double>::epsilon() * 3 * k;
      CHECK(std::abs(error - 0.5 * std::pow(1 - beta, k)) <= tolerance);
    }
  }
}

TEST_CASE("two overlapping bodies part until the slop is left, by a share beta in every step") {
  const double depth = 0.1, slop = 0.01, beta = 0.2;
  Scene scene({.gravity = {0, 0},
               .stabilization = {.policy = StabilizationPolicy::baumgarte, .baumgarte = beta, .slop = slop},
               .warm_start = false});
  scene.add_ground();
  scene.add({.shapes = {circle(0.5)}, .position = {0, 0.5 - depth}, .mass = 1});
  World<double> world = world_after(scene, 1, 1);
  const double left = depth - (world.bodies().pose[{1}].position.y() - (0.5 - depth));
  CHECK(left - slop == doctest::Approx((1 - beta) * (depth - slop)).epsilon(1e-12));
  CHECK(world.bodies().velocity[{1}].y() == doctest::Approx(beta * (depth - slop) * 60).epsilon(1e-12));
}
