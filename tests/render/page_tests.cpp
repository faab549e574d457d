// The layout of a page: zones, header and footer, panels with equations, tables and questions.
#include "render/pictures.hpp"

namespace cairn::render {

namespace {

bool page_test_overlap(const Rect& a, const Rect& b) {
  return std::min(a.x + a.width, b.x + b.width) - std::max(a.x, b.x) > 1 &&
         std::min(a.y + a.height, b.y + b.height) - std::max(a.y, b.y) > 1;
}

bool page_test_inside(const Rect& inner, const Rect& outer) {
  return inner.x >= outer.x && inner.y >= outer.y && inner.x + inner.width <= outer.x + outer.width &&
         inner.y + inner.height <= outer.y + outer.height;
}

/// Every text lies within `outer`, none meets another, none is below 12 px.
void page_test_check_texts(const Page& page, const Rect& outer) {
  const Span<const TextBox> boxes = page.canvas().text_boxes();
  for (int i = 0; i < boxes.size(); ++i) {
    CAPTURE(boxes[i].text);
    CHECK(page_test_inside(boxes[i].rect, outer));
    CHECK(boxes[i].style.size >= 12);
    for (int j = 0; j < i; ++j) {
      CAPTURE(boxes[j].text);
      CHECK_FALSE(page_test_overlap(boxes[i].rect, boxes[j].rect));
    }
  }
}

Rect page_test_rect(const Page& page) {
  return {0, 0, static_cast<double>(page.canvas().width()), static_cast<double>(page.canvas().height())};
}

Equation page_test_equation() {
  return {.number = "eq (22)",
          .symbols = "λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)",
          .numbers = "= (0 − (−0.150)) / (2 × 0.02)",
          .result = "= 3.75 N",
          .algorithm = "Algorithm 1, line 13:  λ₂: 5.00 → 8.75",
          .color = light_theme().normal};
}

TableView page_test_table(int count) {
  TableView table;
  table.header = {"row", "λ (N)", "Δλ (N)", "v (m/s)"};
  for (int i = 0; i < count; ++i) {
    table.rows.push_back({"row " + std::to_string(i + 1), fixed(1.25 * i, 2),
                          fixed(-0.5 * i, 2, Sign::always), fixed(0.1 * i, 3)});
  }
  return table;
}

}  // namespace

TEST_CASE("a page that is too small is refused") {
  CHECK_THROWS_AS(Page(319, 360, light_theme()), std::invalid_argument);
  CHECK_THROWS_AS(Page(640, 179, light_theme()), std::invalid_argument);
}

TEST_CASE("the body lies between header and footer, inside the margins, at every size") {
  for (const auto& [width, height] : {std::pair{320, 180}, {640, 360}, {960, 540}, {1280, 720}}) {
    const Page page(width, height, light_theme());
    const Sizes& sizes = page.sizes();
    const Rect area = page.area();
    CHECK(area.x == sizes.margin);
    CHECK(area.width == width - 2 * sizes.margin);
    CHECK(area.y >= sizes.header);
    CHECK(area.y + area.height <= height - sizes.footer);
    CHECK(area.height > 0.6 * height);
    CHECK(page.compact() == (height < 540));
  }
}

TEST_CASE("columns and rows with their gaps fill the whole, by their weights") {
  const Rect all = {10, 20, 310, 200};
  const List<Rect> three = columns(all, {1, 2, 3}, 5);
  REQUIRE(three.size() == 3);
  const double unit = (310 - 2 * 5) / 6.0;
  CHECK(three[0].x == 10);
  CHECK(three[0].width == doctest::Approx(unit));
  CHECK(three[1].x == doctest::Approx(10 + unit + 5));
  CHECK(three[1].width == doctest::Approx(2 * unit));
  CHECK(three[2].x + three[2].width == doctest::Approx(10 + 310));
  const List<Rect> two = rows(all, {3, 1}, 8);
  REQUIRE(two.size() == 2);
  CHECK(two[0].height == doctest::Approx(3 * (200 - 8) / 4.0));
  CHECK(two[1].y == doctest::Approx(20 + two[0].height + 8));
  CHECK(two[1].y + two[1].height == doctest::Approx(20 + 200));
  CHECK(two[1].x == 10);
  CHECK(two[1].width == 310);
  CHECK(columns(all, {}, 5).empty());
  CHECK_THROWS_AS(columns(all, {0, 0}, 5), std::invalid_argument);
}

TEST_CASE("an inset takes as much from every side, and never turns a rectangle inside out") {
  const Rect inner = inset({10, 20, 100, 50}, 8);
  CHECK(inner.x == 18);
  CHECK(inner.y == 28);
  CHECK(inner.width == 84);
  CHECK(inner.height == 34);
  CHECK(inset({0, 0, 10, 10}, 8).width == 0);
}

TEST_CASE("title and state share the header without meeting, however long they are") {
  const std::string words = "sweep 2/10 · row 2 of 3 · ";
  for (const auto& [width, height] : {std::pair{320, 180}, {640, 360}, {1280, 720}}) {
    Page page(width, height, light_theme());
    for (const std::string& state : {words, words + words, words + words + words + words}) {
      for (const std::string& title :
           {std::string("Rows"), std::string("Sequential impulses and their long title"),
            words + words + words + words}) {
        page.begin({.number = "06", .title = title, .state = state, .frame = 3, .frames = 30});
        const Rect header = {page.sizes().margin, 0, width - 2 * page.sizes().margin, page.sizes().header};
        CHECK(page.canvas().text_boxes().size() == 3);
        page_test_check_texts(page, inset(header, -1));
      }
    }
  }
}

TEST_CASE("a title and a state that have room are written whole") {
  Page page(1280, 720, light_theme());
  page.begin({.number = "06", .title = "Sequential impulses", .state = "sweep 2/10 · row 2 of 3"});
  CHECK(is_written(page, "Sequential impulses"));
  REQUIRE(find_text(page.canvas().text_boxes(), "sweep 2/10 · row 2 of 3") != nullptr);
  CHECK(find_text(page.canvas().text_boxes(), "sweep 2/10 · row 2 of 3")->style.size == page.sizes().state);
}

TEST_CASE("the dot of the scrubber stands where the frame is in the sequence") {
  Page page(640, 360, light_theme());
  const int frames = 31;
  for (const int frame : {0, 12, 30}) {
    page.begin({.title = "Rows", .frame = frame, .frames = frames});
    const Image image = page.canvas().read();
    const Color dark = page.theme().secondary_text;
    const double y = 360 - page.sizes().footer / 2;
    const double above = y - 3;  // inside the dot, above line and progress
    double sum = 0, count = 0;
    for (int x = 0; x < 640; ++x) {
      const int at = 3 * (static_cast<int>(above) * 640 + x);
      if (std::abs(image.pixels[at] - 255 * dark.r) < 12) sum += x + 0.5, count += 1;
    }
    REQUIRE(count > 0);
    const double margin = page.sizes().margin;
    const double expected = margin + (640 - 2 * margin) * frame / (frames - 1);
    CHECK(std::abs(sum / count - expected) <= 1);
  }
}

TEST_CASE("an equation stays inside its panel, from a large one to one too small for its size") {
  Page page(640, 360, light_theme());
  for (const double width : {620.0, 320.0, 200.0, 140.0}) {
    page.begin({.title = "Rows"});
    const Rect panel = {10, 40, width, 280};
    page.equation(panel, page_test_equation());
    const Span<const TextBox> boxes = page.canvas().text_boxes();
    for (int i = 1; i < boxes.size(); ++i) {
      CAPTURE(boxes[i].text);
      CHECK(page_test_inside(boxes[i].rect, panel));
    }
    page_test_check_texts(page, page_test_rect(page));
  }
}

TEST_CASE("a result has its colour only in bold of at least 18 px") {
  for (const double width : {620.0, 280.0}) {
    Page page(1280, 720, light_theme());
    page.equation({20, 60, width, 300}, page_test_equation());
    const TextBox* result = find_text(page.canvas().text_boxes(), "= 3.75 N");
    REQUIRE(result != nullptr);
    CHECK(result->style.bold);
    const bool colored = result->style.color.r == page.theme().normal.r;
    CHECK(colored == (result->style.size >= 18));
    CHECK((result->style.size >= 18) == (width > 500));
  }
}

TEST_CASE("a table shows every row when there is room, its numbers right-aligned") {
  Page page(1280, 720, light_theme());
  const Rect panel = {640, 64, 620, 320};
  page.table(panel, "rows", page_test_table(6));
  page_test_check_texts(page, panel);
  const TextBox* first = find_text(page.canvas().text_boxes(), "1.25");
  const TextBox* second = find_text(page.canvas().text_boxes(), "6.25");
  REQUIRE(first != nullptr);
  REQUIRE(second != nullptr);
  CHECK(first->rect.x + first->rect.width == doctest::Approx(second->rect.x + second->rect.width));
  CHECK(first->style.mono);
}

TEST_CASE("a table too long for its panel shows the last rows, or those from the active one on") {
  Page page(640, 360, light_theme());
  const Rect panel = {320, 40, 310, 130};
  TableView table = page_test_table(40);
  page.table(panel, "rows", table);
  page_test_check_texts(page, panel);
  CHECK(is_written(page, "row 40"));
  CHECK(!is_written(page, "row 1"));
  page.begin({});
  table.active_row = 4;
  page.table(panel, "rows", table);
  CHECK(is_written(page, "row 5"));
  CHECK(!is_written(page, "row 40"));
}

TEST_CASE("a table too wide for its panel is cut with an ellipsis and stays inside") {
  Page page(640, 360, light_theme());
  const Rect panel = {10, 40, 130, 200};
  page.table(panel, "a title that is longer than the panel is wide", page_test_table(4));
  page_test_check_texts(page, panel);
}

TEST_CASE("a question is wrapped at words and stays inside its panel") {
  Page page(640, 360, light_theme());
  const Rect panel = {10, 40, 300, 140};
  page.note(
      panel, "question",
      "After the first sweep, which boxes still move, and how fast? Think of who has been pushed by whom.");
  page_test_check_texts(page, panel);
  CHECK(page.canvas().text_boxes().size() > 3);
}

TEST_CASE("a card is as high as its text, and returns the room below it") {
  Page page(1280, 720, light_theme());
  const Rect room = {10, 40, 300, 600};
  const Rect below_short = page.card(room, "answer", "No.");
  const Rect below_long =
      page.card(room, "answer", "No, since the mass cancels: it stands on both sides of the equation.");
  for (const Rect& below : {below_short, below_long}) {
    CHECK(below.y + below.height == doctest::Approx(room.y + room.height));
    CHECK(below.x == room.x);
    CHECK(below.width == room.width);
  }
  CHECK(below_long.y > below_short.y + page.sizes().question);
  const TextBox* word = find_text(page.canvas().text_boxes(), "No.");
  REQUIRE(word != nullptr);
  CHECK(word->rect.y + word->rect.height + page.sizes().padding / 2 < below_short.y);
  const Rect small = {10, 40, 300, 60};
  CHECK(page.card(small, "answer", "No, since the mass cancels: it stands on both sides.").height >= 0);
}

TEST_CASE("a new frame forgets the curves of the last one") {
  Page page(640, 360, light_theme());
  page.note_curve({{0, 0}, {1, 1}});
  CHECK(page.curves().size() == 1);
  page.begin({});
  CHECK(page.curves().empty());
}

TEST_CASE("the same page drawn twice has the same pixels") {
  Page page(640, 360, light_theme());
  List<std::uint8_t> first;
  for (int i = 0; i < 2; ++i) {
    page.begin({.number = "06", .title = "Rows", .state = "sweep 1/10", .frame = 2, .frames = 9});
    page.equation({320, 40, 310, 140}, page_test_equation());
    page.table({320, 190, 310, 140}, "rows", page_test_table(5));
    if (i == 0) first = page.canvas().read().pixels;
  }
  CHECK(page.canvas().read().pixels == first);
}

TEST_CASE("a page looks as it did, light and dark") {
  for (const bool dark : {false, true}) {
    Page page(640, 360, dark ? dark_theme() : light_theme());
    page.begin({.number = "06",
                .title = "Sequential impulses",
                .state = "sweep 2/10 · row 2 of 3",
                .frame = 5,
                .frames = 31});
    const List<Rect> halves = columns(page.area(), {1, 1}, page.sizes().gap);
    const List<Rect> right = rows(halves[1], {1, 1}, page.sizes().gap);
    TableView table = page_test_table(5);
    table.active_row = 1;
    page.note(halves[0], "question", "After the first sweep, which boxes still move, and how fast?");
    page.table(right[0], "accumulated λ", table);
    page.equation(right[1], page_test_equation());
    page_test_check_texts(page, page_test_rect(page));
    test::check_golden(dark ? "page_dark" : "page_light", page.canvas().read());
  }
}

}  // namespace cairn::render
