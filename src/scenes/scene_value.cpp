// Floor 8. Values in words.
#include <cairn/scenes/scene_value.hpp>

#include <fmt/format.h>

#include <algorithm>

#include <cairn/math/check.hpp>
#include <cairn/math/printable.hpp>
#include <cairn/scenes/scene_file.hpp>

namespace cairn {

const SceneValue* SceneValue::find(const std::string& name) const {
  const auto found =
      std::find_if(items.begin(), items.end(), [&name](const SceneValue& item) { return item.key == name; });
  return kind == Kind::table && found != items.end() ? &*found : nullptr;
}

std::string description(const SceneValue& value) {
  switch (value.kind) {
    case SceneValue::Kind::flag:
      return value.number != 0 ? "true" : "false";
    case SceneValue::Kind::integer:
      return std::to_string(value.integer);
    case SceneValue::Kind::number:
      return shortest(value.number);
    case SceneValue::Kind::text:
      return '"' + excerpt(value.text) + '"';
    case SceneValue::Kind::array:
      return fmt::format("a list of {}", value.items.size());
    case SceneValue::Kind::table:
      return "a table";
    case SceneValue::Kind::other:
      break;
  }
  return "a date or time";
}

void require_scene_size(std::uintmax_t bytes, const std::string& file) {
  if (bytes > most_scene_bytes)
    refuse_scene(file, {}, fmt::format("the file must be at most {} bytes, got {}", most_scene_bytes, bytes));
}

void refuse_scene(const std::string& file, const SceneMark& mark, const std::string& message) {
  throw SceneRefusal(fmt::format("{}:{}:{}: {}", file, mark.line, mark.column, message));
}

}  // namespace cairn
