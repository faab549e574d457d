// Sensors, breaks and counters of a run, in words and as JSON.
#include "lessons/sandbox/occurrences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace cairn::sandbox {
namespace {

using Json = nlohmann::ordered_json;

constexpr int most_lines = 8;  // of breaks, and of visits

std::string joint_name(const SceneEntry& scene, JointId id) {
  for (const auto& [name, joint] : scene.joint_ids) {
    if (joint == id) return name;
  }
  return fmt::format("joint {}", id.index);
}

std::string break_text(const SceneEntry& scene, const SnapshotBreak& broken) {
  std::string text = fmt::format("{} at {:.4g} s", joint_name(scene, broken.joint.id), broken.time);
  if (broken.force > 0) text += fmt::format(", holding {:.4g} N", broken.force);
  // Of a pin there is only rounding.
  if (broken.torque > 1e-9 * broken.force) text += fmt::format(" and {:.4g} N m", broken.torque);
  return text;
}

std::string visit_text(const SceneEntry& scene, const SensorVisit& visit) {
  std::string text = fmt::format("{} from {:.4g} s", scene.body_names[visit.body], visit.entered);
  return text + (visit.left ? fmt::format(" to {:.4g} s", *visit.left) : " to the end");
}

/// Keeps a few of the lines, and says how many were left out.
void add_few(const List<OccurrenceLine>& lines, List<OccurrenceLine>& all) {
  for (int i = 0; i < std::min(lines.size(), most_lines); ++i) all.push_back(lines[i]);
  if (lines.size() > most_lines) all.push_back({"", fmt::format("and {} more", lines.size() - most_lines)});
}

}  // namespace

void Occurrences::see(const Snapshot& now) {
  const auto is_there = [&now](BodyId sensor, BodyId body) {
    return std::binary_search(now.sensed.begin(), now.sensed.end(),
                              std::pair<BodyId, BodyId>(std::minmax(sensor, body)));
  };
  for (SensorVisit& visit : visits_) {
    if (!visit.left && !is_there(visit.sensor, visit.body)) visit.left = now.time;
  }
  const auto enter = [&](BodyId sensor, BodyId body) {
    if (!now.bodies[sensor].sensor) return;
    const auto is_in = [&](const SensorVisit& visit) {
      return visit.sensor == sensor && visit.body == body && !visit.left;
    };
    if (std::none_of(visits_.begin(), visits_.end(), is_in)) visits_.push_back({sensor, body, now.time});
  };
  for (const auto& [one, other] : now.sensed) {
    enter(one, other);
    enter(other, one);
  }
  breaks_ = now.broken;
  counters_ = now.counters;
}

List<OccurrenceLine> occurrence_lines(const SceneEntry& scene, const Occurrences& occurrences) {
  List<OccurrenceLine> lines, breaks, visits;
  std::string counts;
  for (const SnapshotCounter& counter : occurrences.counters())
    counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", counter.name, counter.count);
  if (!counts.empty()) lines.push_back({"counted", counts});
  for (const SnapshotBreak& broken : occurrences.breaks())
    breaks.push_back({breaks.empty() ? "broke" : "", break_text(scene, broken)});
  for (const SensorVisit& visit : occurrences.visits())
    visits.push_back({"in " + scene.body_names[visit.sensor], visit_text(scene, visit)});
  add_few(breaks, lines);
  add_few(visits, lines);
  return lines;
}

nlohmann::ordered_json occurrences_json(const SceneEntry& scene, const Occurrences& occurrences) {
  Json counters = Json::object(), broken = Json::array(), sensors = Json::array();
  for (const SnapshotCounter& counter : occurrences.counters()) counters[counter.name] = counter.count;
  for (const SnapshotBreak& each : occurrences.breaks()) {
    broken.push_back({{"joint", joint_name(scene, each.joint.id)},
                      {"time_s", each.time},
                      {"force_N", each.force},
                      {"torque_Nm", each.torque}});
  }
  for (const SensorVisit& visit : occurrences.visits()) {
    sensors.push_back({{"sensor", scene.body_names[visit.sensor]},
                       {"body", scene.body_names[visit.body]},
                       {"entered_s", visit.entered},
                       {"left_s", visit.left ? Json(*visit.left) : Json(nullptr)}});
  }
  return {{"counters", counters}, {"broken", broken}, {"sensors", sensors}};
}

}  // namespace cairn::sandbox
