// A world with its solver, and an observer that stops looking at a row update.
#include "lessons/playground/bench.hpp"

#include <algorithm>
#include <utility>

#include <cairn/constraints/converted.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/solvers/residual.hpp>

namespace cairn::playground {

namespace {

constexpr double end_tolerance = 1e-12;  // R_E of where sweeps end
constexpr int most_end_sweeps = 2000;

/// Keeps the problem as it is after so many row updates.
template <Scalar Real>
class Looker final : public SolveObserver<Real> {
 public:
  Looker(SolveLook& look, int updates) : look_(look), wanted_(updates) {}

  bool watches_rows() const override { return true; }
  void before_solve(const VelocityProblem<Real>& problem) override {
    scale_ = residual_scale(problem);
    look_.given = converted<double>(problem);
    VelocityProblem<Real> begun = problem;
    apply_impulses(begun);
    look_.residuals.push_back(static_cast<double>(residual(begun, scale_).energy));
    keep(begun);
  }
  void after_row(const RowUpdate<Real>& update, const VelocityProblem<Real>& problem) override {
    ++look_.all_updates;
    if (look_.all_updates != wanted_) return;
    keep(problem);
    look_.updates = wanted_;
    look_.last = {update.sweep,
                  update.row,
                  static_cast<double>(update.row_velocity),
                  static_cast<double>(update.inverse_mass),
                  static_cast<double>(update.corrective),
                  static_cast<double>(update.impulse_before),
                  static_cast<double>(update.impulse_after)};
  }
  void after_sweep(int, const VelocityProblem<Real>& problem) override {
    look_.residuals.push_back(static_cast<double>(residual(problem, scale_).energy));
  }
  /// Once the solve is done.
  void end(const VelocityProblem<Real>& problem) {
    if (wanted_ >= 0) return;
    keep(problem);
    look_.updates = look_.all_updates;
    if (look_.residuals.size() == 1)
      look_.residuals.push_back(static_cast<double>(residual(problem, scale_).energy));
  }

 private:
  void keep(const VelocityProblem<Real>& problem) {
    const VelocityProblem<double> now = converted<double>(problem);
    look_.velocity = now.velocity;
    look_.impulse = now.impulse;
  }

  SolveLook& look_;
  int wanted_;
  Real scale_ = 0;
};

template <Scalar Real>
class BenchOf final : public Bench {
 public:
  BenchOf(Scene scene, const Setting& setting) : world_(std::move(scene)), setting_(setting) {
    make_solver_of_setting();
    do_events(world_);
  }
  BenchOf(const BenchOf& other) : world_(other.world_), setting_(other.setting_) { make_solver_of_setting(); }

  std::unique_ptr<Bench> copy() const override { return std::make_unique<BenchOf>(*this); }
  StepReport step() override {
    const StepReport report = world_.step(*solver_);
    do_events(world_);
    return report;
  }
  void set(const Setting& setting) override {
    const auto solver = make_solver<Real>(setting.solver, setting.sweeps);
    world_.edit([&](Scene& scene) { scene.set_settings(with_setting(scene.settings(), setting)); });
    setting_ = setting;
    make_solver_of_setting();
  }
  void edit(const std::function<void(Scene&)>& change) override { world_.edit(change); }
  void repeat(const HandInput& input) override { world_.move_hand(input); }
  const List<HandInput>& hand_inputs() const override { return world_.hand().inputs(); }
  const DragJoint* hand() const override { return world_.hand().joint(); }
  Snapshot snapshot() const override { return cairn::snapshot(world_); }
  const Scene& scene() const override { return world_.scene(); }
  int steps() const override { return world_.clock().steps; }

  SolveLook look(int updates) const override {
    SolveLook look;
    VelocityProblem<Real> problem = world_.velocity_problem();
    Looker<Real> looker(look, updates);
    make_solver<Real>(setting_.solver, setting_.sweeps)->solve(problem, &looker);
    looker.end(problem);
    return look;
  }

 private:
  void make_solver_of_setting() { solver_ = make_solver<Real>(setting_.solver, setting_.sweeps); }

  World<Real> world_;
  Setting setting_;
  std::unique_ptr<Solver<Real>> solver_;
};

}  // namespace

PerRow<double> where_sweeps_end(VelocityProblem<double> problem, int row_updates) {
  const int sweeps = std::clamp(row_updates / std::max(1, problem.row_count()), 1, most_end_sweeps);
  make_solver<double>("accelerated", {.iterations = sweeps, .tolerance = end_tolerance, .patience = 3})
      ->solve(problem);
  return problem.impulse;
}

std::unique_ptr<Bench> make_bench(const Scene& scene, const Setting& setting) {
  check(setting);
  Scene under = scene;
  under.set_settings(with_setting(under.settings(), setting));
  if (setting.scalar == Precision::single_precision)
    return std::make_unique<BenchOf<float>>(std::move(under), setting);
  return std::make_unique<BenchOf<double>>(std::move(under), setting);
}

}  // namespace cairn::playground
