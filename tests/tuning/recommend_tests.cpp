// Recommended settings: what the file says comes from runs, and is what they say today.
#include "tuning/recommend.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

using namespace cairn;

namespace {

const List<Recommendation>& shipped() {
  static const List<Recommendation> all = read_recommendations(recommended_file());
  return all;
}

const Setting& tried_setting(const std::string& text) {
  for (const Setting& setting : recommend_settings()) {
    if (setting_text(setting) == text) return setting;
  }
  throw std::invalid_argument(text + " is not tried any more");
}

RecommendCandidate made_up(const std::string& setting, double cost, const std::string& missed) {
  return {.setting = setting, .findings = {{.run = "r", .missed = missed, .cost = cost}}};
}

}  // namespace

TEST_CASE("there is a recommendation for every kind, and none of its runs gains more than 1 % of energy") {
  REQUIRE(shipped().size() == recommend_kinds().size());
  for (int k = 0; k < shipped().size(); ++k) {
    const RecommendKind& kind = recommend_kinds()[k];
    CAPTURE(kind.name);
    CHECK(shipped()[k].kind == kind.name);
    REQUIRE_FALSE(shipped()[k].ranked().empty());
    const RecommendCandidate best = shipped()[k].ranked().front();
    REQUIRE(best.findings.size() == kind.runs.size());
    for (const RecommendFinding& found : best.findings) CHECK(found.energy_gain <= 0.01);
  }
}

TEST_CASE("the file knows every setting and every run of today") {
  List<Recommendation> known = shipped();
  int runs = 0;
  const bool complete = renew_recommendations(
      known, [](const List<Recommendation>&) {},
      [&runs](int, int) {
        ++runs;
        return false;
      });
  CHECK(complete);
  CHECK(runs == 0);
  CHECK(recommendations_json(known) == recommendations_json(shipped()));
}

TEST_CASE("the quick run of each kind still gives the numbers that its recommendation rests on") {
  for (const Recommendation& of_kind : shipped()) {
    const RecommendKind& kind = recommend_kind(of_kind.kind);
    REQUIRE_FALSE(of_kind.ranked().empty());
    const RecommendCandidate best = of_kind.ranked().front();
    int repeated = 0;
    for (int i = 0; i < kind.runs.size(); ++i) {
      if (!kind.runs[i].quick) continue;
      const RecommendFinding& said = best.findings[i];
      const RecommendFinding found = find_recommendation(kind.runs[i], tried_setting(best.setting));
      CAPTURE(said.run);
      // Runs are the same to the last bit, and numbers are written so that they come back.
      CHECK(found.missed == said.missed);
      CHECK(found.penetration == said.penetration);
      CHECK(found.drift == said.drift);
      CHECK(found.energy_gain == said.energy_gain);
      CHECK(found.stands_until == said.stands_until);
      CHECK(found.row_updates == said.row_updates);
      ++repeated;
    }
    CHECK(repeated == 1);
  }
}

TEST_CASE("the cheapest setting that misses nothing is recommended") {
  const Recommendation of_kind{
      .kind = "stack",
      .candidates = {made_up("dear", 3, ""), made_up("falls", 1, "stands 1 s"), made_up("cheap", 2, "")}};
  const List<RecommendCandidate> ranked = of_kind.ranked();
  REQUIRE(ranked.size() == 2);
  CHECK(ranked[0].setting == "cheap");
  CHECK(ranked[1].setting == "dear");
}

TEST_CASE("what is no file of recommendations is refused by its name, and an unknown kind by the nearest") {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "cairn_recommend_tests.json";
  std::ofstream(file) << "[{\"kind\": 3}]";
  CHECK_THROWS_AS(read_recommendations(file), std::invalid_argument);
  std::filesystem::remove(file);
  CHECK_THROWS_AS(read_recommendations(file), std::runtime_error);
  CHECK_THROWS_WITH_AS(recommend_kind("stak"), "recommend: kind must be a known name (stack?), got stak",
                       std::invalid_argument);
}

TEST_CASE("a renewal goes on from what an earlier one of this build has left, and from nothing else") {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "cairn_unfinished_tests.json";
  std::filesystem::remove(file);
  CHECK(unfinished_recommendations(file).empty());
  const List<Recommendation> known = {{.kind = "stack", .candidates = {made_up("cheap", 2, "")}}};
  const std::string whole = recommendations_json(known);
  std::ofstream(file) << whole;
  CHECK(recommendations_json(unfinished_recommendations(file)) == whole);
  std::string other = whole;
  other.replace(other.find("\"version\": \""), 12, "\"version\": \"9");
  for (const std::string& text :
       {other, whole.substr(0, whole.size() / 2), std::string("{}"), std::string()}) {
    CAPTURE(text);
    std::ofstream(file) << text;
    CHECK_THROWS_WITH_AS(unfinished_recommendations(file), doctest::Contains(file.c_str()),
                         std::invalid_argument);
  }
  std::filesystem::remove(file);
}
