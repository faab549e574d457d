// The playground through its C functions, as a page calls them.
#include "lessons/playground/interface.h"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include <cairn/math/list.hpp>

namespace {

const char* const two_boxes = R"(title = "two boxes"

[ground]
half_width = 8

[[stack]]
name = "crate"
n = 2
box = [1, 1]
)";

/// Begins with a scene and plain SI, however slow this machine is.
void begin(const char* text) {
  REQUIRE(cairn_patience(0) == 1);
  REQUIRE(cairn_open(text, "scene") == 1);
  REQUIRE(cairn_set("other", "none") == 1);
}

double number(int place) { return cairn_numbers()[place]; }
/// What the normal rows between two bodies give together [N], in a column of cairn_rows().
double load(int a, int b, int column = 0) {
  const double* rows = cairn_rows();
  double sum = 0;
  for (int i = 0; i < cairn_row_count(); ++i) {
    if (rows[6 * i + 3] == 1 && rows[6 * i + 4] == a && rows[6 * i + 5] == b) sum += rows[6 * i + column];
  }
  return sum;
}
double height(int body) { return cairn_bodies()[8 * body + 1]; }
std::string refusal() { return cairn_refusal(); }
std::string fingerprint() { return cairn_fingerprint(); }

nlohmann::json setting(const std::string& name) {
  for (const nlohmann::json& one : nlohmann::json::parse(cairn_settings())) {
    if (one.at("name") == name) return one;
  }
  return {};
}

}  // namespace

TEST_CASE("a scene file is run, and refused with the line and the rule") {
  begin(two_boxes);
  CHECK(cairn_body_count() == 3);
  CHECK(std::string(cairn_body_name(2)) == "crate.2");
  CHECK(cairn_step(60) == 1);
  CHECK(number(1) == 60);
  CHECK(number(0) == doctest::Approx(1.0));
  // Two contacts a box, with two rows each.
  CHECK(cairn_row_count() == 8);
  // The ground carries both boxes of 1 kg.
  CHECK(load(0, 1) == doctest::Approx(20).epsilon(0.01));
  CHECK(cairn_open("title = \"x\"\n[[body]]\nbox = [1, -1]\n", "scene") == 0);
  CHECK(refusal().find("scene:3") == 0);
  CHECK(refusal().find("must be") != std::string::npos);
  CHECK(number(1) == 60);
}

TEST_CASE("rows one by one end where the step ends") {
  begin(two_boxes);
  REQUIRE(cairn_set("sweeps", "3") == 1);
  REQUIRE(cairn_step(1) == 1);
  const std::string start = fingerprint();
  REQUIRE(cairn_step(1) == 1);
  const std::string end = fingerprint();
  REQUIRE(cairn_back() == 1);
  CHECK(fingerprint() == start);
  const int updates = 3 * 8;
  for (int i = 1; i <= updates; ++i) {
    REQUIRE(cairn_row(1) == 1);
    CHECK(number(4) == i);
    CHECK(fingerprint() == start);
  }
  CHECK(number(5) == updates);
  CHECK(number(6) == 3);
  REQUIRE(cairn_row(1) == 1);
  CHECK(number(4) == 0);
  CHECK(fingerprint() == end);
}

TEST_CASE("a sweep goes to its end") {
  begin(two_boxes);
  REQUIRE(cairn_row(3) == 1);
  REQUIRE(cairn_sweep() == 1);
  CHECK(number(4) == 8);
  REQUIRE(cairn_sweep() == 1);
  CHECK(number(4) == 16);
  REQUIRE(cairn_back() == 1);
  CHECK(number(4) == 0);
  CHECK(number(1) == 0);
}

TEST_CASE("steps are taken back to the last bit, with what a hand did in them") {
  begin(two_boxes);
  REQUIRE(cairn_step(20) == 1);
  REQUIRE(cairn_grab(0, 1.5) == 1);
  REQUIRE(cairn_drag(0.5, 3) == 1);
  REQUIRE(cairn_step(20) == 1);
  CHECK(height(2) > 1.6);
  cairn_let_go();
  const std::string there = fingerprint();
  REQUIRE(cairn_step(35) == 1);
  for (int i = 0; i < 35; ++i) REQUIRE(cairn_back() == 1);
  CHECK(fingerprint() == there);
  CHECK(number(11) == 40);
  for (int i = 0; i < 40; ++i) REQUIRE(cairn_back() == 1);
  CHECK(cairn_back() == 0);
  CHECK(refusal() == "There is no step before this one to go back to.");
}

