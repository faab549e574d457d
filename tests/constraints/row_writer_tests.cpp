// Rows written in place: what a joint states, and the law of (7), for every kind of joint and every pass.
#include "constraint_list.hpp"
#include <cairn/constraints/springs.hpp>
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

constexpr double h = 1.0 / 64;  // [s]

/// Bodies that move, and what the step would make of their velocities without constraints.
struct Stage {
  PerBody<Pose<double>> start;
  BodyState<double> begin;
  VelocityProblem<double> problem;
  PerBody<Pose<double>> ahead;
  List<std::shared_ptr<const Constraint>> joints;

  explicit Stage(unsigned seed) {
    test::Random random(seed);
    start = random_poses(random);
    begin.pose = ahead = start;
    problem.dt = h;
    for (const BodyId body : start.indices()) {
      const double moves = body == ground ? 0 : 1;
      begin.inverse_mass.push_back(Vec3<double>(0.5, 0.5, 2) * moves * random.uniform(0.5, 2));
      begin.velocity.push_back(moves * Vec3<double>(random.uniform(-1, 1), random.uniform(-1, 1), 0.7));
      problem.velocity.push_back(begin.velocity.back() + moves * Vec3<double>(0, -10 * h, 0));
      begin.pose[body].position += moves * random.point(0.1);
      begin.pose[body].angle += moves * random.uniform(-0.1, 0.1);
      ahead[body].position = begin.pose[body].position + h * begin.velocity[body].head<2>();
      ahead[body].angle = begin.pose[body].angle + h * begin.velocity[body].z();
    }
    problem.inverse_mass = begin.inverse_mass;
    for (const ConstraintUnderTest<double>& kind : all_constraints<double>(start, random))
      if (kind.rows.joint) joints.push_back(kind.rows.joint);
    const BodyId a{1}, b{2};
    const Vec2<double> anchor = start[a].position;
    joints.push_back(std::make_shared<RevoluteJoint>(
        RevoluteJoint::Spec{
            .a = a, .b = b, .anchor = anchor, .motor = RevoluteJoint::Motor{.speed = 2, .max_torque = 3}},
        start));
    joints.push_back(std::make_shared<FrictionJoint>(
        FrictionJoint::Spec{.b = b, .max_force = 3, .max_torque = 2, .shape = FrictionShape::square}, start));
  }
};

/// The sum of m^-1 |j|^2 of what moves bodies along, or else A_ii.
double carried(const RowSpec<double>& spec, const PerBody<Vec3<double>>& inverse_mass) {
  double of_masses = 0, of_all = 0;
  const auto add = [&](BodyId body, const Vec3<double>& j) {
    of_masses += inverse_mass[body].x() * (j.x() * j.x() + j.y() * j.y());
    of_all += j.dot(inverse_mass[body].cwiseProduct(j));
  };
  add(spec.a, spec.jacobian_a);
  add(spec.b, spec.jacobian_b);
  for (int k = 0; k < spec.extra_count; ++k) add(spec.extra[k].body, spec.extra[k].jacobian);
  return of_masses > 0 && spec.bounds.is_equality() ? of_masses : of_all;
}

/// j v.
double speed_of(const RowSpec<double>& spec, const PerBody<Vec3<double>>& velocity) {
  double jv = spec.jacobian_a.dot(velocity[spec.a]) + spec.jacobian_b.dot(velocity[spec.b]);
  for (int k = 0; k < spec.extra_count; ++k) jv += spec.extra[k].jacobian.dot(velocity[spec.extra[k].body]);
  return jv;
}

/// The law in the words of the paper, and of softness.hpp.
SecondRow<double> law(const RowSpec<double>& spec, const Stabilization& how, StabilizationPass pass,
                      const Stage& stage) {
  using enum StabilizationPolicy;
  using enum StabilizationPass;
  const double beta = how.policy == baumgarte || (how.policy == relaxed && pass == velocity) ||
                              (how.policy == split_impulse && pass == position)
                          ? how.baumgarte
                          : 0;
  if (spec.softness) {
    const SpringRow<double> row = spring_row<double>(
        *spec.softness,
        {.error = spec.error,
         .speed = speed_of(spec, stage.begin.velocity),
         .inverse_mass = spec.jacobian_a.dot(stage.begin.inverse_mass[spec.a].cwiseProduct(spec.jacobian_a)) +
                         spec.jacobian_b.dot(stage.begin.inverse_mass[spec.b].cwiseProduct(spec.jacobian_b)),
         .of_masses = carried(spec, stage.begin.inverse_mass)},
        h);
    return {row.bias, row.softness};
  }
  if (spec.max_force) return {spec.speed, 0};
  const bool has_room = spec.bounds.is_unilateral() && spec.error >= 0;
  if (how.policy == soft && pass == velocity && !has_room) {
    const double w = 2 * pi * std::min(how.joint_soft.frequency, 0.25 / h);
    const double resisting = 2 * how.joint_soft.damping_ratio + h * w;
    return {-spec.error * w / resisting, carried(spec, stage.begin.inverse_mass) / (h * w * resisting)};
  }
  const double missing =
      pass == position && spec.bounds.is_unilateral() ? speed_of(spec, stage.problem.velocity) : 0;
  return {(has_room ? -spec.error / h : -beta * spec.error / h) - missing, 0};
}

