// Lesson 09. The three scenes in lines and rows, and what has to be true of them.
#include "lesson.hpp"

namespace cairn::drift {

void print_scenes(Lesson& lesson, const DriftRuns& all) {
  lesson.print(
      "Scenes: a ball in the ground, a pendulum, a hanging weight; one row each, and one push a step");
  lesson.print(
      fmt::format("        1 kg, g = {:g} m/s², Δt = {:.4g} s; β = {:g} unless a table says otherwise",
                  gravity, all.settings.dt, all.settings.beta));
}

void print_swings(Lesson& lesson, const DriftRuns& all) {
  lesson.print(fmt::format("2. A pendulum of {:g} m, let go level with its pivot, after {:g} s:", rod_length,
                           swing_time));
  lesson.print("   β       error c of the length (m)   largest c     energy (J), 0 if it were exact");
  for (const RodRun& run : all.swings) {
    lesson.print(fmt::format("   {:<7g} {:>20.4f} {:>17.4f} {:>15.3f}", run.beta, run.error.back(),
                             *std::max_element(run.error.begin(), run.error.end()), run.energy));
  }
  lesson.print();
}

void print_hangs(Lesson& lesson, const DriftRuns& all) {
  lesson.print("3. A weight hangs on a rod, 100 mm too low. c ← c + ζ Δt = (1 − β) c, in mm:");
  lesson.print("   β     start   step 1   step 2   step 3   step 4   step 5");
  for (const RodRun& run : all.hangs) {
    std::string line = fmt::format("   {:<4g}", run.beta);
    for (int k = 0; k <= 5; ++k) line += fmt::format(" {:>8.3f}", cleaned(1000 * run.error[k]));
    const char* verdict = run.beta > 2 ? "   grows" : run.beta > 1 ? "   overshoots" : "";
    lesson.print(line + verdict);
  }
  lesson.print();
}

void print_balls(Lesson& lesson, const DriftRuns& all) {
  const DriftSettings& settings = all.settings;
  lesson.print(fmt::format("1. A ball of 1 kg begins {:g} mm inside the ground:", 1000 * settings.depth));
  for (const double beta : ascending({settings.beta, 1})) {
    const BallRun& ball = ball_of(all, beta);
    for (int k = 1; k <= 4; ++k) {
      const double free = ball.speed[k - 1] - gravity * settings.dt;
      lesson.print(fmt::format(
          "   β = {:g}, step {}  (22) λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt) = ({:.4f} − ({:.4f})) / "
          "{:.4g} = {:.4f} N{}",
          beta, k, cleaned(ball.zeta[k]), free, settings.dt, cleaned((ball.zeta[k] - free) / settings.dt),
          ball.zeta[k] < free - 1e-9 ? ": clamped to 0" : ""));
    }
  }
  lesson.print("   β       λ (N), step 1        2        3        4   fastest (m/s)   rises to (m)");
  for (const BallRun& run : all.balls) {
    lesson.print(fmt::format("   {:<7g} {:>13.2f} {:>8.2f} {:>8.2f} {:>8.2f} {:>15.3f} {:>13.4f}", run.beta,
                             run.lambda[1], cleaned(run.lambda[2]), cleaned(run.lambda[3]),
                             cleaned(run.lambda[4]), *std::max_element(run.speed.begin(), run.speed.end()),
                             std::max(run.peak, 0.0)));
  }
  lesson.print();
}

void print_limits(Lesson& lesson, const DriftRuns& all) {
  lesson.print("   How deep may it begin so that the ground still pushes in step 2?  g Δt² / β², in mm:");
  std::string names = "   β       ";
  std::string formula = "   formula ";
  std::string measured = "   measured";
  for (const DepthLimit& limit : all.limits) {
    names += fmt::format(" {:>8g}", limit.beta);
    formula += fmt::format(" {:>8.3f}", 1000 * limit.formula);
    measured += fmt::format(" {:>8.3f}", 1000 * limit.measured);
  }
  for (const std::string& line : {names, formula, measured}) lesson.print(line);
  lesson.print(
      fmt::format("   Slop: β acts on what is deeper than {:g} mm, and the ball ends {:.3f} mm deep.",
                  1000 * slop_tried, -1000 * all.with_slop.height.back()));
  lesson.print();
}

void check_rods(Lesson& lesson, const DriftRuns& all) {
  const RodRun& free = swing_of(all, 0);
  const RodRun& held = swing_of(all, all.settings.beta);
  double gap = 0;
  for (const RodRun& run : all.swings) gap = std::max(gap, run.gap);
  // A step rounds some ten times, at the size of the rod and of what it moves in a step.
  lesson.check_small("pendulum: c after a step = |(L + (1 − β) c, v Δt)| − L (m)", gap, 64 * epsilon * 4);
  const bool never_shrinks =
      std::is_sorted(free.error.begin(), free.error.end(), [](double newer, double older) {
        return newer < older - 64 * epsilon * 4;  // the same rounding
      });
  lesson.check_that("β = 0: the error never becomes smaller", never_shrinks,
                    fmt::format("{:.4f}", free.error.back()));
  // c' <= (1 - beta) c + (v dt)^2 / 2 L, as |(x, y)| <= x + y^2 / 2 x: a geometric series.
  const double step = held.fastest * all.settings.dt;
  const double bound = step * step / (2 * rod_length * all.settings.beta);
  lesson.check_small(fmt::format("β = {:g}: c stays below (v Δt)² / (2 L β) (m)", all.settings.beta),
                     *std::max_element(held.error.begin(), held.error.end()), bound * (1 + 1e-9));
  double series = 0;
  double largest = 1;
  for (const RodRun& run : all.hangs) {
    for (int k = 0; k < run.error.size(); ++k) {
      const double power = std::pow(1 - run.beta, static_cast<double>(k));
      series = std::max(series, std::abs(run.error[k] - hang_error * power));
      largest = std::max(largest, std::abs(power));
    }
  }
  // Each step rounds at the size of the rod, and |1 - beta| carries it on.
  lesson.check_small("weight: c = 0.1 m × (1 − β)ᵏ, for every β (m)", series,
                     64 * epsilon * hang_steps * largest);
}

void check_balls(Lesson& lesson, const DriftRuns& all) {
  const DriftSettings& settings = all.settings;
  double gap = all.with_slop.gap;
  double highest = 1;
  for (const BallRun& run : all.balls) {
    gap = std::max(gap, run.gap);
    highest = std::max(highest, run.peak);
  }
  // Some ten roundings a step, at the size of the height; velocities keep theirs for all the steps after.
  const double steps = all.balls[0].steps.size();
  const double rounding = 16 * epsilon * steps * (highest + 1) * (1 + steps * settings.dt);
  lesson.check_small("ball: v = max(v − g Δt, ζ) by hand, every step (m)", gap, rounding);
  const BallRun& ball = ball_of(all, settings.beta);
  const double wanted = settings.beta * settings.depth / settings.dt;  // zeta of step 1
  const double free = wanted - gravity * settings.dt;
  const double zeta = (1 - settings.beta) * wanted;
  lesson.check_equal("ball: λ of step 1 = (β d / Δt + g Δt) m / Δt (N)", ball.lambda[1],
                     wanted / settings.dt + gravity, rounding / settings.dt / settings.dt);
  lesson.check_equal("ball: λ of step 2 = max(0, g − β² d / Δt²) m (N)", ball.lambda[2],
                     std::max(0.0, zeta - free) / settings.dt, rounding / settings.dt / settings.dt);
  lesson.check_equal("β = 1: rises to n d − g Δt² n (n + 1)/2, n = floor(d / (g Δt²)) (m)",
                     ball_of(all, 1).peak, hop_by_formula(settings), rounding);
}

void check_limits(Lesson& lesson, const DriftRuns& all) {
  const DriftSettings& settings = all.settings;
  double gap = 0;
  for (const DepthLimit& limit : all.limits) {
    // Speeds of beta d / dt and positions of 1 m are rounded; beta^2 d / dt is what is compared.
    const double roundings = 16 * epsilon * (1 + 1 / limit.beta) / limit.beta;
    gap = std::max(gap, std::abs(limit.measured - limit.formula) / roundings);
  }
  lesson.check_small("deepest that is held = g Δt² / β² (gap / allowed rounding)", gap, 1);
  const BallRun& ball = all.with_slop;
  const double k = ball.height.size() - 1;
  lesson.check_equal(
      "slop: depth = slop + (d − slop) (1 − β)ᵏ at the end (m)", -ball.height.back(),
      slop_tried + (-ball.height[0] - slop_tried) * std::pow(1 - settings.beta, k),
      64 * epsilon / settings.beta);  // positions of about 1 m, and beta forgets the older roundings
}

CsvTable balls_table(const DriftRuns& all) {
  CsvTable table{
      .header = {"scene", "beta", "step", "error_metre", "speed_metre_per_second", "zeta", "lambda_newton"}};
  for (const BallRun& run : all.balls) {
    for (int k = 0; k < run.height.size(); ++k) {
      table.rows.push_back({"ball", run.beta, k, run.height[k], run.speed[k], run.zeta[k], run.lambda[k]});
    }
  }
  const auto rods = [&](const char* scene, const auto& runs) {
    for (const auto& run : runs) {
      for (int k = 0; k < run.error.size(); ++k) {
        table.rows.push_back({scene, run.beta, k, run.error[k], 0.0, 0.0, 0.0});
      }
    }
  };
  rods("pendulum", all.swings);
  rods("weight", all.hangs);
  return table;
}

}  // namespace cairn::drift
