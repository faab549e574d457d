// Lesson 14. Pulley: a row may touch as many bodies as it likes.
#include "lessons/lesson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pictures.hpp"
#include "rope.hpp"

namespace {

using namespace cairn;
using namespace cairn::pulley;

LessonInfo info() {
  return {
      .number = 14,
      .name = "pulley",
      .title = "A rope on three bodies",
      .idea =
          "A row of J has a block for every body that it touches. A rope over wheels touches three, in one "
          "row, in a joint that this lesson writes itself; every solver takes it as it is.",
      .paper = "paper 4.2, 4.3",
      .equations =
          {"(5)   dC/dt = j v,  j = (0, r₁, 0,  0, r₂, 0,  0, r₃, 0)     one row, three bodies",
           "(22)  λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)                          with three terms in each sum",
           "      T = Σ rᵢ g / Σ (rᵢ² / mᵢ)                              what λ has to be"},
      .needs = {"lesson 06"},
      .reads = {"src/constraints/constraint.hpp", "src/constraints/row.hpp"},
      .question =
          "Masses of 1, 2 and 3 kg hang on one rope, the 2 kg on two parts of it. How hard is it "
          "pulled, in newtons: more or less than the 30 N that the heaviest weighs?",
      .hints = {"What the rope gives on one side it takes on the others: y₁ + 2 y₂ + y₃ stays as it is.",
                "λ follows from (22) with j v = −4 g Δt: each part of the rope counts.",
                "j M⁻¹ jᵀ = 1/1 + 4/2 + 1/3."},
      .parameters = {{"dt", 0.02, 0.0001, 0.1, "s", "time step"},
                     {"m1", 1, 0.01, 100, "kg", "mass on the left, on one part of the rope"},
                     {"m2", 2, 0.01, 100, "kg", "mass in the middle, on two parts"},
                     {"m3", 3, 0.01, 100, "kg", "mass on the right, on one part"},
                     {"lift", 3, 0, 20, "m/s", "how fast the third mass is thrown up"}},
      .cover = 2,
      .next = "lesson15_cone_or_pyramid   (two rows of friction that share one limit)"};
}

void print_row(Lesson& lesson, const PulleyRuns& all) {
  const ConstraintRow<double>& row = all.first.rows[0];
  const double jv = row_velocity(all.first, row);
  const double inverse = inverse_effective_mass(all.first, row);
  lesson.print("The row of the rope, before the first sweep:");
  lesson.print("        body 1    body 2    body 3");
  lesson.print(fmt::format("  j   (0, {:g}, 0)  (0, {:g}, 0)  (0, {:g}, 0)", parts[0], parts[1], parts[2]));
  lesson.print(fmt::format("  v_y  {:8.3f}  {:8.3f}  {:8.3f}  m/s", all.first.velocity[1].y(),
                           all.first.velocity[2].y(), all.first.velocity[3].y()));
  lesson.print(fmt::format("  (22)  λ = ({:g} − ({:.3f})) / ({:.4f} × {:g}) = {:.4f} N, in one sweep",
                           row.bias + 0.0, jv, inverse, all.settings.dt,
                           (row.bias - jv) / inverse / all.settings.dt));
  lesson.print();
}

void print_solvers(Lesson& lesson, const PulleyRuns& all) {
  lesson.print(
      "solver                    λ, step 1 (N)    a₁      a₂      a₃ (m/s²)   beside the problem (bytes)");
  for (const PulleyRun& run : all.runs) {
    const PulleyStep& step = run.steps[1];
    lesson.print(fmt::format("  {:<22} {:>14.10f} {:>7.3f} {:>7.3f} {:>7.3f} {:>17}", run.solver,
                             step.tension, step.speed[0] / all.settings.dt, step.speed[1] / all.settings.dt,
                             step.speed[2] / all.settings.dt, run.memory));
  }
  lesson.print(
      fmt::format("A row takes {} bytes with two bodies. The third costs {} more, and only this row pays.",
                  sizeof(ConstraintRow<double>), sizeof(RowTerm<double>)));
  lesson.print();
}

/// In how many steps the rope is slack: those in which the free masses would leave it longer than it need be.
int slack_by_formula(const PulleySettings& settings) {
  double speed = parts[2] * settings.lift;  // of the length that the masses leave over [m/s], after the throw
  double pull = 0;
  for (std::size_t i = 0; i < 3; ++i) pull += 10 * parts[i];
  for (std::size_t i = 0; i < 2; ++i) {
    const double acceleration = parts[i] * tension_by_formula(settings) / settings.masses[i] - 10;
    speed += parts[i] * acceleration * settings.dt * settings.lift_step;
  }
  int slack = 0;
  for (double room = 0; settings.lift_step + slack < settings.steps; ++slack) {
    speed -= pull * settings.dt;
    room += speed * settings.dt;
    if (!(room > 0)) break;
  }
  return slack;
}

void check_motion(Lesson& lesson, const PulleyRuns& all) {
  const PulleySettings& settings = all.settings;
  const std::vector<PulleyStep>& steps = all.runs[0].steps;
  const double tension = tension_by_formula(settings);
  // An update of one row rounds some ten times, at the size of T.
  lesson.check_equal("λ of the first step = Σ r g / Σ r²/m (N)", steps[1].tension, tension,
                     16 * 2.3e-16 * tension);
  double length = 0;
  double falling = 0;
  int slack = 0;
  for (std::size_t k = 1; k < steps.size(); ++k) {
    length = std::max(length, -steps[k].room);
    if (steps[k].tension > 0) continue;
    ++slack;
    if (static_cast<int>(k) == settings.lift_step + 1) continue;  // the throw is in between
    for (std::size_t i = 0; i < 3; ++i) {
      const double acceleration = (steps[k].speed[i] - steps[k - 1].speed[i]) / settings.dt;
      falling = std::max(falling, std::abs(acceleration + 10));
    }
  }
  // Positions of some metres, rounded once a step.
  lesson.check_small("the rope never gets longer (m)", length, settings.steps * 16 * 2.3e-16 * 20);
  lesson.check_equal("steps for which the throw leaves the rope slack", slack, slack_by_formula(settings), 0);
  lesson.check_small("without tension all three fall at g (m/s²)", falling, 64 * 2.3e-16 * 20 / settings.dt);
}

void check_agreement(Lesson& lesson, const PulleyRuns& all) {
  const std::vector<PulleyStep>& si = all.runs[0].steps;
  double largest = 0;
  double gap = 0;
  for (const PulleyStep& step : si) largest = std::max(largest, step.tension);
  for (const PulleyRun& run : all.runs) {
    for (std::size_t k = 0; k < si.size(); ++k)
      gap = std::max(gap, std::abs(run.steps[k].tension - si[k].tension));
  }
  // One sweep a step is 64 ε (1 + 1), and positions carry the roundings of all steps on: each enters λ as a
  // length over Δt².
  const double carried = all.settings.steps * 2.3e-16 * 20 / (all.settings.dt * all.settings.dt);
  lesson.check_small("seven solvers, one λ, in every step (N)", gap, 128 * 2.3e-16 * largest + carried);
}

CsvTable steps_table(const PulleyRuns& all) {
  CsvTable table{.header = {"solver", "step", "tension_newton", "room_metre", "v1_metre_per_second",
                            "v2_metre_per_second", "v3_metre_per_second"}};
  for (const PulleyRun& run : all.runs) {
    for (std::size_t k = 0; k < run.steps.size(); ++k) {
      const PulleyStep& step = run.steps[k];
      table.rows.push_back({run.solver, static_cast<long long>(k), step.tension, step.room, step.speed[0],
                            step.speed[1], step.speed[2]});
    }
  }
  return table;
}

void run(Lesson& lesson) {
  const PulleySettings settings{.dt = lesson.real("dt"),
                                .masses = {lesson.real("m1"), lesson.real("m2"), lesson.real("m3")},
                                .lift = lesson.real("lift")};
  const PulleyRuns all = run_pulleys(settings);
  lesson.print(
      fmt::format("Scene: {:g}, {:g} and {:g} kg on 1, 2 and 1 parts of a rope; Δt = {:g} s, {} steps, one "
                  "sweep each; after step {} the third is thrown up at {:g} m/s",
                  settings.masses[0], settings.masses[1], settings.masses[2], settings.dt, settings.steps,
                  settings.lift_step, settings.lift));
  lesson.predict();
  lesson.print();
  print_row(lesson, all);
  print_solvers(lesson, all);
  const double tension = tension_by_formula(settings);
  lesson.answer(
      {tension}, 0.05 * tension,
      "λ is what stops y₁ + 2 y₂ + y₃ from shrinking: the heaviest goes down, so it weighs more than "
      "the rope pulls.");
  check_motion(lesson, all);
  check_agreement(lesson, all);
  lesson.film(pulley_shots(all));
  lesson.data(steps_table(all));
  lesson.fingerprint(all.runs[0].steps.back().snapshot);
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(info(), run, argc, argv); }
