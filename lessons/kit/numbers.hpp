// Numbers as the lines and frames of a lesson show them.
#pragma once

#include <string>

namespace cairn {

/// Without what rounding has left of a zero.
double cleaned(double value);

/// As many decimals as it needs, up to `most`.
std::string brief(double value, int most = 3);

/// Negative numbers, as they stand behind an operator: "(−3)".
std::string in_brackets(const std::string& number);

/// A whole number with a space between its thousands: "90 000".
std::string spaced(double number);

}  // namespace cairn
