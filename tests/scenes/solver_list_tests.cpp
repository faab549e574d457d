// Solvers by name.
#include <cairn/scenes/solver_list.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <concepts>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include <cairn/solvers/iterative/jacobi.hpp>
#include "solvers/solver_list.hpp"

using namespace cairn;

TEST_CASE_TEMPLATE("every solver of the list can be made in every scalar and solves a resting box", Real,
                   float, double) {
  std::set<std::string> names;
  for (const SolverEntry& entry : solver_entries()) {
    CAPTURE(entry.name);
    CHECK(names.insert(entry.name).second);
    CHECK_FALSE(entry.title.empty());
    CHECK_FALSE(entry.cost.empty());
    const auto solver = make_solver<Real>(entry.name, {.iterations = 60});
    VelocityProblem<Real> problem = testing::hand_made_stack<Real>(1, 10, Real(0.5));
    solver->solve(problem);
    // It takes m g dt = 5 N s; damped by a half, 2^-60 of it is missing.
    CHECK(std::abs(problem.impulse[0] - Real(5)) <= 64 * std::numeric_limits<Real>::epsilon() * 5);
  }
  CHECK(names.size() >= 10);
}

TEST_CASE("an unknown solver is refused with the nearest name, or with all of them") {
  CHECK_THROWS_WITH_AS(make_solver<double>("pgs-sparce"),
                       "make_solver: solver must be a known name (pgs-sparse?), got pgs-sparce",
                       std::invalid_argument);
  std::string all = "make_solver: solver must be one of ";
  for (const std::string& name : solver_names()) all += name + ", ";
  all += "opencl-jacobi, got simplex";
  CHECK_THROWS_WITH_AS(make_solver<double>("simplex"), all.c_str(), std::invalid_argument);
  CHECK_THROWS_AS(make_solver<float>(""), std::invalid_argument);
  CHECK(solver_entry("box2d").name == "box2d");
  CHECK(solver_entry("pgs").name == "pgs");
}

TEST_CASE_TEMPLATE("Jacobi on a device is made where there is one, and else refused with what is missing",
                   Real, float, double) {
  const std::string refusal = opencl_jacobi_refusal<Real>();
  VelocityProblem<Real> there = testing::hand_made_stack<Real>(8, 10, Real(0.5)), here = there;
  if (refusal.empty()) {
    make_solver<Real>("opencl-jacobi", {.iterations = 40})->solve(there);
    make_solver<Real>("jacobi-split", {.iterations = 40})->solve(here);
    CHECK(there.impulse == here.impulse);
  } else {
    const std::string message = "make_solver: solver must be " + refusal + ", got opencl-jacobi";
    CHECK_THROWS_WITH_AS(make_solver<Real>("opencl-jacobi"), message.c_str(), std::invalid_argument);
    MESSAGE("opencl-jacobi: " << message);
  }
  CHECK(solver_entry("opencl-jacobi").name == "opencl-jacobi");
  for (const SolverEntry& entry : solver_entries()) CHECK(entry.name != "opencl-jacobi");
}

TEST_CASE("damped Jacobi gives half of every correction, and takes no relaxation that is out of range") {
  VelocityProblem<double> problem = testing::hand_made_stack<double>(1, 10, 0.5);
  make_solver<double>("jacobi-damped", {.iterations = 1})->solve(problem);
  CHECK(problem.impulse[0] == 2.5);  // of m g dt = 5 N s
  CHECK_THROWS_AS(make_solver<double>("jacobi-damped", {.relaxation = 2}), std::invalid_argument);
  CHECK_THROWS_AS(make_solver<double>("si", {.iterations = -1}), std::invalid_argument);
}

TEST_CASE("a solver refuses as many rows as its entry says, and no fewer") {
  for (const char* name : {"pgs", "reference"}) {
    const int most = solver_entry(name).max_rows;
    const auto solver = make_solver<double>(name, {.iterations = 0});
    VelocityProblem<double> problem = testing::hand_made_stack<double>(most + 1, 10, 0.5);
    CHECK_THROWS_AS(solver->solve(problem), std::length_error);
  }
  CHECK(solver_entry("si").max_rows == SolverEntry::no_limit);
}

TEST_CASE("entries say which solvers sweeps, order, relaxation and a warm start mean something to") {
  for (const SolverEntry& entry : solver_entries()) {
    CAPTURE(entry.name);
    // Two boxes: the order decides what the first sweep finds.
    VelocityProblem<double> forward = testing::hand_made_stack<double>(2, 10, 0.5);
    VelocityProblem<double> backward = forward;
    make_solver<double>(entry.name, {.iterations = 1})->solve(forward);
    make_solver<double>(entry.name, {.iterations = 1, .order = RowOrder::reverse})->solve(backward);
    CHECK((forward.impulse != backward.impulse) == entry.uses_order);
    VelocityProblem<double> none = testing::hand_made_stack<double>(2, 10, 0.5);
    make_solver<double>(entry.name, {.iterations = 0})->solve(none);
    CHECK((forward.impulse != none.impulse) == entry.uses_sweeps);
    VelocityProblem<double> warm = testing::hand_made_stack<double>(2, 10, 0.5);
    warm.impulse[0] = 1;  // N s
    make_solver<double>(entry.name, {.iterations = 0})->solve(warm);
    CHECK((warm.impulse != none.impulse) == entry.uses_warm_start);
    VelocityProblem<double> slow = testing::hand_made_stack<double>(2, 10, 0.5);
    make_solver<double>(entry.name, {.iterations = 1, .relaxation = 0.5})->solve(slow);
    CHECK((forward.impulse != slow.impulse) == entry.uses_relaxation);
  }
}

TEST_CASE(
    "a sweep counts for an update of each row, a linear system for as many as it takes as long, and both add "
    "up") {
  CHECK(solver_entry("newton").updates_a_row == 15);
  for (const SolverEntry& entry : solver_entries()) {
    CAPTURE(entry.name);
    CHECK(counted_updates(entry, 3 * 4, 5 * 4) == (3 * entry.updates_a_row + 5) * 4);
  }
}
