// Why a solver stops: its sweeps are done, it has arrived, it stands still, or it goes in circles.
#include <numbers>

#include "solver_list.hpp"

using namespace cairn;
using namespace cairn::testing;

TEST_CASE("a solver says that its sweeps are done, or that the tolerance is reached") {
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    VelocityProblem<double> problem = hand_made_stack<double>(5, 10, 0.02);
    const SolveReport done = make({.iterations = 3})->solve(problem);
    CHECK(done.stop == Stop::sweeps);
    CHECK_FALSE(done.converged);
    CHECK(done.iterations == 3);
    const SolveReport arrived = make({.iterations = 10000, .tolerance = 1e-9})->solve(problem);
    CHECK(arrived.stop == Stop::tolerance);
    CHECK(arrived.converged);
    CHECK(arrived.iterations < 10000);
  }
}

TEST_CASE_TEMPLATE("a solver stops where only rounding is left, and its answer is right to rounding", Real,
                   float, double) {
  const Real epsilon = std::numeric_limits<Real>::epsilon();
  const int boxes = 8;
  for (const SolverMaker<Real>& make : paper_solvers<Real>()) {
    for (const RowOrder order : {RowOrder::as_written, RowOrder::alternating, RowOrder::shuffled}) {
      VelocityProblem<Real> problem = hand_made_stack<Real>(boxes, 10, Real(0.02));
      const SolveReport report = make({.iterations = 1000000, .order = order, .patience = 5})->solve(problem);
      CHECK(report.stop == Stop::stalled);
      CHECK_FALSE(report.converged);  // no tolerance was asked for
      // A sweep shrinks errors to cos^2(pi / 2n) = 0.96: each has 16 roundings at most to go, times
      // 1 / (1 - 0.96) = 26 sweeps. Twice that, for orders that are a little slower.
      const Real weight = Real(10) * problem.dt;
      for (int i = 0; i < boxes; ++i) {
        CHECK(std::abs(problem.impulse[i] - Real(boxes - i) * weight) <=
              2 * 26 * 16 * epsilon * boxes * weight);
      }
    }
  }
}

TEST_CASE("where there is nothing to do, patience is the number of sweeps") {
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    for (const int patience : {1, 4}) {
      VelocityProblem<double> rising = hand_made_stack<double>(1, -10, 0.02);
      const SolveReport report = make({.iterations = 100, .patience = patience})->solve(rising);
      CHECK(report.stop == Stop::stalled);
      CHECK(report.iterations == patience);
      CHECK(rising.impulse[0] == 0);
      VelocityProblem<double> again = hand_made_stack<double>(1, -10, 0.02);
      CHECK(make({.iterations = 100})->solve(again).iterations == 100);  // not asked for
    }
  }
}

TEST_CASE("slow progress is no standstill: a heavy box on a light one") {
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    VelocityProblem<double> problem = hand_made_stack<double>(2, 10, 0.02);
    problem.inverse_mass[{2}] = Vec3<double>(1e-6, 1e-6, 6e-6);  // a sweep removes a millionth of the error
    const SolveReport report = make({.iterations = 5000, .patience = 1})->solve(problem);
    CHECK(report.stop == Stop::sweeps);
    CHECK(report.iterations == 5000);
  }
}

TEST_CASE("rows that contradict each other drift for ever, and that is seen as a plateau") {
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    VelocityProblem<double> problem = hand_made_stack<double>(1, 10, 0.02);
    problem.rows[0].bounds = Bounds<double>::equality();
    problem.rows.push_back(problem.rows[0]);
    problem.rows[1].bias = 1;  // [m/s], where row 0 wants 0
    problem.impulse = {0, 0};
    const VelocityProblem<double> start = problem;
    const SolveReport report = make({.iterations = 5000, .tolerance = 1e-6, .patience = 3})->solve(problem);
    CHECK(report.stop == Stop::plateau);
    CHECK(report.iterations == 1024);
    CHECK_FALSE(report.converged);
    CHECK(report.largest_change == doctest::Approx(1).epsilon(1e-12));  // every sweep moves 1 N s across
    CHECK(problem.impulse[1] == doctest::Approx(1024).epsilon(1e-12));
    problem = start;
    CHECK(make({.iterations = 1000, .patience = 3})->solve(problem).stop == Stop::sweeps);  // too soon to say
    problem = start;
    CHECK(make({.iterations = 5000})->solve(problem).iterations == 5000);  // nobody asked
  }
}

TEST_CASE_TEMPLATE("friction above A_nn / A_nt = 4/3 makes one contact go in circles, and the solver says so",
                   Real, float, double) {
  for (const SolverMaker<Real>& make : all_solvers<Real>()) {
    for (const RowOrder order : {RowOrder::as_written, RowOrder::alternating}) {
      // Above it, the friction of the first sweep lifts the end off by itself: the normal impulse goes to 0
      // and takes friction with it, and the next sweep begins where the first did.
      VelocityProblem<Real> circling = painleve_rod<Real>(-1, Real(1.4));
      const SolveReport cycle = make({.iterations = 100000, .order = order, .patience = 3})->solve(circling);
      VelocityProblem<Real> settling = painleve_rod<Real>(-1, Real(0.6));
      const SolveReport stalled =
          make({.iterations = 100000, .order = order, .patience = 3})->solve(settling);
      // Below it: lambda_n = g dt / (A_nn + mu A_nt).
      CHECK(stalled.stop == Stop::stalled);
      CHECK(static_cast<double>(settling.impulse[0]) ==
            doctest::Approx(0.01 / (1.6 + 0.6 * 1.2)).epsilon(1e-5));
      CHECK(cycle.stop == Stop::cycle);
      CHECK_FALSE(cycle.converged);
      CHECK(cycle.iterations <= 100);
      // It still moves by much more than rounding: by the normal impulse of a first sweep, 0.01 / 1.6 N s.
      CHECK(cycle.largest_change > 0.001);
    }
  }
}

