// The table of keys: it is whole, its defaults are those of the engine, and its page is up to date.
#include "scenes/scene_schema.hpp"

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

#include "constraints/drag_joint.hpp"
#include "constraints/gear_joint.hpp"
#include "constraints/prismatic_joint.hpp"
#include "constraints/pulley_joint.hpp"
#include "constraints/revolute_joint.hpp"
#include "scenes/scene_file.hpp"
#include "scenes/scene_table.hpp"
#include "scenes/setting.hpp"
#include "world/scene.hpp"

using namespace cairn;

namespace {

std::string schema_file(const std::string& name) {
  std::ifstream stream(std::filesystem::path(CAIRN_SOURCE_DIR) / "lessons/scenes" / name);
  REQUIRE(stream.good());
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The value that a table has when the file says no more of it than it must.
double schema_default(const std::string& kind, const std::string& key) {
  const SceneContext context;
  SceneValue empty;
  SceneTable table(context, empty, kind, "");
  return table.number(key);
}

}  // namespace

TEST_CASE("the page on scenes is what the table of keys says today") {
  CHECK(schema_file("README.md") == scene_schema_page());
}

TEST_CASE("the scene of the five minutes is there, and says what the page says") {
  std::set<std::string> lines;
  std::istringstream scene(schema_file("tower-and-ball.toml"));
  for (std::string line; std::getline(scene, line);) lines.insert(line);
  std::istringstream page(scene_schema_page());
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
  CHECK(scene_schema_page().find("\n    " + message + "\n") != std::string::npos);
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
    const bool is_table = key.type == SceneType::table || key.type == SceneType::tables;
    if (is_table) CHECK_NOTHROW(scene_table_kind(key.range));
    if (key.type == SceneType::word) CHECK(scene_words(key).size() >= 2);
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

TEST_CASE("a range holds what it says") {
  const auto holds = [](const std::string& range, double value) {
    return in_range({.group = "", .key = "", .type = SceneType::number, .range = range}, value);
  };
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

TEST_CASE("the defaults of scene files are those of the engine: the scene, its steps and its ground") {
  const SceneSettings settings;
  CHECK(schema_default("step", "dt") == settings.dt);
  CHECK(read_scene_text("[[body]]\ncircle = 1\n", "my.toml").setting.substeps == 4);
  CHECK(schema_default("stabilization", "baumgarte") == settings.stabilization.baumgarte);
  CHECK(schema_default("stabilization", "frequency") == settings.stabilization.soft.frequency);
  CHECK(schema_default("stabilization", "damping_ratio") == settings.stabilization.soft.damping_ratio);
  const SwingSoftness& joints = settings.stabilization.joint_soft;
  CHECK(schema_default("stabilization", "joint_frequency") == joints.frequency);
  CHECK(schema_default("stabilization", "joint_damping_ratio") == joints.damping_ratio);
  CHECK(schema_default("sleeping", "speed") == Sleeping().speed);
  CHECK(schema_default("sleeping", "angular_speed") == Sleeping().angular_speed);
  CHECK(schema_default("sleeping", "time") == Sleeping().time);
  CHECK(schema_default("ground", "height") == GroundSpec().height);
  CHECK(schema_default("ground", "friction") == GroundSpec().friction);
  CHECK(schema_default("ground", "restitution") == GroundSpec().restitution);
}

TEST_CASE("the defaults of scene files are those of the engine: bodies") {
  const BodySpec body;
  CHECK(schema_default("body", "angle") == body.angle);
  CHECK(schema_default("body", "angular_velocity") == body.angular_velocity);
  CHECK(schema_default("body", "density") == body.density);
  CHECK(schema_default("body", "friction") == body.friction);
  CHECK(schema_default("body", "restitution") == body.restitution);
  CHECK(schema_default("body", "linear_damping") == body.linear_damping);
  CHECK(schema_default("body", "angular_damping") == body.angular_damping);
  CHECK(schema_default("body", "gravity_scale") == body.gravity_scale);
  CHECK(schema_default("body", "category") == body.category);
  CHECK(schema_default("body", "collides_with") == body.collides_with);
}

TEST_CASE("the defaults of scene files are those of the engine: joints and solvers") {
  const auto fallback = [](const std::string& group, const std::string& key) {
    for (const SceneKey& each : scene_keys()) {
      if (each.group == group && each.key == key) return std::stod(each.fallback);
    }
    return std::nan("");
  };
  CHECK(fallback("revolute", "limit_margin") == RevoluteJoint::Spec().limit_margin);
  CHECK(fallback("gear", "radius_a") == GearJoint::Spec().radius_a);
  CHECK(fallback("gear", "radius_b") == GearJoint::Spec().radius_b);
  CHECK(fallback("end", "parts") == PulleyJoint::End().parts);
  CHECK(fallback("drag", "max_force") == DragJoint::Spec().max_force);
  const Setting setting;
  CHECK(schema_default("recommended", "iterations") == setting.sweeps.iterations);
  CHECK(schema_default("recommended", "tolerance") == setting.sweeps.tolerance);
  CHECK(schema_default("recommended", "time_budget") == setting.sweeps.time_budget);
  CHECK(schema_default("recommended", "seed") == setting.sweeps.seed);
  CHECK(schema_default("recommended", "relaxation") == setting.sweeps.relaxation);
  CHECK(schema_default("recommended", "patience") == setting.sweeps.patience);
  CHECK(schema_default("recommended", "position_iterations") == setting.position_iterations);
}
