// The pyramid's matrix and its eigenvalues, and solves of one step.
#include "lesson.hpp"

#include <Eigen/Eigenvalues>

namespace cairn::everybody {

namespace {

const double goal = 0.01;   // of R_E
const double pitch = 1.25;  // [m] from box to box in a row

/// n of Splitting::mass for each body: how many rows would move it.
PerBody<int> rows_on_each(const VelocityProblem<double>& problem) {
  PerBody<int> count(problem.body_count(), 0);
  for (const ConstraintRow<double>& row : problem.rows) {
    for_each_term(problem, row, [&](BodyId body, const Vec3<double>&) { ++count[body]; });
  }
  return count;
}

/// The largest eigenvalue of D^-1 A, which are those of D^-1/2 A D^-1/2; D as the method has it.
double largest_eigenvalue(const VelocityProblem<double>& problem, Method method) {
  const PerBody<int> count = rows_on_each(problem);
  Eigen::MatrixXd scaled = system_matrices(problem).A;
  Eigen::VectorXd root(scaled.rows());
  for (Eigen::Index i = 0; i < root.size(); ++i) {
    const ConstraintRow<double>& row = problem.rows[i];
    double divisor = 0;
    for_each_term(problem, row, [&](BodyId body, const Vec3<double>& jacobian) {
      const double parts = method == Method::split ? count[body] : 1;
      divisor += parts * jacobian.dot(problem.inverse_mass[body].cwiseProduct(jacobian));
    });
    root[i] = 1 / std::sqrt(divisor);
  }
  scaled = root.asDiagonal() * scaled * root.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

/// After which sweep the residual stays below the goal; -1: it does not.
int settled_after(const List<double>& residual) {
  int needed = residual.size();
  while (needed > 0 && residual[needed - 1] <= goal) --needed;
  return needed < residual.size() ? needed : -1;
}

PileHistory history_from(Method method, const SweepRecorder<double>& recorder) {
  PileHistory history{.method = method};
  for (const SweepRecord& sweep : recorder.sweeps()) {
    const double value = sweep.residual_energy;
    history.residual.push_back(std::isfinite(value) ? value : std::numeric_limits<double>::infinity());
  }
  history.sweeps_needed = settled_after(history.residual);
  return history;
}

PileHistory pile_history(const PileRun& run, Method method) {
  VelocityProblem<double> problem = run.problem;
  const PileSettings& settings = run.settings;
  PileHistory history = history_from(method, solved(method, settings.omega, settings.sweeps, problem));
  if (method == Method::sequential) return history;
  const double omega = method == Method::damped ? settings.omega : 1;
  history.eigenvalue = omega * largest_eigenvalue(run.problem, method);
  return history;
}

PileHistory coloured_history(const PileRun& run) {
  VelocityProblem<double> problem = run.problem;
  SweepRecorder<double> recorder;
  SequentialImpulse<double>({.iterations = run.settings.sweeps, .order = RowOrder::coloured})
      .solve(problem, &recorder);
  return history_from(Method::sequential, recorder);
}

int colours_of(const VelocityProblem<double>& problem) {
  RowSequence sequence;
  order_rows(problem, RowOrder::coloured, 1, 1, sequence);
  return sequence.colours.size() - 1;
}

/// Tries shares of 0.1, 0.105 ... up to that at which it would no longer converge.
TunedJacobi tuned_jacobi(const VelocityProblem<double>& problem, double largest) {
  TunedJacobi best;
  for (double omega = 0.1; omega * largest < 2; omega += 0.005) {
    VelocityProblem<double> copy = problem;
    const int needed = history_from(Method::damped, solved(Method::damped, omega, 600, copy)).sweeps_needed;
    if (needed > 0 && (best.sweeps_needed < 0 || needed < best.sweeps_needed)) best = {omega, needed};
  }
  return best;
}

/// The same problem with its rows backwards.
VelocityProblem<double> backwards(const VelocityProblem<double>& problem) {
  VelocityProblem<double> result = problem;
  const int last = problem.row_count() - 1;
  result.blocks.clear();
  for (int i = 0; i <= last; ++i) {
    ConstraintRow<double>& row = result.rows[i];
    row = problem.rows[last - i];
    if (row.bounds.normal_row != Bounds<double>::none) row.bounds.normal_row = last - row.bounds.normal_row;
    result.blocks.push_back({i, 1});
  }
  return result;
}

/// The largest difference that it makes to solve the rows backwards, over the largest impulse.
double effect_of_order(const VelocityProblem<double>& start, Method method) {
  VelocityProblem<double> straight = start;
  VelocityProblem<double> other = backwards(start);
  solved(method, 1, 20, straight);
  solved(method, 1, 20, other);
  double largest = 0;
  double gap = 0;
  for (int i = 0; i < start.row_count(); ++i) {
    largest = std::max(largest, std::abs(straight.impulse[i]));
    gap = std::max(gap, std::abs(straight.impulse[i] - other.impulse[start.row_count() - 1 - i]));
  }
  return gap / largest;
}

}  // namespace

Scene pile_scene(int base) {
  Scene scene({.gravity = {0, -gravity},
               .dt = time_step,
               .stabilization = {.policy = StabilizationPolicy::baumgarte}});
  scene.add_ground();
  for (int level = 0; level < base; ++level) {
    for (int i = 0; i < base - level; ++i) {
      const double x = (i - (base - level - 1) / 2.0) * pitch;
      scene.add({.shapes = {box(1, 1)}, .position = {x, 0.5 + level}, .mass = 1});
    }
  }
  return scene;
}

PileRun run_pile(const PileSettings& settings) {
  PileRun run{.settings = settings};
  World<double> world(pile_scene(settings.base));
  run.problem = world.velocity_problem();
  SequentialImpulse<double> solver({.iterations = settings.sweeps});
  world.step(solver);
  run.snapshot = snapshot(world);
  run.largest_eigenvalue = largest_eigenvalue(run.problem, Method::plain);
  run.colours = colours_of(run.problem);
  run.contacts = colour_contacts(run.problem);
  run.larger = colour_contacts(World<double>(pile_scene(larger_base)).velocity_problem());
  run.rows_on_box = rows_on_each(run.problem);
  for (const Method method : all_methods) run.histories.push_back(pile_history(run, method));
  run.coloured = coloured_history(run);
  run.tuned = tuned_jacobi(run.problem, run.largest_eigenvalue);
  const double safe = 1 / run.largest_eigenvalue;
  run.momentum_residual = residuals_with_momentum(run.problem, safe, settings.sweeps);
  run.with_momentum = {safe, settled_after(run.momentum_residual)};
  run.order_at_once = effect_of_order(run.problem, Method::split);
  run.order_in_turn = effect_of_order(run.problem, Method::sequential);
  return run;
}

List<double> residuals_with_momentum(const VelocityProblem<double>& start, double omega, int most) {
  const int m = start.row_count();
  const double scale = residual_scale(start);
  Jacobi<double> jacobi({.iterations = 1, .relaxation = omega});
  PerRow<double> last(m, 0.0), begun(m, 0.0);
  double theta = 1;
  List<double> residuals = {residual(start, scale).energy};
  for (int sweep = 1; sweep <= most && !(residuals.back() < goal / 20); ++sweep) {
    VelocityProblem<double> problem = start;
    problem.impulse = begun;
    jacobi.solve(problem);  // which gives all bodies these impulses first
    residuals.push_back(residual(problem, scale).energy);
    double against = 0;  // whether the last move goes back on what this sweep corrects
    for (int i = 0; i < m; ++i)
      against += (begun[i] - problem.impulse[i]) * (problem.impulse[i] - last[i]) *
                 inverse_effective_mass(start, start.rows[i]);
    if (against > 0) theta = 1;
    const double next = (1 + std::sqrt(1 + 4 * theta * theta)) / 2, share = (theta - 1) / next;
    theta = next;
    for (int i = 0; i < m; ++i) begun[i] = problem.impulse[i] + share * (problem.impulse[i] - last[i]);
    last = problem.impulse;
  }
  return residuals;
}

int turns_per_sweep(const PileRun& run, const PileHistory& history) {
  if (history.method != Method::sequential) return 1;
  return &history == &run.coloured ? run.colours : run.problem.row_count();
}

// Colours, given one after the other.

namespace {

/// The ground cannot be moved: contacts that share it do not disturb each other.
bool can_move(const VelocityProblem<double>& problem, BodyId body) {
  return !problem.inverse_mass[body].isZero(0);
}

}  // namespace

Colouring colour_contacts(const VelocityProblem<double>& problem) {
  Colouring colouring;
  PerBody<std::set<int>> taken(problem.body_count());  // colours
  for (const ConstraintRow<double>& row : problem.rows) {
    const bool is_known = !colouring.contacts.empty() && colouring.contacts.back().a == row.a &&
                          colouring.contacts.back().b == row.b;
    if (is_known) continue;  // another row of the same contact
    std::set<int>& taken_at_a = taken[row.a];
    std::set<int>& taken_at_b = taken[row.b];
    int colour = 0;
    while (taken_at_a.contains(colour) || taken_at_b.contains(colour)) ++colour;
    if (can_move(problem, row.a)) taken_at_a.insert(colour);
    if (can_move(problem, row.b)) taken_at_b.insert(colour);
    colouring.contacts.push_back({row.a, row.b, colour});
    if (colour == colouring.count.size()) colouring.count.push_back(0);
    ++colouring.count[colour];
  }
  for (const std::set<int>& colours : taken)
    colouring.most_on_a_box = std::max(colouring.most_on_a_box, static_cast<int>(colours.size()));
  return colouring;
}

int clashes(const VelocityProblem<double>& problem, const Colouring& colouring) {
  int number = 0;
  const List<ColouredContact>& contacts = colouring.contacts;
  for (int i = 0; i < contacts.size(); ++i) {
    for (int k = 0; k < i; ++k) {
      const ColouredContact &one = contacts[i], &other = contacts[k];
      const bool a_shared = can_move(problem, one.a) && (one.a == other.a || one.a == other.b);
      const bool b_shared = can_move(problem, one.b) && (one.b == other.a || one.b == other.b);
      number += one.colour == other.colour && (a_shared || b_shared);
    }
  }
  return number;
}

std::string counts_text(const Colouring& colouring) {
  return fmt::format("{}", fmt::join(colouring.count, " + "));
}

}  // namespace cairn::everybody
