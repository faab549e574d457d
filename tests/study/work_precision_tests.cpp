// Tables of work against error: complete, with their failures; fronts and sums against brute force.
#include <cairn/study/work_precision.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <cairn/study/trade_row.hpp>
#include <cairn/validation/case_problems.hpp>

using namespace cairn;

namespace {

const double never = std::numeric_limits<double>::infinity();

/// A row as solvers leave it.
struct MadeUp {
  std::string scene = "s", solver = "si";
  long long sweeps = 1;
  double work = 1, error = 1;
  std::string status = "ok";
  double median = 100, range = 1;
};

CsvTable made_up_table(const List<MadeUp>& rows) {
  CsvTable table{.header = trade_header(), .rows = {}};
  for (const MadeUp& made : rows) {
    TradeRow row;
    row.set("scene", made.scene);
    row.set("solver", made.solver);
    row.set("setting", made.solver + " x" + std::to_string(made.sweeps));
    row.set("sweeps", made.sweeps);
    row.set("status", made.status);
    if (made.status != "refused") {
      row.set("row_updates", made.work);
      row.set("R_E_v", made.error);
    }
    if (made.median > 0) {
      row.set("solve_ns_med", made.median);
      row.set("solve_ns_iqr", made.range);
    }
    table.rows.push_back(row.cells());
  }
  return table;
}

/// What a study answers.
CsvTable answers(const Study& study) {
  CsvTable table{.header = study.header, .rows = {}};
  for (const StudyTask& task : study.tasks) table.rows.push_back(task.run());
  return table;
}

SolveGrid small_grid(const List<std::string>& solvers, int most_sweeps) {
  return {.solvers = solvers,
          .most_sweeps = most_sweeps,
          .starts = {Start::cold},
          .scalars = {Precision::double_precision},
          .timing = {.repetitions = 0, .seconds = 0}};
}

FrozenProblem frozen_rod(double friction) {
  return {.name = "rod",
          .description = "a rod",
          .tags = {},
          .problem = cases::painleve_rod<double>(-1, friction)};
}

WorkToError made_up_work(const std::string& scene, const std::string& solver, double updates) {
  return {.scene = scene, .solver = solver, .row_updates = {1, updates}, .ending = "ok"};
}

}  // namespace

TEST_CASE("a study of solvers has a task for every point of its grid, and a row for every task") {
  SolveGrid grid = small_grid({"si", "pgs"}, 8);
  grid.starts = {Start::cold, Start::warm};
  grid.scalars = {Precision::double_precision, Precision::single_precision};
  const Study study = solve_study({frozen_rod(0.5), frozen_rod(1)}, grid);
  REQUIRE(study.tasks.size() == 2 * 2 * 2 * 2 * 4);  // problems, solvers, starts, scalars; 1, 2, 4, 8 sweeps
  const CsvTable table = answers(study);
  for (int i = 0; i < table.rows.size(); ++i) {
    CHECK(number_in(table, i, "row_updates") == 2 * number_in(table, i, "sweeps"));  // two rows
    CHECK(number_in(table, i, "rows") == 2);
    CHECK(number_in(table, i, "level") == 1);
    CHECK(std::isnan(number_in(table, i, "solve_ns_med")));  // nothing was timed
  }
  CHECK(rows_with(table, {{"scalar", "float"}, {"warm", "warm"}}).rows.size() == 16);
  CHECK(rows_with(table, {{"solver", "reference"}}).rows.empty());
  CHECK(rows_with(table, {}).rows.size() == table.rows.size());
}

TEST_CASE("the name of a study tells every grid from every other") {
  const FrozenProblem rod = frozen_rod(0.5);
  const SolveGrid usual = small_grid({"si"}, 8);
  List<SolveGrid> others(6, usual);
  others[0].solvers = {"pgs"};
  others[1].most_sweeps = 16;
  others[2].starts = {Start::warm};
  others[3].scalars = {Precision::single_precision};
  others[4].timing.repetitions = 3;
  others[5].solvers = {"si", "pgs"};
  for (const SolveGrid& other : others)
    CHECK(solve_study({rod}, other).name != solve_study({rod}, usual).name);
  FrozenProblem renamed = rod;
  renamed.name = "rod2";
  CHECK(solve_study({renamed}, usual).name != solve_study({rod}, usual).name);
  CHECK_THROWS_AS(solve_study({rod}, small_grid({"guess"}, 8)), std::invalid_argument);
}

