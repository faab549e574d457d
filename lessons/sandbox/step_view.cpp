// Looks over a solver's shoulder in one step.
#include "lessons/sandbox/step_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <cairn/constraints/contact_rows.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/world/world.hpp>

namespace cairn::sandbox {
namespace {

constexpr int most_reference_rows = 400;

/// Hands everything on to a recorder, and keeps the problem as it was given and as it was left.
class StepKeeper final : public SolveObserver<double> {
 public:
  void before_solve(const VelocityProblem<double>& problem) override {
    given = problem;
    solved = problem;
    recorder.before_solve(problem);
  }
  void after_sweep(int sweep, const VelocityProblem<double>& problem) override {
    solved = problem;
    recorder.after_sweep(sweep, problem);
  }

  VelocityProblem<double> given = {}, solved = {};
  SweepRecorder<double> recorder{};
};

/// What wrote each row: joints come first, in the scene's order.
PerRow<std::string> row_kinds(const VelocityProblem<double>& problem, const Scene& scene) {
  PerRow<std::string> kinds(problem.row_count());
  for (int block = 0; block < problem.blocks.size(); ++block) {
    for (int k = 0; k < problem.blocks[block].count; ++k) {
      const int i = problem.blocks[block].first + k;
      const bool is_joint = block < scene.joints().size();
      if (is_joint) {
        // There is a joint of that name too.
        const std::string name = scene.joints()[block]->name();
        kinds[i] = name == "friction" ? name + " joint" : name;
      } else {
        const ConstraintRow<double>& row = problem.rows[i];
        kinds[i] = is_rolling(row) ? "rolling" : row.bounds.is_friction() ? "friction" : "contact";
      }
    }
  }
  return kinds;
}

void set_rows(StepView& view, const Scene& scene, const PerBody<std::string>& names) {
  const PerRow<std::string> kinds = row_kinds(view.given, scene);
  for (int i = 0; i < view.given.row_count(); ++i) {
    const ConstraintRow<double>& row = view.given.rows[i];
    constexpr double endless = std::numeric_limits<double>::infinity();
    view.rows.push_back({.kind = kinds[i],
                         .a = names[row.a],
                         .b = names[row.b],
                         .velocity = row_velocity(view.given, row),
                         .bias = row.bias,
                         .lower = row.bounds.clamp(-endless, view.solved.impulse),
                         .upper = row.bounds.clamp(endless, view.solved.impulse),
                         .impulse = view.solved.impulse[i],
                         .correction = natural_correction(view.solved, i)});
  }
}

/// sqrt(dv^T M dv) between two velocities.
double kinetic_distance(const VelocityProblem<double>& problem, const PerBody<Vec3<double>>& first,
                        const PerBody<Vec3<double>>& second) {
  double sum = 0;
  for (const BodyId body : first.indices()) {
    const Vec3<double> gap = first[body] - second[body];
    for (int axis = 0; axis < 3; ++axis) {
      const double inverse = problem.inverse_mass[body][axis];
      if (inverse > 0) sum += gap[axis] * gap[axis] / inverse;
    }
  }
  return std::sqrt(sum);
}

void add_reference(StepView& view) {
  if (view.given.row_count() > most_reference_rows) {
    view.no_reference = fmt::format("not asked with more than {} rows", most_reference_rows);
    return;
  }
  VelocityProblem<double> exact = view.given;
  ReferenceSolver<double> solver;
  try {
    solver.solve(exact);
  } catch (const std::logic_error& refusal) {
    view.no_reference = refusal.what();
    return;
  }
  StepReference reference{.report = solver.report()};
  for (int i = 0; i < view.rows.size(); ++i) {
    view.rows[i].exact = exact.impulse[i];
    reference.impulse_gap =
        std::max(reference.impulse_gap, std::abs(exact.impulse[i] - view.solved.impulse[i]));
  }
  for (const BodyId body : exact.velocity.indices()) {
    const double gap = (exact.velocity[body] - view.solved.velocity[body]).cwiseAbs().maxCoeff();
    reference.velocity_gap = std::max(reference.velocity_gap, gap);
  }
  const double change = kinetic_distance(exact, exact.velocity, view.given.velocity);
  const double error = kinetic_distance(exact, exact.velocity, view.solved.velocity);
  reference.energy_error = change > 0 ? error / change : 0;
  view.reference = reference;
}

}  // namespace

StepView view_step(const SceneEntry& entry, const Setting& setting, int step) {
  Scene scene = entry.make();
  scene.set_settings(with_setting(scene.settings(), setting));
  World<double> world(scene);
  const auto solver = make_solver<double>(setting.solver, setting.sweeps);
  for (int k = 1; k < step; ++k) {
    if (world.step(*solver).not_finite)
      throw std::invalid_argument(fmt::format("inspect: the scene is not finite after step {}", k));
  }
  StepKeeper keeper;
  world.step(*solver, &keeper);
  StepView view{.step = step,
                .time = world.clock().time,
                .setting = setting,
                .given = keeper.given,
                .solved = keeper.solved,
                .sweeps = keeper.recorder.sweeps()};
  // A solver without sweeps has its answer only when it is done.
  if (view.sweeps.size() <= 1) {
    const double scale = residual_scale(view.given);
    view.solved = view.given;
    make_solver<double>(setting.solver, setting.sweeps)->solve(view.solved);
    const Residual<double> left = residual(view.solved, scale);
    view.sweeps.push_back({.sweep = 1,
                           .residual_energy = left.energy,
                           .residual_velocity = left.velocity,
                           .impulse = view.solved.impulse});
  }
  set_rows(view, world.scene(), entry.body_names);
  add_reference(view);
  return view;
}

List<int> shown_sweeps(int count) {
  List<int> shown;
  for (int next = 0; next < count; next = next < 3 ? next + 1 : next + (next + 1) / 2) {
    shown.push_back(next);
  }
  if (count > 0 && shown.back() != count - 1) shown.push_back(count - 1);
  return shown;
}

}  // namespace cairn::sandbox
