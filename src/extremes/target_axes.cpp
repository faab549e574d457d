// Floor 12. What recommended settings must reach where plain ones fall, stretch or sink.
#include "extremes/extreme_axes.hpp"
#include "tuning/recommend_scenes.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

/// A tower of boxes of 1 m: nothing of it may move by a centimetre, and so its top sinks by less.
struct TowerTarget {
  std::string text = {};
  int boxes = 0;
  double top = 1;      // [kg] the others have 1 kg
  double seconds = 0;  // [s]
  bool quick = false;
};

struct ChainTarget {
  std::string text = {};
  int links = 0;
  double bob = 0;  // [kg] a link has 1 kg
  ChainStart start = ChainStart::level;
  bool quick = false;
};

Setting newton_setting(int substeps) {
  Setting setting = setting_of("newton", 60, StabilizationPolicy::relaxed, substeps);
  setting.sweeps.tolerance = 1e-9;
  return setting;
}

ExtremeCase tower_target(const TowerTarget& target) {
  const auto run = [target](const Setting& setting) {
    return run_extreme(tower_of_boxes(target.boxes, target.top), setting,
                       {.seconds = target.seconds,
                        .quantity = "farthest from its place (m)",
                        .limit = 0.01,
                        .measure = [](const TrialResult& result) { return result.farthest; },
                        .floor = 0,
                        .time_limit = 300});
  };
  return {"targets", target.text, newton_setting(1), ExtremeVerdict::ok, target.quick, run};
}

ExtremeCase chain_target(const ChainTarget& target, const Setting& tried) {
  const auto run = [target](const Setting& setting) {
    return run_extreme(chain_with_bob(target.links, target.bob, target.start), setting,
                       {.seconds = 5,
                        .quantity = "joint drift / link",
                        .limit = 0.01,
                        .measure = [](const TrialResult& result) { return result.worst_drift / 0.5; },
                        .thinnest = 1e300,
                        .time_limit = 300});
  };
  return {"targets", target.text, tried, ExtremeVerdict::ok, target.quick, run};
}

List<ExtremeCase> target_cases() {
  List<ExtremeCase> cases;
  for (const TowerTarget& target :
       {TowerTarget{"100 boxes, 2 s", 100, 1, 2, true}, TowerTarget{"100 boxes, 60 s", 100, 1, 60, false},
        TowerTarget{"1 t on four boxes, 10 s", 5, 1e3, 10, true},
        TowerTarget{"1 t on five boxes, 10 s", 6, 1e3, 10, true},
        TowerTarget{"10 t on 1 kg, 10 s", 2, 1e4, 10, true},
        TowerTarget{"1000 t on nine boxes, 10 s", 10, 1e6, 10, false}}) {
    cases.push_back(tower_target(target));
  }
  const Setting newton = newton_setting(8);
  const Setting momentum = setting_of("accelerated", 100, StabilizationPolicy::relaxed, 8);
  for (const ChainTarget& target :
       {ChainTarget{"20 links, bob 100, level", 20, 100, ChainStart::level, true},
        ChainTarget{"200 links, bob 100, level", 200, 100, ChainStart::level, false},
        ChainTarget{"200 links, bob 100, hanging", 200, 100, ChainStart::hanging, false}}) {
    cases.push_back(chain_target(target, newton));
    // Hanging, momentum lets it gain 1.5 % of its energy scale in its first steps.
    if (target.links == 200 && target.start == ChainStart::level)
      cases.push_back(chain_target(target, momentum));
  }
  return cases;
}

}  // namespace

List<ExtremeAxis> target_axes() {
  return {{"targets", "what the recommended settings must hold, 2 to 60 s",
           "newton alone for towers, with 8 substeps for chains; accelerated for chains too", target_cases}};
}

}  // namespace cairn
