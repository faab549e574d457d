// Recommended settings: what the file says comes from runs, and is what they say today.
#include <cairn/study/tuning/recommend.hpp>

#include <doctest/doctest.h>

#include <stdexcept>

#include "scratch_folder.hpp"

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
  for (const Recommendation& of_kind : shipped()) {
    const List<RecommendRun>& runs = recommend_kind(of_kind.kind).runs;
    REQUIRE(of_kind.candidates.size() == recommend_settings().size());
    for (int k = 0; k < of_kind.candidates.size(); ++k) {
      const RecommendCandidate& candidate = of_kind.candidates[k];
      CHECK(candidate.setting == setting_text(recommend_settings()[k]));
      CHECK((candidate.findings.size() == runs.size() || candidate.misses()));
      for (int i = 0; i < candidate.findings.size(); ++i) CHECK(candidate.findings[i].run == runs[i].name);
    }
  }
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
  const testing::ScratchFolder folder;
  folder.write("wrong.json", "[{\"kind\": 3}]");
  CHECK_THROWS_AS(read_recommendations(folder / "wrong.json"), std::invalid_argument);
  CHECK_THROWS_AS(read_recommendations(folder / "none.json"), std::runtime_error);
  CHECK_THROWS_WITH_AS(recommend_kind("stak"), "recommend: kind must be a known name (stack?), got stak",
                       std::invalid_argument);
}

TEST_CASE("a renewal tries each setting for each kind, and its journal gives back what was found") {
  const Study study = recommend_study();
  REQUIRE(study.tasks.size() == recommend_kinds().size() * recommend_settings().size());
  const testing::ScratchFolder folder;
  Journal journal(folder / "journal.csv", study);
  journal.write(1, study.tasks[1].run());
  const List<Recommendation> found = recommendations_of(journal.csv());
  REQUIRE(found.size() == 1);
  REQUIRE(found[0].candidates.size() == 1);
  const RecommendCandidate &now = found[0].candidates[0], &said = shipped()[0].candidates[1];
  CHECK(now.setting == said.setting);
  REQUIRE(now.findings.size() == said.findings.size());
  for (int i = 0; i < now.findings.size(); ++i) {
    CHECK(now.findings[i].missed == said.findings[i].missed);
    CHECK(now.findings[i].row_updates == said.findings[i].row_updates);
  }
  CHECK_THROWS_AS(recommendations_of("task,a\n0,1\n"), std::invalid_argument);
}