TEST_CASE("E_M is given where the true velocity is unique, and the exact solver misses it by rounding only") {
  const CsvTable table = answers(solve_study({frozen_rod(0.5)}, small_grid({"reference", "si"}, 1)));
  REQUIRE(table.rows.size() == 2);
  CHECK(text_in(table, 0, "unique_v") == "yes");
  CHECK(number_in(table, 0, "E_M") <= 1e-12);  // two rows of numbers around 1, over 0.01 m/s of falling
  CHECK(number_in(table, 1, "E_M") > 1e-3);    // one sweep: 0.75 mu = 3/8 of the error is left
}

TEST_CASE("failures stay in the table: a nan and a cycle") {
  FrozenProblem endless = frozen_rod(0.5);
  endless.name = "endless";
  endless.problem.velocity[{1}].x() = std::nan("");
  const CsvTable table = answers(solve_study({endless, frozen_rod(1.4)}, small_grid({"pgs"}, 128)));
  REQUIRE(table.rows.size() == 2 * 8);
  CHECK(rows_with(table, {{"scene", "endless"}, {"status", "nan"}}).rows.size() == 8);
  CHECK(text_in(table, 15, "status") == "cycle");
  const List<WorkToError> work = work_to_errors(table, {1e-2});
  REQUIRE(work.size() == 2);
  const std::string endings[] = {"nan", "cycle"};
  for (int i = 0; i < 2; ++i) {
    CHECK(work[i].row_updates == List<double>{never});
    CHECK(work[i].ending == endings[i]);
  }
  // The cycle is drawn where it stands; the other has nothing to draw.
  CHECK(trade_points(table, "row_updates", "R_E_v", 1e-16).size() == 8);
}

TEST_CASE("the front of made-up points is what brute force finds") {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> few(1, 12);  // so that there are ties
  for (int round = 0; round < 20; ++round) {
    List<MadeUp> rows(40);
    for (MadeUp& row : rows) {
      row.work = few(random);
      row.error = few(random);
    }
    const List<TradePoint> points = trade_points(made_up_table(rows), "row_updates", "R_E_v", 1e-16);
    REQUIRE(points.size() == rows.size());
    for (int i = 0; i < points.size(); ++i) {
      bool is_beaten = false;
      for (const MadeUp& other : rows) {
        is_beaten = is_beaten || (other.work < rows[i].work && other.error <= rows[i].error) ||
                    (other.work <= rows[i].work && other.error < rows[i].error);
      }
      CHECK(points[i].on_front != is_beaten);
    }
  }
}

TEST_CASE("points are rows that ended with numbers, and an error of 0 stands at the least that is drawn") {
  const CsvTable table = made_up_table({{.work = 1, .error = 0},
                                        {.work = 0, .error = 1},
                                        {.work = 2, .error = never},
                                        {.work = 3, .error = std::nan("")},
                                        {.work = 4, .error = 0.5, .status = "nan"},
                                        {.work = 5, .error = 0.5, .status = "diverged"},
                                        {.status = "refused"},
                                        {.work = 6, .error = 0.5, .status = "plateau"},
                                        {.work = 7, .error = 0.25, .status = "cycle"}});
  const List<TradePoint> points = trade_points(table, "row_updates", "R_E_v", 1e-16);
  REQUIRE(points.size() == 3);
  CHECK(points[0].error == 1e-16);
  CHECK(points[1].work == 6);
  CHECK(points[2].work == 7);
  CHECK(points[0].on_front);
  CHECK_FALSE(points[1].on_front);
}

TEST_CASE("rows whose times spread by more than a tenth are left out, those without a time are kept") {
  const CsvTable table = made_up_table({{.sweeps = 1, .median = 100, .range = 10},
                                        {.sweeps = 2, .median = 100, .range = 10.5},
                                        {.sweeps = 3, .median = 0},
                                        {.sweeps = 4, .median = 1e6, .range = 3e5}});
  const CsvTable steady = rows_with_steady_times(table, 0.1);
  REQUIRE(steady.rows.size() == 2);
  CHECK(number_in(steady, 0, "sweeps") == 1);
  CHECK(number_in(steady, 1, "sweeps") == 3);
}

