// The tower as rows, the solvers on it, and what theory says about them.
#include "lesson.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cairn/constraints/converted.hpp>
#include <cairn/validation/column.hpp>

namespace cairn::cost {

namespace {

/// Writes a curve while a solver works.
template <typename Real>
class CurveObserver final : public SolveObserver<Real> {
 public:
  CurveObserver(Curve& curve, double least) : curve_(curve), least_(least) {}
  void before_solve(const VelocityProblem<Real>& problem) override {
    exact_ = exact_lambda(problem.row_count());
    look(problem);
  }
  void after_sweep(int, const VelocityProblem<Real>& problem) override {
    if (curve_.error.back() > least_) look(problem);
  }

 private:
  void look(const VelocityProblem<Real>& problem) {
    List<double> lambda;
    for (const Real impulse : problem.impulse) lambda.push_back(static_cast<double>(impulse) / time_step);
    curve_.error.push_back(error_of(lambda, exact_));
    if (curve_.lambda.size() <= kept_sweeps) curve_.lambda.push_back(lambda);
  }
  Curve& curve_;
  double least_;
  List<double> exact_ = {};
};

Matrix<double> tower_matrix(int boxes) {
  Matrix<double> A = Matrix<double>::Zero(boxes, boxes);
  for (int i = 0; i < boxes; ++i) {
    A(i, i) = i == 0 ? 1 : 2;
    if (i > 0) A(i, i - 1) = A(i - 1, i) = -1;
  }
  return A;
}

}  // namespace

double error_of(const List<double>& lambda, const List<double>& exact) {
  double error = 0;
  for (int i = 0; i < exact.size(); ++i) error = std::max(error, std::abs(lambda[i] - exact[i]));
  return error / exact[0];
}

VelocityProblem<double> tower_problem(int boxes) {
  return cases::column<double>(List<double>(boxes, 1.0), gravity, time_step);
}

List<double> exact_lambda(int boxes) {
  List<double> exact;
  for (int i = 0; i < boxes; ++i) exact.push_back((boxes - i) * gravity);
  return exact;
}

int sweeps_to(const List<double>& errors, double error) {
  for (int k = 0; k < errors.size(); ++k) {
    if (errors[k] <= error) return k;
  }
  return -1;
}

double sweeps_per_digit(const Curve& curve) { return std::log(10) / -std::log(curve.rate); }

double jacobi_rate(int boxes) { return std::cos(pi / (2 * boxes)); }

double best_relaxation(int boxes) { return 2 / (1 + std::sin(pi / (2 * boxes))); }

double sor_rate(int boxes, double omega) {
  if (omega >= best_relaxation(boxes)) return omega - 1;
  // lambda of (lambda + omega - 1)^2 = lambda omega^2 cos^2(pi / 2n); the larger.
  const double half = omega * jacobi_rate(boxes) / 2;
  const double root = half + std::sqrt(std::max(0.0, half * half - omega + 1));
  return root * root;
}

double sor_rate_by_matrix(int boxes, double omega) {
  const Matrix<double> A = tower_matrix(boxes);
  const Matrix<double> D = A.diagonal().asDiagonal();
  const Matrix<double> lower = A.triangularView<Eigen::StrictlyLower>();
  const Matrix<double> left = D + omega * lower;
  const Matrix<double> sweep = Matrix<double>::Identity(boxes, boxes) - omega * left.partialPivLu().solve(A);
  return Eigen::EigenSolver<Matrix<double>>(sweep, false).eigenvalues().cwiseAbs().maxCoeff();
}

double error_energy(const List<double>& lambda) {
  const List<double> exact = exact_lambda(lambda.size());
  double energy = 0;
  double above = 0;
  for (int i = lambda.size(); i-- > 0;) {
    const double error = (lambda[i] - exact[i]) * time_step;  // [N s]
    energy += (error - above) * (error - above) / 2;          // of box i, which is pushed from both sides
    above = error;
  }
  return energy;
}

template <typename Real>
void watch(Solver<Real>& solver, int boxes, double least, Curve& curve) {
  CurveObserver<Real> observer(curve, least);
  VelocityProblem<Real> problem = converted<Real>(tower_problem(boxes));
  solver.solve(problem, &observer);
}
template void watch<double>(Solver<double>&, int, double, Curve&);

int most_sweeps(int boxes) { return 2 * boxes * boxes + 20; }

SizeCost sweeps_to_one_percent(int boxes) {
  Curve si;
  Curve sor;
  SequentialImpulse<double> plain({.iterations = most_sweeps(boxes)});
  SequentialImpulse<double> relaxed({.iterations = most_sweeps(boxes), .relaxation = best_relaxation(boxes)});
  watch<double>(plain, boxes, 0.01, si);
  watch<double>(relaxed, boxes, 0.01, sor);
  return {.boxes = boxes, .si = sweeps_to(si.error, 0.01), .sor = sweeps_to(sor.error, 0.01)};
}

void look_closer(CostRun& run) {
  const int boxes = run.settings.boxes;
  const int sweeps = static_cast<int>(1.4 * run.curves[si_curve].error.size());
  ProjectedGaussSeidel<double> pgs({.iterations = sweeps});
  watch<double>(pgs, boxes, 0, run.pgs);
  run.non_zeros = coupled_pairs(tower_problem(boxes));
  Scene scene;
  scene.add_ground();
  for (int i = 0; i < boxes; ++i) scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5 + i}, .mass = 1});
  run.tower = snapshot(scene);
}

List<double> tower_only(int boxes, int sweeps) {
  List<double> v(boxes + 1, -gravity * time_step);
  List<double> impulse(boxes + 1, 0.0);
  v[0] = 0;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 1; i <= boxes; ++i) {
      const double sum = std::max(0.0, impulse[i] + (v[i - 1] - v[i]) * (i == 1 ? 1.0 : 0.5));
      const double change = sum - impulse[i];
      impulse[i] = sum;
      v[i] += change;
      if (i > 1) v[i - 1] -= change;
    }
  }
  impulse.erase(impulse.begin());
  return impulse;
}

}  // namespace cairn::cost
