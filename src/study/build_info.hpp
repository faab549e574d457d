// Beside floor 6. What numbers about time come from.
#pragma once

#include <string>

#include "study/trade_row.hpp"

namespace cairn {

std::string cpu_name();       // as the system calls it, "unknown" where it does not tell
std::string compiler_name();  // with its version
std::string build_flags();

/// Fills the columns schema, cpu, compiler and flags.
void set_build(TradeRow& row);

}  // namespace cairn
