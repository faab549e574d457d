// The forms of projected Gauss-Seidel are one algorithm, stored in different ways.
#include "geometry/random_shapes.hpp"
#include "solvers/solver_list.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// Every form but the dense one, which they are compared with. In long double there is none but SI.
template <Scalar Real>
List<SolverMaker<Real>> forms_of_pgs() {
  if constexpr (std::is_same_v<Real, long double>)
    return {maker<SequentialImpulse<Real>, Real>()};
  else
    return {maker<SparseProjectedGaussSeidel<Real>, Real>(),
            maker<FactoredProjectedGaussSeidel<Real>, Real>(), maker<NaiveProjectedGaussSeidel<Real>, Real>(),
            maker<SequentialImpulse<Real>, Real>()};
}

template <Scalar Real>
ConstraintRow<Real> scattered_row(test::Random& random, int bodies) {
  const auto number = [&random](double reach) { return static_cast<Real>(random.uniform(-reach, reach)); };
  ConstraintRow<Real> row;
  row.a = {random.below(bodies)};
  row.b = {(row.a.index + 1 + random.below(bodies - 1)) % bodies};
  for (int axis = 0; axis < 3; ++axis) {
    row.jacobian_a(axis) = number(1);
    row.jacobian_b(axis) = number(1);
  }
  row.bias = number(0.5);
  return row;
}

/// Eight bodies, two of them immovable, and 24 rows that mean nothing: equalities (some soft), motors of
/// limited strength, one-sided rows and friction behind them; with impulses to start from.
template <Scalar Real>
VelocityProblem<Real> scattered_rows(std::uint64_t seed) {
  test::Random random(seed);
  const int bodies = 8;
  VelocityProblem<Real> problem;
  problem.dt = Real(0.02);
  for (int body = 0; body < bodies; ++body) {
    const Real inverse = body % 4 == 0 ? Real(0) : static_cast<Real>(random.uniform(0.5, 2));
    problem.inverse_mass.push_back({inverse, inverse, 6 * inverse});
    const Vec2<double> v = random.point(2);
    problem.velocity.push_back({static_cast<Real>(v.x()), static_cast<Real>(v.y()), Real(0.5)});
  }
  for (int i = 0; i < 24; ++i) {
    ConstraintRow<Real> row = scattered_row<Real>(random, bodies);
    if (i % 4 == 0) row.softness = static_cast<Real>(random.uniform(0, 1));
    if (i % 4 == 1) row.bounds = Bounds<Real>::at_most(Real(0.3));
    if (i % 4 == 2) row.bounds = Bounds<Real>::unilateral();
    if (i % 4 == 3) row.bounds = Bounds<Real>::coulomb(Real(0.3), i - 1);
    problem.blocks.push_back({i, 1});
    problem.rows.push_back(row);
    const Real start = static_cast<Real>(random.uniform(0, 0.2));
    problem.impulse.push_back(row.bounds.clamp(start, problem.impulse));
  }
  return problem;
}

/// Six boxes on each other, the top one hung on a rod, the lowest beside a bar on a pin that rests on it; a
/// few steps on, so that there are impulses to start from.
template <Scalar Real>
VelocityProblem<Real> stack_with_joints() {
  Scene scene;
  scene.add_ground();
  BodyId top;
  for (int i = 0; i < 6; ++i) {
    top = scene.add({.shapes = {box(1, 1)}, .position = {0.05 * i, 0.5 + i}, .angle = 0.01 * i});
  }
  const BodyId bar = scene.add({.shapes = {box(2, 0.2)}, .position = {1.6, 1.2}, .angular_velocity = 1});
  scene.join<RevoluteJoint>({.a = ground, .b = bar, .anchor = {2.5, 1.2}});
  scene.join<DistanceJoint>({.a = ground, .b = top, .anchor_a = {2, 8}, .anchor_b = {0.25, 5.5}});
  World<Real> world = world_after<Real>(scene, 12);
  return world.velocity_problem();
}

