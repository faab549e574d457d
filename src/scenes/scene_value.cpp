// Floor 7. Values in words.
#include "scenes/scene_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "math/check.hpp"

namespace cairn {

const SceneValue* SceneValue::find(const std::string& name) const {
  const auto found =
      std::find_if(items.begin(), items.end(), [&name](const SceneValue& item) { return item.key == name; });
  return kind == Kind::table && found != items.end() ? &*found : nullptr;
}

std::string description(const SceneValue& value) {
  const std::size_t longest = 40;  // letters of a text that a message repeats
  switch (value.kind) {
    case SceneValue::Kind::flag:
      return value.number != 0 ? "true" : "false";
    case SceneValue::Kind::integer:
      return std::to_string(value.integer);
    case SceneValue::Kind::number:
      return shortest(value.number);
    case SceneValue::Kind::text:
      if (value.text.size() > longest) return '"' + value.text.substr(0, longest) + "...\"";
      return '"' + value.text + '"';
    case SceneValue::Kind::array:
      return fmt::format("a list of {}", value.items.size());
    case SceneValue::Kind::table:
      return "a table";
    case SceneValue::Kind::other:
      break;
  }
  return "a date or time";
}

void refuse_scene(const std::string& file, const SceneMark& mark, const std::string& message) {
  throw std::invalid_argument(fmt::format("{}:{}:{}: {}", file, mark.line, mark.column, message));
}

}  // namespace cairn
