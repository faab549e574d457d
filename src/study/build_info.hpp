// Floor 9. What numbers about time come from, and what it takes to have them again.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>

#include <cairn/study/trade_row.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// The commit of the tree that Cairn was built from, as git wrote it when the build was configured; "none"
/// for a tree without git. What was changed since that commit is not in it.
std::string build_commit();

/// By the names of their columns: schema (of the tables), version, git, box2d (its version, "none" without
/// it), compiler, flags, cpu (as the system calls it, "unknown" where it does not tell) and cores (that this
/// process may use).
const List<std::pair<std::string, std::string>>& build_entries();

/// What decides about numbers, on one line: version, commit, Box2D, compiler and flags, not the machine.
std::string build_text();

/// The same as an object, to stand beside numbers in JSON.
nlohmann::ordered_json build_json();

/// Fills the columns of build_entries().
void set_build(TradeRow& row);

}  // namespace cairn
