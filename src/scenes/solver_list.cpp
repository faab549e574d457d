// Floor 8. The solvers by name.
#include <cairn/scenes/solver_list.hpp>

#include <concepts>

#include <cairn/math/check.hpp>
#include <cairn/math/nearest.hpp>
#include <cairn/solvers/iterative/accelerated_projected_gauss_seidel.hpp>
#include <cairn/solvers/iterative/block_sequential_impulse.hpp>
#include <cairn/solvers/iterative/factored_projected_gauss_seidel.hpp>
#include <cairn/solvers/iterative/jacobi.hpp>
#include <cairn/solvers/exact/newton_solver.hpp>
#include <cairn/solvers/iterative/projected_gauss_seidel.hpp>
#include <cairn/solvers/exact/reference_solver.hpp>
#include <cairn/solvers/iterative/sequential_impulse.hpp>
#include <cairn/solvers/iterative/sparse_projected_gauss_seidel.hpp>
#include <cairn/solvers/wide/wide_sequential_impulse.hpp>
#include <cairn/math/list.hpp>
#ifdef CAIRN_HAVE_OPENCL
#include <cairn/device/opencl_jacobi.hpp>
#endif

namespace cairn {

namespace {

const double jacobi_damping = 0.5;  // omega of "jacobi-damped"

template <Scalar Real>
std::unique_ptr<Solver<Real>> damped_jacobi(const SolverSettings& settings) {
  check(settings, "Jacobi");  // before a relaxation out of range is made one within
  SolverSettings damped = settings;
  damped.relaxation *= jacobi_damping;
  return std::make_unique<Jacobi<Real>>(damped);
}

/// It has no use for settings, but they must be right.
template <Scalar Real>
std::unique_ptr<Solver<Real>> reference(const SolverSettings& settings) {
  check(settings, "ReferenceSolver");
  return std::make_unique<ReferenceSolver<Real>>();
}

template <Scalar Real>
std::unique_ptr<Solver<Real>> opencl_jacobi([[maybe_unused]] const SolverSettings& settings) {
  const std::string refusal = opencl_jacobi_refusal<Real>();
  require(refusal.empty(), "make_solver", "solver", refusal, opencl_jacobi_entry().name);
#ifdef CAIRN_HAVE_OPENCL
  return std::make_unique<OpenClJacobi<Real>>(settings);
#else
  return nullptr;  // refused above
#endif
}

/// The entry of a class of solvers: its makers, and what else it says.
template <typename InFloat, typename InDouble, typename... Variant>
SolverEntry entry_of(SolverEntry entry, Variant... variant) {
  entry.make_float = [=](const SolverSettings& settings) {
    return std::make_unique<InFloat>(settings, variant...);
  };
  entry.make_double = [=](const SolverSettings& settings) {
    return std::make_unique<InDouble>(settings, variant...);
  };
  return entry;
}

const SolverEntry& known_solver(const std::string& name, const char* place) {
  for (const SolverEntry& entry : solver_entries()) {
    if (entry.name == name) return entry;
  }
  List<std::string> known = solver_names();
  known.push_back(opencl_jacobi_entry().name);
  require_known(name, known, place, "solver");
  return opencl_jacobi_entry();
}

}  // namespace

const List<SolverEntry>& solver_entries() {
  // What sweeps cost is what measured_prices() (study/tuning/sweep_price.hpp) found, optimised: the median of
  // the frozen problems, and for lanes less than there, as most problems have more rows.
  static const List<SolverEntry> entries = {
      entry_of<SequentialImpulse<float>, SequentialImpulse<double>>(
          {.name = "si", .title = "sequential impulses", .cost = "12 m a sweep, memory m", .tuned = true}),
      entry_of<ProjectedGaussSeidel<float>, ProjectedGaussSeidel<double>>(
          {.name = "pgs",
           .title = "PGS on a dense A",
           .cost = "m^2 a sweep, memory m^2",
           .max_rows = ProjectedGaussSeidel<double>::max_rows}),
      entry_of<SparseProjectedGaussSeidel<float>, SparseProjectedGaussSeidel<double>>(
          {.name = "pgs-sparse",
           .title = "PGS on A without its zeros",
           .cost = "the non-zeros of A a sweep, and as much memory",
           .work_of_a_sweep = 1.6}),
      entry_of<FactoredProjectedGaussSeidel<float>, FactoredProjectedGaussSeidel<double>>(
          {.name = "pgs-factored",
           .title = "PGS on A in two factors",
           .cost = "12 m a sweep, memory 12 m",
           .work_of_a_sweep = 1.4}),
      entry_of<Jacobi<float>, Jacobi<double>>({.name = "jacobi",
                                               .title = "Jacobi, all rows at once",
                                               .cost = "12 m a sweep, memory 2 m",
                                               .work_of_a_sweep = 0.7,
                                               .uses_order = false}),
      {.name = "jacobi-damped",
       .title = "Jacobi with half of every correction",
       .cost = "12 m a sweep, memory 2 m",
       .work_of_a_sweep = 0.7,
       .uses_order = false,
       .make_float = damped_jacobi<float>,
       .make_double = damped_jacobi<double>},
      entry_of<Jacobi<float>, Jacobi<double>>({.name = "jacobi-split",
                                               .title = "Jacobi with split masses",
                                               .cost = "12 m a sweep, memory 2 m",
                                               .work_of_a_sweep = 0.7,
                                               .uses_order = false},
                                              Splitting::mass),
      entry_of<BlockSequentialImpulse<float>, BlockSequentialImpulse<double>>(
          {.name = "block",
           .title = "sequential impulses, joints as blocks",
           .cost = "12 m a sweep and n^2 for a joint of n rows, memory linear in m",
           .work_of_a_sweep = 1.3,
           .tuned = true},
          ContactBlock::none),
      entry_of<BlockSequentialImpulse<float>, BlockSequentialImpulse<double>>(
          {.name = "block-contact",
           .title = "sequential impulses, joints and contact points as blocks",
           .cost = "12 m a sweep and n^2 for a block of n rows, memory linear in m",
           .work_of_a_sweep = 1.8,
           .tuned = true},
          ContactBlock::normal_and_friction),
      entry_of<AcceleratedProjectedGaussSeidel<float>, AcceleratedProjectedGaussSeidel<double>>(
          {.name = "accelerated",
           .title = "PGS with Nesterov's momentum",
           .cost = "24 m a sweep, memory 2 m and three numbers a body",
           .work_of_a_sweep = 1.8,
           .tuned = true}),
      entry_of<WideSequentialImpulse<float>, WideSequentialImpulse<double>>(
          {.name = "wide",
           .title = "sequential impulses, 16 blocks at a time",
           .cost = "12 m a sweep, 16 rows at a time, memory 20 m",
           .work_of_a_sweep = 0.3,
           .tuned = true,
           .uses_order = false},
          Momentum::none),
      entry_of<WideSequentialImpulse<float>, WideSequentialImpulse<double>>(
          {.name = "wide-accelerated",
           .title = "PGS with Nesterov's momentum, 16 blocks at a time",
           .cost = "24 m a sweep, 16 rows at a time, memory 21 m",
           .work_of_a_sweep = 0.6,
           .tuned = true,
           .uses_order = false},
          Momentum::nesterov),
      // In level 2 of the study no scene that newton loses with 1 to 16 linear systems a step, at a step of
      // the grid, is held with 32 or 64: none of 738.
      entry_of<NewtonSolver<float>, NewtonSolver<double>>(
          {.name = "newton",
           .title = "Newton's method on sparse factors, from the warm start",
           .cost = "a sparse system a sweep: that of 5 to 40 others; memory 18 numbers a "
                   "pair of bodies, 22 a row",
           .updates_a_row = 15,
           .work_of_a_sweep = 15,
           .most_tried_sweeps = 16,
           .tuned = true,
           .uses_order = false,
           .uses_relaxation = false}),
      {.name = "reference",
       .title = "exact: modes, Lemke's method or Newton's",
       .cost = "m^3 and more, memory 4 m^2",
       .max_rows = ReferenceSolver<double>::most_rows,
       .work_of_a_sweep = 2000,
       .most_tried_sweeps = 1,
       .uses_sweeps = false,
       .uses_order = false,
       .uses_relaxation = false,
       .uses_warm_start = false,
       .make_float = reference<float>,
       .make_double = reference<double>},
  };
  return entries;
}

List<std::string> solver_names(List<std::string> names) {
  for (const SolverEntry& entry : solver_entries()) names.push_back(entry.name);
  return names;
}

const SolverEntry& opencl_jacobi_entry() {
  static const SolverEntry entry = {.name = "opencl-jacobi",
                                    .title = "jacobi-split on an OpenCL device, where there is one",
                                    .cost = "12 m a sweep, all rows at a time, memory 26 m there",
                                    .uses_order = false,
                                    .make_float = opencl_jacobi<float>,
                                    .make_double = opencl_jacobi<double>};
  return entry;
}

const SolverEntry& box2d_entry() {
  static const SolverEntry entry = {.name = "box2d",
                                    .title = "Box2D 2.4.1, beside Cairn",
                                    .uses_order = false,
                                    .uses_relaxation = false,
                                    .uses_world = false};
  return entry;
}

template <Scalar Real>
std::string opencl_jacobi_refusal() {
#ifdef CAIRN_HAVE_OPENCL
  if (has_opencl_device<Real>()) return "";
  const std::string known = std::same_as<Real, double> ? " that has double" : "";
  return "another where there is no OpenCL device" + known +
         " (a driver makes the processor one: pocl-opencl-icd)";
#else
  return "another where Cairn was built without OpenCL (install ocl-icd-opencl-dev, opencl-clhpp-headers and "
         "pocl-opencl-icd, then build again)";
#endif
}

std::int64_t counted_updates(const SolverEntry& solver, std::int64_t row_iterations,
                             std::int64_t extra_row_sweeps) {
  return row_iterations * solver.updates_a_row + extra_row_sweeps;
}

const SolverEntry& solver_entry(const std::string& name) {
  return name == box2d_entry().name ? box2d_entry() : known_solver(name, "solver_entry");
}

template <Scalar Real>
std::unique_ptr<Solver<Real>> make_solver(const std::string& name, const SolverSettings& settings) {
  const SolverEntry& entry = known_solver(name, "make_solver");
  if constexpr (std::same_as<Real, float>) {
    return entry.make_float(settings);
  } else {
    return entry.make_double(settings);
  }
}

template std::string opencl_jacobi_refusal<float>();
template std::string opencl_jacobi_refusal<double>();
template std::unique_ptr<Solver<float>> make_solver(const std::string&, const SolverSettings&);
template std::unique_ptr<Solver<double>> make_solver(const std::string&, const SolverSettings&);

}  // namespace cairn
