// Floor 9. The kinds of scenes, the runs that stand for each, and the settings that are tried.
#include <fmt/format.h>

#include <cairn/math/nearest.hpp>
#include <cairn/study/setting_grid.hpp>
#include <cairn/study/tuning/recommend.hpp>
#include <cairn/study/tuning/recommend_scenes.hpp>
#include <cairn/scenes/scene_list.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using Policy = StabilizationPolicy;

constexpr double most_gain = 0.01;     // of the energy scale: in every run
constexpr double most_overlap = 0.01;  // [m] in piles of bodies of 0.9 and 1 m: a hundredth of one

/// Towers stand where nothing leaves the place in which it has settled by more than a centimetre.
RecommendRun tower_run(const std::string& name, double seconds, int boxes, double top) {
  return {.name = name,
          .seconds = seconds,
          .wish = {.energy_gain = most_gain, .stands = seconds},
          .stand_distance = 0.01,
          .make = [boxes, top] { return tower_of_boxes(boxes, top); }};
}

RecommendKind stack_kind() {
  RecommendKind kind{.name = "stack", .title = "stacked boxes, heavy ones on top", .runs = {}};
  kind.runs = {tower_run("10 boxes, 10 s", 10, 10, 1), tower_run("10 t on 1 kg, 10 s", 10, 2, 1e4),
               tower_run("1 t on 4 x 1 kg, 10 s", 10, 5, 1e3), tower_run("1 t on 5 x 1 kg, 10 s", 10, 6, 1e3),
               tower_run("100 boxes, 60 s", 60, 100, 1)};
  kind.runs[2].quick = true;
  return kind;
}

/// Joints keep to 1 % of a link of 0.5 m.
RecommendRun chain_run(int links, double bob, ChainStart start) {
  const bool level = start == ChainStart::level;
  return {.name = fmt::format("{} links, {:g} kg, {}, 5 s", links, bob, level ? "let go level" : "hanging"),
          .seconds = 5,
          .wish = {.drift = 0.005, .energy_gain = most_gain},
          .make = [=] { return chain_with_bob(links, bob, start); }};
}

RecommendKind chain_kind() {
  RecommendKind kind{.name = "chain", .title = "long chains with a bob", .runs = {}};
  kind.runs = {chain_run(5, 1, ChainStart::level), chain_run(20, 100, ChainStart::level),
               chain_run(50, 100, ChainStart::level), chain_run(200, 100, ChainStart::hanging),
               chain_run(200, 100, ChainStart::level)};
  kind.runs[0].quick = true;
  return kind;
}

RecommendKind mechanism_kind() {
  RecommendKind kind{.name = "mechanism", .title = "joints in loops and branches", .runs = {}};
  // Without motors, whose work would be counted as a gain.
  for (const char* name : {"double-pendulum", "bridge", "weld-beam", "ragdoll"}) {
    kind.runs.push_back({.name = fmt::format("the scene {}, 3 s", name),
                         .seconds = 3,
                         .wish = {.drift = 0.01, .energy_gain = most_gain},
                         .make = [name] { return scene_entry(name).make(); }});
  }
  kind.runs[0].quick = true;
  return kind;
}

RecommendKind granular_kind() {
  RecommendKind kind{.name = "granular", .title = "piles, and bodies poured into a bin", .runs = {}};
  kind.runs = {{.name = "a pyramid of 10 rows, 5 s",
                .seconds = 5,
                .wish = {.penetration = most_overlap, .energy_gain = most_gain, .stands = 5},
                .stand_distance = 0.05,
                .make = [] { return pyramid_of_boxes(10); }}};
  for (const int bodies : {100, 200}) {
    kind.runs.push_back({.name = fmt::format("{} discs and boxes into a bin, 4 s", bodies),
                         .seconds = 4,
                         .wish = {.penetration = most_overlap, .energy_gain = most_gain},
                         .make = [bodies] { return bin_of_bodies(bodies); }});
  }
  kind.runs[0].quick = true;
  return kind;
}

RecommendKind fast_kind() {
  RecommendKind kind{.name = "fast", .title = "bullets against a thin wall", .runs = {}};
  for (const double speed : {10.0, 100.0, 1000.0, 1e5}) {
    kind.runs.push_back(
        {.name = fmt::format("{:g} m/s, 1 s", speed),
         .seconds = 1,
         .wish = {.penetration = 0.1, .energy_gain = most_gain},
         .escaped = [](const Snapshot& now) { return now.bodies.back().pose.position.x() > 0; },
         .make = [speed] { return shot_at_wall(speed, circle(0.1), 0.5); }});
  }
  kind.runs[1].quick = true;
  return kind;
}

RecommendKind far_kind() {
  RecommendKind kind{.name = "far", .title = "a stack far from the origin", .runs = {}};
  const auto add = [&kind](const std::string& type, Precision scalar, double x) {
    kind.runs.push_back({.name = fmt::format("{:g} m in {}, 2 s", x, type),
                         .seconds = 2,
                         .wish = {.energy_gain = most_gain, .stands = 2},
                         .stand_distance = 0.02,
                         .scalar = scalar,
                         .make = [x] { return boxes_far_off(x); }});
  };
  for (const double x : {1e2, 1e3}) add("float", Precision::single_precision, x);
  for (const double x : {1e4, 1e8, 1e11}) add("double", Precision::double_precision, x);
  kind.runs[0].quick = true;
  return kind;
}

}  // namespace

const List<RecommendKind>& recommend_kinds() {
  static const List<RecommendKind> kinds = {stack_kind(),    chain_kind(), mechanism_kind(),
                                            granular_kind(), fast_kind(),  far_kind()};
  return kinds;
}

const RecommendKind& recommend_kind(const std::string& name) {
  List<std::string> known;
  for (const RecommendKind& kind : recommend_kinds()) known.push_back(kind.name);
  require_known(name, known, "recommend", "kind");
  int at = 0;
  while (known[at] != name) ++at;
  return recommend_kinds()[at];
}

Setting newton_setting(int substeps) {
  Setting setting = setting_of("newton", 60, Policy::relaxed, substeps);
  setting.sweeps.tolerance = 1e-9;  // it would go on to the last digit
  return setting;
}

const List<Setting>& recommend_settings() {
  static const List<Setting> settings = {setting_of("si", 10),
                                         setting_of("si", 30),
                                         setting_of("si", 100),
                                         setting_of("si", 10, Policy::split_impulse),
                                         setting_of("si", 4, Policy::soft, 8),
                                         setting_of("si", 4, Policy::relaxed, 16),
                                         setting_of("block-contact", 10),
                                         setting_of("accelerated", 30),
                                         setting_of("accelerated", 100, Policy::relaxed, 8),
                                         setting_of("accelerated", 300),
                                         setting_of("wide", 20, Policy::relaxed, 4),
                                         newton_setting(1),
                                         newton_setting(4),
                                         newton_setting(8)};
  return settings;
}

const Setting& plain_setting() { return recommend_settings().front(); }

}  // namespace cairn
