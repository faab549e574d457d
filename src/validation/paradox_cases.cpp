// Floor 8. Painleve's rod: Coulomb friction that sweeps never find, and impacts without a collision.
#include <algorithm>

#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_problems.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/worst.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

/// The same with both rows in one block.
VelocityProblem<double> painleve_block(double friction) {
  VelocityProblem<double> problem = painleve_rod<double>(-1, friction);
  problem.blocks = {{0, 2}};
  return problem;
}

/// The largest error of the normal impulse after any of 100 sweeps, in epsilon (1 + k).
template <Scalar Real>
double dragged_rod_error(double friction) {
  const Real mu = static_cast<Real>(friction),
             q = mu * static_cast<Real>(painleve_nt) / static_cast<Real>(painleve_nn);
  const Real answer = static_cast<Real>(painleve_fall) / (static_cast<Real>(painleve_nn) * (1 + q));
  Real largest = 0;
  for (const SolverMaker<Real>& make : all_solvers<Real>()) {
    VelocityProblem<Real> problem = painleve_rod<Real>(-1, mu);
    ImpulseTrace<Real> trace;
    make({.iterations = 100})->solve(problem, &trace);
    Real power = 1;  // (-q)^k
    for (int k = 0; k <= 100; ++k, power *= -q) {
      const Real normal = trace.sweeps[k][0];
      const Real rounding = std::numeric_limits<Real>::epsilon() * static_cast<Real>(1 + k);
      const Real error = std::abs(normal - answer * (1 - power)) / rounding;
      if (!(error <= largest)) largest = error;
    }
  }
  return static_cast<double>(largest);
}

template <Scalar Real>
Measured dragged_rod_number(const std::string& scalar) {
  Worst worst = Worst("error in " + scalar +
                          ", over epsilon (1 + k): worst of k = 0..100, mu = 0.3, 1, 1.25 "
                          "and of 5 solvers",
                      "N s")
                    .by("0")
                    .since("64 roundings a sweep of velocities of 1 m/s");
  for (const double mu : {0.3, 1.0, 1.25}) worst.add(0, dragged_rod_error<Real>(mu), 64);
  return worst.number();
}

// A20. The normal row gives what is missing, A_nn p' = g dt - A_nt (mu p): the last sweep's friction. So
// p' - p* = -q (p - p*) with q = mu A_nt / A_nn.
ValidationResult dragged_rod(const EngineMaker&) {
  const double q = painleve_nt / painleve_nn, answer = painleve_fall / (painleve_nn + painleve_nt);
  const int k = 3;
  VelocityProblem<double> problem = painleve_rod<double>(-1, 1);
  SequentialImpulse<double>({.iterations = k}).solve(problem);
  ValidationResult result;
  result.numbers = {
      measured("normal impulse after 3 sweeps, mu = 1", problem.impulse[0], "N s")
          .by("g dt / (A_nn + mu A_nt) (1 - (-q)^k), q = mu A_nt / A_nn", answer * (1 + q * q * q))
          .within(64 * double_epsilon * (1 + k), "64 roundings a sweep of velocities of 1 m/s"),
      dragged_rod_number<float>("float"), dragged_rod_number<double>("double")};
  return result;
}

/// Circles of sweeps, over several solvers and frictions.
struct Circles {
  Worst odd;   // impulses after odd sweeps
  Worst even;  // after even ones
  Worst change;
  int silent = 0;  // solves that did not report a circle

  void add(const SolverMaker<double>& make, double mu) {
    VelocityProblem<double> problem = painleve_rod<double>(-1, mu);
    ImpulseTrace<double> trace;
    const SolveReport report = make({.iterations = 1000, .patience = 3})->solve(problem, &trace);
    silent += report.stop == Stop::cycle && !report.converged ? 0 : 1;
    const double last = painleve_fall / painleve_nn * std::max(mu, 1.0);
    change.add(last, report.largest_change, 1e-12 * last);
    for (int k = 1; k < trace.sweeps.size(); ++k) {
      const double expected = k % 2 == 1 ? painleve_fall / painleve_nn : 0;
      for (const double impulse : {trace.sweeps[k][0], trace.sweeps[k][1] / mu}) {
        (k % 2 == 1 ? odd : even).add(expected, impulse, 64 * double_epsilon);
      }
    }
  }
};

