// Lesson 13. Soft: a spring is a constraint that gives way.
#include "lessons/lesson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "pictures.hpp"
#include "spring.hpp"

namespace {

using namespace cairn;
using namespace cairn::soft;

const double epsilon = std::numeric_limits<double>::epsilon();

LessonInfo info() {
  return {
      .number = 13,
      .name = "soft",
      .title = "A row that gives way",
      .idea =
          "A spring need not be a force. Let a row give way by γ for every unit of its own impulse: with β "
          "and "
          "γ from stiffness and damping it is a spring, for any stiffness and any step.",
      .paper = "paper 4.3, with eq (7), (15), (22)",
      .equations = {"4.3   j·v + γ λ Δt = ζ = −β C / Δt               (11) of a row that gives way",
                    "      γ = 1 / (Δt (c + Δt k)),  β = Δt k / (c + Δt k)",
                    "(15)  (A + γ) λ = b                               PGS: γ on the diagonal of A",
                    "(22)  Δλ = (ζ − j·v − γ λ Δt) / ((A_ii + γ) Δt)   SI: one more term, in one class"},
      .needs = {"lesson 03", "lesson 06"},
      .reads = {"src/constraints/softness.hpp", "src/solvers/sequential_impulse.cpp"},
      .question =
          "The spring gets stiffer and stiffer, and its γ goes to 0. Where does β go, and how far "
          "(in mm) does the weight sag then? (two numbers)",
      .hints = {"Which of the two terms in c + Δt k grows faster with the frequency?",
                "k grows like its square, c in proportion: Δt k / (c + Δt k) is nearly Δt k / Δt k.",
                "A row with γ = 0 is one of lesson 03. Which β takes all of its error back in one step?"},
      .parameters = {{"frequency", 2, 1, 100, "Hz", "of the spring, as it would swing undamped"},
                     {"damping", 0.5, 0.1, 2, "", "ratio; 1 is the fastest return without overshoot"},
                     {"dt", 0.02, 0.005, 0.05, "s", "time step"},
                     {"mass", 1, 0.01, 100, "kg", "of each weight"},
                     {"pressed", 0.2, 0, 0.3, "m", "how far the spring is pressed together at the start"}},
      .cover = 21,
      .next = "lesson14_pulley   (one row on as many bodies as it likes)"};
}

/// Without what rounding leaves of a zero.
double cleaned(double value) { return std::abs(value) < 1e-9 ? 0 : value; }

void print_spring(Lesson& lesson, const SoftRuns& all) {
  const SoftSettings& settings = all.settings;
  const double k = stiffness(settings);
  const double c = damping_constant(settings);
  const WeightRun& spring = all.spring;
  lesson.print(fmt::format("1. The row.  k = m (2π f)² = {:.2f} N/m,  c = 2 m ζ 2π f = {:.3f} N s/m", k, c));
  lesson.print(fmt::format(
      "   γ = 1 / ({:g} × ({:.3f} + {:.3f})) = {:.4g} 1/kg,   β = {:.3f} / {:.3f} = {:.4f}", settings.dt, c,
      settings.dt * k, spring.gamma, settings.dt * k, c + settings.dt * k, spring.beta));
  for (std::size_t step = 1; step <= 3; ++step) {
    const StepRow& row = spring.rows[step];
    lesson.print(fmt::format(
        "   step {}  ζ = {:7.4f}   λ = ({:.4f} − ({:.4f})) / (({:g} + {:.4g}) × {:g}) = {:.4f} N", step,
        row.zeta, row.zeta, row.free, 1 / settings.mass, spring.gamma, settings.dt, row.lambda));
  }
  lesson.print("   t (s)    C (mm): exact     soft row   γ = 0, same β      λ (N): soft row        γ = 0");
  for (const double time : {0.1, 0.2, 0.5, 1.0}) {
    const auto step = static_cast<std::size_t>(std::lround(time / settings.dt));
    lesson.print(fmt::format("   {:<6g} {:>16.2f} {:>12.2f} {:>15.2f} {:>20.3f} {:>13.3f}", time,
                             1000 * exact_error(settings, time), 1000 * spring.error[step],
                             cleaned(1000 * all.rigid.error[step]), spring.rows[step].lambda,
                             all.rigid.rows[step].lambda));
  }
  lesson.print(fmt::format("   At rest: C = {:.4f} mm, λ = {:.4f} N. With γ = 0 it rests at 0 mm.",
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
    gamma += fmt::format(" {:>8.2g}", run.gamma);
    beta += fmt::format(" {:>8.4f}", run.beta);
    sag += fmt::format(" {:>8.2g}", 1000 * run.sag);
  }
  for (const std::string& line : {names, gamma, beta, sag}) lesson.print(line);
  lesson.print();
}

void print_columns(Lesson& lesson, const SoftRuns& all) {
  lesson.print(
      fmt::format("3. {} weights, one upon the other: what the sweeps of one cold step leave of the error:",
                  column_weights));
  std::string names = "   sweep           ";
  for (int sweep = 1; sweep <= 6; ++sweep) names += fmt::format(" {:>9}", sweep);
  lesson.print(names + "   rate, formula");
  for (const auto& [name, run] :
       {std::pair{"rigid, A", &all.rigid_column}, {"soft, A + γ", &all.soft_column}}) {
    std::string line = fmt::format("   {:<16}", name);
    for (std::size_t sweep = 1; sweep <= 6; ++sweep) line += fmt::format(" {:>9.2e}", run->error[sweep]);
    lesson.print(line + fmt::format(" {:>13.4f}", run->rate));
  }
  lesson.print();
}

void print_harsh(Lesson& lesson, const SoftRuns& all) {
  lesson.print(fmt::format("4. {:g} Hz with steps of {:g} s: C (mm) after", harsh_hertz, harsh_dt));
  std::string names = "   step           ";
  std::string row = "   as a row       ";
  std::string force = "   as a force     ";
  for (const std::size_t step : std::array<std::size_t, 6>{0, 1, 2, 3, 5, 20}) {
    names += fmt::format(" {:>11}", step);
    row += fmt::format(" {:>11.4f}", cleaned(1000 * all.harsh_row[step]));
    force += fmt::format(" {:>11.3g}", 1000 * all.harsh_force[step]);
  }
  for (const std::string& line : {names, row, force}) lesson.print(line);
  lesson.print();
}

double largest_gap(const std::vector<double>& a, const std::vector<double>& b) {
  double gap = 0;
  for (std::size_t k = 0; k < a.size(); ++k) gap = std::max(gap, std::abs(a[k] - b[k]));
  return gap;
}

void check_row(Lesson& lesson, const SoftRuns& all) {
  const SoftSettings& settings = all.settings;
  const double h = settings.dt;
  const double resisting = damping_constant(settings) + h * stiffness(settings);
  // Ten roundings each, of the numbers themselves.
  lesson.check_small("γ = 1 / (Δt (c + Δt k)), of itself", all.spring.gamma * h * resisting - 1,
                     16 * epsilon);
  lesson.check_small("β = Δt k / (c + Δt k), of itself",
                     all.spring.beta * resisting / (h * stiffness(settings)) - 1, 16 * epsilon);
  const auto steps = static_cast<double>(all.spring.error.size());
  // Some ten roundings a step of positions of 1 m; a step never enlarges what it is given.
  lesson.check_small("soft row: v and C of implicit Euler by hand, every step (m)",
                     largest_gap(all.spring.error, by_row(settings, static_cast<int>(steps) - 1)),
                     32 * epsilon * steps);
  std::vector<double> powers;
  for (std::size_t k = 0; k < all.rigid.error.size(); ++k)
    powers.push_back(-settings.pressed * std::pow(1 - all.rigid.beta, static_cast<double>(k)));
  // The same roundings, of which beta forgets the older ones.
  lesson.check_small("γ = 0: C = C₀ (1 − β)ᵏ, every step (m)", largest_gap(all.rigid.error, powers),
                     32 * epsilon / all.rigid.beta);
}

void check_rest(Lesson& lesson, const SoftRuns& all) {
  const SoftSettings& settings = all.settings;
  const double k = stiffness(settings);
  const double z = angular_frequency(settings.frequency) * settings.dt;
  // The run ends once 1e-13 of less than 0.6 m are left. Near rest a step moves the weight by less than half
  // a rounding of 1 m: speeds below epsilon / (2 dt) go unseen, and stop it where damper and step still carry
  // v (c + dt k) / k = (epsilon / 2) (1 + 2 zeta / z).
  const double tolerance = 6e-14 + epsilon * (8 + 2 * settings.damping / z);
  lesson.check_equal("at rest: C = −m g / k (m)", all.rest_error, -settings.mass * gravity / k, tolerance);
  // A speed that goes unseen needs dt (c + dt k) of itself, and k times the rounding of C.
  const double unseen = k * tolerance + 16 * epsilon * settings.mass * gravity;
  lesson.check_equal("at rest: λ = m g (N)", all.rest_lambda, settings.mass * gravity, unseen);
  double grown = -1;
  for (std::size_t step = 1; step < all.spring.error.size(); ++step) {
    const double before = swing_energy(settings, all.spring.error[step - 1], all.spring.speed[step - 1]);
    const double after = swing_energy(settings, all.spring.error[step], all.spring.speed[step]);
    grown = std::max(grown, (after - before) / k);
  }
  // Energy over k: squares of less than 1 m, rounded.
  lesson.check_small("energy gained in any step, over k (m²)", std::max(grown, 0.0), 64 * epsilon);
  const StiffRun& stiffest = all.stiff.back();
  const double y = angular_frequency(stiffest.frequency) * settings.dt;
  double left = 0;
  for (std::size_t step = 1; step < stiffest.error.size(); ++step)
    left = std::max(left, std::abs(stiffest.error[step]));
  // C' = (C (1 + 2 zeta y) + dt v - dt^2 g) / (1 + 2 zeta y + y^2), where |dt v| is at most about |C_0|.
  const double held =
      (settings.pressed * (2 + 2 * settings.damping * y) + gravity * settings.dt * settings.dt) /
      (1 + 2 * settings.damping * y + y * y);
  lesson.check_small("f = 1e6 Hz: C from step 1 on is that of β = 1, γ = 0, which is 0 (m)", left,
                     1.1 * held + 32 * epsilon);
}

void check_columns(Lesson& lesson, const SoftRuns& all) {
  const ColumnRun& rigid = all.rigid_column;
  const ColumnRun& soft = all.soft_column;
  const Matrix<double> added = soft.A - rigid.A;
  const Matrix<double> gamma = soft.gamma * Matrix<double>::Identity(column_weights, column_weights);
  lesson.check_small("A of the soft rows less A of the rigid ones = γ on the diagonal, of A",
                     (added - gamma).cwiseAbs().maxCoeff() / soft.A.maxCoeff(), 8 * epsilon);
  double apart = 0;
  for (const ColumnRun* run : {&rigid, &soft}) {
    for (std::size_t sweep = 0; sweep < run->by_si.size(); ++sweep)
      apart = std::max(apart, largest_gap(run->by_si[sweep], run->by_pgs[sweep]) /
                                  *std::max_element(run->exact.begin(), run->exact.end()));
  }
  // Three rows, a few roundings each, in every sweep.
  lesson.check_small("PGS and SI: the same λ after every sweep, of the largest", apart,
                     32 * epsilon * column_sweeps);
  for (const auto& [name, run] : {std::pair{"rigid", &rigid}, {"soft", &soft}}) {
    // From sweep 2 on one error is left, and each sweep shrinks it. It is known to some roundings of lambda.
    lesson.check_equal(fmt::format("{}: a sweep leaves A₁₂²/(A₁₁A₂₂) + A₂₃²/(A₂₂A₃₃)", name),
                       run->error[3] / run->error[2], run->rate, 32 * epsilon / run->error[2]);
  }
}

void check_harsh(Lesson& lesson, const SoftRuns& all) {
  SoftSettings harsh = all.settings;
  harsh.frequency = harsh_hertz;
  const double sag = harsh.mass * gravity / stiffness(harsh);
  double out = 0;
  for (const double error : all.harsh_row) out = std::max(out, std::abs(error + sag));
  // The energy never grows, so the weight is never further out than at the start.
  lesson.check_small("100 Hz, Δt = 0.05 s: a row is never further out than at first (m)", out,
                     std::abs(harsh.pressed - sag) + 32 * epsilon);
  // A step multiplies by 800 and more: 800^20 times 25 micrometres.
  const double thrown = std::abs(all.harsh_force.back());
  lesson.check_that("as a force it is out by more than 10⁶ m after 20 steps", thrown > 1e6,
                    fmt::format("{:.1e}", thrown));
}

CsvTable steps_table(const SoftRuns& all) {
  CsvTable table{.header = {"run", "gamma", "beta", "step", "error_metre", "speed_metre_per_second", "zeta",
                            "lambda_newton", "exact_metre"}};
  for (const auto& [name, run] : {std::pair{"soft", &all.spring}, {"rigid", &all.rigid}}) {
    for (std::size_t step = 0; step < run->error.size(); ++step) {
      table.rows.push_back({name, run->gamma, run->beta, static_cast<long long>(step), run->error[step],
                            run->speed[step], run->rows[step].zeta, run->rows[step].lambda,
                            exact_error(all.settings, static_cast<double>(step) * all.settings.dt)});
    }
  }
  return table;
}

void run(Lesson& lesson) {
  const SoftRuns all = run_soft({.frequency = lesson.real("frequency"),
                                 .damping = lesson.real("damping"),
                                 .dt = lesson.real("dt"),
                                 .mass = lesson.real("mass"),
                                 .pressed = lesson.real("pressed")});
  const SoftSettings& settings = all.settings;
  lesson.print(
      fmt::format("Scene: {:g} kg on a spring of {:g} Hz, damping ratio {:g}, pressed together by {:g} mm",
                  settings.mass, settings.frequency, settings.damping, 1000 * settings.pressed));
  lesson.print(
      fmt::format("       g = {:g} m/s², Δt = {:.4g} s; it moves up and down only: one row, one sweep a step",
                  gravity, settings.dt));
  lesson.predict();
  lesson.print();
  print_spring(lesson, all);
  print_stiff(lesson, all);
  print_columns(lesson, all);
  print_harsh(lesson, all);
  lesson.answer(
      {1, 0}, 0.05,
      "γ = 0, β = 1: a rigid row that takes all of its error back in one step. A rod is the stiffest "
      "spring that a step can follow, and it costs nothing more.");
  check_row(lesson, all);
  check_rest(lesson, all);
  check_columns(lesson, all);
  check_harsh(lesson, all);
  lesson.film(soft_shots(all));
  lesson.data(steps_table(all));
  lesson.fingerprint(all.spring.steps.back());
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(info(), run, argc, argv); }
