// What every constraint must do besides, for every scalar: the same bits twice, no numbers that are none
// where bodies meet, and one answer whichever solver is asked.
#include "solvers/solver_list.hpp"
#include "constraint_list.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

template <Scalar Real>
void check_finite(const RowSpecs<Real>& rows) {
  for (const RowSpec<Real>& row : rows) {
    CHECK(std::isfinite(row.error));
    CHECK(row.jacobian_a.allFinite());
    CHECK(row.jacobian_b.allFinite());
    Real largest = row.jacobian_a.cwiseAbs().maxCoeff() + row.jacobian_b.cwiseAbs().maxCoeff();
    for (int k = 0; k < row.extra_count; ++k) {
      const RowTerm<Real>& term = row.extra[k];
      CHECK(term.jacobian.allFinite());
      largest += term.jacobian.cwiseAbs().maxCoeff();
    }
    CHECK(largest > 0);
  }
}

/// One step of these rows: four bodies come with different velocities and spins, and touch where the rows are
/// those of a contact.
template <Scalar Real>
VelocityProblem<Real> constraint_problem(const RowSpecs<Real>& specs) {
  VelocityProblem<Real> problem;
  problem.dt = Real(1) / 60;
  problem.inverse_mass = {Vec3<Real>::Zero(), Vec3<Real>(1, 1, Real(0.25)),
                          Vec3<Real>(Real(0.5), Real(0.5), Real(0.1)), Vec3<Real>(1, 1, 1),
                          Vec3<Real>(2, 2, Real(0.5))};
  problem.velocity = {Vec3<Real>::Zero(), Vec3<Real>(1, Real(-0.5), Real(0.3)),
                      Vec3<Real>(-1, Real(0.4), Real(-0.2)), Vec3<Real>(Real(0.5), Real(0.7), Real(0.4)),
                      Vec3<Real>(Real(-0.3), Real(0.2), Real(0.6))};
  const BodyState<Real> begin = {{}, problem.velocity, problem.inverse_mass};
  int next = 0;
  const RowWriting<Real> writing{.begin = begin,
                                 .problem = problem,
                                 .next = next,
                                 .rule = joint_rule<Real>({}, StabilizationPass::velocity, problem.dt)};
  ProblemRows<Real> rows(writing, 0);
  for (RowSpec<Real> spec : specs) {
    if (spec.bounds.is_unilateral()) spec.error = 0;
    rows.add(spec);
  }
  problem.blocks = {{0, problem.row_count()}};
  problem.impulse.assign(problem.rows.size(), Real(0));
  if (row_velocity(problem, problem.rows[0]) > 0) {  // a contact that opens, a rope that slackens: turn back
    for (Vec3<Real>& v : problem.velocity) v = Vec3<Real>(-v);
  }
  return problem;
}

}  // namespace

TEST_CASE_TEMPLATE("a constraint that is asked twice says the same, to the last bit", Real, float, double) {
  test::Random random(21);
  const PerBody<Pose<double>> start = random_poses(random);
  for (const ConstraintUnderTest<Real>& constraint : all_constraints<Real>(start, random)) {
    CAPTURE(constraint.name);
    const PerBody<Pose<Real>> poses = poses_in<Real>(start);
    const RowSpecs<Real> first = constraint.rows(poses), second = constraint.rows(poses);
    REQUIRE(first.size() == second.size());
    for (int i = 0; i < first.size(); ++i) {
      CHECK(first[i].error == second[i].error);
      CHECK(first[i].jacobian_a == second[i].jacobian_a);
      CHECK(first[i].jacobian_b == second[i].jacobian_b);
      CHECK(first[i].part == second[i].part);
    }
  }
}

