// Prints the counts and what solvers keep, and checks them by formulas.
#include "lesson.hpp"

#include <cairn/solvers/body_rows.hpp>

namespace cairn::stored {

namespace {

/// The full A of base 10; that of the largest would take as long as all the rest.
void check_entries(Lesson& lesson, const StoredRun& run) {
  const VelocityProblem<double>& problem = run.problems[2];
  const Eigen::MatrixXd A = system_matrices(problem).A;
  double gap = 0;
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    for (Eigen::Index j = 0; j < A.cols(); ++j) {
      const double entry = coupling(problem, problem.rows[i], problem.rows[j], problem.inverse_mass);
      gap = std::max(gap, std::abs(A(i, j) - entry));
    }
  }
  // A sum of six products, in another order.
  lesson.check_small("base 10: J M⁻¹ Jᵀ multiplied out, and pair by pair (1/kg)", gap,
                     8 * epsilon * A.cwiseAbs().maxCoeff());
  // Where terms cancel, rounding may leave something: then the full A has fewer.
  const double entries = count_entries(A);
  lesson.check_that("and it has no entry that was not counted", entries <= run.pyramids[2].non_zeros,
                    fmt::format("{:.0f} of {:.0f}", entries, run.pyramids[2].non_zeros));
}

void check_counts(Lesson& lesson, const StoredRun& run) {
  double rows_off = 0;
  double pairs_off = 0;
  double linear = 0;
  double beyond = 0;
  for (const Count& count : run.pyramids) {
    rows_off = std::max(rows_off, std::abs(count.rows - rows_by_formula(count.base)));
    pairs_off = std::max(pairs_off, std::abs(count.pairs - pairs_by_formula(count.base)));
    linear = std::max(linear, count.pairs / count.rows);
    const double ground_only = 4.0 * count.base * count.base - 4.0 * count.base;
    beyond = std::max(beyond, count.printed - count.pairs - ground_only);
  }
  lesson.check_equal("m: 2 rows for a box on the ground, 4 for one on two others", rows_off, 0, 0);
  lesson.check_equal("rows that share a body: Σ (rows on it)², less what two bodies count", pairs_off, 0, 0);
  // A box has at most 8 rows; a row between two of them meets 8 + 8, itself and its twin counted twice.
  lesson.check_that("sparse A grows like m: entries for each row, at most 14", linear <= 14,
                    fmt::format("{:.2f}", linear));
  lesson.check_that("(30) as printed: beyond these only rows that share the ground", beyond <= 0,
                    fmt::format("{:.0f} − {:.0f}", run.pyramids[2].printed, run.pyramids[2].non_zeros));
  double library = 0;
  for (int i = 0; i < run.problems.size(); ++i) {
    const VelocityProblem<double>& problem = run.problems[i];
    const Count& count = run.pyramids[i];
    library = std::max({library, std::abs(static_cast<double>(non_zeros(problem)) - count.non_zeros),
                        std::abs(static_cast<double>(non_zeros_as_printed(problem)) - count.printed),
                        std::abs(static_cast<double>(coupled_pairs(problem)) - count.pairs)});
  }
  lesson.check_equal("the library's counts, which go from body to body: the same", library, 0, 0);
  check_entries(lesson, run);
  lesson.check_equal("the tray: all pairs of rows share a body", run.tray.pairs, run.tray.dense, 0);
}

/// One row update of SI, number by number. Returns its products but for that with the effective mass.
int update_counting(VelocityProblem<double>& problem, int i) {
  const ConstraintRow<double>& row = problem.rows[i];
  int products = 0;
  const auto times = [&products](double a, double b) {
    ++products;
    return a * b;
  };
  const FixedList<std::pair<BodyId, Vec3<double>>, 2> ends = {
      {{row.a, row.jacobian_a}, {row.b, row.jacobian_b}}};
  double jv = 0;
  for (const auto& [body, j] : ends)
    for (int k = 0; k < 3; ++k) jv += times(j[k], problem.velocity[body][k]);
  const double before = problem.impulse[i];
  problem.impulse[i] = std::max(0.0, before + effective_mass(problem, row) * (row.bias - jv));
  const double p = problem.impulse[i] - before;
  for (const auto& [body, j] : ends)
    for (int k = 0; k < 3; ++k)
      problem.velocity[body][k] += times(times(problem.inverse_mass[body][k], j[k]), p);
  return products;
}

void check_update(Lesson& lesson, const StoredRun& run) {
  VelocityProblem<double> counted = run.problems.back(), library = counted;
  double products = 0;
  for (int i = 0; i < counted.row_count(); ++i) products += update_counting(counted, i);
  SequentialImpulse<double>({.iterations = 1}).solve(library);
  double gap = 0, scale = 0;
  for (const BodyId body : counted.velocity.indices()) {
    gap = std::max(gap, (counted.velocity[body] - library.velocity[body]).cwiseAbs().maxCoeff());
    scale = std::max(scale, library.velocity[body].cwiseAbs().maxCoeff());
  }
  lesson.check_equal("a row update of SI, written out: products", products / counted.row_count(), si_products,
                     0);
  // A row's sum is added in another order.
  lesson.check_small("and a sweep of it leaves the library's velocities (m/s)", gap,
                     64 * epsilon * (scale + 1));
}

void check_solvers(Lesson& lesson, const StoredRun& run) {
  const Count& tallest = run.pyramids.back();
  lesson.check_equal("SI keeps one number per row (bytes)", run.kept[0].bytes, 8 * tallest.rows, 0);
  lesson.check_that("sparse PGS: 12 bytes for each pair, and more; PGS: 8 m², and more",
                    run.kept[2].bytes >= 12 * tallest.pairs && run.kept[3].bytes >= 8 * tallest.dense,
                    bytes_text(run.kept[2].bytes) + " and " + bytes_text(run.kept[3].bytes));
  double gap = 0;
  double scale = 0;
  for (const Kept& kept : run.kept) {
    for (int i = 0; i < kept.impulse.size(); ++i) {
      scale = std::max(scale, std::abs(kept.impulse[i]));
      gap = std::max(gap, std::abs(kept.impulse[i] - run.kept[0].impulse[i]));
    }
  }
  // As in lesson 07: 64 roundings of the largest number for each sweep are more than sums of 14 terms make.
  lesson.check_small(fmt::format("all four: the same impulses after {} sweeps (N s)", run.settings.sweeps),
                     gap, 64 * epsilon * (1 + run.settings.sweeps) * scale);
}

}  // namespace

