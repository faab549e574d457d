// The λ of SI after every row update, and the effective masses that its sweeps need.
#include "lesson.hpp"

namespace cairn::twice {

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
