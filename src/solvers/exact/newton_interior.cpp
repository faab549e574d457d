// Floor 4. The way through the interior of all bounds.
#include <algorithm>

#include "math/deadline.hpp"
#include "solvers/exact/newton_solver.hpp"

namespace cairn {

namespace {

constexpr int most_attempts = 3;
constexpr int steps_of_one_attempt = 40;
constexpr double first_distance = 10;  // from bounds, beside the mean of what is left of R_E
constexpr double share_of_way = 0.99;  // to the next bound
constexpr double least_share = 1e-3;   // below it, bounds are in the way

}  // namespace

/// From the best impulses so far, and from farther inside where bounds are in the way.
template <Scalar Real>
void NewtonSolver<Real>::follow_interior() {
  double factor = 1;
  for (int attempt = 0; attempt < most_attempts; ++attempt, factor *= 10) {
    rows_.center_at(best_);
    note_center();
    const double distance = first_distance * factor * rows_.error_of_a_row();
    if (!interior_.begin(rows_, distance)) return;
    double share = 1;
    for (int step = 0; step < steps_of_one_attempt && share > least_share; ++step) {
      if (least_residual_ <= enough() || systems_ >= settings_.iterations) break;
      share = take_interior_step();
    }
    if (least_residual_ <= enough()) return;
  }
}

/// As Mehrotra does: a step for 0 shows how far the products may be asked to fall, and their second order.
template <Scalar Real>
double NewtonSolver<Real>::take_interior_step() {
  Deadline::go_on();
  interior_.linearize();
  ++systems_;
  factors_.factorize(rows_, interior_);
  const auto aim = [this](double target) {
    interior_.find_right_side(target, change_);
    factors_.solve(change_);
    interior_.find_direction(target, change_);
  };
  aim(0);
  const double product = interior_.mean_product(0);
  const double left =
      product > 0 ? interior_.mean_product(std::min(1.0, interior_.longest_step())) / product : 0;
  interior_.keep_products();
  aim(left * left * left * product);
  const double share = std::min(1.0, share_of_way * interior_.longest_step());
  if (!change_.allFinite()) return 0;
  interior_.go(share);
  interior_.copy_impulses_to(inside_);
  rows_.center_at(inside_);
  note_center();
  return share;
}

template void NewtonSolver<float>::follow_interior();
template void NewtonSolver<double>::follow_interior();

}  // namespace cairn
