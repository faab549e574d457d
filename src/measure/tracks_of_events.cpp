// Floor 6. Quantities of sensors and of what events count.
#include <cairn/measure/tracks.hpp>

#include <fnmatch.h>

#include <algorithm>
#include <limits>
#include <set>

namespace cairn {

List<BodyId> sensors_of(const Scene& scene) {
  List<BodyId> sensors;
  for (const BodyId body : scene.bodies().indices()) {
    if (scene.bodies()[body].spec.sensor) sensors.push_back(body);
  }
  return sensors;
}

List<std::string> counters_of(const Scene& scene) {
  std::set<std::string> names;
  for (const SceneEvent& event : scene.events()) {
    if (const auto* counted = std::get_if<CountTouches>(&event.action)) names.insert(counted->counter);
  }
  return {names.begin(), names.end()};
}

bool TrackRecorder::matches(const std::string& pattern, const std::string& text) {
  return fnmatch(pattern.c_str(), text.c_str(), FNM_NOESCAPE) == 0;
}

/// Of whatever kind they are.
bool TrackRecorder::take_things(const std::string& name, const std::string& quantity) {
  const bool of_sensors = take_sensors(name, quantity), of_counters = take_counters(name, quantity);
  return take_bodies(name, quantity) | take_joints(name, quantity) | of_sensors | of_counters;
}

bool TrackRecorder::take_sensors(const std::string& name, const std::string& quantity) {
  bool found = false;
  for (const BodyId id : names_.sensors) {
    if (!matches(name, names_.bodies[id]) || !matches(quantity, "touching")) continue;
    add_track(names_.bodies[id] + ".touching", "", [id](const Snapshot& now) {
      return static_cast<double>(std::count_if(now.sensed.begin(), now.sensed.end(), [id](const Pair& pair) {
        return pair.first == id || pair.second == id;
      }));
    });
    found = true;
  }
  return found;
}

bool TrackRecorder::take_counters(const std::string& name, const std::string& quantity) {
  bool found = false;
  for (const std::string& counter : names_.counters) {
    if (!matches(name, counter) || !matches(quantity, "count")) continue;
    add_track(counter + ".count", "", [counter](const Snapshot& now) {
      for (const SnapshotCounter& each : now.counters) {
        if (each.name == counter) return static_cast<double>(each.count);
      }
      return std::numeric_limits<double>::quiet_NaN();
    });
    found = true;
  }
  return found;
}

}  // namespace cairn
