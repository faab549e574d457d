// Bars as pictures: their lengths in pixels, read back.
#include "render/bars.hpp"
#include "render/pictures.hpp"

namespace cairn::render {

namespace {

PagePicture bars_of(const BarChart& chart, const Theme& theme = light_theme(),
                    const Rect& room = {0, 0, 640, 360}) {
  return picture_of_page(theme, [&](Page& page) { draw_bars(page, room, chart); });
}

bool bar_pixel_is(const Image& image, int x, int y, Color color) {
  return worst_off(image, x, y, color) <= 1.5;
}

// Without names and title of text, row `row` of `rows` has its middle here.
int middle_row(int row, int rows) {
  const double room = 360 - 2 * sizes_for(360).padding;
  const double pitch = std::min(84.0, room / rows);
  return static_cast<int>(std::lround(180 + pitch * (row + 0.5 - rows / 2.0)));
}

struct Run {
  int begin = 0;
  int end = 0;  // behind the last
};

// From the first to behind the last pixel of this colour in a line of pixels; empty if there is none.
Run run_of(const Image& image, int y, Color color) {
  Run run;
  for (int x = 0; x < image.width; ++x) {
    if (!bar_pixel_is(image, x, y, color)) continue;
    if (run.end == 0) run.begin = x;
    run.end = x + 1;
  }
  return run;
}

Run grey_run(const Image& image, int row, int rows) {
  return run_of(image, middle_row(row, rows), light_theme().inactive);
}

BarChart worked_chart() {
  BarChart chart = {.title = "accumulated λ (N)", .largest = 33};
  chart.bars.push_back({.name = "row 1", .before = 15, .exact = 30});
  chart.bars.push_back({.name = "row 2", .before = 5, .added = 3.75, .exact = 20, .active = true});
  chart.bars.push_back({.name = "row 3", .before = 12.5, .added = -4, .exact = 10});
  return chart;
}

BarChart crowded_chart(int count) {
  BarChart chart = {.title = "accumulated λ (N s)"};
  for (int i = 0; i < count; ++i) {
    chart.bars.push_back({.name = "row " + std::to_string(i + 1),
                          .before = 10 - 0.5 * i,
                          .added = 0.3 * i - 1.05,
                          .exact = 11.25 - 0.6 * i,
                          .active = i == 7});
  }
  return chart;
}

}  // namespace

TEST_CASE("a bar is as long as its value says, to a pixel") {
  BarChart chart = {.largest = 40};
  for (const double value : {5.0, 10.0, 20.0, 40.0}) chart.bars.push_back({.before = value});
  const Image image = bars_of(chart).image;
  const double unit = (grey_run(image, 3, 4).end - grey_run(image, 0, 4).end) / 35.0;
  CHECK(unit > 10);
  const double zero = grey_run(image, 3, 4).end - 40 * unit;
  CHECK(std::abs(grey_run(image, 3, 4).begin - zero) <= 1.5);  // half of the axis lies upon it
  CHECK(std::abs(grey_run(image, 1, 4).end - (zero + 10 * unit)) <= 1);
  CHECK(std::abs(grey_run(image, 2, 4).end - (zero + 20 * unit)) <= 1);
}

TEST_CASE("the range does not follow the data when it is given") {
  const Image alone = bars_of({.bars = {{.before = 5}}, .largest = 40}).image;
  const Image both = bars_of({.bars = {{.before = 5}, {.before = 30}}, .largest = 40}).image;
  CHECK(grey_run(alone, 0, 1).end == grey_run(both, 0, 2).end);
}

TEST_CASE("what is added begins where the grey part ends and is as long as its value") {
  BarChart chart = {.largest = 40};
  chart.bars = {{.before = 10}, {.before = 10, .added = 15}, {.before = 25}};
  const Theme theme = light_theme();
  const Image image = bars_of(chart).image;
  const int ten = grey_run(image, 0, 3).end;
  const int twenty_five = grey_run(image, 2, 3).end;
  CHECK(std::abs(grey_run(image, 1, 3).end - ten) <= 1);
  const Run coloured = run_of(image, middle_row(1, 3), theme.normal);
  const double outline = sizes_for(360).outline;
  CHECK(coloured.begin >= ten);
  CHECK(coloured.begin <= ten + outline + 8);  // a hatch line may stand first
  CHECK(coloured.end <= twenty_five);
  CHECK(coloured.end >= twenty_five - outline - 8);
  const Run edge = run_of(image, middle_row(1, 3), theme.outline);
  CHECK(std::abs(edge.begin - ten) <= 1);
  CHECK(std::abs(edge.end - twenty_five) <= 1);
}

TEST_CASE("what is taken back is drawn from the end of the grey part, and grey is left what is left") {
  BarChart chart = {.largest = 40};
  chart.bars = {{.before = 10}, {.before = 25, .added = -15, .active = true}, {.before = 25}};
  const Theme theme = light_theme();
  const PagePicture picture = bars_of(chart);
  CHECK(is_written(picture, "−15.00"));
  const int ten = grey_run(picture.image, 0, 3).end;
  const int twenty_five = grey_run(picture.image, 2, 3).end;
  CHECK(std::abs(grey_run(picture.image, 1, 3).end - ten) <= 1);
  const Run coloured = run_of(picture.image, middle_row(1, 3), theme.normal);
  CHECK(std::abs(coloured.begin - ten) <= 1);
  CHECK(std::abs(coloured.end - twenty_five) <= 1);
  // The head points back: full colour next to the remaining bar, little of it in the other half.
  const int y = middle_row(1, 3);
  CHECK(bar_pixel_is(picture.image, ten + 5, y, theme.normal));
  const int quarter = (twenty_five - ten) / 4;
  int empty = 0;
  for (int x = twenty_five - quarter; x < twenty_five - 3; ++x) {
    if (bar_pixel_is(picture.image, x, y, theme.panel)) ++empty;
  }
  CHECK(empty > quarter / 3);
}

TEST_CASE("a bar that changes its sign is taken back to zero and grows on the other side") {
  const Theme theme = light_theme();
  BarChart chart = {.largest = 10, .smallest = -10};
  chart.bars = {{.before = 4, .added = -10}, {.before = -6}};
  const Image image = bars_of(chart).image;
  CHECK(grey_run(image, 0, 2).end == 0);  // nothing of the old bar is left
  const Run edge = run_of(image, middle_row(0, 2), theme.outline);
  CHECK(std::abs(edge.begin - grey_run(image, 1, 2).begin) <= 1);
  const int zero = grey_run(image, 1, 2).end;
  const auto share = [&](int begin, int end, Color color) {
    int count = 0;
    for (int x = begin; x < end; ++x) count += bar_pixel_is(image, x, middle_row(0, 2), color) ? 1 : 0;
    return static_cast<double>(count) / (end - begin);
  };
  CHECK(share(zero - 90, zero - 10, theme.normal) > 0.4);
  CHECK(share(zero - 90, zero - 10, theme.panel) == 0);
  CHECK(share(zero + 30, zero + 90, theme.panel) > 0.4);
}

TEST_CASE("new and old parts differ without hues, by outline and hatch") {
  const Theme theme = without_hues(light_theme());
  const Image image = bars_of({.bars = {{.before = 10, .added = 15}}, .largest = 40}, theme).image;
  const int y = middle_row(0, 1);
  const Run edge = run_of(image, y, theme.outline);
  CHECK(edge.end - edge.begin > 100);
  int changes = 0;
  for (int x = edge.begin + 3; x < edge.end - 3; ++x) {
    if (bar_pixel_is(image, x, y, theme.normal) != bar_pixel_is(image, x + 1, y, theme.normal)) ++changes;
  }
  CHECK(changes > 10);
}

TEST_CASE("the tick stands at the exact value") {
  BarChart chart = {.largest = 40};
  chart.bars = {{.before = 25}, {.before = 5, .exact = 25}};
  const PagePicture picture = bars_of({.bars = {{.before = 25}, {.before = 5}}, .largest = 40});
  const PagePicture ticked = bars_of(chart);
  CHECK_FALSE(is_written(picture, "exact"));
  CHECK(is_written(ticked, "exact"));
  CHECK(is_written(ticked, "25"));
  // Below the key the tick is the first ink from the left; both bars end where it stands.
  int tick = 640;
  int end = 0;
  for (int y = 40; y < 360; ++y) {
    const Run ink = run_of(ticked.image, y, light_theme().exact.color);
    if (ink.end > 0) tick = std::min(tick, ink.begin);
    end = std::max(end, run_of(ticked.image, y, light_theme().inactive).end);
  }
  CHECK(std::abs(tick + 1 - end) <= 1);
}

TEST_CASE("exact values share the decimals that the least round of them needs") {
  BarChart chart = {.largest = 40};
  chart.bars = {{.exact = 30}, {.exact = 12.5}, {.exact = 20.001}};
  const PagePicture picture = bars_of(chart);
  for (const char* number : {"30.0", "12.5", "20.0"}) CHECK(is_written(picture, number));
}

TEST_CASE("a bar beyond the range is cut, marked and has its value beside it") {
  const Theme theme = light_theme();
  const PagePicture full = bars_of({.bars = {{.before = 40}, {.before = 57}}, .largest = 57});
  const PagePicture cut = bars_of({.bars = {{.before = 40}, {.before = 57}}, .largest = 40});
  CHECK_FALSE(is_written(full, "57.00"));
  CHECK(is_written(cut, "57.00"));
  CHECK_FALSE(is_written(cut, "40.00"));
  CHECK(grey_run(cut.image, 0, 2).end == grey_run(cut.image, 1, 2).end);
  const auto gap_in = [&](int row) {
    const Run grey = grey_run(cut.image, row, 2);
    int x = grey.begin;
    while (x < grey.end && !bar_pixel_is(cut.image, x, middle_row(row, 2), theme.panel)) ++x;
    return x < grey.end;
  };
  CHECK_FALSE(gap_in(0));
  CHECK(gap_in(1));
}

TEST_CASE("an exact value beyond the range is written with an arrow instead of a tick") {
  CHECK(is_written(bars_of({.bars = {{.before = 10, .exact = 90}}, .largest = 40}), "| 90 →"));
}

TEST_CASE("bars that are no numbers say so and leave the others alone") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  BarChart chart = {.largest = 40};
  chart.bars = {
      {.before = 10}, {.before = nan, .added = 3, .exact = infinity, .active = true}, {.before = 30}};
  const PagePicture broken = bars_of(chart);
  CHECK(is_written(broken, "not a number"));
  CHECK(broken.faults.empty());
  CHECK(grey_run(broken.image, 1, 3).end == 0);
  const Run ten = grey_run(broken.image, 0, 3);
  const Run thirty = grey_run(broken.image, 2, 3);
  CHECK(ten.end - ten.begin > 100);
  CHECK(std::abs((thirty.end - ten.begin) - 3 * (ten.end - ten.begin)) <= 3);
  for (const double value : {nan, infinity, -infinity, 1e308, -1e308}) {
    bars_of({.bars = {{.before = value, .added = -value, .exact = value, .active = true}, {.before = 1}}});
  }
}

