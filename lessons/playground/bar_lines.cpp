// Rows and contacts as bars.
#include "lessons/playground/bar_lines.hpp"

#include <fmt/format.h>

#include <cmath>

#include <cairn/constraints/contact_rows.hpp>

namespace cairn::playground {

namespace {

constexpr double rounding = 1e-9;  // of the largest

bool is_same_pair(const ConstraintRow<double>& one, const ConstraintRow<double>& other) {
  return one.a == other.a && one.b == other.b;
}

/// "stack.2, 1" for two of a stack, "crate, shelf" for others, and "crate" for what stands on the ground.
std::string pair_name(const std::string& upper, const std::string& lower) {
  if (lower == "ground") return upper;
  const auto dot = upper.find('.');
  const bool is_family = dot != std::string::npos && lower.starts_with(upper.substr(0, dot + 1));
  return fmt::format("{}, {}", upper, is_family ? lower.substr(dot + 1) : lower);
}

}  // namespace

bool shows_rows(const Playground& playground) {
  return playground.bench(0).steps() == 0 || playground.cursor() || playground.lit_row() >= 0 ||
         playground.prediction();
}

std::string kind_name(const ConstraintRow<double>& row) {
  if (is_rolling(row)) return "rolling";
  if (row.bounds.is_friction()) return "friction";
  return row.bounds.is_unilateral() ? "normal" : "joint";
}

List<BarLine> bar_lines(const Playground& playground, bool all) {
  const PerRow<ConstraintRow<double>>& rows = playground.look(0).given.rows;
  const std::optional<Prediction>& prediction = playground.prediction();
  const bool are_single = all || shows_rows(playground);
  List<BarLine> lines;
  int contact = -1;  // the row that began the last line, where it is a contact's
  for (int i = 0; i < rows.size(); ++i) {
    const std::string kind = kind_name(rows[i]);
    const bool is_looked_at = i == playground.lit_row() || (prediction && prediction->row == i);
    if (!all && !is_looked_at && (kind == "friction" || kind == "rolling")) continue;
    const bool is_normal = kind == "normal";
    if (!are_single && is_normal && contact >= 0 && is_same_pair(rows[contact], rows[i])) {
      lines.back().rows.push_back(i);
      continue;
    }
    contact = is_normal ? i : -1;
    const auto& names = playground.names();
    const bool is_contact = !are_single && is_normal;
    lines.push_back(
        {is_contact ? pair_name(names[rows[i].b], names[rows[i].a]) : fmt::format("{} {}", i + 1, kind),
         {i}});
  }
  return lines;
}

double without_rounding(double value, double largest) {
  return std::abs(value) < rounding * largest ? 0 : value;
}

double sum_of(const BarLine& line, const PerRow<double>& impulse) {
  double sum = 0, largest = 0;
  for (const int row : line.rows) sum += impulse[row];
  for (const double one : impulse) largest = std::max(largest, std::abs(one));
  return without_rounding(sum, largest);
}

}  // namespace cairn::playground
