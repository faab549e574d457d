// Floor 4. Which exact method is for which problem, and what it proves.
#include <cairn/solvers/exact/reference_solver.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <cairn/constraints/converted.hpp>
#include <cairn/math/check.hpp>
#include <cairn/solvers/iterative/accelerated_projected_gauss_seidel.hpp>
#include <cairn/solvers/exact/contact_modes.hpp>
#include <cairn/solvers/exact/impulse_family.hpp>
#include <cairn/solvers/exact/lemke.hpp>
#include <cairn/solvers/exact/newton.hpp>
#include <cairn/solvers/exact/other_answers.hpp>
#include <cairn/solvers/residual.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

bool has_moving_bounds(const ExactRows& rows) {
  return std::any_of(rows.bounds.begin(), rows.bounds.end(), [](const ExactBounds& bounds) {
    return bounds.is_friction && bounds.mu + bounds.second_mu > 0;
  });
}

bool is_finite(const VelocityProblem<long double>& problem) {
  bool finite = true;
  for (const Vec3<long double>& v : problem.velocity) finite = finite && v.allFinite();
  for (const Vec3<long double>& inverse : problem.inverse_mass) finite = finite && inverse.allFinite();
  for (const ConstraintRow<long double>& row : problem.rows) {
    finite = finite && row.jacobian_a.allFinite() && row.jacobian_b.allFinite() && std::isfinite(row.bias) &&
             std::isfinite(row.softness) && !std::isnan(row.bounds.lower) && !std::isnan(row.bounds.upper);
  }
  for (const RowTerm<long double>& term : problem.extra_terms) finite = finite && term.jacobian.allFinite();
  return finite;
}

/// One solve: changes `problem`, and fills `report`.
class ReferenceRun {
 public:
  ReferenceRun(const ReferenceSettings& settings, VelocityProblem<long double>& problem)
      : settings_(settings), problem_(problem), scale_(exact_scale(problem)) {}

  int run() {
    const bool has_disc = std::any_of(problem_.rows.begin(), problem_.rows.end(),
                                      [](const auto& row) { return row.bounds.disc > 0; });
    const bool is_small = problem_.row_count() <= settings_.max_rows;
    const bool is_solved = is_small && !has_disc && solve_reduced();
    if (!is_solved) solve_by_newton();
    if (!is_solved) claim_by_convexity();
    report.residual = static_cast<double>(residual(problem_, scale_).energy);
    return report.method == ReferenceMethod::newton || !is_solved ? iterations_ : 1;
  }

  ReferenceReport report;
  std::size_t memory = 0;

 private:
  long double error_of(const ExactRows& rows, const Vector<long double>& x) const {
    const long double error = natural_error(rows, x).norm();
    return error == 0 ? 0 : error / scale_;
  }
  bool is_answer(const ExactRows& rows, const Vector<long double>& x) const {
    return error_of(rows, x) <= settings_.tolerance;
  }

  bool solve_reduced() {
    const ExactReduction reduction = reduce_to_exact_rows(problem_);
    report.redundant_equalities = reduction.redundant_equalities;
    report.contradictory_equalities = reduction.contradictory_equalities;
    Vector<long double> x = Vector<long double>::Zero(reduction.rows.s.size());
    if (x.size() > 0 && !find_answer(reduction, x)) return false;
    if (x.size() == 0) report.method = ReferenceMethod::enumeration;
    const bool is_convex = !has_moving_bounds(reduction.rows);
    if (is_convex) report.velocity = {Uniqueness::unique, Evidence::convexity};
    report.solutions = std::max(report.solutions, 1);
    const bool is_unique = !reduction.redundant_equalities && has_unique_impulse(reduction.rows, x);
    if (report.velocity.verdict == Uniqueness::not_unique) {
      report.impulse = {Uniqueness::not_unique, report.velocity.evidence};
    } else if (!is_unique) {
      report.impulse = {Uniqueness::not_unique, Evidence::rank};
    } else if (report.velocity.verdict == Uniqueness::unique) {
      report.impulse = {Uniqueness::unique, Evidence::rank};
    }
    set_impulses(problem_, impulses_of(reduction, x));
    return true;
  }

