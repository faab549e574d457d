// Floor 9. The search for the cheapest setting.
#include <cairn/study/tuning/tuner.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>
#include <cairn/study/jitter.hpp>
#include <cairn/study/tuning/tuner_search.hpp>

namespace cairn {

namespace {

// Of the time: when each part of the work has to be over. What one leaves is for the next.
constexpr double screening_end = 1.0 / 2;
constexpr double search_end = 2.0 / 3;
constexpr double plain_si_end = 5.0 / 6;
constexpr double box2d_end = 1;

void check_wish(const Wish& wish) {
  const std::pair<const char*, std::optional<double>> fields[] = {
      {"penetration", wish.penetration}, {"drift", wish.drift},
      {"residual", wish.residual},       {"energy_gain", wish.energy_gain},
      {"energy_loss", wish.energy_loss}, {"stands", wish.stands}};
  for (const auto& [name, value] : fields) {
    if (value) require(*value > 0 && std::isfinite(*value), "tune", name, "a finite number > 0", *value);
  }
  require(!wish.is_empty(), "tune", "wish", "at least one error that is to be met", "none");
}

void check_tuner_options(const TunerOptions& options) {
  require(options.starts >= 1, "tune", "starts", ">= 1", options.starts);
  require(options.time_limit > 0, "tune", "time_limit", "> 0 s", options.time_limit);
  require(options.budget.value_or(1) > 0, "tune", "budget", "> 0 s", options.budget.value_or(1));
}

bool is_alike(const Setting& a, const Setting& b) {
  return a.solver == b.solver && a.stabilization.policy == b.stabilization.policy;
}

/// The best and its runners-up.
int most_kinds(const TunerOptions& options) { return std::max(options.runners_up, 0) + 1; }

/// The same sweeps in other ways: single precision is seldom cheaper, and never by much; manifolds that last
/// until bodies have moved often are.
List<Setting> variants_of(const Setting& setting) {
  Setting in_single_precision = setting, when_moved = setting;
  in_single_precision.scalar = Precision::single_precision;
  when_moved.contact_search = ContactSearch::when_moved;
  Setting both = when_moved;
  both.scalar = Precision::single_precision;
  return {in_single_precision, when_moved, both};
}

/// The settings that were tried and do what was asked, so far.
class TunerField {
 public:
  TunerField(TunerSearch& search, const TunerOptions& options, TunerAnswer& answer)
      : search_(search), options_(options), answer_(answer) {
    settings_ = options.first;
    const List<Setting> rest = tuner_settings(options.solvers, options.has_joints);
    settings_.insert(settings_.end(), rest.begin(), rest.end());
  }

  /// From start 0: all that are not too much work, and the variants of the best. False: none was left.
  bool screen() {
    search_.end_at(screening_end);
    const int before = answer_.tried;
    for (const Setting& setting : settings_) {
      if (search_.is_too_much(setting, alive_.empty() ? nullptr : &alive_.front())) continue;
      if (!try_one(setting)) break;
    }
    for (const Candidate& kind : kinds()) {
      for (const Setting& variant : variants_of(kind.setting)) try_one(variant);
    }
    return answer_.tried > before;
  }

  /// From all starts: the best of each kind, as many as the answer names. False: one of them is out, and
  /// others may have been left out for its sake.
  bool confirm() {
    search_.end_at(search_end);
    bool all_hold = true;
    while (true) {
      const List<Candidate> best = kinds();
      const auto open = std::find_if(best.begin(), best.end(), [this](const Candidate& candidate) {
        return !search_.is_settled(candidate);
      });
      if (open == best.end()) return all_hold;
      const std::optional<Candidate> next =
          search_.candidate(open->setting, options_.starts, answer_.tried, answer_.tried);
      answer_.complete = answer_.complete && next && search_.is_settled(*next);
      if (!next || next->starts == open->starts) return all_hold;  // no time is left
      erase_if(alive_, [&](const Candidate& one) { return is_same(one.setting, next->setting); });
      if (search_.does(*next)) insert(*next);
      all_hold = all_hold && search_.does(*next);
    }
  }

