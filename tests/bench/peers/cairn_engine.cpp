// Cairn behind the interface of its peers, and its joints in their words.
#include <algorithm>
#include <cmath>
#include <utility>

#include "../measure.hpp"
#include <cairn/constraints/revolute_joint.hpp>
#include "engine.hpp"
#include <cairn/math/check.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/world/world.hpp>

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
    const Stopwatch watch;
    const SolveReport report = solver_->solve(problem, observer);
    seconds_ += watch.seconds();
    return report;
  }
  bool takes_contacts() const override { return solver_->takes_contacts(); }
  double seconds() const { return seconds_; }

 private:
  std::unique_ptr<Solver<double>> solver_;
  double seconds_ = 0;
};

const double far_turned = 1024;  // [rad]: a limit is passed there, and its sum with one is exact to 1e-13

/// The limit that b has passed when it is turned by so much [rad]: the error of its row says how far.
std::optional<double> limit_of(const Constraint& joint, BodyId b, double turn, PerBody<Pose<double>>& poses) {
  const double angle = poses[b].angle;
  poses[b].angle = angle + turn;
  RowSpecs<double> rows;
  joint.append_rows(poses, rows);
  poses[b].angle = angle;
  for (const RowSpec<double>& row : rows) {
    if (row.bounds.is_unilateral()) return turn < 0 ? turn - row.error : turn + row.error;
  }
  return std::nullopt;
}

}  // namespace

std::unique_ptr<Engine> make_cairn(const Scene& scene, const Setting& setting) {
  return std::make_unique<CairnEngine>(prepared(scene, setting), setting);
}

Phases phases_of_cairn(const Scene& scene, const Setting& setting, int steps) {
  World<double> world(prepared(scene, setting));
  TimedSolver solver(make_solver<double>(setting.solver, setting.sweeps));
  Phases phases = {.parts = {{.name = "solver"}, {.name = "all else"}}};
  double points = 0;
  for (int step = 0; step < steps; ++step) {
    const double before = solver.seconds();
    const Stopwatch watch;
    points += world.step(solver).contacts;
    const double all = watch.seconds(), solved = solver.seconds() - before;
    phases.parts[0].seconds.push_back(solved);
    phases.parts[1].seconds.push_back(all - solved);
  }
  phases.points = static_cast<int>(std::lround(points / steps));
  return phases;
}

List<Phase> edits_of_cairn(const Scene& scene, const BodySpec& body, int times) {
  Phase in_scene = {.name = "Scene::add"}, in_world = {.name = "World::edit"},
        steps = {.name = "the step after it"}, copies = {.name = "World twin = world"};
  Scene growing = scene;
  World<double> world(scene);
  const std::unique_ptr<Solver<double>> solver = make_solver<double>("newton", {.iterations = 50});
  for (int step = 0; step < 3; ++step) world.step(*solver);
  const auto take = [](Phase& phase, const auto& run) {
    const Stopwatch watch;
    run();
    phase.seconds.push_back(watch.seconds());
  };
  growing.add(body);  // from here on it shares its bodies with no other
  for (int i = 0; i < times; ++i) {
    take(in_scene, [&] { growing.add(body); });
    take(in_world, [&] { world.edit([&](Scene& now) { now.add(body); }); });
    take(steps, [&] { world.step(*solver); });
    std::optional<World<double>> twin;
    take(copies, [&] { twin.emplace(world); });
  }
  return {in_scene, in_world, steps, copies};
}

List<Pin> pins_of(const Scene& scene) {
  PerBody<Pose<double>> poses;
  for (const SceneBody& body : scene.bodies()) poses.push_back(body.pose);
  List<Pin> pins;
  for (const auto& joint : scene.joints()) {
    require(dynamic_cast<const RevoluteJoint*>(joint.get()) != nullptr, "the peers", "joint", "a pin",
            joint->name());
    const List<Attachment> ends = joint->attachments();
    Pin pin = {.a = ends.front().body,
               .b = ends.back().body,
               .anchor_a = ends.front().anchor,
               .anchor_b = ends.back().anchor,
               .motor = joint->motor()};
    pin.start = poses[pin.b].angle - poses[pin.a].angle;
    pin.lower = limit_of(*joint, pin.b, -far_turned, poses);
    pin.upper = limit_of(*joint, pin.b, far_turned, poses);
    require(pin.lower.has_value() == pin.upper.has_value(), "the peers", "limits", "both or neither", "one");
    pin.touch = !std::binary_search(scene.joints().apart().begin(), scene.joints().apart().end(),
                                    std::pair<BodyId, BodyId>(std::minmax(pin.a, pin.b)));
    pins.push_back(pin);
  }
  return pins;
}

}  // namespace cairn::bench
