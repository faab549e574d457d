// Floor 8. Refusing keys and values that a table cannot have.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <cairn/math/check.hpp>
#include <cairn/math/nearest.hpp>
#include <cairn/math/printable.hpp>
#include <cairn/scenes/scene_table.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

void SceneTable::check_member(const SceneValue& member) const {
  const SceneKey* key = find_scene_key(*kind_, member.key);
  if (!key) refuse_unknown(member);
  check_value(*key, member, path_of(member.key));
}

void SceneTable::refuse_unknown(const SceneValue& member) const {
  List<std::string> names;
  for (const SceneKey* key : keys_of(*kind_)) names.push_back(key->key);
  const std::string near = nearest(member.key, names);
  std::string hint = near.empty() ? "; it may have " : " (" + near + "?)";
  for (int i = 0; near.empty() && i < names.size(); ++i) hint += (i > 0 ? ", " : "") + names[i];
  refuse_scene(context_->file, member.key_mark,
               fmt::format("{} must be a known key, but {} has none of that name{}", path_of(member.key),
                           kind_->heading, hint));
}

void SceneTable::refuse_value(const SceneKey& key, const SceneValue& value, const std::string& path) const {
  refuse_scene(context_->file, value.mark,
               fmt::format("{} must be {}, got {}", path, rule_text(key), description(value)));
}

void SceneTable::check_number(const SceneKey& key, const SceneValue& value, const std::string& path) const {
  const double number = scene_number(*context_, value, path, rule_text(key));
  const bool whole = key.field.type != SceneType::integer || number == std::floor(number);
  if (in_range(key, number) && whole) return;
  std::string got = description(value);
  if (value.kind == SceneValue::Kind::text) got += ", which is " + shortest(number);
  refuse_scene(context_->file, value.mark, fmt::format("{} must be {}, got {}", path, rule_text(key), got));
}

void SceneTable::check_point(const SceneKey& key, const SceneValue& value, const std::string& path) const {
  if (value.kind != SceneValue::Kind::array || value.items.size() != 2) refuse_value(key, value, path);
  SceneKey coordinate = key;
  coordinate.field.type = SceneType::number;
  for (int i = 0; i < 2; ++i) {
    check_number(coordinate, value.items[i], fmt::format("{}[{}]", path, i + 1));
  }
}

void SceneTable::check_text(const SceneValue& value, const std::string& path) const {
  const std::size_t longest = 1000;
  if (excerpt(value.text, longest) == value.text) return;
  refuse_scene(context_->file, value.mark,
               fmt::format("{} must be one line of at most {} bytes without control characters, got {}", path,
                           longest, description(value)));
}

void SceneTable::check_value(const SceneKey& key, const SceneValue& value, const std::string& path) const {
  using Kind = SceneValue::Kind;
  const auto demand = [&](Kind kind) {
    if (value.kind != kind) refuse_value(key, value, path);
  };
  switch (key.field.type) {
    case SceneType::number:
    case SceneType::integer:
      return check_number(key, value, path);
    case SceneType::flag:
      return demand(Kind::flag);
    case SceneType::text:
      demand(Kind::text);
      return check_text(value, path);
    case SceneType::word: {
      const List<std::string>& words = key.field.words;
      if (value.kind == Kind::text && !known_word(value.text, words).empty()) return;
      const std::string near = value.kind == Kind::text ? nearest(value.text, words) : "";
      const std::string hint = near.empty() ? "" : " (" + near + "?)";
      refuse_scene(context_->file, value.mark,
                   fmt::format("{} must be {}, got {}{}", path, rule_text(key), description(value), hint));
    }
    case SceneType::point:
      return check_point(key, value, path);
    case SceneType::points:
      demand(Kind::array);
      for (int i = 0; i < value.items.size(); ++i) {
        check_point(key, value.items[i], fmt::format("{}[{}]", path, i + 1));
      }
      return;
    case SceneType::table:
      return demand(Kind::table);
    case SceneType::tables:
      demand(Kind::array);
      for (const SceneValue& item : value.items) {
        if (item.kind != Kind::table) refuse_value(key, item, path);
      }
  }
}

void SceneTable::check_required() const {
  for (const SceneKey* key : keys_of(*kind_)) {
    if (key->fallback != "required" || has(key->key)) continue;
    const std::string meaning = key->meaning.empty() ? "" : " (" + key->meaning + ")";
    refuse_scene(context_->file, value_->mark,
                 fmt::format("{} must be given: {}{}", path_of(key->key), rule_text(*key), meaning));
  }
}

}  // namespace cairn