  /// The best of each kind of setting, the best first.
  List<Candidate> kinds() const {
    List<Candidate> kinds;
    for (const Candidate& candidate : alive_) {
      const bool is_new = std::none_of(kinds.begin(), kinds.end(), [&](const Candidate& other) {
        return is_alike(other.setting, candidate.setting);
      });
      if (is_new && kinds.size() < most_kinds(options_)) kinds.push_back(candidate);
    }
    return kinds;
  }

 private:
  static bool is_same(const Setting& a, const Setting& b) { return setting_text(a) == setting_text(b); }

  void insert(const Candidate& candidate) {
    const auto place =
        std::upper_bound(alive_.begin(), alive_.end(), candidate,
                         [this](const Candidate& a, const Candidate& b) { return search_.is_better(a, b); });
    alive_.insert(place, candidate);
  }

  /// Once. False: there is no time left.
  bool try_one(const Setting& setting) {
    const std::string text = setting_text(setting);
    if (tried_.count(text) > 0) return true;
    const int total = std::max(settings_.size(), answer_.tried + 1);
    const std::optional<Candidate> candidate = search_.candidate(setting, 1, answer_.tried + 1, total);
    answer_.complete = answer_.complete && candidate.has_value();
    if (!candidate) return false;
    tried_.insert(text);
    answer_.tried += 1;
    if (search_.does(*candidate)) {
      insert(*candidate);
    } else if (is_nearer(*candidate)) {
      answer_.nearest = candidate;
    }
    return true;
  }

  /// Runs that miss a wish are given up there: what came from more work came nearer. To a budget the shorter
  /// one is, and before all others one that does not fail.
  bool is_nearer(const Candidate& candidate) const {
    if (!answer_.nearest) return true;
    if (options_.budget) {
      const bool holds = std::isfinite(candidate.share), held = std::isfinite(answer_.nearest->share);
      return holds != held ? holds : candidate.frame < answer_.nearest->frame;
    }
    return expected_work(candidate.setting) >= expected_work(answer_.nearest->setting);
  }

  TunerSearch& search_;
  const TunerOptions& options_;
  TunerAnswer& answer_;
  List<Setting> settings_ = {};
  std::set<std::string> tried_ = {};  // setting_text()
  List<Candidate> alive_ = {};        // the best first
};

}  // namespace

TunerAnswer tune(const TunerRun& run, const Wish& wish, const TunerOptions& options) {
  check_wish(wish);
  check_tuner_options(options);
  TunerSearch search(run, wish, options);
  TunerAnswer answer;
  TunerField field(search, options, answer);
  // Where the best is out, what was left out beside it gets its turn.
  while (field.screen() && !field.confirm()) {
  }
  const List<Candidate> kinds = field.kinds();
  if (!kinds.empty()) {
    answer.best = kinds.front();
    answer.nearest.reset();
    answer.runners_up.assign(kinds.begin() + 1, kinds.end());
  }
  answer.complete = answer.complete && !search.told_to_stop();
  search.end_at(plain_si_end);
  answer.plain_si = search.rival(plain_si_settings(), answer.tried);
  search.end_at(box2d_end);
  if (has_box2d()) answer.box2d = search.rival(box2d_settings(), answer.tried);
  return answer;
}

TunerAnswer tune(const SceneEntry& scene, double seconds, const Wish& wish, TunerOptions options,
                 const std::function<bool()>& stops) {
  const Scene made = scene.make();
  options.has_joints = !made.joints().empty();
  const List<std::string>& solvers = options.solvers;
  if (std::count(solvers.begin(), solvers.end(), scene.setting.solver) > 0) options.first = {scene.setting};
  TrialOptions trial = trial_options(scene);
  trial.seconds = seconds;
  trial.residual = wish.residual ? ResidualMeasure::every_step : ResidualMeasure::off;
  const bool has_budget = options.budget.has_value();
  const TunerRun run = [&](const Setting& setting, std::uint64_t start, double seconds_left) {
    const auto begin = std::chrono::steady_clock::now();
    trial.gives_up = [&](const TrialResult& so_far) {
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
      const bool late = passed.count() > seconds_left;
      if (late || stops()) return true;
      const RunJudgement judgement = judge(so_far, wish);
      return has_budget ? judgement.fails() : judgement.is_lost();
    };
    TrialResult result = run_trial(nth_start(made, start), setting, trial);
    if (stops()) result.status = TrialStatus::timeout;  // it may have been cut short
    return result;
  };
  return tune(run, wish, options);
}

}  // namespace cairn
