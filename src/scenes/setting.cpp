// Floor 8. Settings in words.
#include <cairn/scenes/setting.hpp>

#include <fmt/format.h>

#include <algorithm>

#include <cairn/math/check.hpp>
#include <cairn/math/nearest.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

std::string sweeps_text(const SolverSettings& sweeps) {
  const SolverSettings usual;
  std::string text = fmt::format(" x{}", sweeps.iterations);
  if (sweeps.tolerance > 0) text += fmt::format(" to {:g}", sweeps.tolerance);
  if (sweeps.relaxation != usual.relaxation) text += fmt::format(" omega {:g}", sweeps.relaxation);
  if (sweeps.patience != usual.patience) text += fmt::format(" patience {}", sweeps.patience);
  if (sweeps.time_budget > 0) text += fmt::format(" within {:g} s", sweeps.time_budget);
  if (sweeps.order != usual.order) text += ' ' + word_of(sweeps.order);
  if (sweeps.order == RowOrder::shuffled) text += fmt::format(" {}", sweeps.seed);
  return text;
}

/// A word in a sentence: "split impulse".
std::string spaced(std::string word) {
  std::replace(word.begin(), word.end(), '-', ' ');
  return word;
}

/// What differs from the usual spring.
std::string spring_text(const SwingSoftness& spring, const SwingSoftness& usual) {
  std::string text;
  if (spring.frequency != usual.frequency) text += fmt::format(" {:g} Hz", spring.frequency);
  if (spring.damping_ratio != usual.damping_ratio) text += fmt::format(" zeta {:g}", spring.damping_ratio);
  return text;
}

}  // namespace

std::string stabilization_text(const Stabilization& stabilization) {
  const Stabilization usual;
  std::string text = spaced(word_of(stabilization.policy));
  if (stabilization.policy == StabilizationPolicy::none) return text;
  if (stabilization.policy == StabilizationPolicy::soft) {
    text += spring_text(stabilization.soft, usual.soft);
    const std::string of_joints = spring_text(stabilization.joint_soft, usual.joint_soft);
    if (!of_joints.empty()) text += " joints" + of_joints;
  } else if (stabilization.baumgarte != usual.baumgarte) {
    text += fmt::format(" {:g}", stabilization.baumgarte);
  }
  if (stabilization.slop) text += fmt::format(" slop {:g} m", *stabilization.slop);
  if (stabilization.max_speed) text += fmt::format(" at most {:g} m/s", *stabilization.max_speed);
  return text;
}

std::string setting_text(const Setting& setting) {
  std::string rate = fmt::format("{:.6g} Hz", 1 / setting.dt);
  if (setting.substeps != 1) rate += fmt::format(" x{}", setting.substeps);
  if (setting.contact_search != ContactSearch::every_substep)
    rate += ", contacts " + spaced(word_of(setting.contact_search));
  const std::string cold = setting.warm_start ? "" : ", cold";
  if (setting.solver == "box2d") {
    return fmt::format("box2d x{}+{}, {}, float{}", setting.sweeps.iterations, setting.position_iterations,
                       rate, cold);
  }
  return fmt::format("{}{}, {}, {}, {}{}", setting.solver, sweeps_text(setting.sweeps), rate,
                     stabilization_text(setting.stabilization), word_of(setting.scalar), cold);
}

std::string solver_refusal(const Setting& setting) {
  if (setting.solver == "box2d" && !has_box2d()) return "one of Cairn's own where it was built without Box2D";
  if (setting.solver != opencl_jacobi_entry().name) return "";
  return setting.scalar == Precision::single_precision ? opencl_jacobi_refusal<float>()
                                                       : opencl_jacobi_refusal<double>();
}

void check(const Setting& setting) {
  const std::string refusal = solver_refusal(setting);
  require(refusal.empty(), "Setting", "solver", refusal, setting.solver);
  require_known(setting.solver, contestant_names(), "Setting", "solver");
  check(setting.sweeps, "Setting");
  require(setting.position_iterations >= 0, "Setting", "position_iterations", ">= 0",
          setting.position_iterations);
  Scene().set_settings(with_setting({}, setting));
}

SceneSettings with_setting(SceneSettings settings, const Setting& setting) {
  settings.dt = setting.dt;
  settings.substeps = setting.substeps;
  settings.contact_search = setting.contact_search;
  settings.stabilization = setting.stabilization;
  settings.warm_start = setting.warm_start;
  return settings;
}

bool has_box2d() {
#ifdef CAIRN_HAVE_BOX2D
  return true;
#else
  return false;
#endif
}

List<std::string> contestant_names() {
  List<std::string> names = solver_names();
  names.push_back(opencl_jacobi_entry().name);
  if (has_box2d()) names.push_back(box2d_entry().name);
  return names;
}

}  // namespace cairn
