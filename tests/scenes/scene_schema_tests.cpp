// The table of keys: it is whole, and its page is up to date.
#include <cairn/scenes/scene_schema.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

#include <cairn/scenes/scene_file.hpp>
#include <cairn/scenes/scene_formula.hpp>
#include <cairn/scenes/setting.hpp>
#include <cairn/world/scene.hpp>

using namespace cairn;

namespace {

std::string schema_file(const std::string& name) {
  std::ifstream stream(std::filesystem::path(CAIRN_SOURCE_DIR) / "lessons/scenes" / name);
  REQUIRE(stream.good());
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

TEST_CASE("the page on scenes is what the table of keys says today") {
  const std::string page = schema_file("REFERENCE.md");
  const std::string wanted = page.substr(0, page.find("## Every table\n")) + scene_schema_page();
  if (page == wanted) return;
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "scenes_REFERENCE.md";
  std::ofstream(file) << wanted;
  FAIL_CHECK("lessons/scenes/REFERENCE.md is to be as " << file.string() << ", which was written now");
}

TEST_CASE("the scene of the five minutes is there, and says what the page says") {
  std::set<std::string> lines;
  std::istringstream scene(schema_file("tower-and-ball.toml"));
  for (std::string line; std::getline(scene, line);) lines.insert(line);
  std::istringstream page(schema_file("README.md"));
  bool is_scene = false;
  int quoted = 0;
  for (std::string line; std::getline(page, line) && line != "## Numbers";) {
    if (line.rfind("```", 0) == 0) {
      is_scene = line == "```toml";
    } else if (is_scene) {
      CAPTURE(line);
      CHECK(lines.count(line) == 1);
      ++quoted;
    }
  }
  CHECK(quoted > 20);
}

TEST_CASE("the mistake on the page is answered as the page says") {
  std::string text = schema_file("tower-and-ball.toml");
  text.replace(text.find("density"), 7, "densty");
  std::string message;
  try {
    read_scene_text(text, "tower-and-ball.toml");
  } catch (const std::invalid_argument& error) {
    message = error.what();
  }
  CHECK(message.size() > 50);
  CHECK(schema_file("README.md").find("\n    " + message + "\n") != std::string::npos);
}

TEST_CASE("every key belongs to a table, is explained, and stands once in each table that has it") {
  std::set<std::string> groups;
  for (const SceneTableKind& kind : scene_table_kinds()) {
    CAPTURE(kind.name);
    CHECK_FALSE(kind.meaning.empty());
    groups.insert(kind.groups.begin(), kind.groups.end());
    std::set<std::string> keys;
    for (const SceneKey* key : keys_of(kind)) CHECK_MESSAGE(keys.insert(key->key).second, key->key);
    CHECK((keys.empty()) == (kind.name == "numbers"));
  }
  for (const SceneKey& key : scene_keys()) {
    CAPTURE(key.group);
    CAPTURE(key.key);
    CHECK(groups.count(key.group) == 1);
    CHECK_FALSE(key.meaning.empty());
    const bool is_table = key.field.type == SceneType::table || key.field.type == SceneType::tables;
    if (is_table) CHECK_NOTHROW(scene_table_kind(key.range));
    if (key.field.type == SceneType::word) CHECK(key.field.words.size() >= 2);
    CHECK(key.meaning.find('|') == std::string::npos);  // it would end a cell of the page
  }
}

TEST_CASE("a scene file may ask for as many sweeps and substeps as a flag") {
  const SceneKey* const sweeps = find_scene_key(scene_table_kind("recommended"), "iterations");
  REQUIRE(sweeps != nullptr);
  CHECK(in_range(*sweeps, Setting::most_sweeps));
  CHECK_FALSE(in_range(*sweeps, Setting::most_sweeps + 1));
  const SceneKey* const substeps = find_scene_key(scene_table_kind("step"), "substeps");
  REQUIRE(substeps != nullptr);
  CHECK(in_range(*substeps, SceneSettings::most_substeps));
  CHECK_FALSE(in_range(*substeps, SceneSettings::most_substeps + 1));
}

TEST_CASE("a default that a row writes out is that of the member") {
  int written = 0;
  for (const SceneKey& key : scene_keys()) {
    if (key.field.readers.empty() || !has_default(key) || key.fallback == key.field.usual) continue;
    CAPTURE(key.key);
    CHECK(evaluate_formula(key.fallback, {}).value == evaluate_formula(key.field.usual, {}).value);
    ++written;
  }
  CHECK(written == 1);  // dt, as 1 / 60
}

TEST_CASE("a range holds what it says") {
  const auto holds = [](const std::string& range, double value) { return in_range({.range = range}, value); };
  CHECK(holds("> 0", 1e-300));
  CHECK_FALSE(holds("> 0", 0));
  CHECK(holds(">= 0", 0));
  CHECK_FALSE(holds(">= 0", -1e-300));
  CHECK(holds("from 0 to 1", 1));
  CHECK_FALSE(holds("from 0 to 1", 1.0000001));
  CHECK(holds("", -5));
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK_FALSE(holds("> 0", infinite));
  CHECK(holds("> 0 or inf", infinite));
  CHECK_FALSE(holds("> 0 or inf", -infinite));
  CHECK_FALSE(holds("", std::numeric_limits<double>::quiet_NaN()));
}
