// Lesson 06. Sequential impulses: Algorithm 1, one row at a time.
#include "lessons/lesson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pictures.hpp"
#include "stack.hpp"

namespace {

using namespace cairn;
using namespace cairn::stack;

LessonInfo info() {
  return {
      .number = 6,
      .name = "sequential_impulses",
      .title = "Sequential impulses",
      .idea =
          "Do not build the matrix. Visit each contact, cancel its own error, repeat: the pushes find each "
          "other.",
      .paper = "paper 3.2, Algorithm 1, eq (19)-(23)",
      .equations = {"(22)  λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)     what this row asks for [N]",
                    "(23)  p = jᵀ λ Δt                        the impulse it gives [N s]",
                    "(21)  v ← v + M⁻¹ p                      to its two bodies, at once"},
      .needs = {"lesson 00"},
      .reads = {"src/solvers/sequential_impulse.cpp", "src/constraints/row.hpp"},
      .question =
          "After one sweep from the ground up: how fast does each box still fall (m/s, lowest first)?",
      .hints =
          {"A push acts on both boxes of a contact: it stops the upper one and speeds up the lower one.",
           "Two boxes of 1 kg that close in at 0.2 m/s share the push: each changes by 0.1 m/s.",
           "Row 1 stops box 1. Row 2 shares 0.2 m/s between boxes 1 and 2. Row 3 shares what then is left."},
      .parameters = {{"bodies", 3, 1, 10, "", "boxes", Parameter::Kind::whole},
                     {"dt", 0.02, 0.0001, 1, "s", "time step"},
                     {"gravity", 10, 0.01, 1000, "m/s^2", "gravity, downwards"},
                     {"sweeps", 10, 1, 100, "", "sweeps", Parameter::Kind::whole},
                     {"seed", 1, 0, 1e9, "", "of --order shuffle", Parameter::Kind::whole}},
      .choices = {{"order", {"up", "down", "shuffle"}, "in which rows are visited"}},
      .cover = 6,
      .next = "lesson07_clamp_the_sum   (why a contact may take back what it gave)"};
}

void print_updates(Lesson& lesson, const StackRun& run) {
  const double dt = run.settings.dt;
  std::string header = "sweep row  pair       j·v        λ corr                λ (N)";
  for (int i = 1; i <= std::min(run.settings.boxes, 5); ++i)
    header += fmt::format("{:>11}", fmt::format("v{}", i));
  lesson.print(header + "   (m/s)");
  const std::size_t shown = static_cast<std::size_t>(2 * run.settings.boxes);
  for (std::size_t i = 0; i < run.updates.size(); ++i) {
    const RowUpdate<double>& update = run.updates[i].update;
    const int interface = run.interface_of_row[static_cast<std::size_t>(update.row)];
    const std::string pair = interface == 0 ? "g-1" : fmt::format("{}-{}", interface, interface + 1);
    std::string line = fmt::format(
        "{:>5} {:>3}  {:>5} {:>9.4f} {:>+13.4f} {:>9.4f} -> {:<9.4f}", update.sweep, interface + 1, pair,
        update.row_velocity, update.corrective / dt, update.impulse_before / dt, update.impulse_after / dt);
    for (int k = 1; k <= std::min(run.settings.boxes, 5); ++k) {
      line += fmt::format("{:>11.4f}", run.updates[i].velocity[static_cast<std::size_t>(k)].y());
    }
    if (i < shown && i < 10) {
      lesson.print(line);
    } else {
      lesson.detail(line);
    }
  }
  if (run.updates.size() > shown || shown > 10) {
    lesson.print(fmt::format("  ...  (-v shows all {} rows)", run.updates.size()));
  }
}

void print_sweeps(Lesson& lesson, const StackRun& run) {
  std::string header = "after sweep";
  std::vector<int> sweeps;
  for (const int sweep : {1, 2, 3, 5, 10, 20, 50, 100}) {
    if (sweep > run.settings.sweeps) break;
    sweeps.push_back(sweep);
    header += fmt::format("{:>9}", sweep);
  }
  lesson.print();
  lesson.print(header + "    exact");
  for (std::size_t i = 0; i < run.exact.size(); ++i) {
    std::string line = fmt::format("λ{:<10}", i + 1);
    for (const int sweep : sweeps) line += fmt::format("{:>9.2f}", lambda_after(run, sweep)[i]);
    lesson.print(line + fmt::format("{:>9.2f}   N", run.exact[i]));
  }
  lesson.print();
}

/// The largest difference between the velocities of the solver and v + M^-1 J^T lambda dt (26), over all
/// updates; and the largest change of a body that the row does not touch.
struct UpdateErrors {
  double identity = 0;  // [m/s]
  double bystander = 0;
};

UpdateErrors update_errors(const StackRun& run) {
  UpdateErrors errors;
  std::vector<double> impulse(run.exact.size(), 0.0);
  std::vector<Vec3<double>> before = run.problem.velocity;
  for (const RowRecord& record : run.updates) {
    impulse[static_cast<std::size_t>(record.update.row)] = record.update.impulse_after;
    VelocityProblem<double> twin = run.problem;
    for (std::size_t row = 0; row < impulse.size(); ++row) {
      apply_impulse(twin, twin.rows[row], impulse[row]);
    }
    const std::vector<Vec3<double>>& expected = twin.velocity;
    const ConstraintRow<double>& active = run.problem.rows[static_cast<std::size_t>(record.update.row)];
    for (std::size_t body = 0; body < expected.size(); ++body) {
      errors.identity =
          std::max(errors.identity, (record.velocity[body] - expected[body]).cwiseAbs().maxCoeff());
      const BodyId id{static_cast<int>(body)};
      if (id == active.a || id == active.b) continue;
      errors.bystander =
          std::max(errors.bystander, (record.velocity[body] - before[body]).cwiseAbs().maxCoeff());
    }
    before = record.velocity;
  }
  return errors;
}

double largest_gap_to_gauss_seidel(const StackRun& run) {
  const std::vector<std::vector<double>> expected = gauss_seidel(run.problem, run.settings.sweeps);
  double largest = 0;
  for (std::size_t sweep = 0; sweep < expected.size(); ++sweep) {
    for (std::size_t row = 0; row < expected[sweep].size(); ++row) {
      largest = std::max(largest,
                         std::abs(run.sweeps[sweep].impulse[row] / run.settings.dt - expected[sweep][row]));
    }
  }
  return largest;
}

void check_run(Lesson& lesson, const StackRun& run) {
  const StackSettings& settings = run.settings;
  const double updates = static_cast<double>(run.updates.size());
  const double rounding = 2.3e-16 * updates;  // each update rounds a few times, by half of this
  const double fall = settings.gravity * settings.dt;
  const UpdateErrors errors = update_errors(run);
  lesson.check_small("v = v0 + M⁻¹ Jᵀ λ Δt after every update, eq (26) (m/s)", errors.identity,
                     4 * rounding * fall * settings.boxes);
  lesson.check_small("only the two boxes of the row change (m/s)", errors.bystander, 0);
  lesson.check_small("the same λ as Gauss-Seidel on A λ = b (N)", largest_gap_to_gauss_seidel(run),
                     4 * rounding * run.exact[0]);
  const double factor = error_factor(settings.boxes);
  lesson.check_equal(
      fmt::format("a sweep leaves cos²(π/{}) = {:.4f} of the error", 2 * settings.boxes, factor),
      measured_error_factor(settings), factor, 1e-6);
  double momentum = 0;  // of the boxes: only the ground's push and gravity can change it
  for (std::size_t i = 1; i < run.updates.back().velocity.size(); ++i)
    momentum += run.updates.back().velocity[i].y();
  const double given = lambda_after(run, settings.sweeps)[0] * settings.dt - settings.boxes * fall;
  lesson.check_equal("momentum changes by gravity and the ground's push alone (N s)", momentum, given,
                     4 * rounding * fall * settings.boxes);
}

CsvTable rows_table(const StackRun& run) {
  CsvTable table{.header = {"sweep", "row", "body_a", "body_b", "jv", "zeta", "a_ii", "lambda_corr",
                            "lambda_old", "lambda_new"}};
  for (int i = 1; i <= run.settings.boxes; ++i) table.header.push_back(fmt::format("v{}", i));
  const double dt = run.settings.dt;
  for (const RowRecord& record : run.updates) {
    const RowUpdate<double>& update = record.update;
    const long long interface = run.interface_of_row[static_cast<std::size_t>(update.row)];
    std::vector<CsvCell> cells = {static_cast<long long>(update.sweep),
                                  interface + 1,
                                  interface,
                                  interface + 1,
                                  update.row_velocity,
                                  0.0,
                                  update.inverse_mass,
                                  update.corrective / dt,
                                  update.impulse_before / dt,
                                  update.impulse_after / dt};
    for (std::size_t k = 1; k < record.velocity.size(); ++k) cells.push_back(record.velocity[k].y());
    table.rows.push_back(cells);
  }
  return table;
}

void run(Lesson& lesson) {
  const StackSettings settings{.boxes = lesson.whole("bodies"),
                               .dt = lesson.real("dt"),
                               .gravity = lesson.real("gravity"),
                               .sweeps = lesson.whole("sweeps"),
                               .order = lesson.choice("order"),
                               .seed = static_cast<std::uint64_t>(lesson.whole("seed"))};
  const StackRun stack = run_stack(settings);
  lesson.print(fmt::format(
      "Scene: {} boxes of 1 kg on the ground, g = {:g} m/s², Δt = {:g} s, {} sweeps, no warm start",
      settings.boxes, settings.gravity, settings.dt, settings.sweeps));
  lesson.predict();
  lesson.print();
  print_updates(lesson, stack);
  print_sweeps(lesson, stack);
  std::vector<double> after_one;
  const auto last = static_cast<std::size_t>(settings.boxes - 1);
  for (int i = 1; i <= settings.boxes; ++i) {
    after_one.push_back(stack.updates[last].velocity[static_cast<std::size_t>(i)].y());
  }
  lesson.answer(
      after_one, 1e-3 * settings.gravity * settings.dt,
      "each push stops its own pair and disturbs the neighbours; the last pair closes in no longer");
  check_run(lesson, stack);
  lesson.film(stack_shots(stack));
  lesson.data(rows_table(stack));
  std::vector<double> numbers = lambda_after(stack, settings.sweeps);
  for (const Vec3<double>& v : stack.updates.back().velocity) numbers.push_back(v.y());
  lesson.fingerprint(numbers);
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(info(), run, argc, argv); }
