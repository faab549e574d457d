// Floor 9. What recommended settings must reach where plain ones fall, stretch or sink.
#include <cairn/study/extremes/extreme_axes.hpp>
#include <cairn/math/list.hpp>
#include <cairn/study/tuning/recommend.hpp>
#include <cairn/study/tuning/recommend_scenes.hpp>

namespace cairn {

namespace {

constexpr double longest_target = 300;  // [s] of processor time

/// A tower of boxes of 1 m and 1 kg under one of `top` kg: nothing of it may move by a centimetre, and so its
/// top sinks by less.
void add_tower_target(const std::string& text, double seconds, int boxes, double top, bool quick,
                      AxisCases& cases) {
  cases.add(text, {newton_setting(1), quick}, ExtremeVerdict::ok, [=](const Setting& setting) {
    return run_extreme(tower_of_boxes(boxes, top), setting,
                       {.seconds = seconds,
                        .measure = farthest_place(),
                        .limit = 0.01,
                        .floor = 0,
                        .time_limit = longest_target});
  });
}

/// A chain with a bob of 100 kg; a link has 1 kg.
void add_chain_target(const std::string& text, int links, ChainStart start, const ExtremeSetting& tried,
                      AxisCases& cases) {
  cases.add(text, tried, ExtremeVerdict::ok, [=](const Setting& setting) {
    return run_extreme(chain_with_bob(links, 100, start), setting,
                       {.seconds = 5,
                        .measure = drift_of_links(),
                        .limit = 0.01,
                        .thinnest = 1e300,
                        .time_limit = longest_target});
  });
}

List<ExtremeCase> target_cases() {
  AxisCases cases("targets");
  add_tower_target("100 boxes, 2 s", 2, 100, 1, true, cases);
  add_tower_target("100 boxes, 60 s", 60, 100, 1, false, cases);
  add_tower_target("1 t on four boxes, 10 s", 10, 5, 1e3, true, cases);
  add_tower_target("1 t on five boxes, 10 s", 10, 6, 1e3, true, cases);
  add_tower_target("10 t on 1 kg, 10 s", 10, 2, 1e4, true, cases);
  add_tower_target("1000 t on nine boxes, 10 s", 10, 10, 1e6, false, cases);
  const Setting newton = newton_setting(8);
  const Setting momentum = setting_of("accelerated", 100, StabilizationPolicy::relaxed, 8);
  add_chain_target("20 links, bob 100, level", 20, ChainStart::level, {newton, true}, cases);
  add_chain_target("200 links, bob 100, level", 200, ChainStart::level, {newton, false}, cases);
  add_chain_target("200 links, bob 100, level", 200, ChainStart::level, {momentum, false}, cases);
  // Hanging, momentum lets it gain 1.5 % of its energy scale in its first steps.
  add_chain_target("200 links, bob 100, hanging", 200, ChainStart::hanging, {newton, false}, cases);
  return cases.all();
}

}  // namespace

List<ExtremeAxis> target_axes() {
  return {{"targets", "what the recommended settings must hold, 2 to 60 s",
           "newton alone for towers, with 8 substeps for chains; accelerated for chains too", target_cases}};
}

}  // namespace cairn
