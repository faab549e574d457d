// Floor 8. Settings from a scene file.
#include <cairn/scenes/scene_settings.hpp>

#include <cairn/math/nearest.hpp>
#include <cairn/scenes/default_setting.hpp>
#include <cairn/scenes/scene_builder.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// What [step] or [recommended] says, whose keys these settings have.
template <typename Settings>
void read_pace(const SceneTable& table, Settings& settings) {
  table.read(settings);
  if (const auto part = part_of<Stabilization>(table, "stabilization")) settings.stabilization = *part;
}

std::string solver_of(const SceneTable& table, const std::string& fallback) {
  if (!table.has("solver")) return fallback;
  const List<std::string> known = solver_names({"box2d", opencl_jacobi_entry().name});
  const std::string name = table.get<std::string>("solver");
  if (const std::string found = known_word(name, known); !found.empty()) return found;
  const std::string near = nearest(name, known);
  std::string rule = "the name of a solver";
  if (!near.empty()) rule += " (" + near + "?)";
  for (int i = 0; near.empty() && i < known.size(); ++i) rule += (i > 0 ? ", " : ": ") + known[i];
  table.refuse("solver", rule);
}

bool says_substeps(const SceneTable& file) {
  for (const SceneTable& step : file.tables("step")) return step.has("substeps");
  return false;
}

}  // namespace

SceneSettings scene_settings_of(const SceneTable& file) {
  const bool from_above = file.get<std::string>("view") == "top";
  if (from_above && file.has("gravity")) file.refuse("gravity", "left out where view = \"top\"");
  SceneSettings settings;
  file.read(settings);
  settings.fields = fields_of(file, settings.fields);
  if (from_above) settings.gravity = {0, 0};
  for (const SceneTable& step : file.tables("step")) {
    read_pace(step, settings);
    settings.sleeping = part_of<Sleeping>(step, "sleeping");
    step.guard([&] { Scene scene(settings); });
  }
  return settings;
}

Setting recommended_of(const SceneTable& file, const Scene& scene) {
  Setting setting = default_setting(scene).setting;
  if (says_substeps(file)) setting.substeps = scene.settings().substeps;
  for (const SceneTable& table : file.tables("recommended")) {
    setting.solver = solver_of(table, setting.solver);
    if (table.has("solver")) setting.sweeps = {};
    read_pace(table, setting);
    table.read(setting.sweeps);
    table.guard([&] { check(setting); });
  }
  return setting;
}

}  // namespace cairn
