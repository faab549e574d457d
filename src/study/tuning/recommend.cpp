// Floor 9. Trying settings, and what is kept of it.
#include <cairn/study/tuning/recommend.hpp>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include <cairn/math/check.hpp>
#include <cairn/scenes/data_folder.hpp>
#include <cairn/math/list.hpp>
#include <cairn/study/build_info.hpp>
#include <cairn/study/trade_row.hpp>

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

RecommendJson candidate_json(const RecommendCandidate& candidate) {
  RecommendJson runs = RecommendJson::array();
  for (const RecommendFinding& found : candidate.findings) runs.push_back(finding_json(found));
  return {{"setting", candidate.setting}, {"runs", runs}};
}

RecommendCandidate candidate_of(const RecommendJson& json) {
  RecommendCandidate candidate{.setting = json.at("setting"), .findings = {}};
  for (const RecommendJson& found : json.at("runs")) candidate.findings.push_back(finding_of(found));
  return candidate;
}

const List<std::string> recommend_header = {"kind", "candidate"};

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
  options.gives_up = [&](const TrialResult& result) { return escaped || judge(result, run.wish).is_lost(); };
  options.observer = [&](const Snapshot& now) { escaped = escaped || (run.escaped && run.escaped(now)); };
  const TrialResult result = run_trial(run.make(), used, options);
  return {.run = run.name,
          .missed = escaped ? "went through" : judge(result, run.wish).first_missed(result.seconds),
          .penetration = result.worst_penetration,
          .drift = result.worst_drift,
          .energy_gain = result.energy_gain,
          .stands_until = result.stands_until,
          .row_updates = result.work(),
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

Study recommend_study() {
  Study study{.name = "cairn recommendations", .header = recommend_header, .tasks = {}};
  for (const auto& [name, value] : build_entries()) {
    if (name == "cpu" || name == "cores") study.name += ", " + name + " " + value;
  }
  for (const Setting& setting : recommend_settings()) study.name += "; " + setting_text(setting);
  for (const RecommendKind& kind : recommend_kinds()) {
    for (const RecommendRun& run : kind.runs) study.name += "; " + run.name;
    for (const Setting& setting : recommend_settings()) {
      study.tasks.push_back(
          {.name = kind.name + ", " + setting_text(setting), .run = [&kind, setting]() -> List<CsvCell> {
             return {kind.name, candidate_json(try_for_kind(kind, setting)).dump()};
           }});
    }
  }
  return study;
}

List<Recommendation> recommendations_of(const std::string& csv) {
  const CsvTable table = table_of(csv, "recommendations");
  require_columns(table, recommend_header, "recommendations", "those of a renewal");
  List<Recommendation> all;
  for (int row = 0; row < table.rows.size(); ++row) {
    const std::string kind = text_in(table, row, "kind");
    if (all.empty() || all.back().kind != kind) all.push_back({.kind = kind, .candidates = {}});
    all.back().candidates.push_back(candidate_of(RecommendJson::parse(text_in(table, row, "candidate"))));
  }
  return all;
}

std::filesystem::path recommended_file() {
  std::error_code error;
  const std::filesystem::path file = data_folder() / "recommended.json";
  const std::filesystem::path resolved = std::filesystem::canonical(file, error);
  return error ? file : resolved;  // a renewal must not put a file in the place of a link
}

List<Recommendation> read_recommendations(const std::filesystem::path& path) {
  std::error_code ignored;
  const bool is_other =
      std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored);
  require(!is_other, path.string(), "recommendations", "a file", "something else");  // a FIFO would block
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error(path.string() + ": cannot be read");
  try {
    List<Recommendation> all;
    const RecommendJson file = RecommendJson::parse(in);
    for (const RecommendJson& kind : file.at("recommendations")) {
      all.push_back({.kind = kind.at("kind"), .candidates = {}});
      for (const RecommendJson& candidate : kind.at("candidates"))
        all.back().candidates.push_back(candidate_of(candidate));
    }
    return all;
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(path.string() +
                                ": recommendations must be as cairn recommend --renew writes them, got " +
                                error.what());
  }
}

std::string recommendations_json(const List<Recommendation>& all) {
  RecommendJson kinds = RecommendJson::array();
  for (const Recommendation& of_kind : all) {
    RecommendJson candidates = RecommendJson::array();
    for (const RecommendCandidate& candidate : of_kind.candidates)
      candidates.push_back(candidate_json(candidate));
    kinds.push_back({{"kind", of_kind.kind}, {"candidates", candidates}});
  }
  return RecommendJson({{"build", build_json()}, {"recommendations", kinds}}).dump(1) + "\n";
}

}  // namespace cairn
