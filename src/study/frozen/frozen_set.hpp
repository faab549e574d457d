// Floor 9. The frozen problems that solvers are compared on.
#pragma once

#include <cairn/study/frozen/frozen_problem.hpp>
#include <cairn/world/world.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// The problem of the world's next step, with its warm impulses as they are. Tags: "cold" or "warm" (an
/// impulse is not 0); "40 rows"; and "start" (no step was done yet), "settled" (nothing is faster than
/// 0.05 m/s or rad/s) or "moving".
FrozenProblem freeze(const World<double>& world, const std::string& name, const std::string& description);

/// Names of the set, in order: a mass ratio, stacks, a welded beam, a chain with a bob, a pyramid, an arch, a
/// silo, a rod at the Painleve limit, a bridge.
const List<std::string>& frozen_names();

/// Makes one of them anew: the same bits every time.
/// @throws std::invalid_argument for a name that is not in the set.
FrozenProblem make_frozen(const std::string& name);

/// Makes all of them and writes each to folder/NAME.json; makes the folder.
/// @throws std::runtime_error where that cannot be written.
void write_frozen_set(const std::filesystem::path& folder);

/// All that frozen_names() says, read from a folder.
/// @throws std::runtime_error for a missing file, std::invalid_argument for one that is malformed.
List<FrozenProblem> read_frozen_set(const std::filesystem::path& folder);

}  // namespace cairn
