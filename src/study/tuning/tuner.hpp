// Floor 9. The cheapest setting that does what a user wishes of a scene.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include <cairn/math/list.hpp>
#include <cairn/study/judgement.hpp>

namespace cairn {

/// A run of the scene under a setting. Start 0 is the scene as it is; others have been jittered. A run that
/// is not over after so many seconds of the wall clock need not go on: what came of it is not looked at.
using TunerRun = std::function<TrialResult(const Setting& setting, std::uint64_t start, double seconds_left)>;

/// A setting that was tried, and what came out: the worst and the median of its starts.
struct Candidate {
  Setting setting = {};
  int starts = 0;
  double share = 0;  // RunJudgement::share(), the worst
  std::string missed =
      {};            // the first thing that a start missed, with the time that was simulated until then
  double cost = 0;   // [s] of processor time for each second simulated, median
  double frame = 0;  // [s] TrialResult::frame(), median
  double slowest_step = 0;  // [s]
  double row_updates = 0;   // for each second simulated, median
  double worst_penetration = 0;
  double worst_drift = 0;
  double worst_residual = 0;
  double energy_gain = 0;
  double energy_loss = 0;
  double stands_until = 0;  // [s] the least
  /// It misses the wish, and so does every setting of its list that is expected to be less work.
  bool list_exhausted = false;

  bool meets() const { return share <= 1; }
};

/// The names of all that are tried unless others are named.
List<std::string> tuned_solvers();

struct TunerOptions {
  List<std::string> solvers = tuned_solvers();
  bool has_joints = false;   // of the scene: the policy Baumgarte is tried, too
  List<Setting> first = {};  // that are tried before all others, such as the scene's own
  int starts = 16;           // of each setting that is to be trusted, as far as there is time
  int runners_up = 4;        // that are to be found beside the best
  double time_limit = 60;    // [s] of the wall clock; each rival may have a sixth of it
  /// [s] The best is the one with the least share of the limits, of those whose frame() is no longer; else
  /// the cheapest that meets the wish.
  std::optional<double> budget = {};
  /// Told after every setting: how many were tried, and how many there are to try, as far as is known: fewer
  /// once the rest are too much work. Never more than that were tried. False stops the search.
  std::function<bool(int tried, int total)> progress = {};
};

struct TunerAnswer {
  std::optional<Candidate> best = {};  // from every start that there was time for
  List<Candidate> runners_up = {};     // further ones, the best first, no two alike in solver and policy
  /// The best SI at 60 Hz without substeps, all else as where nothing is said, and the best Box2D; the one
  /// with the most work where none will do, as it says.
  std::optional<Candidate> plain_si = {};
  std::optional<Candidate> box2d = {};
  std::optional<Candidate> nearest = {};  // where nothing will do: what came nearest to the wish
  int tried = 0;
  bool complete = true;  // false: the time was over before all settings were tried from every start
};

/// The settings that are tried: solvers, 1 to 256 sweeps (of newton 1 to 16 linear systems), 60 to 240 steps
/// a second, 1 to 16 substeps, policies relaxed, soft and split impulse; for joints, Baumgarte too. From the
/// least work to the most, but first a coarse choice: 60 Hz, relaxed, and sweeps and substeps by factors
/// of 4.
List<Setting> tuner_settings(const List<std::string>& solvers, bool has_joints);
/// SI at 60 steps a second with Baumgarte and no substeps, 1 to 1024 sweeps.
List<Setting> plain_si_settings();
/// Box2D 2.4.1: 4 to 64 velocity iterations, 3 or 10 for positions, 60 to 240 steps, 1 or 4 substeps.
List<Setting> box2d_settings();

/// About how much work a second of the setting is: sweeps, weighed by what they cost, with what a step costs
/// without any; of a solver that ends by itself one iteration, whatever their limit. Only orders the search;
/// what is reported is measured.
double expected_work(const Setting& setting);
/// What all of a step costs but its sweeps, in sweeps of sequential impulses.
inline constexpr double work_of_a_step = 10;

/// Tries each setting from start 0, those in `first` and the coarse ones before the others, and leaves out
/// what must be expected to cost more than twice the best, or the budget, by what other settings of its
/// solver have cost for their expected work (the least of them, where solves end by themselves); 4 times, by
/// those of all solvers, where it has none. The best are tried in single precision and with manifolds that
/// last, too, and then from the other starts; one that misses the wish from one of them is out.
/// @throws std::invalid_argument for an empty wish, and numbers that are not above 0.
TunerAnswer tune(const TunerRun& run, const Wish& wish, const TunerOptions& options = {});

/// The same for a scene that runs for so many seconds from itself, and from starts whose bodies are up to a
/// micrometre off. A run is given up once it fails or its time is over, or `stops` says so; without a budget
/// also once the wish cannot be met any more.
TunerAnswer tune(const SceneEntry& scene, double seconds, const Wish& wish, TunerOptions options,
                 const std::function<bool()>& stops);

}  // namespace cairn