void check_near(double value, double expected) {
  CHECK(std::abs(value - expected) <= 1e-12 * (1 + std::abs(expected)));
}

void check_stated(const RowSpec<double>& spec, const ConstraintRow<double>& row) {
  CHECK(row.a == spec.a);
  CHECK(row.b == spec.b);
  CHECK(row.jacobian_a == spec.jacobian_a);
  CHECK(row.jacobian_b == spec.jacobian_b);
  CHECK(row.key == RowKey{77, spec.part});
  CHECK(row.extra_count == spec.extra_count);
}

void check_bounds(const RowSpec<double>& spec, bool yields_to_nothing, const ConstraintRow<double>& row) {
  if (yields_to_nothing) {
    CHECK(row.bounds.upper == 0);
    CHECK(row.bounds.lower == 0);
  } else if (spec.max_force) {
    CHECK(row.bounds.upper == *spec.max_force * h);
    CHECK(row.bounds.lower == -*spec.max_force * h);
  } else {
    CHECK(row.bounds.is_equality() == spec.bounds.is_equality());
    CHECK(row.bounds.is_unilateral() == spec.bounds.is_unilateral());
  }
}

/// Behind three rows of something else, over old rows.
void check_joint(const Constraint& joint, const Stabilization& how, StabilizationPass pass, Stage stage) {
  VelocityProblem<double>& problem = stage.problem;
  ConstraintRow<double> old;
  old.softness = old.bias = 9;
  old.extra_count = old.first_extra = 9;
  problem.rows.assign(5, old);
  const RowSpecs<double> specs = rows_of(joint, stage.begin.pose);
  List<SecondRow<double>> second_rows;
  int next = 3;
  const RowWriting<double> writing{
      .begin = stage.begin,
      .problem = problem,
      .next = next,
      .rule = joint_rule(how, pass, h),
      .second_rule = joint_rule(how, StabilizationPass::second, h),
      .second_rows = pass == StabilizationPass::velocity ? &second_rows : nullptr};
  ProblemRows<double> rows(writing, 77);
  joint.write_rows(stage.begin.pose, rows);
  REQUIRE(next - 3 == specs.size());
  int extra = 0;
  for (int i = 0; i < specs.size(); ++i) {
    const RowSpec<double>& spec = specs[i];
    const ConstraintRow<double>& row = problem.rows[3 + i];
    check_stated(spec, row);
    CHECK(row.first_extra == extra);
    extra += spec.extra_count;
    const bool does_nothing = pass == StabilizationPass::position && (spec.softness || spec.max_force);
    check_bounds(spec, does_nothing, row);
    if (does_nothing) continue;
    check_near(row.bias, law(spec, how, pass, stage).bias);
    check_near(row.softness, law(spec, how, pass, stage).softness);
    if (!writing.second_rows) continue;
    const SecondRow<double> second = law(spec, how, StabilizationPass::second, stage);
    check_near(second_rows[i].bias, second.bias);
    check_near(second_rows[i].softness, second.softness);
  }
  CHECK(extra == problem.extra_terms.size());
}

/// A stage on which everything that is looked at is one joint.
RowWriting<double> writing_of(Stage& stage, int& next) {
  return {.begin = stage.begin,
          .problem = stage.problem,
          .next = next,
          .rule = joint_rule<double>({}, StabilizationPass::velocity, h)};
}

}  // namespace

TEST_CASE("a row is written as its joint states it, with the law of its pass") {
  using enum StabilizationPolicy;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Stage stage(seed);
    for (const StabilizationPolicy policy : {none, baumgarte, relaxed, soft, split_impulse}) {
      for (const auto pass : {StabilizationPass::velocity, StabilizationPass::position}) {
        for (const auto& joint : stage.joints) {
          CAPTURE(joint->name());
          CAPTURE(static_cast<int>(policy));
          check_joint(*joint, {.policy = policy}, pass, stage);
        }
      }
    }
  }
}

