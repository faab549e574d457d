// Floor 4. The kinds of a block's rows in one number: blocks of the same kinds lie side by side.
#pragma once

#include <cstdint>

#include <cairn/solvers/wide/lane_data.hpp>

namespace cairn {

/// A row's kind: 1 + bounds, and two rows of its block.
inline constexpr int bits_of_a_kind = 9;
/// Behind those of all rows: they are of a contact that needs none.
inline constexpr std::uint64_t contact_bit = std::uint64_t{1} << 63;

/// A kind as a number above 0.
inline std::uint64_t code_of(LaneKind kind) {
  return (static_cast<std::uint64_t>(kind.bounds) + 1) | (static_cast<std::uint64_t>(kind.normal) << 3) |
         (static_cast<std::uint64_t>(kind.second_normal) << 6);
}

/// The kind of such a number.
inline LaneKind kind_of(std::uint64_t code) {
  return {.bounds = static_cast<LaneBounds>((code & 7) - 1),
          .normal = static_cast<std::uint8_t>((code >> 3) & 7),
          .second_normal = static_cast<std::uint8_t>((code >> 6) & 7)};
}

/// Of a contact with friction: a normal row and one of friction for each point.
inline std::uint64_t kinds_of_contact(int rows) {
  std::uint64_t kinds = 0;
  for (int i = 0; i + 1 < rows; i += 2) {
    const LaneKind friction = {.bounds = LaneBounds::friction, .normal = static_cast<std::uint8_t>(i)};
    kinds = kinds << bits_of_a_kind | code_of({.bounds = LaneBounds::lower});
    kinds = kinds << bits_of_a_kind | code_of(friction);
  }
  return kinds;
}

}  // namespace cairn