// A20, T12. With q > 1 the normal impulse is clamped at 0 after every overshoot, and the circle begins anew.
ValidationResult circling_rod(const EngineMaker&) {
  const std::string any = ": worst of mu = 1.4, 2, 10 and of 5 solvers", mild = "64 epsilon of 1 m/s";
  const std::string impulse = "normal impulse, and friction impulse over mu, after ";
  Worst exists = Worst("violation by (p, mu p), p = g dt / (A_nn + mu A_nt): worst of mu = 1.4, 2, 10", "m/s")
                     .by("0")
                     .since(mild);
  Circles circles{Worst(impulse + "odd sweeps" + any, "N s").by("g dt / A_nn").since(mild),
                  Worst(impulse + "even sweeps" + any, "N s").by("0").since(mild),
                  Worst("largest change in the last sweep" + any, "N s")
                      .by("g dt / A_nn max(mu, 1)")
                      .since("1e-12 of it")};
  for (const double mu : {1.4, 2.0, 10.0}) {
    const double answer = painleve_fall / (painleve_nn + mu * painleve_nt);
    exists.add(0, violation_by(painleve_rod<double>(-1, mu), {answer, mu * answer}), 64 * double_epsilon);
    for (const SolverMaker<double>& make : all_solvers<double>()) circles.add(make, mu);
  }
  const Measured silent = {.what = "solves that do not report a cycle, of 15",
                           .formula = "0",
                           .got = static_cast<double>(circles.silent),
                           .reason = "a count"};
  return {.numbers = {exists.number(), circles.odd.number(), circles.even.number(), circles.change.number(),
                      silent}};
}

// A20. Normal and friction together, with friction at its limit: (A_nn + mu A_nt) p = g dt.
ValidationResult circling_rod_as_a_block(const EngineMaker&) {
  ValidationResult result;
  for (const double mu : {1.4, 2.0, 10.0}) {
    VelocityProblem<double> problem = painleve_block(mu);
    BlockSequentialImpulse<double>({.iterations = 1}).solve(problem);
    result.add(measured("normal impulse after one sweep of blocks, mu = " + std::to_string(mu).substr(0, 3),
                        problem.impulse[0], "N s")
                   .by("g dt / (A_nn + mu A_nt)", painleve_fall / (painleve_nn + mu * painleve_nt))
                   .within(64 * double_epsilon, "64 epsilon of 1 m/s"));
  }
  return result;
}

/// Whether 2000 sweeps with this relaxation bring the circling rod (mu = 2) closer to its answer.
bool relaxation_helps(const SolverMaker<double>& make, double relaxation) {
  const double answer = painleve_fall / (painleve_nn + 2 * painleve_nt);
  VelocityProblem<double> problem = painleve_rod<double>(-1, 2);
  make({.iterations = 2000, .relaxation = relaxation})->solve(problem);
  return std::abs(problem.impulse[0] - answer) < 0.9 * answer;
}

// T12. A sweep with relaxation omega leaves 1 - omega (1 + q) of the error: less than all of it, in size, for
// omega < 2 / (1 + q). At 1e-4 of omega from there 2000 sweeps leave 0.9998^2000 = 0.67 of it.
ValidationResult relaxed_rod(const EngineMaker&) {
  const double answer = painleve_fall / (painleve_nn + 2 * painleve_nt);
  Worst largest = Worst("largest omega that converges, mu = 2: worst of 5 solvers")
                      .by("2 / (1 + mu A_nt / A_nn)")
                      .since("so far from it 2000 sweeps decide; the bracket is smaller");
  Worst found = Worst("normal impulse, omega = 0.3, 0.5, 0.7: worst of 5 solvers", "N s")
                    .by("g dt / (A_nn + mu A_nt)")
                    .since("0.75^200 = 1e-25 leaves rounding only: 64 epsilon of 1 m/s");
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    const auto fails = [&make](double omega) { return !relaxation_helps(make, omega); };
    largest.add(2 / (1 + 2 * painleve_nt / painleve_nn), bisected({0.3, 1}, 2e-5, fails).middle(), 1e-4);
    for (const double omega : {0.3, 0.5, 0.7}) {
      VelocityProblem<double> problem = painleve_rod<double>(-1, 2);
      make({.iterations = 200, .relaxation = omega})->solve(problem);
      found.add(answer, problem.impulse[0], 64 * double_epsilon);
    }
  }
  return {.numbers = {largest.number(), found.number()}};
}

