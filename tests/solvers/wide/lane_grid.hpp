// Problems that fill lanes, and what to compare of their answers.
#pragma once

#include <random>

#include "solvers/solver_list.hpp"

namespace cairn::testing {

/// Numbers from -1 to 1.
class LaneNumbers {
 public:
  double next() { return static_cast<double>(random_() % 2001) / 1000 - 1; }
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

 private:
  std::mt19937 random_{11};
};

/// Bodies in a grid; each is held to the next and to the one above by a block of rows, in turn a manifold of
/// two points, a pin, a weld with a spring, and a manifold whose friction is one row.
struct LaneGrid {
  VelocityProblem<double> problem = {};
  LaneNumbers numbers = {};

  void add_row(int a, int b, const Bounds<double>& bounds, double softness) {
    ConstraintRow<double> row;
    row.a = {a};
    row.b = {b};
    row.jacobian_a = {numbers.next(), numbers.next(), numbers.next()};
    row.jacobian_b = {numbers.next(), numbers.next(), numbers.next()};
    row.bias = numbers.next();
    row.softness = softness;
    row.bounds = bounds;
    problem.rows.push_back(row);
    problem.impulse.push_back(bounds.is_unilateral() ? 0.1 : 0);
  }
  void add_block(int a, int b, int kind) {
    const int first = problem.row_count();
    const auto normal = Bounds<double>::unilateral();
    if (kind == 0) {
      for (int point = 0; point < 2; ++point) {
        add_row(a, b, normal, 0);
        add_row(a, b, Bounds<double>::coulomb(0.5, first + 2 * point), 0);
      }
    } else if (kind == 1) {
      for (int row = 0; row < 2; ++row) add_row(a, b, Bounds<double>::equality(), 0.3);
    } else if (kind == 2) {
      add_row(a, b, Bounds<double>::at_most(0.2), 0);
      for (int row = 0; row < 3; ++row) add_row(a, b, Bounds<double>::equality(), row == 2 ? 2 : 0.3);
    } else {
      for (int point = 0; point < 2; ++point) add_row(a, b, normal, 0.3);
      add_row(a, b, Bounds<double>::coulomb(0.5, first, first + 1), 0);
    }
    problem.blocks.push_back({first, problem.row_count() - first});
  }
};

/// Every fifth body cannot move.
inline VelocityProblem<double> lane_grid(int side, int kinds) {
  LaneGrid grid;
  for (int body = 0; body < side * side; ++body) {
    grid.problem.velocity.push_back({grid.numbers.next(), grid.numbers.next(), grid.numbers.next()});
    const Vec3<double> mass{1.5 + grid.numbers.next(), 1.5, 1.5 + grid.numbers.next()};  // in this order
    grid.problem.inverse_mass.push_back(body % 5 == 0 ? Vec3<double>(0, 0, 0) : mass);
  }
  for (int body = 0; body < side * side; ++body) {
    if (body % side != side - 1) grid.add_block(body, body + 1, grid.numbers.below(kinds));
    if (body + side < side * side) grid.add_block(body, body + side, grid.numbers.below(kinds));
  }
  return grid.problem;
}

/// A grid with rows that fit into no lane: of three bodies, on a disc, and friction on another block's row.
inline VelocityProblem<double> lane_grid_with_oddities(int kinds) {
  LaneGrid grid = {.problem = lane_grid(12, kinds)};
  const int first = grid.problem.row_count();
  grid.add_row(1, 50, Bounds<double>::equality(), 0.5);
  grid.problem.extra_terms = {{{77}, {0.3, -0.8, 0.1}}};
  grid.problem.rows[first].extra_count = 1;
  grid.add_row(3, 4, Bounds<double>::at_most(0.3), 0);
  grid.add_row(3, 4, Bounds<double>::rest_of_disc(0.3, first + 1), 0);
  grid.problem.blocks.push_back({first, 1});
  grid.problem.blocks.push_back({first + 1, 2});
  for (int i = 0; i < 2; ++i) {
    grid.add_row(6, 7, i == 0 ? Bounds<double>::unilateral() : Bounds<double>::coulomb(0.4, first + 3), 0);
    grid.problem.blocks.push_back({first + 3 + i, 1});
  }
  return grid.problem;
}

template <Scalar Real>
bool same_bits(const VelocityProblem<Real>& one, const VelocityProblem<Real>& other) {
  bool same = one.impulse == other.impulse;
  for (const BodyId body : one.velocity.indices()) same = same && one.velocity[body] == other.velocity[body];
  return same;
}

/// The rows in the order in which a sweep updates them.
template <Scalar Real>
class OrderWatcher final : public SolveObserver<Real> {
 public:
  bool watches_rows() const override { return true; }
  void after_row(const RowUpdate<Real>& update, const VelocityProblem<Real>& problem) override {
    if (update.sweep == 1) rows.push_back(update.row);
    outside += is_outside(problem, update.row, update.impulse_after);
    outside += problem.impulse[update.row] != update.impulse_after;
  }
  List<int> rows;
  int outside = 0;
};

}  // namespace cairn::testing
