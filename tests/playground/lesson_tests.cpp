// What the lessons say of the playground: their links open it, and the numbers beside them are those that it
// shows.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

#include <cairn/math/list.hpp>
#include "lessons/playground/interface.h"

namespace {

namespace fs = std::filesystem;
using cairn::List;

std::string text_of(const fs::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// Opens what a link's title asks for, such as "#scene=stack&sweeps=10".
void follow(const std::string& address) {
  REQUIRE(cairn_patience(0) == 1);  // however slow this machine is
  std::istringstream words(address.substr(1));
  for (std::string word; std::getline(words, word, '&');) {
    const std::string name = word.substr(0, word.find('=')), value = word.substr(word.find('=') + 1);
    CAPTURE(word);
    if (name == "scene") {
      const fs::path file = fs::path(CAIRN_SOURCE_DIR) / "lessons" / "scenes" / (value + ".toml");
      REQUIRE(cairn_open(text_of(file).c_str(), value.c_str()) == 1);
      REQUIRE(cairn_set("other", "none") == 1);
    } else {
      REQUIRE(cairn_set(name.c_str(), value.c_str()) == 1);
    }
  }
}

/// The address that a lesson leads to; "" where it has none.
std::string address_of(const fs::path& readme) {
  static const std::regex link(R"re(\.\./playground/README\.md "(#[^"]*)")re");
  const std::string text = text_of(readme);
  std::smatch found;
  return std::regex_search(text, found, link) ? found[1].str() : "";
}

void follow_lesson(int number) {
  char name[4];
  std::snprintf(name, sizeof name, "%02d_", number);
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(CAIRN_SOURCE_DIR) / "lessons")) {
    if (entry.path().filename().string().rfind(name, 0) == 0)
      return follow(address_of(entry.path() / "README.md"));
  }
}

double lambda(int row) { return cairn_rows()[6 * row]; }
double end_of(int row) { return cairn_rows()[6 * row + 1]; }
/// One of x, y, angle of a body; the last body: -1.
double place(int body, int which) {
  const int count = cairn_body_count();
  return cairn_bodies()[8 * (body < 0 ? count + body : body) + which];
}
double sunk(double height) { return 1000 * (height - place(-1, 1)); }  // [mm] of the uppermost box

/// [mm] How far the lower pin of the double pendulum is open.
double pin_gap() {
  const double upper = place(1, 2), lower = place(2, 2);
  return 1000 * std::hypot(place(1, 0) + std::cos(upper) - place(2, 0) - std::sin(lower),
                           place(1, 1) + std::sin(upper) - place(2, 1) + std::cos(lower));
}

}  // namespace

TEST_CASE("every lesson that leads to the playground leads to a scene and settings that there are") {
  int links = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(CAIRN_SOURCE_DIR) / "lessons")) {
    const std::string address = address_of(entry.path() / "README.md");
    if (address.empty()) continue;
    CAPTURE(entry.path().string());
    follow(address);
    CHECK(cairn_step(3) == 1);
    ++links;
  }
  CHECK(links >= 12);
}

// The tolerances are half of the last place that the lessons print.
TEST_CASE("the playground shows the numbers that the lessons name") {
  follow_lesson(9);
  cairn_step(120);
  CHECK(std::abs(pin_gap() - 173) < 0.5);
  follow_lesson(9);
  cairn_set("policy", "baumgarte");
  double widest = 0;
  int when = 0;
  for (int step = 1; step <= 120; ++step) {
    cairn_step(1);
    if (pin_gap() > widest) when = step;
    widest = std::max(widest, pin_gap());
  }
  CHECK(std::abs(pin_gap() - 4) < 0.5);
  CHECK(std::abs(widest - 57) < 0.5);
  CHECK(std::abs(when / 60.0 - 0.93) < 0.01);
  follow_lesson(6);
  const double first[] = {14.2, 16.9, 0.13, 0.52};  // both points of the lowest contact, and of the uppermost
  for (int i = 0; i < 4; ++i) CHECK(std::abs(lambda(i < 2 ? i : 16 + i) - first[i]) < (i < 2 ? 0.05 : 0.005));
  CHECK(std::abs(lambda(0) + lambda(1) - 31) < 0.5);
  CHECK(std::abs(lambda(18) + lambda(19) - 0.65) < 0.005);
  CHECK(std::abs(end_of(0) - 50) < 0.5);
  cairn_set("sweeps", "100");
  CHECK(std::abs(lambda(0) + lambda(1) - 89) < 0.5);
  CHECK(std::abs(lambda(18) + lambda(19) - 8.4) < 0.05);
  follow_lesson(3);
  cairn_row(1);
  CHECK(std::abs(lambda(0) - 4) < 1e-9);
  follow_lesson(4);
  const double given[] = {34.4, 43.3, 40.6}, kept[] = {34, 42.6, 40};
  for (int i = 0; i < 3; ++i) {
    CHECK(std::abs(lambda(2 * i) - given[i]) < 0.05);
    CHECK(std::abs(end_of(2 * i) - kept[i]) < 0.05);
  }
  follow_lesson(8);
  cairn_step(120);
  CHECK(std::abs(sunk(9.5) - 140) < 5);
  cairn_set("warm", "on");
  cairn_restart();
  cairn_step(120);
  CHECK(std::abs(sunk(9.5) - 15) < 0.5);
}

TEST_CASE("the playground shows what the later lessons say") {
  follow_lesson(11);
  const double start = place(-1, 0);
  cairn_step(60);
  CHECK(place(-1, 0) < start - 0.1);
  cairn_set("friction", "0.4");
  cairn_restart();
  cairn_step(60);
  CHECK(std::abs(place(-1, 0) - start) < 1e-3);
  follow_lesson(12);
  cairn_step(60);
  CHECK(place(-1, 1) < -1);
  cairn_set("solver", "block");
  cairn_restart();
  cairn_step(60);
  CHECK(place(-1, 1) < -1);
  follow_lesson(13);
  cairn_step(120);
  CHECK(std::abs(sunk(9.5) - 137) < 0.5);
  cairn_set("policy", "baumgarte");
  cairn_restart();
  cairn_step(120);
  CHECK(std::abs(sunk(9.5) - 15) < 0.5);
  follow_lesson(16);
  cairn_step(2);
  CHECK(std::abs(cairn_bodies()[8 * (cairn_body_count() - 1) + 4] - 1232) < 0.5);
  cairn_set("solver", "jacobi-split");
  cairn_restart();
  cairn_step(60);
  CHECK(std::abs(sunk(9.5) - 35) < 0.5);
  follow_lesson(19);
  cairn_set("mass-ratio", "10");
  cairn_step(30);
  CHECK(std::abs(place(-1, 1) - 0.8) < 0.02);
}
