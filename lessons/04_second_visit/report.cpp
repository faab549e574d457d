// Prints the visits and what becomes of the box, and checks them against formulas, a second account and the
// library.
#include "lesson.hpp"

namespace cairn::feet {

namespace {

const char* name_of(Clamped clamped) { return clamped == Clamped::sum ? "the sum" : "each push"; }

void print_landings(Lesson& lesson, const BoxRun& box) {
  lesson.print(
      fmt::format("{:<25} left (N s) right (N s)  together   v (m/s)  ω (rad/s)  energy (J)", "in the end"));
  for (const Landing& landing : box.landings) {
    lesson.print(fmt::format("  clamped: {:<16} {:>10.4f} {:>11.4f} {:>9.4f} {:>+9.4f} {:>+10.4f} {:>11.4f}",
                             name_of(landing.clamped), landing.impulse[0], landing.impulse[1],
                             landing.together(), cleaned(landing.velocity.y()) + 0.0,
                             cleaned(landing.velocity.z()) + 0.0, landing.energy()));
  }
  lesson.print(fmt::format("  exact                     {:>10.4f} {:>11.4f} {:>9.4f}", box.exact[0],
                           box.exact[1], box.exact[0] + box.exact[1]));
}

double largest_gap(const Pair& a, const Pair& b) {
  return std::max(std::abs(a[0] - b[0]), std::abs(a[1] - b[1]));
}

/// The largest difference to the library's own two clamps [N s].
double gap_to_library(const BoxRun& box, const FeetSettings& settings) {
  double largest = 0;
  for (const Clamp clamp : {Clamp::increment, Clamp::accumulated}) {
    VelocityProblem<double> problem = landing_problem(box.foot, settings.speed);
    SequentialImpulse<double>({.iterations = settings.sweeps}, {.clamp = clamp}).solve(problem);
    const Clamped ours = clamp == Clamp::increment ? Clamped::increment : Clamped::sum;
    largest = std::max(largest, largest_gap({problem.impulse[0], problem.impulse[1]}, box.by(ours).impulse));
  }
  return largest;
}

void check_sums(Lesson& lesson, const FeetRun& run) {
  const BoxRun& box = run.box;
  const double speed = run.settings.speed;
  const double visits = box.by(Clamped::sum).visits.size();
  // A visit rounds j v, the quotient and the sum: a few times half an ulp of the largest impulse.
  const double rounding = 4 * epsilon * visits * box_mass * speed;
  double gap = 0;
  for (int sweep = 1; sweep <= run.settings.sweeps; ++sweep) {
    const Visit& last = box.by(Clamped::sum).visits[2 * sweep - 1];
    gap = std::max(gap, largest_gap(last.after, sums_by_formula(box, speed, sweep)));
  }
  lesson.check_small("the sum: m v/2 (1 + q²ᵏ⁻¹), m v/2 (1 − q²ᵏ) after k sweeps (N s)", gap, rounding);
  lesson.check_small("the same sums, computed a second way (N s)",
                     largest_gap(box.of_matrix, box.by(Clamped::sum).impulse), rounding);
  lesson.check_small("the library's solver with either clamp: the same bits (N s)",
                     gap_to_library(box, run.settings), 0);
  if (box.A12 > 0) {
    const Landing& naive = box.by(Clamped::increment);
    lesson.check_small("each push: nothing after the first sweep, v/A₁₁ + v/A₁₁ (1 − q) (N s)",
                       largest_gap(naive.impulse, increments_by_formula(box, speed)), rounding);
    // Of the two impulses, over the mass.
    lesson.check_equal("and the box leaves at v q (1 − q) / 2 (m/s)", naive.velocity.y(),
                       speed * (box.A12 / box.A11) * (1 - box.A12 / box.A11) / 2, 2 * rounding / box_mass);
  }
  double harmless = 0;
  double formula = 0;
  for (const Spread& spread : run.spreads) {
    if (spread.foot > harmless_distance()) harmless = std::max(harmless, spread.gap);
    // Beyond, further sweeps change what the first has given, and the formula is not for that.
    if (spread.foot > harmless_distance()) continue;
    formula = std::max({formula, std::abs(spread.speed - spread.formula_speed),
                        std::abs(spread.spin - spread.formula_spin)});
  }
  lesson.check_small("feet beyond √(I/m), A₁₂ < 0: both clamps, the same bits (N s)", harmless, 0);
  lesson.check_small("nearer: v and ω of each push clamped, by formula (m/s, rad/s)", formula, 2 * rounding);
}

void check_rest(Lesson& lesson, const FeetRun& run) {
  const double speed = run.settings.speed;
  const double rounding = 8 * epsilon * run.settings.sweeps * box_mass * speed;  // as above
  const Landing& naive = run.box.by(Clamped::increment);
  // The ground is met to within rounding of the heights, which a row takes for a speed: over dt.
  lesson.check_small("in the world: the same velocity after the first step (m/s, rad/s)",
                     (run.hop[1].bodies[{1}].velocity - naive.velocity).cwiseAbs().maxCoeff(),
                     rounding + 16 * epsilon / time_step * speed);
  const double q = std::abs(run.box.A12 / run.box.A11);
  const double left = std::pow(q, 2 * run.settings.sweeps - 1);
  if (left > 0.01) return;
  // Every step leaves this share of what it stops: the landing once, then g dt again and again. The box rises
  // by no more than all that is left for a step each, and by rounding.
  const double all_stopped = speed + 2 * motion_steps * gravity * time_step;
  lesson.check_small("in the world: with the sum clamped, the box does not rise (m)", run.still_height,
                     time_step * left * all_stopped + 1e-12);
}

}  // namespace

std::string question_of(const FeetRun& run) {
  const List<Visit>& visits = run.box.by(Clamped::sum).visits;
  return fmt::format(
      "A box of {:g}\u00a0kg lands at {:g}\u00a0m/s on feet at ±{:g}\u00a0m. First the left foot stops "
      "itself "
      "with {:.2f}\u00a0N\u00a0s, then the right one with {:.2f}\u00a0N\u00a0s. Now the left foot moves at "
      "{}\u00a0m/s. A contact must not pull. How much has the left foot given in all after its second visit, "
      "in N\u00a0s?",
      box_mass, run.settings.speed, run.settings.foot, visits[0].after[0], visits[1].after[1],
      fixed(visits[2].jv, 2, Sign::always));
}

void tell_scene(Lesson& lesson, const FeetRun& run) {
  const FeetSettings& settings = run.settings;
  lesson.print(
      fmt::format("Scene: {:g} kg, I = {:g} kg m², feet at −{:g} and {:g} m, lands at {:g} m/s; A = "
                  "[{:.4g} {:.4g}; {:.4g} {:.4g}] kg⁻¹",
                  box_mass, box_inertia, settings.foot, settings.foot, settings.speed, run.box.A11,
                  run.box.A12, run.box.A12, run.box.A22));
}

void tell_visits(Lesson& lesson, const FeetRun& run) {
  const List<Visit>& naive = run.box.by(Clamped::increment).visits;
  const List<Visit>& sum = run.box.by(Clamped::sum).visits;
  lesson.print();
  lesson.print("             each push is clamped (m/s, N s)         the sum is clamped (m/s, N s)");
  lesson.print("sweep  foot      j·v    p_corr       p after         j·v    p_corr       p after");
  for (int k = 0; k < sum.size(); ++k) {
    const int foot = sum[k].foot;
    const auto half = [foot](const Visit& visit) {
      return fmt::format("{:>+9.4f} {:>+9.4f} {:>13.4f}", cleaned(visit.jv) + 0.0, cleaned(visit.asked) + 0.0,
                         visit.after[foot]);
    };
    const std::string line =
        fmt::format("{:>5} {:>5} {}   {}", sum[k].sweep, name_of_foot(foot), half(naive[k]), half(sum[k]));
    lesson.print_if(k < 6, line);
  }
  lesson.print(fmt::format("  ...  (-v shows all {} visits)", sum.size()));
  lesson.print();
}

void tell_landings(Lesson& lesson, const FeetRun& run) { print_landings(lesson, run.box); }

void tell_motion(Lesson& lesson, const FeetRun& run) {
  lesson.print();
  lesson.print(fmt::format(
      "In a world that steps on, {:.4g} s later: each push clamped, the box has risen by up to {:.1f} mm "
      "and turned by {:.0f}°;",
      motion_steps * time_step, 1000 * run.hop_height,
      std::abs(run.hop.back().bodies[{1}].pose.angle) * 180 / pi));
  lesson.print(fmt::format("the sum clamped, it has risen by {:.4f} mm and turned by {:.4f}°.",
                           1000 * run.still_height,
                           std::abs(run.still.back().bodies[{1}].pose.angle) * 180 / pi));
  lesson.print();
  std::string feet = "feet at (m)         ";
  std::string ratio = "A_12 / A_11         ";
  std::string speed = "leaves at (m/s)     ";
  for (int k = 4; k < run.spreads.size(); k += 5) {
    feet += fmt::format("{:>7.2f}", run.spreads[k].foot);
    ratio += fmt::format("{:>7.3f}", run.spreads[k].ratio);
    speed += fmt::format("{:>7.3f}", cleaned(run.spreads[k].speed));
  }
  lesson.print(feet);
  lesson.print(ratio);
  lesson.print(speed + "   each push clamped");
  lesson.print();
}

void check_claims(Lesson& lesson, const FeetRun& run) {
  if (run.settings.foot == 0.25 && run.settings.speed == 10) {
    lesson.check_that("the question has the numbers of this run", question_of(run) == card().question, "all");
  }
  check_sums(lesson, run);
  check_rest(lesson, run);
}

CsvTable table_of(const FeetRun& run) {
  CsvTable table{.header = {"clamped", "sweep", "foot", "jv", "p_corr", "p_before", "p_after"}};
  for (const Landing& landing : run.box.landings) {
    for (const Visit& visit : landing.visits) {
      const int foot = visit.foot;
      table.rows.push_back({name_of(landing.clamped), visit.sweep, name_of_foot(visit.foot), visit.jv,
                            visit.asked, visit.before[foot], visit.after[foot]});
    }
  }
  return table;
}

}  // namespace cairn::feet
