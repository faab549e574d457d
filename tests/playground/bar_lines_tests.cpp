// Which bars stand beside a scene, what they add up, and how contacts and curves look.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <cairn/scenes/solver_list.hpp>
#include "lessons/playground/bar_lines.hpp"
#include "lessons/playground/picture.hpp"
#include "render/image.hpp"
#include "render/solver_style.hpp"

namespace {

using namespace cairn;
using namespace cairn::playground;

const char* const stack = R"([ground]
half_width = 8
[[stack]]
n = 10
box = [1, 1]
)";

Playground opened(const char* text) {
  Playground playground;
  playground.open(text, "scene");
  return playground;
}

List<std::string> names_of(const List<BarLine>& lines) {
  List<std::string> names;
  for (const BarLine& line : lines) names.push_back(line.name);
  return names;
}

/// How many pixels have this colour, but for smooth edges.
int pixels_of(const render::Image& image, render::Color color) {
  const auto is_near = [](unsigned char value, float wanted) {
    return std::abs(value - std::lround(255 * wanted)) <= 6;
  };
  int count = 0;
  for (int i = 0; i < image.width * image.height; ++i) {
    const auto* pixel = &image.pixels[3 * i];
    count += is_near(pixel[0], color.r) && is_near(pixel[1], color.g) && is_near(pixel[2], color.b);
  }
  return count;
}

}  // namespace

TEST_CASE("between steps a contact has one bar, and within a step each of its rows has one") {
  Playground playground = opened(stack);
  CHECK(bar_lines(playground, false).size() == 20);
  CHECK(bar_lines(playground, true).size() == 40);
  CHECK(bar_lines(playground, false)[1].name == "3 normal");
  playground.step(1);
  const List<BarLine> contacts = bar_lines(playground, false);
  REQUIRE(contacts.size() == 10);
  CHECK(names_of(contacts)[0] == "stack.1");
  CHECK(names_of(contacts)[1] == "stack.2, 1");
  CHECK(contacts[0].rows == List<int>{0, 2});
  playground.advance_rows(2);  // the second row is of friction
  const List<BarLine> rows = bar_lines(playground, false);
  CHECK(rows.size() == 21);
  CHECK(rows[1].name == "2 friction");
}

TEST_CASE("the force of a contact stands still beside a tower that stands, though its points take turns") {
  Playground playground = opened(stack);
  playground.step(100);
  double least_end = 1e9, most_end = 0, least_sum = 1e9, most_sum = 0;  // [N]
  for (int i = 0; i < 120; ++i) {
    playground.step(1);
    const PerRow<double>& ends = playground.ends();
    const double dt = playground.look(0).given.dt;
    const double sum = sum_of(bar_lines(playground, false)[0], ends) / dt;
    least_end = std::min(least_end, ends[0] / dt), most_end = std::max(most_end, ends[0] / dt);
    least_sum = std::min(least_sum, sum), most_sum = std::max(most_sum, sum);
  }
  CHECK(most_end - least_end > 20);
  CHECK(most_sum - least_sum < 10);
  CHECK(least_sum == doctest::Approx(100).epsilon(0.06));
}

TEST_CASE("what is nothing but rounding is 0") {
  CHECK(without_rounding(1e-17, 1) == 0);
  CHECK(without_rounding(-2e-9, 1) == -2e-9);
  PerRow<double> impulse;
  for (const double value : {1.0, 0.25, -1e-12}) impulse.push_back(value);
  CHECK(sum_of({.name = "", .rows = {0, 1}}, impulse) == 1.25);
  CHECK(sum_of({.name = "", .rows = {2}}, impulse) == 0);
}

TEST_CASE("the second solver's curve is in its own colour") {
  Picture picture;
  const render::Theme theme = render::light_theme();
  picture.resize(1280, 720, 1);
  for (const auto& [first, second] : {std::pair("pgs", "jacobi"), std::pair("jacobi", "si")}) {
    Playground playground = opened(stack);
    playground.set("solver", first);
    playground.set("other", second);
    picture.draw(playground);
    const render::Image image = picture.page().canvas().read();
    for (const std::string solver : {"pgs", "jacobi", "si"}) {
      const bool is_there = solver == first || solver == second;
      CAPTURE(solver);
      CHECK((pixels_of(image, render::style_of_solver(theme, solver).color) > 100) == is_there);
    }
  }
}

TEST_CASE("contacts at rest have no dots of friction, on a phone neither") {
  Picture picture;
  Playground playground = opened(stack);
  playground.step(60);
  for (const auto& [width, height] : {std::pair(390, 624), std::pair(1280, 720)}) {
    picture.resize(width, height, 1);
    picture.draw(playground);
    CHECK(pixels_of(picture.page().canvas().read(), render::light_theme().friction) < 10);
  }
}

TEST_CASE("the first bar can be seen to grow, by as much as the moment says") {
  Picture picture;
  Playground playground = opened("[ground]\nhalf_width = 3\n[[stack]]\nn = 3\nbox = [1, 1]\n");
  playground.set("warm", "off");
  picture.resize(1280, 720, 1);
  picture.show(false, false);
  playground.advance_rows(1);
  const auto orange = [&](double moment) {
    picture.set_moment(moment);
    picture.draw(playground);
    return pixels_of(picture.page().canvas().read(), render::light_theme().normal);
  };
  const int none = orange(0), half = orange(0.5), all = orange(1);
  CHECK(half > none + 50);
  CHECK(all > half + 50);
  CHECK_THROWS_AS(picture.set_moment(1.5), std::invalid_argument);
}
