// Floor 8. Settings, expectations and camera from a scene file.
#include "scenes/scene_settings.hpp"

#include "math/nearest.hpp"
#include "scenes/default_setting.hpp"
#include "scenes/solver_list.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

Stabilization stabilization_of(const SceneTable& table) {
  Stabilization stabilization;
  stabilization.policy = static_cast<StabilizationPolicy>(table.word("policy"));
  stabilization.baumgarte = table.number("baumgarte");
  if (table.has("slop")) stabilization.slop = table.number("slop");
  if (table.has("max_speed")) stabilization.max_speed = table.number("max_speed");
  stabilization.soft = {.frequency = table.number("frequency"),
                        .damping_ratio = table.number("damping_ratio")};
  stabilization.joint_soft = {.frequency = table.number("joint_frequency"),
                              .damping_ratio = table.number("joint_damping_ratio")};
  return stabilization;
}

/// The keys that [step] and [recommended] share, where the table has them.
void set_pace(const SceneTable& table, SceneSettings& settings) {
  if (table.has("dt")) settings.dt = table.number("dt");
  if (table.has("substeps")) settings.substeps = table.integer("substeps");
  if (table.has("contact_search"))
    settings.contact_search = static_cast<ContactSearch>(table.word("contact_search"));
  if (table.has("warm_start")) settings.warm_start = table.flag("warm_start");
  for (const SceneTable& part : table.tables("stabilization")) {
    settings.stabilization = stabilization_of(part);
  }
}

std::string solver_of(const SceneTable& table, const std::string& fallback) {
  if (!table.has("solver")) return fallback;
  List<std::string> known = {"box2d", opencl_jacobi_entry().name};
  for (const SolverEntry& entry : solver_entries()) known.push_back(entry.name);
  const std::string name = table.text("solver");
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

SolverSettings sweeps_of(const SceneTable& table) {
  SolverSettings sweeps;
  sweeps.iterations = table.integer("iterations");
  sweeps.tolerance = table.number("tolerance");
  sweeps.time_budget = table.number("time_budget");
  sweeps.order = static_cast<RowOrder>(table.word("row_order"));
  sweeps.seed = static_cast<std::uint64_t>(table.number("seed"));
  sweeps.relaxation = table.number("relaxation");
  sweeps.patience = table.integer("patience");
  return sweeps;
}

std::optional<double> expected(const SceneTable& table, const std::string& key) {
  if (!table.has(key)) return std::nullopt;
  return table.number(key);
}

}  // namespace

SceneSettings scene_settings_of(const SceneTable& file) {
  const bool from_above = file.text("view") == "top";
  if (from_above && file.has("gravity")) file.refuse("gravity", "left out where view = \"top\"");
  SceneSettings settings;
  settings.gravity = from_above ? Vec2<double>(0, 0) : file.point("gravity");
  for (const SceneTable& step : file.tables("step")) {
    set_pace(step, settings);
    if (step.has("speculative_margin")) settings.speculative_margin = step.number("speculative_margin");
    if (step.has("restitution_threshold"))
      settings.restitution_threshold = step.number("restitution_threshold");
    settings.friction_rows =
        step.word("friction_rows") == 0 ? FrictionRows::per_point : FrictionRows::per_manifold;
    for (const SceneTable& sleeping : step.tables("sleeping")) {
      settings.sleeping = Sleeping{.speed = sleeping.number("speed"),
                                   .angular_speed = sleeping.number("angular_speed"),
                                   .time = sleeping.number("time")};
    }
    step.guard([&] { Scene scene(settings); });
  }
  return settings;
}

Setting recommended_of(const SceneTable& file, const Scene& scene) {
  SceneSettings settings = scene.settings();
  Setting setting = default_setting(scene).setting;
  if (says_substeps(file)) setting.substeps = settings.substeps;
  settings.substeps = setting.substeps;
  for (const SceneTable& table : file.tables("recommended")) {
    SceneSettings pace = settings;
    set_pace(table, pace);
    const bool says_solver = table.has("solver");
    setting.solver = solver_of(table, setting.solver);
    const int iterations = setting.sweeps.iterations;
    setting.sweeps = sweeps_of(table);
    if (!says_solver && !table.has("iterations")) setting.sweeps.iterations = iterations;
    setting.scalar = static_cast<Precision>(table.word("scalar"));
    setting.dt = pace.dt;
    setting.substeps = pace.substeps;
    setting.contact_search = pace.contact_search;
    setting.stabilization = pace.stabilization;
    setting.warm_start = pace.warm_start;
    setting.position_iterations = table.integer("position_iterations");
    table.guard([&] { check(setting); });
  }
  return setting;
}

Expectations expectations_of(const SceneTable& file) {
  for (const SceneTable& table : file.tables("expect")) {
    return {.penetration = expected(table, "penetration"),
            .drift = expected(table, "drift"),
            .energy_gain = expected(table, "energy_gain"),
            .energy_loss = expected(table, "energy_loss"),
            .stands = expected(table, "stands"),
            .places = {}};
  }
  return {};
}

std::optional<SceneCamera> camera_of(const SceneTable& file) {
  for (const SceneTable& table : file.tables("camera")) {
    return SceneCamera{.center = table.point("center"), .height = table.number("height")};
  }
  return std::nullopt;
}

}  // namespace cairn
