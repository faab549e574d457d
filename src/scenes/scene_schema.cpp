// Floor 8. Looking keys up, and what they demand.
#include <cairn/scenes/scene_schema.hpp>
#include <cairn/math/list.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace cairn {

const List<SceneKey>& scene_keys() {
  static const List<SceneKey> keys = [] {
    List<SceneKey> all;
    for (const auto& part : {scene_top_keys, scene_step_keys, scene_recommended_keys, scene_body_keys,
                             scene_pair_keys, scene_motor_keys, scene_train_keys, scene_event_keys,
                             scene_acting_keys, scene_block_keys, scene_hanging_keys}) {
      for (const SceneKey& key : part()) {
        all.push_back(key);
        if (key.fallback.empty()) all.back().fallback = key.field.usual;
      }
    }
    return all;
  }();
  return keys;
}

const SceneTableKind& scene_table_kind(const std::string& name) {
  for (const SceneTableKind& kind : scene_table_kinds()) {
    if (kind.name == name) return kind;
  }
  throw std::logic_error("scene_table_kind: there is no kind " + name);
}

List<const SceneKey*> keys_of(const SceneTableKind& kind) {
  List<const SceneKey*> found;
  for (const std::string& group : kind.groups) {
    for (const SceneKey& key : scene_keys()) {
      if (key.group == group) found.push_back(&key);
    }
  }
  return found;
}

const SceneKey* find_scene_key(const SceneTableKind& kind, const std::string& key) {
  for (const SceneKey* candidate : keys_of(kind)) {
    if (candidate->key == key) return candidate;
  }
  return nullptr;
}

bool has_default(const SceneKey& key) {
  return !key.fallback.empty() && key.fallback != "required" &&
         !std::isupper(static_cast<unsigned char>(key.fallback[0]));
}

std::string rule_text(const SceneKey& key) {
  const std::string range = key.range.empty() ? "" : " " + key.range;
  const std::string unit = key.unit.empty() ? "" : " " + key.unit;
  const std::string of_unit = key.unit.empty() ? "" : key.range.empty() ? " of " + key.unit : unit;
  switch (key.field.type) {
    case SceneType::number:
      return "a number" + range + of_unit;
    case SceneType::integer:
      return "a whole number" + range + unit;
    case SceneType::flag:
      return "true or false";
    case SceneType::word:
      return fmt::format("one of {}", fmt::join(key.field.words, ", "));
    case SceneType::text:
      return "a text in quotes";
    case SceneType::point:
      return "two numbers" + range + of_unit + " in brackets";
    case SceneType::points:
      return "a list of points [x, y]" + of_unit;
    case SceneType::table:
      return key.group == "scene" ? "one table, [" + key.key + "]" : "a table in braces: { key = value }";
    case SceneType::tables:
      break;
  }
  return key.group == "scene" ? "a list of tables, each [[" + key.key + "]]"
                              : "a list of tables: [{...}, {...}]";
}

bool in_range(const SceneKey& key, double value) {
  const std::string infinite = " or inf";
  std::string range = key.range;
  if (range.size() > infinite.size() && range.substr(range.size() - infinite.size()) == infinite) {
    if (std::isinf(value) && value > 0) return true;
    range.resize(range.size() - infinite.size());
  }
  if (!std::isfinite(value)) return false;
  double least = 0, most = 0;
  if (std::sscanf(range.c_str(), "from %lf to %lf", &least, &most) == 2) {
    return value >= least && value <= most;
  }
  if (std::sscanf(range.c_str(), ">= %lf", &least) == 1) return value >= least;
  if (std::sscanf(range.c_str(), "> %lf", &least) == 1) return value > least;
  return true;
}

}  // namespace cairn
