// A run for programs: numbers in base units, by name.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lessons/sandbox/run_table.hpp"
#include <cairn/study/build_info.hpp>

namespace cairn::sandbox {
namespace {

using Json = nlohmann::ordered_json;

/// Null where there was nothing to measure.
Json worst_json(const SceneEntry& scene, double value, const TrialWorst& worst) {
  if (!(value > 0)) return nullptr;
  Json json = {{"a", scene.body_names[worst.a]}, {"b", scene.body_names[worst.b]}, {"time_s", worst.time}};
  if (!worst.joint.empty()) json["joint"] = worst.joint;
  return json;
}

Json places_json(const SceneEntry& scene, const SceneRun& run) {
  Json places = Json::array();
  for (int i = 0; judges_places(scene, run) && i < scene.expectations.places.size(); ++i) {
    const ExpectedPlace& place = scene.expectations.places[i];
    places.push_back({{"body", scene.body_names[place.body]},
                      {"distance_m", run.result.place_distances[i]},
                      {"within_m", place.within}});
  }
  return places;
}

/// What was asked, each with the share of its limit that it came to: null for an infinite one.
Json asked_json(const RunJudgement& judgement) {
  Json asked = Json::array();
  for (const JudgedPart& part : judgement.parts) {
    const Json share = std::isfinite(part.share) ? Json(part.share) : Json(nullptr);
    asked.push_back({{"what", part.name}, {"found", part.found}, {"asked", part.asked}, {"share", share}});
  }
  return asked;
}

Json measures_json(const SceneEntry& scene, const SceneRun& run) {
  const TrialResult& result = run.result;
  return {{"time_s", result.seconds},
          {"steps", result.steps},
          {"step_ms", 1e3 * result.step_seconds / std::max(1, result.steps)},
          {"step_ms_median", 1e3 * result.median_step},
          {"step_ms_slowest", 1e3 * result.slowest_step},
          {"setup_ms", 1e3 * result.setup_seconds},
          {"row_updates", result.row_updates},
          {"unfinished_steps", result.unfinished_steps},
          {"unfinished_residual", result.unfinished_residual},
          {"last_residual", result.worst_residual ? Json(*result.worst_residual) : Json(nullptr)},
          {"penetration_m", result.worst_penetration},
          {"penetration_worst", worst_json(scene, result.worst_penetration, result.penetration_worst)},
          {"drift_m_or_rad", result.worst_drift},
          {"drift_worst", worst_json(scene, result.worst_drift, result.drift_worst)},
          {"of_body", result.of_body()},
          {"jitter_m_s", result.jitter},
          {"energy_scale_J", result.energy_scale},
          {"energy_gain", result.energy_gain},
          {"energy_loss", result.energy_loss},
          {"farthest_m", result.farthest},
          {"stands_s", scene.expectations.stands ? Json(result.stands_until) : Json(nullptr)},
          {"places", places_json(scene, run)}};
}

}  // namespace

nlohmann::ordered_json run_json(const SceneEntry& scene, const SceneRun& run) {
  const TrialResult& result = run.result;
  const Setting& setting = run.setting;
  Json json = {{"scene", scene.name},
               {"setting", setting_text(setting)},
               {"solver", setting.solver},
               {"sweeps", setting.sweeps.iterations},
               {"substeps", setting.substeps},
               {"dt_s", setting.dt},
               {"status", status_text(result.status)}};
  if (result.status == TrialStatus::refused) {
    json["reason"] = result.reason;
    return json;
  }
  json.update(measures_json(scene, run));
  json.update(occurrences_json(scene, run.occurrences));
  json.update({{"asked", asked_json(run.judgement)},
               {"missed", run.judgement.missed()},
               {"failures", run.judgement.failures},
               {"build", build_json()},
               {"state", fmt::format("{:016x}", result.state_hash)}});
  return json;
}

}  // namespace cairn::sandbox
