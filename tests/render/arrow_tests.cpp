// Arrows are as long as their quantity, and say so when they are not.
#include "render/arrow.hpp"
#include "render/pictures.hpp"

namespace cairn::render {

namespace {

Camera arrow_test_camera() { return {.viewport = {0, 0, 640, 360}, .center = {0, 0}, .scale = 100}; }

bool arrow_test_inked(const Image& image, int x, int y, Color background) {
  return sum_off(image, x, y, background) > 40;
}

/// What of row `y` is inked: first and last column, and how many.
struct ArrowTestRun {
  int first = 1 << 20, last = -1, count = 0;
};

ArrowTestRun arrow_test_run(const Image& image, int y, Color background) {
  ArrowTestRun run;
  for (int x = 0; x < image.width; ++x) {
    if (!arrow_test_inked(image, x, y, background)) continue;
    run.first = std::min(run.first, x);
    run.last = std::max(run.last, x);
    ++run.count;
  }
  return run;
}

ArrowTestRun arrow_test_rows(const Image& image, Color background) {
  ArrowTestRun run;
  for (int y = 0; y < image.height; ++y) {
    if (arrow_test_run(image, y, background).count == 0) continue;
    run.first = std::min(run.first, y);
    run.last = std::max(run.last, y);
    ++run.count;
  }
  return run;
}

/// One arrow to the right from the middle of an empty page.
Image arrow_picture(ArrowKind kind, double value, const ArrowScale& scale) {
  Page page(640, 360, light_theme());
  draw_arrow(page, arrow_test_camera(), scale, {.kind = kind, .tail = {0, -0.005}, .value = {value, 0}});
  return page.canvas().read();
}

constexpr int arrow_test_row = 180;  // the tail lies in the middle of this row of pixels

ArrowTestRun run_of_arrow(ArrowKind kind, double value, const ArrowScale& scale) {
  return arrow_test_run(arrow_picture(kind, value, scale), arrow_test_row, light_theme().background);
}

}  // namespace

TEST_CASE("an arrow is as long as its value times the scale") {
  const ArrowScale scale = {.pixels_per_unit = 8, .longest = 300, .unit = "N"};
  for (const ArrowKind kind : {ArrowKind::normal, ArrowKind::friction, ArrowKind::velocity, ArrowKind::joint,
                               ArrowKind::negative_correction, ArrowKind::external, ArrowKind::inactive}) {
    for (const double value : {4.0, 12.5, 30.0}) {
      CAPTURE(static_cast<int>(kind));
      CAPTURE(value);
      const ArrowTestRun run = run_of_arrow(kind, value, scale);
      // The tip is a point: its last pixel may be too pale to count.
      CHECK(std::abs(run.last + 1 - (320 + 8 * value)) <= 2);
    }
  }
}

TEST_CASE("a solid arrow is inked from its tail to its tip, a dashed one is not") {
  const ArrowScale scale = {.pixels_per_unit = 8, .longest = 300, .unit = "N"};
  const ArrowTestRun solid = run_of_arrow(ArrowKind::normal, 20, scale);
  CHECK(solid.first == 320);
  CHECK(solid.count == solid.last - solid.first + 1);
  const ArrowTestRun dashed = run_of_arrow(ArrowKind::external, 20, scale);
  CHECK(dashed.count < 0.85 * (dashed.last - dashed.first + 1));
}

TEST_CASE("an arrow shorter than 8 px is a dot of 3 px") {
  const ArrowScale scale = {.pixels_per_unit = 1, .longest = 200, .unit = "N"};
  const Color background = light_theme().background;
  for (const double value : {0.0, 3.0, 7.9}) {
    const Image image = arrow_picture(ArrowKind::normal, value, scale);
    const ArrowTestRun width = arrow_test_run(image, arrow_test_row, background);
    const ArrowTestRun height = arrow_test_rows(image, background);
    CHECK(std::abs(width.last + 1 - width.first - 2 * 3) <= 1);
    CHECK(std::abs(height.last + 1 - height.first - 2 * 3) <= 1);
    CHECK(std::abs(0.5 * (width.first + width.last + 1) - 320) <= 0.5);
  }
}

TEST_CASE("an arrow above the longest is cut there, with a gap in its shaft and its number") {
  const ArrowScale scale = {.pixels_per_unit = 10, .longest = 150, .unit = "N"};
  const Color background = light_theme().background;
  const ArrowTestRun whole = run_of_arrow(ArrowKind::normal, 15, scale);
  CHECK(whole.count == whole.last - whole.first + 1);
  Page page(640, 360, light_theme());
  draw_arrow(page, arrow_test_camera(), scale, {.tail = {0, -0.005}, .value = {40, 0}});
  const ArrowTestRun cut = arrow_test_run(page.canvas().read(), arrow_test_row, background);
  CHECK(std::abs(cut.last + 1 - (320 + 150)) <= 2);
  CHECK(cut.count < cut.last - cut.first + 1);
  REQUIRE(page.canvas().text_boxes().size() == 1);
  CHECK(page.canvas().text_boxes()[0].text == "40 N");
  draw_arrow(page, arrow_test_camera(), scale, {.tail = {0, 1}, .value = {40, 0}, .label = "λ_2"});
  CHECK(page.canvas().text_boxes()[1].text == "λ_2 = 40 N");
  draw_arrow(page, arrow_test_camera(), scale, {.tail = {0, -1}, .value = {40, 0}, .label = "40.0 N"});
  CHECK(page.canvas().text_boxes()[2].text == "40.0 N");
}

TEST_CASE("arrows point up when their value does") {
  const ArrowScale scale = {.pixels_per_unit = 10, .longest = 150, .unit = "N"};
  Page page(640, 360, light_theme());
  draw_arrow(page, arrow_test_camera(), scale, {.tail = {0, 0}, .value = {0, 10}});
  const ArrowTestRun height = arrow_test_rows(page.canvas().read(), page.theme().background);
  CHECK(std::abs(height.first - (180 - 100)) <= 2);
  CHECK(height.last == 179);
}

TEST_CASE("a head is at most a quarter of its arrow") {
  const ArrowScale scale = {.pixels_per_unit = 1, .longest = 200, .unit = "N"};
  const Color background = light_theme().background;
  for (const double value : {12.0, 20.0, 100.0}) {
    const Image image = arrow_picture(ArrowKind::normal, value, scale);
    int first_of_head = 640;  // where something stands beside the shaft
    for (int x = 319; x < 640; ++x) {
      if (arrow_test_inked(image, x, arrow_test_row + 3, background))
        first_of_head = std::min(first_of_head, x);
    }
    CHECK(first_of_head + 1 >= 320 + 0.75 * value);
  }
}

TEST_CASE("the largest value of a sequence fills 35 % of the viewport's height and is not cut") {
  const Camera camera = arrow_test_camera();
  const ArrowScale scale = arrow_scale(37.3, "N", camera);
  CHECK(scale.pixels_per_unit * 37.3 == doctest::Approx(0.35 * 360));
  CHECK(scale.longest == doctest::Approx(0.35 * 360));
  CHECK(scale.unit == "N");
  Page page(640, 360, light_theme());
  draw_arrow(page, camera, scale, {.value = {0, 37.3}});
  CHECK(page.canvas().text_boxes().empty());
}

TEST_CASE("a sequence without any force still has a scale") {
  for (const double largest :
       {0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const ArrowScale scale = arrow_scale(largest, "N", arrow_test_camera());
    CHECK(scale.pixels_per_unit > 0);
    CHECK(std::isfinite(scale.pixels_per_unit));
  }
}

TEST_CASE("a label stands at least 6 px beside the middle of its arrow") {
  const ArrowScale scale = {.pixels_per_unit = 10, .longest = 300, .unit = "N"};
  Page page(640, 360, light_theme());
  draw_arrow(page, arrow_test_camera(), scale, {.tail = {0, -0.5}, .value = {0, 10}, .label = "10 N"});
  REQUIRE(page.canvas().text_boxes().size() == 1);
  const Rect rect = page.canvas().text_boxes()[0].rect;
  CHECK(rect.x >= 320 + 6);
  CHECK(std::abs(rect.y + rect.height / 2 - (230 - 50)) <= rect.height / 2);
}

TEST_CASE("labels of arrows side by side do not meet") {
  const ArrowScale scale = {.pixels_per_unit = 10, .longest = 300, .unit = "N"};
  for (const int height : {360, 720}) {
    Page page(16 * height / 9, height, light_theme());
    const Camera camera = {
        .viewport = {0, 0, 16.0 * height / 9, 1.0 * height}, .center = {0, 0}, .scale = 100};
    for (const double x : {-0.3, 0.0, 0.3}) {
      draw_arrow(page, camera, scale, {.tail = {x, 0}, .value = {0, 10}, .label = "10.00 N"});
    }
    const Span<const TextBox> boxes = page.canvas().text_boxes();
    REQUIRE(boxes.size() == 3);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < i; ++j) {
        const Rect a = boxes[i].rect, b = boxes[j].rect;
        const bool apart = a.x + a.width <= b.x + 1 || b.x + b.width <= a.x + 1 ||
                           a.y + a.height <= b.y + 1 || b.y + b.height <= a.y + 1;
        CHECK(apart);
      }
    }
  }
}

