// Floor 6. A fingerprint of numbers: two runs with the same one computed the same bits.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <cairn/world/snapshot.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// FNV-1a, 64 bit (Fowler, Noll, Vo).
class Fingerprint {
 public:
  /// Bytes as they are.
  void add(std::string_view bytes);
  /// The 8 bytes of the number, the lowest first on every machine.
  void add(double number);
  /// As a double, which holds every float.
  void add(float number) { add(static_cast<double>(number)); }
  /// The numbers of an Eigen vector, one after the other.
  template <typename Vector>
  requires requires(const Vector& v) {
    v.size();
    v[0];
    v.allFinite();
  }
  void add(const Vector& vector) {
    for (const auto number : vector) add(number);
  }
  /// Of all that was added so far.
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

/// Of time, poses, velocities and impulses.
std::uint64_t fingerprint_of(const Snapshot& snapshot);
/// Of numbers, in their order.
std::uint64_t fingerprint_of(const List<double>& numbers);

/// 16 hexadecimal digits.
std::string hexadecimal(std::uint64_t fingerprint);

}  // namespace cairn
