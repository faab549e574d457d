// FNV-1a against the vectors its authors publish, and what of a state it sees.
#include <bit>

#include <cairn/measure/fingerprint.hpp>
#include "testing.hpp"

using namespace cairn;

namespace {

std::uint64_t hash_of_text(std::string_view text) {
  Fingerprint fingerprint;
  fingerprint.add(text);
  return fingerprint.value();
}

Snapshot snapshot_of_one_body() {
  Snapshot snapshot;
  snapshot.bodies.resize(1);
  snapshot.bodies[{0}].pose.position = {1, 2};
  return snapshot;
}

}  // namespace

TEST_CASE("the fingerprint is FNV-1a of 64 bit") {
  CHECK(hash_of_text("") == 0xcbf29ce484222325u);  // the offset basis
  CHECK(hash_of_text("a") == 0xaf63dc4c8601ec8cu);
  CHECK(hash_of_text("foobar") == 0x85944171f73967e8u);
  CHECK(hash_of_text("b") == (0xcbf29ce484222325u ^ 0x62u) * 0x100000001b3u);  // one byte, by the definition
}

TEST_CASE("a number is hashed as its eight bytes, the lowest first") {
  const auto bits = std::bit_cast<std::uint64_t>(1.5);
  std::string bytes;
  for (int i = 0; i < 8; ++i) bytes += static_cast<char>(bits >> (8 * i) & 0xFFu);
  CHECK(fingerprint_of(List<double>{1.5}) == hash_of_text(bytes));
  CHECK(fingerprint_of(List<double>{}) == hash_of_text(""));
}

TEST_CASE("two states that differ in one bit have two fingerprints") {
  const Snapshot state = snapshot_of_one_body();
  Snapshot moved = state;
  moved.bodies[{0}].pose.position.x() = std::nextafter(1.0, 2.0);
  Snapshot turning = state;
  turning.bodies[{0}].velocity.z() = 1e-300;
  CHECK(fingerprint_of(state) == fingerprint_of(snapshot_of_one_body()));
  CHECK(fingerprint_of(state) != fingerprint_of(moved));
  CHECK(fingerprint_of(state) != fingerprint_of(turning));
  CHECK(fingerprint_of(moved) != fingerprint_of(turning));
}

TEST_CASE("a fingerprint is written with sixteen digits, leading zeros included") {
  CHECK(hexadecimal(0x9f0c) == "0000000000009f0c");
  CHECK(hexadecimal(0xcbf29ce484222325u) == "cbf29ce484222325");
}
