// Floor 8. The solvers that closed forms are asked of: a new solver is one line here.
#pragma once

#include <functional>
#include <memory>

#include <cairn/solvers/iterative/accelerated_projected_gauss_seidel.hpp>
#include <cairn/solvers/iterative/block_sequential_impulse.hpp>
#include <cairn/solvers/iterative/factored_projected_gauss_seidel.hpp>
#include <cairn/solvers/iterative/jacobi.hpp>
#include <cairn/solvers/iterative/naive_projected_gauss_seidel.hpp>
#include <cairn/solvers/iterative/projected_gauss_seidel.hpp>
#include <cairn/solvers/iterative/sequential_impulse.hpp>
#include <cairn/solvers/iterative/sparse_projected_gauss_seidel.hpp>
#include <cairn/solvers/wide/wide_sequential_impulse.hpp>
#include <cairn/math/list.hpp>

namespace cairn::cases {

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

/// Sequential impulses in lanes, with momentum.
template <Scalar Real>
std::unique_ptr<Solver<Real>> wide_accelerated(const SolverSettings& settings) {
  return std::make_unique<WideSequentialImpulse<Real>>(settings, Momentum::nesterov);
}

/// What a case wants of the solvers that it asks for.
enum class Iterates {
  of_gauss_seidel,  // after every sweep they have the impulses of Gauss-Seidel, but for rounding
  any,              // they come to the same answer in their own way
};

template <Scalar Real>
List<SolverMaker<Real>> all_solvers(Iterates iterates = Iterates::of_gauss_seidel) {
  List<SolverMaker<Real>> solvers = {
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
  solvers.push_back(maker<WideSequentialImpulse<Real>, Real>());
  solvers.push_back(wide_accelerated<Real>);
  return solvers;
}

/// The solvers of the paper, for cases that take long.
template <Scalar Real>
List<SolverMaker<Real>> paper_solvers() {
  return {maker<SequentialImpulse<Real>, Real>(), maker<ProjectedGaussSeidel<Real>, Real>()};
}

}  // namespace cairn::cases
