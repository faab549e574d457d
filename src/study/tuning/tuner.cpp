// Floor 9. The search for the cheapest setting.
#include <cairn/study/tuning/tuner.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>
#include <cairn/study/expectation.hpp>
#include <cairn/study/jitter.hpp>

namespace cairn {

namespace {

using TunerClock = std::chrono::steady_clock;

// Of the time: when each part of the work has to be over. What one leaves is for the next.
constexpr double search_end = 2.0 / 3;
constexpr double plain_si_end = 5.0 / 6;
constexpr double box2d_end = 1;
constexpr double search_margin = 4;  // measured cost and expected work agree within about so much

double median_of(List<double> values) {
  std::sort(values.begin(), values.end());
  const int n = values.size();
  return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

std::string length_text(double metres) { return fmt::format("{:.3g} mm", 1e3 * metres); }

/// Runs are often given up where they miss the wish: what was found is of so much of them.
Verdict missed_verdict(const std::string& what, const TrialResult& result) {
  return {false, fmt::format("{} after {:.3g} s", what, result.seconds)};
}

/// How long it stood, or how far it ended from where it should.
std::string fall_text(const TrialResult& result) {
  const List<double>& distances = result.place_distances;
  if (distances.empty()) return fmt::format("stands {:.3g} s", result.stands_until);
  return "ends " + length_text(*std::max_element(distances.begin(), distances.end())) + " out of place";
}

void check_wish(const Wish& wish) {
  const std::pair<const char*, std::optional<double>> fields[] = {{"penetration", wish.penetration},
                                                                  {"drift", wish.drift},
                                                                  {"residual", wish.residual},
                                                                  {"energy_gain", wish.energy_gain},
                                                                  {"stands", wish.stands}};
  bool is_empty = true;
  for (const auto& [name, value] : fields) {
    if (!value) continue;
    is_empty = false;
    require(*value > 0 && std::isfinite(*value), "tune", name, "a finite number > 0", *value);
  }
  require(!is_empty, "tune", "wish", "at least one error that is to be met", "none");
}

void check_tuner_options(const TunerOptions& options) {
  require(options.starts >= 1, "tune", "starts", ">= 1", options.starts);
  require(options.time_limit > 0, "tune", "time_limit", "> 0 s", options.time_limit);
}

/// Runs settings, each of them once, until time is over or it is told to stop.
class TunerSearch {
 public:
  TunerSearch(const TunerRun& run, const Wish& wish, const TunerOptions& options)
      : run_(run), wish_(wish), options_(options) {}

  bool told_to_stop() const { return told_to_stop_; }
  /// What follows has to be over by that share of the time.
  void end_at(double share) { end_ = share * options_.time_limit; }

  /// `tried` of `total` settings are what progress is told. Nothing where the time is over, or it was told to
  /// stop.
  std::optional<Candidate> candidate(const Setting& setting, int tried, int total) {
    if (told_to_stop_) return std::nullopt;
    const std::string name = setting_text(setting);
    auto found = known_.find(name);
    if (found == known_.end()) {
      const std::optional<Candidate> now = try_setting(setting);
      if (!now) return std::nullopt;
      found = known_.emplace(name, *now).first;
    }
    if (options_.progress && !options_.progress(tried, total)) told_to_stop_ = true;
    return found->second;
  }

  /// Of a few settings in the order of their work, the first that meets the wish, else the last one tried.
  /// Progress is told that all `tried` are done.
  std::optional<Candidate> first_that_meets(const List<Setting>& settings, int tried) {
    std::optional<Candidate> last;
    for (const Setting& setting : settings) {
      const std::optional<Candidate> next = candidate(setting, tried, tried);
      if (!next) break;
      last = next;
      if (last->verdict.meets) break;
      last->list_exhausted = &setting == &settings.back();
    }
    return last;
  }

 private:
  double seconds_left() const {
    return end_ - std::chrono::duration<double>(TunerClock::now() - begin_).count();
  }

  /// Runs a setting from starts 0, 1, ... and stops at the first that misses the wish.
  std::optional<Candidate> try_setting(const Setting& setting) const {
    Candidate candidate{.setting = setting};
    List<double> costs, updates;
    for (int start = 0; start < options_.starts && candidate.verdict.meets; ++start) {
      if (!(seconds_left() > 0)) return std::nullopt;
      const TrialResult result = run_(setting, static_cast<std::uint64_t>(start), seconds_left());
      if (!(seconds_left() > 0)) return std::nullopt;  // it may have been cut short
      candidate.verdict = verdict(result, wish_);
      candidate.starts += 1;
      costs.push_back(result.cost());
      updates.push_back(result.work());
      candidate.worst_penetration = std::max(candidate.worst_penetration, result.worst_penetration);
      candidate.worst_drift = std::max(candidate.worst_drift, result.worst_drift);
      candidate.worst_residual = std::max(candidate.worst_residual, result.worst_residual.value_or(0));
      candidate.energy_gain = std::max(candidate.energy_gain, result.energy_gain);
      candidate.stands_until =
          start == 0 ? result.stands_until : std::min(candidate.stands_until, result.stands_until);
    }
    candidate.cost = median_of(costs);
    candidate.row_updates = median_of(updates);
    return candidate;
  }

  const TunerRun& run_;
  const Wish& wish_;
  const TunerOptions& options_;
  TunerClock::time_point begin_ = TunerClock::now();
  double end_ = 0;                          // [s] after that
  std::map<std::string, Candidate> known_;  // by setting_text()
  bool told_to_stop_ = false;
};

bool is_alike(const Setting& a, const Setting& b) {
  return a.solver == b.solver && a.stabilization.policy == b.stabilization.policy;
}

/// The best of each kind of setting, cheapest first.
List<Candidate> ranked(List<Candidate> met) {
  std::stable_sort(met.begin(), met.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  List<Candidate> kinds;
  for (const Candidate& candidate : met) {
    const bool is_new = std::none_of(kinds.begin(), kinds.end(), [&](const Candidate& other) {
      return is_alike(other.setting, candidate.setting);
    });
    if (is_new) kinds.push_back(candidate);
  }
  return kinds;
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

/// All that meet the wish: of the settings until they are too much work, and of the variants of the best.
List<Candidate> all_that_meet(TunerSearch& search, const TunerOptions& options, TunerAnswer& answer) {
  const List<Setting> settings = tuner_settings(options.solvers, options.has_joints);
  const int total = settings.size();
  List<Candidate> met;
  double least_work = 0;
  for (const Setting& setting : settings) {
    const double work = expected_work(setting);
    if (!met.empty() && work > search_margin * least_work) break;
    const std::optional<Candidate> candidate = search.candidate(setting, answer.tried + 1, total);
    answer.complete = candidate.has_value();
    if (!candidate) break;
    answer.tried += 1;
    if (candidate->verdict.meets) {
      if (met.empty()) least_work = work;
      met.push_back(*candidate);
    } else if (met.empty()) {
      answer.nearest = candidate;
    }
  }
  const List<Candidate> kinds = ranked(met);
  List<Setting> variants;
  for (int i = 0; i < std::min(kinds.size(), most_kinds(options)); ++i) {
    for (const Setting& variant : variants_of(kinds[i].setting)) variants.push_back(variant);
  }
  const int in_all = answer.tried + variants.size();  // the settings that are too much work are not tried
  for (const Setting& variant : variants) {
    const std::optional<Candidate> candidate = search.candidate(variant, answer.tried + 1, in_all);
    answer.complete = answer.complete && candidate.has_value();
    if (!candidate) break;
    answer.tried += 1;
    if (candidate->verdict.meets) met.push_back(*candidate);
  }
  answer.complete = answer.complete && !search.told_to_stop();
  return met;
}

}  // namespace

Verdict verdict(const TrialResult& result, const Wish& wish) {
  if (wish.stands && result.status == TrialStatus::ok && !(result.stands_until >= *wish.stands)) {
    return {false, fall_text(result)};
  }
  return verdict_so_far(result, wish);
}

Verdict verdict_so_far(const TrialResult& result, const Wish& wish) {
  if (result.status == TrialStatus::refused) return {false, "refused: " + result.reason};
  if (result.status != TrialStatus::ok) {
    return missed_verdict(status_text(result.status), result);
  }
  const auto misses = [](double value, const std::optional<double>& limit) {
    return limit && !(value <= *limit);
  };
  if (wish.stands && result.fell_at && !(*result.fell_at >= *wish.stands)) {
    return {false, fall_text(result)};
  }
  if (misses(result.worst_penetration, wish.penetration)) {
    return missed_verdict("penetration " + length_text(result.worst_penetration), result);
  }
  if (misses(result.worst_drift, wish.drift)) {
    return missed_verdict("drift " + length_text(result.worst_drift), result);
  }
  if (misses(result.energy_gain, wish.energy_gain)) {
    return missed_verdict(fmt::format("energy gain {:.3g} %", 100 * result.energy_gain), result);
  }
  // Who cannot tell its residual does not meet a wish for one.
  if (wish.residual && !result.worst_residual) return {false, "R_E cannot be measured"};
  if (misses(result.worst_residual.value_or(0), wish.residual)) {
    return missed_verdict(fmt::format("R_E {:.2g}", *result.worst_residual), result);
  }
  if (!result.failures.empty()) return {false, failure_text(result.failures.front())};
  return {};
}

TunerAnswer tune(const TunerRun& run, const Wish& wish, const TunerOptions& options) {
  check_wish(wish);
  check_tuner_options(options);
  TunerSearch search(run, wish, options);
  TunerAnswer answer;
  search.end_at(search_end);
  const List<Candidate> kinds = ranked(all_that_meet(search, options, answer));
  if (!kinds.empty()) {
    answer.best = kinds.front();
    answer.nearest.reset();
    const int most = std::min(kinds.size(), most_kinds(options));
    answer.runners_up.assign(kinds.begin() + 1, kinds.begin() + most);
  }
  search.end_at(plain_si_end);
  answer.plain_si = search.first_that_meets(plain_si_settings(), answer.tried);
  search.end_at(box2d_end);
  if (has_box2d()) answer.box2d = search.first_that_meets(box2d_settings(), answer.tried);
  return answer;
}

TunerAnswer tune(const SceneEntry& scene, double seconds, const Wish& wish, TunerOptions options,
                 const std::function<bool()>& stops) {
  const Scene made = scene.make();
  options.has_joints = !made.joints().empty();
  TrialOptions trial = trial_options(scene);
  trial.seconds = seconds;
  trial.residual = wish.residual ? ResidualMeasure::every_step : ResidualMeasure::off;
  const TunerRun run = [&](const Setting& setting, std::uint64_t start, double seconds_left) {
    const TunerClock::time_point begin = TunerClock::now();
    trial.gives_up = [&](const TrialResult& so_far) {
      const bool late = std::chrono::duration<double>(TunerClock::now() - begin).count() > seconds_left;
      return late || stops() || !verdict_so_far(so_far, wish).meets;
    };
    TrialResult result = run_trial(nth_start(made, start), setting, trial);
    if (stops()) result.status = TrialStatus::timeout;  // it may have been cut short
    return result;
  };
  return tune(run, wish, options);
}

}  // namespace cairn
