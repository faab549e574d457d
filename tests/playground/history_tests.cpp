// What bodies and pairs did, step by step, as a page plots it.
#include <doctest/doctest.h>

#include <cmath>

#include <cairn/math/list.hpp>
#include "lessons/playground/interface.h"
#include "playground/crates.hpp"

namespace {

using cairn::List;

const char* const falling = R"(title = "a ball that falls"
gravity = [0, -10]
[[body]]
name = "ball"
circle = 0.5
position = [0, 6]
[recommended]
substeps = 1
)";

void begin_run(const char* text) {
  REQUIRE(cairn_patience(0) == 1);
  REQUIRE(cairn_open(text, "scene") == 1);
  REQUIRE(cairn_set("other", "none") == 1);
}

List<double> body(int number) {
  const double* first = cairn_body_history(number);
  return List<double>(first, first + 4 * cairn_history_count());
}
List<double> pair(int a, int b) {
  const double* first = cairn_pair_history(a, b);
  return List<double>(first, first + 2 * cairn_history_count());
}

}  // namespace

TEST_CASE("every step of a fall is kept, whatever was asked for at once") {
  begin_run(falling);
  REQUIRE(cairn_history_count() == 1);
  REQUIRE(cairn_step(30) == 1);
  REQUIRE(cairn_history_count() == 31);
  const List<double> ball = body(1);
  for (int step = 0; step <= 30; ++step) {
    CHECK(ball[4 * step] == doctest::Approx(step / 60.0));
    CHECK(ball[4 * step + 2] == doctest::Approx(10 * step / 60.0));  // g t
    CHECK(ball[4 * step + 3] == 0);
  }
  CHECK(ball[4 * 30 + 1] == cairn_bodies()[8 + 1]);
}

TEST_CASE("back cuts the history, restart begins it anew, and it is as long as the way back") {
  begin_run(falling);
  REQUIRE(cairn_step(10) == 1);
  const List<double> before = body(1);
  REQUIRE(cairn_step(1) == 1);
  REQUIRE(cairn_back() == 1);
  CHECK(body(1) == before);
  REQUIRE(cairn_restart() == 1);
  CHECK(cairn_history_count() == 1);
  REQUIRE(cairn_step(700) == 1);
  CHECK(cairn_history_count() == 601);
}

TEST_CASE("the force between two bodies is the weight that one carries") {
  begin_run(two_crates.c_str());
  REQUIRE(cairn_step(120) == 1);
  const List<double> crates = pair(1, 2), reversed = pair(2, 1);
  CHECK(crates.back() == doctest::Approx(10).epsilon(0.01));
  CHECK(crates == reversed);
  CHECK(pair(0, 1).back() == doctest::Approx(20).epsilon(0.01));
  CHECK(pair(0, 2).back() == 0);
}

TEST_CASE("a body that is not there has no numbers") {
  begin_run(two_crates.c_str());
  REQUIRE(cairn_step(5) == 1);
  REQUIRE(cairn_add_box(4, 3, 1, 1) == 1);
  REQUIRE(cairn_step(1) == 1);
  const List<double> box = body(3);
  CHECK(std::isnan(box[4 * 4 + 1]));
  CHECK(box[4 * 5 + 1] == doctest::Approx(3));
  REQUIRE(cairn_remove(3) == 1);
  CHECK(std::isnan(body(3)[4 * 6 + 1]));
  REQUIRE(cairn_undo() == 1);
  CHECK(std::isfinite(body(3)[4 * 6 + 1]));
  CHECK(std::isnan(body(99)[1]));
  CHECK(std::isnan(body(-1)[1]));
  CHECK(pair(-1, 99).back() == 0);
}