TEST_CASE_TEMPLATE("the rows of a constraint have names that differ, and keep them while bodies move", Real,
                   float, double) {
  test::Random random(22);
  const PerBody<Pose<double>> start = random_poses(random);
  for (const ConstraintUnderTest<Real>& constraint : all_constraints<Real>(start, random)) {
    CAPTURE(constraint.name);
    PerBody<Pose<Real>> poses = poses_in<Real>(start);
    const RowSpecs<Real> before = constraint.rows(poses);
    poses[{1}].position.x() += Real(1e-3);
    const RowSpecs<Real> after = constraint.rows(poses);
    REQUIRE(after.size() == before.size());
    for (int i = 0; i < before.size(); ++i) {
      CHECK(after[i].part == before[i].part);
      for (int other = 0; other < i; ++other) CHECK(before[other].part != before[i].part);
    }
  }
}

TEST_CASE("a joint that says it holds points has rows that bodies resist by moving, and others have none") {
  test::Random random(24);
  const PerBody<Pose<double>> start = random_poses(random);
  for (const ConstraintUnderTest<double>& constraint : all_constraints<double>(start, random)) {
    if (!constraint.rows.joint) continue;
    CAPTURE(constraint.name);
    bool moves = false;
    for (const RowSpec<double>& row : constraint.rows(start)) {
      for (const BodyId body : start.indices()) moves |= !jacobian_of(row, body).head<2>().isZero(0);
    }
    CHECK(constraint.rows.joint->traits().holds_points == moves);
  }
}

TEST_CASE_TEMPLATE("where bodies lie in one place, every row has a direction and no row is not a number",
                   Real, float, double) {
  test::Random random(23);
  const PerBody<Pose<double>> start = random_poses(random);
  for (const ConstraintUnderTest<Real>& constraint : all_constraints<Real>(start, random)) {
    CAPTURE(constraint.name);
    PerBody<Pose<Real>> poses = poses_in<Real>(start);
    poses[{2}] = poses[{1}];
    check_finite(constraint.rows(poses));
    poses[{1}] = poses[{2}] = {};
    check_finite(constraint.rows(poses));
  }
}

TEST_CASE_TEMPLATE("a rod, a rope and a spring whose ends have met write no row", Real, float, double) {
  const PerBody<Pose<double>> start = {{}, {{0, 0}, 0}, {{2, 0}, 0}};
  using Kind = DistanceJoint::Kind;
  for (const Kind kind : {Kind::rod, Kind::rope, Kind::spring}) {
    DistanceJoint::Spec spec = {.a = {1}, .b = {2}, .anchor_a = {0, 0}, .anchor_b = {2, 0}, .kind = kind};
    spec.slack_margin = 100;
    if (kind == Kind::spring) spec.softness = SwingSoftness{.frequency = 2, .damping_ratio = 0.5};
    const StateRows<Real> rows = joint_rows<DistanceJoint, Real>(spec, start);
    CHECK(rows({{}, {{1, 1}, 0}, {{1, 1}, 0}}).empty());
    CHECK(rows({{}, {{1, 1}, 0}, {{1, 2}, 0}}).size() == 1);
  }
}

TEST_CASE_TEMPLATE("every solver gives the bodies of a constraint the same velocities", Real, float, double) {
  test::Random random(24);
  for (int round = 0; round < 2; ++round) {
    const PerBody<Pose<double>> start = random_poses(random);
    for (const ConstraintUnderTest<Real>& constraint : all_constraints<Real>(start, random)) {
      CAPTURE(constraint.name);
      const VelocityProblem<Real> given = constraint_problem(constraint.rows(poses_in<Real>(start)));
      const SolverSettings settings = {.iterations = 30000, .patience = 3};
      VelocityProblem<Real> expected = given;
      SequentialImpulse<Real>(settings).solve(expected);
      CHECK(largest_gap(expected.velocity, given.velocity) > Real(0.01));  // the rows have something to do
      for (const SolverMaker<Real>& make : all_solvers<Real>(Iterates::any)) {
        VelocityProblem<Real> problem = given;
        make(settings)->solve(problem);
        // Both stop where a sweep changes impulses of up to 4 N s by 16 roundings at most, and arms of 4 m
        // and inertias of 4 kg m^2 and more turn these into speeds up to 4 times as large.
        CHECK(largest_gap(problem.velocity, expected.velocity) <=
              2 * 256 * std::numeric_limits<Real>::epsilon());
      }
    }
  }
}
