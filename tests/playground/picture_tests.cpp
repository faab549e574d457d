// The playground's picture through its C functions: what is drawn, and what is where on it.
#include <doctest/doctest.h>

#include <string>
#include <utility>

#include "lessons/playground/interface.h"

TEST_CASE("the picture is drawn at each size, and what is drawn is found again") {
  REQUIRE(cairn_open("[ground]\nhalf_width = 8\n[[stack]]\nn = 2\nbox = [1, 1]\n", "scene") == 1);
  REQUIRE(cairn_step(1) == 1);
  for (const auto& [width, height] : {std::pair(1280, 720), std::pair(390, 700), std::pair(640, 360)}) {
    REQUIRE(cairn_resize(width, height, 1) == 1);
    REQUIRE(cairn_draw() == 1);
    const double *place = cairn_place(0, 1.5), x = place[0], y = place[1];
    const double* spot = cairn_at(x, y);
    CHECK(spot[0] == 1);
    CHECK(spot[1] == 2);
    CHECK(spot[2] == doctest::Approx(0).epsilon(1e-9));
    CHECK(spot[3] == doctest::Approx(1.5));
  }
  CHECK(cairn_resize(100, 100, 1) == 0);
  CHECK(std::string(cairn_refusal()).find("at least") != std::string::npos);
  CHECK(cairn_theme("dark") == 1);
  CHECK(cairn_theme("drak") == 0);
  CHECK(cairn_draw() == 1);
}

TEST_CASE("walls stand along the border of what is seen, also of a part of the scene") {
  REQUIRE(cairn_open("[ground]\nhalf_width = 8\n[[stack]]\nn = 2\nbox = [1, 1]\n", "scene") == 1);
  REQUIRE(cairn_resize(1280, 720, 1) == 1);
  REQUIRE(cairn_draw() == 1);
  REQUIRE(cairn_zoom(0.25, 300, 200) == 1);
  REQUIRE(cairn_draw() == 1);
  const auto kind = [](double x, double y) { return cairn_at(x, y)[0]; };
  double left = 0, right = 1280;  // [px] of the scene, at that height
  while (kind(left, 60) != 1) ++left;
  while (kind(right, 60) != 1) --right;
  CHECK(cairn_at(left + 1, 60)[1] == -1);
  REQUIRE(cairn_add_walls() == 1);
  REQUIRE(cairn_draw() == 1);
  for (const double x : {left + 1, right - 1}) CHECK(cairn_at(x, 60)[1] == 3);
  for (const double share : {0.1, 0.9}) CHECK(cairn_at(left + share * (right - left), 60)[1] == -1);
}

TEST_CASE("bodies that cannot move are found where no other is, and the ground nowhere") {
  const char* const text = R"(camera = { center = [0, 2], height = 9 }

[ground]
half_width = 8

[[body]]
name = "shelf"
type = "static"
box = [4, 1]
position = [0, 2]

[[body]]
name = "crate"
box = [1, 1]
position = [0, 3]

[[body]]
name = "wire"
type = "static"
chain = [[-6, 1], [-4, 2], [-3, 2]]
)";
  REQUIRE(cairn_open(text, "scene") == 1);
  REQUIRE(cairn_resize(1280, 720, 1) == 1);
  REQUIRE(cairn_draw() == 1);
  const auto found = [](double x, double y) {
    const double* place = cairn_place(x, y);
    const double place_x = place[0], place_y = place[1];
    return static_cast<int>(cairn_at(place_x, place_y)[1]);
  };
  CHECK(found(1.5, 2) == 1);
  CHECK(found(0, 3) == 2);
  CHECK(found(-5, 1.5) == 3);
  CHECK(found(-3.5, 2) == 3);
  CHECK(found(0, 0.8) == -1);
  CHECK(found(0, -0.5) == -1);
  CHECK(cairn_grab(1.5, 2) == 0);
  CHECK(cairn_remove(1) == 1);
  CHECK(found(1.5, 2) == -1);
}

TEST_CASE("a picture comes nearer around a place, moves with it, and shows all of the next scene") {
  const char* const text = "[ground]\nhalf_width = 8\n[[stack]]\nn = 2\nbox = [1, 1]\n";
  REQUIRE(cairn_open(text, "scene") == 1);
  REQUIRE(cairn_resize(1280, 720, 1) == 1);
  REQUIRE(cairn_draw() == 1);
  const auto place = [](double x, double y) {
    const double* found = cairn_place(x, y);
    return std::pair(found[0], found[1]);
  };
  const auto [x, y] = place(1, 1);
  const double scale = place(2, 1).first - x;  // [px/m]
  REQUIRE(cairn_zoom(3, x, y) == 1);
  REQUIRE(cairn_pan(10, -20) == 1);
  REQUIRE(cairn_draw() == 1);
  CHECK(place(1, 1).first == doctest::Approx(x + 10));
  CHECK(place(1, 1).second == doctest::Approx(y - 20));
  CHECK(place(2, 1).first - place(1, 1).first == doctest::Approx(3 * scale));
  CHECK(cairn_zoom(0, x, y) == 0);
  REQUIRE(cairn_open(text, "scene") == 1);
  REQUIRE(cairn_draw() == 1);
  CHECK(place(1, 1) == std::pair(x, y));
}