// A20
ValidationResult pushed_rod(const EngineMaker&) {
  const std::string any = ": worst of mu = 0.3, 0.9, 1.2 and of 5 solvers";
  const std::string reason = "(mu A_nt / A_nn)^400 = 5e-19 is left; 64 epsilon of 1 m/s live 10 sweeps";
  Worst normal = Worst("normal impulse" + any, "N s").by("g dt / (A_nn - mu A_nt)").since(reason);
  Worst friction =
      Worst("friction impulse over mu" + any, "N s").by("-g dt / (A_nn - mu A_nt)").since(reason);
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const double mu : {0.3, 0.9, 1.2}) {
      VelocityProblem<double> problem = painleve_rod<double>(1, mu);
      make({.iterations = 400})->solve(problem);
      const double answer = painleve_fall / (painleve_nn - mu * painleve_nt);
      normal.add(answer, problem.impulse[0], 640 * double_epsilon);
      friction.add(-answer, problem.impulse[1] / mu, 640 * double_epsilon);
    }
  }
  return {.numbers = {normal.number(), friction.number()}};
}

// A20. Impulses grow by mu A_nt / A_nn or more a sweep until the end sticks: v_n = v_t = 0, by Cramer's rule.
ValidationResult jamming_rod(const EngineMaker&) {
  const double speed = 1, determinant = painleve_nn * painleve_tt - painleve_nt * painleve_nt;
  const std::string any = ": worst of mu = 1.34, 1.4, 2, 1e6 and of 5 solvers",
                    reason = "64 epsilon of 1 m/s";
  Worst normal =
      Worst("normal impulse" + any, "N s").by("(A_tt g dt + A_nt v_t) / (A_nn A_tt - A_nt^2)").since(reason);
  Worst friction = Worst("friction impulse" + any, "N s")
                       .by("-(A_nn v_t + A_nt g dt) / (A_nn A_tt - A_nt^2)")
                       .since(reason);
  int moving = 0;
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const double mu : {1.34, 1.4, 2.0, 1e6}) {
      VelocityProblem<double> problem = painleve_rod<double>(speed, mu);
      // Once the end sticks, a sweep leaves A_nt^2 / (A_nn A_tt) = 0.26 of the error.
      const SolveReport report = make({.iterations = 20000, .patience = 3})->solve(problem);
      moving += report.stop == Stop::stalled ? 0 : 1;
      normal.add((painleve_tt * painleve_fall + painleve_nt * speed) / determinant, problem.impulse[0],
                 64 * double_epsilon);
      friction.add(-(painleve_nn * speed + painleve_nt * painleve_fall) / determinant, problem.impulse[1],
                   64 * double_epsilon);
    }
  }
  return {.numbers = {normal.number(),
                      friction.number(),
                      {.what = "solves that do not come to rest, of 20",
                       .formula = "0",
                       .got = static_cast<double>(moving),
                       .reason = "a count"}}};
}

}  // namespace

void add_paradox_cases(ValidationCases& cases) {
  const std::string source = "P. Painleve, 1895; derived";
  cases.push_back({"A20",
                   "The impulse of a rod that drags its end overshoots by mu A_nt / A_nn in every sweep",
                   source, Asks::cairn, dragged_rod});
  cases.push_back({"A20b",
                   "Above mu = A_nn / A_nt = 4/3 a dragged rod has an answer, but sweeps circle round it",
                   source, Asks::cairn, circling_rod});
  cases.push_back({"A20c", "A block of normal and friction finds the answer that sweeps circle round", source,
                   Asks::cairn, circling_rod_as_a_block});
  cases.push_back({"A20d",
                   "A relaxation below 2 / (1 + mu A_nt / A_nn) brings the circling rod to its answer",
                   "derived", Asks::cairn, relaxed_rod});
  cases.push_back({"A20e", "A rod that is pushed against its end slides while mu is below A_nn / A_nt = 4/3",
                   source, Asks::cairn, pushed_rod});
  cases.push_back({"A20f", "Above mu = 4/3 a rod pushed against its end jams: an impact without a collision",
                   source, Asks::cairn, jamming_rod});
}

}  // namespace cairn
