// Floor 8. The solvers by name.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>

#include <cairn/solvers/solver.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// All there is to know of a solver but for its code: how it is made, what tables and lists of choices say of
/// it, what its work costs, and which settings mean anything to it.
struct SolverEntry {
  static constexpr int no_limit = std::numeric_limits<int>::max();

  std::string name = {};    // as in make_solver
  std::string title = {};   // a few words
  std::string cost = {};    // of one sweep over m rows, and of its memory
  int max_rows = no_limit;  // more are refused with std::length_error
  /// How many updates of each row one of its iterations counts for, where work is counted: a linear system
  /// for as many as the sweeps of SequentialImpulse that take as long, between 5 in a stack and 40 in a grid.
  int updates_a_row = 1;
  /// What a sweep costs, or a solve without sweeps: in sweeps of sequential impulses. The one price by which
  /// the work of different solvers is compared; study/tuning/sweep_price.hpp measures it.
  double work_of_a_sweep = 1;
  int most_tried_sweeps = 256;  // by a tuner
  bool tuned = false;           // whether a tuner tries it if nobody says which
  bool uses_sweeps = true;      // SolverSettings::iterations
  bool uses_order = true;       // SolverSettings::order
  bool uses_relaxation = true;  // SolverSettings::relaxation
  bool uses_warm_start = true;  // the impulses of the last step
  /// Setting::scalar, stabilization, contact_search: those of a world of Cairn.
  bool uses_world = true;
  std::function<std::unique_ptr<Solver<float>>(const SolverSettings&)> make_float = {};
  std::function<std::unique_ptr<Solver<double>>(const SolverSettings&)> make_double = {};

  /// Its iterations are linear systems, and mostly the first solves a problem: their number is only a limit.
  bool ends_by_itself() const { return updates_a_row > 1; }
};

/// Row updates of so many rows times iterations, by SolverEntry::updates_a_row, and of rows times extra
/// sweeps.
std::int64_t counted_updates(const SolverEntry& solver, std::int64_t row_iterations,
                             std::int64_t extra_row_sweeps);

/// All of them, the plainest first.
const List<SolverEntry>& solver_entries();

/// Their names, behind those that are given.
List<std::string> solver_names(List<std::string> names = {});

/// "opencl-jacobi", OpenClJacobi. It is not one of solver_entries(): every build and every machine has those.
const SolverEntry& opencl_jacobi_entry();

/// "box2d", the contestant that is no solver of Cairn: make_solver() cannot make it.
const SolverEntry& box2d_entry();

/// Why "opencl-jacobi" cannot be made, as the rule of a message and with what to install; empty where it can.
template <Scalar Real>
std::string opencl_jacobi_refusal();

/// "jacobi-damped" is Jacobi with half of every correction: settings.relaxation multiplies that half.
/// @throws std::invalid_argument for an unknown name, with the nearest known one, for settings out of range,
/// and for "opencl-jacobi" by opencl_jacobi_refusal().
template <Scalar Real>
std::unique_ptr<Solver<Real>> make_solver(const std::string& name, const SolverSettings& settings = {});

/// One of solver_entries(), opencl_jacobi_entry() or box2d_entry().
/// @throws std::invalid_argument for an unknown name.
const SolverEntry& solver_entry(const std::string& name);

}  // namespace cairn