void tell_scene(Lesson& lesson, const StoredRun& run) {
  lesson.print(
      fmt::format("Scene: pyramids of unit boxes of 1 kg, {:.4g} m apart in a row, without friction; base 3, "
                  "5, 10 and {}",
                  run.settings.spacing, run.settings.base));
}

void tell_counts(Lesson& lesson, const StoredRun& run) {
  lesson.print();
  lesson.print(
      "numbers       bodies    rows m     full m²   (30) printed   not zero   share a body       SI m");
  List<Count> counts = run.pyramids;
  counts.push_back(run.tray);
  for (const Count& count : counts) {
    lesson.print(fmt::format("{:<12} {:>7} {:>9.0f} {:>11.0f} {:>14.0f} {:>10.0f} {:>14.0f} {:>10.0f}",
                             count.name, count.bodies, count.rows, count.dense, count.printed,
                             count.non_zeros, count.pairs, count.rows));
  }
  lesson.print("tray: 99 boxes that stand on one body. All rows share it, and no entry of A is zero.");
  lesson.print();
  lesson.print(
      "products of a sweep        naive 6 m²     full A m²      sparse A     SI 18 m    sparse / SI");
  for (const Count& count : counts) {
    const Work work = work_of(count);
    lesson.print(fmt::format("{:<24} {:>12.0f} {:>13.0f} {:>13.0f} {:>11.0f} {:>13.2f}", count.name,
                             work.naive, work.dense, work.sparse, work.si, work.sparse / work.si));
  }
  lesson.print();
}

void tell_kept(Lesson& lesson, const StoredRun& run) {
  lesson.print(fmt::format("base {}: what each solver keeps beside the rows, which take {} each",
                           run.settings.base, bytes_text(sizeof(ConstraintRow<double>))));
  for (const Kept& kept : run.kept) {
    lesson.print(fmt::format("  {:<14}{:>12}   {:>8.1f} bytes per row", kept.name, bytes_text(kept.bytes),
                             kept.bytes / run.pyramids.back().rows));
  }
  const Count& largest = run.pyramids.back();
  const double copies = sizeof(double) * (2 * largest.rows + 3 * (largest.bodies + 1));
  lesson.print(fmt::format(
      "  of sparse PGS's, λ, b and v are {:.1f} bytes per row, which SI has in the problem: {:.1f} "
      "are left",
      copies / largest.rows, (run.kept[2].bytes - copies) / largest.rows));
  lesson.print();
}

void check_claims(Lesson& lesson, const StoredRun& run) {
  check_counts(lesson, run);
  check_building(lesson, run);
  check_update(lesson, run);
  check_solvers(lesson, run);
}

CsvTable table_of(const StoredRun& run) {
  CsvTable table{.header = {"scene", "bodies", "rows", "full", "printed", "non_zeros", "pairs"}};
  List<Count> counts = run.pyramids;
  counts.push_back(run.tray);
  for (const Count& count : counts) {
    table.rows.push_back(
        {count.name, count.bodies, count.rows, count.dense, count.printed, count.non_zeros, count.pairs});
  }
  return table;
}

// What A costs before the first sweep, and what a sweep has to read.

namespace {

/// Products for all of A, pair by pair: three for each body that both rows move.
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
  lesson.print(fmt::format(
      "before the first sweep, base {}: from M⁻¹Jᵀ ({:.0f} products) A takes {:.0f}, as many as {:.1f} "
      "sweeps of SI; the effective masses of SI take {:.0f}",
      largest.base, 6 * largest.rows, work, work / (si_products * largest.rows), 6 * largest.rows));
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
  lesson.check_equal("building A: 3 products for each body that two rows share", gap, 0, 0);
}

}  // namespace cairn::stored