TEST_CASE("only bold text of at least 18 px has the arrow's colour") {
  const ArrowScale scale = {.pixels_per_unit = 10, .longest = 300, .unit = "N"};
  for (const int height : {360, 720}) {
    Page page(16 * height / 9, height, light_theme());
    draw_arrow(page, arrow_test_camera(), scale, {.value = {0, 10}, .label = "10 N"});
    draw_arrow(page, arrow_test_camera(), scale,
               {.tail = {1, 0}, .value = {0, 10}, .label = "old", .active = false});
    REQUIRE(page.canvas().text_boxes().size() == 2);
    const TextStyle lit = page.canvas().text_boxes()[0].style;
    CHECK((lit.color.r == page.theme().normal.r) == (lit.bold && lit.size >= 18));
    const TextStyle old = page.canvas().text_boxes()[1].style;
    CHECK(old.color.r == page.theme().secondary_text.r);
  }
}

TEST_CASE("friction's brackets stand at both limits, across its direction") {
  const ArrowScale scale = {.pixels_per_unit = 10, .longest = 300, .unit = "N"};
  Page page(640, 360, light_theme());
  draw_friction_limit(page, arrow_test_camera(), scale, {0, -0.005}, {2, 0}, 9);
  const ArrowTestRun run = arrow_test_run(page.canvas().read(), arrow_test_row, page.theme().background);
  CHECK(std::abs(run.first + 0.5 - (320 - 90)) <= 1.5);
  CHECK(std::abs(run.last + 0.5 - (320 + 90)) <= 1.5);
  CHECK(run.count <= 8);
  const ArrowTestRun height = arrow_test_rows(page.canvas().read(), page.theme().background);
  CHECK(height.last - height.first >= page.sizes().head_width);
}

