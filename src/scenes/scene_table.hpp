// Floor 8. One table of a scene file, held against the keys that it may have.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include <cairn/math/math.hpp>
#include <cairn/scenes/scene_schema.hpp>
#include <cairn/scenes/scene_value.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// What every table of a file shares.
struct SceneContext {
  std::string file = {};                       // as messages name it
  std::map<std::string, double> numbers = {};  // of [numbers]
};

/// Every function takes a key of the table's kind. What the file leaves out is the default of the key.
class SceneTable {
 public:
  /// Checks all keys, their types and ranges. `context` and `value` must outlive the table. `path` is what
  /// messages call it: "body[2]", or "" for the file itself.
  /// @throws std::invalid_argument, with place and rule, for the first key that is not as it should be.
  SceneTable(const SceneContext& context, const SceneValue& value, const std::string& kind,
             const std::string& path);

  bool has(const std::string& key) const { return value_->find(key) != nullptr; }
  /// As a bool, an int, a double (an integer's too), a text (a word is as the key lists it), a Vec2<double>
  /// or a List of them.
  template <typename Value>
  Value get(const std::string& key) const;
  /// The tables of a key of type table or tables; empty: there is none.
  List<SceneTable> tables(const std::string& key) const;
  /// Gives all that the file says of members of such a struct to these members; the others stay as they are.
  template <typename Struct>
  void read(Struct& into) const;

  const SceneContext& context() const { return *context_; }
  SceneMark mark() const { return value_->mark; }
  const std::string& path() const { return path_; }
  const std::string& kind() const { return kind_->name; }
  /// Throws "file:line:column: path.key must be rule, got value"; the place is that of the key, or else of
  /// the table.
  [[noreturn]] void refuse(const std::string& key, const std::string& rule, const std::string& got) const;
  [[noreturn]] void refuse(const std::string& key, const std::string& rule) const;
  /// Does `work`, and says of what it throws where in the file that was.
  void guard(const std::function<void()>& work) const;

 private:
  const SceneKey& known(const std::string& key) const;
  std::string path_of(const std::string& key) const;
  void check_member(const SceneValue& member) const;
  void check_value(const SceneKey& key, const SceneValue& value, const std::string& path) const;
  void check_number(const SceneKey& key, const SceneValue& value, const std::string& path) const;
  void check_text(const SceneValue& value, const std::string& path) const;
  void check_point(const SceneKey& key, const SceneValue& value, const std::string& path) const;
  void check_required() const;
  /// What the library refused, "Class: field must be ...", in words of the file: a field that is a key by its
  /// path, and nothing of the class.
  [[noreturn]] void refuse_as_key(const std::string& message) const;
  [[noreturn]] void refuse_unknown(const SceneValue& member) const;
  [[noreturn]] void refuse_value(const SceneKey& key, const SceneValue& value, const std::string& path) const;

  const SceneContext* context_;
  const SceneValue* value_;
  const SceneTableKind* kind_;
  std::string path_;
};

template <>
bool SceneTable::get(const std::string& key) const;
template <>
double SceneTable::get(const std::string& key) const;
template <>
int SceneTable::get(const std::string& key) const;
template <>
std::string SceneTable::get(const std::string& key) const;
template <>
Vec2<double> SceneTable::get(const std::string& key) const;
template <>
List<Vec2<double>> SceneTable::get(const std::string& key) const;

template <typename Struct>
void SceneTable::read(Struct& into) const {
  for (const SceneKey* key : keys_of(*kind_)) {
    for (const std::any& reader : key->field.readers) {
      const auto* const found = std::any_cast<SceneReader<Struct>>(&reader);
      if (found != nullptr && has(key->key)) (*found)(*this, key->key, into);
    }
  }
}

/// The table under a key as such a struct; none where there is no table.
template <typename Struct>
std::optional<Struct> part_of(const SceneTable& table, const std::string& key) {
  std::optional<Struct> part;
  for (const SceneTable& inner : table.tables(key)) inner.read(part.emplace(Struct{}));
  return part;
}

/// The number of a value that is one, or a sum in quotes. @throws std::invalid_argument.
double scene_number(const SceneContext& context, const SceneValue& value, const std::string& path,
                    const std::string& rule);

}  // namespace cairn