template <Scalar Real>
class RowHistory final : public SolveObserver<Real> {
 public:
  bool watches_rows() const override { return true; }
  void before_solve(const VelocityProblem<Real>& problem) override {
    for (const Real impulse : problem.impulse) largest = std::max(largest, std::abs(impulse));
    see(problem);
  }
  void after_row(const RowUpdate<Real>& update, const VelocityProblem<Real>& problem) override {
    updates.push_back(update);
    largest = std::max({largest, std::abs(update.corrective), std::abs(update.impulse_after)});
    see(problem);
  }
  void after_sweep(int sweep, const VelocityProblem<Real>&) override { sweeps = sweep; }

  List<RowUpdate<Real>> updates = {};
  List<PerBody<Vec3<Real>>> velocities = {};  // before the first row, and after each
  int sweeps = 0;
  Real largest = 0;  // [N s]
  Real fastest = 0;  // [m/s, rad/s]

 private:
  void see(const VelocityProblem<Real>& problem) {
    velocities.push_back(problem.velocity);
    for (const Vec3<Real>& v : problem.velocity) fastest = std::max(fastest, v.cwiseAbs().maxCoeff());
  }
};

/// A row update is one sum of some 20 products, and each sweep rounds it anew.
template <Scalar Real>
Real sweeps_of_roundings(int sweeps) {
  return 64 * std::numeric_limits<Real>::epsilon() * static_cast<Real>(1 + sweeps);
}

template <Scalar Real>
void check_same_answer(const VelocityProblem<Real>& answer, const VelocityProblem<Real>& dense,
                       const RowHistory<Real>& scale, int sweeps) {
  const Real tolerance = sweeps_of_roundings<Real>(sweeps);
  for (int i = 0; i < dense.impulse.size(); ++i) {
    CHECK(std::abs(answer.impulse[i] - dense.impulse[i]) <= tolerance * scale.largest);
  }
  CHECK(largest_gap(answer.velocity, dense.velocity) <= tolerance * scale.fastest);
}

template <Scalar Real>
void check_forms_agree(const VelocityProblem<Real>& start, SolverSettings settings = {}) {
  for (const int sweeps : {0, 1, 2, 5, 50}) {
    CAPTURE(sweeps);
    settings.iterations = sweeps;
    VelocityProblem<Real> dense = start;
    RowHistory<Real> history;
    ProjectedGaussSeidel<Real>(settings).solve(dense, &history);
    for (const SolverMaker<Real>& make : forms_of_pgs<Real>()) {
      VelocityProblem<Real> problem = start;
      const auto solver = make(settings);
      CAPTURE(solver->name());
      CHECK(solver->solve(problem).iterations == sweeps);
      check_same_answer(problem, dense, history, sweeps);
    }
  }
}

/// What an observer sees of every row, held against what it sees of the dense solver.
template <Scalar Real>
void check_forms_show_the_same(const VelocityProblem<Real>& start, int sweeps) {
  VelocityProblem<Real> dense = start;
  RowHistory<Real> expected;
  ProjectedGaussSeidel<Real>({.iterations = sweeps}).solve(dense, &expected);
  const Real tolerance = sweeps_of_roundings<Real>(sweeps);
  for (const SolverMaker<Real>& make : forms_of_pgs<Real>()) {
    VelocityProblem<Real> problem = start;
    const auto solver = make({.iterations = sweeps});
    CAPTURE(solver->name());
    RowHistory<Real> seen;
    solver->solve(problem, &seen);
    REQUIRE(seen.updates.size() == start.row_count() * sweeps);
    CHECK(seen.sweeps == sweeps);
    for (int i = 0; i < seen.updates.size(); ++i) {
      const RowUpdate<Real>& update = seen.updates[i];
      const RowUpdate<Real>& wanted = expected.updates[i];
      CHECK(update.sweep == wanted.sweep);
      CHECK(update.row == wanted.row);
      CHECK(std::abs(update.row_velocity - wanted.row_velocity) <= tolerance * expected.fastest);
      CHECK(std::abs(update.inverse_mass - wanted.inverse_mass) <= tolerance * wanted.inverse_mass);
      CHECK(std::abs(update.corrective - wanted.corrective) <= tolerance * expected.largest);
      CHECK(std::abs(update.impulse_before - wanted.impulse_before) <= tolerance * expected.largest);
      CHECK(std::abs(update.impulse_after - wanted.impulse_after) <= tolerance * expected.largest);
      CHECK(largest_gap(seen.velocities[i + 1], expected.velocities[i + 1]) <= tolerance * expected.fastest);
    }
  }
}

}  // namespace

