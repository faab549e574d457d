// Floor 0. Refusing bad input at the edge: one message that names place, field, rule, unit and value.
#pragma once

#include <string>
#include <string_view>

#include <cairn/math/math.hpp>

namespace cairn {

/// The shortest text that reads back as the same number.
std::string shortest(double value);

/// Throws std::invalid_argument "place: field must be rule, got value" unless `holds`.
/// Write the condition so that NaN fails: `require(radius > 0, ...)`.
void require(bool holds, std::string_view place, std::string_view field, std::string_view rule, double value);

/// The same for a value that is not one number.
void require(bool holds, std::string_view place, std::string_view field, std::string_view rule,
             std::string_view value);

/// @throws std::invalid_argument unless both numbers are finite. `unit` as in "m".
void require_finite(const Vec2<double>& value, std::string_view place, std::string_view field,
                    std::string_view unit);
/// The same for one number.
/// @throws std::invalid_argument unless it is finite.
void require_finite(double value, std::string_view place, std::string_view field, std::string_view unit);

}  // namespace cairn
