// Floor 9. Runs, and what came of all starts of a setting together.
#include <cairn/study/tuning/tuner_search.hpp>

#include <algorithm>
#include <cmath>

#include <cairn/scenes/solver_list.hpp>

namespace cairn {

namespace {

// Measured cost and expected work agree within about so much: of settings of one solver, and of several.
constexpr double solver_margin = 2;
constexpr double search_margin = 4;

double median_of(List<double> values) {
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return values.size() % 2 == 1 ? *middle : (*middle + *std::max_element(values.begin(), middle)) / 2;
}

/// What a unit of work costs. Where solves end by themselves, a run that does badly does many times the work
/// that is expected: the least shows what one costs that does well.
double cost_of(const SolverEntry& solver, const List<double>& costs) {
  return solver.ends_by_itself() ? *std::min_element(costs.begin(), costs.end()) : median_of(costs);
}

}  // namespace

bool TunerSearch::does(const Candidate& candidate) const {
  if (!options_.budget) return candidate.meets();
  return candidate.frame <= *options_.budget && std::isfinite(candidate.share);
}

bool TunerSearch::is_better(const Candidate& a, const Candidate& b) const {
  return options_.budget && a.share != b.share ? a.share < b.share : a.cost < b.cost;
}

bool TunerSearch::is_too_much(const Setting& setting, const Candidate* best) const {
  if ((best == nullptr && !options_.budget) || cost_of_work_.empty()) return false;
  const double limit = options_.budget ? 60 * *options_.budget : best->cost;  // [s] for a second
  const auto own = cost_of_work_.find(setting.solver);
  if (own != cost_of_work_.end())
    return expected_work(setting) * cost_of(solver_entry(setting.solver), own->second) >
           solver_margin * limit;
  List<double> all;
  for (const auto& [solver, costs] : cost_of_work_) all.insert(all.end(), costs.begin(), costs.end());
  return expected_work(setting) * median_of(all) > search_margin * limit;
}

bool TunerSearch::is_settled(const Candidate& candidate) const {
  return candidate.starts >= options_.starts || !goes_on(candidate);
}

/// What misses the wish from one start need not be tried from another.
bool TunerSearch::goes_on(const Candidate& candidate) const {
  return candidate.starts == 0 || does(candidate);
}

double TunerSearch::seconds_left() const {
  return end_ - std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

std::optional<Candidate> TunerSearch::candidate(const Setting& setting, int starts, int tried, int total) {
  if (told_to_stop_) return std::nullopt;
  Tried& all =
      known_.try_emplace(setting_text(setting), Tried{.candidate = {.setting = setting}}).first->second;
  while (all.candidate.starts < starts && goes_on(all.candidate)) {
    if (!try_start(all)) break;
  }
  if (all.candidate.starts == 0) return std::nullopt;
  if (options_.progress && !options_.progress(tried, total)) told_to_stop_ = true;
  return all.candidate;
}

std::optional<Candidate> TunerSearch::rival(const List<Setting>& settings, int tried) {
  std::optional<Candidate> best, last;
  for (const Setting& setting : settings) {
    if (last && is_too_much(setting, best ? &*best : nullptr)) break;
    const std::optional<Candidate> next = candidate(setting, options_.starts, tried, tried);
    if (!next) break;
    last = next;
    last->list_exhausted = &setting == &settings.back();
    if (does(*next) && (!best || is_better(*next, *best))) best = next;
    if (best && !options_.budget) break;
  }
  return best ? best : last;
}

bool TunerSearch::try_start(Tried& all) {
  const double left = seconds_left();
  if (!(left > 0)) return false;
  const int start = all.candidate.starts;
  const TrialResult result = run_(all.candidate.setting, static_cast<std::uint64_t>(start), left);
  if (!(seconds_left() > 0)) return false;  // it may have been cut short
  add(result, all);
  if (start == 0 && result.cost() > 0)
    cost_of_work_[all.candidate.setting.solver].push_back(result.cost() /
                                                          expected_work(all.candidate.setting));
  return true;
}

void TunerSearch::add(const TrialResult& result, Tried& all) const {
  Candidate& candidate = all.candidate;
  const RunJudgement judgement = judge(result, wish_);
  if (candidate.missed.empty()) candidate.missed = judgement.first_missed(result.seconds);
  candidate.share = std::max(candidate.share, judgement.share());
  all.costs.push_back(result.cost());
  all.frames.push_back(result.frame());
  all.updates.push_back(result.work());
  candidate.cost = median_of(all.costs);
  candidate.frame = median_of(all.frames);
  candidate.row_updates = median_of(all.updates);
  const auto keep_larger = [](double& kept, double value) { kept = std::max(kept, value); };
  keep_larger(candidate.slowest_step, result.slowest_step);
  keep_larger(candidate.worst_penetration, result.worst_penetration);
  keep_larger(candidate.worst_drift, result.worst_drift);
  keep_larger(candidate.worst_residual, result.worst_residual.value_or(0));
  keep_larger(candidate.energy_gain, result.energy_gain);
  keep_larger(candidate.energy_loss, result.energy_loss);
  const double stood = result.stands_until;
  candidate.stands_until = candidate.starts == 0 ? stood : std::min(candidate.stands_until, stood);
  candidate.starts += 1;
}

}  // namespace cairn
