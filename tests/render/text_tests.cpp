// Text: where glyphs stand, what markup does, and what is reported of it.
#include <string_view>

#include "render/font.hpp"
#include "render/markup.hpp"
#include "render/pictures.hpp"

using namespace cairn;
using namespace cairn::render;

namespace {

/// First and last row and column that are not white; empty if all are.
struct InkBounds {
  int left = 1 << 20, top = 1 << 20, right = -1, bottom = -1;
  bool empty() const { return right < 0; }
};

InkBounds ink_of(const Image& image) {
  InkBounds ink;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const int at = 3 * (y * image.width + x);
      if (image.pixels[at] < 255) {
        ink.left = std::min(ink.left, x);
        ink.right = std::max(ink.right, x);
        ink.top = std::min(ink.top, y);
        ink.bottom = std::max(ink.bottom, y);
      }
    }
  }
  return ink;
}

const TextStyle black_text = {.size = 20, .color = {0, 0, 0, 1}};

Image written_picture(std::string_view markup, const TextStyle& style = black_text,
                      const Point& at = {100, 50}) {
  Canvas canvas(200, 100);
  canvas.clear({1, 1, 1, 1});
  canvas.text(at, markup, style);
  return canvas.read();
}

TextStyle aligned(Align align) {
  TextStyle style = black_text;
  style.align = align;
  return style;
}

std::u32string code_points(std::string_view text) {
  std::u32string result;
  while (!text.empty()) {
    result += take_code_point(text);
  }
  return result;
}

}  // namespace

TEST_CASE("the width of two texts in a row is the sum of their widths") {
  const Canvas canvas(10, 10);
  for (const std::string_view second : {"AVTo", "λ_{n} ≥ 0", " ", "x^2"}) {
    const std::string both = "VAmass" + std::string(second);
    CHECK(canvas.text_width(both, black_text) ==
          doctest::Approx(canvas.text_width("VAmass", black_text) + canvas.text_width(second, black_text)));
  }
  CHECK(canvas.text_width("", black_text) == 0);
}

TEST_CASE("the width of a text grows with its size, and all mono signs are equally wide") {
  const Canvas canvas(10, 10);
  TextStyle twice = black_text;
  twice.size = 40;
  CHECK(canvas.text_width("Cairn", twice) == doctest::Approx(2 * canvas.text_width("Cairn", black_text)));
  TextStyle mono = black_text;
  mono.mono = true;
  CHECK(canvas.text_width("iiii", mono) == doctest::Approx(canvas.text_width("MWλ0", mono)));
  mono.bold = true;
  CHECK(canvas.text_width("iiii", mono) == doctest::Approx(canvas.text_width("MWλ0", mono)));
}

TEST_CASE("alignment puts the left end, the centre or the right end at the given place") {
  const double width = Canvas(10, 10).text_width("HIH", black_text);
  const double stem = 2.5;  // the free space before and after an H, at most [px]
  const InkBounds left = ink_of(written_picture("HIH", aligned(Align::left)));
  const InkBounds center = ink_of(written_picture("HIH", aligned(Align::center)));
  const InkBounds right = ink_of(written_picture("HIH", aligned(Align::right)));
  CHECK(left.left >= 100);
  CHECK(left.left <= 100 + stem);
  CHECK(left.right <= 100 + width);
  CHECK(std::abs(0.5 * (center.left + center.right + 1) - 100) <= 0.6);
  CHECK(right.right <= 100);
  CHECK(right.right >= 100 - stem);
  for (const InkBounds& ink : {left, center, right}) {
    CHECK(ink.bottom == 49);  // flat letters stand on the base line, whose y is the first row below them
  }
}

TEST_CASE("a text moved by whole pixels is the same picture moved") {
  const Image here = written_picture("λ = 3.75 N");
  const Image there = written_picture("λ = 3.75 N", black_text, {103, 50});
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x + 3 < 200; ++x) {
      const int from = 3 * (y * 200 + x);
      REQUIRE(here.pixels[from] == there.pixels[from + 9]);
    }
  }
}

TEST_CASE("subscripts stand 0.20 em below the base line, superscripts 0.36 em above it, both at 78 %") {
  const GlyphLine line = lay_out("v_{rel}x^2", 20, Face::regular);
  REQUIRE(line.glyphs.size() == 6);
  CHECK(line.glyphs[0].drop == 0);
  CHECK(line.glyphs[1].drop == doctest::Approx(4));
  CHECK(line.glyphs[3].drop == doctest::Approx(4));
  CHECK(line.glyphs[3].size == doctest::Approx(15.6));
  CHECK(line.glyphs[4].drop == 0);
  CHECK(line.glyphs[4].size == 20);
  CHECK(line.glyphs[5].drop == doctest::Approx(-7.2));
  const InkBounds plain = ink_of(written_picture("v"));
  CHECK(ink_of(written_picture("v_H")).bottom == plain.bottom + 4);
  CHECK(ink_of(written_picture("v^H")).top < plain.top);
}

