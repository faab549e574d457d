// The quick part of the extremes: everything holds, degrades within bounds or is refused, as it must.
#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <string>

#include <cairn/study/extremes/extreme.hpp>
#include <cairn/study/extremes/extreme_axes.hpp>
#include <cairn/math/list.hpp>
#include "scratch_folder.hpp"
#include <cairn/study/trade_row.hpp>
#include <cairn/validation/case_scenes.hpp>

using namespace cairn;

namespace {

std::string extreme_name(const ExtremeCase& extreme) {
  return extreme.axis + ": " + extreme.value + ", " + setting_text(extreme.setting);
}

/// Judged by the clock: for the program, on a machine that does nothing else.
bool takes_time(const ExtremeCase& extreme) { return extreme.axis == "denormals"; }

}  // namespace

TEST_CASE("at every extreme the quick settings hold, degrade within bounds or refuse, as they must") {
  int cases = 0;
  for (const ExtremeAxis& axis : extreme_axes()) {
    for (const ExtremeCase& extreme : axis.make()) {
      if (!extreme.quick || takes_time(extreme)) continue;
      ++cases;
      const ExtremeFinding found = find_out(extreme);
      CHECK_FALSE(found.quantity.empty());
      CHECK_MESSAGE(meets(extreme.required, found.verdict), extreme_name(extreme), ": ",
                    verdict_text(found.verdict), ", ", found.quantity, " ", found.value, " ", found.note);
    }
  }
  CHECK(cases > 500);
}

TEST_CASE(
    "every axis has a name of its own, cases for all of its values, and two settings or none that differ") {
  std::set<std::string> names;
  for (const ExtremeAxis& axis : extreme_axes()) {
    CHECK(names.insert(axis.name).second);
    CHECK_FALSE(axis.title.empty());
    CHECK_FALSE(axis.settings.empty());
    std::set<std::string> cases;
    bool quick = false;
    for (const ExtremeCase& extreme : axis.make()) {
      CHECK(extreme.axis == axis.name);
      CHECK(extreme.required != ExtremeVerdict::fail);
      CHECK_MESSAGE(cases.insert(extreme_name(extreme)).second, extreme_name(extreme), " is there twice");
      quick = quick || extreme.quick;
    }
    CHECK(quick);
  }
}

TEST_CASE("what must be bounded may be right, and nothing else may be what it was not asked to be") {
  using Verdict = ExtremeVerdict;
  CHECK(meets(Verdict::bound, Verdict::ok));
  CHECK(meets(Verdict::bound, Verdict::bound));
  CHECK_FALSE(meets(Verdict::ok, Verdict::bound));
  CHECK_FALSE(meets(Verdict::refuse, Verdict::ok));
  for (const Verdict required : {Verdict::ok, Verdict::bound, Verdict::refuse})
    CHECK_FALSE(meets(required, Verdict::fail));
}

TEST_CASE("R_E tells why a run failed once what it leaves in every substep moves a body by half its size") {
  Scene scene = cases::box_column({1, 99});
  const Setting setting = setting_of("si", 10, StabilizationPolicy::relaxed, 4);
  const ExtremeRun run{.seconds = 3};
  const double asked = 10.0 / 240, fastest = asked * std::sqrt(100.0);
  const double told = telling_residual(scene, setting, run);
  CHECK(told == doctest::Approx(0.5 / (0.5 + fastest * 3)));
  double left = 0, way = 0;  // [m/s, m] of the light box, where each solve leaves that share
  for (int substep = 0; substep < 720; ++substep) {
    left = told * (fastest + left);
    way += left / 240;
  }
  CHECK(way == doctest::Approx(0.5).epsilon(0.01));
  scene.set_settings({.gravity = {0, 0}});
  CHECK(telling_residual(scene, setting, run) == 1);
}

TEST_CASE("a refusal that names no rule, an error of another kind and a NaN are failures") {
  const auto verdict_of = [](const std::function<ExtremeFinding(const Setting&)>& run) {
    return find_out({.axis = "a", .value = "b", .setting = {}, .run = run}).verdict;
  };
  CHECK(verdict_of([](const Setting&) -> ExtremeFinding { throw std::invalid_argument("no"); }) ==
        ExtremeVerdict::fail);
  CHECK(verdict_of([](const Setting&) -> ExtremeFinding {
          throw std::invalid_argument("a: b must be > 0 m, got -1");
        }) == ExtremeVerdict::refuse);
  CHECK(verdict_of([](const Setting&) -> ExtremeFinding { throw std::runtime_error("a must be b"); }) ==
        ExtremeVerdict::fail);
  CHECK(verdict_of([](const Setting&) {
          return ExtremeFinding{.verdict = ExtremeVerdict::ok, .quantity = "q", .value = std::nan("")};
        }) == ExtremeVerdict::fail);
}

TEST_CASE("rows come back from the journal as they were found, and from JSON's text no row is lost") {
  const Study study = extreme_study({.part = ExtremePart::quick, .axes = {"mass", "restitution"}});
  const testing::ScratchFolder folder;
  Journal journal(folder / "journal.csv", study);
  REQUIRE(run_study(study, {}, journal, [](int, int, double) { return true; }));
  const CsvTable rows = extreme_table(journal.csv());
  REQUIRE(rows.rows.size() == study.tasks.size());
  for (int i = 0; i < rows.rows.size(); ++i)
    CHECK_MESSAGE(number_in(rows, i, "meets") == 1, text_in(rows, i, "axis"), " ", text_in(rows, i, "note"));
  CHECK(text_in(rows, 0, "axis") == "restitution");
  CHECK(shown_in(rows, 0, "value") == "0");
  CHECK(text_in(rows, 0, "solver") == "si x10");
  CHECK(text_in(rows, 0, "policy") == "relaxed");
  CHECK(text_in(rows, 0, "verdict") == "OK");
  const std::string json = extreme_json(rows);
  int objects = 0;
  for (std::size_t at = 0; (at = json.find("\"axis\"", at)) != std::string::npos; ++at) ++objects;
  CHECK(objects == rows.rows.size());
  CHECK(json.find("\"build\"") != std::string::npos);
  CHECK_THROWS_AS(extreme_study({.axes = {"nothing"}}), std::invalid_argument);
}
