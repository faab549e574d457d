// Floor 6. What of a state is hashed, and how.
#include <cairn/measure/fingerprint.hpp>
#include <cairn/math/list.hpp>

#include <fmt/format.h>

#include <bit>

namespace cairn {

void Fingerprint::add(std::string_view bytes) {
  for (const char byte : bytes) {
    hash_ ^= static_cast<unsigned char>(byte);
    hash_ *= 0x100000001b3u;
  }
}

void Fingerprint::add(double number) {
  const auto bits = std::bit_cast<std::uint64_t>(number);
  std::string bytes(8, '\0');
  for (std::size_t i = 0; i < 8; ++i) bytes[i] = static_cast<char>(bits >> (8 * i) & 0xFFu);
  add(std::string_view(bytes));
}

std::uint64_t fingerprint_of(const Snapshot& snapshot) {
  Fingerprint fingerprint;
  fingerprint.add(snapshot.time);
  for (const SnapshotBody& body : snapshot.bodies) {
    fingerprint.add(body.pose.position.x());
    fingerprint.add(body.pose.position.y());
    fingerprint.add(body.pose.angle);
    for (const double component : body.velocity) fingerprint.add(component);
  }
  for (const SnapshotContact& contact : snapshot.contacts) {
    fingerprint.add(contact.normal_impulse);
    fingerprint.add(contact.friction_impulse);
  }
  for (const SnapshotJoint& joint : snapshot.joints) {
    fingerprint.add(joint.impulse.x());
    fingerprint.add(joint.impulse.y());
  }
  return fingerprint.value();
}

std::uint64_t fingerprint_of(const List<double>& numbers) {
  Fingerprint fingerprint;
  for (const double number : numbers) fingerprint.add(number);
  return fingerprint.value();
}

std::string hexadecimal(std::uint64_t fingerprint) { return fmt::format("{:016x}", fingerprint); }

}  // namespace cairn
