// Inputs that nobody would write, made from some that somebody did.
#pragma once

#include <cstdint>
#include <string>

#include <cairn/math/list.hpp>

namespace cairn::fuzz {

/// The `number`-th input: first the seeds as they are, then one of them with one to four changes. The same
/// for the same seeds, `seed` and `number`.
std::string input(const List<std::string>& seeds, std::uint64_t seed, std::uint64_t number);

}  // namespace cairn::fuzz
