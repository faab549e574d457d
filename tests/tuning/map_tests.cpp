// The map of settings: what is counted, what is the cheapest, and which setting does for most scenes.
#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include <cairn/study/tuning/map_study.hpp>
#include <cairn/study/tuning/sweep_price.hpp>

using namespace cairn;

namespace {

MapRow made_run(const std::string& scene, const std::string& solver, int sweeps, double work, double error,
                const std::string& status = "ok") {
  return {.scene = scene,
          .solver = solver,
          .sweeps = sweeps,
          .policy = "relaxed",
          .scalar = "double",
          .status = status,
          .work = work,
          .error = error};
}

/// The answers of one setting in one scene.
List<CsvCell> row_of(const Setting& setting, const std::string& scene) {
  for (const MapScene& entry : map_scenes()) {
    if (entry.scene.name == scene) return map_study({entry}, {setting}).tasks.front().run();
  }
  throw std::invalid_argument(scene + " is not on the map");
}

CsvTable table_with(const List<List<CsvCell>>& rows) {
  CsvTable table{.header = {"task"}, .rows = {}};
  for (const std::string& column : map_header()) table.header.push_back(column);
  for (const List<CsvCell>& row : rows) {
    List<CsvCell> cells = {static_cast<long long>(table.rows.size())};
    cells.insert(cells.end(), row.begin(), row.end());
    table.rows.push_back(cells);
  }
  return table;
}

const MapTable two_scenes{
    .scenes = {{made_run("low", "si", 1, 100, 0.02), made_run("low", "si", 10, 400, 0.005),
                made_run("low", "newton", 1, 800, 1e-6)},
               {made_run("high", "si", 1, 100, 0.5, "fell"), made_run("high", "si", 10, 900, 0.002),
                made_run("high", "newton", 1, 300, 1e-6)}}};

}  // namespace

TEST_CASE("the map has 1472 settings, all different, and at least 100,000 runs") {
  std::set<std::string> texts;
  for (const Setting& setting : map_settings()) texts.insert(setting_text(setting));
  CHECK(texts.size() == 4 * 4 * 2 * 5 * 4 * 2 + 4 * 2 * 3 * 4 * 2);
  CHECK(map_settings().size() * map_scenes().size() >= 100'000);
}

TEST_CASE("scenes of the map have names of their own, and members of families a number") {
  std::set<std::string> names;
  for (const MapScene& entry : map_scenes()) {
    CHECK(names.insert(entry.scene.name).second);
    CHECK((entry.value > 0) == !entry.family.empty());
  }
}

TEST_CASE(
    "five boxes have two rows at each of two corners of five contacts, and SI updates each once a sweep") {
  Setting setting{.solver = "si", .dt = 1.0 / 60};
  setting.sweeps.iterations = 30;
  setting.stabilization.policy = StabilizationPolicy::baumgarte;
  const List<CsvCell> row = row_of(setting, "heavy-top 1");
  const double rows = 5 * 2 * 2 * 60;
  CHECK(std::get<std::string>(row[10]) == "1200");
  CHECK(std::get<std::string>(row[11]) == "3.6e+04");
  CHECK(rows == 1200);
  CHECK(counted_work("si", 30 * rows, rows) == 40 * rows);
  CHECK(counted_work("block", 30 * rows, rows) == doctest::Approx((1.3 * 30 + 10) * rows).epsilon(1e-15));
}

TEST_CASE("the cheapest of those that meet the goal, and none where none does") {
  CHECK(cheapest(two_scenes.scenes[0], 0.03)->setting() == "si x1, 60 Hz, relaxed, double");
  CHECK(cheapest(two_scenes.scenes[0], 0.01)->sweeps == 10);
  CHECK(cheapest(two_scenes.scenes[1], 1.0)->solver == "newton");
  CHECK(cheapest(two_scenes.scenes[1], 1e-9) == nullptr);
  const auto by_si = [](const MapRow& run) { return run.solver == "si"; };
  CHECK(cheapest(two_scenes.scenes[1], 0.01, by_si)->work == 900);
}

TEST_CASE(
    "another price of a sweep is another count of work, for its solver alone, and may have another winner") {
  MapTable table = two_scenes;
  for (List<MapRow>& runs : table.scenes) {
    for (MapRow& run : runs) {
      run.rows = 1;
      run.updates = run.solver == "newton" ? 15 : 20;
      run.work = counted_work(run.solver, run.updates, run.rows);
    }
  }
  CHECK(cheapest(table.scenes[0], 0.01)->solver == "newton");  // 15 + 10, and si 20 + 10
  const MapTable dear = priced(table, "newton", 30);
  CHECK(dear.scenes[0][2].work == 30 + 10);
  CHECK(dear.scenes[0][1].work == 20 + 10);
  CHECK(cheapest(dear.scenes[0], 0.01)->solver == "si");
}

TEST_CASE("prices are measured in sweeps of sequential impulses, which cost one") {
  const List<SweepPrice> prices = measured_prices({"si", "accelerated"});
  REQUIRE(prices.size() == 2);
  CHECK(prices[0].median == doctest::Approx(1).epsilon(0.5));  // the machine may have other work
  for (const SweepPrice& price : prices) {
    CHECK(price.least > 0);
    CHECK(price.least <= price.median);
    CHECK(price.median <= price.most);
  }
  CHECK(prices[1].median > prices[0].median);  // momentum does more in a sweep
}

TEST_CASE("one setting for both scenes: that which does for most, at the geometric mean of its multiples") {
  const MapChoice si = best_for_all(two_scenes, {0, 1}, 0.01, "si");
  CHECK(si.setting == 1);
  CHECK(si.met == 2);
  CHECK(si.multiple == doctest::Approx(std::sqrt(1.0 * 900 / 300)).epsilon(1e-15));
  const MapChoice newton = best_for_all(two_scenes, {0, 1}, 0.01, "newton");
  CHECK(newton.multiple == doctest::Approx(std::sqrt(800.0 / 400)).epsilon(1e-15));
  CHECK(best_for_all(two_scenes, {0, 1}, 0.01, "block").setting == -1);
}

TEST_CASE("a table of another kind, and one that lacks a run, are refused with their name") {
  CHECK_THROWS_WITH_AS(read_map({.header = {"a"}, .rows = {}}, "t.csv"), doctest::Contains("t.csv"),
                       std::invalid_argument);
  const auto cells = [](const std::string& scene) {
    return List<CsvCell>{
        scene, std::string(),          std::string(),         std::string("si"), 60LL,   1LL,
        10LL,  std::string("relaxed"), std::string("double"), std::string("ok"), 1200LL, 12000LL,
        0.001};
  };
  const MapTable read = read_map(table_with({cells("a"), cells("a"), cells("b"), cells("b")}), "t.csv");
  CHECK(read.scenes.size() == 2);
  CHECK(read.scenes[1][0].work == 12000 + 10 * 1200);
  CHECK_THROWS_WITH_AS(read_map(table_with({cells("a"), cells("a"), cells("b")}), "t.csv"),
                       doctest::Contains("settings of b"), std::invalid_argument);
}
