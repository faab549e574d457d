// Which bars stand beside the scene: a row each, or the points of a contact together.
#pragma once

#include <string>

#include <cairn/math/list.hpp>
#include "lessons/playground/playground.hpp"

namespace cairn::playground {

/// One bar, and the rows whose impulses it adds up: one row, or the normal rows of a contact.
struct BarLine {
  std::string name = {};
  List<int> rows = {};
};

/// Where the student is: within a step, or where a row is lit or asked for, single rows are looked at.
/// Between steps two points of a contact share its force now this way and now that, and only their sum stands
/// still.
bool shows_rows(const Playground& playground);

/// The bars of the solve that comes next. Without `all`, rows of friction are left out but for one that is
/// lit, and contacts take one bar each unless rows are looked at.
List<BarLine> bar_lines(const Playground& playground, bool all);

/// "normal", "friction", "rolling" or "joint".
std::string kind_name(const ConstraintRow<double>& row);

/// The sum of a line's impulses [N s]; 0 where it is nothing beside the largest of all.
double sum_of(const BarLine& line, const PerRow<double>& impulse);

/// Zero where a value is nothing but rounding beside the largest [the unit of both].
double without_rounding(double value, double largest);

}  // namespace cairn::playground
