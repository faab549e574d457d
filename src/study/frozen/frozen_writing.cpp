// Floor 9. Frozen problems as JSON text.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>

#include <cairn/math/check.hpp>
#include <cairn/study/frozen/frozen_problem.hpp>
#include <cairn/measure/whole_file.hpp>

namespace cairn {

namespace {

/// JSON has no infinities; and without its point, -0 would be read as the whole number 0.
std::string frozen_number(double value) {
  if (std::isinf(value)) return value > 0 ? "\"inf\"" : "\"-inf\"";
  if (value == 0) return std::signbit(value) ? "-0.0" : "0";
  return fmt::format("{:.17g}", value);
}

std::string frozen_numbers(const Vec3<double>& v) {
  return frozen_number(v.x()) + "," + frozen_number(v.y()) + "," + frozen_number(v.z());
}

std::string frozen_bounds(const Bounds<double>& bounds) {
  const std::string ends = frozen_number(bounds.lower) + "," + frozen_number(bounds.upper);
  const bool is_interval = bounds.friction == 0 && !std::signbit(bounds.friction) && bounds.disc == 0 &&
                           !std::signbit(bounds.disc) && bounds.normal_row == Bounds<double>::none;
  if (is_interval) return "[" + ends + "]";
  return fmt::format("[{},{},{},{},{}]", ends, frozen_number(bounds.friction), frozen_number(bounds.disc),
                     bounds.normal_row, bounds.second_normal_row);
}

std::string frozen_row(const ConstraintRow<double>& row, double impulse) {
  std::string text =
      fmt::format("[{},{},[{}],[{}],{},{},{},[\"{:x}\",\"{:x}\"],{}", row.a.index, row.b.index,
                  frozen_numbers(row.jacobian_a), frozen_numbers(row.jacobian_b), frozen_number(row.bias),
                  frozen_number(row.softness), frozen_bounds(row.bounds), row.key.source, row.key.part,
                  frozen_number(impulse));
  if (row.first_extra != 0 || row.extra_count != 0) {
    text += fmt::format(",{},{}", row.first_extra, row.extra_count);
  }
  return text + "]";
}

/// A list with one line for each of its elements.
template <typename Array, typename Element>
std::string frozen_list(const char* field, const Array& array, const Element& element) {
  std::string lines;
  for (const auto i : array.indices()) lines += (lines.empty() ? "\n  " : ",\n  ") + element(i);
  return fmt::format(" \"{}\": [", field) + lines + (lines.empty() ? "]" : "\n ]");
}

std::string frozen_text(const std::string& text) { return nlohmann::json(text).dump(); }

}  // namespace

void write_frozen(std::ostream& out, const FrozenProblem& frozen) {
  check(frozen, "write_frozen");
  const VelocityProblem<double>& problem = frozen.problem;
  out << "{\n \"schema\": " << frozen_text(frozen_schema) << ",\n \"name\": " << frozen_text(frozen.name)
      << ",\n \"description\": " << frozen_text(frozen.description)
      << ",\n \"tags\": " << nlohmann::json(frozen.tags).dump() << ",\n \"dt\": " << frozen_number(problem.dt)
      << ",\n";
  out << frozen_list("bodies", problem.velocity, [&](BodyId body) {
    return "[" + frozen_numbers(problem.inverse_mass[body]) + "," + frozen_numbers(problem.velocity[body]) +
           "]";
  }) << ",\n";
  out << frozen_list("extra_terms", problem.extra_terms, [&](int i) {
    const RowTerm<double>& term = problem.extra_terms[i];
    return fmt::format("[{},{}]", term.body.index, frozen_numbers(term.jacobian));
  }) << ",\n";
  out << frozen_list("rows", problem.rows, [&](int i) {
    return frozen_row(problem.rows[i], problem.impulse[i]);
  }) << ",\n";
  out << frozen_list("blocks", problem.blocks, [&](int i) {
    return fmt::format("[{},{}]", problem.blocks[i].first, problem.blocks[i].count);
  }) << "\n}\n";
}

void write_frozen_file(const std::filesystem::path& path, const FrozenProblem& frozen) {
  std::ostringstream text;
  write_frozen(text, frozen);
  write_whole_file(path, text.str());
}

}  // namespace cairn
