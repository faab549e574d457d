// Floor 8. Small sums in scene files: "30 deg", "2 / 3 * mu".
#pragma once

#include <map>
#include <string>

namespace cairn {

struct FormulaResult {
  double value = 0;
  std::string problem = {};  // why there is no value; empty: there is one
};

/// Numbers, + - * / and brackets, pi, the functions sqrt, abs, sin, cos, tan, asin, acos, atan, the named
/// numbers, and the unit deg behind a number: "30 deg" is 30 pi / 180. Angles are in rad.
FormulaResult evaluate_formula(const std::string& text, const std::map<std::string, double>& numbers);

}  // namespace cairn