TEST_CASE("the active row says what it gives now, however many rows there are") {
  for (const int count : {8, 10, 12, 40}) {
    for (const Rect& room : {Rect{10, 36, 305, 140}, Rect{10, 36, 305, 300}, Rect{0, 0, 640, 360}}) {
      CAPTURE(count);
      CAPTURE(room.height);
      const PagePicture picture = bars_of(crowded_chart(count), light_theme(), room);
      CHECK(is_written(picture, "+1.05"));
      CHECK(is_written(picture, "row 8"));
      for (const std::string& fault : picture.faults) FAIL_CHECK(fault);
    }
  }
}

TEST_CASE("twelve rows that have room are all named") {
  const PagePicture picture = bars_of(crowded_chart(12), light_theme(), {10, 36, 305, 300});
  for (int i = 1; i <= 12; ++i) CHECK(is_written(picture, "row " + std::to_string(i)));
}

TEST_CASE("bars have a sound layout in every theme") {
  for (const Theme& theme : {light_theme(), dark_theme(), without_hues(light_theme())}) {
    for (const int height : {360, 720}) {
      Page page(height * 16 / 9, height, theme);
      page.begin({.number = "06", .title = "Sequential impulses"});
      const List<Rect> parts = columns(page.area(), {1, 1}, page.sizes().gap);
      draw_bars(page, parts[0], worked_chart());
      draw_bars(page, parts[1], crowded_chart(12));
      for (const std::string& fault : lint(page)) FAIL_CHECK(fault);
    }
  }
}

