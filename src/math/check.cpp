// Floor 0. The wording of refusals.
#include <cairn/math/check.hpp>

#include <fmt/format.h>

#include <stdexcept>

namespace cairn {

std::string shortest(double value) { return fmt::format("{}", value); }

void require(bool holds, std::string_view place, std::string_view field, std::string_view rule,
             std::string_view value) {
  if (!holds)
    throw std::invalid_argument(fmt::format("{}: {} must be {}, got {}", place, field, rule, value));
}

void require(bool holds, std::string_view place, std::string_view field, std::string_view rule,
             double value) {
  if (!holds) require(false, place, field, rule, shortest(value));
}

void require_finite(double value, std::string_view place, std::string_view field, std::string_view unit) {
  if (std::isfinite(value)) return;
  require(false, place, field, unit.empty() ? "a finite number" : fmt::format("a finite number of {}", unit),
          value);
}

void require_finite(const Vec2<double>& value, std::string_view place, std::string_view field,
                    std::string_view unit) {
  if (!(std::isfinite(value.x()) && std::isfinite(value.y()))) {
    require(false, place, field, fmt::format("finite numbers of {}", unit),
            fmt::format("({}, {})", value.x(), value.y()));
  }
}

}  // namespace cairn
