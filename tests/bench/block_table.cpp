// Paper 4.3, measured: sweeps with and without blocks, and what a sweep costs.
#include "table.hpp"
#include "tables.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include <cairn/cairn.hpp>
#include <cairn/math/list.hpp>
#include <cairn/samples/samples.hpp>
#include <cairn/validation/case_scenes.hpp>

namespace cairn::bench {

namespace {

constexpr int block_table_cap = 200000;  // sweeps

struct BlockScene {
  std::string name = {};
  VelocityProblem<double> problem = {};
};

using BlockTableSolver = std::function<std::unique_ptr<Solver<double>>(const SolverSettings&)>;

struct BlockTableColumn {
  std::string name = {};
  BlockTableSolver make = {};
};

/// Twenty rods of 1 kg and 1 m in a straight line, the first pinned to the ground, let go at `angle` below
/// the horizontal.
BlockScene pin_chain(const std::string& name, double angle) {
  Scene scene;
  const Vec2<double> along = {std::cos(angle), -std::sin(angle)};
  samples::add_chain(scene, 20, {.shapes = {box(1, 0.1)}, .position = along / 2, .angle = -angle, .mass = 1},
                     along);
  return {name, World(scene).velocity_problem()};
}

/// A cantilever of ten unit boxes.
BlockScene welded_beam() { return {"welded beam", World(cases::welded_beam(10)).velocity_problem()}; }

/// Ten unit boxes, every other one `offset` to the side: contacts hold and nothing slides. In a straight
/// stack two normals that are solved together tilt no box, and friction rests; staggered, they gain nothing.
BlockScene frictional_stack(const std::string& name, double offset) {
  Scene scene;
  scene.add_ground();
  samples::add_staggered_stack(scene, 10, offset);
  return {name, World(scene).velocity_problem()};
}

List<BlockTableColumn> block_table_columns() {
  const auto blocks = [](ContactBlock contact) -> BlockTableSolver {
    return [contact](const SolverSettings& settings) {
      return std::make_unique<BlockSequentialImpulse<double>>(settings, contact);
    };
  };
  return {
      {"SI",
       [](const SolverSettings& settings) { return std::make_unique<SequentialImpulse<double>>(settings); }},
      {"joints, (n, t)", blocks(ContactBlock::normal_and_friction)},
      {"joints, (n, n)", blocks(ContactBlock::two_normals)}};
}

std::string sweeps_to(double tolerance, const BlockTableSolver& make, VelocityProblem<double> problem) {
  const SolveReport report = make({.iterations = block_table_cap, .tolerance = tolerance})->solve(problem);
  return report.converged ? std::to_string(report.iterations) : "-";
}

/// [s] of 200 sweeps.
double seconds_of(Solver<double>& solver, const VelocityProblem<double>& start) {
  VelocityProblem<double> problem = start;
  const auto begin = std::chrono::steady_clock::now();
  solver.solve(problem);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The median, over rounds in which the two take turns, of the time of `make` over that of `base`: what the
/// machine does beside them meets both.
double cost_ratio(const BlockTableSolver& make, const BlockTableSolver& base,
                  const VelocityProblem<double>& problem) {
  const auto solver = make({.iterations = 200});
  const auto other = base({.iterations = 200});
  List<double> ratios;
  for (int round = 0; round < 31; ++round) {
    const double of_base = seconds_of(*other, problem);
    ratios.push_back(seconds_of(*solver, problem) / of_base);
  }
  std::nth_element(ratios.begin(), ratios.begin() + 15, ratios.end());
  return ratios[15];
}

}  // namespace

void print_block_table() {
  const List<BlockScene> scenes = {
      pin_chain("pin chain, 45 degrees", pi / 4), pin_chain("pin chain, level", 0), welded_beam(),
      frictional_stack("stack, straight", 0), frictional_stack("stack, staggered", 0.1)};
  const List<BlockTableColumn> columns = block_table_columns();
  print_heading("4. Blocks: what it gains to solve rows together that belong together");
  std::printf(
      "Paper 4.3: solving the rows of a joint at once should converge faster. Sweeps from cold to a "
      "residual\n"
      "R_E, and what a sweep costs in sweeps of SI. (n, t): a normal with its friction; (n, n): the two "
      "normals\n"
      "of a manifold; -: over %d sweeps.\n\n",
      block_table_cap);
  std::printf("%-23s %5s  %-15s %8s %8s %8s %6s\n", "scene", "rows", "blocks", "1e-2", "1e-4", "1e-6",
              "cost");
  for (const BlockScene& scene : scenes) {
    for (const BlockTableColumn& column : columns) {
      std::printf("%-23s %5d  %-15s %8s %8s %8s %6.2f\n", scene.name.c_str(), scene.problem.row_count(),
                  column.name.c_str(), sweeps_to(1e-2, column.make, scene.problem).c_str(),
                  sweeps_to(1e-4, column.make, scene.problem).c_str(),
                  sweeps_to(1e-6, column.make, scene.problem).c_str(),
                  cost_ratio(column.make, columns.front().make, scene.problem));
    }
  }
}

}  // namespace cairn::bench
