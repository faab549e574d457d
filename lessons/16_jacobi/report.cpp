// What lesson 16 prints, and the claims that it makes.
#include "lesson.hpp"

namespace cairn::everybody {

namespace {

std::string numbers(const List<double>& values, const char* form) {
  std::string line;
  for (const double value : values) line += fmt::format(fmt::runtime(form), value);
  return line;
}

void print_feet(Lesson& lesson, const FeetRun& run) {
  lesson.print("Plain Jacobi, λ of each foot from the left (N), and the box's speed:");
  const FeetHistory& plain = history_of(run, Method::plain);
  for (int k = 1; k <= 4; ++k) {
    lesson.print(fmt::format("  sweep {}  (22) {}   together {:7.2f} N    (21) v = {:+.4f} m/s", k,
                             numbers(plain.lambda[k], "{:8.2f}"), together(plain.lambda[k]), plain.speed[k]));
  }
  lesson.print();
  lesson.print("v after sweep (m/s)      1         2         3         5        10    taken at once");
  for (const FeetHistory& history : run.histories) {
    const List<double>& v = history.speed;
    const bool in_turn = history.method == Method::sequential;
    lesson.print(
        fmt::format("  {:<17} {:+9.4f} {:+9.4f} {:+9.4f} {:+9.4f} {:+9.4f}    {}",
                    method_name(history.method, run.settings.omega), v[1], v[2], v[3], v[5], v[10],
                    in_turn ? "in turn" : fmt::format("{:.3f}", taken_at_once(run, history.method))));
  }
  lesson.print();
}

void print_colours(Lesson& lesson, const PileRun& run) {
  lesson.print("Contacts in colours, those of a colour at the same time, as they share no box:");
  for (const Colouring* each : {&run.contacts, &run.larger}) {
    const int contacts = each->contacts.size();
    lesson.print(fmt::format("  {:>3} contacts, up to {} on a box: {} colours of {} contacts", contacts,
                             each->most_on_a_box, each->count.size(), counts_text(*each)));
  }
}

void print_pile(Lesson& lesson, const PileRun& run) {
  lesson.print(fmt::format("Pyramid: {} boxes, {} rows, up to {} on one box, one step from rest, μ = 0.6",
                           run.problem.body_count() - 1, run.problem.row_count(),
                           *std::max_element(run.rows_on_box.begin() + 1, run.rows_on_box.end())));
  lesson.print("method               ω·eigenvalue    R_E after 20     sweeps to 1 %   × turns   = turns");
  const auto line = [&](const std::string& name, const PileHistory& history) {
    const bool in_turn = history.method == Method::sequential;
    const int turns = turns_per_sweep(run, history);
    const int needed = history.sweeps_needed;
    lesson.print(fmt::format("  {:<18} {:>13} {:>15.3g} {:>17} {:>9} {:>9}", name,
                             in_turn ? "" : fmt::format("{:.3f}", history.eigenvalue), history.residual[20],
                             needed < 0 ? "never" : fmt::format("{}", needed), turns,
                             needed < 0 ? "" : fmt::format("{}", needed * turns)));
  };
  for (const PileHistory& history : run.histories) {
    line(method_name(history.method, run.settings.omega), history);
  }
  line("SI, by colours", run.coloured);
  const auto tuned = [&](const char* name, const TunedJacobi& jacobi, int turns) {
    lesson.print(fmt::format("  {:<18} {:>47} {:>9} {:>9}", fmt::format("{}, ω = {:.3f}", name, jacobi.omega),
                             jacobi.sweeps_needed, turns, jacobi.sweeps_needed * turns));
  };
  tuned("Jacobi, best", run.tuned, 1);
  tuned("momentum", run.with_momentum, 2);  // whose test for a restart adds up all rows
  const double bytes_there = 1.0 * sizeof(ConstraintRow<double>) * run.problem.row_count();
  const double bytes_back = 1.0 * sizeof(Vec3<double>) * run.problem.body_count();
  lesson.print(fmt::format(
      "On another processor: {:.0f} bytes of rows there and {:.0f} of velocities back, each step.",
      bytes_there, bytes_back));
  lesson.print("A turn: rows that work at the same time, if each row has a processor of its own.");
  lesson.print();
  print_colours(lesson, run);
  lesson.print();
}

void check_feet(Lesson& lesson, const FeetRun& run) {
  const double weight = box_mass * gravity;
  const double first = together(history_of(run, Method::plain).lambda[1]);
  // Some ten roundings a foot, at the size of the weight.
  lesson.check_equal("first sweep, all feet together: Σ g / A_ii (N)", first, weight * run.answer,
                     16 * run.settings.feet * epsilon * weight);
  double gap = 0;
  for (const Method method : {Method::plain, Method::damped, Method::split}) {
    const List<double>& speed = history_of(run, method).speed;
    for (int k = 0; k < speed.size(); ++k) {
      gap = std::max(gap, std::abs(speed[k] - speed_by_formula(run, method, k)));
    }
  }
  // Of a problem with one body and a few rows, 64 ε a sweep, at the speed that plain Jacobi throws the box
  // up.
  const double fastest = gravity * time_step * std::max(1.0, run.answer - 1);
  lesson.check_small("three forms of Jacobi: v follows the closed forms (m/s)", gap,
                     64 * epsilon * (1 + run.settings.sweeps) * fastest);
}

void check_pile(Lesson& lesson, const PileRun& run) {
  const PileHistory& plain = run.histories[0];
  const PileHistory& damped = run.histories[1];
  const PileHistory& split = run.histories[2];
  const PileHistory& in_turn = run.histories[3];
  // An eigenvalue of a symmetric matrix of m rows is good to some m ε of the largest.
  lesson.check_that("split masses: no eigenvalue above 1",
                    split.eigenvalue <= 1 + run.problem.row_count() * 16 * epsilon,
                    fmt::format("{:.4f}", split.eigenvalue));
  lesson.check_that("plain: eigenvalue above 2, and worse than no impulse at all",
                    plain.eigenvalue > 2 && !(plain.residual.back() <= 1),
                    fmt::format("{:.3g}", plain.residual.back()));
  // Below 2 it converges, but the nearer the slower, and friction moves its bounds: asked for with some room.
  if (damped.eigenvalue <= 1.95) {
    lesson.check_that("damped: below 2, and it settles (sweeps to 1 %)", damped.sweeps_needed > 0,
                      fmt::format("{}", damped.sweeps_needed));
  }
  lesson.check_that(
      "Jacobi with momentum: fewer sweeps than with the best share",
      run.with_momentum.sweeps_needed > 0 && run.with_momentum.sweeps_needed < run.tuned.sweeps_needed,
      fmt::format("{} < {}", run.with_momentum.sweeps_needed, run.tuned.sweeps_needed));
  lesson.check_that(
      "and fewer turns in all than SI by colours, twice as many a sweep",
      2 * run.with_momentum.sweeps_needed < run.coloured.sweeps_needed * run.colours,
      fmt::format("{} < {}", 2 * run.with_momentum.sweeps_needed, run.coloured.sweeps_needed * run.colours));
  lesson.check_that("split settles, in more sweeps than SI",
                    in_turn.sweeps_needed > 0 && split.sweeps_needed > in_turn.sweeps_needed,
                    fmt::format("{} > {}", split.sweeps_needed, in_turn.sweeps_needed));
}

void check_order(Lesson& lesson, const PileRun& run) {
  // 64 ε a sweep of the largest impulse; another order only adds up the same numbers in another order.
  const double rounding = 64 * epsilon * (1 + 20);
  lesson.check_small("rows backwards, split Jacobi: change of λ", run.order_at_once, rounding);
  lesson.check_that("rows backwards, SI: more than rounding", run.order_in_turn > 1000 * rounding,
                    fmt::format("{:.2g}", run.order_in_turn));
}

/// The sweeps of lesson.cpp beside those of the library.
void check_library(Lesson& lesson, const FeetRun& run) {
  double gap = 0;
  double largest = 0;
  for (const FeetHistory& history : run.histories) {
    VelocityProblem<double> problem = run.problem;
    solved(history.method, run.settings.omega, run.settings.sweeps, problem);
    for (int i = 0; i < problem.impulse.size(); ++i) {
      gap = std::max(gap, std::abs(problem.impulse[i] / time_step - history.lambda.back()[i]));
      largest = std::max(largest, history.lambda.back()[i]);
    }
  }
  // Eight roundings for each foot in each sweep.
  lesson.check_small("these sweeps and the library's solvers: the same λ (N)", gap,
                     8 * run.settings.feet * run.settings.sweeps * epsilon * largest);
}

void check_colours(Lesson& lesson, const PileRun& run) {
  const int rows = run.problem.row_count() / run.contacts.contacts.size();  // of a contact
  lesson.check_small("contacts of one colour that share a box", clashes(run.problem, run.contacts), 0);
  lesson.check_equal("turns of a sweep by colours: rows of a contact × colours", run.colours,
                     rows * run.contacts.count.size(), 0);
}

}  // namespace

CsvTable sweeps_table(const FeetRun& feet, const PileRun& pile) {
  CsvTable table{.header = {"scene", "method", "sweep", "speed", "residual"}};
  for (const FeetHistory& history : feet.histories) {
    for (int k = 0; k < history.speed.size(); ++k) {
      table.rows.push_back(
          {"feet", method_name(history.method, feet.settings.omega), k, history.speed[k], 0.0});
    }
  }
  for (const PileHistory& history : pile.histories) {
    for (int k = 0; k <= 300; ++k) {
      table.rows.push_back(
          {"pyramid", method_name(history.method, feet.settings.omega), k, 0.0, history.residual[k]});
    }
  }
  return table;
}

void report(Lesson& lesson, const FeetRun& feet, const PileRun& pile) {
  lesson.print();
  print_feet(lesson, feet);
  print_pile(lesson, pile);
  const List<ThreadedSweeps> threaded = run_threads();
  print_threads(lesson, threaded);
  lesson.answer(
      {together(history_of(feet, Method::plain).lambda[1]),
       together(history_of(feet, Method::plain).lambda[2])},
      0.5,
      "In the first sweep every foot sees the whole fall and stops it alone, so the box is thrown up. "
      "In the second no foot pushes, and it begins again.");
  check_feet(lesson, feet);
  check_library(lesson, feet);
  check_pile(lesson, pile);
  check_colours(lesson, pile);
  check_order(lesson, pile);
  check_threads(lesson, threaded);
}

}  // namespace cairn::everybody
