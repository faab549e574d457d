// Worlds that are stepped, read, copied, edited, pushed and dragged in any order.
#pragma once

#include <cstdint>
#include <string>

#include "fuzz/fuzz_target.hpp"

namespace cairn::fuzz {

/// Makes a world and what happens to it of the bytes, in float or double, with every solver. Beside what ends
/// a process, it looks whether
///   a copy that another solver steps goes on with the same bits, though one of the two was read before;
///   a step that throws leaves bodies and time where they were, and, without substeps, all bits of the next
///   one; numbers that are not finite are reported.
/// @throws Finding.
Outcome feed_world(const std::string& bytes);

/// The bytes of a world of that number: as good as any others.
std::string world_bytes(std::uint64_t number);

}  // namespace cairn::fuzz