TEST_CASE("a subscript and a superscript of the same sign stand above each other") {
  const GlyphLine line = lay_out("λ_{n}^{old}=", 20, Face::regular);
  REQUIRE(line.glyphs.size() == 6);
  CHECK(line.glyphs[1].x == line.glyphs[2].x);
  CHECK(line.glyphs[2].drop < line.glyphs[1].drop - 0.78 * 20 * 0.55);  // an x height apart at least
  CHECK(line.glyphs[5].x == doctest::Approx(lay_out("λ^{old}", 20, Face::regular).width));
}

TEST_CASE("a backslash makes the marks literal, a mark at the very end is literal too") {
  const auto letters = [](std::string_view markup) {
    return lay_out(markup, 20, Face::regular).glyphs.size();
  };
  CHECK(letters("warm\\_start") == 10);
  CHECK(lay_out("a\\_b", 20, Face::regular).glyphs[2].drop == 0);
  CHECK(lay_out("2\\^3", 20, Face::regular).glyphs[2].size == 20);
  CHECK(letters("a_") == 2);
  CHECK(letters("\\n") == 2);
  CHECK(letters("a_{bc") == 3);
  CHECK(letters("a_{}b") == 2);
  CHECK(letters("a_λb") == 3);
  CHECK(lay_out("a_λb", 20, Face::regular).glyphs[2].drop == 0);
}

TEST_CASE("a sign that a face lacks comes from the regular face, one that no face has is a box") {
  CHECK(find_glyph(Face::mono, U'λ').face == Face::mono);
  CHECK(find_glyph(Face::regular, U'⊥').index != 0);
  const GlyphName nowhere = find_glyph(Face::bold, char32_t{0x13000});
  CHECK(nowhere.index == 0);
  CHECK(nowhere.face == Face::bold);
  CHECK_FALSE(ink_of(written_picture("\xF0\x93\x80\x80")).empty());
}

TEST_CASE("every sign the lessons write is in the regular, the bold and the mono face") {
  std::string_view signs = "αβγδεζηθικλμνξοπρστυφχψωΓΔΘΛΞΠΣΦΨΩ·×÷±−≤≥≠≈∞√∑∫∂∇→←↑↓⁻¹²³°…–—‖";
  while (!signs.empty()) {
    const char32_t code_point = take_code_point(signs);
    CAPTURE(static_cast<unsigned>(code_point));
    for (const Face face : {Face::regular, Face::bold, Face::mono}) {
      CHECK(find_glyph(face, code_point).index != 0);
    }
  }
}

TEST_CASE("bytes that are not UTF-8 become replacement signs and lose nothing else") {
  CHECK(code_points("aλ⁻😀") == U"aλ⁻😀");
  CHECK(code_points("a\xFFz") == U"a\xFFFDz");
  CHECK(code_points("\xCE") == U"\xFFFD");
  CHECK(code_points("\xC0\x80") == U"\xFFFD\xFFFD");
  CHECK(code_points("\xED\xA0\x80").front() == U'\xFFFD');
  CHECK(code_points("\xE2\x82z") == U"\xFFFD\xFFFDz");
}

TEST_CASE("variables are slanted; words, names, units and numbers are upright") {
  const auto slanted = [](std::string_view markup) {
    std::string signs;
    for (const PlacedGlyph& placed : lay_out(markup, 20, Face::regular).glyphs)
      if (placed.name.slanted) signs += placed.sign;
    return signs;
  };
  struct Line {
    std::string_view markup, slanted;
  };
  for (const Line& line : std::initializer_list<Line>{
           {"v_{rel} of a box a", "v"},
           {"λ_{i} = 2 N", "λi"},
           {"A_{ij} λ_{j} / A_{ii}, Σ_{j≠i}, x_{kin}", "AijλjAiijix"},
           {"R_{E}, Δt (s), step\\_1", "Rt"},
           {"5 mm, μs, Σ λ", "λ"},
           {"t (s)", "t"},
           {"pull a (box), body b, boxes a and b", ""},
           {"v ← v + g Δt,  then  y ← y + v_{y} Δt", "vvgtyyvyt"},
           {"j M⁻¹ jᵀ = max(0, 1/m_{corr})", "jMjm"},
           {"v_{y} = −2.40 m/s", "vy"},
           {"m g = 40 N, at 0.02 s, in 10^{−5} N", "mg"},
           {"40 N s/m, d in N s/m, m = 2 kg", "dm"},
           {"g Δt t/2, t/Δt steps", "gtttt"},
           {"j = (u_{x}, u_{y}, r × u), r = (−0.5, 0) m", "juxuyrur"},
           {"Aλ = b, the row of A, A λ − b", "AλbAAλb"},
           {"A box of 6 kg m², 0.1 N s, (kg m²/s), λ (N s)", "λ"},
           {"A · row 1, column 2", ""},
           {"c = −1 m, |c| in m, c: where", "ccc"},
           {"cos²(π/2n), si x10, 3D, l00", "πn"},
           {"a rod of 5\u00A0m, at 0.02\u00A0s. A\u00A0λ says", "Aλ"},
           {"dc/dt = j·v, Box2D − SI, max(m, 1), 2μg", "ctjvmμg"},
           {"acceleration a = 0.67 m/s², = a pull", "a"},
       }) {
    CAPTURE(line.markup);
    CHECK(slanted(line.markup) == line.slanted);
  }
}

