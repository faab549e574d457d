// The palettes keep the contrasts that they promise.
#include "render/theme.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "math/list.hpp"

namespace cairn::render {

namespace {

/// Relative luminance as WCAG 2 defines it.
double theme_test_luminance(Color color) {
  const auto light = [](double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * light(color.r) + 0.7152 * light(color.g) + 0.0722 * light(color.b);
}

double theme_test_contrast(Color first, Color second) {
  const double one = theme_test_luminance(first) + 0.05;
  const double two = theme_test_luminance(second) + 0.05;
  return std::max(one, two) / std::min(one, two);
}

struct StatedContrast {
  std::string name = {};
  Color color = {};
  double ratio = 1;
};

void theme_test_check(Color background, const List<StatedContrast>& stated) {
  for (const StatedContrast& each : stated) {
    CAPTURE(each.name);
    // Stated with one decimal.
    CHECK(std::abs(theme_test_contrast(each.color, background) - each.ratio) <= 0.0501);
  }
}

List<Color> theme_test_grounds(const Theme& theme) {
  return {theme.background, theme.panel, theme.body, theme.active_a, theme.active_b, theme.sleeping};
}

}  // namespace

TEST_CASE("the light palette has the contrasts stated for it") {
  const Theme theme = light_theme();
  List<StatedContrast> stated;
  stated.push_back({"text", theme.text, 16.0});
  stated.push_back({"secondary text", theme.secondary_text, 6.0});
  stated.push_back({"normal", theme.normal, 3.7});
  stated.push_back({"friction", theme.friction, 10.4});
  stated.push_back({"velocity", theme.velocity, 3.2});
  stated.push_back({"external", theme.external, 4.1});
  stated.push_back({"PGS", theme.pgs.color, 5.0});
  stated.push_back({"SI", theme.si.color, 3.4});
  stated.push_back({"Box2D", theme.box2d.color, 7.9});
  stated.push_back({"Jacobi", theme.jacobi.color, 8.3});
  stated.push_back({"grid", theme.grid, 1.2});
  theme_test_check(theme.background, stated);
}

TEST_CASE("the dark palette has the contrasts stated for it") {
  const Theme theme = dark_theme();
  List<StatedContrast> stated;
  stated.push_back({"text", theme.text, 16.3});
  stated.push_back({"secondary text", theme.secondary_text, 8.8});
  stated.push_back({"normal", theme.normal, 6.9});
  stated.push_back({"friction", theme.friction, 4.6});
  stated.push_back({"velocity", theme.velocity, 10.1});
  stated.push_back({"external", theme.external, 7.1});
  stated.push_back({"PGS", theme.pgs.color, 7.8});
  stated.push_back({"SI", theme.si.color, 10.0});
  stated.push_back({"Box2D", theme.box2d.color, 13.6});
  stated.push_back({"Jacobi", theme.jacobi.color, 4.9});
  theme_test_check(theme.background, stated);
}

TEST_CASE("text is read at 4.5 to 1 on every body and panel, and arrows are seen at 3 to 1 on every page") {
  for (const Theme& theme :
       {light_theme(), dark_theme(), without_hues(light_theme()), without_hues(dark_theme())}) {
    for (const Color ground : theme_test_grounds(theme))
      CHECK(theme_test_contrast(theme.text, ground) >= 4.5);
    for (const Color ground : {theme.background, theme.panel}) {
      CHECK(theme_test_contrast(theme.secondary_text, ground) >= 4.5);
      for (const Color arrow : {theme.normal, theme.friction, theme.joint, theme.velocity, theme.external}) {
        CHECK(theme_test_contrast(arrow, ground) >= 3);
      }
      for (const SeriesStyle& series : {theme.pgs, theme.si, theme.box2d, theme.jacobi, theme.exact}) {
        CHECK(theme_test_contrast(series.color, ground) >= 3);
      }
    }
  }
}

TEST_CASE("without hues every colour is a grey of the same luminance") {
  for (const Theme& theme : {light_theme(), dark_theme()}) {
    const Theme gray = without_hues(theme);
    const auto check = [](Color before, Color after) {
      CHECK(after.r == after.g);
      CHECK(after.g == after.b);
      // Floats hold a channel to 6e-8; the curve's slope is at most 2.3.
      CHECK(theme_test_luminance(after) == doctest::Approx(theme_test_luminance(before)).epsilon(1e-5));
    };
    check(theme.background, gray.background);
    check(theme.active_b, gray.active_b);
    check(theme.normal, gray.normal);
    check(theme.velocity, gray.velocity);
    check(theme.penetration, gray.penetration);
    check(theme.negative, gray.negative);
    check(theme.pgs.color, gray.pgs.color);
    check(theme.exact.color, gray.exact.color);
  }
}

TEST_CASE("no two solvers share a dash and a marker, so that print without hues tells them apart") {
  const Theme theme = light_theme();
  const List<SeriesStyle> series = {theme.pgs, theme.si, theme.box2d, theme.jacobi, theme.exact};
  for (int i = 0; i < series.size(); ++i) {
    for (int j = 0; j < i; ++j) CHECK(series[i].marker != series[j].marker);
  }
  CHECK(theme.pgs.dash.empty());
  CHECK(theme.si.dash != theme.box2d.dash);
  CHECK(theme.box2d.dash != theme.jacobi.dash);
  CHECK(theme.jacobi.dash != theme.si.dash);
}

TEST_CASE("type is never below 12 px, whatever the size of the picture") {
  for (const int height : {180, 360, 539, 540, 720, 1080}) {
    const Sizes sizes = sizes_for(height);
    for (const double size : {sizes.title, sizes.state, sizes.label, sizes.tick, sizes.equation,
                              sizes.body_number, sizes.question}) {
      CHECK(size >= 12);
    }
  }
}

TEST_CASE("pictures of 540 px and more have the large sizes") {
  CHECK(sizes_for(539).title < sizes_for(540).title);
  CHECK(sizes_for(540).title == sizes_for(1080).title);
}

}  // namespace cairn::render
