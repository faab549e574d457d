// Floor 9. What must hold of a problem.
#include <cairn/study/frozen/frozen_problem.hpp>

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string_view>

#include <cairn/math/check.hpp>

namespace cairn {

namespace {

/// A place in the problem, for messages that are written only when something is wrong.
struct ProblemPlace {
  const std::string& file;
  const char* list = "";
  int index = 0;

  void require_that(bool holds, std::string_view field, std::string_view rule, double value) const {
    if (!holds) require(false, file, fmt::format("{}[{}].{}", list, index, field), rule, shortest(value));
  }
  void require_numbers(const Vec3<double>& numbers, const char* field) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::isfinite(numbers(axis))) continue;
      require_that(false, fmt::format("{}[{}]", field, axis), "a finite number", numbers(axis));
    }
  }
};

void check_bodies(const VelocityProblem<double>& problem, const std::string& file) {
  require(problem.body_count() >= 1, file, "bodies", "at least the ground", problem.body_count());
  require(problem.inverse_mass.size() == problem.velocity.size(), file, "inverse_mass", "one for each body",
          static_cast<double>(problem.inverse_mass.size()));
  for (const BodyId body : problem.velocity.indices()) {
    const ProblemPlace place{file, "bodies", body.index};
    place.require_numbers(problem.velocity[body], "velocity");
    place.require_numbers(problem.inverse_mass[body], "inverse_mass");
    const double least = problem.inverse_mass[body].minCoeff();
    place.require_that(least >= 0, "inverse_mass", "numbers >= 0 1/kg and 1/(kg m^2)", least);
  }
  const double of_ground = problem.inverse_mass[{0}].maxCoeff();
  require(of_ground == 0, file, "bodies[0].inverse_mass", "0 1/kg, for it is the ground", of_ground);
}

void check_bounds(const VelocityProblem<double>& problem, const ProblemPlace& place) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Bounds<double>& bounds = problem.rows[place.index].bounds;
  const auto names_a_row = [&](int row) { return row >= 0 && row < problem.row_count(); };
  const auto stands_alone = [&](int row) { return !problem.rows[row].bounds.is_friction(); };
  // Impulses must come to lie inside: times the inverse mass of any body of a scene, these still are
  // velocities.
  const double most_begun = 1e30;
  place.require_that(bounds.lower < infinity, "bounds.lower", "a number below infinity N s", bounds.lower);
  place.require_that(bounds.upper > -infinity, "bounds.upper", "a number above -infinity N s", bounds.upper);
  place.require_that(bounds.lower <= most_begun, "bounds.lower", "a number up to 1e30 N s", bounds.lower);
  place.require_that(bounds.upper >= -most_begun, "bounds.upper", "a number from -1e30 N s on", bounds.upper);
  place.require_that(bounds.lower <= bounds.upper, "bounds.upper", "a number >= lower N s", bounds.upper);
  place.require_that(bounds.friction >= 0 && std::isfinite(bounds.friction), "bounds.friction",
                     "a finite number >= 0", bounds.friction);
  place.require_that(bounds.disc >= 0 && std::isfinite(bounds.disc), "bounds.disc",
                     "a finite number >= 0 N s", bounds.disc);
  const int first = bounds.normal_row, second = bounds.second_normal_row;
  if (first == Bounds<double>::none) {
    place.require_that(second == first, "bounds.second_normal_row", "-1 without a normal_row", second);
    return;
  }
  place.require_that(names_a_row(first), "bounds.normal_row", "-1 or the place of a row", first);
  place.require_that(stands_alone(first), "bounds.normal_row", "a row that names no other row", first);
  if (second == Bounds<double>::none) return;
  place.require_that(names_a_row(second), "bounds.second_normal_row", "-1 or the place of a row", second);
  place.require_that(stands_alone(second), "bounds.second_normal_row", "a row that names no other", second);
  place.require_that(first != second, "bounds.second_normal_row", "another row than the first", second);
}

void check_row(const VelocityProblem<double>& problem, const ProblemPlace& place) {
  const ConstraintRow<double>& row = problem.rows[place.index];
  const auto names_a_body = [&](BodyId id) { return id.index >= 0 && id.index < problem.body_count(); };
  place.require_that(names_a_body(row.a), "a", "the place of a body", row.a.index);
  place.require_that(names_a_body(row.b), "b", "the place of a body", row.b.index);
  place.require_numbers(row.jacobian_a, "jacobian_a");
  place.require_numbers(row.jacobian_b, "jacobian_b");
  place.require_that(std::isfinite(row.bias), "bias", "a finite number of m/s or rad/s", row.bias);
  place.require_that(row.softness >= 0 && std::isfinite(row.softness), "softness",
                     "a finite number >= 0 1/kg", row.softness);
  const auto terms = static_cast<std::int64_t>(problem.extra_terms.size());
  const std::int64_t first = row.first_extra, count = row.extra_count;
  place.require_that(count >= 0 && count <= terms, "extra_count", "from 0 to the number of extra terms",
                     row.extra_count);
  place.require_that(first >= 0 && first + count <= terms, "first_extra",
                     "so that its terms lie inside extra_terms", row.first_extra);
  place.require_that(std::isfinite(problem.impulse[place.index]), "impulse", "a finite number of N s",
                     problem.impulse[place.index]);
  check_bounds(problem, place);
}

void check_extra_terms(const VelocityProblem<double>& problem, const std::string& file) {
  for (int i = 0; i < problem.extra_terms.size(); ++i) {
    const ProblemPlace place{file, "extra_terms", i};
    const int body = problem.extra_terms[i].body.index;
    place.require_that(body >= 0 && body < problem.body_count(), "body", "the place of a body", body);
    place.require_numbers(problem.extra_terms[i].jacobian, "jacobian");
  }
}

void check_blocks(const VelocityProblem<double>& problem, const std::string& file) {
  std::int64_t next = 0;
  for (int i = 0; i < problem.blocks.size(); ++i) {
    const ProblemPlace place{file, "blocks", i};
    const RowBlock& block = problem.blocks[i];
    place.require_that(block.first == next, "first", "where the block before ends", block.first);
    place.require_that(block.count >= 0 && next + block.count <= problem.row_count(), "count",
                       "a number of rows that are left", block.count);
    next += block.count;
  }
  require(next == problem.row_count(), file, "blocks", "so many as to cover all rows",
          static_cast<double>(next));
}

}  // namespace

void check(const VelocityProblem<double>& problem, const std::string& place) {
  check_bodies(problem, place);
  require(problem.impulse.size() == problem.rows.size(), place, "impulse", "one for each row",
          static_cast<double>(problem.impulse.size()));
  require(problem.dt > 0 && std::isfinite(problem.dt), place, "dt", "a finite number > 0 s", problem.dt);
  check_extra_terms(problem, place);
  for (int i = 0; i < problem.row_count(); ++i) check_row(problem, {place, "rows", i});
  check_blocks(problem, place);
}

}  // namespace cairn
