// What times were taken on.
#pragma once

namespace cairn::bench {

/// Prints compiler, flags, Eigen, caches, processor and load.
void print_machine();

}  // namespace cairn::bench
