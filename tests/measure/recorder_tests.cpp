// What a recorder sees of a solver at work.
#include "../validation/problems.hpp"

using namespace cairn;
using namespace cairn::testing;

TEST_CASE("a recorder keeps the start and every sweep, and the residual falls from 1") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    VelocityProblem<double> problem = stack<double>(3);
    SweepRecorder<double> recorder;
    make({.iterations = 5})->solve(problem, &recorder);
    REQUIRE(recorder.sweeps().size() == 6);
    CHECK(recorder.rows().empty());
    CHECK(recorder.sweeps()[0].residual_energy == doctest::Approx(1));
    CHECK(recorder.sweeps()[0].impulse == PerRow<double>{0, 0, 0});
    for (int k = 1; k < 6; ++k) {
      CHECK(recorder.sweeps()[k].sweep == k);
      CHECK(recorder.sweeps()[k].residual_energy < recorder.sweeps()[k - 1].residual_energy);
    }
    CHECK(recorder.sweeps()[5].impulse == problem.impulse);
  }
}

TEST_CASE("sweep 0 of a recorder is the warm start, applied") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    VelocityProblem<double> problem = stack<double>(2);
    const double fall = test_gravity * test_dt;
    problem.impulse = {2 * fall, fall};  // the answer
    SweepRecorder<double> recorder;
    make({.iterations = 1})->solve(problem, &recorder);
    CHECK(recorder.sweeps()[0].residual_energy <= 8 * double_epsilon);
    CHECK(recorder.sweeps()[0].impulse == PerRow<double>{2 * fall, fall});
  }
}

TEST_CASE("a recorder of rows sees each update: j v, the correction, and the impulse before and after") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    VelocityProblem<double> problem = column<double>({1, 3});
    SweepRecorder<double> recorder(SweepRecorder<double>::Detail::rows);
    make({.iterations = 2})->solve(problem, &recorder);
    const double fall = test_gravity * test_dt;
    REQUIRE(recorder.rows().size() == 4);
    const RowUpdate<double>& first = recorder.rows()[0].update;
    CHECK(first.sweep == 1);
    CHECK(first.row == 0);
    CHECK(first.row_velocity == doctest::Approx(-fall));
    CHECK(first.inverse_mass == doctest::Approx(1));
    CHECK(first.corrective == doctest::Approx(fall));
    CHECK(first.impulse_before == 0);
    CHECK(first.impulse_after == doctest::Approx(fall));
    CHECK(std::abs(recorder.rows()[0].velocity[{1}].y()) <= double_epsilon);  // the lower box stands,
    CHECK(recorder.rows()[0].velocity[{2}].y() == doctest::Approx(-fall));    // the upper one still falls
    const RowUpdate<double>& second = recorder.rows()[1].update;
    CHECK(second.row == 1);
    CHECK(second.inverse_mass == doctest::Approx(1 + 1.0 / 3));
    CHECK(second.impulse_after == doctest::Approx(fall * 3 / 4));
    CHECK(recorder.rows()[2].update.sweep == 2);
    CHECK(recorder.rows()[2].update.impulse_before == first.impulse_after);
    CHECK(recorder.rows()[2].update.impulse_after == doctest::Approx(fall * 7 / 4));
  }
}

TEST_CASE("a recorder that is used again keeps the last solve only") {
  SequentialImpulse<double> solver({.iterations = 2});
  SweepRecorder<double> recorder(SweepRecorder<double>::Detail::rows);
  for (const int boxes : {4, 2}) {
    VelocityProblem<double> problem = stack<double>(boxes);
    solver.solve(problem, &recorder);
  }
  CHECK(recorder.sweeps().size() == 3);
  CHECK(recorder.rows().size() == 4);
}
