// Floor 8. TOML into values: the only file that knows toml++.
// toml++ asserts some of what it checks right after: "[" with no name behind it ends a program. With NDEBUG
// it lets clang++ assume the same. Neither is wanted of a text that may be wrong.
#undef NDEBUG
#define TOML_ASSERT(condition) static_cast<void>(0)
#include <toml++/toml.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include <cairn/math/printable.hpp>
#include <cairn/scenes/scene_value.hpp>

namespace cairn {

namespace {

SceneMark toml_mark(const toml::source_region& source) {
  return {.line = static_cast<int>(source.begin.line), .column = static_cast<int>(source.begin.column)};
}

bool toml_before(const SceneMark& a, const SceneMark& b) {
  return std::pair(a.line, a.column) < std::pair(b.line, b.column);
}

/// A value inside of more tables and lists than any scene needs.
struct TomlTooDeep {
  SceneMark mark = {};
};

SceneValue toml_value(const toml::node& node, int depth);

SceneValue toml_table(const toml::table& table, int depth) {
  SceneValue value;
  for (const auto& [key, node] : table) {
    SceneValue member = toml_value(node, depth + 1);
    member.key = std::string(key.str());
    member.key_mark = toml_mark(key.source());
    value.items.push_back(std::move(member));
  }
  // toml++ sorts by the alphabet; the file says which body comes first.
  std::stable_sort(value.items.begin(), value.items.end(), [](const SceneValue& a, const SceneValue& b) {
    return toml_before(a.key_mark, b.key_mark);
  });
  return value;
}

SceneValue toml_array(const toml::array& array, int depth) {
  SceneValue value;
  value.kind = SceneValue::Kind::array;
  for (const toml::node& node : array) {
    value.items.push_back(toml_value(node, depth + 1));
    value.items.back().key_mark = value.items.back().mark;
  }
  return value;
}

SceneValue toml_value(const toml::node& node, int depth) {
  const int deepest = 40;
  if (depth > deepest) throw TomlTooDeep{toml_mark(node.source())};
  SceneValue value;
  if (const toml::table* table = node.as_table()) {
    value = toml_table(*table, depth);
  } else if (const toml::array* array = node.as_array()) {
    value = toml_array(*array, depth);
  } else if (node.is_boolean()) {
    value.kind = SceneValue::Kind::flag;
    value.number = node.as_boolean()->get() ? 1 : 0;
  } else if (node.is_integer()) {
    value.kind = SceneValue::Kind::integer;
    value.integer = node.as_integer()->get();
    value.number = static_cast<double>(value.integer);
  } else if (node.is_floating_point()) {
    value.kind = SceneValue::Kind::number;
    value.number = node.as_floating_point()->get();
  } else if (node.is_string()) {
    value.kind = SceneValue::Kind::text;
    value.text = node.as_string()->get();
  } else {
    value.kind = SceneValue::Kind::other;
  }
  value.mark = toml_mark(node.source());
  return value;
}

void toml_replace(std::string& text, const std::string& what, const std::string& with) {
  const std::size_t place = text.find(what);
  if (place != std::string::npos) text.replace(place, what.size(), with);
}

/// "Error while parsing array: expected a comma" as "expected a comma (in an array)", in plain words.
std::string toml_complaint(const toml::parse_error& error) {
  std::string text(error.description());
  const std::string beginning = "Error while parsing ";
  const std::size_t colon = text.find(": ");
  if (text.compare(0, beginning.size(), beginning) == 0 && colon != std::string::npos) {
    const std::string where = text.substr(beginning.size(), colon - beginning.size());
    text = text.substr(colon + 2) + " (while reading a " + where + ")";
  }
  toml_replace(text, "could not determine value type",
               "a value must be a number, a list, or a text in quotes");
  toml_replace(text, "unescaped control characters other than TAB (U+0009) are explicitly prohibited",
               "a text must end on its line, and have no control characters");
  toml_replace(text, "could not be interpreted as a value", "is a number too large or too small");
  toml_replace(text, "is not representable in 64 bits", "is a number too large");
  toml_replace(text, " (TOML_MAX_NESTED_VALUES)", "");
  toml_replace(text, "Encountered", "there is an");
  toml_replace(text, "saw '\\n'", "and the line ended");
  toml_replace(text, "saw '\\r'", "and the line ended");
  toml_replace(text, "a array", "an array");
  toml_replace(text, "a inline", "an inline");
  return excerpt(text, 200);
}

/// Every dot of a key is a table in a table, and toml++ has no limit to them; the stack has.
void require_few_dots(const std::string& text, const std::string& file) {
  const int most = 40;
  SceneMark mark = {.line = 1, .column = 0};
  int dots = 0;
  bool is_comment = false, is_beginning = true;
  for (const char letter : text) {
    ++mark.column;
    if (letter == '\n') {
      mark = {.line = mark.line + 1, .column = 0};
      is_comment = false;
      is_beginning = true;
    } else if (letter != ' ' && letter != '\t') {
      is_comment |= is_beginning && letter == '#';
      is_beginning = false;
    }
    if (letter == '.') {
      ++dots;
    } else if (std::strchr("\n,=[]{}", letter)) {  // no key goes on behind these
      dots = 0;
    }
    if (dots > most && !is_comment) refuse_scene(file, mark, "a key must have at most 40 dots");
  }
}

}  // namespace

SceneValue parse_toml(const std::string& text, const std::string& file) {
  require_scene_size(text.size(), file);
  require_few_dots(text, file);
  try {
    const toml::table table = toml::parse(std::string_view(text), file);
    return toml_table(table, 0);
  } catch (const TomlTooDeep& deep) {
    refuse_scene(file, deep.mark, "the text must have at most 40 tables and lists in each other");
  } catch (const toml::parse_error& error) {
    refuse_scene(file, toml_mark(error.source()), "the text must be TOML: " + toml_complaint(error));
  }
}

}  // namespace cairn
