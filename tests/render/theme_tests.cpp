// The palettes keep the contrasts that they promise.
#include "render/pictures.hpp"
#include "render/solver_style.hpp"

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

List<Color> theme_test_grounds(const Theme& theme) {
  return {theme.background, theme.panel, theme.body, theme.active_a, theme.active_b, theme.sleeping};
}

}  // namespace

TEST_CASE("the palettes have the contrasts stated for them") {
  const Theme light = light_theme(), dark = dark_theme();
  struct Stated {
    std::string name = {};
    Color of_light = {}, of_dark = {};
    double light = 1, dark = 1;
  };
  for (const Stated& each : {Stated{"text", light.text, dark.text, 16.0, 16.3},
                             Stated{"secondary text", light.secondary_text, dark.secondary_text, 6.0, 8.8},
                             Stated{"normal", light.normal, dark.normal, 3.7, 6.9},
                             Stated{"friction", light.friction, dark.friction, 10.4, 4.6},
                             Stated{"velocity", light.velocity, dark.velocity, 3.2, 10.1},
                             Stated{"external", light.external, dark.external, 4.1, 7.1},
                             Stated{"PGS", light.pgs.color, dark.pgs.color, 5.0, 7.8},
                             Stated{"SI", light.si.color, dark.si.color, 3.4, 10.0},
                             Stated{"Box2D", light.box2d.color, dark.box2d.color, 7.9, 13.6},
                             Stated{"Jacobi", light.jacobi.color, dark.jacobi.color, 8.3, 4.9}}) {
    CAPTURE(each.name);
    // Stated with one decimal.
    CHECK(std::abs(theme_test_contrast(each.of_light, light.background) - each.light) <= 0.0501);
    CHECK(std::abs(theme_test_contrast(each.of_dark, dark.background) - each.dark) <= 0.0501);
  }
  CHECK(std::abs(theme_test_contrast(light.grid, light.background) - 1.2) <= 0.0501);
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
    for (const auto color : {&Theme::background, &Theme::active_b, &Theme::normal, &Theme::velocity,
                             &Theme::penetration, &Theme::negative})
      check(theme.*color, gray.*color);
    for (const auto series : {&Theme::pgs, &Theme::exact}) check((theme.*series).color, (gray.*series).color);
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

TEST_CASE("each solver has the colour of its family and a line of its own, and grey is no solver") {
  for (const Theme& theme : {light_theme(), dark_theme()}) {
    const auto same = [](Color a, Color b) { return a.r == b.r && a.g == b.g && a.b == b.b; };
    const List<std::pair<std::string, Color>> families = {{"pgs", theme.pgs.color},
                                                          {"accelerated", theme.pgs.color},
                                                          {"si", theme.si.color},
                                                          {"sor", theme.si.color},
                                                          {"block", theme.si.color},
                                                          {"wide", theme.si.color},
                                                          {"jacobi", theme.jacobi.color},
                                                          {"jacobi-damped", theme.jacobi.color},
                                                          {"jacobi-split", theme.jacobi.color},
                                                          {"box2d", theme.box2d.color},
                                                          {"newton", theme.text}};
    for (int i = 0; i < families.size(); ++i) {
      CAPTURE(families[i].first);
      const SeriesStyle style = style_of_solver(theme, families[i].first);
      CHECK(same(style.color, families[i].second));
      for (int k = 0; k < i; ++k) {
        const SeriesStyle other = style_of_solver(theme, families[k].first);
        if (same(style.color, other.color)) CHECK((style.dash != other.dash && style.marker != other.marker));
      }
      for (const SeriesStyle& neutral : neutral_styles(theme))
        CHECK((families[i].first == "newton" || !same(style.color, neutral.color)));
    }
  }
}

}  // namespace cairn::render