TEST_CASE("the way back leads through changes of settings and bodies, and undoes them") {
  begin(two_boxes);
  const auto now = [] {
    return fingerprint() + cairn_scene_text() + setting("sweeps").at("value").get<std::string>();
  };
  cairn::List<std::string> trail;
  const auto step = [&](int count) {
    for (int i = 0; i < count; ++i) {
      trail.push_back(now());
      REQUIRE(cairn_step(1) == 1);
    }
  };
  step(12);
  REQUIRE(cairn_add_box(0.2, 2.6, 1, 1) == 1);
  step(40);
  REQUIRE(cairn_set("sweeps", "3") == 1);
  step(5);
  REQUIRE(cairn_remove(3) == 1);
  step(2);
  CHECK(number(11) == 59);
  for (int i = trail.size() - 1; i >= 0; --i) {
    REQUIRE(cairn_back() == 1);
    CAPTURE(i);
    CHECK(now() == trail[i]);
  }
  CHECK(cairn_undo() == 0);  // it is done already
}

TEST_CASE("a hand takes hold of what can move, and of nothing else") {
  begin(two_boxes);
  CHECK(cairn_grab(5, 5) == 0);
  CHECK(cairn_grab(0, -0.5) == 0);
  CHECK(refusal() == "There is no body that can move.");
  CHECK(cairn_drag(0, 0) == 0);
  CHECK(cairn_grab(0, 0.5) == 1);
  cairn_let_go();
  CHECK(refusal().empty());
}

TEST_CASE("boxes and pins are put in and taken out, in the world and in its text, and undone") {
  begin(two_boxes);
  REQUIRE(cairn_step(30) == 1);
  const std::string before = fingerprint(), text = cairn_scene_text();
  REQUIRE(cairn_add_box(3, 0.5, 1, 1) == 1);
  CHECK(cairn_body_count() == 4);
  CHECK(number(1) == 30);
  REQUIRE(cairn_pin(0, 3, 3, 0.5) == 1);
  REQUIRE(cairn_remove(1) == 1);
  CHECK(cairn_bodies()[8 * 0 + 7] == 1);
  CHECK(cairn_bodies()[8 * 1 + 7] == 0);
  CHECK(cairn_bodies()[8 * 2 + 7] == 2);
  const std::string changed = cairn_scene_text();
  CHECK(changed.find("[[joint]]\ntype = \"revolute\"\nb = \"box-1\"") != std::string::npos);
  REQUIRE(cairn_step(60) == 1);
  const double fallen = height(2);
  CHECK(fallen == doctest::Approx(0.5).epsilon(0.02));
  // The text as it is now is the same scene.
  REQUIRE(cairn_open(changed.c_str(), "scene") == 1);
  REQUIRE(cairn_step(90) == 1);
  CHECK(cairn_body_count() == 4);
  CHECK(cairn_undo() == 0);
  begin(two_boxes);
  REQUIRE(cairn_step(30) == 1);
  REQUIRE(cairn_add_box(3, 0.5, 1, 1) == 1);
  REQUIRE(cairn_step(5) == 1);
  REQUIRE(cairn_undo() == 1);
  CHECK(fingerprint() == before);
  CHECK(std::string(cairn_scene_text()) == text);
  CHECK(cairn_undo() == 0);
  CHECK(cairn_remove(0) == 0);
  CHECK(cairn_remove(17) == 0);
}

