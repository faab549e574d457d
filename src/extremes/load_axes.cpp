// Floor 12. Heavy on light, high stacks, long chains.
#include <fmt/format.h>

#include "constraints/revolute_joint.hpp"
#include "extremes/extreme_axes.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

using Policy = StabilizationPolicy;

/// A box of 1 kg under one of `ratio` kg.
Scene pair_of_boxes(double ratio) {
  Scene scene;
  scene.add_ground({.half_width = 20});
  scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}, .mass = 1});
  scene.add({.shapes = {box(1, 1)}, .position = {0, 1.5}, .mass = ratio});
  return scene;
}

Scene high_stack(int boxes) {
  Scene scene;
  scene.add_ground({.half_width = 2.0 * boxes + 10});
  for (int i = 0; i < boxes; ++i) scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5 + i}});
  return scene;
}

/// Links of 0.5 m and 1 kg, level with the pin, and a bob. They do not bump into each other: drift alone is
/// to be seen.
Scene long_chain(int links, double bob) {
  const double length = 0.5, radius = 0.25;  // [m]
  Scene scene;
  BodyId above = ground;
  for (int i = 0; i < links; ++i) {
    const BodyId link = scene.add(
        {.shapes = {box(length, 0.1)}, .position = {(i + 0.5) * length, 0}, .mass = 1, .collides_with = 0});
    scene.join<RevoluteJoint>({.a = above, .b = link, .anchor = {i * length, 0}});
    above = link;
  }
  const double end = links * length;
  const BodyId ball =
      scene.add({.shapes = {circle(radius)}, .position = {end + radius, 0}, .mass = bob, .collides_with = 0});
  scene.join<RevoluteJoint>({.a = above, .b = ball, .anchor = {end, 0}});
  return scene;
}

/// A stack stands while each of its boxes has sunk in by less than 2.5 cm: springs and slop let it sag.
ExtremeRun standing(double seconds, int boxes) {
  return {.seconds = seconds,
          .quantity = "farthest from its place (m)",
          .limit = 0.025 * boxes,
          .measure = [](const TrialResult& result) { return result.farthest; },
          .floor = 0};
}

List<ExtremeSetting> stack_settings() {
  return {{setting_of("si", 10), true},
          {setting_of("si", 30), false},
          {setting_of("si", 100), false},
          {setting_of("si", 4, Policy::baumgarte, 16), false},
          {setting_of("si", 4, Policy::soft, 8), true},
          {setting_of("si", 10, Policy::split_impulse), false},
          {setting_of("block-contact", 10), false},
          {setting_of("pgs-sparse", 100), false},
          {setting_of("jacobi-split", 100), false},
          {setting_of("accelerated", 100), false},
          {setting_of("reference", 1), false}};
}

/// Up to 10 any setting carries; 100 takes 100 sweeps, substeps or an exact answer; and an exact one carries
/// all.
ExtremeVerdict required_of_ratio(double ratio, const Setting& setting) {
  const bool exact = setting.solver == "reference";
  const bool split = setting.solver == "jacobi-split";
  const bool long_solve = setting.sweeps.iterations * setting.substeps >= 64 && !split;
  const bool ok = exact || (ratio <= 10 && !split) || (ratio <= 100 && long_solve);
  return ok ? ExtremeVerdict::ok : ExtremeVerdict::bound;
}

List<ExtremeCase> mass_ratio_cases() {
  List<ExtremeCase> cases;
  for (const double ratio : {1e-6, 1e-3, 1.0, 10.0, 100.0, 1e3, 1e4, 1e6}) {
    for (const ExtremeSetting& tried : stack_settings()) {
      const auto run = [ratio](const Setting& setting) {
        return run_extreme(pair_of_boxes(ratio), setting, standing(3, 2));
      };
      cases.push_back({"mass-ratio", fmt::format("{:g}", ratio), tried.setting,
                       required_of_ratio(ratio, tried.setting), tried.quick, run});
    }
  }
  return cases;
}

ExtremeVerdict required_of_stack(int boxes, const Setting& setting) {
  const bool split = setting.solver == "jacobi-split";
  const bool thirty = setting.sweeps.iterations * setting.substeps >= 30 || setting.solver == "reference";
  const bool ok = !split && (boxes <= 10 || (boxes <= 20 && thirty));
  return ok ? ExtremeVerdict::ok : ExtremeVerdict::bound;
}

List<ExtremeCase> stack_cases() {
  List<ExtremeCase> cases;
  for (const int boxes : {2, 5, 10, 20, 40, 100}) {
    for (const ExtremeSetting& tried : stack_settings()) {
      if (tried.setting.solver == "reference" && boxes > 20) continue;  // m^3: minutes
      const double seconds = tried.setting.solver == "reference" ? 0.5 : 3;
      const auto run = [boxes, seconds](const Setting& setting) {
        ExtremeRun how = standing(seconds, boxes);
        if (boxes > 20) how.time_limit = 120;
        return run_extreme(high_stack(boxes), setting, how);
      };
      cases.push_back({"stack", std::to_string(boxes), tried.setting, required_of_stack(boxes, tried.setting),
                       tried.quick && boxes <= 40, run});
    }
  }
  return cases;
}

List<ExtremeCase> chain_cases() {
  const List<ExtremeSetting> settings = {{setting_of("si", 10), true},
                                         {setting_of("si", 10, Policy::baumgarte), false},
                                         {setting_of("si", 10, Policy::soft), false},
                                         {setting_of("si", 10, Policy::split_impulse), false},
                                         {setting_of("si", 4, Policy::soft, 16), true},
                                         {setting_of("si", 100), false},
                                         {setting_of("block", 10), false},
                                         {setting_of("block", 4, Policy::soft, 16), false},
                                         {setting_of("accelerated", 100), false}};
  List<ExtremeCase> cases;
  for (const int links : {5, 20, 50, 200}) {
    for (const double bob : {1.0, 100.0, 1e4}) {
      for (const ExtremeSetting& tried : settings) {
        const auto run = [links, bob](const Setting& setting) {
          return run_extreme(long_chain(links, bob), setting,
                             {.seconds = 2,
                              .quantity = "joint drift / link",
                              .limit = 0.01,
                              .measure = [](const TrialResult& result) { return result.worst_drift / 0.5; },
                              .thinnest = 1e300});
        };
        cases.push_back({"chain", fmt::format("{} x {:g}", links, bob), tried.setting, ExtremeVerdict::bound,
                         tried.quick && links <= 50, run});
      }
    }
  }
  return cases;
}

}  // namespace

List<ExtremeAxis> load_axes() {
  const std::string all = "si under every policy, with more sweeps and with substeps, and the other families";
  return {{"mass-ratio", "a box of VALUE kg on one of 1 kg, 3 s", all, mass_ratio_cases},
          {"stack", "so many boxes of 1 m, 3 s", all, stack_cases},
          {"chain", "VALUE links of 1 kg with a bob of VALUE kg, let go level, 2 s", all, chain_cases}};
}

}  // namespace cairn