TEST_CASE("Jacobi's two-cycle is found: two feet in one place both take the whole weight, then both none") {
  VelocityProblem<double> problem;
  problem.impulse = {0, 0};
  const double weight = 0.1;
  Stopping<double> stopping;
  stopping.begin({.patience = 10}, problem);
  int sweep = 0;
  Stop stop = Stop::sweeps;
  while (stop == Stop::sweeps && sweep < 1000) {
    const PerRow<double> old = problem.impulse;
    problem.impulse = {weight - old[1], weight - old[0]};
    stop = stopping.judge(problem, ++sweep, std::abs(problem.impulse[0] - old[0]));
  }
  CHECK(stop == Stop::cycle);
  CHECK(sweep == 4);  // remembered after sweep 2, found again two sweeps later
}

TEST_CASE("a cycle of any length is found in the memory of one state") {
  for (const int length : {2, 3, 7, 100}) {
    VelocityProblem<double> problem;
    Stopping<double> stopping;
    stopping.begin({.patience = 1}, problem);
    int sweep = 0;
    Stop stop = Stop::sweeps;
    while (stop == Stop::sweeps && sweep < 1000) {
      problem.impulse = {1.0 + ++sweep % length};
      stop = stopping.judge(problem, sweep, 1.0);
    }
    CHECK(stop == Stop::cycle);
    // The first power of two that is no less than the length is remembered long enough.
    int remembered = 1;
    while (remembered < length) remembered *= 2;
    CHECK(sweep == remembered + length);
  }
}

TEST_CASE("an up-sweep and a down-sweep with the same outcome are no cycle, and shuffled sweeps have none") {
  for (const RowOrder order : {RowOrder::alternating, RowOrder::shuffled}) {
    VelocityProblem<double> problem;
    Stopping<double> stopping;
    stopping.begin({.order = order, .patience = 1}, problem);
    // As seen after sweeps 1, 2, 3: the impulses of sweep 2 come back in sweep 3, which went the other way.
    problem.impulse = {1};
    CHECK(stopping.judge(problem, 1, 1.0) == Stop::sweeps);
    problem.impulse = {2};
    CHECK(stopping.judge(problem, 2, 1.0) == Stop::sweeps);
    CHECK(stopping.judge(problem, 3, 1.0) == Stop::sweeps);
    const Stop fourth = stopping.judge(problem, 4, 1.0);
    CHECK(fourth == (order == RowOrder::alternating ? Stop::cycle : Stop::sweeps));
  }
}

TEST_CASE("impulses that stay are no cycle, nor are those that come back in a sweep of another kind") {
  CycleSearch<double> cycles;
  cycles.begin(1, 2);
  CHECK_FALSE(cycles.comes_back({1}, 1, true));
  CHECK_FALSE(cycles.comes_back({2}, 2, true));  // remembered
  CHECK_FALSE(cycles.comes_back({2}, 3, true));  // a sweep of the other kind
  CHECK(cycles.comes_back({2}, 4, false));       // two sweeps later, and they moved in sweep 3
  cycles.begin(1, 1);
  for (int sweep = 1; sweep < 10; ++sweep) CHECK_FALSE(cycles.comes_back({2}, sweep, false));
}

TEST_CASE("rare looks come where the steps are as much smaller as R_E was too large, and some sweeps later") {
  RareLooks<double> looks;
  CHECK(looks.are_due(1, 1e9));
  looks.note(32, 8, 1e-2, 1e-3);                           // ten times too large
  CHECK(looks.are_due(32 + 3 + 2, 1.25 * 8 / 10 * 0.99));  // a tenth of the size, and a quarter more
  CHECK_FALSE(looks.are_due(32 + 3 + 2, 1.25 * 8 / 10 * 1.01));
  CHECK_FALSE(looks.are_due(32 + 3 + 1, 0));
}

TEST_CASE("impulses that are not numbers are neither a standstill nor a cycle") {
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    VelocityProblem<double> problem = hand_made_stack<double>(2, 10, 0.02);
    problem.velocity[{1}].y() = std::numeric_limits<double>::quiet_NaN();
    const SolveReport report = make({.iterations = 50, .patience = 1})->solve(problem);
    CHECK(report.stop == Stop::sweeps);
    CHECK(report.iterations == 50);
  }
}

TEST_CASE("a solve ends with its time budget, after one sweep at least, and says so") {
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    VelocityProblem<double> problem = hand_made_stack<double>(10, 10, 0.02);
    // A nanosecond is gone once the clock is read again.
    const SolveReport hurried = make({.iterations = 1000, .time_budget = 1e-9})->solve(problem);
    CHECK(hurried.stop == Stop::time);
    CHECK(hurried.iterations == 1);
    CHECK_FALSE(hurried.converged);
    const SolveReport patient = make({.iterations = 1000, .time_budget = 1e6})->solve(problem);
    CHECK(patient.stop == Stop::sweeps);
    CHECK(patient.iterations == 1000);
  }
  for (const double refused :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(SequentialImpulse<double>({.time_budget = refused}), std::invalid_argument);
  }
}

TEST_CASE("a patience below zero is refused") {
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    CHECK_THROWS_AS(make({.patience = -1}), std::invalid_argument);
  }
}
