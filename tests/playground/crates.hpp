// A scene that several tests of the playground open.
#pragma once

#include <string>

/// Two boxes that stand.
inline const std::string two_crates = R"(title = "two boxes"
[ground]
half_width = 8
[[stack]]
name = "crate"
n = 2
box = [1, 1]
)";
