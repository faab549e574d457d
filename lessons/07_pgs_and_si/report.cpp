// Prints one sweep row by row and the differences in three precisions, and checks them.
#include "lesson.hpp"

namespace cairn::twice {

namespace {

void check_precision(Lesson& lesson, const PrecisionRun& precision) {
  // The worst of all sweeps, each measured by its own bound: at most 1.
  double worst = 0;
  for (int k = 1; k < precision.difference.size(); ++k) {
    worst = std::max(worst, precision.difference[k] / precision.scale / rounding_bound(precision, k));
  }
  lesson.check_small(fmt::format("{}: PGS = SI after every sweep, in units of 64 ε (1 + k)", precision.name),
                     worst, 1);
}

}  // namespace

void tell_scene(Lesson& lesson, const TwiceSettings& settings) {
  lesson.print(fmt::format(
      "Scene: {} bodies with random masses and velocities, {} random rows between them, every second "
      "one-sided; Δt = {:g} s, {} sweeps, seed {}",
      settings.bodies, settings.rows, settings.dt, settings.sweeps, settings.seed));
}

void tell_first_sweep(Lesson& lesson, const TwiceRun& run) {
  lesson.print();
  lesson.print("Sweep 1, before clamping (N):");
  lesson.print(" row      η_i       j·v         (27) SI       (28) PGS           (29)   (27)−(28)   clamped");
  for (const RowStep& step : run.steps) {
    lesson.print(fmt::format("{:>4} {:>8.3f} {:>9.4f} {:>15.8f} {:>14.8f} {:>14.8f} {:>11.1e} {:>9.3f}",
                             step.row + 1, step.eta, step.row_velocity, step.by_27, step.by_28, step.by_29,
                             step.by_27 - step.by_28, step.si));
  }
  lesson.print();
}

void tell_precisions(Lesson& lesson, const TwiceRun& run) {
  lesson.print(fmt::format("largest |λ_PGS − λ_SI| after sweep {}, {} of {} rows at their bound:",
                           run.settings.sweeps, run.at_bound, run.problem.row_count()));
  for (const PrecisionRun& precision : run.precisions) {
    const double gap = precision.difference.back();
    lesson.print(fmt::format("  {:<12} {:>9.1e} N of {:.1f} N: {:.1e}, {:.1f} digits; ε is {:.1e}",
                             precision.name, gap, precision.scale, gap / precision.scale, precision.digits(),
                             precision.epsilon));
  }
  lesson.print(fmt::format("after {} sweeps, off the answer by (% of the largest λ): PGS {:.4f}, SI {:.4f}",
                           asked_sweeps, run.pgs_off, run.si_off));
  lesson.print("the same rows, but PGS from the last to the first: largest |λ_PGS − λ_SI|");
  int sweeps = 1;
  for (const double difference : run.backwards) {
    lesson.print(fmt::format("  after {:>4} sweep{} {:>9.2g} N", sweeps, sweeps > 1 ? "s" : " ", difference));
    sweeps *= 10;
  }
  lesson.print("Erratum: in (28) of the paper read i for l, and m for n; both sums use the newest η.");
  lesson.print();
}

void check_claims(Lesson& lesson, const TwiceRun& run) {
  double by_row = 0;
  double scale = 0;
  for (const RowStep& step : run.steps) {
    scale = std::max({scale, std::abs(step.by_27), std::abs(step.by_28)});
    by_row = std::max({by_row, std::abs(step.by_27 - step.by_28), std::abs(step.by_27 - step.by_29)});
  }
  // One sweep: see rounding_bound().
  lesson.check_small("(27) = (29) = (28) for every row of sweep 1 (N)", by_row, 128 * 2.3e-16 * scale);
  double to_si = 0, to_pgs = 0;
  for (const RowStep& step : run.steps) {
    to_si = std::max(to_si, std::abs(step.si - run.si[1][step.row]));
    to_pgs = std::max(to_pgs, std::abs(step.pgs - run.pgs[1][step.row]));
  }
  lesson.check_small("(27) clamped = the library's SI after one sweep (N)", to_si, 128 * 2.3e-16 * scale);
  lesson.check_small("(28) clamped = the library's PGS after one sweep (N)", to_pgs, 128 * 2.3e-16 * scale);
  check_eta(lesson, run);
  for (const PrecisionRun& precision : run.precisions) check_precision(lesson, precision);
  check_precision(lesson, run.warm);
  // Every rounding error is a share of ε, so a finer ε gives as many digits more; which way each falls is
  // chance, and a factor of ten is allowed for it.
  lesson.check_equal("double agrees to as many more digits as its ε is finer",
                     run.precisions[1].digits() - run.precisions[0].digits(),
                     std::log10(run.precisions[0].epsilon / run.precisions[1].epsilon), 1);
  lesson.check_small("PGS and SI are as far from the answer (% of the largest λ)", run.pgs_off - run.si_off,
                     1e-9);
  // Every update rounds two bodies' velocities, which are of the size of M^-1 J^T lambda dt: at most 10 a
  // row.
  const double updates = static_cast<double>(run.settings.sweeps) * run.problem.row_count();
  const double velocity_scale = 10 * run.precisions[1].scale * run.settings.dt + 2;
  lesson.check_small("(26) after every row update of SI (m/s)", run.identity_error,
                     2.3e-16 * updates * velocity_scale);
  lesson.check_that("some one-sided rows end at their bound", run.at_bound > 0,
                    fmt::format("{} of {}", run.at_bound, run.problem.row_count() / 2));
}

CsvTable table_of(const TwiceRun& run) {
  CsvTable table{.header = {"precision", "sweep", "largest_difference_newton", "largest_lambda_newton"}};
  for (const PrecisionRun& precision : run.precisions) {
    for (int k = 0; k < precision.difference.size(); ++k) {
      table.rows.push_back({precision.name, k, precision.difference[k], precision.scale});
    }
  }
  return table;
}

// The λ of SI after every row update, and the effective masses that its sweeps need.

namespace {

/// Counts the λ that are not as (24) and (25) have them.
class EtaObserver final : public SolveObserver<double> {
 public:
  bool watches_rows() const override { return true; }
  void before_solve(const VelocityProblem<double>& problem) override {
    last_ = before_sweep_ = problem.impulse;
  }
  void after_row(const RowUpdate<double>& update, const VelocityProblem<double>& problem) override {
    for (int i = 0; i < last_.size(); ++i) changed_ += i != update.row && problem.impulse[i] != last_[i];
    last_ = problem.impulse;
    during_.push_back(last_);
  }
  void after_sweep(int, const VelocityProblem<double>& problem) override {
    for (int l = 0; l < during_.size(); ++l) {
      for (int i = 0; i < last_.size(); ++i)
        mixed_ += during_[l][i] != (i <= l ? problem.impulse : before_sweep_)[i];
    }
    before_sweep_ = problem.impulse;
    during_.clear();
  }
  int changed() const { return changed_; }
  int mixed() const { return mixed_; }

