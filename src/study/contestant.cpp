// Floor 9. Stepping a scene under a setting.
#include <cairn/study/contestant.hpp>

#include <cairn/measure/fingerprint.hpp>
#include <cairn/measure/violation.hpp>
#include <cairn/solvers/residual.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/world/world.hpp>
#ifdef CAIRN_HAVE_BOX2D
#include <cairn/reference/box2d_joints.hpp>
#include <cairn/reference/box2d_world.hpp>
#endif

namespace cairn {

namespace {

template <Scalar Real>
void add_motion(const Pose<Real>& pose, const Vec3<Real>& velocity, Fingerprint& hash) {
  hash.add(pose.position);
  hash.add(pose.angle);
  hash.add(velocity);
}

template <Scalar Real>
class WorldContestant final : public Contestant {
 public:
  WorldContestant(const Scene& scene, const Setting& setting)
      : world_(scene),
        entry_(solver_entry(setting.solver)),
        solver_(make_solver<Real>(setting.solver, setting.sweeps)),
        twin_(make_solver<Real>(setting.solver, setting.sweeps)) {}

  bool do_events() override {
    const bool any = cairn::do_events(world_);
    if (any && impulses_) impulses_->clear();  // of a step whose joints may be gone
    return any;
  }
  void step() override {
    report_ = world_.step(*solver_, impulses_ ? StepWatch<Real>(*impulses_) : StepWatch<Real>());
  }
  std::optional<BodyId> not_finite() const override { return report_.not_finite; }
  std::optional<double> unfinished() const override {
    return report_.unfinished > 0 ? std::optional(report_.worst_residual) : std::nullopt;
  }
  Snapshot snapshot() const override {
    return impulses_ ? impulses_->in(cairn::snapshot(world_)) : cairn::snapshot(world_);
  }
  void sum_impulses() override { impulses_.emplace(); }
  std::int64_t row_updates(const Snapshot&) const override {
    return counted_updates(entry_, report_.row_sweeps, report_.extra_row_sweeps);
  }
  std::int64_t rows(const Snapshot&) const override { return report_.rows_solved; }

  std::optional<double> residual_ahead() override {
    VelocityProblem<Real> problem = world_.velocity_problem();
    const Real scale = residual_scale(problem);
    twin_->solve(problem);
    return static_cast<double>(residual(problem, scale).energy);
  }

  std::uint64_t state_hash() const override {
    Fingerprint hash;
    for (const BodyId body : world_.bodies().pose.indices()) {
      add_motion(world_.bodies().pose[body], world_.bodies().velocity[body], hash);
    }
    return hash.value();
  }

 private:
  World<Real> world_;
  const SolverEntry& entry_;
  std::unique_ptr<Solver<Real>> solver_, twin_;
  StepReport report_ = {};
  std::optional<StepImpulses> impulses_;  // where they are asked for
};

#ifdef CAIRN_HAVE_BOX2D
class Box2DContestant final : public Contestant {
 public:
  Box2DContestant(const Scene& scene, const Setting& setting)
      : setting_(setting),
        world_(one_substep(scene), {.velocity_iterations = setting.sweeps.iterations,
                                    .position_iterations = setting.position_iterations}) {
    (void)worst_penetration(world_.snapshot());  // refuses more pairs than a step of Cairn takes
  }

  bool do_events() override {
    const bool any = world_.do_events();
    if (any && impulses_) impulses_->clear();  // of a step whose joints may be gone
    return any;
  }
  void step() override {
    if (impulses_) impulses_->clear();
    for (int i = 0; i < setting_.substeps; ++i) {
      world_.step();
      if (impulses_) impulses_->add(world_.snapshot());
    }
    steps_ += 1;
  }
  Snapshot snapshot() const override {
    Snapshot result = impulses_ ? impulses_->in(world_.snapshot()) : world_.snapshot();
    result.step = steps_;
    return result;
  }
  void sum_impulses() override { impulses_.emplace(); }
  std::int64_t row_updates(const Snapshot& after) const override {
    return rows(after) * setting_.sweeps.iterations;
  }
  std::int64_t rows(const Snapshot& after) const override {
    std::int64_t rows = 2 * static_cast<std::int64_t>(after.contacts.size());
    for (const SnapshotJoint& joint : after.joints) rows += joint.traits.box2d_rows;
    return rows * setting_.substeps;
  }
  std::optional<double> residual_ahead() override { return std::nullopt; }
  std::uint64_t state_hash() const override {
    Fingerprint hash;
    for (const SnapshotBody& body : world_.snapshot().bodies) add_motion(body.pose, body.velocity, hash);
    return hash.value();
  }

 private:
  /// Box2D has no substeps: it takes shorter steps.
  static Scene one_substep(Scene scene) {
    SceneSettings settings = scene.settings();
    settings.dt /= settings.substeps;
    settings.substeps = 1;
    scene.set_settings(settings);
    return scene;
  }

  Setting setting_;
  Box2DWorld world_;
  int steps_ = 0;
  std::optional<StepImpulses> impulses_;  // where they are asked for
};
#endif

}  // namespace

List<std::string> known_differences([[maybe_unused]] const Scene& scene,
                                    [[maybe_unused]] const Setting& setting) {
#ifdef CAIRN_HAVE_BOX2D
  if (setting.solver == "box2d") return box2d_differences(scene);
#endif
  return {};
}

std::unique_ptr<Contestant> make_contestant(const Scene& scene, const Setting& setting) {
  check(setting);
  Scene prepared = scene;
  prepared.set_settings(with_setting(scene.settings(), setting));
#ifdef CAIRN_HAVE_BOX2D
  if (setting.solver == "box2d") return std::make_unique<Box2DContestant>(prepared, setting);
#endif
  if (setting.scalar == Precision::single_precision)
    return std::make_unique<WorldContestant<float>>(prepared, setting);
  return std::make_unique<WorldContestant<double>>(prepared, setting);
}

}  // namespace cairn
