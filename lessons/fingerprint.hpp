// A fingerprint of numbers: two runs with the same one computed the same bits.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "world/snapshot.hpp"

namespace cairn {

/// FNV-1a, 64 bit (Fowler, Noll, Vo).
class Fingerprint {
 public:
  void add(std::string_view bytes);
  /// The 8 bytes of the number, the lowest first on every machine.
  void add(double number);
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

/// Of time, poses, velocities and impulses.
std::uint64_t fingerprint_of(const Snapshot& snapshot);
std::uint64_t fingerprint_of(const std::vector<double>& numbers);

/// 16 hexadecimal digits.
std::string hexadecimal(std::uint64_t fingerprint);

}  // namespace cairn
