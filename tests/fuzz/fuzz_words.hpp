// Command lines of `cairn` from any bytes.
#pragma once

#include <string>

#include "fuzz/fuzz_target.hpp"

namespace cairn::fuzz {

/// See feed().
Outcome feed_words(const std::string& bytes);

}  // namespace cairn::fuzz
