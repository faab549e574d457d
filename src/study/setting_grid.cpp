// Floor 9. All combinations.
#include <cairn/study/setting_grid.hpp>

namespace cairn {

namespace {

/// Each of the settings with each of the values; as they are where there are none.
template <typename Value, typename Set>
List<Setting> varied(const List<Setting>& settings, const List<Value>& values, const Set& set) {
  if (values.empty()) return settings;
  List<Setting> all;
  for (const Setting& setting : settings) {
    for (const Value& value : values) {
      all.push_back(setting);
      set(all.back(), value);
    }
  }
  return all;
}

}  // namespace

Setting setting_of(const std::string& solver, int sweeps, StabilizationPolicy policy, int substeps) {
  Setting setting{.solver = solver, .substeps = substeps};
  setting.sweeps.iterations = sweeps;
  setting.stabilization.policy = policy;
  return setting;
}

List<Setting> settings_of(const SettingGrid& grid) {
  List<Setting> all = {grid.base};
  all = varied(all, grid.solvers, [](Setting& s, const std::string& solver) { s.solver = solver; });
  all = varied(all, grid.frequencies, [](Setting& s, int frequency) { s.dt = 1.0 / frequency; });
  all = varied(all, grid.substeps, [](Setting& s, int substeps) { s.substeps = substeps; });
  all = varied(all, grid.sweeps, [](Setting& s, int sweeps) { s.sweeps.iterations = sweeps; });
  all = varied(all, grid.policies,
               [](Setting& s, StabilizationPolicy policy) { s.stabilization.policy = policy; });
  all = varied(all, grid.scalars, [](Setting& s, Precision scalar) { s.scalar = scalar; });
  return varied(all, grid.position_iterations, [](Setting& s, int count) { s.position_iterations = count; });
}

List<int> doubled(int least, int most) {
  List<int> values;
  for (int value = least; value <= most; value *= 2) values.push_back(value);
  return values;
}

}  // namespace cairn