TEST_CASE("a row that follows an arc is asked for less by what its Jacobian leaves out of the arc") {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Stage stage(seed);
    for (const auto& joint : stage.joints) {
      CAPTURE(joint->name());
      RowSpecs<double> now, then;
      joint->append_rows(stage.begin.pose, now);
      joint->append_rows(stage.ahead, then);
      List<RowError<double>> errors;
      for (const bool moves : {false, true}) {
        const PerBody<char> all(stage.start.size(), moves);
        const Arcs<double> arcs{stage.ahead, all, errors};
        int next = 0;
        RowWriting<double> writing = writing_of(stage, next);
        writing.arcs = &arcs;
        ProblemRows<double> rows(writing, 1, joint.get());
        joint->write_rows(stage.begin.pose, rows);
        for (int i = 0; i < now.size(); ++i) {
          const RowSpec<double>& spec = now[i];
          const bool rigid = !spec.softness && !spec.max_force;
          const bool holds = spec.bounds.is_equality() || spec.error <= 0;
          const bool follows = rigid && holds && (moves || spec.extra_count > 0);
          const double jv = speed_of(spec, stage.begin.velocity);
          const double lost = follows ? (then[i].error - spec.error) / h - jv : 0;
          const Stabilization how;
          const double expected = law(spec, how, StabilizationPass::velocity, stage).bias - lost;
          CHECK(std::abs(stage.problem.rows[i].bias - expected) <= 1e-11 * (1 + std::abs(expected)));
        }
      }
    }
  }
}

TEST_CASE("a limit with room follows its arc only if it has pushed in the last step") {
  Stage stage(1);
  const PulleyJoint rope({.ends = {{.body = {1}, .anchor = {0, 0}, .roller = {3, 3}},
                                   {.body = {2}, .anchor = {1, 0}, .roller = {4, 3}}},
                          .length = 30,
                          .slack_margin = 100},
                         stage.start);
  RowSpecs<double> now, then;
  rope.append_rows(stage.begin.pose, now);
  rope.append_rows(stage.ahead, then);
  REQUIRE(now[0].error > 0);
  const double lost = (then[0].error - now[0].error) / h - speed_of(now[0], stage.begin.velocity);
  for (const double pushed : {0.0, 2.0}) {
    List<RowError<double>> errors;
    const PerBody<char> moves(stage.start.size(), 1);
    const Arcs<double> arcs{stage.ahead, moves, errors};
    const RowImpulse<double> last{.part = now[0].part, .impulse = pushed};
    int next = 0;
    RowWriting<double> writing = writing_of(stage, next);
    writing.arcs = &arcs;
    ProblemRows<double> rows(writing, 1, &rope, {&last, 1});
    rope.write_rows(stage.begin.pose, rows);
    const double expected = -now[0].error / h - (pushed > 0 ? lost : 0);
    CHECK(stage.problem.rows[0].bias == doctest::Approx(expected).epsilon(1e-12));
  }
}

TEST_CASE("a joint is apart where its rigid rows are, by more than the circle around the smaller body") {
  Stage stage(1);
  const PerBody<double> radius = {0, 1, 0.5, 2, 2};
  const RevoluteJoint pin({.a = {1}, .b = {2}, .anchor = stage.start[{1}].position}, stage.start);
  for (const double gap : {0.4, 0.6}) {
    stage.begin.pose = stage.start;
    stage.begin.pose[{1}].position += gap * Vec2<double>(0.6, 0.8);
    int next = 0;
    RowWriting<double> writing = writing_of(stage, next);
    writing.radius = &radius;
    ProblemRows<double> rows(writing, 1);
    pin.write_rows(stage.begin.pose, rows);
    CHECK(rows.is_apart() == (gap > 0.5));
  }
}

TEST_CASE(
    "a row that nothing can move is left out, and rows behind it name their rows from the joint's first") {
  Stage stage(1);
  for (const BodyId body : {BodyId{1}, BodyId{2}}) stage.problem.inverse_mass[body].z() = 0;
  const WeldJoint weld({.a = {1}, .b = {2}, .anchor = {0, 0}}, stage.start);
  int next = 0;
  const RowWriting<double> writing = writing_of(stage, next);
  ProblemRows<double> rows(writing, 1);
  weld.write_rows(stage.begin.pose, rows);
  CHECK(next == 2);
  const FrictionJoint friction({.b = {2}, .max_force = 3}, stage.start);
  ProblemRows<double> sliding(writing, 2);
  friction.write_rows(stage.begin.pose, sliding);
  REQUIRE(next == 4);
  CHECK(stage.problem.rows[3].bounds.normal_row == 2);
  CHECK(stage.problem.rows[3].bounds.disc == 3 * h);
}