TEST_CASE("no bars, no values and no room do no harm") {
  CHECK(bars_of({.title = "empty"}).faults.empty());
  CHECK(bars_of({.bars = {{.name = "zero", .active = true}}}).faults.empty());
  bars_of(worked_chart(), light_theme(), {10, 10, 0, 0});
  bars_of(worked_chart(), light_theme(), {10, 10, 40, 40});
}

TEST_CASE("the bars of a stack of three boxes look as they did") {
  Page page(640, 360, light_theme());
  page.begin({.number = "06", .title = "Sequential impulses", .state = "sweep 2/10 · row 2 of 3"});
  const List<Rect> parts = columns(page.area(), {1, 1}, page.sizes().gap);
  draw_bars(page, parts[0], worked_chart());
  draw_bars(page, parts[1], crowded_chart(12));
  test::check_golden("bars_light", page.canvas().read());
}

TEST_CASE("values in columns leave bars their place, and half of the panel") {
  const auto places_of = [](double value, double end) {
    BarPlaces places;
    BarChart chart{.largest = 100, .digits = 2};
    for (int i = 0; i < 3; ++i)
      chart.bars.push_back({.name = "1 normal", .before = value, .exact = end, .active = i == 0});
    picture_of_page(light_theme(), [&](Page& page) { places = draw_bars(page, {0, 0, 640, 360}, chart); });
    return places;
  };
  const BarPlaces few = places_of(4, 9), many = places_of(33.333333, -0.00123);
  CHECK(few.plot.x == many.plot.x);
  CHECK(few.plot.width == many.plot.width);
  CHECK(few.plot.width > 0.5 * 640);
}

}  // namespace cairn::render
