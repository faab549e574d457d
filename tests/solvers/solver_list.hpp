// The solvers under test: a new solver is one line here.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "solvers/accelerated_projected_gauss_seidel.hpp"
#include "solvers/block_sequential_impulse.hpp"
#include "solvers/factored_projected_gauss_seidel.hpp"
#include "solvers/jacobi.hpp"
#include "solvers/naive_projected_gauss_seidel.hpp"
#include "solvers/projected_gauss_seidel.hpp"
#include "solvers/sequential_impulse.hpp"
#include "solvers/sparse_projected_gauss_seidel.hpp"

namespace cairn::testing {

template <Scalar Real>
using SolverMaker = std::function<std::unique_ptr<Solver<Real>>(const SolverSettings&)>;

template <typename SolverType, Scalar Real>
SolverMaker<Real> maker() {
  return [](const SolverSettings& settings) { return std::make_unique<SolverType>(settings); };
}

/// The form of Jacobi's method that converges whenever Gauss-Seidel does.
template <Scalar Real>
std::unique_ptr<Solver<Real>> mass_splitting_jacobi(const SolverSettings& settings) {
  return std::make_unique<Jacobi<Real>>(settings, Splitting::mass);
}

/// What a test wants of the solvers that it asks for.
enum class Iterates {
  of_gauss_seidel,  // after every sweep they have the impulses of Gauss-Seidel, but for rounding
  any,              // they come to the same answer in their own way
};

template <Scalar Real>
std::vector<SolverMaker<Real>> all_solvers(Iterates iterates = Iterates::of_gauss_seidel) {
  std::vector<SolverMaker<Real>> solvers = {
      maker<SequentialImpulse<Real>, Real>(),             // Algorithm 1
      maker<ProjectedGaussSeidel<Real>, Real>(),          // A dense
      maker<SparseProjectedGaussSeidel<Real>, Real>(),    // A without its zeros
      maker<FactoredProjectedGaussSeidel<Real>, Real>(),  // A in two factors
      maker<NaiveProjectedGaussSeidel<Real>, Real>(),     // every velocity after every row
  };
  if (iterates == Iterates::of_gauss_seidel) return solvers;
  solvers.push_back(mass_splitting_jacobi<Real>);
  solvers.push_back(maker<AcceleratedProjectedGaussSeidel<Real>, Real>());
  solvers.push_back(maker<BlockSequentialImpulse<Real>, Real>());
  return solvers;
}

/// n boxes of mass 1 kg on the ground, one normal row an interface, falling for one step: row j between j and
/// j + 1.
template <Scalar Real>
VelocityProblem<Real> hand_made_stack(int boxes, Real g, Real dt) {
  VelocityProblem<Real> problem;
  problem.dt = dt;
  problem.velocity.assign(static_cast<std::size_t>(boxes) + 1, Vec3<Real>(0, -g * dt, 0));
  problem.inverse_mass.assign(static_cast<std::size_t>(boxes) + 1, Vec3<Real>(1, 1, 6));
  problem.velocity[0].setZero();
  problem.inverse_mass[0].setZero();
  for (int i = 0; i < boxes; ++i) {
    ConstraintRow<Real> row;
    row.a = {i};
    row.b = {i + 1};
    row.jacobian_a = {0, -1, 0};
    row.jacobian_b = {0, 1, 0};
    row.bounds = Bounds<Real>::unilateral();
    problem.rows.push_back(row);
    problem.blocks.push_back({i, 1});
  }
  problem.impulse.assign(problem.rows.size(), Real(0));
  return problem;
}

}  // namespace cairn::testing
