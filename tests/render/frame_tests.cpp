// Whole frames: clips, coordinates that are out of bounds, contexts side by side, and the same bits every
// time.
#include <cstdlib>
#include <thread>

#include "render/ink.hpp"

using namespace cairn;
using namespace cairn::render;

namespace {

/// Everything at once.
void draw_medley(Canvas& canvas) {
  canvas.clear(rgb(0xF6F8FA));
  const auto box = turned_rectangle({40, 40}, 20, 12, 0.4);
  canvas.polygon(box, {.fill = rgb(0x5B8FCF), .outline = canvas_black, .outline_width = 1.5});
  canvas.polygon(turned_rectangle({100, 40}, 15, 9, 1.1), {.fill = faded(rgb(0xCF6F60), 0.7)}, 4);
  canvas.hatch(box, {.width = 1, .color = canvas_black}, 7);
  canvas.circle({150.3, 40.7}, 17.2, {.fill = rgb(0x7AB58A), .outline = canvas_black, .outline_width = 2});
  List<Point> wave;
  for (int i = 0; i < 180; ++i) {
    wave.emplace_back(10 + i, 90 + 12 * std::sin(0.3 * i));
  }
  canvas.polyline(wave, {.width = 2, .color = rgb(0xC8452F)});
  canvas.polyline(wave, {.width = 1, .color = canvas_black, .dash = {5, 3}});
  canvas.push_clip({120, 60, 50, 40});
  canvas.capsule({110, 60}, {180, 100}, 8, {.fill = faded(rgb(0x9A7FC0), 0.5)});
  canvas.pop_clip();
  canvas.text({10, 140}, "λ_{n} ≥ 0  x^{2}", {.size = 15, .color = canvas_black, .halo = canvas_white});
}

Image medley() {
  Canvas canvas(200, 150);
  draw_medley(canvas);
  return canvas.read();
}

/// Chooses the backend while it lives.
class BackendChoice {
 public:
  explicit BackendChoice(const char* name) {
    if (const char* before = std::getenv("CAIRN_RENDER_BACKEND"); before != nullptr) {
      before_ = before;
    }
    setenv("CAIRN_RENDER_BACKEND", name, 1);
  }
  ~BackendChoice() {
    if (before_.empty()) {
      unsetenv("CAIRN_RENDER_BACKEND");
    } else {
      setenv("CAIRN_RENDER_BACKEND", before_.c_str(), 1);
    }
  }
  BackendChoice(const BackendChoice&) = delete;
  BackendChoice& operator=(const BackendChoice&) = delete;

 private:
  std::string before_ = {};
};

}  // namespace

TEST_CASE("nothing is drawn outside the intersection of all clips, and a clip ends when it is popped") {
  Canvas canvas(20, 20);
  canvas.clear(canvas_white);
  const Rect everything = {0, 0, 20, 20};
  canvas.push_clip({2, 3, 10, 10});
  canvas.push_clip({5, 1, 30, 6});
  canvas.rect(everything, {.fill = canvas_black});
  CHECK(covered_area(canvas.read()) == 7 * 4);
  canvas.pop_clip();
  canvas.rect(everything, {.fill = canvas_black});
  CHECK(covered_area(canvas.read()) == 100);
  canvas.push_clip({50, 50, 5, 5});
  canvas.rect(everything, {.fill = canvas_black});
  CHECK(covered_area(canvas.read()) == 100);
  canvas.pop_clip();
  canvas.pop_clip();
  canvas.rect(everything, {.fill = canvas_black});
  CHECK(covered_area(canvas.read()) == 400);
  CHECK_THROWS_AS(canvas.pop_clip(), std::logic_error);
}

