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

void print_columns(Lesson& lesson, const SoftRuns& all) {
  lesson.print(
      fmt::format("3. {} weights on top of each other, springs without load: the share of the error that the "
                  "sweeps of one step leave:",
                  column_weights));
  std::string names = "   sweep           ";
  for (int sweep = 1; sweep <= 6; ++sweep) names += fmt::format(" {:>9}", sweep);
  lesson.print(names + "   rate, formula");
  for (const auto& [name, run] :
       {std::pair{"rigid, A", &all.rigid_column}, {"soft, A + γ", &all.soft_column}}) {
    std::string line = fmt::format("   {:<16}", name);
    for (int sweep = 1; sweep <= 6; ++sweep) line += fmt::format(" {:>9.2e}", run->error[sweep]);
    lesson.print(line + fmt::format(" {:>13.4f}", run->rate));
  }
  lesson.print();
}

void print_harsh(Lesson& lesson, const SoftRuns& all) {
  lesson.print(fmt::format("4. {:g} Hz with steps of {:g} s: c (mm) after", harsh_hertz, all.settings.dt));
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
  print_columns(lesson, all);
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

}  // namespace cairn::soft
