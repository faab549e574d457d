// Over-relaxation, held against D. M. Young's theory (Iterative methods for solving partial difference
// equations of elliptic type, 1954).
#include <Eigen/Core>
#include <numbers>

#include "solvers/solver_list.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// The stack with glue in its joints, so that no clamp disturbs the linear theory.
template <Scalar Real>
VelocityProblem<Real> glued_stack(int boxes, Real g) {
  VelocityProblem<Real> problem = hand_made_stack<Real>(boxes, g, Real(0.02));
  for (ConstraintRow<Real>& row : problem.rows) row.bounds = Bounds<Real>::equality();
  return problem;
}

/// By how much one sweep shrinks the slowest error: the spectral radius of the matrix that takes the errors
/// before a sweep to those after it. Its columns come from the solver: without gravity every impulse is
/// error. Gelfand: it is the limit of the k-th root of the norm of the k-th power, here at k = 2^40.
double spectral_radius(const SolverMaker<double>& make, int boxes, const SolverSettings& settings) {
  Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic> errors(boxes, boxes);
  for (int column = 0; column < boxes; ++column) {
    VelocityProblem<double> problem = glued_stack<double>(boxes, 0);
    problem.impulse[column] = 1;
    make(settings)->solve(problem);
    for (int i = 0; i < boxes; ++i) errors(i, column) = problem.impulse[i];
  }
  long double log_radius = 0;
  for (long double k = 1; k <= 0x1p40L; k *= 2) {
    const long double norm = errors.norm();
    log_radius += std::log(norm) / k;
    errors /= norm;
    errors = (errors * errors).eval();
  }
  return static_cast<double>(std::exp(log_radius));
}

/// Young: with mu the spectral radius of Jacobi's method, here cos(pi / 2n), the radius x of SOR obeys
/// x + omega - 1 = omega mu sqrt(x); its larger root, or omega - 1 once the roots are complex.
double radius_by_young(int boxes, double omega) {
  const double mu = std::cos(pi / (2 * boxes));
  const double discriminant = omega * omega * mu * mu - 4 * (omega - 1);
  if (discriminant <= 0) return omega - 1;
  const double root = (omega * mu + std::sqrt(discriminant)) / 2;
  return root * root;
}

double best_omega(int boxes) { return 2 / (1 + std::sin(pi / (2 * boxes))); }

/// The largest error of an impulse after so many sweeps over the glued stack [N s].
long double error_after(int boxes, int sweeps, double omega) {
  VelocityProblem<long double> problem = glued_stack<long double>(boxes, 10);
  SequentialImpulse<long double>({.iterations = sweeps, .relaxation = omega}).solve(problem);
  long double largest = 0;
  for (int i = 0; i < boxes; ++i) {
    const long double weight = static_cast<long double>(boxes - i) * 10 * problem.dt;
    largest = std::max(largest, std::abs(problem.impulse[i] - weight));
  }
  return largest;
}

class RelaxedBoundsWatcher final : public SolveObserver<double> {
 public:
  bool watches_rows() const override { return true; }
  void after_row(const RowUpdate<double>& update, const VelocityProblem<double>& problem) override {
    const Bounds<double>& bounds = problem.rows[update.row].bounds;
    const double wish = update.impulse_before + update.corrective;
    largest_error =
        std::max(largest_error, std::abs(bounds.clamp(wish, problem.impulse) - update.impulse_after));
    clamped += wish < 0;
  }
  double largest_error = 0;
  int clamped = 0;
};

}  // namespace

TEST_CASE("relaxation multiplies what a row gives: one box, one sweep, omega times its weight") {
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    for (const double omega : {0.25, 1.0, 1.5}) {
      VelocityProblem<double> problem = glued_stack<double>(1, 10);
      make({.iterations = 1, .relaxation = omega})->solve(problem);
      CHECK(problem.impulse[0] == doctest::Approx(omega * 10 * problem.dt).epsilon(1e-15));
      // Each further sweep leaves |1 - omega| of the error.
      make({.iterations = 5, .relaxation = omega})->solve(problem = glued_stack<double>(1, 10));
      const double left = std::pow(1 - omega, 5) * 10 * problem.dt;
      CHECK(std::abs(10 * problem.dt - problem.impulse[0] - left) <= 1e-15);
    }
  }
}