TEST_CASE("the key shows a round value at the scale") {
  Page page(640, 360, light_theme());
  const ArrowScale scale = {.pixels_per_unit = 2.7, .longest = 300, .unit = "N"};
  draw_scale_key(page, scale, {20, 300});
  REQUIRE(page.canvas().text_boxes().size() == 1);
  CHECK(page.canvas().text_boxes()[0].text == "20 N");
  const Image image = page.canvas().read();
  int last = 0;
  for (int x = 20; x < page.canvas().text_boxes()[0].rect.x - 3; ++x) {
    if (arrow_test_inked(image, x, 295, page.theme().background)) last = x;
  }
  CHECK(std::abs(last + 0.5 - (20 + 20 * 2.7)) <= 1.5);
}

TEST_CASE("what is not finite draws nothing and harms nothing") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ArrowScale scale = {.pixels_per_unit = 10, .longest = 100, .unit = "N"};
  Page page(640, 360, light_theme());
  const List<std::uint8_t> empty = page.canvas().read().pixels;
  draw_arrow(page, arrow_test_camera(), scale, {.value = {nan, 0}, .label = "lost"});
  draw_arrow(page, arrow_test_camera(), scale, {.tail = {nan, 0}, .value = {1, 0}, .label = "lost"});
  draw_arrow(page, arrow_test_camera(), scale,
             {.value = {std::numeric_limits<double>::infinity(), 0}, .label = "lost"});
  draw_friction_limit(page, arrow_test_camera(), scale, {0, 0}, {nan, 0}, 1);
  draw_friction_limit(page, arrow_test_camera(), scale, {0, 0}, {1, 0}, nan);
  draw_scale_key(page, {.pixels_per_unit = 0}, {20, 300});
  CHECK(page.canvas().read().pixels == empty);
}

TEST_CASE("every kind of arrow looks as it did") {
  Page page(640, 360, light_theme());
  const Camera camera = arrow_test_camera();
  const ArrowScale scale = {.pixels_per_unit = 10, .longest = 110, .unit = "N"};
  const List<std::pair<ArrowKind, std::string>> kinds = {
      {ArrowKind::normal, "normal"},     {ArrowKind::negative_correction, "negative"},
      {ArrowKind::friction, "friction"}, {ArrowKind::joint, "joint"},
      {ArrowKind::velocity, "velocity"}, {ArrowKind::external, "external"},
      {ArrowKind::inactive, "old"}};
  for (int i = 0; i < kinds.size(); ++i) {
    const double x = -2.9 + 0.85 * i;
    draw_arrow(page, camera, scale,
               {.kind = kinds[i].first, .tail = {x, 0.1}, .value = {0, 8}, .label = kinds[i].second});
    draw_arrow(page, camera, scale, {.kind = kinds[i].first, .tail = {x, -0.6}, .value = {4, 3}});
    draw_arrow(page, camera, scale, {.kind = kinds[i].first, .tail = {x, -0.8}, .value = {1.5, 0}});
    draw_arrow(page, camera, scale, {.kind = kinds[i].first, .tail = {x, -1.05}, .value = {0.5, 0}});
  }
  draw_arrow(page, camera, scale, {.tail = {-2.9, -1.3}, .value = {40, 0}});
  draw_arrow(page, camera, scale, {.kind = ArrowKind::friction, .tail = {0.5, -1.3}, .value = {5, 0}});
  draw_friction_limit(page, camera, scale, {0.5, -1.3}, {1, 0}, 7);
  draw_scale_key(page, scale, {540, 330});
  test::check_golden("arrows_light", page.canvas().read());
}

}  // namespace cairn::render
