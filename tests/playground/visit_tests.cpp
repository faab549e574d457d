// Steps and row updates that are shown again, forwards and backwards.
#include <doctest/doctest.h>

#include <string>

#include <cairn/math/list.hpp>
#include "lessons/playground/interface.h"

namespace {

using cairn::List;

const char* const boxes = R"(title = "three boxes"
[ground]
half_width = 8
[[stack]]
name = "crate"
n = 3
box = [1, 1]
)";

void begin_boxes() {
  REQUIRE(cairn_patience(0) == 1);
  REQUIRE(cairn_open(boxes, "scene") == 1);
  REQUIRE(cairn_set("other", "none") == 1);
}

double told(int place) { return cairn_numbers()[place]; }
constexpr int at_step = 1, at_update = 4, last_step = 15, touched = 16;

/// Where all bodies are, and how they move.
List<double> state() {
  const double* first = cairn_bodies();
  return List<double>(first, first + 8 * cairn_body_count());
}

}  // namespace

TEST_CASE("every step that is kept can be visited, in any order, also those in which a hand pulled") {
  begin_boxes();
  List<List<double>> states = {state()};
  for (int i = 0; i < 100; ++i) {
    if (i == 40) REQUIRE(cairn_grab(0, 2.5) == 1);
    if (i == 40) REQUIRE(cairn_drag(1, 4) == 1);
    if (i == 70) cairn_let_go();
    REQUIRE(cairn_step(1) == 1);
    states.push_back(state());
  }
  CHECK(states[60] != states[40]);
  for (const int step : {100, 3, 60, 59, 0, 99, 70, 100}) {
    CAPTURE(step);
    REQUIRE(cairn_visit(step) == 1);
    CHECK(state() == states[step]);
    CHECK(told(at_step) == step);
    CHECK(told(last_step) == 100);
    CHECK(cairn_history_count() == step + 1);
  }
  REQUIRE(cairn_visit(50) == 1);
  REQUIRE(cairn_grab(cairn_bodies()[8 * 3], cairn_bodies()[8 * 3 + 1]) ==
          1);  // a hand that lets go at once, as a press on a body does
  cairn_let_go();
  CHECK(told(last_step) == 100);
  REQUIRE(cairn_visit(100) == 1);
  CHECK(state() == states[100]);
  CHECK(cairn_visit(101) == 0);
  CHECK(cairn_visit(-1) == 0);
  REQUIRE(cairn_visit(50) == 1);
  REQUIRE(cairn_step(2) == 1);
  CHECK(told(last_step) == 52);  // what came later is forgotten
  CHECK(cairn_history_count() == 53);
  CHECK(cairn_visit(60) == 0);
}

TEST_CASE("a visit to steps before a change keeps the change, and its way back") {
  begin_boxes();
  REQUIRE(cairn_step(10) == 1);
  REQUIRE(cairn_add_ball(3, 3, 0.5) == 1);
  REQUIRE(cairn_set("gravity", "5") == 1);
  REQUIRE(cairn_step(10) == 1);
  REQUIRE(cairn_visit(5) == 1);
  CHECK(cairn_body_count() == 4);
  CHECK(std::string(cairn_scene_text()) == boxes);
  REQUIRE(cairn_visit(20) == 1);
  CHECK(cairn_body_count() == 5);
  CHECK(std::string(cairn_settings()).find("\"value\":\"5\"") != std::string::npos);
  REQUIRE(cairn_visit(15) == 1);
  REQUIRE(cairn_undo() == 1);
  CHECK(cairn_body_count() == 4);
  CHECK(told(last_step) == 10);
  REQUIRE(cairn_step(5) == 1);
  REQUIRE(cairn_visit(8) == 1);
  REQUIRE(cairn_add_box(3, 3, 1, 1) == 1);  // the future that is left has no such box
  CHECK(told(last_step) == 8);
  REQUIRE(cairn_undo() == 1);
  CHECK(cairn_undo() == 0);
}

TEST_CASE("row updates are shown in any order") {
  begin_boxes();
  REQUIRE(cairn_row(7) == 1);
  const std::string words = cairn_words();
  REQUIRE(cairn_visit_row(20) == 1);
  CHECK(told(at_update) == 20);
  REQUIRE(cairn_visit_row(7) == 1);
  CHECK(std::string(cairn_words()) == words);
  REQUIRE(cairn_visit_row(0) == 1);
  CHECK(told(at_update) == 0);
  CHECK(told(at_step) == 0);
  CHECK(cairn_visit_row(static_cast<int>(told(5)) + 1) == 0);
  CHECK(cairn_visit_row(-1) == 0);
}

TEST_CASE("a scene is touched by a hand, and by changes after its first step") {
  begin_boxes();
  REQUIRE(cairn_set("gravity", "5") == 1);
  REQUIRE(cairn_add_box(3, 3, 1, 1) == 1);
  REQUIRE(cairn_step(5) == 1);
  CHECK(told(touched) == 0);
  REQUIRE(cairn_set("gravity", "6") == 1);
  CHECK(told(touched) == 1);
  REQUIRE(cairn_visit(4) == 1);
  CHECK(told(touched) == 0);
  REQUIRE(cairn_restart() == 1);
  CHECK(told(touched) == 0);
  REQUIRE(cairn_grab(0, 2.5) == 1);
  CHECK(told(touched) == 1);
  cairn_let_go();
  REQUIRE(cairn_restart() == 1);
}
