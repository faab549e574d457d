// Floor 5. The wording of a refusal to change a world from within.
#include <cairn/world/occupation.hpp>

#include <fmt/format.h>

#include <stdexcept>

namespace cairn {

void Occupation::refuse(const char* who) const {
  if (within_ == nullptr) return;
  throw std::logic_error(
      fmt::format("{}: not from within {} of the same world, which would lose it", who, within_));
}

}  // namespace cairn