TEST_CASE_TEMPLATE("every form of PGS gives the same impulses and velocities on rows of every kind", Real,
                   float, double, long double) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u}) {
    CAPTURE(seed);
    check_forms_agree(scattered_rows<Real>(seed));
  }
}

TEST_CASE_TEMPLATE("every form of PGS gives the same impulses and velocities for a stack with joints", Real,
                   float, double) {
  const VelocityProblem<Real> problem = stack_with_joints<Real>();
  CHECK(problem.row_count() >= 3 + 6 * 4);  // the joints, and two contacts with friction under every box
  check_forms_agree(problem);
}

TEST_CASE_TEMPLATE("every form of PGS shows an observer the same numbers, row by row", Real, float, double) {
  check_forms_show_the_same(scattered_rows<Real>(6), 4);
}

TEST_CASE("an empty problem is solved by every form of PGS") {
  for (const SolverMaker<double>& make : forms_of_pgs<double>()) {
    VelocityProblem<double> problem;
    const SolveReport report = make({.iterations = 3})->solve(problem);
    CHECK(report.iterations == 3);
    CHECK(report.largest_change == 0);
    CHECK(problem.impulse.empty());
  }
}

TEST_CASE("one row is solved by one update") {
  const double g = 10, dt = 0.5;  // a box of 1 kg has fallen for one step: exact in binary
  for (const SolverMaker<double>& make : forms_of_pgs<double>()) {
    VelocityProblem<double> problem = hand_made_stack<double>(1, g, dt);
    make({.iterations = 1})->solve(problem);
    CHECK(problem.impulse[0] == g * dt);
    CHECK(problem.velocity[{1}] == Vec3<double>(0, 0, 0));
  }
}

TEST_CASE("a row between two immovable bodies gets no impulse, and bias / softness when it is soft") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    VelocityProblem<double> problem = hand_made_stack<double>(1, 10, 0.5);
    problem.inverse_mass[{1}].setZero();
    VelocityProblem<double> soft = problem;
    make({.iterations = 3})->solve(problem);
    CHECK(problem.impulse[0] == 0);
    CHECK(problem.velocity[{1}] == Vec3<double>(0, -5, 0));

    soft.rows[0].softness = 2;
    make({.iterations = 3})->solve(soft);
    CHECK(soft.impulse[0] == 5.0 / 2);  // gamma p = zeta - j v
    CHECK(soft.velocity[{1}] == Vec3<double>(0, -5, 0));
  }
}

TEST_CASE_TEMPLATE("all forms of PGS agree in every order of rows, and over-relaxed", Real, float, double) {
  for (const RowOrder order :
       {RowOrder::reverse, RowOrder::alternating, RowOrder::shuffled, RowOrder::coloured}) {
    CAPTURE(static_cast<int>(order));
    check_forms_agree(scattered_rows<Real>(3), {.order = order, .seed = 5, .relaxation = 1.3});
  }
}

TEST_CASE("all forms of PGS stop after the same sweep for the same reason") {
  // Ten boxes need 557 sweeps for a millionth (cos^2(pi / 20) a sweep), and come to a standstill in the end.
  for (const SolverSettings& settings : {SolverSettings{.iterations = 5000, .tolerance = 1e-3},
                                         SolverSettings{.iterations = 5000, .patience = 3}}) {
    VelocityProblem<double> dense = hand_made_stack<double>(10, 10, 0.02);
    const SolveReport expected = ProjectedGaussSeidel<double>(settings).solve(dense);
    CHECK(expected.stop == (settings.patience > 0 ? Stop::stalled : Stop::tolerance));
    for (const SolverMaker<double>& make : forms_of_pgs<double>()) {
      VelocityProblem<double> problem = hand_made_stack<double>(10, 10, 0.02);
      const auto solver = make(settings);
      CAPTURE(solver->name());
      const SolveReport report = solver->solve(problem);
      CHECK(report.stop == expected.stop);
      CHECK(report.converged == expected.converged);
      // Rounding may put the last sweeps of a standstill elsewhere.
      if (settings.patience > 0) continue;
      CHECK(report.iterations == expected.iterations);
      CHECK(report.largest_change == doctest::Approx(expected.largest_change).epsilon(1e-9));
    }
  }
}