TEST_CASE(
    "the work to come down to errors is the least of the rows that did, and the ending that of the last") {
  const CsvTable table = made_up_table(
      {{.scene = "a", .solver = "si", .sweeps = 1, .work = 10, .error = 0.5},
       {.scene = "b", .solver = "si", .sweeps = 1, .work = 7, .error = 1e-9},
       {.scene = "a", .solver = "si", .sweeps = 4, .work = 40, .error = 1e-3, .status = "plateau"},
       {.scene = "a", .solver = "si", .sweeps = 2, .work = 20, .error = 1e-2},
       {.scene = "a", .solver = "pgs", .sweeps = 1, .work = 5, .error = std::nan(""), .status = "nan"}});
  const List<WorkToError> work = work_to_errors(table, {1e-2, 1e-4});
  REQUIRE(work.size() == 3);
  CHECK(work[0].scene == "a");
  CHECK(work[0].solver == "si");
  CHECK(work[0].row_updates == List<double>{20, never});  // 1e-2 is at most 1e-2
  CHECK(work[0].ending == "plateau");                     // of four sweeps, though it is not the last row
  CHECK(work[1].row_updates == List<double>{7, 7});
  CHECK(work[1].ending == "ok");
  CHECK(work[2].row_updates == List<double>{never, never});
  CHECK(work[2].ending == "nan");
}

TEST_CASE("a profile is the share of problems within a factor of the best, ties and failures counted") {
  const List<PerformanceProfile> profiles = performance_profiles(
      {made_up_work("p", "si", 10), made_up_work("p", "pgs", 30), made_up_work("q", "si", 800),
       made_up_work("q", "pgs", 8), made_up_work("r", "si", 5), made_up_work("r", "pgs", 5),
       made_up_work("s", "si", never), made_up_work("s", "pgs", 7), made_up_work("t", "si", never),
       made_up_work("t", "pgs", never)},
      1);
  REQUIRE(profiles.size() == 2);
  CHECK(profiles[0].solver == "si");
  // si: 1, 100, 1, failed, failed; pgs: 3, 1, 1, 1, failed. Nobody solves t: no share reaches 1.
  CHECK(profiles[0].ratios == List<double>{1, 1, 100, never, never});
  CHECK(profiles[1].ratios == List<double>{1, 1, 1, 3, never});
  CHECK(profiles[0].share(0.999) == 0);
  CHECK(profiles[0].share(1) == 2.0 / 5);
  CHECK(profiles[0].share(99.9) == 2.0 / 5);
  CHECK(profiles[0].share(100) == 3.0 / 5);
  CHECK(profiles[1].share(1) == 3.0 / 5);
  CHECK(profiles[1].share(3) == 4.0 / 5);
  CHECK(profiles[1].share(never) == 4.0 / 5);
}

TEST_CASE("a solver that was not tried on a problem has failed there") {
  const List<PerformanceProfile> profiles = performance_profiles(
      {made_up_work("p", "si", 1), made_up_work("q", "si", 2), made_up_work("q", "block", 1)}, 1);
  REQUIRE(profiles.size() == 2);
  CHECK(profiles[0].ratios == List<double>{1, 2});
  CHECK(profiles[1].ratios == List<double>{1, never});
}

TEST_CASE("the error that is asked for decides, and where there is nothing there are no profiles") {
  const List<WorkToError> work = {{.scene = "p", .solver = "si", .row_updates = {4, 40}, .ending = "ok"},
                                  {.scene = "p", .solver = "pgs", .row_updates = {8, 20}, .ending = "ok"}};
  CHECK(performance_profiles(work, 0)[1].ratios == List<double>{2});
  CHECK(performance_profiles(work, 1)[1].ratios == List<double>{1});
  CHECK_THROWS_AS(performance_profiles(work, 2), std::out_of_range);
  CHECK(performance_profiles({}, 0).empty());
  CHECK(PerformanceProfile{}.share(1) == 0);
  CHECK(
      performance_profiles({{.scene = "p", .solver = "si", .row_updates = {0}, .ending = "ok"}}, 0)[0].share(
          1) == 1);
}