  bool find_answer(const ExactReduction& reduction, Vector<long double>& x) {
    if (enumerate(reduction.rows, x)) return true;
    const bool is_large = problem_.row_count() > settings_.newton_rows;
    if (is_large && !reduction.contradictory_equalities) {
      const VelocityProblem<long double> start = problem_;
      const bool is_solved = iterate();
      if (is_solved) x = unknowns_at(reduction, problem_.impulse);
      problem_ = start;
      if (is_solved) return true;
    }
    return follow_paths(reduction, x);
  }

  static Vector<long double> unknowns_at(const ExactReduction& reduction,
                                         const PerRow<long double>& impulse) {
    Vector<long double> x(reduction.kept.size());
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      const auto row = reduction.kept[k];
      x(k) = impulse[row] / reduction.unit[row];
    }
    return x;
  }

  bool enumerate(const ExactRows& rows, Vector<long double>& x) {
    const ModeList list = enumerate_modes(rows, settings_.max_modes);
    if (list.solutions.empty() || !is_answer(rows, list.solutions.front().x)) return false;
    report.method = ReferenceMethod::enumeration;
    report.solutions = list.solutions.size();
    if (report.solutions > 1) {
      report.velocity = {Uniqueness::not_unique, Evidence::enumeration};
    } else if (!list.solutions.front().in_family) {
      report.velocity = {Uniqueness::unique, Evidence::enumeration};
    }
    x = list.solutions.front().x;
    return true;
  }

  /// What pivots have lost to rounding, where masses differ much, a few steps of Newton's method bring back.
  Vector<long double> polished(const ExactReduction& reduction, const Vector<long double>& x) const {
    const long double error = error_of(reduction.rows, x);
    if (reduction.contradictory_equalities || error <= exact_residual) return x;
    VelocityProblem<long double> copy = problem_;
    copy.impulse = impulses_of(reduction, x);
    newton(copy, {.iterations = 200, .restarts = 0, .sweeps = 0});
    const Vector<long double> better = unknowns_at(reduction, copy.impulse);
    return error_of(reduction.rows, better) < error ? better : x;
  }

  bool follow_paths(const ExactReduction& reduction, Vector<long double>& x) {
    const ExactRows& rows = reduction.rows;
    const ComplementarityProblem problem = complementarity_problem(rows);
    const Eigen::Index n = problem.q.size();
    memory = static_cast<std::size_t>(n * (n + 2) + n * n) * sizeof(long double);
    List<Vector<long double>> answers;
    const int covers = settings_.other_covers;
    for (int k = 0; k <= covers; ++k) {
      if (k > 0 && !answers.empty() && !has_moving_bounds(rows)) break;  // there is one velocity only
      const Vector<long double> cover = other_cover(n, k);
      const LemkeResult result = lemke(problem.M, problem.q, cover);
      if (result.status != LemkeStatus::solved) continue;
      const Vector<long double> answer = polished(reduction, unknowns_of(problem, result.z));
      const long double error = error_of(rows, answer);
      if (!(error <= settings_.tolerance)) continue;
      if (!answers.empty() && (error > exact_residual || error_of(rows, answers.front()) > exact_residual)) {
        continue;
      }
      if (!is_known(rows, answers, answer)) answers.push_back(answer);
    }
    if (answers.empty()) return false;
    report.method = ReferenceMethod::lemke;
    report.solutions = answers.size();
    x = answers.front();
    if (answers.size() == 1 && has_moving_bounds(rows) && error_of(rows, x) <= exact_residual) {
      VelocityProblem<long double> copy = problem_;
      set_impulses(copy, impulses_of(reduction, x));
      report.solutions = count_newton_answers(problem_, copy.velocity, covers);
    }
    if (report.solutions > 1) report.velocity = {Uniqueness::not_unique, Evidence::two_answers};
    return true;
  }

  static bool is_known(const ExactRows& rows, const List<Vector<long double>>& answers,
                       const Vector<long double>& answer) {
    for (const Vector<long double>& known : answers) {
      const Vector<long double> change = rows.effect * (answer - known);
      if (change.norm() <= distinct_velocity * rows.size) return true;
    }
    return false;
  }

  /// Newton's method; `problem_` holds its best, answer or not.
  bool iterate() {
    const VelocityProblem<long double> start = problem_;
    const NewtonSettings settings{.tolerance = std::min(settings_.tolerance, 1e-15)};
    const NewtonResult result = newton(problem_, settings);
    iterations_ = result.iterations;
    if (!(result.residual <= settings_.tolerance)) return false;
    report.method = ReferenceMethod::newton;
    report.solutions = 1;
    if (!has_friction() || result.residual > exact_residual) return true;
    report.solutions = count_newton_answers(start, problem_.velocity, settings_.other_covers);
    if (report.solutions > 1) report.velocity = {Uniqueness::not_unique, Evidence::two_answers};
    return true;
  }

  void solve_by_newton() {
    const VelocityProblem<long double> start = problem_;
    if (iterate()) return;
    VelocityProblem<long double> swept = start;
    AcceleratedProjectedGaussSeidel<long double>({.iterations = 2000, .patience = 3}).solve(swept);
    if (!(residual(problem_, scale_).energy <= residual(swept, scale_).energy)) problem_ = swept;
  }

  bool has_friction() const {
    return std::any_of(problem_.rows.begin(), problem_.rows.end(),
                       [](const auto& row) { return row.bounds.is_friction(); });
  }

  void claim_by_convexity() {
    if (!has_friction() && report.method != ReferenceMethod::none) {
      report.velocity = {Uniqueness::unique, Evidence::convexity};
    }
  }

  ReferenceSettings settings_;
  VelocityProblem<long double>& problem_;
  long double scale_ = 0;
  int iterations_ = 0;  // of Newton's method
};

}  // namespace

