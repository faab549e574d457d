// The families of solvers.
#include "lessons/playground/solver_look.hpp"

namespace cairn::playground {

const render::SeriesStyle& look_of(const render::Theme& theme, const std::string& solver) {
  if (solver == "newton" || solver == "reference") return theme.exact;
  if (solver == "box2d") return theme.box2d;
  if (solver.starts_with("jacobi")) return theme.jacobi;
  if (solver.starts_with("pgs") || solver == "accelerated") return theme.pgs;
  return theme.si;  // row by row, in blocks, or many blocks at a time
}

}  // namespace cairn::playground