TEST_CASE("each setting takes what it lists, and refuses the rest in words") {
  begin(two_boxes);
  for (const nlohmann::json& one : nlohmann::json::parse(cairn_settings())) {
    const std::string name = one.at("name"), value = one.at("value");
    CAPTURE(name);
    CHECK_FALSE(one.at("title").get<std::string>().empty());
    CHECK(cairn_set(name.c_str(), value.c_str()) == 1);
    CHECK(cairn_set(name.c_str(), "nonsense") == 0);
    CHECK(refusal().find("nonsense") != std::string::npos);
    for (const std::string choice : one.at("choices")) {
      CAPTURE(choice);
      CHECK(cairn_set(name.c_str(), choice.c_str()) == 1);
      CHECK(setting(name).at("value") == choice);
      CHECK(cairn_step(1) == 1);
    }
    CHECK(cairn_set(name.c_str(), value.c_str()) == 1);
  }
  for (const char* word : {"split impulse", "split_impulse", "split-impulse"})
    CHECK(cairn_set("policy", word) == 1);
  CHECK(cairn_set("sweeps", "101") == 0);
  CHECK(cairn_set("sweeps", "2.5") == 0);
  CHECK(refusal().find("a whole number from 0 to 100") != std::string::npos);
  CHECK(cairn_set("sweps", "1") == 0);
  CHECK(refusal().find("sweeps") != std::string::npos);
}

TEST_CASE("limits of a setting hold what the scene recommends") {
  const std::string text = std::string(two_boxes) + "\n[step]\ndt = 0.001\n[recommended]\niterations = 300\n";
  begin(text.c_str());
  CHECK(setting("rate").at("most") == 1000);
  CHECK(setting("sweeps").at("most") == 300);
  CHECK(cairn_set("sweeps", "301") == 0);
  REQUIRE(cairn_set("sweeps", "10") == 1);
  CHECK(cairn_set("sweeps", "300") == 1);
  CHECK(setting("sweeps").at("least") == 0);
}

TEST_CASE("a world goes on under another setting") {
  begin(two_boxes);
  REQUIRE(cairn_step(10) == 1);
  REQUIRE(cairn_set("solver", "newton") == 1);
  CHECK(number(1) == 10);
  REQUIRE(cairn_step(1) == 1);
  CHECK(number(7) < 1e-6);
  CHECK(cairn_row(1) == 0);
  CHECK(refusal().find("newton has no updates of single rows") == 0);
  REQUIRE(cairn_set("mass-ratio", "100") == 1);
  CHECK(number(1) == 11);
  CHECK(cairn_bodies()[8 * 2 + 6] == 100);
  REQUIRE(cairn_set("mass-ratio", "1") == 1);
  CHECK(cairn_bodies()[8 * 2 + 6] == 1);
}

TEST_CASE("a second solver runs beside the first") {
  begin(two_boxes);
  REQUIRE(cairn_set("other", "newton") == 1);
  REQUIRE(cairn_step(60) == 1);
  // Both carry the upper box, the first nearly.
  CHECK(load(1, 2, 2) == doctest::Approx(10).epsilon(1e-6));
  CHECK(load(1, 2) == doctest::Approx(10).epsilon(0.01));
  REQUIRE(cairn_set("other", "none") == 1);
}

TEST_CASE("sweeps end where the tick says") {
  begin(two_boxes);
  REQUIRE(cairn_set("warm", "off") == 1);
  REQUIRE(cairn_set("friction", "0") == 1);
  REQUIRE(cairn_set("sweeps", "100") == 1);
  // A sweep over a stack of two leaves half of the error, and both limits are within 1e-12 of the weight.
  REQUIRE(cairn_row_count() == 4);
  const double* rows = cairn_rows();
  for (int i = 0; i < 4; ++i) CHECK(std::abs(rows[6 * i] - rows[6 * i + 1]) < 1e-9);
}

TEST_CASE("a prediction is kept, and revealed with how far it is off") {
  begin(two_boxes);
  REQUIRE(cairn_predict(0, 7) == 1);
  CHECK(number(12) == 0);
  CHECK(number(13) == 7);
  CHECK(number(14) == 0);
  cairn_reveal();
  CHECK(number(14) == 1);
  CHECK(std::string(cairn_words()).find("Row 1 ends at 10") == 0);
  CHECK(cairn_predict(99, 1) == 0);
}
