// Floor 9. The groups of axes, one file each, and what they build their cases from.
#pragma once

#include <cairn/study/extremes/extreme.hpp>
#include <cairn/study/setting_grid.hpp>
#include <cairn/study/trial.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

List<ExtremeAxis> load_axes();      // mass ratio, stack, chain
List<ExtremeAxis> step_axes();      // dt, variable dt, iterations
List<ExtremeAxis> motion_axes();    // speed, spin
List<ExtremeAxis> size_axes();      // distance from the origin, size ratio, overlap
List<ExtremeAxis> row_axes();       // tiny inertia, redundant and contradictory rows
List<ExtremeAxis> spring_axes();    // stiffness
List<ExtremeAxis> material_axes();  // friction, restitution
List<ExtremeAxis> number_axes();    // scalars, denormals, overflow, determinism
List<ExtremeAxis> count_axes();     // nothing at all, many bodies, many contacts on one
List<ExtremeAxis> input_axes();     // shapes, masses, and numbers that are none
List<ExtremeAxis> target_axes();    // what recommended settings must reach

/// A setting of an axis, and whether it is in the quick part.
struct ExtremeSetting {
  Setting setting = {};
  bool quick = false;
};

/// The settings most axes are tried with: si and block under each policy, and one each of the others.
List<ExtremeSetting> usual_settings();

/// The cases of one axis, as they are added.
class AxisCases {
 public:
  using Run = std::function<ExtremeFinding(const Setting&)>;

  explicit AxisCases(std::string axis) : axis_(std::move(axis)) {}

  /// Of one value, with one setting.
  void add(const std::string& value, const ExtremeSetting& tried, ExtremeVerdict required, const Run& run);
  /// One with each of usual_settings().
  void add_usual(const std::string& value, ExtremeVerdict required, const Run& run);
  /// What must be refused before any solver sees it.
  void add_refusal(const std::string& value, const std::function<void()>& act);
  const List<ExtremeCase>& all() const { return all_; }

 private:
  std::string axis_;
  List<ExtremeCase> all_ = {};
};

/// What of a run is held against a limit, and what that is called.
struct ExtremeMeasure {
  std::string quantity = {};
  std::function<double(const TrialResult&)> of = {};
};
ExtremeMeasure farthest_place();  // [m] TrialResult::farthest
ExtremeMeasure energy_gained();   // TrialResult::energy_gain
ExtremeMeasure joint_drift();     // [m] TrialResult::worst_drift
ExtremeMeasure drift_of_links();  // the same over the length of a link, 0.5 m

/// A scene to be stepped, what is measured of it, and what must not happen.
struct ExtremeRun {
  double seconds = 2;  // [s]
  ExtremeMeasure measure = {};
  double limit = 0;           // of what is measured, for OK
  double thinnest = 1;        // [m] of the thinnest body: an overlap by half of it has gone through
  double floor = -1e300;      // [m] a centre of mass below it has gone through
  double energy_gain = 0.01;  // of its scale: more is a failure
  /// [J] The scale; 0: that of the run, TrialResult::energy_scale.
  double energy_scale = 0;
  std::function<bool(const Snapshot&)> escaped = {};  // a further way to have gone through something
  double time_limit = 30;                             // [s] of processor time, at most
};

/// Judges by what ExtremeVerdict says. A refusal by the engine is passed on.
/// @throws std::invalid_argument, std::length_error.
ExtremeFinding run_extreme(const Scene& scene, const Setting& setting, const ExtremeRun& run);

/// R_E of solves that, in every substep of the run, may let the lightest body go by half of what is thinnest.
/// At rest a substep of h asks all bodies, together of mass M, for the speed g h. R_E is the root of a share
/// of energy: a solve that ends with R_E = r leaves M (r g h)^2 at most, and all of it may be that of the
/// lightest body, m, which is then as fast as e = r v with v = g h sqrt(M / m). The next solve is asked for
/// that too and leaves r (v + e), so e grows to v r / (1 - r): a way of e T in a run of T. That is half of a
/// size s for
///   r = (s / 2) / (s / 2 + v T).
/// Without gravity it is 1: nothing is asked of bodies at rest.
double telling_residual(const Scene& scene, const Setting& setting, const ExtremeRun& run);

/// [m] By how much the springs of policy soft give way under `load` [N] on a point where an impulse of 1 N s
/// changes the approach by `inverse_mass` [1/kg]: a point's spring has the stiffness omega^2 / inverse_mass,
/// and omega goes up to a quarter of the steps. 0 under every other policy.
double spring_sag(const Setting& setting, double load, double inverse_mass);

/// A finding that depends on one number alone: OK up to `limit`, a failure above `bound`, bounded between.
ExtremeFinding judged(const std::string& quantity, double value, double limit, double bound);

/// Calls run(Real()) with the scalar type that is asked for.
template <typename Run>
auto in_scalar(Precision scalar, const Run& run) {
  if (scalar == Precision::single_precision) return run(float());
  return run(double());
}

/// A scene with the settings that a setting asks for.
Scene scene_for(const Setting& setting, const SceneSettings& usual = {});

}  // namespace cairn
