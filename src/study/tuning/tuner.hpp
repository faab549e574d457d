// Floor 9. The cheapest setting that does what a user wishes of a scene.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include <cairn/math/list.hpp>
#include <cairn/study/trial.hpp>

namespace cairn {

/// Errors that a user can name. Those that are not given are not looked at.
struct Wish {
  std::optional<double> penetration = {};  // [m] of any two shapes, at most
  std::optional<double> drift = {};        // [m or rad] of any joint, at most
  std::optional<double> residual = {};     // R_E left by any solve, at most
  std::optional<double> energy_gain = {};  // of the scene's energy scale, at most
  std::optional<double> stands = {};       // [s] as TrialResult::stands_until, at least
};

/// Whether a run did what was wished, and otherwise the first thing that it missed, with the time that was
/// simulated until then: "penetration 3.1 mm after 0.5 s".
struct Verdict {
  bool meets = true;
  std::string missed = {};
};
Verdict verdict(const TrialResult& result, const Wish& wish);
/// The same of a run that is not over: whether it can still meet the wish.
Verdict verdict_so_far(const TrialResult& result, const Wish& wish);

/// A run of the scene under a setting. Start 0 is the scene as it is; others have been jittered. A run that
/// is not over after so many seconds of the wall clock need not go on: what came of it is not looked at.
using TunerRun = std::function<TrialResult(const Setting& setting, std::uint64_t start, double seconds_left)>;

/// A setting that was tried, and what came out: the worst and the median of its starts.
struct Candidate {
  Setting setting = {};
  int starts = 0;
  Verdict verdict = {};
  double cost = 0;         // [s] of processor time for each second simulated, median
  double row_updates = 0;  // for each second simulated, median
  double worst_penetration = 0;
  double worst_drift = 0;
  double worst_residual = 0;
  double energy_gain = 0;
  double stands_until = 0;  // [s] the least
  /// It misses the wish, and so does every setting of its list that is expected to be less work.
  bool list_exhausted = false;
};

/// The names of all that are tried unless others are named.
List<std::string> tuned_solvers();

struct TunerOptions {
  List<std::string> solvers = tuned_solvers();
  bool has_joints = false;  // of the scene: the policy relaxed is tried, which without them is Baumgarte
  int starts = 16;          // of each setting that is to be trusted
  int runners_up = 4;       // that are to be found beside the best
  double time_limit = 60;   // [s] of the wall clock; the search may have two thirds, and each rival a sixth
  /// Told after every setting: how many were tried, and how many there are to try, as far as is known: fewer
  /// once the rest are too much work. Never more than that were tried. False stops the search.
  std::function<bool(int tried, int total)> progress = {};
};

struct TunerAnswer {
  std::optional<Candidate> best = {};  // the cheapest that meets the wish from every start
  List<Candidate> runners_up = {};     // further ones that do, cheapest first, no two alike in solver
                                       // and policy
  /// The cheapest SI at 60 Hz without substeps, all else as where nothing is said, and the cheapest Box2D;
  /// the one with the most work where none meets the wish, as its verdict says.
  std::optional<Candidate> plain_si = {};
  std::optional<Candidate> box2d = {};
  std::optional<Candidate> nearest = {};  // where nothing meets the wish: what came from the most work
  int tried = 0;
  bool complete = true;  // false: the time was over before all settings were tried
};

/// The settings that are tried, from the least work to the most: solvers, 1 to 256 sweeps (of newton 1 to 16
/// linear systems), 60 to 240 steps a second, 1 to 16 substeps, policies Baumgarte, soft and split impulse;
/// for joints, relaxed too.
List<Setting> tuner_settings(const List<std::string>& solvers, bool has_joints);
/// SI at 60 steps a second with Baumgarte and no substeps, 1 to 1024 sweeps.
List<Setting> plain_si_settings();
/// Box2D 2.4.1: 4 to 64 velocity iterations, 3 or 10 for positions, 60 to 240 steps, 1 or 4 substeps.
List<Setting> box2d_settings();

/// About how much work a second of the setting is: sweeps, weighed by what they cost, with what a step costs
/// without any. Only orders the search; what is reported is measured.
double expected_work(const Setting& setting);
/// What all of a step costs but its sweeps, in sweeps of sequential impulses.
inline constexpr double work_of_a_step = 10;

/// Tries settings in the order of their expected work, each from start 0 first and, if that meets the wish,
/// from all starts. The best are tried in single precision and with manifolds that last, too. Once the best
/// and its runners-up are found it goes on until the expected work is 4 times that of the cheapest found. Of
/// those that meet the wish the one with the least measured cost is the best.
/// @throws std::invalid_argument for an empty wish, and numbers that are not above 0.
TunerAnswer tune(const TunerRun& run, const Wish& wish, const TunerOptions& options = {});

/// The same for a scene that runs for so many seconds from itself, and from starts whose bodies are up to a
/// micrometre off. A run is given up once the wish cannot be met any more, its time is over, or `stops` says
/// so.
TunerAnswer tune(const SceneEntry& scene, double seconds, const Wish& wish, TunerOptions options,
                 const std::function<bool()>& stops);

}  // namespace cairn