TEST_CASE("the rate of SOR on a stack is that of Young's theory, for every omega and for PGS as for SI") {
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    for (const int boxes : {2, 5, 10}) {
      for (const double omega : {0.5, 0.9, 1.0, 1.2, 1.4, 1.6, 1.8, 1.95}) {
        const double radius = spectral_radius(make, boxes, {.iterations = 1, .relaxation = omega});
        CAPTURE(boxes);
        CAPTURE(omega);
        CHECK(radius == doctest::Approx(radius_by_young(boxes, omega)).epsilon(1e-9));
      }
    }
  }
}

TEST_CASE("backwards or by colours, SOR on a stack has the same rate: Young's consistent orders") {
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    for (const RowOrder order : {RowOrder::reverse, RowOrder::coloured}) {
      for (const double omega : {1.0, 1.3, 1.9}) {
        const SolverSettings settings = {.iterations = 1, .order = order, .relaxation = omega};
        CHECK(spectral_radius(make, 10, settings) ==
              doctest::Approx(radius_by_young(10, omega)).epsilon(1e-9));
      }
    }
  }
}

TEST_CASE("the best omega for n boxes is 2 / (1 + sin(pi / 2n)), and its rate is omega - 1") {
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    for (const int boxes : {2, 5, 10}) {
      const double omega = best_omega(boxes);
      const double best = spectral_radius(make, boxes, {.iterations = 1, .relaxation = omega});
      // Two eigenvalues meet there, and a rounding of the matrix parts them by its square root.
      CHECK(std::abs(best - (omega - 1)) <= 1e-7);
      for (const double other : {omega - 0.01, omega + 0.01}) {
        CHECK(spectral_radius(make, boxes, {.iterations = 1, .relaxation = other}) > best + 0.005);
      }
    }
  }
}

TEST_CASE("ten boxes: the best omega needs 7 sweeps a digit where Gauss-Seidel needs 93") {
  const int boxes = 10;
  const double plain = std::pow(std::cos(pi / (2 * boxes)), 2), best = best_omega(boxes) - 1;
  // The slowest error alone is left after 100 sweeps: the next one shrinks by cos^2(3 pi / 2n) = 0.79.
  const double measured_plain =
      static_cast<double>(std::pow(error_after(boxes, 300, 1) / error_after(boxes, 100, 1), 1.0L / 200));
  CHECK(measured_plain == doctest::Approx(plain).epsilon(1e-6));
  CHECK(1 / std::log10(1 / plain) == doctest::Approx(92.9).epsilon(0.001));
  // Where two eigenvalues meet, errors shrink like k best^k: from sweep 40 to 100 that is at most a factor of
  // 100 / 40 more than best^60, and the phase of the other eigenvalues, all as large, does no more than that.
  const double measured_best = static_cast<double>(std::pow(
      error_after(boxes, 100, best_omega(boxes)) / error_after(boxes, 40, best_omega(boxes)), 1.0L / 60));
  CHECK(measured_best >= best * std::pow(0.4, 1.0 / 60));
  CHECK(measured_best <= best * std::pow(2.5, 1.0 / 60));
  CHECK(1 / std::log10(1 / best) == doctest::Approx(7.3).epsilon(0.01));
}

TEST_CASE("clamping comes after relaxation, so that every impulse stays inside its bounds") {
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    VelocityProblem<double> problem = hand_made_stack<double>(5, 10, 0.02);
    problem.velocity[{2}].y() = 3;  // the second box is thrown up: its contact opens, the one above pushes
    RelaxedBoundsWatcher watcher;
    make({.iterations = 40, .relaxation = 1.9})->solve(problem, &watcher);
    CHECK(watcher.clamped > 0);
    CHECK(watcher.largest_error <= 1e-15);
  }
}

TEST_CASE("a relaxation that cannot converge is refused") {
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    for (const double omega : {-1.0, 0.0, 2.0, std::numeric_limits<double>::quiet_NaN()}) {
      CHECK_THROWS_AS(make({.relaxation = omega}), std::invalid_argument);
    }
  }
  CHECK_THROWS_WITH_AS(SequentialImpulse<double>({.relaxation = 2.5}),
                       "SequentialImpulse: relaxation must be > 0 and < 2, got 2.5", std::invalid_argument);
}
