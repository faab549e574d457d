// What changes while a scene runs: gravity, friction, bounce and mass; balls and ropes; and the floor below.
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include <cairn/measure/fingerprint.hpp>
#include "lessons/playground/interface.h"
#include "playground/crates.hpp"
#include "lessons/playground/playground.hpp"
#include <cairn/scenes/scene_list.hpp>

namespace {

const std::string falling_ball = R"(title = "a ball that falls"
[ground]
half_width = 8
[[body]]
name = "ball"
circle = 0.5
position = [0, 40]
[recommended]
substeps = 1
)";

void begin_with(const std::string& text) {
  REQUIRE(cairn_patience(0) == 1);
  REQUIRE(cairn_open(text.c_str(), "scene") == 1);
  REQUIRE(cairn_set("other", "none") == 1);
}

double of_body(int body, int place) { return cairn_bodies()[8 * body + place]; }
int steps() { return static_cast<int>(cairn_numbers()[1]); }

/// What the normal rows on the ground carry [N] in the solve that comes next.
double weight() {
  const double* rows = cairn_rows();
  double sum = 0;
  for (int i = 0; i < cairn_row_count(); ++i)
    if (rows[6 * i + 3] == 1 && rows[6 * i + 4] == 0) sum += rows[6 * i];
  return sum;
}

}  // namespace

TEST_CASE("gravity changes in flight: a speed grows by g dt a step, and no more without g") {
  begin_with(falling_ball);
  REQUIRE(cairn_step(30) == 1);
  CHECK(of_body(1, 4) == doctest::Approx(-10 * 30 / 60.0));
  REQUIRE(cairn_set("gravity", "0") == 1);
  CHECK(std::string(cairn_words()) == "Gravity: 0 m/s².");
  CHECK(steps() == 30);
  REQUIRE(cairn_step(30) == 1);
  CHECK(of_body(1, 4) == doctest::Approx(-5));
  REQUIRE(cairn_set("gravity", "20") == 1);
  REQUIRE(cairn_step(30) == 1);
  CHECK(of_body(1, 4) == doctest::Approx(-15));
  REQUIRE(cairn_restart() == 1);
  REQUIRE(cairn_step(1) == 1);
  CHECK(of_body(1, 4) == doctest::Approx(-20 / 60.0));
  CHECK(cairn_set("gravity", "-1") == 0);
}

TEST_CASE(
    "friction, bounce, mass and a second solver change without a restart, and contacts keep their impulses") {
  begin_with(two_crates);
  REQUIRE(cairn_step(120) == 1);
  REQUIRE(cairn_set("sweeps", "0") == 1);  // so that the next solve is its warm start
  CHECK(weight() == doctest::Approx(20).epsilon(0.02));
  for (const auto& [name, value] : {std::pair("friction", "0.1"), std::pair("bounce", "0.4"),
                                    std::pair("mass-ratio", "3"), std::pair("other", "newton")}) {
    CAPTURE(name);
    REQUIRE(cairn_set(name, value) == 1);
    CHECK(steps() == 120);
    CHECK(weight() == doctest::Approx(20).epsilon(0.02));
  }
  CHECK(of_body(2, 6) == 3);
  REQUIRE(cairn_set("sweeps", "60") == 1);
  REQUIRE(cairn_step(60) == 1);
  CHECK(weight() == doctest::Approx(40).epsilon(0.02));
  for (int i = 0; i < 60; ++i) REQUIRE(cairn_back() == 1);
  REQUIRE(cairn_set("other", "none") == 1);
}

TEST_CASE("a ball that is given a bounce of 1 in flight leaves the ground as fast as it came") {
  begin_with(falling_ball);
  REQUIRE(cairn_step(60) == 1);
  REQUIRE(cairn_set("bounce", "1") == 1);
  double fastest = 0, upwards = 0;
  for (int i = 0; i < 240; ++i) {
    REQUIRE(cairn_step(1) == 1);
    fastest = std::min(fastest, of_body(1, 4));
    upwards = std::max(upwards, of_body(1, 4));
  }
  CHECK(fastest < -25);
  CHECK(upwards == doctest::Approx(-fastest).epsilon(0.02));
}

