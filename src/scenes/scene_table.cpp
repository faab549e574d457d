// Floor 8. Reading the keys of a table.
#include <cairn/scenes/scene_table.hpp>

#include <fmt/format.h>

#include <cctype>
#include <limits>
#include <stdexcept>

#include <cairn/math/nearest.hpp>
#include <cairn/math/printable.hpp>
#include <cairn/scenes/scene_formula.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// A default of the table of keys; they are numbers and sums that hold together.
double default_number(const std::string& text) {
  if (text == "inf") return std::numeric_limits<double>::infinity();
  const FormulaResult result = evaluate_formula(text, {});
  if (!result.problem.empty()) throw std::logic_error("scene key: default " + text + ": " + result.problem);
  return result.value;
}

Vec2<double> default_point(const std::string& text) {
  const std::size_t comma = text.find(',');
  return {default_number(text.substr(1, comma - 1)),
          default_number(text.substr(comma + 1, text.size() - comma - 2))};
}

}  // namespace

double scene_number(const SceneContext& context, const SceneValue& value, const std::string& path,
                    const std::string& rule) {
  if (value.kind == SceneValue::Kind::integer || value.kind == SceneValue::Kind::number) return value.number;
  std::string got = description(value);
  if (value.kind == SceneValue::Kind::text) {
    const FormulaResult result = evaluate_formula(value.text, context.numbers);
    if (result.problem.empty()) return result.value;
    got += ": " + result.problem;
  }
  refuse_scene(context.file, value.mark, fmt::format("{} must be {}, got {}", path, rule, got));
}

SceneTable::SceneTable(const SceneContext& context, const SceneValue& value, const std::string& kind,
                       const std::string& path)
    : context_(&context), value_(&value), kind_(&scene_table_kind(kind)), path_(path) {
  for (const SceneValue& member : value.items) check_member(member);
  check_required();
}

const SceneKey& SceneTable::known(const std::string& key) const {
  const SceneKey* found = find_scene_key(*kind_, key);
  if (!found) throw std::logic_error("SceneTable: " + kind_->name + " has no key " + key);
  return *found;
}

std::string SceneTable::path_of(const std::string& key) const {
  if (key.empty()) return path_;
  return path_.empty() ? excerpt(key) : path_ + "." + excerpt(key);
}

template <>
bool SceneTable::get(const std::string& key) const {
  const SceneValue* value = value_->find(key);
  return value ? value->number != 0 : known(key).fallback == "true";
}

template <>
double SceneTable::get(const std::string& key) const {
  const SceneValue* value = value_->find(key);
  const SceneKey& rules = known(key);
  return value ? scene_number(*context_, *value, path_of(key), rule_text(rules))
               : default_number(rules.fallback);
}

template <>
int SceneTable::get(const std::string& key) const {
  return static_cast<int>(get<double>(key));
}

template <>
std::string SceneTable::get(const std::string& key) const {
  const SceneValue* value = value_->find(key);
  const SceneKey& rules = known(key);
  if (!value) return rules.fallback;
  return rules.field.type == SceneType::word ? known_word(value->text, rules.field.words) : value->text;
}

template <>
Vec2<double> SceneTable::get(const std::string& key) const {
  const SceneValue* value = value_->find(key);
  const SceneKey& rules = known(key);
  if (!value) return default_point(rules.fallback);
  const std::string rule = rule_text(rules);
  return {scene_number(*context_, value->items[0], path_of(key), rule),
          scene_number(*context_, value->items[1], path_of(key), rule)};
}

template <>
List<Vec2<double>> SceneTable::get(const std::string& key) const {
  const std::string rule = rule_text(known(key));
  List<Vec2<double>> all;
  for (const SceneValue& item : value_->find(key)->items) {
    all.push_back({scene_number(*context_, item.items[0], path_of(key), rule),
                   scene_number(*context_, item.items[1], path_of(key), rule)});
  }
  return all;
}

List<SceneTable> SceneTable::tables(const std::string& key) const {
  const SceneValue* value = value_->find(key);
  const SceneKey& rules = known(key);
  List<SceneTable> all;
  if (!value) return all;
  if (rules.field.type == SceneType::table) return {SceneTable(*context_, *value, rules.range, path_of(key))};
  for (const SceneValue& item : value->items) {
    all.emplace_back(*context_, item, rules.range, fmt::format("{}[{}]", path_of(key), all.size() + 1));
  }
  return all;
}

void SceneTable::refuse(const std::string& key, const std::string& rule, const std::string& got) const {
  const SceneValue* value = value_->find(key);
  refuse_scene(context_->file, value ? value->mark : value_->mark,
               fmt::format("{} must be {}, got {}", path_of(key), rule, got));
}

void SceneTable::refuse(const std::string& key, const std::string& rule) const {
  const SceneValue* value = value_->find(key);
  refuse(key, rule, value ? description(*value) : "nothing");
}

void SceneTable::guard(const std::function<void()>& work) const {
  try {
    work();
  } catch (const SceneRefusal&) {
    throw;  // it has its place
  } catch (const std::invalid_argument& error) {
    refuse_as_key(error.what());
  }
}

void SceneTable::refuse_as_key(const std::string& message) const {
  const std::size_t place = message.find(": ");
  const bool names_class = std::isupper(static_cast<unsigned char>(message[0])) && place < message.find(' ');
  const std::string rest = names_class ? message.substr(place + 2) : message;
  const std::string key = rest.substr(0, rest.find(' '));
  const SceneValue* value = value_->find(key);
  const bool names_key = find_scene_key(*kind_, key) != nullptr;
  refuse_scene(context_->file, value ? value->mark : value_->mark,
               path_ + (names_key && !path_.empty() ? "." : ": ") + rest);
}

}  // namespace cairn
