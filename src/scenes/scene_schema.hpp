// Floor 8. Every key of a scene file: the one table that the reader and its page are made from.
#pragma once

#include <any>
#include <functional>
#include <string>
#include <utility>

#include <cairn/math/list.hpp>

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

class SceneTable;

/// Gives a member of `into` what the table says under the key.
template <typename Struct>
using SceneReader = std::function<void(const SceneTable& table, const std::string& key, Struct& into)>;

/// What the value of a key is. Where it goes to a member of a struct, or of several, these say its type, its
/// default and its words, and SceneTable::read() fills them: scene_field.hpp.
struct SceneField {
  SceneType type = SceneType::number;
  std::string usual = {};        // the default of the member
  List<std::string> words = {};  // of a word: all that it may be
  List<std::any> readers = {};   // a SceneReader<Struct> for each struct

  SceneField(SceneType of = SceneType::number, std::string fallback = {}, List<std::string> all = {})
      : type(of), usual(std::move(fallback)), words(std::move(all)) {}
  template <typename Struct, typename Value>
  SceneField(Value Struct::*member);
};

/// A word, of these.
inline SceneField one_of(List<std::string> words) { return {SceneType::word, "", std::move(words)}; }

/// One key, a row of the table. Keys that several tables have are written once, in a group of their own.
struct SceneKey {
  std::string group = {};
  std::string key = {};
  SceneField field = {};
  std::string unit = {};
  std::string range = {};  // "> 0", "from 0 to 1"; of a table: the name of its kind
  std::string meaning = {};
  /// As it would be in a file; "required"; in words, with a capital; left out: that of the member, or none.
  std::string fallback = {};
};

class SceneBuilder;
struct ScenePair;

/// A kind of table: its keys are those of its groups.
struct SceneTableKind {
  std::string name = {};     // "body"
  std::string heading = {};  // "[[body]]"; left out: by the name, as the kinds beside it
  List<std::string> groups = {};
  std::string meaning = {};
  /// Adds what such a table says, where it stands for many bodies; `name` is that of the whole. Or, of a type
  /// of [[joint]], makes one.
  void (*build)(SceneBuilder& builder, const SceneTable& table, const std::string& name) = nullptr;
  void (*join)(const ScenePair& pair) = nullptr;
};

const List<SceneKey>& scene_keys();
const List<SceneTableKind>& scene_table_kinds();

/// @throws std::logic_error for a kind that there is not.
const SceneTableKind& scene_table_kind(const std::string& name);
/// The keys of all groups of a kind, in order.
List<const SceneKey*> keys_of(const SceneTableKind& kind);
/// The key of that name in a kind of table, or none.
const SceneKey* find_scene_key(const SceneTableKind& kind, const std::string& key);
/// Whether a default is a value that the reader uses; others are missing or told in words.
bool has_default(const SceneKey& key);
/// What a value has to be: "a number > 0 kg/m^2".
std::string rule_text(const SceneKey& key);
/// Whether a number is in the range of the key.
bool in_range(const SceneKey& key, double value);

/// All kinds and keys as tables: lessons/scenes/REFERENCE.md, from "## Every table" on.
std::string scene_schema_page();

// A part of scene_table_kinds(), and the parts of scene_keys().
List<SceneTableKind> scene_joint_kinds();
List<SceneKey> scene_top_keys();
List<SceneKey> scene_step_keys();
List<SceneKey> scene_recommended_keys();
List<SceneKey> scene_body_keys();
List<SceneKey> scene_pair_keys();
List<SceneKey> scene_motor_keys();
List<SceneKey> scene_train_keys();
List<SceneKey> scene_event_keys();
List<SceneKey> scene_acting_keys();
List<SceneKey> scene_block_keys();
List<SceneKey> scene_hanging_keys();

}  // namespace cairn
