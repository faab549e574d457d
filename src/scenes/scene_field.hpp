// Floor 8. Keys that are members of structs: what they are in a file, and how tables fill them.
#pragma once

#include <concepts>
#include <functional>
#include <type_traits>

#include <cairn/math/check.hpp>
#include <cairn/scenes/named.hpp>
#include <cairn/scenes/scene_table.hpp>

namespace cairn {

/// Gives a member, or what it may hold, what the table says under the key.
template <typename Value>
void read_value(const SceneTable& table, const std::string& key, Value& value) {
  if constexpr (requires { value.has_value(); }) {
    read_value(table, key, value.emplace());
  } else if constexpr (std::is_enum_v<Value>) {
    value = value_of<Value>(table.get<std::string>(key));
  } else if constexpr (std::is_arithmetic_v<Value> && !std::same_as<Value, bool>) {
    value = static_cast<Value>(table.get<double>(key));
  } else {
    value = table.get<Value>(key);
  }
}

/// What such a value is in a file, with this one as the default.
template <typename Value>
SceneField field_of(const Value& usual) {
  SceneField field;
  if constexpr (requires { usual.has_value(); }) {
    field.type = field_of(typename Value::value_type()).type;
  } else if constexpr (std::is_enum_v<Value>) {
    field = {SceneType::word, word_of(usual), words_of<Value>()};
  } else if constexpr (std::same_as<Value, bool>) {
    field = {SceneType::flag, usual ? "true" : "false"};
  } else if constexpr (std::same_as<Value, std::string>) {
    field = {SceneType::text, usual};
  } else if constexpr (std::same_as<Value, Vec2<double>>) {
    field = {SceneType::point, "[" + shortest(usual.x()) + ", " + shortest(usual.y()) + "]"};
  } else {
    field.type = std::integral<Value> ? SceneType::integer : SceneType::number;
    field.usual = shortest(static_cast<double>(usual));
  }
  return field;
}

/// What `access` finds in a Struct.
template <typename Struct, typename Access>
SceneField field_in(Access access) {
  Struct usual;
  SceneField field = field_of(std::invoke(access, usual));
  field.readers.push_back(
      SceneReader<Struct>([access](const SceneTable& table, const std::string& key, Struct& into) {
        read_value(table, key, std::invoke(access, into));
      }));
  return field;
}

/// A member of a member.
template <typename Struct, typename Outer, typename Value>
SceneField nested(Outer Struct::*outer, Value Outer::*inner) {
  return field_in<Struct>([=](Struct& into) -> Value& { return into.*outer.*inner; });
}

/// A member of one struct, and the same of another.
template <typename Member, typename Other>
SceneField members(Member member, Other other) {
  SceneField field = member;
  field.readers.push_back(SceneField(other).readers[0]);
  return field;
}

template <typename Struct, typename Value>
SceneField::SceneField(Value Struct::*member) : SceneField(field_in<Struct>(member)) {}

}  // namespace cairn
