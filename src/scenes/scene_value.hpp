// Floor 8. What a scene file says, as a tree of values that know their places.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include <cairn/math/list.hpp>

namespace cairn {

/// A place in a file, counted from 1.
struct SceneMark {
  int line = 1;
  int column = 1;
};

/// One value of the file. The members of a table are in the order in which the file has them.
struct SceneValue {
  enum class Kind { flag, integer, number, text, array, table, other };
  Kind kind = Kind::table;
  std::string key = {};         // in its table; "" for an item of an array
  SceneMark key_mark = {};      // where the key is
  SceneMark mark = {};          // where the value is
  double number = 0;            // of integer and number; 1 of a flag that is true
  long long integer = 0;        // of integer
  std::string text = {};        // of text
  List<SceneValue> items = {};  // of array and table

  /// The member of that name, or none.
  const SceneValue* find(const std::string& name) const;
};

/// For messages: a number, "a text" in quotes, true, "a table", "a list of 3".
std::string description(const SceneValue& value);

/// What a scene file is refused for, with its place in the file.
struct SceneRefusal : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Throws SceneRefusal "file:line:column: message".
[[noreturn]] void refuse_scene(const std::string& file, const SceneMark& mark, const std::string& message);

/// @throws std::invalid_argument for a file of more than most_scene_bytes.
void require_scene_size(std::uintmax_t bytes, const std::string& file);

/// The tree of a TOML text. `file` is the name that messages give it.
/// @throws std::invalid_argument for what is no TOML, and for more than most_scene_bytes.
SceneValue parse_toml(const std::string& text, const std::string& file);

}  // namespace cairn
