// Floor 8. From the text of a file to a scene.
#include <cairn/scenes/scene_file.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>

#include <cairn/math/check.hpp>
#include <cairn/math/printable.hpp>
#include <cairn/measure/fingerprint.hpp>
#include <cairn/scenes/scene_builder.hpp>
#include <cairn/scenes/scene_formula.hpp>
#include <cairn/scenes/scene_settings.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// [numbers], in order: each may use those before it. They hold for the whole file, wherever they stand.
std::map<std::string, double> numbers_of(const SceneContext& context, const SceneValue& file) {
  SceneContext known = context;
  const SceneValue* table = file.find("numbers");
  if (!table || table->kind != SceneValue::Kind::table) return {};
  for (const SceneValue& item : table->items) {
    const std::string path = "numbers." + excerpt(item.key);
    const bool is_word = evaluate_formula(item.key, {{item.key, 0}}).problem.empty();
    const bool is_free = evaluate_formula(item.key, {}).problem.compare(0, 12, "unknown word") == 0;
    if (!is_word || !is_free || item.key == "deg" || item.key == "rad") {
      refuse_scene(context.file, item.key_mark,
                   path + " must be a name of letters, digits and _ that sums do not have yet");
    }
    const std::string rule = "a finite number, or a sum of numbers above it";
    const double number = scene_number(known, item, path, rule);
    if (!std::isfinite(number)) {
      refuse_scene(context.file, item.mark, path + " must be " + rule + ", got " + description(item));
    }
    known.numbers[item.key] = number;
  }
  return known.numbers;
}

/// The kinds of tables that make bodies.
bool makes_bodies(const SceneTable& file, const std::string& key) {
  const SceneKey* found = find_scene_key(scene_table_kind(file.kind()), key);
  if (!found || found->field.type != SceneType::tables) return false;
  return key == "body" || scene_table_kind(key).build != nullptr;
}

/// One table of a list: which one of its kind, and what it says.
struct SceneItem {
  std::string kind = {};
  int number = 0;  // from 1
  const SceneValue* value = nullptr;
};

/// All tables that make bodies and joints, in the order of the file.
List<SceneItem> items_of(const SceneTable& file, const SceneValue& root) {
  List<SceneItem> items;
  for (const SceneValue& member : root.items) {
    if (member.key != "joint" && !makes_bodies(file, member.key)) continue;
    int number = 0;
    for (const SceneValue& item : member.items) {
      items.push_back({.kind = member.key, .number = ++number, .value = &item});
    }
  }
  std::stable_sort(items.begin(), items.end(), [](const SceneItem& a, const SceneItem& b) {
    return std::pair(a.value->mark.line, a.value->mark.column) <
           std::pair(b.value->mark.line, b.value->mark.column);
  });
  return items;
}

void build_items(SceneBuilder& builder, const SceneContext& context, const List<SceneItem>& items) {
  for (const SceneItem& item : items) {
    if (item.kind == "joint") {
      build_joint(builder, context, *item.value, item.number);
    } else {
      const std::string path = item.kind + "[" + std::to_string(item.number) + "]";
      build_bodies(builder, SceneTable(context, *item.value, item.kind, path), item.number);
    }
  }
  builder.finish();
}

/// For tables and names of files, whatever the name of the scene file has in it.
std::string stem_of(const std::string& file) {
  return excerpt(std::filesystem::path(file).stem().string(), 100);
}

}  // namespace

SceneEntry read_scene_text(const std::string& text, const std::string& file) {
  const SceneValue root = parse_toml(text, file);
  SceneContext context{.file = file};
  context.numbers = numbers_of(context, root);
  const SceneTable table(context, root, "scene", "");
  SceneBuilder builder(scene_settings_of(table));
  build_items(builder, context, items_of(table, root));
  for (const SceneTable& surface : table.tables("ground")) builder.add_ground(surface);
  build_acting(builder, table);
  read_contacts(builder, table);
  build_events(builder, table);

  SceneEntry entry;
  entry.name = stem_of(file);
  entry.title = entry.name;
  table.read(entry);
  entry.expectations = part_of<Expectations>(table, "expect").value_or(Expectations());
  entry.expectations.places = expected_places(builder, table);
  entry.setting = recommended_of(table, builder.scene());
  entry.camera = part_of<SceneCamera>(table, "camera");
  entry.body_names = builder.names().of_bodies();
  entry.joint_ids = builder.names().joint_ids();
  entry.make = [scene = builder.scene()] { return scene; };
  Fingerprint fingerprint;
  fingerprint.add(std::string_view(text));
  entry.fingerprint = fingerprint.value();
  return entry;
}

SceneEntry read_scene_file(const std::string& path) {
  std::ifstream stream;
  std::error_code ignored;  // opening what is no file could wait for ever
  if (std::filesystem::is_regular_file(path, ignored)) stream.open(path, std::ios::binary);
  require(stream.is_open(), "read_scene_file", "path", "a file that can be read", path);
  require_scene_size(std::filesystem::file_size(path), path);  // before it is read
  return read_scene_text({std::istreambuf_iterator<char>(stream), {}}, path);
}

List<SceneEntry> read_scene_folder(const std::string& folder) {
  require(std::filesystem::is_directory(folder), "read_scene_folder", "folder", "a folder", folder);
  List<SceneEntry> entries;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() == ".toml") entries.push_back(read_scene_file(file.path().string()));
  }
  require(!entries.empty(), "read_scene_folder", "folder", "one with scenes in files *.toml", folder);
  std::sort(entries.begin(), entries.end(), [](const SceneEntry& a, const SceneEntry& b) {
    return std::pair(a.order, a.name) < std::pair(b.order, b.name);
  });
  return entries;
}

}  // namespace cairn
