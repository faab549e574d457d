// Floor 3. Problems in other precisions.
#pragma once

#include <cairn/constraints/row.hpp>

namespace cairn {

/// The same row in another precision.
template <Scalar To, Scalar From>
ConstraintRow<To> converted(const ConstraintRow<From>& row) {
  const auto as_to = [](From x) { return static_cast<To>(x); };
  const Bounds<From>& bounds = row.bounds;
  return {.a = row.a,
          .b = row.b,
          .jacobian_a = row.jacobian_a.template cast<To>(),
          .jacobian_b = row.jacobian_b.template cast<To>(),
          .bias = as_to(row.bias),
          .softness = as_to(row.softness),
          .bounds = {.lower = as_to(bounds.lower),
                     .upper = as_to(bounds.upper),
                     .friction = as_to(bounds.friction),
                     .disc = as_to(bounds.disc),
                     .normal_row = bounds.normal_row,
                     .second_normal_row = bounds.second_normal_row},
          .key = row.key,
          .first_extra = row.first_extra,
          .extra_count = row.extra_count};
}

/// The same problem in another precision, by its rows alone.
template <Scalar To, Scalar From>
VelocityProblem<To> converted(const VelocityProblem<From>& problem) {
  VelocityProblem<To> result;
  for (const ConstraintRow<From>& row : problem.rows) result.rows.push_back(converted<To>(row));
  result.blocks = problem.blocks;
  for (const RowTerm<From>& term : problem.extra_terms) {
    result.extra_terms.push_back({term.body, term.jacobian.template cast<To>()});
  }
  for (const Vec3<From>& v : problem.inverse_mass) result.inverse_mass.push_back(v.template cast<To>());
  for (const Vec3<From>& v : problem.velocity) result.velocity.push_back(v.template cast<To>());
  for (const From impulse : problem.impulse) result.impulse.push_back(static_cast<To>(impulse));
  result.dt = static_cast<To>(problem.dt);
  return result;
}

}  // namespace cairn