TEST_CASE("balls and ropes are added, hold, and stand in the text") {
  begin_with(two_crates);
  REQUIRE(cairn_add_ball(3, 2, 0.5) == 1);
  CHECK(std::string(cairn_body_name(3)) == "ball-1");
  REQUIRE(cairn_add_rope(0, 3, 4, 3, 3, 2) == 1);
  CHECK(cairn_body_count() == 4 + 5);  // links of 0.4 m
  CHECK(std::string(cairn_body_name(4)) == "rope-1.1");
  CHECK(std::string(cairn_words()) == "A rope more: rope-1.");
  const std::string text = cairn_scene_text();
  const std::string print = cairn_fingerprint();
  REQUIRE(cairn_step(120) == 1);
  CHECK(of_body(3, 1) == doctest::Approx(2).epsilon(0.05));  // it hangs, 1.5 m over the ground
  begin_with(text);
  CHECK(std::string(cairn_fingerprint()) == print);
  REQUIRE(cairn_add_rope(0, -4, 5, 0, -3, 5) == 1);
  CHECK(std::string(cairn_body_name(9)) == "rope-2.1");
  REQUIRE(cairn_step(30) == 1);
  CHECK(of_body(9, 1) == doctest::Approx(5).epsilon(0.02));  // it hangs straight between its pins
  REQUIRE(cairn_undo() == 1);
  CHECK(cairn_body_count() == 9);
}

TEST_CASE("a ball or a rope that cannot be is refused, and nothing changes") {
  begin_with(two_crates);
  const std::string text = cairn_scene_text();
  CHECK(cairn_add_ball(0, 4, -1) == 0);
  CHECK(cairn_add_rope(0, 1, 1, 0, 1, 1.01) == 0);
  CHECK(std::string(cairn_refusal()).find("length must be from 0.05 to 100 m") != std::string::npos);
  CHECK(cairn_add_rope(1, 0, 0, 1, 0, 1) == 0);
  CHECK(cairn_add_rope(0, 1, 1, 77, 2, 2) == 0);
  CHECK(cairn_add_rope(0, std::nan(""), 1, 0, 2, 2) == 0);
  CHECK(cairn_scene_text() == text);
}

TEST_CASE("what leaves the ground lands on the floor below it") {
  begin_with(two_crates);
  REQUIRE(cairn_add_ball(8.6, 2, 0.5) == 1);  // beyond the edge, at 8 m
  REQUIRE(cairn_step(600) == 1);
  CHECK(of_body(3, 1) == doctest::Approx(-3 + 0.5).epsilon(0.02));
}

TEST_CASE("walls keep in what flies, stand in the text, and go again") {
  const std::string text = R"(title = "a ball that flies"
gravity = [0, 0]
[[body]]
name = "ball"
circle = 0.5
velocity = [60, 45]
restitution = 1
[recommended]
substeps = 1
)";
  cairn::playground::Playground free, walled;
  free.open(text, "scene");
  walled.open(text, "scene");
  walled.add_walls({{-4, -3}, {6, 5}});
  CHECK(walled.names().back() == "walls-1");
  const auto ball = [](const auto& played) { return played.bench(0).snapshot().bodies[{1}]; };
  free.step(60);
  CHECK(ball(free).pose.position.x() == doctest::Approx(60));
  for (int i = 0; i < 600; ++i) {
    walled.step(1);
    const cairn::Vec2<double> at = ball(walled).pose.position;
    REQUIRE((at.x() > -3.5 - 0.05 && at.x() < 5.5 + 0.05 && at.y() > -2.5 - 0.05 && at.y() < 4.5 + 0.05));
  }
  CHECK(ball(walled).velocity.head<2>().norm() > 1);  // it flies on
  cairn::playground::Playground again;
  again.open(walled.text(), "scene");
  again.step(600);
  CHECK(fingerprint_of(again.bench(0).snapshot()) == fingerprint_of(walled.bench(0).snapshot()));
  walled.undo();
  CHECK(walled.text() == text);
  CHECK(walled.names().size() == 2);
  CHECK_THROWS_WITH_AS(walled.add_walls({{1, 0}, {1, 2}}), doctest::Contains("room must be"),
                       std::invalid_argument);
  CHECK(walled.text() == text);
}

TEST_CASE("a scene that nobody touches takes the same steps without that floor") {
  using namespace cairn;
  int scenes = 0;
  for (const SceneEntry& entry : scene_entries()) {
    CAPTURE(entry.name);
    playground::Playground played;
    std::ifstream file(scene_folder() / (entry.name + ".toml"));
    played.open(std::string(std::istreambuf_iterator<char>(file), {}), entry.name);
    const auto plain = playground::make_bench(played.entry().make(), played.controls().setting);
    played.step(90);
    for (int i = 0; i < 90; ++i) plain->step();
    CHECK(fingerprint_of(played.bench(0).snapshot()) == fingerprint_of(plain->snapshot()));
    ++scenes;
  }
  CHECK(scenes >= 40);
}
