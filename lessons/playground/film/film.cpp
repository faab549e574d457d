// cairn_playground_film THEME FILE: the playground as a short animated PNG, for the README. A stack without
// friction is solved row by row, then sweep by sweep; then it runs, and a hand pulls its uppermost box aside.
#include <cstdio>
#include <exception>
#include <string>

#include "lessons/playground/picture.hpp"
#include "render/sequence.hpp"

namespace {

using namespace cairn::playground;

const char* const scene = R"(title = "the playground: three boxes, row by row"
camera = { center = [0, 1.7], height = 4.6 }

[ground]
half_width = 3

[[stack]]
name = "box"
n = 3
box = [1, 1]
)";

constexpr int width = 720, height = 420;
constexpr double frames_per_second = 6;
constexpr int rows = 6, sweeps = 6, steps = 16, still = 6;  // frames

class Film {
 public:
  Film(const std::string& theme, const std::string& file)
      : film_(file, rows + sweeps + steps + 2 * still, frames_per_second) {
    picture_.resize(width, height, 1);
    picture_.choose_theme(theme);
    playground_.open(scene, "film");
    for (const auto& [name, value] : {std::pair("warm", "off"), std::pair("sweeps", "7")})
      playground_.set(name, value);
    playground_.set("friction", "0");
  }

  void draw() {
    for (int i = 0; i < rows; ++i) {
      playground_.advance_rows(1);
      add(1);
    }
    for (int i = 0; i < sweeps; ++i) {
      playground_.advance_sweep();
      add(i + 1 < sweeps ? 1 : 1 + still);
    }
    playground_.open(scene, "film");
    playground_.step(1);
    playground_.grab({0.2, 2.6}, 0);
    for (int i = 0; i < steps; ++i) {
      playground_.drag({0.2 + 0.1 * i, 2.6 + 0.02 * i});
      playground_.step(3);
      add(i + 1 < steps ? 1 : 1 + still);
    }
    film_.finish();
  }

 private:
  void add(int times) {
    picture_.draw(playground_);
    for (int i = 0; i < times; ++i) film_.add(picture_.page().canvas().read());
  }

  Playground playground_;
  Picture picture_;
  cairn::render::ApngWriter film_;
};

}  // namespace

int main(int count, char** words) {
  if (count != 3) {
    std::fprintf(stderr, "cairn_playground_film THEME FILE\n");
    return 2;
  }
  try {
    Film(words[1], words[2]).draw();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cairn_playground_film: %s\n", error.what());
    return 3;
  }
}
