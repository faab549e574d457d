// Text on a page: wrapped, put where there is room, and numbers for people.
#include "render/pictures.hpp"
#include "render/text_layout.hpp"

namespace cairn::render {

TEST_CASE("a number is never parted from its unit, unless both are too wide for a line") {
  Page page(640, 360, light_theme());
  const TextStyle style = page.label();
  const std::string text = "it falls at 0.2 m/s, gets 3 N s and 10 % of 4 boxes";
  for (double width = page.canvas().text_width("0.2 m/s,", style); width < 300; width += 7) {
    for (const std::string& line : wrapped(page.canvas(), text, width, style)) {
      CAPTURE(line);
      CHECK((!line.ends_with("0.2") && !line.ends_with("3") && !line.ends_with("3 N") &&
             !line.ends_with("10")));
    }
  }
  CHECK(wrapped(page.canvas(), "4 boxes", page.canvas().text_width("boxes", style), style).size() == 2);
}

TEST_CASE("wrapped lines fit their width and hold every word in order") {
  Page page(640, 360, light_theme());
  const TextStyle style = page.label();
  const std::string text =
      "the top box pushes λ_{2 3} and the middle box pushes back, without_a_space_anywhere_to_be_found";
  for (const double width : {400.0, 150.0, 60.0}) {
    std::string joined;
    for (const std::string& line : wrapped(page.canvas(), text, width, style)) {
      CAPTURE(line);
      CHECK(page.canvas().text_width(line, style) <= width);
      joined += line;
    }
    std::string expected = text, found = joined;
    std::erase(expected, ' ');
    std::erase(found, ' ');
    CHECK(found == expected);
  }
}

TEST_CASE("text is cut behind whole characters and markup, and only when it must be") {
  Page page(640, 360, light_theme());
  const TextStyle style = page.label();
  const std::string text = "λ_{12} → v";
  const double width = page.canvas().text_width(text, style);
  CHECK(ellipsized(page.canvas(), text, width, style) == text);
  const std::string cut = ellipsized(page.canvas(), text, page.canvas().text_width("λ_{12}…", style), style);
  CHECK(cut == "λ_{12}…");
  CHECK(ellipsized(page.canvas(), text, page.canvas().text_width("λ_{1}…", style), style) == "λ…");
  CHECK(ellipsized(page.canvas(), text, 1, style).empty());
}

TEST_CASE("a paragraph's height is its number of lines times the pitch of one") {
  Page page(640, 360, light_theme());
  const TextStyle style = page.label();
  const double one = page.paragraph({20, 60}, 600, "short", style);
  CHECK(one >= style.size);
  CHECK(page.paragraph({20, 90}, 600, "first\nsecond\nthird", style) == 3 * one);
  const double width = page.canvas().text_width("four of these", style);
  const double narrow = page.paragraph({20, 200}, width, "four of these four of these", style);
  CHECK(narrow == 2 * one);
}

TEST_CASE("text takes the first place that is free and inside, and the first of all when none is") {
  Page page(640, 360, light_theme());
  const TextStyle style = page.label();
  const Rect within = {100, 100, 200, 100};
  page.canvas().text({120, 150}, "taken", style);
  page.place_text({{120, 150}, {90, 130}, {200, 150}, {120, 190}}, within, "label", style);
  REQUIRE(page.canvas().text_boxes().size() == 2);
  CHECK(page.canvas().text_boxes()[1].rect.x == doctest::Approx(200).epsilon(0.01));
  page.place_text({{120, 150}, {90, 130}}, within, "crowd", style);
  REQUIRE(page.canvas().text_boxes().size() == 3);
  CHECK(page.canvas().text_boxes()[2].rect.x == doctest::Approx(120).epsilon(0.01));
  page.place_text({}, within, "nowhere", style);
  CHECK(page.canvas().text_boxes().size() == 3);
}

TEST_CASE("text keeps off lines where it can, and stands on one rather than leave its room") {
  Page page(640, 360, light_theme());
  const TextStyle style = page.label();
  const Rect within = {100, 100, 200, 100};
  page.avoid({{110, 100}, {130, 200}});
  page.note_curve({{100, 185}, {300, 185}});
  page.place_text({{105, 150}, {105, 190}, {200, 150}}, within, "label", style);
  REQUIRE(page.canvas().text_boxes().size() == 1);
  CHECK(page.canvas().text_boxes()[0].rect.x == doctest::Approx(200).epsilon(0.01));
  page.place_text({{500, 150}, {105, 150}}, within, "other", style);
  REQUIRE(page.canvas().text_boxes().size() == 2);
  CHECK(page.canvas().text_boxes()[1].rect.x == doctest::Approx(105).epsilon(0.02));
}

TEST_CASE("fixed numbers have their decimals, a true minus, and no negative zero") {
  CHECK(fixed(3.14159, 2) == "3.14");
  CHECK(fixed(-0.15, 3) == "−0.150");
  CHECK(fixed(5, 0) == "5");
  CHECK(fixed(-0.0, 2) == "0.00");
  CHECK(fixed(-0.004, 2) == "0.00");
  CHECK(fixed(-0.006, 2) == "−0.01");
  CHECK(fixed(3.75, 2, Sign::always) == "+3.75");
  CHECK(fixed(-3.75, 2, Sign::always) == "−3.75");
  CHECK(fixed(0.001, 2, Sign::always) == "0.00");
  CHECK(fixed(12345.678, 1) == "12345.7");
}

TEST_CASE("numbers that are none are written as such") {
  const double infinity_value = std::numeric_limits<double>::infinity();
  CHECK(fixed(std::numeric_limits<double>::quiet_NaN(), 2) == "NaN");
  CHECK(fixed(infinity_value, 2) == "∞");
  CHECK(fixed(infinity_value, 2, Sign::always) == "+∞");
  CHECK(fixed(-infinity_value, 2) == "−∞");
  CHECK(significant(std::numeric_limits<double>::quiet_NaN()) == "NaN");
  CHECK(significant(-infinity_value) == "−∞");
  CHECK(fixed(std::numeric_limits<double>::max(), 2).size() == 309 + 3);
}

TEST_CASE("significant digits: as many as asked for, plain where people write them plain") {
  CHECK(significant(0) == "0");
  CHECK(significant(-0.0) == "0");
  CHECK(significant(3.14159) == "3.14");
  CHECK(significant(2.5) == "2.5");
  CHECK(significant(10) == "10");
  CHECK(significant(-0.01234) == "−0.0123");
  CHECK(significant(9.999) == "10");
  CHECK(significant(0.0001) == "0.0001");
  CHECK(significant(1886) == "1890");
  CHECK(significant(1886, 4) == "1886");
  CHECK(significant(1.1e-13) == "1.1×10^{−13}");
  CHECK(significant(-2e7) == "−2×10^{7}");
  CHECK(significant(6.0221e23, 4) == "6.022×10^{23}");
}

}  // namespace cairn::render
