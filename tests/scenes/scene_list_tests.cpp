// Scenes by name, and what is expected of each.
#include <cairn/scenes/scene_list.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>

using namespace cairn;

TEST_CASE("there are at least 30 scenes, each with a name of its own and words that say what it is") {
  std::set<std::string> names;
  for (const SceneEntry& entry : scene_entries()) {
    CAPTURE(entry.name);
    CHECK(names.insert(entry.name).second);
    CHECK_FALSE(entry.title.empty());
    CHECK(entry.look.back() == '.');
    CHECK(entry.seconds > 0);
    check(entry.setting);
    CHECK(entry.body_names.size() == entry.make().bodies().size());
  }
  CHECK(names.size() >= 30);
}

TEST_CASE("an unknown scene is refused with the nearest name") {
  CHECK(scene_entry("arch").name == "arch");
  CHECK_THROWS_WITH_AS(scene_entry("dominos"),
                       "scene_entry: scene must be a known name (dominoes?), got dominos",
                       std::invalid_argument);
  CHECK_THROWS_AS(scene_entry("waterfall"), std::invalid_argument);
}

TEST_CASE("a scene can be asked for by the path of its file") {
  const std::string path = std::string(CAIRN_SOURCE_DIR) + "/lessons/scenes/arch.toml";
  CHECK(scene_entry(path).name == "arch");
  CHECK(scene_entry(path).title == scene_entry("arch").title);
  CHECK_THROWS_AS(scene_entry("./no-such-scene.toml"), std::invalid_argument);
}

TEST_CASE(
    "every file of a scene begins with a comment of one to three lines, and is no wider than the code") {
  const std::string folder = std::string(CAIRN_SOURCE_DIR) + "/lessons/scenes/";
  for (const SceneEntry& entry : scene_entries()) {
    CAPTURE(entry.name);
    std::ifstream stream(folder + entry.name + ".toml");
    int comment = 0, number = 0;
    for (std::string line; std::getline(stream, line); ++number) {
      if (line.rfind("# ", 0) == 0 && comment == number) ++comment;
      CHECK(line.size() <= 120);
    }
    CHECK(comment >= 1);
    CHECK(comment <= 3);
  }
}
