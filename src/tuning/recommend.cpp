// Floor 11. Trying settings, and what is kept of it.
#include "tuning/recommend.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "math/check.hpp"
#include "scenes/data_folder.hpp"
#include "study/build_info.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

using RecommendJson = nlohmann::ordered_json;

constexpr double longest_trial = 60;  // [s] of processor time for one run

RecommendJson finding_json(const RecommendFinding& found) {
  return {{"run", found.run},
          {"missed", found.missed},
          {"penetration_m", found.penetration},
          {"drift", found.drift},
          {"energy_gain", found.energy_gain},
          {"stands_s", found.stands_until},
          {"row_updates_per_s", found.row_updates},
          {"cost_s_per_s", found.cost}};
}

RecommendFinding finding_of(const RecommendJson& json) {
  return {.run = json.at("run"),
          .missed = json.at("missed"),
          .penetration = json.at("penetration_m"),
          .drift = json.at("drift"),
          .energy_gain = json.at("energy_gain"),
          .stands_until = json.at("stands_s"),
          .row_updates = json.at("row_updates_per_s"),
          .cost = json.at("cost_s_per_s")};
}

/// Whether its runs are today's: all of the kind, or the first ones up to a miss.
bool is_of_today(const RecommendCandidate& candidate, const RecommendKind& kind) {
  const int runs = candidate.findings.size();
  if (runs > kind.runs.size() || (runs < kind.runs.size() && !candidate.misses())) return false;
  for (int i = 0; i < runs; ++i) {
    if (candidate.findings[i].run != kind.runs[i].name) return false;
  }
  return true;
}

const RecommendCandidate* known_candidate(const List<Recommendation>& known, const RecommendKind& kind,
                                          const std::string& setting) {
  for (const Recommendation& of_kind : known) {
    if (of_kind.kind != kind.name) continue;
    for (const RecommendCandidate& candidate : of_kind.candidates) {
      if (candidate.setting == setting && is_of_today(candidate, kind)) return &candidate;
    }
  }
  return nullptr;
}

}  // namespace

double RecommendCandidate::cost() const {
  double sum = 0;
  for (const RecommendFinding& found : findings) sum += found.cost;
  return sum;
}

List<RecommendCandidate> Recommendation::ranked() const {
  List<RecommendCandidate> all = candidates;
  erase_if(all, [](const RecommendCandidate& candidate) { return candidate.misses(); });
  std::stable_sort(all.begin(), all.end(), [](const RecommendCandidate& a, const RecommendCandidate& b) {
    return a.cost() < b.cost();
  });
  return all;
}

RecommendFinding find_recommendation(const RecommendRun& run, const Setting& setting) {
  Setting used = setting;
  used.scalar = run.scalar.value_or(setting.scalar);
  bool escaped = false;
  TrialOptions options{.seconds = run.seconds, .stand_distance = run.stand_distance};
  options.most_energy = std::numeric_limits<double>::infinity();
  options.time_limit = longest_trial;
  options.gives_up = [&](const TrialResult& result) {
    return escaped || !verdict_so_far(result, run.wish).meets;
  };
  options.observer = [&](const Snapshot& now) { escaped = escaped || (run.escaped && run.escaped(now)); };
  const TrialResult result = run_trial(run.make(), used, options);
  const double seconds = result.seconds > 0 ? result.seconds : 1;
  return {.run = run.name,
          .missed = escaped ? "went through" : verdict(result, run.wish).missed,
          .penetration = result.worst_penetration,
          .drift = result.worst_drift,
          .energy_gain = result.energy_gain,
          .stands_until = result.stands_until,
          .row_updates = static_cast<double>(result.row_updates) / seconds,
          .cost = result.cost()};
}

RecommendCandidate try_for_kind(const RecommendKind& kind, const Setting& setting) {
  RecommendCandidate candidate{.setting = setting_text(setting), .findings = {}};
  for (const RecommendRun& run : kind.runs) {
    if (candidate.misses()) break;
    candidate.findings.push_back(find_recommendation(run, setting));
  }
  return candidate;
}

