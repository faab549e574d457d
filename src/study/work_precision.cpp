// Floor 9. Level 1 of the trade: frozen problems.
#include <cairn/study/work_precision.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <cairn/measure/fingerprint.hpp>
#include <cairn/solvers/non_zeros.hpp>
#include <cairn/solvers/exact/reference_solver.hpp>
#include <cairn/study/build_info.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/study/trade_row.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// A problem and what is true of it, found once.
struct KnownProblem {
  FrozenProblem frozen = {};
  Uniqueness unique = Uniqueness::unknown;
  std::optional<PerBody<Vec3<double>>> truth = {};
  std::uint64_t fingerprint = 0;  // of its numbers
  bool solved = false;
};

std::uint64_t problem_fingerprint(const VelocityProblem<double>& problem) {
  Fingerprint hash;
  hash.add(problem.dt);
  for (const Vec3<double>& inverse_mass : problem.inverse_mass) hash.add(inverse_mass);
  for (const Vec3<double>& velocity : problem.velocity) hash.add(velocity);
  for (const double impulse : problem.impulse) hash.add(impulse);
  for (const ConstraintRow<double>& row : problem.rows) {
    for (const int body : {row.a.index, row.b.index}) hash.add(static_cast<double>(body));
    hash.add(row.jacobian_a);
    hash.add(row.jacobian_b);
    for (const double number :
         {row.bias, row.softness, row.bounds.lower, row.bounds.upper, row.bounds.friction})
      hash.add(number);
  }
  return hash.value();
}

void find_truth(KnownProblem& known) {
  if (known.solved) return;
  known.solved = true;
  known.fingerprint = problem_fingerprint(known.frozen.problem);
  ReferenceSolver<double> reference;
  VelocityProblem<double> answer = known.frozen.problem;
  const SolveReport report = reference.solve(answer);
  known.unique = reference.report().velocity.verdict;
  if (report.converged && known.unique == Uniqueness::unique) known.truth = answer.velocity;
}

std::string uniqueness_word(Uniqueness unique) {
  return unique == Uniqueness::unique ? "yes" : unique == Uniqueness::not_unique ? "no" : "unknown";
}

std::string start_word(Start start) { return start == Start::warm ? "warm" : "cold"; }

void set_error(TradeRow& row, const AnswerError<double>& error) {
  row.set("R_E", error.from_impulses.energy);
  row.set("R_E_v", error.returned.energy);
  row.set("r_inf_e", error.returned.velocity_equality);
  row.set("r_inf_n", error.returned.velocity_normal);
  row.set("r_inf_t", error.returned.velocity_friction);
  if (error.velocity) row.set("E_M", *error.velocity);
  row.set("delta_v_lambda", error.drift);
  row.set("gap_J", error.gap);
}

List<CsvCell> solve_row(KnownProblem& known, const SolveChoice& choice, const SolveTiming& timing) {
  find_truth(known);
  const VelocityProblem<double>& problem = known.frozen.problem;
  const SolveOutcome outcome = try_solver(problem, choice, known.truth, timing);
  TradeRow row;
  set_build(row);
  row.set("scalar", word_of(choice.scalar));
  row.set("scene", known.frozen.name);
  row.set("scene_hash", hexadecimal(known.fingerprint));
  row.set("level", 1LL);
  row.set("bodies", static_cast<long long>(problem.body_count()));
  row.set("rows", static_cast<long long>(problem.row_count()));
  row.set("nnzA", static_cast<long long>(non_zeros(problem)));
  row.set("unique_v", uniqueness_word(known.unique));
  row.set("solver", choice.solver);
  row.set("setting", fmt::format("{} x{}", choice.solver, choice.sweeps));
  row.set("dt", problem.dt);
  row.set("sweeps", static_cast<long long>(choice.sweeps));
  row.set("warm", start_word(choice.start));
  row.set("friction_model", std::string("coupled"));
  if (known.truth) row.set("ref_kind", std::string("reference"));
  row.set("status", outcome.status);
  if (outcome.status == "refused") return row.cells();
  row.set("row_updates", static_cast<long long>(outcome.row_updates));
  set_error(row, outcome.error);
  row.set("reps", static_cast<long long>(outcome.times.repetitions));
  if (outcome.times.repetitions > 0) {
    row.set("solve_ns_min", outcome.times.least);
    row.set("solve_ns_med", outcome.times.median);
    row.set("solve_ns_iqr", outcome.times.quartile_range);
  }
  row.set("state_hash", fmt::format("{:016x}", outcome.state_hash));
  return row.cells();
}

/// Every point of the grid for one problem.
void add_solve_tasks(const std::shared_ptr<KnownProblem>& known, const SolveGrid& grid, Study& study) {
  for (const std::string& solver : grid.solvers) {
    for (const Precision scalar : grid.scalars) {
      for (const Start start : grid.starts) {
        for (int sweeps = 1; sweeps <= grid.most_sweeps; sweeps *= 2) {
          const SolveChoice choice{.solver = solver, .sweeps = sweeps, .scalar = scalar, .start = start};
          study.tasks.push_back(
              {.name = fmt::format("{} {} x{}", known->frozen.name, solver, sweeps),
               .run = [known, choice, timing = grid.timing] { return solve_row(*known, choice, timing); }});
        }
      }
    }
  }
}

}  // namespace

