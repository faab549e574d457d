// A frame in vectors: what a canvas draws is in the file, where it was drawn.
#include "render/pictures.hpp"
#include "render/svg.hpp"

namespace cairn::render {
namespace {

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// What a canvas of 200 x 100 px draws by `draw`, as a file.
template <typename Draw>
std::string drawn(const Draw& draw, Letters letters = Letters::outlines) {
  Canvas canvas(200, 100);
  SvgDrawing drawing(letters);
  canvas.record(&drawing);
  canvas.clear(rgb(0xFFFFFF));
  draw(canvas);
  return drawing.file({0, 0, 200, 100}, rgb(0xFFFFFF), "a < b & \"c\"");
}

const Paint red = {.fill = rgb(0xFF0000), .outline = faded(rgb(0x0000FF), 0.5), .outline_width = 3};

}  // namespace

TEST_CASE("an SVG file has the size of its view, a title and its background") {
  const std::string file = drawn([](Canvas&) {});
  CHECK(file.find("viewBox=\"0 0 200 100\" width=\"200\" height=\"100\"") != std::string::npos);
  CHECK(file.find("<title>a &lt; b &amp; &quot;c&quot;</title>") != std::string::npos);
  CHECK(file.find("<rect x=\"0\" y=\"0\" width=\"200\" height=\"100\" fill=\"#ffffff\"/>") !=
        std::string::npos);
  CHECK(count(SvgDrawing().file({0, 0, 9, 9}, transparent, ""), "<rect") == 0);
}

TEST_CASE("shapes keep their places and paints") {
  const std::string file = drawn([](Canvas& canvas) {
    canvas.circle({30, 40}, 5, red);
    canvas.rect({1, 2, 30, 40}, red);
    canvas.polygon(FixedList<Point, 3>{Point(10, 10), Point(10, 30), Point(30, 10)}, red, 2);
    canvas.line({1, 2}, {3, 4}, {.width = 1.5, .color = rgb(0x00FF00), .dash = {4, 2}});
  });
  const std::string paint = "fill=\"#ff0000\" stroke=\"#0000ff\" stroke-opacity=\"0.5\" stroke-width=\"3\"/>";
  CHECK(file.find("<circle cx=\"30\" cy=\"40\" r=\"5\" " + paint) != std::string::npos);
  CHECK(file.find("<path d=\"M1 2L31 2L31 42L1 42Z\" " + paint) != std::string::npos);
  // Grown by 2 px: the upper side lies at y = 8, the left at x = 8, and there is an arc at each corner.
  CHECK(file.find("L30 8A2 2 0 0 1 ") != std::string::npos);
  CHECK(count(file, "A2 2 0 0 1 ") == 3);
  CHECK(file.find("<path d=\"M1 2L3 4\" fill=\"none\" stroke=\"#00ff00\" stroke-width=\"1.5\" "
                  "stroke-linejoin=\"round\" stroke-dasharray=\"4 2\"/>") != std::string::npos);
}

TEST_CASE("hatching is cut at the edge of its polygon") {
  const std::string file = drawn([](Canvas& canvas) {
    canvas.hatch(FixedList<Point, 4>{Point(10, 10), Point(30, 10), Point(30, 30), Point(10, 30)},
                 {.width = 1, .color = rgb(0)}, 10);
  });
  // x + y = 20 touches a corner only; 30, 40 and 50 cross the square, and 60 touches the last corner.
  for (const char* line : {"M20 10L10 20", "M30 10L10 30", "M30 20L20 30"}) {
    CAPTURE(line);
    CHECK(file.find(line) != std::string::npos);
  }
}

TEST_CASE("each sign has its outline once, and stands once for each time that it is written") {
  const std::string file = drawn([](Canvas& canvas) {
    canvas.text({10, 20}, "abba", {.size = 16, .color = rgb(0)});
    canvas.text({10, 50}, "ab", {.size = 16, .color = rgb(0), .halo = rgb(0xFFFFFF)});
  });
  CHECK(count(file, "<path id=\"g") == 2);
  CHECK(count(file, "<use ") == 4 + 2 * 2);  // the halo is a layer of its own
  CHECK(file.find("translate(10 20)") != std::string::npos);
}

TEST_CASE("text is text where that is asked for, as wide as it is drawn") {
  const TextStyle style{.size = 16, .color = rgb(0), .bold = true};
  double width = 0;
  const std::string file = drawn(
      [&](Canvas& canvas) {
        canvas.text({10, 20}, "ab < cd", style);
        width = canvas.text_width("ab < cd", style);
      },
      Letters::text);
  CHECK(count(file, "<use") == 0);
  CHECK(count(file, "<path") == 0);
  CHECK(file.find("<text xml:space=\"preserve\" fill=\"#000000\" x=\"10\" y=\"20\" "
                  "font-family=\"DejaVu Sans, Verdana, Helvetica, sans-serif\" font-weight=\"bold\" "
                  "font-size=\"16\" textLength=\"") != std::string::npos);
  CHECK(file.find(">ab &lt; cd</text>") != std::string::npos);
  const std::size_t length = file.find("textLength=\"") + 12;
  CHECK(std::stod(file.substr(length)) == doctest::Approx(width).epsilon(0.001));
}

TEST_CASE("scripts are parts of their text, smaller and beside the base line, and a halo is no second text") {
  const std::string file = drawn(
      [](Canvas& canvas) {
        canvas.text(
            {100, 20}, "λ_{rel}^2 = \xFF",
            {.size = 20, .color = rgb(0), .mono = true, .align = Align::right, .halo = rgb(0xFFFFFF)});
      },
      Letters::text);
  CHECK(count(file, "<text ") == 1);
  CHECK(count(file, "<tspan ") == 4);
  CHECK(file.find("stroke=\"#ffffff\"") < file.find("paint-order=\"stroke\""));
  CHECK(count(file, "font-family=\"DejaVu Sans Mono, Menlo, Consolas, monospace\"") == 4);
  std::string text;  // without marks
  for (std::size_t at = file.find("<text "), end = file.find("</text>"); at < end; ++at) {
    if (file[at] == '<') at = file.find('>', at);
    if (file[at] != '>') text += file[at];
  }
  CHECK(text == "λrel2 = \uFFFD");
  CHECK(count(file, "font-size=\"15.6\"") == 2);  // 0.78 em
}

TEST_CASE("a drawing of text forgets its shapes, and not that it is one of text") {
  const std::string file = drawn(
      [](Canvas& canvas) {
        canvas.text({10, 20}, "earlier", {.size = 16, .color = rgb(0)});
        canvas.clear(rgb(0xFFFFFF));
        canvas.text({10, 20}, "later", {.size = 16, .color = rgb(0)});
      },
      Letters::text);
  CHECK(file.find("earlier") == std::string::npos);
  CHECK(file.find(">later</text>") != std::string::npos);
}

TEST_CASE("a clip holds what is drawn between push and pop") {
  const std::string file = drawn([](Canvas& canvas) {
    canvas.push_clip({10, 20, 30, 40});
    canvas.circle({30, 40}, 5, red);
    canvas.pop_clip();
  });
  const std::size_t open = file.find("<g clip-path=\"url(#c1)\">");
  CHECK(file.find("<clipPath id=\"c1\"><rect x=\"10\" y=\"20\" width=\"30\" height=\"40\"/>") !=
        std::string::npos);
  CHECK(open < file.find("<circle"));
  CHECK(file.find("<circle") < file.find("</g>", open));
  CHECK(count(file, "<g") == count(file, "</g>"));
}

TEST_CASE("a drawing leaves out what is not finite, forgets at clear(), and changes no pixel") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto draw = [nan](Canvas& canvas) {
    canvas.clear(rgb(0xFFFFFF));
    canvas.line({nan, 0}, {10, 10}, {.width = 1, .color = rgb(0), .dash = {}});
    canvas.circle({30, 40}, nan, red);
    canvas.text({50, 50}, "λ", {.size = 16, .color = rgb(0)});
  };
  CHECK(drawn(draw).find("nan") == std::string::npos);
  Canvas plain(200, 100), recorded(200, 100);
  SvgDrawing drawing;
  recorded.record(&drawing);
  recorded.circle({30, 40}, 5, red);
  draw(plain);
  draw(recorded);
  CHECK(drawing.file({0, 0, 1, 1}, transparent, "").find("<circle") == std::string::npos);
  CHECK(plain.read().pixels == recorded.read().pixels);
}

}  // namespace cairn::render