TEST_CASE("a slanted sign leans to the right about its middle, and takes as much room as the upright one") {
  const GlyphLine upright = lay_out("ll", 40, Face::regular), leaning = lay_out("l", 40, Face::regular);
  CHECK(2 * leaning.width == upright.width);
  GlyphAtlas atlas(1);
  const Glyph* const straight = atlas.find({.name = upright.glyphs[0].name, .size = 40});
  const Glyph* const slanted = atlas.find({.name = leaning.glyphs[0].name, .size = 40});
  CHECK(slanted->height == straight->height);
  // An l is as high as 0.76 em and leans by a fifth of it: six pixels.
  CHECK(slanted->width - straight->width >= 5);
  CHECK(slanted->width - straight->width <= 7);
  CHECK(slanted->left < straight->left);
}

TEST_CASE("a text box holds all the ink, is as wide as the text and no higher than need be") {
  Canvas canvas(200, 100);
  for (const std::string_view markup : {"Hqy_{pq}", "λ^{2}", "a b", "‖v‖"}) {
    canvas.clear({1, 1, 1, 1});
    canvas.text({60.3, 50.4}, markup, aligned(Align::center));
    const InkBounds ink = ink_of(canvas.read());
    REQUIRE(canvas.text_boxes().size() == 1);
    const TextBox& box = canvas.text_boxes()[0];
    CHECK(box.text == markup);
    CHECK(box.style.size == 20);
    CHECK(box.rect.x <= ink.left);
    CHECK(box.rect.x + box.rect.width >= ink.right + 1);
    CHECK(box.rect.y <= ink.top);
    CHECK(box.rect.y >= ink.top - 1);
    CHECK(box.rect.y + box.rect.height >= ink.bottom + 1);
    CHECK(box.rect.y + box.rect.height <= ink.bottom + 2);
    CHECK(box.rect.width == doctest::Approx(canvas.text_width(markup, black_text)).epsilon(0.05));
  }
}

TEST_CASE("text boxes are kept in order until the canvas is cleared") {
  Canvas canvas(100, 50);
  canvas.clear({1, 1, 1, 1});
  canvas.text({5, 20}, "first", black_text);
  canvas.text({5, 40}, "second", black_text);
  REQUIRE(canvas.text_boxes().size() == 2);
  CHECK(canvas.text_boxes()[0].text == "first");
  CHECK(canvas.text_boxes()[1].text == "second");
  canvas.clear({1, 1, 1, 1});
  CHECK(canvas.text_boxes().empty());
}

TEST_CASE("a halo keeps the ground around the glyphs clear") {
  TextStyle style = black_text;
  style.halo = {1, 1, 1, 1};
  Canvas canvas(200, 100);
  canvas.clear({0, 0, 0, 1});
  canvas.text({100, 50}, "I", style);
  const Image image = canvas.read();
  const InkBounds letter = ink_of(written_picture("I"));
  const auto brightness = [&](int x, int y) { return image.pixels[3 * (y * 200 + x)]; };
  CHECK(brightness(letter.left - 1, 45) > 240);
  CHECK(brightness(letter.right + 1, 45) > 240);
  CHECK(brightness(letter.left - 8, 45) == 0);
  CHECK(brightness((letter.left + letter.right) / 2, 45) < 60);
}

TEST_CASE("more glyphs than the atlas holds are all drawn") {
  Canvas small(400, 400);
  Canvas full(400, 400);
  const auto line = [](Canvas& canvas) {
    canvas.text({20, 200}, "Cairn λ", {.size = 60, .color = {0, 0, 0, 1}});
  };
  small.clear({1, 1, 1, 1});
  line(small);
  full.clear({1, 1, 1, 1});
  for (int size = 100; size < 300; size += 5) {
    full.text({-5000, 0}, "BGHMQ@", {.size = double(size), .color = {0, 0, 0, 1}});
  }
  line(full);
  for (int size = 100; size < 300; size += 5) {
    full.text({-5000, 0}, "BGHMQ@", {.size = double(size), .color = {0, 0, 0, 1}});
  }
  CHECK(full.read().pixels == small.read().pixels);
}