Study solve_study(const List<FrozenProblem>& problems, const SolveGrid& grid) {
  Study study{.name = "cairn work against error 1:", .header = trade_header(), .tasks = {}};
  for (const std::string& solver : grid.solvers) study.name += " " + solver_entry(solver).name;
  study.name += fmt::format("; up to {} sweeps,", grid.most_sweeps);
  for (const Start start : grid.starts) study.name += " " + start_word(start);
  study.name += ", in";
  for (const Precision scalar : grid.scalars) study.name += " " + word_of(scalar);
  study.name += fmt::format("; {} timings;", grid.timing.repetitions);
  for (const FrozenProblem& problem : problems) {
    study.name += " " + problem.name;
    add_solve_tasks(std::make_shared<KnownProblem>(KnownProblem{.frozen = problem}), grid, study);
  }
  return study;
}

CsvTable rows_with(const CsvTable& table, const std::map<std::string, std::string>& words) {
  CsvTable result{.header = table.header, .rows = {}};
  for (int i = 0; i < table.rows.size(); ++i) {
    const bool has_all = std::all_of(words.begin(), words.end(), [&](const auto& word) {
      return text_in(table, i, word.first) == word.second;
    });
    if (has_all) result.rows.push_back(table.rows[i]);
  }
  return result;
}

bool is_point(const std::string& status) {
  return status == "ok" || status == "plateau" || status == "cycle";
}

List<TradePoint> trade_points(const CsvTable& table, const std::string& work, const std::string& error,
                              double least_error) {
  List<TradePoint> points;
  for (int i = 0; i < table.rows.size(); ++i) {
    if (!is_point(text_in(table, i, "status"))) continue;
    TradePoint point{.solver = text_in(table, i, "solver"),
                     .setting = text_in(table, i, "setting"),
                     .work = number_in(table, i, work),
                     .error = number_in(table, i, error),
                     .row = i};
    if (!(point.work > 0) || !std::isfinite(point.work) || !(point.error >= 0) || !std::isfinite(point.error))
      continue;
    point.error = std::max(point.error, least_error);
    points.push_back(point);
  }
  for (TradePoint& point : points) {
    point.on_front = std::none_of(points.begin(), points.end(), [&](const TradePoint& other) {
      const bool no_worse = other.work <= point.work && other.error <= point.error;
      return no_worse && (other.work < point.work || other.error < point.error);
    });
  }
  return points;
}

CsvTable rows_with_steady_times(const CsvTable& table, double most_spread) {
  CsvTable result{.header = table.header, .rows = {}};
  for (int i = 0; i < table.rows.size(); ++i) {
    const double range = number_in(table, i, "solve_ns_iqr"), median = number_in(table, i, "solve_ns_med");
    const bool is_noisy = range > most_spread * median;  // not so where there is no number
    if (!is_noisy) result.rows.push_back(table.rows[i]);
  }
  return result;
}

List<WorkToError> work_to_errors(const CsvTable& table, const List<double>& residuals) {
  List<WorkToError> all;
  std::map<std::pair<std::string, std::string>, std::pair<int, double>> known;  // place, most sweeps
  for (int i = 0; i < table.rows.size(); ++i) {
    const std::string scene = text_in(table, i, "scene"), solver = text_in(table, i, "solver");
    const auto [found, is_new] = known.try_emplace({scene, solver}, all.size(), 0.0);
    if (is_new) {
      const double never = std::numeric_limits<double>::infinity();
      all.push_back({scene, solver, List<double>(residuals.size(), never), ""});
    }
    WorkToError& entry = all[found->second.first];
    const double sweeps = number_in(table, i, "sweeps");
    if (sweeps >= found->second.second) {
      found->second.second = sweeps;
      entry.ending = text_in(table, i, "status");
    }
    const double reached = number_in(table, i, "R_E_v"), work = number_in(table, i, "row_updates");
    for (int k = 0; k < residuals.size(); ++k) {
      if (reached <= residuals[k]) entry.row_updates[k] = std::min(entry.row_updates[k], work);
    }
  }
  return all;
}

double PerformanceProfile::share(double tau) const {
  if (ratios.empty()) return 0;
  const auto beyond = std::upper_bound(ratios.begin(), ratios.end(), tau);
  // An infinite tau does not make a failure a success.
  const auto failed = std::lower_bound(ratios.begin(), ratios.end(), std::numeric_limits<double>::infinity());
  return static_cast<double>(std::min(beyond, failed) - ratios.begin()) / static_cast<double>(ratios.size());
}

List<PerformanceProfile> performance_profiles(const List<WorkToError>& work, int which) {
  const double never = std::numeric_limits<double>::infinity();
  std::map<std::string, double> least;  // by problem
  for (const WorkToError& entry : work) {
    const auto found = least.try_emplace(entry.scene, never).first;
    found->second = std::min(found->second, entry.row_updates.at(which));
  }
  List<PerformanceProfile> profiles;
  for (const WorkToError& entry : work) {
    auto own = std::find_if(profiles.begin(), profiles.end(),
                            [&](const PerformanceProfile& p) { return p.solver == entry.solver; });
    if (own == profiles.end()) own = profiles.insert(own, {.solver = entry.solver, .ratios = {}});
    const double updates = entry.row_updates.at(which), best = least.at(entry.scene);
    if (updates < never) own->ratios.push_back(updates == best ? 1 : updates / best);
  }
  for (PerformanceProfile& profile : profiles) {
    profile.ratios.resize(std::ssize(least), never);
    std::sort(profile.ratios.begin(), profile.ratios.end());
  }
  return profiles;
}

}  // namespace cairn
