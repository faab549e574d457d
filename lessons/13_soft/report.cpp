// Lesson 13. What is printed.
#include "lesson.hpp"

namespace cairn::soft {

namespace {

void print_spring(Lesson& lesson, const SoftRuns& all) {
  const SoftSettings& settings = all.settings;
  const double k = stiffness(settings);
  const double d = damping_constant(settings);
  const WeightRun& spring = all.spring;
  lesson.print(fmt::format(
      "1. The row.  k = m (2π f)² = {:.2f} N/m,  d = 2 m (damping ratio) 2π f = {:.3f} N s/m", k, d));
  lesson.print(fmt::format(
      "   γ = 1 / ({:g} × ({:.3f} + {:.3f})) = {:.4g} 1/kg,   β = {:.3f} / {:.3f} = {:.4f}", settings.dt, d,
      settings.dt * k, spring.gamma, settings.dt * k, d + settings.dt * k, spring.beta));
  for (int step = 1; step <= 3; ++step) {
    const StepRow& row = spring.rows[step];
    lesson.print(fmt::format(
        "   step {}  ζ = {:7.4f}   λ = ({:.4f} − ({:.4f})) / (({:g} + {:.4g}) × {:g}) = {:.4f} N", step,
        row.zeta, row.zeta, row.free, 1 / settings.mass, spring.gamma, settings.dt, row.lambda));
  }
  lesson.print(fmt::format(
      "   −k c − d v: {:.4f} N at the beginning of step 1, {:.4f} − {:.4f} N at its end, {:.2f} mm up",
      k * settings.pressed, -k * spring.error[1], d * spring.speed[1],
      1000 * (settings.pressed + spring.error[1])));
  lesson.print("   t (s)    c (mm): exact     soft row   γ = 0, same β      λ (N): soft row        γ = 0");
  for (const double time : {0.1, 0.2, 0.5, 1.0}) {
    const int step = static_cast<int>(std::lround(time / settings.dt));
    lesson.print(fmt::format("   {:<6g} {:>16.2f} {:>12.2f} {:>15.3f} {:>20.3f} {:>13.3f}", time,
                             1000 * exact_error(settings, time), 1000 * spring.error[step],
                             cleaned(1000 * all.rigid.error[step]), spring.rows[step].lambda,
                             all.rigid.rows[step].lambda));
  }
  lesson.print(fmt::format("   At rest: c = {:.4f} mm, λ = {:.4f} N. With γ = 0 it rests at 0 mm.",
                           1000 * all.rest_error, all.rest_lambda));
  lesson.print();
}

void print_stiff(Lesson& lesson, const SoftRuns& all) {
  lesson.print("2. Stiffer and stiffer, at the same Δt and damping ratio:");
  std::string names = "   f (Hz)      ";
  std::string gamma = "   γ (1/kg)    ";
  std::string beta = "   β           ";
  std::string sag = "   m g / k (mm)";
  for (const StiffRun& run : all.stiff) {
    names += fmt::format(" {:>8g}", run.frequency);
    gamma += fmt::format(" {:>8.3g}", run.gamma);
    beta += fmt::format(" {:>8.4f}", run.beta);
    sag += fmt::format(" {:>8.3g}", 1000 * run.sag);
  }
  for (const std::string& line : {names, gamma, beta, sag}) lesson.print(line);
  lesson.print();
}

void print_harsh(Lesson& lesson, const SoftRuns& all) {
  lesson.print(fmt::format("3. {:g} Hz with steps of {:g} s: c (mm) after", harsh_hertz, all.settings.dt));
  std::string names = "   step           ";
  std::string row = "   as a row       ";
  std::string force = "   as a force     ";
  for (const int step : {0, 1, 2, 3, 5, 20}) {
    names += fmt::format(" {:>11}", step);
    row += fmt::format(" {:>11.4f}", cleaned(1000 * all.harsh_row[step]));
    force += fmt::format(" {:>11.3g}", 1000 * all.harsh_force[step]);
  }
  for (const std::string& line : {names, row, force}) lesson.print(line);
  lesson.print();
}

}  // namespace

void print_scene(Lesson& lesson, const SoftSettings& settings) {
  lesson.print(
      fmt::format("Scene: {:g} kg on a spring of {:g} Hz, damping ratio {:g}, pressed together by {:g} mm",
                  settings.mass, settings.frequency, settings.damping, 1000 * settings.pressed));
  lesson.print(
      fmt::format("       g = {:g} m/s², Δt = {:.4g} s; it moves up and down only: one row, one sweep a step",
                  gravity, settings.dt));
}

void print_runs(Lesson& lesson, const SoftRuns& all) {
  lesson.print();
  print_spring(lesson, all);
  print_stiff(lesson, all);
  print_harsh(lesson, all);
}

CsvTable steps_table(const SoftRuns& all) {
  CsvTable table{.header = {"run", "gamma", "beta", "step", "error_metre", "speed_metre_per_second", "zeta",
                            "lambda_newton", "exact_metre"}};
  for (const auto& [name, run] : {std::pair{"soft", &all.spring}, {"rigid", &all.rigid}}) {
    for (int step = 0; step < run->error.size(); ++step) {
      table.rows.push_back({name, run->gamma, run->beta, step, run->error[step], run->speed[step],
                            run->rows[step].zeta, run->rows[step].lambda,
                            exact_error(all.settings, step * all.settings.dt)});
    }
  }
  return table;
}

SoftSettings settings_of(const Lesson& lesson) {
  return {.frequency = lesson.real("frequency"),
          .damping = lesson.real("damping"),
          .dt = lesson.real("dt"),
          .mass = lesson.real("mass"),
          .pressed = lesson.real("pressed")};
}

// What is checked.

namespace {

double largest_gap(const List<double>& a, const List<double>& b) {
  double gap = 0;
  for (int k = 0; k < a.size(); ++k) gap = std::max(gap, std::abs(a[k] - b[k]));
  return gap;
}

void check_row(Lesson& lesson, const SoftRuns& all) {
  const SoftSettings& settings = all.settings;
  const double h = settings.dt;
  const double resisting = damping_constant(settings) + h * stiffness(settings);
  // Ten roundings each, of the numbers themselves.
  lesson.check_small("γ = 1 / (Δt (d + Δt k)), of itself", all.spring.gamma * h * resisting - 1,
                     16 * epsilon);
  lesson.check_small("β = Δt k / (d + Δt k), of itself",
                     all.spring.beta * resisting / (h * stiffness(settings)) - 1, 16 * epsilon);
  const int steps = all.spring.error.size();
  // Some ten roundings a step of positions of 1 m; a step never enlarges what it is given.
  lesson.check_small("soft row: v and c of implicit Euler by hand, every step (m)",
                     largest_gap(all.spring.error, by_implicit_euler(settings, steps - 1)),
                     32 * epsilon * steps);
  lesson.check_small("soft row: the loop of lesson.cpp, with γ and β by hand, every step (m)",
                     largest_gap(all.spring.error, by_row(settings, steps - 1)), 32 * epsilon * steps);
  List<double> powers;
  for (int k = 0; k < all.rigid.error.size(); ++k)
    powers.push_back(-settings.pressed * std::pow(1 - all.rigid.beta, k));
  // The same roundings, of which beta forgets the older ones.
  lesson.check_small("γ = 0: c = c₀ (1 − β)ᵏ, every step (m)", largest_gap(all.rigid.error, powers),
                     32 * epsilon / all.rigid.beta);
}

void check_rest(Lesson& lesson, const SoftRuns& all) {
  const SoftSettings& settings = all.settings;
  const double k = stiffness(settings);
  const double z = angular_frequency(settings.frequency) * settings.dt;
  // The run ends once 1e-13 of less than 0.6 m are left. Near rest a step moves the weight by less than half
  // a rounding of 1 m: speeds below epsilon / (2 dt) go unseen, and stop it where damper and step still carry
  // v (d + dt k) / k = (epsilon / 2) (1 + 2 zeta / z).
  const double tolerance = 6e-14 + epsilon * (8 + 2 * settings.damping / z);
  lesson.check_equal("at rest: c = −m g / k (m)", all.rest_error, -settings.mass * gravity / k, tolerance);
  // A speed that goes unseen needs dt (d + dt k) of itself, and k times the rounding of c.
  const double unseen = k * tolerance + 16 * epsilon * settings.mass * gravity;
  lesson.check_equal("at rest: λ = m g (N)", all.rest_lambda, settings.mass * gravity, unseen);
  double grown = -1;
  for (int step = 1; step < all.spring.error.size(); ++step) {
    const double before = swing_energy(settings, all.spring.error[step - 1], all.spring.speed[step - 1]);
    const double after = swing_energy(settings, all.spring.error[step], all.spring.speed[step]);
    grown = std::max(grown, (after - before) / k);
  }
  // Energy over k: squares of less than 1 m, rounded.
  lesson.check_small("energy gained in any step, over k (m²)", std::max(grown, 0.0), 64 * epsilon);
  const StiffRun& stiffest = all.stiff.back();
  const double y = angular_frequency(stiffest.frequency) * settings.dt;
  double left = 0;
  for (int step = 1; step < stiffest.error.size(); ++step)
    left = std::max(left, std::abs(stiffest.error[step]));
  // c' = (c (1 + 2 zeta y) + dt v - dt^2 g) / (1 + 2 zeta y + y^2), where |dt v| is at most about |c_0|.
  const double held =
      (settings.pressed * (2 + 2 * settings.damping * y) + gravity * settings.dt * settings.dt) /
      (1 + 2 * settings.damping * y + y * y);
  lesson.check_small("f = 1e6 Hz: c from step 1 on is that of β = 1, γ = 0, which is 0 (m)", left,
                     1.1 * held + 32 * epsilon);
}

void check_columns(Lesson& lesson, const SoftRuns& all) {
  const SoftSettings& settings = all.settings;
  const ColumnRun& rigid = all.rigid_column;
  const ColumnRun& soft = all.soft_column;
  const Matrix<double> added = soft.A - rigid.A;
  const Matrix<double> gamma = soft.gamma * Matrix<double>::Identity(column_weights, column_weights);
  lesson.check_small("A of the soft rows less A of the rigid ones = γ on the diagonal, of A",
                     (added - gamma).cwiseAbs().maxCoeff() / soft.A.maxCoeff(), 8 * epsilon);
  double apart = 0;
  for (const ColumnRun* run : {&rigid, &soft}) {
    for (int sweep = 0; sweep < run->by_si.size(); ++sweep)
      apart = std::max(apart, largest_gap(run->by_si[sweep], run->by_pgs[sweep]) /
                                  (column_weights * settings.mass * gravity));
  }
  // Three rows, a few roundings each, in every sweep.
  lesson.check_small("PGS and SI: the same λ after every sweep, of the weight", apart,
                     32 * epsilon * column_sweeps);
}

void check_harsh(Lesson& lesson, const SoftRuns& all) {
  SoftSettings harsh = all.settings;
  harsh.frequency = harsh_hertz;
  const double sag = harsh.mass * gravity / stiffness(harsh);
  double out = 0;
  for (const double error : all.harsh_row) out = std::max(out, std::abs(error + sag));
  // The energy never grows, so the weight is never further out than at the start.
  lesson.check_small("100 Hz: a row is never further out than at first (m)", out,
                     std::abs(harsh.pressed - sag) + 32 * epsilon);
  // With steps of 0.005 s and more, each multiplies by 8 and more: 8^20 times 25 micrometres.
  const double thrown = std::abs(all.harsh_force.back());
  lesson.check_that("as a force it is out by more than 10⁶ m after 20 steps", thrown > 1e6,
                    fmt::format("{:.1e}", thrown));
}

}  // namespace

void check_runs(Lesson& lesson, const SoftRuns& all) {
  check_row(lesson, all);
  check_rest(lesson, all);
  check_columns(lesson, all);
  check_harsh(lesson, all);
}

}  // namespace cairn::soft
