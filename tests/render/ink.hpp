// What the tests of the canvas share: pictures in black on white, and how much of them is black.
#pragma once

#include "render/pictures.hpp"

namespace cairn::render {

inline const Color canvas_white = rgb(0xFFFFFF);
inline const Color canvas_black = rgb(0x000000);

inline constexpr double one_level = 1.0 / 255;  // what eight bits can tell apart

/// How dark a pixel of a picture in black on white is: 0 to 1.
inline double darkness(const Image& image, int x, int y) {
  const int pixel = y * image.width + x;
  return 1 - image.pixels[3 * pixel] / 255.0;
}

/// The covered area of a picture in black on white [px^2].
inline double covered_area(const Image& image) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      sum += darkness(image, x, y);
    }
  }
  return sum;
}

/// What `draw` draws on white.
template <typename Draw>
Image picture_of(int width, int height, Draw draw) {
  Canvas canvas(width, height);
  canvas.clear(canvas_white);
  draw(canvas);
  return canvas.read();
}

/// A rectangle about a centre, turned.
inline FixedList<Point, 4> turned_rectangle(const Point& center, double half_width, double half_height,
                                            double angle) {
  const Rotation<double> turn(angle);
  return {center + turn * Point(-half_width, -half_height), center + turn * Point(half_width, -half_height),
          center + turn * Point(half_width, half_height), center + turn * Point(-half_width, half_height)};
}

}  // namespace cairn::render
