// Floor 9. Heavy on light, high stacks, long chains.
#include <fmt/format.h>

#include <cairn/study/extremes/extreme_axes.hpp>
#include <cairn/math/list.hpp>
#include <cairn/study/tuning/recommend_scenes.hpp>
#include <cairn/validation/case_scenes.hpp>

namespace cairn {

namespace {

using Policy = StabilizationPolicy;
using cairn::cases::box_column;

/// A stack stands while each of its boxes has sunk in by less than 2.5 cm: springs and slop let it sag.
ExtremeRun standing(double seconds, int boxes) {
  return {.seconds = seconds, .measure = farthest_place(), .limit = 0.025 * boxes, .floor = 0};
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
  AxisCases cases("mass-ratio");
  for (const double ratio : {1e-6, 1e-3, 1.0, 10.0, 100.0, 1e3, 1e4, 1e6}) {
    for (const ExtremeSetting& tried : stack_settings()) {
      cases.add(fmt::format("{:g}", ratio), tried, required_of_ratio(ratio, tried.setting),
                [ratio](const Setting& setting) {
                  return run_extreme(box_column({1, ratio}, 0, 20), setting, standing(3, 2));
                });
    }
  }
  return cases.all();
}

ExtremeVerdict required_of_stack(int boxes, const Setting& setting) {
  const bool split = setting.solver == "jacobi-split";
  const bool thirty = setting.sweeps.iterations * setting.substeps >= 30 || setting.solver == "reference";
  const bool ok = !split && (boxes <= 10 || (boxes <= 20 && thirty));
  return ok ? ExtremeVerdict::ok : ExtremeVerdict::bound;
}

List<ExtremeCase> stack_cases() {
  AxisCases cases("stack");
  for (const int boxes : {2, 5, 10, 20, 40, 100}) {
    for (const ExtremeSetting& tried : stack_settings()) {
      if (tried.setting.solver == "reference" && boxes > 20) continue;  // m^3: minutes
      const double seconds = tried.setting.solver == "reference" ? 0.5 : 3;
      cases.add(std::to_string(boxes), {tried.setting, tried.quick && boxes <= 40},
                required_of_stack(boxes, tried.setting), [boxes, seconds](const Setting& setting) {
                  ExtremeRun how = standing(seconds, boxes);
                  if (boxes > 20) how.time_limit = 120;
                  const List<double> masses(boxes, 1.0);
                  return run_extreme(box_column(masses, 0, 2.0 * boxes + 10), setting, how);
                });
    }
  }
  return cases.all();
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
  AxisCases cases("chain");
  for (const int links : {5, 20, 50, 200}) {
    for (const double bob : {1.0, 100.0, 1e4}) {
      for (const ExtremeSetting& tried : settings) {
        cases.add(fmt::format("{} x {:g}", links, bob), {tried.setting, tried.quick && links <= 50},
                  ExtremeVerdict::bound, [links, bob](const Setting& setting) {
                    return run_extreme(
                        chain_with_bob(links, bob, ChainStart::level), setting,
                        {.seconds = 2, .measure = drift_of_links(), .limit = 0.01, .thinnest = 1e300});
                  });
      }
    }
  }
  return cases.all();
}

}  // namespace

List<ExtremeAxis> load_axes() {
  const std::string all = "si under every policy, with more sweeps and with substeps, and the other families";
  return {{"mass-ratio", "a box of VALUE kg on one of 1 kg, 3 s", all, mass_ratio_cases},
          {"stack", "so many boxes of 1 m, 3 s", all, stack_cases},
          {"chain", "VALUE links of 1 kg with a bob of VALUE kg, let go level, 2 s", all, chain_cases}};
}

}  // namespace cairn
