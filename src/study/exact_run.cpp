// Floor 9. One run that others are held against.
#include <cairn/study/exact_run.hpp>

#include <algorithm>

#include <cairn/scenes/default_setting.hpp>
#include <cairn/study/trial.hpp>

namespace cairn {

namespace {

Setting exact_setting() {
  Setting setting{.solver = "newton", .dt = 1.0 / 240, .substeps = 16};
  setting.sweeps.iterations = 60;
  setting.sweeps.tolerance = 1e-12;
  return setting;
}

}  // namespace

ExactRun::ExactRun(const Scene& scene, double seconds) : seconds_(std::min(seconds, 1.0)) {
  if (default_setting(scene).setting.solver != exact_setting().solver) return;
  TrialOptions options{.seconds = seconds_, .penetration_every = 1000};
  options.observer = [this](const Snapshot& now) {
    places_.clear();
    for (const SnapshotBody& body : now.bodies) places_.push_back(body.pose.position);
  };
  if (run_trial(scene, exact_setting(), options).status != TrialStatus::ok) places_.clear();
}

double ExactRun::gap(const Snapshot& now) const {
  double farthest = 0;
  for (const BodyId body : now.bodies.indices()) {
    if (now.bodies[body].type != BodyType::dynamic || now.bodies[body].removed) continue;
    farthest = std::max(farthest, (now.bodies[body].pose.position - places_[body]).norm());
  }
  return farthest;
}

}  // namespace cairn
