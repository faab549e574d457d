// Floor 8. The end of the page on scene files: every table and every key.
#include <fmt/format.h>

#include <cairn/scenes/scene_schema.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

std::string scene_default_text(const SceneKey& key) {
  if (key.fallback.empty()) return "";
  if (key.fallback == "required") return "**required**";
  if (!has_default(key)) {
    std::string words = key.fallback;
    words[0] = static_cast<char>(words[0] - 'A' + 'a');
    return words;
  }
  const bool is_text = key.field.type == SceneType::word || key.field.type == SceneType::text;
  const bool is_sum = key.fallback.find('/') != std::string::npos;
  return is_text || is_sum ? "`\"" + key.fallback + "\"`" : "`" + key.fallback + "`";
}

std::string scene_type_text(const SceneKey& key) {
  switch (key.field.type) {
    case SceneType::word: {
      std::string text;
      for (const std::string& word : key.field.words) text += (text.empty() ? "`" : ", `") + word + "`";
      return text;
    }
    case SceneType::text:
      return "text";
    case SceneType::flag:
      return "`true`, `false`";
    case SceneType::integer:
      return "whole number " + key.range;
    case SceneType::number:
      return key.range.empty() ? "number" : "number " + key.range;
    case SceneType::point:
      return key.range.empty() ? "[x, y]" : "[x, y] " + key.range;
    case SceneType::points:
      return "[[x, y], ...]";
    case SceneType::table:
      return "table";
    case SceneType::tables:
      break;
  }
  return "tables";
}

/// The keys of some groups as a table.
std::string scene_key_rows(const List<std::string>& groups) {
  std::string text = "| key | value | unit | default | meaning |\n|---|---|---|---|---|\n";
  for (const std::string& group : groups) {
    for (const SceneKey& key : scene_keys()) {
      if (key.group != group) continue;
      text += fmt::format("| `{}` | {} | {} | {} | {} |\n", key.key, scene_type_text(key), key.unit,
                          scene_default_text(key), key.meaning);
    }
  }
  return text + "\n";
}

/// Groups that many tables share are listed once, under a heading of their own.
struct SharedGroup {
  std::string name = {};
  std::string title = {};
};

const List<SharedGroup>& shared_scene_groups() {
  static const List<SharedGroup> groups = {
      {"repeat", "Name"}, {"shape", "Shape"}, {"matter", "Matter"}, {"motion", "Motion"},
      {"joint", "Joint"}, {"pair", "Pair"},   {"anchor", "Anchor"}, {"distance", "Distance"},
      {"slack", "Slack"}, {"soft", "Soft"},   {"give", "Give"},     {"strength", "Strength"},
      {"pace", "Pace"}, {"lasting", "Lasting"}};
  return groups;
}

/// The heading of a group as GitHub links to it.
std::string scene_link(const std::string& title) {
  std::string anchor = title;
  anchor[0] = static_cast<char>(anchor[0] - 'A' + 'a');
  return fmt::format("[{}](#{})", title, anchor);
}

std::string scene_kind_text(const SceneTableKind& kind) {
  std::string text = fmt::format(
      "### {}\n\n{}\n", kind.name == "scene" ? "The file itself" : "`" + kind.heading + "`", kind.meaning);
  std::string shared;
  List<std::string> own;
  for (const std::string& group : kind.groups) {
    std::string title;
    for (const SharedGroup& each : shared_scene_groups()) {
      if (each.name == group) title = each.title;
    }
    if (title.empty()) {
      own.push_back(group);
    } else {
      shared += (shared.empty() ? "" : ", ") + scene_link(title);
    }
  }
  if (!shared.empty()) text += fmt::format("It has the keys of {}{}\n", shared, own.empty() ? "." : ", and:");
  text += "\n";
  return own.empty() ? text : text + scene_key_rows(own);
}

}  // namespace

std::string scene_schema_page() {
  std::string text = "## Every table\n\n";
  for (const SceneTableKind& kind : scene_table_kinds()) {
    if (kind.name != "joint") text += scene_kind_text(kind);
  }
  text += "## Keys that many tables have\n\n";
  for (const SharedGroup& group : shared_scene_groups()) {
    text += "### " + group.title + "\n\n" + scene_key_rows({group.name});
  }
  while (text.size() > 1 && text[text.size() - 2] == '\n') text.pop_back();
  return text;
}

}  // namespace cairn
