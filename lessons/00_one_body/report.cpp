// Lesson 00. The flight in lines and rows, and what has to be true of it.
#include "lesson.hpp"

namespace cairn::one_body {

void tell_scene(Lesson& lesson, const Flight& flight) {
  const Throw& thrown = flight.thrown;
  lesson.print(
      fmt::format("thrown: a unit box of 1 kg at ({}, {}) m, gravity {} m/s², Δt {} s, {} steps = {} s",
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
  lesson.print("step      t (s)   v_y (m/s)     y (m)   y, position first   exact y");
  const int steps = flight.thrown.steps;
  for (int step = 0; step <= steps; ++step) {
    const std::string line = fmt::format(
        "{:4}  {:>9} {:>11} {:>9} {:>19} {:>9}", step, fixed(flight.time[step], 3),
        fixed(flight.cairn[step].bodies[{1}].velocity.y(), 3), fixed(flight.semi_implicit[step].y(), 3),
        fixed(flight.explicit_euler[step].y(), 3), fixed(flight.exact[step].y(), 3));
    const bool shown = step <= 3 || step == steps / 2 || step == steps;
    lesson.print_if(shown, line);
  }
}

void check_claims(Lesson& lesson, const Flight& flight) {
  const Throw& thrown = flight.thrown;
  // A standard flight of 60 steps may lose 1.2e-13 m to rounding: well below the 1e-12 m that we ask for.
  const double rounding = std::max(1e-12, rounding_of_height(flight));
  const double error = final_error(flight, flight.semi_implicit);
  const double formula = thrown.gravity * thrown.dt * flight.time.back() / 2;
  lesson.check_equal("velocity first ends g Δt t/2 below the parabola (m)", error, -formula, rounding);
  lesson.check_equal("position first ends as far above it (m)", final_error(flight, flight.explicit_euler),
                     formula, rounding);
  lesson.check_small("Cairn's step is the two lines of lesson.cpp (m)", flight.gap, rounding);

  const double inertia = mass_properties(box(1, 1)).inertia;
  lesson.check_equal("a box has I = m (w² + h²)/12 (kg m²)", inertia, (1.0 + 1.0) / 12, 1e-15);
  const Vec3<double> expected(1, 1, 12.0 / (1 + 1));
  lesson.check_small("M⁻¹ = diag(1/m, 1/m, 1/I), eq (2)", (flight.inverse_mass - expected).norm(), 1e-14);

  const Snapshot& last = flight.cairn.back();
  const double turned = thrown.velocity.z() * flight.time.back();
  lesson.check_equal("nothing turns the box: θ = ω t (rad)", last.bodies[{1}].pose.angle, turned, rounding);
}

CsvTable table_of(const Flight& flight) {
  CsvTable table = {
      .header = {"step", "t", "x", "y", "angle", "v_x", "v_y", "omega", "y_explicit", "y_exact"}};
  for (int i = 0; i < flight.time.size(); ++i) {
    const SnapshotBody& box = flight.cairn[i].bodies[{1}];
    table.rows.push_back({i, flight.time[i], box.pose.position.x(), box.pose.position.y(), box.pose.angle,
                          box.velocity.x(), box.velocity.y(), box.velocity.z(), flight.explicit_euler[i].y(),
                          flight.exact[i].y()});
  }
  return table;
}

}  // namespace cairn::one_body