template <Scalar Real>
ReferenceSolver<Real>::ReferenceSolver(const ReferenceSettings& settings) : settings_(settings) {
  const char* place = "ReferenceSolver";
  require(settings.max_modes >= 0, place, "max_modes", ">= 0", settings.max_modes);
  require(settings.max_rows >= 0, place, "max_rows", ">= 0", settings.max_rows);
  require(settings.newton_rows >= 0, place, "newton_rows", ">= 0", settings.newton_rows);
  require(settings.other_covers >= 0, place, "other_covers", ">= 0", settings.other_covers);
  require(settings.tolerance > 0 && std::isfinite(settings.tolerance), place, "tolerance",
          "finite and above 0", settings.tolerance);
}

template <Scalar Real>
SolveReport ReferenceSolver<Real>::solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer) {
  if (problem.row_count() > most_rows) {
    throw std::length_error("ReferenceSolver: an exact answer for " + std::to_string(problem.row_count()) +
                            " rows, above the limit of " + std::to_string(most_rows) +
                            ", may take many minutes; NewtonSolver comes close to it in less");
  }
  if (observer != nullptr) observer->before_solve(problem);
  report_ = {};
  memory_ = 0;
  VelocityProblem<long double> exact = converted<long double>(problem);
  exact.impulse.assign(exact.rows.size(), 0);  // a warm start is ignored
  SolveReport result;
  if (is_finite(exact)) {
    ReferenceRun run(settings_, exact);
    result.iterations = run.run();
    report_ = run.report;
    memory_ = run.memory;
    result.residual = report_.residual;
    result.converged = report_.method != ReferenceMethod::none && report_.residual <= settings_.tolerance;
  }
  if (result.converged) result.stop = Stop::tolerance;
  for (int i = 0; i < exact.rows.size(); ++i) {
    problem.impulse[i] = static_cast<Real>(exact.impulse[i]);
  }
  for (const BodyId body : exact.velocity.indices()) {
    problem.velocity[body] = exact.velocity[body].template cast<Real>();
  }
  if (observer != nullptr) observer->after_sweep(1, problem);
  return result;
}

template class ReferenceSolver<float>;
template class ReferenceSolver<double>;
template class ReferenceSolver<long double>;

}  // namespace cairn
