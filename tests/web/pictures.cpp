// cairn_web_pictures FOLDER: draws the playground here, for the browser's pictures to be held against. It
// prints for each: file, width, height, scale, theme, steps, row updates, and the path of the scene.
#include <cstdio>
#include <exception>
#include <fstream>
#include <sstream>
#include <string>

#include "lessons/playground/picture.hpp"
#include "render/image.hpp"

namespace {

using namespace cairn::playground;

struct Case {
  const char* scene = "";
  const char* theme = "light";
  int width = 0;
  int height = 0;
  int scale = 1;
  int steps = 0;
  int rows = 0;
};

constexpr Case cases[] = {{"stack", "light", 1280, 720, 1, 30, 3},
                          {"pyramid", "dark", 820, 600, 1, 20, 0},
                          {"bridge", "light", 390, 700, 2, 30, 5},
                          {"silo", "dark", 1280, 720, 1, 60, 0}};

void draw(const Case& one, const std::string& folder) {
  const std::string scene = std::string(CAIRN_SOURCE_DIR) + "/lessons/scenes/" + one.scene + ".toml";
  std::stringstream text;
  text << std::ifstream(scene).rdbuf();
  Playground playground;
  playground.open(text.str(), one.scene);
  playground.step(one.steps);
  if (one.rows > 0) playground.advance_rows(one.rows);
  Picture picture;
  picture.resize(one.width, one.height, one.scale);
  picture.choose_theme(one.theme);
  picture.draw(playground);
  const std::string file = folder + "/" + one.scene + ".png";
  cairn::render::write_png(file, picture.page().canvas().read());
  std::printf("%s %d %d %d %s %d %d %s\n", file.c_str(), one.width, one.height, one.scale, one.theme,
              one.steps, one.rows, scene.c_str());
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "cairn_web_pictures FOLDER\n");
    return 2;
  }
  try {
    for (const Case& one : cases) draw(one, words[1]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cairn_web_pictures: %s\n", error.what());
    return 1;
  }
}
