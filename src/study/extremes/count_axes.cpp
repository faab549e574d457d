// Floor 9. Nothing at all, and very much.
#include <fmt/format.h>

#include <cmath>

#include <cairn/study/extremes/extreme_axes.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// Boxes side by side on the ground, which touch nothing else.
Scene field_of_boxes(int boxes) {
  Scene scene;
  scene.add_ground({.half_width = 1.0 * boxes + 10});
  for (int i = 0; i < boxes; ++i)
    scene.add({.shapes = {box(1, 1)}, .position = {1.5 * (i - boxes / 2), 0.5}});
  return scene;
}

/// A plate that lies on the ground, and so many balls on it.
Scene laden_plate(int balls) {
  const double apart = 0.25, radius = 0.1;  // [m]
  const double wide = apart * balls + 1;
  Scene scene;
  scene.add_ground({.half_width = wide});
  scene.add({.shapes = {box(wide, 1)}, .position = {0, 0.5}, .mass = 1000});
  for (int i = 0; i < balls; ++i)
    scene.add({.shapes = {circle(radius)}, .position = {apart * (i - balls / 2), 1 + radius}, .mass = 1});
  return scene;
}

ExtremeRun few_steps(int steps, const Setting& setting, double thinnest) {
  return {.seconds = steps * setting.dt,
          .measure = farthest_place(),
          .limit = 0.01,
          .thinnest = thinnest,
          .time_limit = 120};
}

List<ExtremeSetting> linear_settings() {
  return {{setting_of("si", 10), true},
          {setting_of("si", 10, StabilizationPolicy::soft), false},
          {setting_of("si", 10, StabilizationPolicy::split_impulse), false},
          {setting_of("block-contact", 10), false},
          {setting_of("accelerated", 10), true}};
}

void add_counts(const ExtremeSetting& tried, AxisCases& cases) {
  const auto add = [&](const std::string& what, ExtremeVerdict required, bool quick,
                       const AxisCases::Run& run) {
    cases.add(what, {tried.setting, quick && tried.quick}, required, run);
  };
  add("no bodies", ExtremeVerdict::ok, true,
      [](const Setting& setting) { return run_extreme(Scene(), setting, few_steps(10, setting, 1)); });
  add("one body, no rows", ExtremeVerdict::ok, true, [](const Setting& setting) {
    Scene scene({.gravity = {0, 0}});
    scene.add({.shapes = {circle(1)}});
    return run_extreme(scene, setting, few_steps(10, setting, 1));
  });
  for (const int boxes : {1000, 100000}) {
    add(fmt::format("{} boxes", boxes), ExtremeVerdict::ok, boxes == 1000, [boxes](const Setting& setting) {
      return run_extreme(field_of_boxes(boxes), setting, few_steps(3, setting, 1));
    });
  }
  for (const int balls : {1000, 10000}) {
    add(fmt::format("{} contacts on a body", balls), ExtremeVerdict::bound, balls == 1000,
        [balls](const Setting& setting) {
          return run_extreme(laden_plate(balls), setting, few_steps(10, setting, 0.2));
        });
  }
}

List<ExtremeCase> count_cases() {
  AxisCases cases("count");
  for (const ExtremeSetting& tried : linear_settings()) add_counts(tried, cases);
  // 4 rows a box: more than a dense A is made for.
  cases.add("a dense A of 40000 rows", {setting_of("pgs", 1), true}, ExtremeVerdict::refuse,
            [](const Setting& setting) {
              return run_extreme(field_of_boxes(10000), setting, few_steps(1, setting, 1));
            });
  return cases.all();
}

}  // namespace

List<ExtremeAxis> count_axes() {
  return {{"count", "so many bodies or contacts, a few steps",
           "si under every policy, block-contact, accelerated; dense PGS where it must refuse", count_cases}};
}

}  // namespace cairn
