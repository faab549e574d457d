// Shapes: what part of every pixel they cover, held against areas from formulas.
#include "render/ink.hpp"

using namespace cairn;
using namespace cairn::render;

TEST_CASE("an upright rectangle covers every pixel by the area they share") {
  const Image image = picture_of(8, 8, [](Canvas& canvas) {
    canvas.rect({2.5, 3.25, 3, 2}, {.fill = canvas_black});
  });
  const FixedList<double, 8> across = {0, 0, 0.5, 1, 1, 0.5, 0, 0};
  const FixedList<double, 8> down = {0, 0, 0, 0.75, 1, 0.25, 0, 0};
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const double shared = across[x] * down[y];
      CHECK(darkness(image, x, y) == doctest::Approx(shared).epsilon(one_level));
    }
  }
}

TEST_CASE("y points down and the first row of an image is the top one") {
  const Image image = picture_of(5, 7, [](Canvas& canvas) {
    canvas.rect({1, 0, 1, 1}, {.fill = canvas_black});
  });
  CHECK(image.width == 5);
  CHECK(image.height == 7);
  CHECK(image.pixels.size() == 5 * 7 * 3);
  CHECK(darkness(image, 1, 0) == 1);
  CHECK(covered_area(image) == 1);
}

TEST_CASE("a disk covers pi r^2, up to the ramp of one pixel at its edge") {
  for (const double radius : {0.2, 0.5, 1.0, 3.3, 20.0}) {
    const Image image = picture_of(48, 48, [&](Canvas& canvas) {
      canvas.circle({24.2, 23.6}, radius, {.fill = canvas_black});
    });
    // A linear ramp over one pixel adds pi / 12; sums over a grid and eight bits add less than a level a
    // pixel.
    const double ramp = pi / 12;
    CAPTURE(radius);
    CHECK(std::abs(covered_area(image) - pi * radius * radius) <= ramp + 0.06 + 0.01 * radius);
  }
}

TEST_CASE("a capsule covers its rectangle and two half disks") {
  const Image image = picture_of(80, 60, [](Canvas& canvas) {
    canvas.capsule({20, 20}, {56, 37}, 7, {.fill = canvas_black});
  });
  const double area = 14 * std::hypot(36, 17) + pi * 49;
  CHECK(covered_area(image) == doctest::Approx(area).epsilon(0.002));
}

TEST_CASE("an outline is centred on the edge and as wide as asked for") {
  for (const double width : {0.5, 1.0, 2.5, 6.0}) {
    const Image disk = picture_of(64, 64, [&](Canvas& canvas) {
      canvas.circle({32, 32}, 20, {.outline = canvas_black, .outline_width = width});
    });
    const Image square = picture_of(64, 64, [&](Canvas& canvas) {
      canvas.rect({12.5, 12.5, 30, 20}, {.outline = canvas_black, .outline_width = width});
    });
    CAPTURE(width);
    CHECK(covered_area(disk) == doctest::Approx(2 * pi * 20 * width).epsilon(0.01));
    // (a + w)(b + w) - (a - w)(b - w) = 2 (a + b) w for corners that stay sharp.
    CHECK(covered_area(square) == doctest::Approx(100 * width).epsilon(0.005));
  }
}

TEST_CASE("an opaque outline hides the fill under it and nothing shows between the two") {
  const Image image = picture_of(40, 40, [](Canvas& canvas) {
    canvas.circle({20, 20}, 12.3, {.fill = canvas_black, .outline = canvas_black, .outline_width = 3});
  });
  CHECK(covered_area(image) == doctest::Approx(pi * 13.8 * 13.8).epsilon(0.002));
  CHECK(darkness(image, 20, 20) == 1);
  CHECK(darkness(image, 32, 20) == 1);
}

TEST_CASE("a polygon looks the same in either turning sense, and a turned one keeps its area") {
  const auto points = turned_rectangle({30, 30}, 18, 9, 0.7);
  const FixedList<Point, 4> reversed = {points[3], points[2], points[1], points[0]};
  const auto image_of = [](const FixedList<Point, 4>& corners) {
    return picture_of(60, 60, [&](Canvas& canvas) { canvas.polygon(corners, {.fill = canvas_black}); });
  };
  const Image image = image_of(points);
  CHECK(covered_area(image) == doctest::Approx(36 * 18).epsilon(0.002));
  CHECK(covered_area(image_of(reversed)) == doctest::Approx(covered_area(image)).epsilon(1e-4));
}

TEST_CASE("polygons of many sides, sharp or rounded, cover their area") {
  List<Point> points;
  for (int i = 0; i < 7; ++i) {
    points.emplace_back(40 + 25 * std::cos(2 * pi * i / 7), 40 + 25 * std::sin(2 * pi * i / 7));
  }
  const double side = 50 * std::sin(pi / 7);
  const double area = 3.5 * 625 * std::sin(2 * pi / 7);
  for (const double rounding : {0.0, 2.0, 9.0}) {
    const Image image =
        picture_of(80, 80, [&](Canvas& canvas) { canvas.polygon(points, {.fill = canvas_black}, rounding); });
    CAPTURE(rounding);
    // Steiner: area + perimeter r + pi r^2.
    CHECK(covered_area(image) ==
          doctest::Approx(area + 7 * side * rounding + pi * rounding * rounding).epsilon(0.002));
  }
}

