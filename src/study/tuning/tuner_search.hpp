// Floor 9. The runs of a tuner: each start of a setting once, within the time.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>

#include <cairn/math/list.hpp>
#include <cairn/study/tuning/tuner.hpp>

namespace cairn {

/// Runs settings, each start of them once, until time is over or it is told to stop.
class TunerSearch {
 public:
  /// Keeps references to all three.
  TunerSearch(const TunerRun& run, const Wish& wish, const TunerOptions& options)
      : run_(run), wish_(wish), options_(options) {}

  bool told_to_stop() const { return told_to_stop_; }
  /// What follows has to be over by that share of the time.
  void end_at(double share) { end_ = share * options_.time_limit; }

  /// Whether a setting is what was asked for, as far as it was tried.
  bool does(const Candidate& candidate) const;
  bool is_better(const Candidate& a, const Candidate& b) const;
  /// A setting that must be expected to cost more than the margin allows, beside the best or the budget.
  bool is_too_much(const Setting& setting, const Candidate* best) const;
  /// Whether no start is left that has to be tried.
  bool is_settled(const Candidate& candidate) const;

  /// What came of the setting from its first `starts` starts, or of fewer where the time is over; nothing of
  /// none. `tried` of `total` settings are what progress is told.
  std::optional<Candidate> candidate(const Setting& setting, int starts, int tried, int total);
  /// Of a few settings in the order of their work: the first that meets the wish, or within the budget the
  /// best; else the last one tried. Progress is told that all `tried` are done.
  std::optional<Candidate> rival(const List<Setting>& settings, int tried);

 private:
  /// A candidate, and the numbers whose medians are in it.
  struct Tried {
    Candidate candidate = {};
    List<double> costs = {}, frames = {}, updates = {};
  };

  double seconds_left() const;
  bool goes_on(const Candidate& candidate) const;
  bool try_start(Tried& all);
  void add(const TrialResult& result, Tried& all) const;

  const TunerRun& run_;
  const Wish& wish_;
  const TunerOptions& options_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double end_ = 0;                                    // [s] after that
  std::map<std::string, Tried> known_;                // by setting_text()
  std::map<std::string, List<double>> cost_of_work_;  // [s] of a unit of expected_work(), by solver
  bool told_to_stop_ = false;
};

}  // namespace cairn
