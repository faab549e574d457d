// Lesson 18. Speed and accuracy: what does one more digit cost?
// After a few sweeps every further one leaves the same share ρ of the error, so that k sweeps leave about ρᵏ,
// and each digit costs as many sweeps as the one before. A tower of boxes, one step from nothing: four
// solvers, each watched sweep by sweep. One of them differs from SI by a single factor, ω, and needs a
// twelfth of the sweeps. Then larger towers.
#include "lesson.hpp"

namespace {

using namespace cairn;
using namespace cairn::cost;

/// Gauss-Seidel over A λ = b of the tower in plain loops; with ω above 1 it is over-relaxed (SOR).
List<double> errors_by_hand(int n, double omega, int sweeps) {
  const List<double> exact = exact_lambda(n);
  List<double> lambda(n, 0.0);
  List<double> errors = {error_of(lambda, exact)};
  // [sweeps]
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 0; i < n; ++i) {
      double left = (i == 0 ? gravity : 0) - (i == 0 ? 1 : 2) * lambda[i];  // b_i − (A λ)_i, (15)
      if (i > 0) left += lambda[i - 1];
      if (i + 1 < n) left += lambda[i + 1];
      lambda[i] = std::max(0.0, lambda[i] + omega * left / (i == 0 ? 1 : 2));  // (28), Δλ times ω
    }
    errors.push_back(error_of(lambda, exact));  // the load that is most wrong, over the largest
  }
  // [/sweeps]
  return errors;
}

/// Sweeps until least_error, and some: a rate multiplies by itself, SOR's for a while a little more slowly.
int enough_sweeps(double rate) {
  return 200 + static_cast<int>(1.5 * std::log(least_error / 100) / std::log(rate));
}

/// In the order of CostRun::curves.
List<Curve> watch_four(int boxes, double omega) {
  const double cosine = jacobi_rate(boxes);
  List<Curve> curves = {{.name = "SI", .work = 3.0 * boxes - 2, .rate = cosine * cosine},
                        {.name = "Jacobi, ω = ½", .work = 4.0 * boxes - 2, .rate = (1 + cosine) / 2},
                        {.name = fmt::format("SOR, ω = {:.4g}", omega),
                         .work = 4.0 * boxes - 2,
                         .rate = sor_rate(boxes, omega)},
                        {.name = "PGS with momentum", .work = 6.0 * boxes - 4}};
  SequentialImpulse<double> si({.iterations = enough_sweeps(curves[si_curve].rate)});
  Jacobi<double> jacobi({.iterations = enough_sweeps(curves[jacobi_curve].rate), .relaxation = 0.5});
  SequentialImpulse<double> sor(
      {.iterations = std::min(enough_sweeps(curves[sor_curve].rate), 50000), .relaxation = omega});
  AcceleratedProjectedGaussSeidel<double> accelerated({.iterations = 200 + 60 * boxes});
  watch<double>(si, boxes, least_error, curves[si_curve]);
  watch<double>(jacobi, boxes, least_error, curves[jacobi_curve]);
  watch<double>(sor, boxes, least_error, curves[sor_curve]);
  watch<double>(accelerated, boxes, least_error, curves[accelerated_curve]);
  curves[si_curve].by_hand = errors_by_hand(boxes, 1, kept_sweeps);
  curves[sor_curve].by_hand = errors_by_hand(boxes, omega, kept_sweeps);
  return curves;
}

void run(Lesson& lesson) {
  CostRun all{.settings = {.boxes = lesson.whole("bodies"), .omega = lesson.real("omega")}};
  const int boxes = all.settings.boxes;
  lesson.print(
      fmt::format("Scene: {} boxes of 1 kg upon each other, one row each; g = {:g} m/s², Δt = {:g} s; one "
                  "step, from λ = 0",
                  boxes, gravity, time_step));
  lesson.print("       error: the load that is most wrong, over the load of the lowest box");
  lesson.predict();
  all.best_omega = best_relaxation(boxes);
  all.omega = all.settings.omega > 0 ? all.settings.omega : all.best_omega;
  all.curves = watch_four(boxes, all.omega);
  for (const int size : tower_sizes) {
    all.sizes.push_back(sweeps_to_one_percent(size));
    all.sizes.back().by_hand = sweeps_to(errors_by_hand(size, 1, most_sweeps(size)), 0.01);
  }
  look_closer(all);
  report(lesson, all);
  lesson.film(cost_shots(all));
  lesson.data(errors_table(all));
  lesson.fingerprint(all.curves[si_curve].error);
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(cairn::card(), run, argc, argv); }
