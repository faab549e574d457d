// Floor 9. Which setting is recommended for which kind of scene, and the runs that speak for it.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include <cairn/math/list.hpp>
#include <cairn/study/journal.hpp>
#include <cairn/study/tuning/tuner.hpp>

namespace cairn {

/// One run that a setting must stand: a scene, for how long, and what is wished of it.
struct RecommendRun {
  std::string name = {};                                            // "100 boxes, 60 s"
  double seconds = 2;                                               // [s]
  Wish wish = {};                                                   // energy_gain is at most 1 % in every run
  double stand_distance = std::numeric_limits<double>::infinity();  // [m] as in TrialOptions
  std::optional<Precision> scalar = {};                             // in place of the setting's
  /// What must not come to be, such as a body behind a wall.
  std::function<bool(const Snapshot&)> escaped = {};
  std::function<Scene()> make = {};
  bool quick = false;  // the run that a test repeats; one of each kind
};

/// A kind of scene, by its runs, the quickest first.
struct RecommendKind {
  std::string name = {};
  std::string title = {};  // a few words
  List<RecommendRun> runs = {};
};

/// stack, chain, mechanism, granular, fast, far.
const List<RecommendKind>& recommend_kinds();
/// @throws std::invalid_argument for an unknown name, with the nearest known one.
const RecommendKind& recommend_kind(const std::string& name);

/// What is tried for every kind: sequential impulses as they are used to, with more sweeps, with substeps and
/// under each policy; contact blocks; momentum; lanes as the default has them; and Newton's method.
const List<Setting>& recommend_settings();
/// Of them: Newton's method until R_E is at most 1e-9.
Setting newton_setting(int substeps);
/// The first of them: what most engines do.
const Setting& plain_setting();

/// What a run came to.
struct RecommendFinding {
  std::string run = {};     // its name
  std::string missed = {};  // of its wish; empty: nothing
  double penetration = 0;   // [m] worst
  double drift = 0;         // [m or rad] worst
  double energy_gain = 0;   // of the scale, worst
  double stands_until = 0;  // [s]
  double row_updates = 0;   // for each second simulated
  double cost = 0;          // [s] of processor time for each second simulated; the only one that may differ
};

/// A setting, and what its runs came to: all of a kind, or those up to the first that it misses.
struct RecommendCandidate {
  std::string setting = {};  // setting_text()
  List<RecommendFinding> findings = {};

  bool misses() const { return !findings.empty() && !findings.back().missed.empty(); }
  /// [s] of processor time for a second of each run.
  double cost() const;
};

/// All that was tried for a kind.
struct Recommendation {
  std::string kind = {};
  List<RecommendCandidate> candidates = {};

  /// Those that meet every wish, the cheapest first: the first one is recommended.
  List<RecommendCandidate> ranked() const;
};

/// Runs a setting, and gives up once the wish cannot be met any more.
RecommendFinding find_recommendation(const RecommendRun& run, const Setting& setting);
/// All runs of the kind, up to the first that is missed.
RecommendCandidate try_for_kind(const RecommendKind& kind, const Setting& setting);

/// One task for each kind and setting, whose row is the candidate. On another machine it is another study, as
/// its times must not stand beside ours.
Study recommend_study();
/// From Journal::csv() of that study.
/// @throws std::invalid_argument for a table that is not of such a study.
List<Recommendation> recommendations_of(const std::string& csv);

/// Where the recommendations that come with Cairn are.
std::filesystem::path recommended_file();
/// @throws std::invalid_argument for a file that is not of this kind, std::runtime_error for one that cannot
/// be read; both name it.
List<Recommendation> read_recommendations(const std::filesystem::path& path);
/// The text of such a file, which says first what build its times come from.
std::string recommendations_json(const List<Recommendation>& all);

}  // namespace cairn
