// Floor 8. Every key of a scene file: the one table that the reader and its page are made from.
#pragma once

#include <string>

#include "math/list.hpp"

namespace cairn {

/// What a scene may have, beside the ground.
inline constexpr int most_scene_bodies = 20000;

enum class SceneType {
  number,   // or a sum in quotes
  integer,  // a whole number
  flag,     // true or false
  word,     // one of a few
  text,
  point,   // [x, y]
  points,  // a list of those
  table,
  tables,  // a list of those, or one table [[...]] after the other
};

/// One key. Keys that several tables have are written once, in a group of their own.
struct SceneKey {
  std::string group = {};
  std::string key = {};
  SceneType type = SceneType::number;
  std::string unit = {};
  std::string fallback = {};  // as it would be in a file; "required"; "": none; or in words, with a capital
  std::string range = {};  // "> 0", "from 0 to 1"; of a word: all of them; of a table: the name of its kind
  std::string meaning = {};
};

/// A kind of table: its keys are those of its groups.
struct SceneTableKind {
  std::string name = {};     // "body"
  std::string heading = {};  // "[[body]]"
  List<std::string> groups = {};
  std::string meaning = {};
};

const List<SceneKey>& scene_keys();
const List<SceneTableKind>& scene_table_kinds();

/// @throws std::logic_error for a kind that there is not.
const SceneTableKind& scene_table_kind(const std::string& name);
/// The keys of all groups of a kind, in order.
List<const SceneKey*> keys_of(const SceneTableKind& kind);
/// The key of that name in a kind of table, or none.
const SceneKey* find_scene_key(const SceneTableKind& kind, const std::string& key);
/// The words of a key of type word, and the last ones for lists of them.
List<std::string> scene_words(const SceneKey& key);
/// Whether a default is a value that the reader uses; others are missing or told in words.
bool has_default(const SceneKey& key);
/// What a value has to be: "a number > 0 kg/m^2".
std::string rule_text(const SceneKey& key);
/// Whether a number is in the range of the key.
bool in_range(const SceneKey& key, double value);

/// The page lessons/scenes/README.md.
std::string scene_schema_page();

// The parts of scene_keys().
List<SceneKey> scene_setting_keys();
List<SceneKey> scene_body_keys();
List<SceneKey> scene_joint_keys();
List<SceneKey> scene_event_keys();
List<SceneKey> scene_repeat_keys();

}  // namespace cairn