TEST_CASE("pieces of a see-through rounded polygon neither overlap nor leave gaps") {
  const Image image = picture_of(60, 60, [](Canvas& canvas) {
    canvas.polygon(turned_rectangle({30, 30}, 12, 8, 0.37), {.fill = faded(canvas_black, 0.5)}, 8);
  });
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) {
      CHECK(darkness(image, x, y) <= 0.5 + one_level);
      const Point local = Rotation<double>(0.37).transposed_times(Point(x + 0.5 - 30, y + 0.5 - 30));
      const Point beyond = (local.cwiseAbs() - Point(12, 8)).cwiseMax(0);
      if (beyond.norm() < 7) {
        CHECK(darkness(image, x, y) >= 0.5 - one_level);
      }
    }
  }
}

TEST_CASE("a thin sliver and a sharp tip are as dark as their area") {
  const Image sliver = picture_of(80, 30, [](Canvas& canvas) {
    canvas.polygon(turned_rectangle({40, 15}, 30, 0.2, 0.1), {.fill = canvas_black});
  });
  CHECK(covered_area(sliver) == doctest::Approx(60 * 0.4).epsilon(0.03));
  const Image tip = picture_of(80, 30, [](Canvas& canvas) {
    canvas.polygon(FixedList<Point, 3>{Point(5, 10), Point(5, 20), Point(75, 14)}, {.fill = canvas_black});
  });
  CHECK(covered_area(tip) == doctest::Approx(0.5 * 10 * 70).epsilon(0.01));
}

TEST_CASE("a polygon that has collapsed to a line is drawn as one if it is rounded, and else not at all") {
  const FixedList<Point, 3> flat = {Point(10, 20), Point(40, 20), Point(25, 20)};
  const auto image_of = [&](double rounding) {
    return picture_of(60, 40,
                      [&](Canvas& canvas) { canvas.polygon(flat, {.fill = canvas_black}, rounding); });
  };
  CHECK(covered_area(image_of(5)) == doctest::Approx(30 * 10 + pi * 25).epsilon(0.002));
  CHECK(covered_area(image_of(0)) == 0);
}

TEST_CASE("colours are straight sRGB and mix by opacity") {
  const Image image = picture_of(3, 1, [](Canvas& canvas) {
    canvas.rect({0, 0, 1, 1}, {.fill = rgb(0x336699)});
    canvas.rect({1, 0, 1, 1}, {.fill = faded(rgb(0xFF0000), 0.25)});
  });
  CHECK(image.pixels[0] == 0x33);
  CHECK(image.pixels[1] == 0x66);
  CHECK(image.pixels[2] == 0x99);
  CHECK(image.pixels[3] == 255);
  CHECK(std::abs(image.pixels[4] - 0.75 * 255) <= 1);
  CHECK(std::abs(image.pixels[5] - 0.75 * 255) <= 1);
  CHECK(image.pixels[6] == 255);
}

TEST_CASE("a sharp canvas draws what a larger one does of everything enlarged") {
  for (const double scale : {0.5, 2.0, 2.75}) {
    List<Rect> boxes;
    const auto draw = [&](Canvas& canvas, double by) {
      canvas.clear(canvas_white);
      const Paint paint{.fill = rgb(0x3366AA), .outline = canvas_black, .outline_width = 3 * by};
      canvas.circle(by * Point(20, 20), 10 * by, paint);
      canvas.rect({40 * by, 8 * by, 20 * by, 16 * by}, paint, 4 * by);
      canvas.push_clip({0, 4 * by, 96 * by, 56 * by});
      canvas.polygon(FixedList<Point, 3>{by * Point(70, 5), by * Point(92, 9), by * Point(80, 30)}, paint,
                     by);
      canvas.hatch(FixedList<Point, 3>{by * Point(5, 40), by * Point(30, 40), by * Point(5, 62)},
                   {.width = by}, 5 * by);
      canvas.line(by * Point(35, 50), by * Point(90, 40), {.width = 2 * by, .dash = {6 * by, 3 * by}});
      canvas.text(by * Point(92, 58), "v_{rel}", {.size = 14 * by, .align = Align::right});
      for (const TextBox& box : canvas.text_boxes()) boxes.push_back(box.rect);
      CHECK(canvas.text_width("v_{rel}", {.size = 14 * by}) ==
            doctest::Approx(by * canvas.text_width("v_{rel}", {.size = 14})).epsilon(1e-6));
      return canvas.read();
    };
    Canvas sharp(96, 64, scale), large(static_cast<int>(96 * scale), static_cast<int>(64 * scale));
    const Image image = draw(sharp, 1);
    CAPTURE(scale);
    CHECK(image.pixels == draw(large, scale).pixels);
    CHECK(boxes[0].x * scale == doctest::Approx(boxes[1].x));
    CHECK(boxes[0].width * scale == doctest::Approx(boxes[1].width));
    CHECK(sharp.width() == 96);
  }
  CHECK_THROWS_AS(Canvas(96, 64, 0.1), std::invalid_argument);
  CHECK_THROWS_AS(Canvas(96, 64, 9), std::invalid_argument);
}