bool renew_recommendations(List<Recommendation>& known,
                           const std::function<void(const List<Recommendation>&)>& keep,
                           const std::function<bool(int done, int total)>& progress) {
  const List<Recommendation> before = known;
  const int total = recommend_kinds().size() * recommend_settings().size();
  int done = 0;
  bool goes_on = true;
  known.clear();
  for (const RecommendKind& kind : recommend_kinds()) {
    known.push_back({.kind = kind.name, .candidates = {}});
    for (const Setting& setting : recommend_settings()) {
      const RecommendCandidate* found = known_candidate(before, kind, setting_text(setting));
      if (found == nullptr && !goes_on) continue;
      known.back().candidates.push_back(found != nullptr ? *found : try_for_kind(kind, setting));
      ++done;
      if (found == nullptr) {
        keep(known);
        goes_on = progress(done, total);
      }
    }
  }
  keep(known);
  return done == total;
}

std::filesystem::path recommended_file() {
  std::error_code error;
  const std::filesystem::path file = data_folder() / "recommended.json";
  const std::filesystem::path resolved = std::filesystem::canonical(file, error);
  return error ? file : resolved;  // a renewal must not put a file in the place of a link
}

namespace {

RecommendJson recommendation_file(const std::filesystem::path& path) {
  std::error_code ignored;
  const bool is_other =
      std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored);
  require(!is_other, path.string(), "recommendations", "a file", "something else");  // a FIFO would block
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error(path.string() + ": cannot be read");
  return RecommendJson::parse(in);
}

List<Recommendation> recommendations_of(const RecommendJson& file) {
  List<Recommendation> all;
  for (const RecommendJson& kind : file.at("recommendations")) {
    all.push_back({.kind = kind.at("kind"), .candidates = {}});
    for (const RecommendJson& candidate : kind.at("candidates")) {
      all.back().candidates.push_back({.setting = candidate.at("setting"), .findings = {}});
      for (const RecommendJson& found : candidate.at("runs"))
        all.back().candidates.back().findings.push_back(finding_of(found));
    }
  }
  return all;
}

[[noreturn]] void refuse_recommendations(const std::filesystem::path& path, const std::exception& error) {
  throw std::invalid_argument(path.string() +
                              ": recommendations must be as cairn recommend --renew writes them, got " +
                              error.what());
}

}  // namespace

List<Recommendation> read_recommendations(const std::filesystem::path& path) {
  try {
    return recommendations_of(recommendation_file(path));
  } catch (const nlohmann::json::exception& error) {
    refuse_recommendations(path, error);
  }
}

List<Recommendation> unfinished_recommendations(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return {};
  try {
    const RecommendJson file = recommendation_file(path);
    const RecommendJson ours = build_json(), theirs = file.at("build");
    require(theirs == ours, path.string(), "build", ours.dump(), theirs.dump());
    return recommendations_of(file);
  } catch (const nlohmann::json::exception& error) {
    refuse_recommendations(path, error);
  }
}

std::string recommendations_json(const List<Recommendation>& all) {
  RecommendJson kinds = RecommendJson::array();
  for (const Recommendation& of_kind : all) {
    RecommendJson candidates = RecommendJson::array();
    for (const RecommendCandidate& candidate : of_kind.candidates) {
      RecommendJson runs = RecommendJson::array();
      for (const RecommendFinding& found : candidate.findings) runs.push_back(finding_json(found));
      candidates.push_back({{"setting", candidate.setting}, {"runs", runs}});
    }
    kinds.push_back({{"kind", of_kind.kind}, {"candidates", candidates}});
  }
  return RecommendJson({{"build", build_json()}, {"recommendations", kinds}}).dump(1) + "\n";
}

}  // namespace cairn
