// Lesson 14. What is printed, and what is checked.
#include "lesson.hpp"

namespace cairn::pulley {

namespace {

void print_row(Lesson& lesson, const PulleyRuns& all) {
  const ConstraintRow<double>& row = all.first.rows[0];
  const double jv = row_velocity(all.first, row);
  const double inverse = inverse_effective_mass(all.first, row);
  lesson.print("The row of the rope, before the first sweep:");
  lesson.print("        body 1    body 2    body 3");
  lesson.print(fmt::format("  j   (0, {:g}, 0)  (0, {:g}, 0)  (0, {:g}, 0)", parts[0], parts[1], parts[2]));
  const auto speed = [&all](int body) { return fixed(all.first.velocity[{body}].y(), 3); };
  lesson.print(fmt::format("  v_y  {:>8}  {:>8}  {:>8}  m/s", speed(1), speed(2), speed(3)));
  lesson.print(fmt::format("  (22)  λ = ({:g} − ({})) / ({:.4f} × {:g}) = {:.4f} N, in one sweep",
                           row.bias + 0.0, fixed(jv, 3), inverse, all.settings.dt,
                           (row.bias - jv) / inverse / all.settings.dt));
  ConstraintRow<double> two = row;
  two.extra_count = 0;
  lesson.print(fmt::format(
      "  without the third mass: λ = {:.4f} N",
      (two.bias - row_velocity(all.first, two)) / inverse_effective_mass(all.first, two) / all.settings.dt));
  const Matrix<double> J = system_matrices(all.first).J;
  std::string line;
  for (Eigen::Index k = 0; k < J.cols(); ++k) line += fmt::format(" {:g}", J(0, k));
  lesson.print("In the big J it is a line of numbers, the ground's first:" + line);
  lesson.print();
}

void print_solvers(Lesson& lesson, const PulleyRuns& all) {
  lesson.print("solver                    λ, step 1 (N)    a₁      a₂      a₃ (m/s²)");
  for (const PulleyRun& run : all.runs) {
    const PulleyStep& step = run.steps[1];
    lesson.print(fmt::format("  {:<22} {:>14.10f} {:>7.3f} {:>7.3f} {:>7.3f}", run.solver, step.tension,
                             step.speed[0] / all.settings.dt, step.speed[1] / all.settings.dt,
                             step.speed[2] / all.settings.dt));
  }
  lesson.print(
      fmt::format("A row takes {} bytes with two bodies. The third costs {} more, and only this row pays.",
                  sizeof(ConstraintRow<double>), sizeof(RowTerm<double>)));
  lesson.print();
}

/// In how many steps the rope is slack: those in which the free masses would leave it longer by `least_room`
/// [m] or more than it need be.
int slack_by_formula(const PulleySettings& settings, double least_room) {
  double speed = parts[2] * settings.lift;  // of the length that the masses leave over [m/s], after the throw
  double pull = 0;
  for (int i = 0; i < 3; ++i) pull += gravity * parts[i];
  for (int i = 0; i < 2; ++i) {
    const double acceleration = parts[i] * tension_by_hand(settings) / settings.masses[i] - gravity;
    speed += parts[i] * acceleration * settings.dt * settings.lift_step;
  }
  int slack = 0;
  for (double room = 0; settings.lift > 0 && settings.lift_step + slack < settings.steps; ++slack) {
    speed -= pull * settings.dt;
    room += speed * settings.dt;
    if (!(room > least_room)) break;
  }
  return slack;
}

void check_motion(Lesson& lesson, const PulleyRuns& all) {
  const PulleySettings& settings = all.settings;
  const List<PulleyStep>& steps = all.runs[0].steps;
  const double tension = tension_by_hand(settings);
  // An update of one row rounds some ten times, at the size of T.
  lesson.check_equal("λ of the first step = Σ r g / Σ r²/m (N)", steps[1].tension, tension,
                     16 * 2.3e-16 * tension);
  double length = 0;
  double falling = 0;
  int slack = 0;
  for (int k = 1; k < steps.size(); ++k) {
    length = std::max(length, -steps[k].room);
    if (steps[k].tension > 0) continue;
    ++slack;
    if (k == settings.lift_step + 1) continue;  // the throw is in between
    for (int i = 0; i < 3; ++i) {
      const double acceleration = (steps[k].speed[i] - steps[k - 1].speed[i]) / settings.dt;
      falling = std::max(falling, std::abs(acceleration + 10));
    }
  }
  // Positions of some metres, rounded once a step.
  lesson.check_small("the rope never gets longer (m)", length, settings.steps * 16 * 2.3e-16 * 20);
  // Where the last room is 0 but for rounding, either count is right.
  const int most = slack_by_formula(settings, -1e-9);
  lesson.check_equal("steps for which the throw leaves the rope slack", slack, most,
                     most - slack_by_formula(settings, 1e-9));
  lesson.check_small("without tension all three fall at g (m/s²)", falling, 64 * 2.3e-16 * 20 / settings.dt);
}

void check_agreement(Lesson& lesson, const PulleyRuns& all) {
  const List<PulleyStep>& si = all.runs[0].steps;
  double largest = 0;
  double gap = 0;
  for (const PulleyStep& step : si) largest = std::max(largest, step.tension);
  for (const PulleyRun& run : all.runs) {
    for (int k = 0; k < si.size(); ++k) gap = std::max(gap, std::abs(run.steps[k].tension - si[k].tension));
  }
  // One sweep a step is 64 ε (1 + 1), and positions carry the roundings of all steps on: each enters λ as a
  // length over Δt².
  const double carried = all.settings.steps * 2.3e-16 * 20 / (all.settings.dt * all.settings.dt);
  lesson.check_small("seven solvers, one λ, in every step (N)", gap, 128 * 2.3e-16 * largest + carried);
}

}  // namespace

void print_scene(Lesson& lesson, const PulleySettings& settings) {
  lesson.print(fmt::format(
      "Scene: {:g}, {:g} and {:g} kg on 1, 2 and 1 parts of a rope; Δt = {:g} s, {} steps, one sweep each",
      settings.masses[0], settings.masses[1], settings.masses[2], settings.dt, settings.steps));
  lesson.print(fmt::format("       after step {} the third is thrown up at {:g} m/s", settings.lift_step,
                           settings.lift));
}

std::string what_goes_down(const PulleySettings& settings) {
  const double tension = tension_by_hand(settings);
  std::string masses;
  for (int i = 0; i < 3; ++i) {
    const double weight = gravity * settings.masses[i];
    if (!(weight - parts[i] * tension > 1e-9 * weight)) continue;
    masses += fmt::format("{}mass {} ({} N of {:g} N)", masses.empty() ? "" : ", ", i + 1,
                          fixed(parts[i] * tension, 1), weight);
  }
  return masses.empty() ? "none does, all pulls equal the weights" : masses;
}

void print_runs(Lesson& lesson, const PulleyRuns& all) {
  lesson.print();
  print_row(lesson, all);
  print_solvers(lesson, all);
}

void check_runs(Lesson& lesson, const PulleyRuns& all) {
  check_motion(lesson, all);
  check_agreement(lesson, all);
}

CsvTable steps_table(const PulleyRuns& all) {
  CsvTable table{.header = {"solver", "step", "tension_newton", "room_metre", "v1_metre_per_second",
                            "v2_metre_per_second", "v3_metre_per_second"}};
  for (const PulleyRun& run : all.runs) {
    for (int k = 0; k < run.steps.size(); ++k) {
      const PulleyStep& step = run.steps[k];
      table.rows.push_back(
          {run.solver, k, step.tension, step.room, step.speed[0], step.speed[1], step.speed[2]});
    }
  }
  return table;
}

PulleySettings settings_of(const Lesson& lesson) {
  const double dt = lesson.real("dt");
  return {.dt = dt,
          .masses = {lesson.real("m1"), lesson.real("m2"), lesson.real("m3")},
          .steps = static_cast<int>(std::lround(1 / dt)),
          .lift_step = static_cast<int>(std::lround(0.4 / dt)),
          .lift = lesson.real("lift")};
}

}  // namespace cairn::pulley
