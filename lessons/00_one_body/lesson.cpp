// Lesson 00. One body in free flight: eq. (1), (2), and the left half of (12).
#include "lessons/lesson.hpp"

#include <fmt/core.h>

#include <cmath>

#include "flight.hpp"
#include "geometry/mass.hpp"
#include "pictures.hpp"
#include "render/canvas.hpp"

namespace {

using namespace cairn;
using namespace cairn::one_body;
using render::fixed;
using render::significant;

LessonInfo info() {
  LessonInfo info;
  info.number = 0;
  info.name = "one_body";
  info.title = "One body";
  info.idea = "A body is three numbers and their rates; a step changes the rates first, then the numbers.";
  info.paper = "paper 2.1, eq (1), (2); 2.2, left half of (12)";
  info.equations = {"(1)   v = (v_x, v_y, ω)", "(2)   M⁻¹ = diag(1/m, 1/m, 1/I)",
                    "(12)  v₂ = v₁ + M⁻¹ f Δt,  here f = m g;  then x₂ = x₁ + v₂ Δt"};
  info.reads = {"src/dynamics/body.hpp", "src/dynamics/integrate.cpp", "src/geometry/mass.cpp"};
  info.question =
      "When it comes down, is the simulated box above or below the exact parabola, and by how many metres?";
  info.hints = {
      "Which velocity does a step use: the one at its beginning or the one at its end?",
      "While the box slows down on its way up, the velocity at the end of a step is the smaller one.",
      "In each step the velocity used is g Δt / 2 smaller than the mean one; that adds up for t seconds."};
  info.parameters = {
      {.flag = "dt", .standard = 0.02, .min = 1e-4, .max = 0.2, .unit = "s", .what = "time step"},
      {.flag = "gravity", .standard = 10, .min = 0.1, .max = 100, .unit = "m/s²", .what = "gravity"},
      {.flag = "spin",
       .standard = -1,
       .min = -20,
       .max = 20,
       .unit = "rad/s",
       .what = "how fast the box turns"},
      {.flag = "steps",
       .standard = 60,
       .min = 6,
       .max = 2000,
       .what = "steps",
       .kind = Parameter::Kind::whole}};
  info.cover = -3;
  info.next = "lesson01_constraint_and_jacobian   (what takes some of this freedom away)";
  return info;
}

Throw throw_of(const Lesson& lesson) {
  Throw thrown;
  thrown.gravity = lesson.real("gravity");
  thrown.dt = lesson.real("dt");
  thrown.velocity.z() = lesson.real("spin");
  thrown.steps = lesson.whole("steps");
  return thrown;
}

/// The same throw for the same time, in ever smaller steps.
Convergence halve_the_step(Throw thrown) {
  Convergence result;
  for (int halvings = 0; halvings <= 4; ++halvings) {
    const Flight flight = fly(thrown);
    result.dt.push_back(thrown.dt);
    result.semi_implicit.push_back(final_error(flight, flight.semi_implicit));
    result.explicit_euler.push_back(final_error(flight, flight.explicit_euler));
    thrown.dt /= 2;
    thrown.steps *= 2;
  }
  return result;
}

void tell_scene(Lesson& lesson, const Flight& flight) {
  const Throw& thrown = flight.thrown;
  lesson.print(
      fmt::format("Scene: a unit box of 1 kg at ({}, {}) m, gravity {} m/s², Δt {} s, {} steps = {} s",
                  fixed(thrown.start.x(), 0), fixed(thrown.start.y(), 0), significant(thrown.gravity),
                  significant(thrown.dt), thrown.steps, significant(flight.time.back())));
  lesson.print(fmt::format("  v   = ({}, {}, {}) m/s, m/s, rad/s                  eq (1)",
                           fixed(thrown.velocity.x(), 1), fixed(thrown.velocity.y(), 1),
                           fixed(thrown.velocity.z(), 1)));
  lesson.print(fmt::format("  M⁻¹ = diag({}, {}, {}) 1/kg, 1/kg, 1/(kg m²)        eq (2)",
                           significant(flight.inverse_mass.x()), significant(flight.inverse_mass.y()),
                           significant(flight.inverse_mass.z())));
}

void tell_steps(Lesson& lesson, const Flight& flight) {
  lesson.print("step      t (s)   v_y (m/s)     y (m)  explicit y   exact y");
  const int steps = flight.thrown.steps;
  for (int step = 0; step <= steps; ++step) {
    const auto i = static_cast<std::size_t>(step);
    const std::string line =
        fmt::format("{:4}  {:>9} {:>11} {:>9} {:>11} {:>9}", step, fixed(flight.time[i], 3),
                    fixed(flight.cairn[i].bodies[1].velocity.y(), 3), fixed(flight.semi_implicit[i].y(), 3),
                    fixed(flight.explicit_euler[i].y(), 3), fixed(flight.exact[i].y(), 3));
    const bool shown = step <= 3 || step == steps / 2 || step == steps;
    if (shown) {
      lesson.print(line);
    } else {
      lesson.detail(line);
    }
  }
}

void tell_convergence(Lesson& lesson, const Convergence& c) {
  lesson.print("after the same time:  Δt (s)   semi-implicit (m)   explicit (m)");
  for (std::size_t i = 0; i < c.dt.size(); ++i) {
    lesson.print(fmt::format("                   {:>9} {:>19} {:>14}", significant(c.dt[i], 4),
                             fixed(c.semi_implicit[i], 6, render::Sign::always),
                             fixed(c.explicit_euler[i], 6, render::Sign::always)));
  }
}

void check_claims(Lesson& lesson, const Flight& flight, const Convergence& convergence) {
  const Throw& thrown = flight.thrown;
  // A standard flight of 60 steps may lose 1.2e-13 m to rounding: well below the 1e-12 m that we ask for.
  const double rounding = std::max(1e-12, rounding_of_height(flight));
  const double error = final_error(flight, flight.semi_implicit);
  const double formula = thrown.gravity * thrown.dt * flight.time.back() / 2;
  lesson.check_equal("semi-implicit Euler ends g Δt t/2 below the parabola (m)", error, -formula, rounding);
  lesson.check_equal("explicit Euler ends as far above it (m)", final_error(flight, flight.explicit_euler),
                     formula, rounding);

  const double inertia = mass_properties(box(1, 1)).inertia;
  lesson.check_equal("a box has I = m (w² + h²)/12 (kg m²)", inertia, (1.0 + 1.0) / 12, 1e-15);
  const Vec3<double> expected(1, 1, 12.0 / (1 + 1));
  lesson.check_small("M⁻¹ = diag(1/m, 1/m, 1/I), eq (2)", (flight.inverse_mass - expected).norm(), 1e-14);

  // The error halves with the step; log2 of the ratio is the order. Rounding shifts it by rounding / error /
  // ln 2 for each of the two errors.
  const double ratio = convergence.semi_implicit[0] / convergence.semi_implicit[1];
  lesson.check_equal("order of the method: log2 of what half the step gains", std::log2(ratio), 1,
                     6 * rounding / formula);
  const Snapshot& last = flight.cairn.back();
  const double turned = thrown.velocity.z() * flight.time.back();
  lesson.check_equal("nothing turns the box: φ = ω t (rad)", last.bodies[1].pose.angle, turned, rounding);
}

CsvTable table_of(const Flight& flight) {
  CsvTable table = {
      .header = {"step", "t", "x", "y", "angle", "v_x", "v_y", "omega", "y_explicit", "y_exact"}};
  for (std::size_t i = 0; i < flight.time.size(); ++i) {
    const SnapshotBody& box = flight.cairn[i].bodies[1];
    std::vector<CsvCell> row;
    row.emplace_back(static_cast<long long>(i));
    for (const double number :
         {flight.time[i], box.pose.position.x(), box.pose.position.y(), box.pose.angle, box.velocity.x(),
          box.velocity.y(), box.velocity.z(), flight.explicit_euler[i].y(), flight.exact[i].y()}) {
      row.emplace_back(number);
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

void run(Lesson& lesson) {
  const Flight flight = fly(throw_of(lesson));
  const Convergence convergence = halve_the_step(flight.thrown);

  tell_scene(lesson, flight);
  lesson.predict();
  tell_steps(lesson, flight);
  tell_convergence(lesson, convergence);
  lesson.answer({final_error(flight, flight.semi_implicit)}, 0.005,
                "Below, by g Δt t / 2: every step already uses the velocity of its end.");
  check_claims(lesson, flight, convergence);
  lesson.data(table_of(flight));
  lesson.fingerprint(flight.cairn.back());
  if (lesson.draws())
    lesson.print("Pictures are drawn offscreen by " + render::Canvas(64, 64).backend() + ".");
  lesson.film(pictures(flight, convergence, info().question));
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(info(), run, argc, argv); }
