// Cairn behind the interface of its peers, and what adapters ask of a joint.
#include <algorithm>
#include <utility>

#include "../measure.hpp"
#include "constraints/revolute_joint.hpp"
#include "engine.hpp"
#include "math/check.hpp"
#include "scenes/solver_list.hpp"
#include "world/world.hpp"

namespace cairn::bench {

namespace {

class CairnEngine final : public Engine {
 public:
  CairnEngine(const Scene& scene, const Setting& setting)
      : world_(scene), solver_(make_solver<double>(setting.solver, setting.sweeps)) {}
  void step() override { world_.step(*solver_); }
  PerBody<Pose<double>> poses() const override { return world_.bodies().pose; }
  PerBody<Vec3<double>> velocities() const override { return world_.bodies().velocity; }

 private:
  World<double> world_;
  std::unique_ptr<Solver<double>> solver_;
};

Scene prepared(const Scene& scene, const Setting& setting) {
  check(setting);
  Scene result = scene;
  result.set_settings(with_setting(scene.settings(), setting));
  return result;
}

/// Hands every problem on, and takes the time.
class TimedSolver final : public Solver<double> {
 public:
  explicit TimedSolver(std::unique_ptr<Solver<double>> solver) : solver_(std::move(solver)) {}
  std::string name() const override { return solver_->name(); }
  SolveReport solve(VelocityProblem<double>& problem, SolveObserver<double>* observer = nullptr) override {
    return timed([&] { return solver_->solve(problem, observer); });
  }
  SolveReport solve_again(VelocityProblem<double>& problem) override {
    return timed([&] { return solver_->solve_again(problem); });
  }
  double seconds() const { return seconds_; }

 private:
  template <typename Solve>
  SolveReport timed(const Solve& solve) {
    const Stopwatch watch;
    const SolveReport report = solve();
    seconds_ += watch.seconds();
    return report;
  }

  std::unique_ptr<Solver<double>> solver_;
  double seconds_ = 0;
};

}  // namespace

std::unique_ptr<Engine> make_cairn(const Scene& scene, const Setting& setting) {
  return std::make_unique<CairnEngine>(prepared(scene, setting), setting);
}

Phases phases_of_cairn(const Scene& scene, const Setting& setting, int steps) {
  World<double> world(prepared(scene, setting));
  TimedSolver solver(make_solver<double>(setting.solver, setting.sweeps));
  Phases phases = {.parts = {{.name = "solver"}, {.name = "all else"}}};
  for (int step = 0; step < steps; ++step) {
    const double before = solver.seconds();
    const Stopwatch watch;
    phases.points = world.step(solver).contacts;
    const double all = watch.seconds(), solved = solver.seconds() - before;
    phases.parts[0].seconds.push_back(solved);
    phases.parts[1].seconds.push_back(all - solved);
  }
  return phases;
}

const RevoluteJoint& require_pin(const Constraint& joint, const std::string& engine) {
  const auto* pin = dynamic_cast<const RevoluteJoint*>(&joint);
  require(pin != nullptr && pin->is_free(), engine.c_str(), "joint", "a pin without limits and motor",
          joint.name());
  return *pin;
}

bool keeps_apart(const Scene& scene, const Constraint& joint) {
  const List<Attachment> ends = joint.attachments();
  return std::binary_search(scene.apart().begin(), scene.apart().end(),
                            std::pair<BodyId, BodyId>(std::minmax(ends.front().body, ends.back().body)));
}

}  // namespace cairn::bench
