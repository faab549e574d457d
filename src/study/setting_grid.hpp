// Floor 9. Settings to be tried: one by one, and all of a grid.
#pragma once

#include <string>

#include <cairn/math/list.hpp>
#include <cairn/scenes/setting.hpp>

namespace cairn {

/// All else as where nothing is said.
Setting setting_of(const std::string& solver, int sweeps, StabilizationPolicy policy = Stabilization{}.policy,
                   int substeps = 1);

/// What settings differ in. Where a list is empty, they have what `base` has.
struct SettingGrid {
  List<std::string> solvers = {};
  List<int> frequencies = {};  // [Hz]
  List<int> substeps = {};
  List<int> sweeps = {};
  List<StabilizationPolicy> policies = {};
  List<Precision> scalars = {};
  List<int> position_iterations = {};
  Setting base = {};  // what they have in common: search for contacts, warm start
};

/// Every combination, by solver first, then by frequency, and so on.
List<Setting> settings_of(const SettingGrid& grid);

/// least, 2 least, 4 least ... up to `most`.
List<int> doubled(int least, int most);

}  // namespace cairn
