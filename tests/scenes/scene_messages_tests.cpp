// What a scene file with a mistake is answered.
#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>

#include <cairn/math/list.hpp>
#include <cairn/scenes/scene_file.hpp>
#include <cairn/scenes/solver_list.hpp>

using namespace cairn;

namespace {

struct SceneMistake {
  std::string mistake = {};
  std::string text = {};
  std::string message = {};
};

std::string text_beside(const std::string& name) {
  std::ifstream file(CAIRN_SOURCE_DIR "/tests/scenes/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Of scenes.wrong: what is wrong behind "= ", the message behind "> ", then the scene, up to an empty line.
/// It may go on behind that of another file, "+ ".
List<SceneMistake> scene_mistakes() {
  std::istringstream file(text_beside("scenes.wrong"));
  List<SceneMistake> mistakes;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("= ")) {
      mistakes.push_back({.mistake = line.substr(2)});
    } else if (line.starts_with("> ")) {
      mistakes.back().message = line.substr(2);
    } else if (line.starts_with("+ ")) {
      mistakes.back().text = text_beside(line.substr(2));
    } else if (!line.empty()) {
      mistakes.back().text += line + "\n";
    }
  }
  return mistakes;
}

}  // namespace

TEST_CASE("a mistake in a scene file is told with its place, its field and its rule") {
  const List<SceneMistake> mistakes = scene_mistakes();
  CHECK(mistakes.size() >= 99);
  for (const SceneMistake& each : mistakes) {
    CAPTURE(each.mistake);
    CHECK_THROWS_WITH_AS(read_scene_text(each.text, "my.toml"), each.message.c_str(), std::invalid_argument);
  }
}

TEST_CASE("an unknown solver that is like none is answered with all of them") {
  std::string message;
  try {
    read_scene_text("[recommended]\nsolver = \"magic\"\n", "my.toml");
  } catch (const std::invalid_argument& error) {
    message = error.what();
  }
  CHECK(message.find("my.toml:2:10: recommended.solver must be the name of a solver: box2d, ") == 0);
  for (const SolverEntry& solver : solver_entries()) {
    CHECK(message.find(", " + solver.name + ", ") != std::string::npos);
  }
  CHECK(message.find(", got \"magic\"") != std::string::npos);
}

TEST_CASE("no message is longer than a few lines, however long a key, a text or a word of the file is") {
  const std::string huge(900000, 'k');
  for (const std::string& text :
       {huge + " = 1\n", "[ground]\n" + huge + " = 1\n", "seconds = \"" + huge + "\"\n",
        "title = \"" + huge + "\"\n", "seconds = \"2 " + huge + "\"\n", "[numbers]\n" + huge + " = true\n",
        "x = " + huge + "\n", huge.substr(0, 400000) + " = 1\n" + huge.substr(0, 400000) + " = 1\n",
        "[[body]]\ncircle = 1\n[[joint]]\ntype = \"weld\"\nb = \"" + huge + "\"\n"}) {
    std::string message;
    try {
      read_scene_text(text, "my.toml");
    } catch (const std::invalid_argument& error) {
      message = error.what();
    }
    CAPTURE(text.substr(0, 40));
    CHECK_FALSE(message.empty());
    CHECK(message.size() <= 500);
  }
}

TEST_CASE("what is no TOML is told with its line and column") {
  const List<SceneMistake> mistakes = {
      {"a word without quotes", "title = stack\n",
       "my.toml:1:9: the text must be TOML: a value must be a number, a list, or a text in quotes"},
      {"a bracket that is not closed", "[[body]]\nbox = [1, 1\nposition = [0, 1]\n",
       "my.toml:3:1: the text must be TOML: "},
      {"a key twice", "[[body]]\ncircle = 1\ncircle = 2\n", "my.toml:3:10: the text must be TOML: "},
      {"a text that goes on", "title = \"one\ntwo\"\n",
       "my.toml:1:13: the text must be TOML: a text must end on its line, and have no control characters"},
      {"a number too large", "seconds = 1e309\n",
       "my.toml:1:16: the text must be TOML: '1e309' is a number too large"},
      {"a key without a value", "seconds =\n", "my.toml:1:10: the text must be TOML: "},
      {"a heading that is not closed", "[ground\nheight = 1\n", "my.toml:1:8: the text must be TOML: "},
      {"letters that are none", "title = \"\xff\"\n", "my.toml:1:9: the text must be TOML: "},
  };
  for (const SceneMistake& each : mistakes) {
    CAPTURE(each.mistake);
    std::string message;
    try {
      read_scene_text(each.text, "my.toml");
    } catch (const std::invalid_argument& error) {
      message = error.what();
    }
    // Releases of toml++ differ in the words behind it.
    CHECK(message.substr(0, each.message.size()) == each.message);
  }
}

TEST_CASE("keys and lists that go deeper than any scene are refused before they go too deep") {
  std::string key = "a";
  for (int i = 0; i < 300000; ++i) key += ".a";
  const char* dots = "my.toml:1:83: a key must have at most 40 dots";
  CHECK_THROWS_WITH_AS(read_scene_text("[" + key + "]\n", "my.toml"), dots, std::invalid_argument);
  const std::string lists = "x = " + std::string(100, '[') + std::string(100, ']') + "\n";
  CHECK_THROWS_WITH_AS(read_scene_text(lists, "my.toml"),
                       "my.toml:1:45: the text must have at most 40 tables and lists in each other",
                       std::invalid_argument);
  CHECK_NOTHROW(read_scene_text("# " + std::string(200, '.') + "\n", "my.toml"));
}