 private:
  PerRow<double> before_sweep_;
  PerRow<double> last_;
  List<PerRow<double>> during_;  // after each row of this sweep
  int changed_ = 0;              // λ of other rows than the updated one, against (25)
  int mixed_ = 0;  // λ that are not of this sweep above the row, or of the last one below it: (24)
};

enum class Masses { once, in_each_update };

struct CountedSweeps {
  PerRow<double> impulse = {};
  int masses = 0;  // effective masses computed
};

CountedSweeps sweep_counting(VelocityProblem<double> problem, int sweeps, Masses when) {
  CountedSweeps counted;
  const auto mass_of = [&problem, &counted](int i) {
    ++counted.masses;
    return effective_mass(problem, problem.rows[i]);
  };
  PerRow<double> masses(problem.row_count(), 0.0);
  if (when == Masses::once) {
    for (int i = 0; i < masses.size(); ++i) masses[i] = mass_of(i);
  }
  for (int update = 0; update < sweeps * problem.row_count(); ++update) {
    const int i = update % problem.row_count();
    const ConstraintRow<double>& row = problem.rows[i];
    const double mass = when == Masses::once ? masses[i] : mass_of(i);
    const double before = problem.impulse[i];
    const double sum = before + mass * (row.bias - row_velocity(problem, row));
    problem.impulse[i] = row.bounds.clamp(sum, problem.impulse);
    apply_impulse(problem, row, problem.impulse[i] - before);
  }
  counted.impulse = problem.impulse;
  return counted;
}

}  // namespace

void check_eta(Lesson& lesson, const TwiceRun& run) {
  EtaObserver eta;
  VelocityProblem<double> problem = run.problem;
  SequentialImpulse<double>({.iterations = run.settings.sweeps}).solve(problem, &eta);
  lesson.check_small("(24) new λ up to the row, old λ below it: entries that differ", eta.mixed(), 0);
  lesson.check_small("(25) λ of other rows that a row update changes", eta.changed(), 0);
}

void check_masses(Lesson& lesson, const TwiceRun& run) {
  const int sweeps = run.settings.sweeps;
  const CountedSweeps once = sweep_counting(run.problem, sweeps, Masses::once);
  const CountedSweeps each = sweep_counting(run.problem, sweeps, Masses::in_each_update);
  double change = 0;
  for (int i = 0; i < once.impulse.size(); ++i)
    change = std::max(change, std::abs(once.impulse[i] - each.impulse[i]) / run.settings.dt);
  lesson.check_small(fmt::format("effective masses computed once ({}), not each time ({}): change of λ (N)",
                                 once.masses, each.masses),
                     change, 0);
}

}  // namespace cairn::twice
