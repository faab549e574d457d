// The layout lint: a page that obeys every rule, and one page for each rule that breaks it.
#include "render/pictures.hpp"

namespace cairn::render {

namespace {

TextStyle lint_test_style() { return {.size = 16, .color = light_theme().text}; }

// What lint says about a page that `draw` has drawn on.
template <typename Draw>
List<std::string> lint_of(Draw draw) {
  Page page(640, 360, light_theme());
  page.canvas().clear(page.theme().background);
  draw(page);
  return lint(page);
}

template <typename Draw>
void check_one_fault(Draw draw, const std::string& words) {
  const List<std::string> faults = lint_of(draw);
  REQUIRE(faults.size() == 1);
  CAPTURE(faults[0]);
  CHECK(faults[0].find(words) != std::string::npos);
  CHECK(faults[0].find("\"λ = 3\"") != std::string::npos);
}

}  // namespace

TEST_CASE("a page with header, panel, table and footer has no fault of layout") {
  for (const int height : {360, 720}) {
    for (const Theme& theme : {light_theme(), dark_theme()}) {
      Page page(height * 16 / 9, height, theme);
      page.begin({.number = "06", .title = "Rows", .state = "row 2 of 3", .frame = 1, .frames = 5});
      const List<Rect> parts = rows(page.area(), {1, 1}, page.sizes().gap);
      page.table(parts[0], "speeds (m/s)", {.header = {"body", "v"}, .rows = {{"1", "0.25"}, {"2", "−3"}}});
      page.note(parts[1], "Predict", "Which of the boxes comes to rest first, and why?");
      CHECK(lint(page).empty());
    }
  }
}

TEST_CASE("lint names text that leaves the page on any side") {
  for (const Point& at : {Point(-5, 100), Point(620, 100), Point(100, 5), Point(100, 364)}) {
    check_one_fault([&](Page& page) { page.canvas().text(at, "λ = 3", lint_test_style()); },
                    "outside the page");
  }
}

TEST_CASE("lint names two texts of which one stands on the other") {
  check_one_fault(
      [](Page& page) {
        page.canvas().text({100, 100}, "λ = 3", lint_test_style());
        page.canvas().text({120, 104}, "other", lint_test_style());
      },
      "overlaps text \"other\"");
}

TEST_CASE("lint allows texts side by side and line under line") {
  const auto faults = lint_of([](Page& page) {
    const double width = page.canvas().text_width("λ = 3", lint_test_style());
    page.canvas().text({100, 100}, "λ = 3", lint_test_style());
    page.canvas().text({100 + width, 100}, "beside", lint_test_style());
    page.canvas().text({100, 120}, "below", lint_test_style());
    page.canvas().text({100, 100}, "", lint_test_style());
  });
  CHECK(faults.empty());
}

TEST_CASE("lint names text below 12 px") {
  TextStyle small = lint_test_style();
  small.size = 11.5;
  check_one_fault([&](Page& page) { page.canvas().text({100, 100}, "λ = 3", small); }, "11.5 px high");
  small.size = 12;
  CHECK(lint_of([&](Page& page) { page.canvas().text({100, 100}, "λ = 3", small); }).empty());
}

TEST_CASE("lint names pale text, and asks less of bold text of 18 px") {
  TextStyle orange = lint_test_style();  // 3.7 : 1 on the light background
  orange.color = light_theme().normal;
  check_one_fault([&](Page& page) { page.canvas().text({100, 100}, "λ = 3", orange); }, "contrast of 3.");
  orange.bold = true;
  check_one_fault([&](Page& page) { page.canvas().text({100, 100}, "λ = 3", orange); }, "less than 4.5");
  orange.size = 18;
  CHECK(lint_of([&](Page& page) { page.canvas().text({100, 100}, "λ = 3", orange); }).empty());
}

TEST_CASE("lint sees that a translucent text is paler than its colour") {
  TextStyle faint = lint_test_style();
  faint.color = faded(faint.color, 0.4);
  check_one_fault([&](Page& page) { page.canvas().text({100, 100}, "λ = 3", faint); }, "contrast");
}

TEST_CASE("lint judges text with a halo against its halo") {
  TextStyle white = lint_test_style();
  white.color = rgb(0xFFFFFF);
  check_one_fault([&](Page& page) { page.canvas().text({100, 100}, "λ = 3", white); }, "contrast");
  white.halo = rgb(0x0072B2);
  CHECK(lint_of([&](Page& page) { page.canvas().text({100, 100}, "λ = 3", white); }).empty());
  TextStyle black = lint_test_style();
  black.halo = rgb(0x202020);
  check_one_fault([&](Page& page) { page.canvas().text({100, 100}, "λ = 3", black); }, "contrast");
}

TEST_CASE("lint names text that a curve crosses, unless it has a halo") {
  TextStyle style = lint_test_style();
  const auto crossed = [&style](Page& page) {
    page.canvas().text({300, 100}, "λ = 3", style);
    page.note_curve({Point(0, 95), Point(640, 96)});  // both ends far from the text
  };
  check_one_fault(crossed, "on a curve");
  style.halo = light_theme().background;
  CHECK(lint_of(crossed).empty());
}

TEST_CASE("lint allows text beside a curve and in its gaps") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto faults = lint_of([&](Page& page) {
    page.canvas().text({300, 100}, "λ = 3", lint_test_style());
    page.note_curve({Point(0, 130), Point(640, 130)});
    page.note_curve({Point(290, 0), Point(290, 360)});
    page.note_curve({Point(200, 0), Point(200, 200), Point(640, 330)});
    page.note_curve({Point(0, 95), Point(nan, nan), Point(640, 95)});
    page.note_curve({Point(310, 95)});  // one point is no line
    page.note_curve({});
  });
  CHECK(faults.empty());
}

TEST_CASE("contrast is 21 between black and white, 1 with itself and the same both ways") {
  CHECK(contrast(rgb(0x000000), rgb(0xFFFFFF)) == doctest::Approx(21));
  CHECK(contrast(rgb(0x336699), rgb(0x336699)) == doctest::Approx(1));
  CHECK(contrast(rgb(0xD55E00), rgb(0xFFFFFF)) == contrast(rgb(0xFFFFFF), rgb(0xD55E00)));
  // Pure red has luminance 0.2126: (1 + 0.05) / (0.2126 + 0.05).
  CHECK(contrast(rgb(0xFF0000), rgb(0xFFFFFF)) == doctest::Approx(1.05 / 0.2626));
}

TEST_CASE("black or white ink reads well upon any fill") {
  for (std::uint32_t r = 0; r <= 255; r += 15) {
    for (std::uint32_t g = 0; g <= 255; g += 15) {
      for (std::uint32_t b = 0; b <= 255; b += 51) {
        const Color fill = rgb(r << 16 | g << 8 | b);
        CHECK(contrast(ink_on(fill), fill) >= 4.5);
      }
    }
  }
}

}  // namespace cairn::render
