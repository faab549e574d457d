// Lesson 10. What is stored: entries of A, and equation (30) taken at its word.
// PGS as section 2 writes it stores how every row acts on every other; SI stores one number per row. We go
// through all pairs of rows of a few pyramids and count: the pairs that have an entry in A, those that (30)
// counts, and those that share a body which can move, for which a sparse A needs room. Then the solvers say
// themselves what they keep.
#include "lesson.hpp"

#include <cairn/solvers/body_rows.hpp>

namespace {

using namespace cairn;
using namespace cairn::stored;

// [share]
/// Whether both rows act on a body that can move. The ground cannot: its M⁻¹ is 0.
bool share_a_body(const VelocityProblem<double>& problem, const ConstraintRow<double>& first,
                  const ConstraintRow<double>& second) {
  for (const BodyId body : {first.a, first.b}) {
    const bool moves = problem.inverse_mass[body] != Vec3<double>::Zero();
    if (moves && (body == second.a || body == second.b)) return true;
  }
  return false;
}
// [/share]

/// All pairs of rows.
Count count_pairs(const VelocityProblem<double>& problem) {
  const PerBody<Vec3<double>>& M_inverse = problem.inverse_mass;
  const PerBody<Vec3<double>> ones(M_inverse.size(), Vec3<double>::Ones());
  const double m = problem.row_count();
  Count count{.bodies = problem.body_count() - 1, .rows = m, .dense = m * m};
  for (const ConstraintRow<double>& first : problem.rows) {
    for (const ConstraintRow<double>& second : problem.rows) {
      if (coupling(problem, first, second, M_inverse) != 0) count.non_zeros += 1;  // J_i M⁻¹ J_jᵀ of (15)
      if (coupling(problem, first, second, ones) != 0) count.printed += 1;         // J_i · J_j of (30)
      if (share_a_body(problem, first, second)) count.pairs += 1;
    }
  }
  return count;
}

/// Lets a solver solve, and asks what it has kept for that.
template <typename Solver>
Kept kept_by(Solver solver, VelocityProblem<double> problem) {
  solver.solve(problem);
  return {.name = solver.name(), .bytes = static_cast<double>(solver.memory()), .impulse = problem.impulse};
}

StoredRun count_all(const StoredSettings& settings) {
  StoredRun run{.settings = settings};
  for (const int base : {3, 5, 10, settings.base}) {
    const Scene scene = pyramid_scene(base, settings.spacing);
    run.problems.push_back(World(scene).velocity_problem());
    run.pyramids.push_back(count_pairs(run.problems.back()));
    run.pyramids.back().name = fmt::format("base {}", base);
    run.pyramids.back().base = base;
    run.snapshots.push_back(with_contacts(scene));
  }
  const VelocityProblem<double>& largest = run.problems.back();
  const SolverSettings sweeps{.iterations = settings.sweeps};
  run.kept = {kept_by(SequentialImpulse<double>(sweeps), largest),
              kept_by(FactoredProjectedGaussSeidel<double>(sweeps), largest),
              kept_by(SparseProjectedGaussSeidel<double>(sweeps), largest),
              kept_by(ProjectedGaussSeidel<double>(sweeps), largest)};
  run.tray_problem = World(tray_scene(boxes_on_tray)).velocity_problem();
  run.tray = count_pairs(run.tray_problem);
  run.tray.name = "tray";
  run.tray_snapshot = with_contacts(tray_scene(boxes_on_tray));
  return run;
}

void run(Lesson& lesson) {
  const StoredRun stored = count_all(
      {.base = lesson.whole("base"), .spacing = lesson.real("spacing"), .sweeps = lesson.whole("sweeps")});
  tell_scene(lesson, stored);
  lesson.predict();
  tell_counts(lesson, stored);
  tell_kept(lesson, stored);
  tell_building(lesson, stored);
  const List<char> middle = pattern(stored.problems.back())[stored.problems.back().row_count() / 2];
  lesson.answer({static_cast<double>(std::count(middle.begin(), middle.end(), 1))}, 0,
                "8 rows act on each of its two boxes, and the two rows of the overlap on both: 8 + 8 − 2, "
                "however high the pyramid is.");
  check_claims(lesson, stored);
  lesson.film(stored_shots(stored));
  lesson.data(table_of(stored));
  const PerRow<double>& impulse = stored.kept[0].impulse;
  lesson.fingerprint(List<double>(impulse.begin(), impulse.end()));
}

}  // namespace

int main(int argc, char** argv) { return run_lesson(card(), run, argc, argv); }