TEST_CASE("coordinates that are not finite or absurdly large draw nothing and harm nothing else") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const auto sound = [](Canvas& canvas) { canvas.rect({5, 5, 10, 10}, {.fill = canvas_black}); };
  const Image image = picture_of(40, 40, [&](Canvas& canvas) {
    for (const double bad : {nan, infinite, -infinite, 1e30, -1e30}) {
      const Paint paint = {.fill = canvas_black, .outline = canvas_black, .outline_width = 1};
      const FixedList<Point, 4> corners = {Point(1, 1), Point(9, bad), Point(9, 9), Point(1, 9)};
      const Stroke stroke = {.width = 2, .color = canvas_black, .dash = {3, 2}};
      canvas.circle({bad, 5}, 3, paint);
      canvas.circle({5, 5}, bad, paint);
      canvas.polygon(corners, paint);
      canvas.polygon(corners, paint, 3);
      canvas.rect({1, bad, 5, 5}, paint, 2);
      canvas.capsule({1, 1}, {bad, bad}, 2, paint);
      canvas.line({1, 1}, {bad, 20}, stroke);
      canvas.line({1, 1}, {30, 20}, {.width = bad, .color = canvas_black});
      canvas.hatch(corners, stroke, 5);
      canvas.hatch(turned_rectangle({20, 20}, 5, 5, 0), stroke, bad);
      canvas.text({bad, 20}, "text", {.size = 15, .color = canvas_black});
      canvas.text({5, 20}, "text", {.size = bad, .color = canvas_black});
      canvas.push_clip({bad, 0, nan, 10});
      canvas.pop_clip();
    }
    sound(canvas);
  });
  CHECK(image.pixels == picture_of(40, 40, sound).pixels);
}

TEST_CASE("shapes that reach far beyond the frame keep their edges") {
  const Image image = picture_of(20, 20, [](Canvas& canvas) {
    canvas.polygon(
        FixedList<Point, 4>{Point(-1e6, 10.5), Point(1e6, 10.5), Point(1e6, 1e6), Point(-1e6, 1e6)},
        {.fill = canvas_black});
    canvas.line({-1e6, 4}, {1e6, 4}, {.width = 1, .color = canvas_black});
  });
  for (int x = 0; x < 20; ++x) {
    CHECK(darkness(image, x, 3) == doctest::Approx(0.5).epsilon(0.01));
    CHECK(darkness(image, x, 4) == doctest::Approx(0.5).epsilon(0.01));
    CHECK(darkness(image, x, 9) == 0);
    CHECK(darkness(image, x, 10) == doctest::Approx(0.5).epsilon(0.01));
    CHECK(darkness(image, x, 11) == 1);
  }
}

TEST_CASE("the same frame twice is the same to the last bit, in one canvas and in another") {
  Canvas canvas(200, 150);
  draw_medley(canvas);
  const Image first = canvas.read();
  draw_medley(canvas);
  CHECK(canvas.read().pixels == first.pixels);
  CHECK(medley().pixels == first.pixels);
}

TEST_CASE("two canvases take turns in one thread without disturbing each other") {
  Canvas one(20, 20);
  Canvas two(30, 10);
  one.clear(canvas_white);
  two.clear(canvas_black);
  one.rect({0, 0, 5, 5}, {.fill = canvas_black});
  two.rect({0, 0, 3, 3}, {.fill = canvas_white});
  const Image second = two.read();
  CHECK(covered_area(one.read()) == 25);
  CHECK(covered_area(second) == 300 - 9);
}

TEST_CASE("a canvas in another thread draws the same bits") {
  Image other;
  std::thread([&] { other = medley(); }).join();
  CHECK(other.pixels == medley().pixels);
}

TEST_CASE("OSMesa and EGL draw the same bits, side by side") {
  try {
    Image osmesa;
    Image egl;
    {
      const BackendChoice choice("osmesa");
      Canvas canvas(200, 150);
      draw_medley(canvas);
      CHECK(canvas.backend() == "osmesa");
      const BackendChoice other_choice("egl");
      Canvas other(200, 150);
      draw_medley(other);
      CHECK(other.backend() == "egl");
      egl = other.read();
      osmesa = canvas.read();
    }
    CHECK(osmesa.pixels == egl.pixels);
  } catch (const RenderError& error) {
    MESSAGE("not compared, one backend is missing: " << std::string(error.what()));
  }
}

TEST_CASE("an unknown backend and a canvas without size are refused by name") {
  {
    const BackendChoice choice("paper");
    CHECK_THROWS_WITH_AS(Canvas(10, 10), "CAIRN_RENDER_BACKEND must be osmesa or egl, got paper",
                         RenderError);
  }
  CHECK_THROWS_WITH_AS(Canvas(0, 10), "Canvas: width must be positive px, got 0", std::invalid_argument);
  CHECK_THROWS_AS(Canvas(10, -1), std::invalid_argument);
}
