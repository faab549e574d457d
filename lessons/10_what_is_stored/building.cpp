// What A costs before the first sweep, and what a sweep has to read.
#include "lesson.hpp"

namespace cairn::stored {

namespace {

/// Multiply-adds for all of A, pair by pair: three for each body that both rows move.
double building_work(const VelocityProblem<double>& problem) {
  double work = 0;
  for (const ConstraintRow<double>& first : problem.rows) {
    for (const ConstraintRow<double>& second : problem.rows) {
      for (const BodyId body : {first.a, first.b}) {
        const bool moves = problem.inverse_mass[body] != Vec3<double>::Zero();
        if (moves && (body == second.a || body == second.b)) work += 3;
      }
    }
  }
  return work;
}

/// Two rows of a contact between two boxes share both: four pairs of rows for which a body more is counted.
double building_by_formula(const Count& count) {
  const double contacts_between_boxes = 1.0 * count.base * (count.base - 1);
  return 3 * (count.pairs + 4 * contacts_between_boxes);
}

}  // namespace

void tell_building(Lesson& lesson, const StoredRun& run) {
  const Count& largest = run.pyramids.back();
  const double work = building_work(run.problems.back());
  lesson.print(
      fmt::format("before the first sweep, base {}: A takes {:.0f} multiply-adds, as many as {:.1f} sweeps "
                  "of SI; the effective masses of SI take {:.0f}",
                  largest.base, work, work / (12 * largest.rows), 6 * largest.rows));
  const double rows = largest.rows * sizeof(ConstraintRow<double>);
  const double sparse = largest.pairs * (sizeof(double) + sizeof(int));  // an entry of A, and its column
  lesson.print(
      fmt::format("a sweep reads, one number after the other: SI {} of rows; sparse PGS {} of A; PGS {} of A",
                  bytes_text(rows), bytes_text(sparse), bytes_text(largest.dense * sizeof(double))));
  lesson.print();
}

void check_building(Lesson& lesson, const StoredRun& run) {
  double gap = 0;
  for (int i = 0; i < run.pyramids.size(); ++i)
    gap = std::max(gap, std::abs(building_work(run.problems[i]) - building_by_formula(run.pyramids[i])));
  lesson.check_equal("building A: 3 multiply-adds for each body that two rows share", gap, 0, 0);
}

}  // namespace cairn::stored
