// Floor 4. The way through the interior of all bounds.
#include <algorithm>

#include <cairn/math/deadline.hpp>
#include <cairn/solvers/exact/island_newton.hpp>

namespace cairn {

namespace {

constexpr int most_attempts = 3;
constexpr int steps_of_one_attempt = 40;
constexpr double first_distance = 10;  // from bounds, beside the mean of what is left of R_E
constexpr double share_of_way = 0.99;  // to the next bound
constexpr double least_share = 1e-3;   // below it, bounds are in the way
// Whole steps that leave most of R_E, so many in a row, lead nowhere: what systems are softer by holds it.
constexpr double whole_share = 0.98;
constexpr double least_progress = 0.5;
constexpr int most_idle = 3;

}  // namespace

/// From the best impulses so far, and from farther inside where bounds are in the way.
void IslandNewton::follow_interior() {
  double factor = 1;
  for (int attempt = 0; attempt < most_attempts; ++attempt, factor *= 10) {
    go_to(best_.impulse);
    const double distance = first_distance * factor * center_.error_of_a_row();
    if (!interior_.begin(rows_, center_, distance)) return;
    double share = 1;
    int idle = 0;
    for (int step = 0; step < steps_of_one_attempt && share > least_share; ++step) {
      if (best_.residual <= enough() || done_.iterations >= settings_.iterations || idle == most_idle) return;
      const double before = residual();
      share = take_interior_step();
      idle = share >= whole_share && residual() > least_progress * before ? idle + 1 : 0;
    }
    if (best_.residual <= enough()) return;
  }
}

/// As Mehrotra does: a step for 0 shows how far the products may be asked to fall, and their second order.
double IslandNewton::take_interior_step() {
  Deadline::go_on();
  interior_.linearize(rows_, center_.error_of_a_row());
  ++done_.iterations;
  factors_.factorize(rows_, interior_, 0.0);
  const auto aim = [this](double target) {
    interior_.find_direction(rows_, target, change_, [this] { factors_.solve(change_); });
  };
  aim(0);
  const double product = interior_.mean_product(0);
  const double left =
      product > 0 ? interior_.mean_product(std::min(1.0, interior_.longest_step())) / product : 0;
  interior_.keep_products();
  aim(left * left * left * product);
  const double share = std::min(1.0, share_of_way * interior_.longest_step());
  if (!change_.allFinite()) return 0;
  interior_.go(rows_, share);
  PerRow<double> inside;
  rows_.copy_impulses(interior_.x(), inside);
  go_to(inside);
  return share;
}

}  // namespace cairn
