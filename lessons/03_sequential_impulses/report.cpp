// Prints the row updates and the sweeps, and checks them against two other accounts of the same stack.
#include "lesson.hpp"

namespace cairn::stack {

namespace {

/// The largest difference between the velocities of the solver and v + M^-1 J^T lambda dt (26), over all
/// updates; and the largest change of a body that the row does not touch.
struct UpdateErrors {
  double identity = 0;  // [m/s]
  double bystander = 0;
};

UpdateErrors update_errors(const StackRun& run) {
  UpdateErrors errors;
  PerRow<double> impulse(run.exact.size(), 0.0);
  PerBody<Vec3<double>> before = run.problem.velocity;
  for (const RowRecord& record : run.updates) {
    impulse[record.update.row] = record.update.impulse_after;
    VelocityProblem<double> twin = run.problem;
    for (int row = 0; row < impulse.size(); ++row) {
      apply_impulse(twin, twin.rows[row], impulse[row]);
    }
    const PerBody<Vec3<double>>& expected = twin.velocity;
    const ConstraintRow<double>& active = run.problem.rows[record.update.row];
    for (const BodyId body : expected.indices()) {
      errors.identity =
          std::max(errors.identity, (record.velocity[body] - expected[body]).cwiseAbs().maxCoeff());
      if (body == active.a || body == active.b) continue;
      errors.bystander =
          std::max(errors.bystander, (record.velocity[body] - before[body]).cwiseAbs().maxCoeff());
    }
    before = record.velocity;
  }
  return errors;
}

double largest_gap_to_gauss_seidel(const StackRun& run) {
  const List<PerRow<double>> expected = gauss_seidel(run.problem, run.settings.sweeps);
  double largest = 0;
  for (int sweep = 0; sweep < expected.size(); ++sweep) {
    for (int row = 0; row < expected[sweep].size(); ++row) {
      largest = std::max(largest, std::abs(run.sweeps[sweep][row] / run.settings.dt - expected[sweep][row]));
    }
  }
  return largest;
}

}  // namespace

void tell_scene(Lesson& lesson, const StackRun& run) {
  const StackSettings& settings = run.settings;
  const std::string order = settings.order == "up"     ? "from the ground up"
                            : settings.order == "down" ? "from the top down"
                                                       : "in a shuffled order";
  lesson.print(fmt::format("Scene: {} boxes of 1 kg on the ground, g = {:g} m/s², Δt = {:g} s, {} sweeps {}",
                           settings.boxes, settings.gravity, settings.dt, settings.sweeps, order));
}

void tell_updates(Lesson& lesson, const StackRun& run) {
  const double dt = run.settings.dt;
  lesson.print();
  std::string header =
      fmt::format("sweep row   pair {:>11} {:>12} {:>15}      ", "j·v (m/s)", "λ corr (N)", "λ (N)");
  for (int i = 1; i <= std::min(run.settings.boxes, 5); ++i)
    header += fmt::format("{:>11}", fmt::format("v{} (m/s)", i));
  lesson.print(header);
  const int shown = 2 * run.settings.boxes;
  for (int i = 0; i < run.updates.size(); ++i) {
    const RowUpdate<double>& update = run.updates[i].update;
    const int interface = run.interface_of_row[update.row];
    const std::string pair = interface == 0 ? "g-1" : fmt::format("{}-{}", interface, interface + 1);
    std::string line = fmt::format(
        "{:>5} {:>3}  {:>5} {:>11.4f} {:>+12.4f} {:>9.4f} → {:<9.4f}", update.sweep, interface + 1, pair,
        update.row_velocity, update.corrective / dt, update.impulse_before / dt, update.impulse_after / dt);
    for (int k = 1; k <= std::min(run.settings.boxes, 5); ++k) {
      line += fmt::format("{:>11.4f}", run.updates[i].velocity[{k}].y());
    }
    lesson.print_if(i < shown && i < 10, line);
  }
  if (run.updates.size() > shown || shown > 10) {
    lesson.print(fmt::format("  ...  (-v shows all {} rows)", run.updates.size()));
  }
}

void tell_sweeps(Lesson& lesson, const StackRun& run) {
  std::string header = "after sweep";
  List<int> sweeps;
  for (const int sweep : {1, 2, 3, 5, 10, 20, 50, 100}) {
    if (sweep > run.settings.sweeps) break;
    sweeps.push_back(sweep);
    header += fmt::format("{:>9}", sweep);
  }
  lesson.print();
  lesson.print(header + "    exact");
  for (int i = 0; i < run.exact.size(); ++i) {
    std::string line = fmt::format("λ{:<10}", i + 1);
    for (const int sweep : sweeps) line += fmt::format("{:>9.2f}", lambda_after(run, sweep)[i]);
    lesson.print(line + fmt::format("{:>9.2f}   N", run.exact[i]));
  }
  lesson.print();
}

void check_claims(Lesson& lesson, const StackRun& run) {
  const StackSettings& settings = run.settings;
  const double updates = run.updates.size();
  const double rounding = 2.3e-16 * updates;  // each update rounds a few times, by half of this
  const double fall = settings.gravity * settings.dt;
  const UpdateErrors errors = update_errors(run);
  lesson.check_small("v = v₀ + M⁻¹ Jᵀ λ Δt after every update, eq (26) (m/s)", errors.identity,
                     4 * rounding * fall * settings.boxes);
  lesson.check_small("only the two boxes of the row change (m/s)", errors.bystander, 0);
  lesson.check_small("the same λ, computed a second way (N)", largest_gap_to_gauss_seidel(run),
                     4 * rounding * run.exact[0]);
  VelocityProblem<double> twin = run.problem;
  SequentialImpulse({.iterations = settings.sweeps}).solve(twin);
  lesson.check_that("the library's solver: the same λ, to the last bit", twin.impulse == run.sweeps.back(),
                    fmt::format("{:.4f} N", twin.impulse.front() / settings.dt));
  const double factor = error_factor(settings.boxes);
  lesson.check_equal(
      fmt::format("a sweep leaves cos²(π/{}) = {:.4f} of the error", 2 * settings.boxes, factor),
      measured_error_factor(settings), factor, 1e-6);
  double momentum = 0;  // of the boxes: only the ground's push and gravity can change it
  for (int i = 1; i <= settings.boxes; ++i) momentum += run.updates.back().velocity[{i}].y();
  const double given = lambda_after(run, settings.sweeps)[0] * settings.dt - settings.boxes * fall;
  lesson.check_equal("momentum changes by gravity and the ground's push alone (N s)", momentum, given,
                     4 * rounding * fall * settings.boxes);
}

void check_question(Lesson& lesson, const StackRun& run) {
  const StackSettings& settings = run.settings;
  const double fall = settings.gravity * settings.dt;
  // Row 1 stops box 1; each row above makes a box as fast as the mean of its own speed and that below.
  lesson.check_equal(
      fmt::format("one sweep leaves the uppermost box 1 − 2^(1 − {}) of its speed (m/s)", settings.boxes),
      -velocities_after(run, 1).back(), fall * (1 - std::exp2(1 - settings.boxes)),
      4 * epsilon * fall * settings.boxes);
}

CsvTable table_of(const StackRun& run) {
  CsvTable table{.header = {"sweep", "row", "body_a", "body_b", "jv", "zeta", "a_ii", "lambda_corr",
                            "lambda_old", "lambda_new"}};
  for (int i = 1; i <= run.settings.boxes; ++i) table.header.push_back(fmt::format("v{}", i));
  const double dt = run.settings.dt;
  for (const RowRecord& record : run.updates) {
    const RowUpdate<double>& update = record.update;
    const long long interface = run.interface_of_row[update.row];
    List<CsvCell> cells = {update.sweep,
                           interface + 1,
                           interface,
                           interface + 1,
                           update.row_velocity,
                           0.0,
                           update.inverse_mass,
                           update.corrective / dt,
                           update.impulse_before / dt,
                           update.impulse_after / dt};
    for (int k = 1; k <= run.settings.boxes; ++k) cells.push_back(record.velocity[{k}].y());
    table.rows.push_back(cells);
  }
  return table;
}

}  // namespace cairn::stack
