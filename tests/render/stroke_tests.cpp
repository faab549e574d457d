// Lines, dashes and hatching: what part of every pixel they cover, held against lengths from formulas.
#include "render/ink.hpp"

using namespace cairn;
using namespace cairn::render;

TEST_CASE("a line is cut straight at its ends: it covers its length times its width") {
  for (const double width : {0.5, 1.0, 3.0}) {
    const Image image = picture_of(80, 60, [&](Canvas& canvas) {
      canvas.line({10.3, 12.1}, {65.2, 44.8}, {.width = width, .color = canvas_black});
    });
    CAPTURE(width);
    CHECK(covered_area(image) == doctest::Approx(width * std::hypot(54.9, 32.7)).epsilon(0.01));
  }
}

TEST_CASE("the joints of a see-through polyline are drawn once and without a gap") {
  List<Point> arc;
  for (int i = 0; i <= 40; ++i) {
    arc.emplace_back(50 + 35 * std::cos(pi * i / 40), 50 + 35 * std::sin(pi * i / 40));
  }
  const Image image = picture_of(100, 100, [&](Canvas& canvas) {
    canvas.polyline(arc, {.width = 8, .color = faded(canvas_black, 0.5)});
  });
  double darkest = 0;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) {
      darkest = std::max(darkest, darkness(image, x, y));
      const double distance = std::hypot(x - 49.5, y - 49.5);
      if (std::abs(distance - 35) < 3 && y > 51) {
        CHECK(darkness(image, x, y) >= 0.5 - one_level);
      }
    }
  }
  CHECK(darkest <= 0.5 + one_level);
}

TEST_CASE("a dash pattern draws and leaves out the lengths it names, also around a corner") {
  const Image straight = picture_of(60, 5, [](Canvas& canvas) {
    canvas.line({4, 2.5}, {56, 2.5}, {.width = 1, .color = canvas_black, .dash = {6, 4, 2, 1}});
  });
  for (int x = 4; x < 56; ++x) {
    const int in_period = (x - 4) % 13;
    const bool drawn = in_period < 6 || (in_period >= 10 && in_period < 12);
    CHECK(darkness(straight, x, 2) == doctest::Approx(drawn ? 1 : 0));
  }
  const FixedList<Point, 3> corner = {Point(5, 5), Point(45, 5), Point(45, 45)};
  const Image bent = picture_of(50, 50, [&](Canvas& canvas) {
    canvas.polyline(corner, {.width = 1, .color = canvas_black, .dash = {7, 3}});
  });
  CHECK(covered_area(bent) == doctest::Approx(0.7 * 80).epsilon(0.01));
}

TEST_CASE("an odd dash pattern swaps drawn and left out each time round; an empty length is no pattern") {
  const Image odd = picture_of(60, 5, [](Canvas& canvas) {
    canvas.line({0, 2.5}, {60, 2.5}, {.width = 1, .color = canvas_black, .dash = {5}});
  });
  CHECK(darkness(odd, 2, 2) == 1);
  CHECK(darkness(odd, 7, 2) == 0);
  CHECK(darkness(odd, 12, 2) == 1);
  const Image solid = picture_of(60, 5, [](Canvas& canvas) {
    canvas.line({0, 2.5}, {60, 2.5}, {.width = 1, .color = canvas_black, .dash = {0, 0}});
  });
  CHECK(covered_area(solid) == 60);
}

TEST_CASE("hatching stays in its polygon and covers width over pitch of it") {
  const FixedList<Point, 4> square = {Point(10, 10), Point(90, 10), Point(90, 90), Point(10, 90)};
  const Image image = picture_of(
      100, 100, [&](Canvas& canvas) { canvas.hatch(square, {.width = 1.5, .color = canvas_black}, 10); });
  // Lines at 45 degrees and 10 px apart horizontally are 10 / sqrt(2) px apart across. Pixel centres meet
  // such lines at multiples of sqrt(1/2) px only: the ramp of one pixel is summed at few places, hence 2 %.
  CHECK(covered_area(image) == doctest::Approx(6400 * 1.5 * std::sqrt(2) / 10).epsilon(0.02));
  for (int i = 0; i < 100; ++i) {
    CHECK(darkness(image, i, 9) == 0);
    CHECK(darkness(image, 90, i) == 0);
  }
}

TEST_CASE("a polyline with a bad point keeps its sound parts") {
  const FixedList<Point, 5> points = {Point(2, 2.5), Point(12, 2.5), Point(std::nan(""), 0), Point(20, 2.5),
                                      Point(30, 2.5)};
  const Image image = picture_of(
      40, 5, [&](Canvas& canvas) { canvas.polyline(points, {.width = 1, .color = canvas_black}); });
  CHECK(covered_area(image) == 20);
}
