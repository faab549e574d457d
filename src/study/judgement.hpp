// Floor 9. The one judgement of a run: what is asked of it, and how far it is from that.
#pragma once

#include <optional>
#include <string>

#include <cairn/scenes/scene_list.hpp>
#include <cairn/study/trial.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// What is asked of a run: what its scene expects, or what a user wishes. What is left out is not asked.
struct Wish {
  std::optional<double> penetration = {};  // [m] of any two shapes, at most
  std::optional<double> drift = {};        // [m or rad] of any joint, at most
  std::optional<double> residual = {};     // R_E left by any solve, at most
  std::optional<double> energy_gain = {};  // of the scene's energy scale, at most
  std::optional<double> energy_loss = {};  // likewise, at the end
  std::optional<double> stands = {};       // [s] that the scene stands, at least: TrialResult::fell_at
  List<ExpectedPlace> places = {};         // at the end; the run must have been one with them in its options

  bool is_empty() const {
    return !penetration && !drift && !residual && !energy_gain && !energy_loss && !stands && places.empty();
  }
};

/// What the scene expects of a run of its own time.
Wish wish_of(const SceneEntry& scene);

/// The options under which a trial of the scene can be held against what it expects.
TrialOptions trial_options(const SceneEntry& scene);

/// One thing that was asked, and what came out.
struct JudgedPart {
  std::string name = {};     // "penetration", "place of ball"
  std::string found = {};    // "penetration 12 mm"
  std::string asked = {};    // "at most 10 mm"
  double share = 0;          // what came out over its limit: above 1 where that is missed
  bool can_recover = false;  // it is asked of the end alone

  bool missed() const { return share > 1; }
};

/// How a run did.
struct RunJudgement {
  std::string ending = {};          // how it came to a bad end, such as "diverged after 0.3 s"; or empty
  List<std::string> failures = {};  // what no run should show, whatever is asked: see measure/failure.hpp
  List<JudgedPart> parts = {};      // what was asked

  bool fails() const { return !ending.empty() || !failures.empty(); }
  /// It does not fail, and misses nothing.
  bool meets() const { return share() <= 1; }
  /// Of a run that is not over: it can no longer meet what is asked.
  bool is_lost() const;
  /// The part that is worst off; nullptr where nothing is asked.
  const JudgedPart* worst() const;
  /// The largest share of a limit; infinite for a run that fails, 0 where nothing is asked.
  double share() const;
  /// Its bad end alone, or what it misses, the worst first, as "penetration 12 mm, at most 10 mm".
  List<std::string> missed() const;
  /// The first thing that is wrong, in few words and with the time that was simulated until then, for a run
  /// that was given up there: "penetration 12 mm after 0.5 s"; or empty.
  std::string first_missed(double seconds) const;
};

/// Holds a run against what is asked. Bodies without a name go by their number.
RunJudgement judge(const TrialResult& result, const Wish& wish, const PerBody<std::string>& names = {});

}  // namespace cairn
