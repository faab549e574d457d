// Floor 9. Maps of what has to carry: heavy on light, high stacks, long chains.
#include <fmt/format.h>

#include <cmath>

#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/study/extremes/atlas.hpp>
#include <cairn/math/list.hpp>
#include <cairn/study/setting_grid.hpp>
#include <cairn/validation/case_scenes.hpp>

namespace cairn {

namespace {

/// Whole numbers, every one labelled.
AtlasAxis whole_axis(const std::string& title, const List<int>& values) {
  AtlasAxis axis{.title = title};
  for (const int value : values) {
    axis.values.push_back(value);
    axis.labels.push_back(std::to_string(value));
  }
  return axis;
}

List<AtlasPanel> load_panels() {
  List<AtlasPanel> panels = solver_panels(10);
  for (AtlasPanel& panel : panels) panel.in_title = panel.in_title || panel.title == "accelerated";
  panels.push_back({"reference", atlas_setting("reference", 1), false, true});
  if (has_box2d()) panels.push_back({"Box2D 2.4.1", atlas_setting("box2d"), true});
  return panels;
}

FixedList<AtlasRule, atlas_classes> standing_classes() {
  return {{{"stands", "a box moved less than 2.5 cm for each box"},
           {"leans", "less than 25 cm for each box"},
           {"falls", "farther, and stays finite"},
           {"explodes", "10 % more energy than at the start"},
           {"", ""}}};
}

AtlasLimits standing_limits(double seconds, double boxes) {
  return {.seconds = seconds, .holds = 0.025 * boxes, .strained = 0.25 * boxes};
}

double way_of(const TrialResult& result) { return result.farthest; }

Scene boxes_of(const List<double>& masses) { return cases::box_column(masses, 0, 2.0 * masses.size() + 20); }

Setting swept(const AtlasPanel& panel, double sweeps) {
  Setting setting = panel.setting;
  if (!panel.ignores_y) setting.sweeps.iterations = static_cast<int>(sweeps);
  return setting;
}

/// Links of 0.5 m and 1 kg, level with the pin, and a bob of 100 kg. They have no shapes: drift alone is to
/// be seen.
Scene level_chain(int links) {
  const double length = 0.5, radius = 0.25, bob = 100;
  const double link_inertia = (length * length + 0.01) / 12;  // a bar of 1 kg, 0.1 m thick
  Scene scene;
  BodyId above = ground;
  for (int i = 0; i < links; ++i) {
    const BodyId link = scene.add({.position = {(i + 0.5) * length, 0}, .mass = 1, .inertia = link_inertia});
    scene.join<RevoluteJoint>({.a = above, .b = link, .anchor = {i * length, 0}});
    above = link;
  }
  const double end = links * length;
  const BodyId ball =
      scene.add({.position = {end + radius, 0}, .mass = bob, .inertia = 0.5 * bob * radius * radius});
  scene.join<RevoluteJoint>({.a = above, .b = ball, .anchor = {end, 0}});
  return scene;
}

List<AtlasPanel> chain_panels() {
  using Policy = StabilizationPolicy;
  List<AtlasPanel> panels = {{"SI, Baumgarte", setting_of("si", 4, Policy::baumgarte), true},
                             {"SI, soft rows", setting_of("si", 4, Policy::soft)},
                             {"SI, split impulse", setting_of("si", 4, Policy::split_impulse), true}};
  for (const std::string solver :
       {"block", "accelerated", "newton", "jacobi", "jacobi-damped", "jacobi-split", "reference"})
    panels.push_back({solver + ", split impulse", setting_of(solver, 4, Policy::split_impulse)});
  if (has_box2d()) panels.push_back({"Box2D 2.4.1", atlas_setting("box2d", 4), true});
  return panels;
}

}  // namespace

AtlasMap mass_ratio_map() {
  AtlasMap map;
  map.name = "mass-ratio";
  map.what =
      "A box of M kg on one of 1 kg, 3 s at 60 steps a second. Warm start, Baumgarte. "
      "A sweep of newton is a linear system.";
  map.quantity = "farthest way of a box [m]";
  map.x = {.title = "mass ratio M / m",
           .values = {1, 2, 5, 10, 20, 50, 100, 200, 500, 1e3, 2e3, 5e3, 1e4},
           .labels = {"1", "", "", "10", "", "", "100", "", "", "10^3", "", "", "10^4"}};
  map.y = whole_axis("sweeps a step", doubled(1, 1024));
  map.panels = load_panels();
  map.classes = standing_classes();
  map.headline = 6;
  map.headline_text = "A mass ratio of 100 stands";
  map.y_unit = "sweeps";
  map.run = [](const AtlasPanel& panel, double ratio, double sweeps) {
    return atlas_cell(boxes_of({1, ratio}), swept(panel, sweeps), standing_limits(3, 2), way_of);
  };
  return map;
}

AtlasMap stack_map() {
  AtlasMap map;
  map.name = "stack";
  map.what =
      "Boxes of 1 kg, 6 s at 60 steps a second. Warm start, Baumgarte. A sweep of newton is a linear system.";
  map.quantity = "farthest way of a box [m]";
  map.x = whole_axis("boxes", {2, 4, 5, 7, 10, 14, 20, 28, 40});
  map.y = whole_axis("sweeps a step", doubled(1, 512));
  map.panels = load_panels();
  map.classes = standing_classes();
  map.headline = 6;
  map.headline_text = "A stack of 20 stands";
  map.y_unit = "sweeps";
  map.run = [](const AtlasPanel& panel, double boxes, double sweeps) {
    if (panel.setting.solver == "reference" && boxes > 10) return AtlasCell{};  // rows^3 a step: minutes
    const List<double> masses(static_cast<int>(boxes), 1.0);
    return atlas_cell(boxes_of(masses), swept(panel, sweeps), standing_limits(6, boxes), way_of);
  };
  return map;
}

AtlasMap chain_map() {
  AtlasMap map;
  map.name = "chain";
  map.what =
      "Links of 0.5 m and 1 kg with a bob of 100 kg, let go level, 2 s at 60 steps a second, 4 sweeps (of "
      "newton: linear systems) a substep, warm start. PGS is SI, and block-contact is block. The reference "
      "is not tried with more than 20 links.";
  map.quantity = "worst gap of a joint over the length of a link";
  map.x = whole_axis("links", {2, 5, 10, 20, 40, 80, 160});
  map.y = whole_axis("substeps a step", doubled(1, 64));
  map.panels = chain_panels();
  map.classes = {{{"holds", "joints open by less than 1 % of a link"},
                  {"stretches", "less than 25 % of a link"},
                  {"tears", "farther, and stays finite"},
                  {"explodes", "10 % more energy than at the start"},
                  {"", ""}}};
  map.headline = 3;
  map.headline_text = "A chain of 20 holds";
  map.y_unit = "substeps";
  map.run = [](const AtlasPanel& panel, double links, double substeps) {
    if (panel.setting.solver == "reference" && links > 20) return AtlasCell{};  // rows^3 a substep: minutes
    Setting setting = panel.setting;
    setting.substeps = static_cast<int>(substeps);
    return atlas_cell(level_chain(static_cast<int>(links)), setting,
                      {.seconds = 2, .holds = 0.01, .strained = 0.25},
                      [](const TrialResult& result) { return result.worst_drift / 0.5; });
  };
  return map;
}

}  // namespace cairn
