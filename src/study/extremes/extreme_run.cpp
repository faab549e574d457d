// Floor 9. Stepping a case, and judging it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <cairn/study/extremes/extreme_axes.hpp>
#include <cairn/math/list.hpp>
#include <cairn/world/scene_length.hpp>

namespace cairn {

namespace {

bool is_below(const Snapshot& now, double floor) {
  for (const SnapshotBody& body : now.bodies) {
    if (body.type == BodyType::dynamic && body.pose.position.y() < floor) return true;
  }
  return false;
}

/// Why the run is not even bounded; empty: it is.
std::string failure_of(const TrialResult& result, const ExtremeRun& run, const std::string& passage) {
  if (result.status != TrialStatus::ok) {
    return fmt::format("{} after {} steps", status_text(result.status), result.steps);
  }
  if (!passage.empty()) return passage;
  const double scale = run.energy_scale > 0 ? run.energy_scale : result.energy_scale;
  const double gain = result.energy_gain * result.energy_scale / scale;
  if (!(gain <= run.energy_gain)) {
    return fmt::format("energy grew by {:.3g} % of its scale", 100 * gain);
  }
  return "";
}

/// Says of a run that failed whether R_E tells why.
void tell_residual(const Scene& scene, const Setting& setting, const ExtremeRun& run, TrialOptions options,
                   ExtremeFinding& finding) {
  options.residual = ResidualMeasure::every_step;
  options.observer = {};
  const std::optional<double> residual = run_trial(scene, setting, options).worst_residual;
  if (!residual || !(*residual >= telling_residual(scene, setting, run))) return;
  finding.verdict = ExtremeVerdict::told;
  finding.note += fmt::format("; solves end at R_E {:.2g}", *residual);
}

}  // namespace

void AxisCases::add(const std::string& value, const ExtremeSetting& tried, ExtremeVerdict required,
                    const Run& run) {
  all_.push_back({axis_, value, tried.setting, required, tried.quick, run});
}

void AxisCases::add_usual(const std::string& value, ExtremeVerdict required, const Run& run) {
  for (const ExtremeSetting& tried : usual_settings()) add(value, tried, required, run);
}

void AxisCases::add_refusal(const std::string& value, const std::function<void()>& act) {
  add(value, {.quick = true}, ExtremeVerdict::refuse, [act](const Setting&) {
    act();
    return ExtremeFinding{.quantity = "not refused"};
  });
}

ExtremeMeasure farthest_place() {
  return {"farthest from its place (m)", [](const TrialResult& run) { return run.farthest; }};
}

ExtremeMeasure energy_gained() {
  return {"energy gain", [](const TrialResult& run) { return run.energy_gain; }};
}

ExtremeMeasure joint_drift() {
  return {"joint drift (m)", [](const TrialResult& run) { return run.worst_drift; }};
}

ExtremeMeasure drift_of_links() {
  return {"joint drift / link", [](const TrialResult& run) { return run.worst_drift / 0.5; }};
}

List<ExtremeSetting> usual_settings() {
  return {{setting_of("si", 10), true},
          {setting_of("si", 10, StabilizationPolicy::soft), false},
          {setting_of("si", 10, StabilizationPolicy::split_impulse), false},
          {setting_of("block-contact", 10), true},
          {setting_of("block", 10, StabilizationPolicy::soft), false},
          {setting_of("pgs-sparse", 10), false},
          {setting_of("accelerated", 30), false}};
}

ExtremeFinding run_extreme(const Scene& scene, const Setting& setting, const ExtremeRun& run) {
  std::string passage;
  TrialOptions options;
  options.seconds = run.seconds;
  options.most_energy = std::numeric_limits<double>::infinity();
  options.time_limit = run.time_limit;
  options.observer = [&](const Snapshot& now) {
    if (!passage.empty()) return;
    if (is_below(now, run.floor)) passage = fmt::format("a body is below the floor at {:.3g} s", now.time);
    if (run.escaped && run.escaped(now))
      passage = fmt::format("something went through at {:.3g} s", now.time);
  };
  const TrialResult result = run_trial(scene, setting, options);
  if (result.status == TrialStatus::refused) throw std::invalid_argument(result.reason);
  if (passage.empty() && result.worst_penetration > run.thinnest / 2) {
    passage = fmt::format("bodies overlap by {:.3g} m", result.worst_penetration);
  }
  ExtremeFinding finding{
      .quantity = run.measure.quantity, .value = run.measure.of(result), .limit = run.limit};
  finding.note = failure_of(result, run, passage);
  if (finding.note.empty()) {
    finding.verdict = finding.value <= run.limit ? ExtremeVerdict::ok : ExtremeVerdict::bound;
  } else {
    tell_residual(scene, setting, run, options, finding);
  }
  return finding;
}

double telling_residual(const Scene& scene, const Setting& setting, const ExtremeRun& run) {
  double all = 0, lightest = std::numeric_limits<double>::infinity();
  for (const SceneBody& body : scene.bodies()) {
    if (!(body.mass > 0)) continue;
    all += body.mass;
    lightest = std::min(lightest, body.mass);
  }
  const double half = std::min(run.thinnest, scene_length(scene)) / 2;
  const double asked = scene.settings().gravity.norm() * setting.dt / setting.substeps;
  return half / (half + asked * std::sqrt(all / lightest) * run.seconds);
}

double spring_sag(const Setting& setting, double load, double inverse_mass) {
  if (setting.stabilization.policy != StabilizationPolicy::soft) return 0;
  return cairn::spring_sag(setting.stabilization.soft, setting.dt / setting.substeps, load * inverse_mass);
}

ExtremeFinding judged(const std::string& quantity, double value, double limit, double bound) {
  ExtremeFinding finding{.quantity = quantity, .value = value, .limit = limit};
  if (value <= bound) finding.verdict = value <= limit ? ExtremeVerdict::ok : ExtremeVerdict::bound;
  if (!(value <= bound)) finding.note = fmt::format("must be at most {:.3g}", bound);
  return finding;
}

Scene scene_for(const Setting& setting, const SceneSettings& usual) {
  return Scene(with_setting(usual, setting));
}

}  // namespace cairn
