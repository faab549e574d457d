// Whole runs against each other: every setting a row, whatever became of it.
#include <cairn/study/trajectory_study.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>

#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/scenes/scene_list.hpp>
#include <cairn/study/trade_row.hpp>
#include <cairn/study/work_precision.hpp>
#include <cairn/validation/case_scenes.hpp>

using namespace cairn;

namespace {

CsvTable rows_of(const List<TrajectoryScene>& scenes, const SettingGrid& grid) {
  const Study study = trajectory_study(scenes, grid);
  CsvTable table{.header = study.header, .rows = {}};
  for (const StudyTask& task : study.tasks) table.rows.push_back(task.run());
  return table;
}

SettingGrid one_setting(const std::string& solver) {
  return {.solvers = {solver}, .frequencies = {60}, .substeps = {1}, .sweeps = {8}};
}

/// Always wrong by the same.
class SameError final : public MotionError {
 public:
  explicit SameError(double error) : error_(error) {}
  void see(const Snapshot&) override {}
  double value() const override { return error_; }

 private:
  double error_;
};

/// A disc with this speed and nothing that acts on it.
TrajectoryScene free_disc(double speed, double error) {
  return {.name = "disc",
          .make =
              [speed] {
                SceneSettings settings;
                settings.gravity = {0, 0};
                Scene scene(settings);
                scene.add({.shapes = {circle(0.5)}, .velocity = {speed, 0}, .mass = 2});
                return scene;
              },
          .seconds = 0.5,
          .error_name = "error",
          .error_formula = "made up",
          .watch = [error] { return std::make_unique<SameError>(error); }};
}

}  // namespace

TEST_CASE("every scene of the study can be made, and its names are told apart") {
  std::set<std::string> names;
  for (const std::string& name : trajectory_names()) {
    CAPTURE(name);
    CHECK(names.insert(name).second);
    const TrajectoryScene scene = trajectory_scene(name);
    CHECK(scene.name == name);
    CHECK(scene.seconds > 0);
    CHECK(scene.make().bodies().size() > 0);
    CHECK((scene.starts > 1) == (scene.stand_distance > 0));
    CHECK(scene.error_name.empty() == !scene.watch);
  }
  CHECK_THROWS_WITH_AS(trajectory_scene("pendulum-46"), doctest::Contains("pendulum-45"),
                       std::invalid_argument);
}

TEST_CASE("a study of runs does not count bodies that were removed from its scene") {
  TrajectoryScene scene = free_disc(1, 0);
  scene.make = [make = scene.make] {
    Scene made = make();
    made.remove(made.add({.shapes = {circle(1)}, .position = {5, 0}}));
    return made;
  };
  const CsvTable table = rows_of({scene, free_disc(1, 0)}, one_setting("si"));
  CHECK(number_in(table, 0, "bodies") == 2);  // the ground and the disc
  CHECK(number_in(table, 1, "bodies") == 2);
}

TEST_CASE("a study of runs has a row for every point of its grid, of the right steps and sweeps") {
  const SettingGrid grid{
      .solvers = {"si", "block"}, .frequencies = {30, 60}, .substeps = {1, 4}, .sweeps = {1, 8}};
  const CsvTable table = rows_of({free_disc(1, 0.25)}, grid);
  REQUIRE(table.rows.size() == 16);
  std::set<std::string> settings;
  for (int i = 0; i < table.rows.size(); ++i) {
    CHECK(settings.insert(text_in(table, i, "setting")).second);
    CHECK(number_in(table, i, "level") == 2);
    CHECK(number_in(table, i, "err_value") == 0.25);
    CHECK(number_in(table, i, "dE_max_gain") == 0);  // nothing acts on it
    CHECK(number_in(table, i, "starts") == 1);
    CHECK(text_in(table, i, "status") == "ok");
    CHECK(text_in(table, i, "survival").empty());
    CHECK(std::isnan(number_in(table, i, "survival")));  // nothing was said about standing
  }
  CHECK(number_in(table, 0, "dt") == 1.0 / 30);
  CHECK(number_in(table, 15, "dt") == 1.0 / 60);
  CHECK(number_in(table, 15, "substeps") == 4);
  CHECK(number_in(table, 15, "sweeps") == 8);
}

TEST_CASE("the work of a run is counted: rows times sweeps, for every substep of a second") {
  // A pin has two rows, which are solved twice: 2 x 2 x 8 x 60 x 4 row updates for each second of the
  // pendulum.
  TrajectoryScene scene = trajectory_scene("pendulum-45");
  scene.seconds = 1;
  SettingGrid grid = one_setting("si");
  grid.substeps = {4};
  const CsvTable table = rows_of({scene}, grid);
  CHECK(number_in(table, 0, "work") == doctest::Approx(2 * 2 * 8 * 60 * 4).epsilon(1e-12));
  CHECK(number_in(table, 0, "row_updates") == 2 * 2 * 8 * 60 * 4);
  CHECK(number_in(table, 0, "cost") > 0);
}

TEST_CASE("runs that fail stay in the table, with an error that is infinite") {
  // On three pins above each other plain Jacobi doubles every error in a sweep: 1/6 m/s becomes 43 m/s in one
  // step of eight, and ends a trial in the next.
  TrajectoryScene pinned = free_disc(0, 0.25);
  pinned.make = [] {
    Scene scene;
    const BodyId disc = scene.add({.shapes = {circle(1)}});
    for (const double y : {-0.5, 0.0, 0.5}) scene.join<RevoluteJoint>({.b = disc, .anchor = {0, y}});
    return scene;
  };
  const CsvTable fast = rows_of({pinned}, one_setting("jacobi"));
  CHECK(text_in(fast, 0, "status") == "diverged");
  CHECK(number_in(fast, 0, "err_value") == std::numeric_limits<double>::infinity());
  const CsvTable lost = rows_of({free_disc(1, std::nan(""))}, one_setting("si"));
  CHECK(number_in(lost, 0, "err_value") == std::numeric_limits<double>::infinity());
}

TEST_CASE("a scene that stands is started again and again, and the share that stood is told") {
  TrajectoryScene stack = trajectory_scene("stack");
  stack.seconds = 0.2;
  stack.starts = 3;
  stack.stand_distance = 0.22;
  const CsvTable table = rows_of({stack}, one_setting("si"));
  CHECK(number_in(table, 0, "starts") == 3);
  CHECK(number_in(table, 0, "survival") == 1);  // free fall would be g t (t + dt) / 2 = 0.217 m
  CHECK(number_in(table, 0, "stands_until") == doctest::Approx(0.2).epsilon(1e-12));
  stack.stand_distance = 1e-9;  // even settling is more
  const CsvTable fallen = rows_of({stack}, one_setting("si"));
  CHECK(number_in(fallen, 0, "survival") == 0);
  CHECK(text_in(fallen, 0, "status") == "fell");
  CHECK(number_in(fallen, 0, "starts") == 3);  // that three fall is what there is to say
  CHECK(number_in(fallen, 0, "failed") == 1);
}

TEST_CASE("starts that come to the same places are not repeated beyond three, and others are") {
  // What is jittered by 1e-6 m and then flies without forces ends as far from its own start: all agree.
  TrajectoryScene disc = free_disc(0.1, 0);
  disc.starts = 16;
  disc.stand_distance = 1;
  CHECK(number_in(rows_of({disc}, one_setting("si")), 0, "starts") == 3);
  // A disc a millimetre above the ground falls as far as it was jittered: by up to 1e-6 m more or less, which
  // is far more than a hundredth of 1e-5 m.
  disc.make = [] {
    Scene scene;
    scene.add_ground({.half_width = 2});
    scene.add({.shapes = {circle(0.5)}, .position = {0, 0.501}});
    return scene;
  };
  disc.stand_distance = 1e-5;
  const CsvTable table = rows_of({disc}, one_setting("si"));
  CHECK(number_in(table, 0, "starts") == 16);
  CHECK(number_in(table, 0, "survival") == 1);
}

TEST_CASE("a setting with more work than real time allows is given up, and says so") {
  // A tower of 100 boxes has 400 rows: solved twice, 2 x 400 x 64 x 960 x 16 are 8e8 updates a second.
  TrajectoryScene tower = free_disc(0, 0);
  tower.watch = nullptr;
  tower.make = [] { return cases::box_column(List<double>(100, 1.0)); };
  tower.seconds = 0.05;
  SettingGrid grid = one_setting("si");
  grid.frequencies = {960};
  grid.substeps = {16};
  grid.sweeps = {64};
  const CsvTable table = rows_of({tower}, grid);
  CHECK(text_in(table, 0, "status") == "timeout");
  CHECK(number_in(table, 0, "work") > most_trajectory_work);
  CHECK(number_in(table, 0, "work") == doctest::Approx(2 * 400.0 * 64 * 960 * 16).epsilon(0.01));
}

TEST_CASE("a row says what it takes to have it again") {
  const CsvTable table = rows_of({trajectory_scene("bounce")}, one_setting("si"));
  for (const char* name : {"schema", "version", "git", "box2d", "compiler", "flags", "cpu", "scene_hash",
                           "stabilizer", "friction_model", "err_ref", "ref_kind"}) {
    CAPTURE(name);
    CHECK_FALSE(text_in(table, 0, name).empty());
  }
  CHECK(text_in(table, 0, "scene_hash") !=
        text_in(rows_of({trajectory_scene("stopping")}, one_setting("si")), 0, "scene_hash"));
}

TEST_CASE("two studies of runs give the same answers, but for their times") {
  const TrajectoryScene scene = trajectory_scene("bounce");
  const CsvTable first = rows_of({scene}, one_setting("si")), second = rows_of({scene}, one_setting("si"));
  const std::set<std::string> times = {"cost", "step_ns_med", "step_ns_max", "setup_ns", "frame_ms"};
  for (int i = 0; i < first.header.size(); ++i) {
    CAPTURE(first.header[i]);
    if (times.count(first.header[i]) == 0) CHECK(first.rows[0][i] == second.rows[0][i]);
  }
}

TEST_CASE("the name of a study of runs tells every grid and every number of starts from every other") {
  const TrajectoryScene stack = trajectory_scene("stack");
  const std::string usual = trajectory_study({stack}, one_setting("si")).name;
  List<SettingGrid> others(5, one_setting("si"));
  others[0].solvers = {"block"};
  others[1].frequencies = {120};
  others[2].substeps = {2};
  others[3].sweeps = {16};
  others[4].base.contact_search = ContactSearch::when_moved;
  for (const SettingGrid& other : others) CHECK(trajectory_study({stack}, other).name != usual);
  TrajectoryScene twice = stack;
  twice.starts = 2;
  CHECK(trajectory_study({twice}, one_setting("si")).name != usual);
}

#ifdef CAIRN_HAVE_BOX2D
TEST_CASE("a scene that Box2D refuses stays in the table as refused") {
  const CsvTable table = rows_of({trajectory_scene("differential")}, one_setting("box2d"));
  REQUIRE(table.rows.size() == 1);
  CHECK(text_in(table, 0, "status") == "refused");
  CHECK(text_in(table, 0, "solver") == "box2d");
  CHECK(std::isnan(number_in(table, 0, "cost")));
}

TEST_CASE("a run of Box2D is a row as any other, in float") {
  const CsvTable table = rows_of({trajectory_scene("stopping")}, one_setting("box2d"));
  CHECK(text_in(table, 0, "status") == "ok");
  CHECK(text_in(table, 0, "scalar") == "float");
  CHECK(number_in(table, 0, "err_value") <= 0.02);  // twice mu g dt / v = 1 % of a step's way
}
#endif

TEST_CASE("more sweeps are more accuracy: in a bridge, a chain, a pyramid and a net") {
  const SettingGrid grid{.solvers = {"si"}, .frequencies = {60}, .substeps = {4}, .sweeps = {1, 4, 16, 64}};
  for (const std::string name :
       {"bridge", "chain", "pyramid", CAIRN_SOURCE_DIR "/tests/study/cases/net.toml"}) {
    CAPTURE(name);
    TrajectoryScene scene = trajectory_scene(name);
    scene.seconds = 2;
    scene.starts = 1;
    scene.beside_exact = false;
    const CsvTable table = rows_of({scene}, grid);
    for (int i = 0; i < table.rows.size(); ++i) {
      CHECK(text_in(table, i, "status") == "ok");
      // A twentieth more: what the steps leave stays.
      if (i > 0) CHECK(number_in(table, i, "of_body") <= 1.05 * number_in(table, i - 1, "of_body"));
    }
    CHECK(number_in(table, 3, "of_body") < 0.1 * number_in(table, 0, "of_body"));
  }
}

TEST_CASE("a run that fails is no point, whether a formula knows it or not, and all starts are counted") {
  TrajectoryScene fallen = free_disc(0, 0.25);
  fallen.make = [] {
    Scene scene;
    scene.add_ground({.half_width = 1});
    scene.add({.shapes = {circle(0.5)}, .position = {0.6, 0.5}, .velocity = {3, 0}});
    return scene;
  };
  fallen.seconds = 3;
  fallen.starts = 16;
  const CsvTable table = rows_of({fallen}, one_setting("si"));
  CHECK(text_in(table, 0, "status") == "fails");  // it has rolled off the ground
  CHECK(number_in(table, 0, "failed") == 1);
  CHECK(number_in(table, 0, "starts") == 3);
  CHECK(trade_points(table, "work", "err_value", 0).empty());
}

TEST_CASE("the worst share of what is asked stands in the table, with the name of the part that it is of") {
  TrajectoryScene disc = free_disc(0.5, 0);
  disc.watch = nullptr;
  disc.wish = {
      .penetration = 0.25, .energy_gain = 0.5, .places = {{.body = {1}, .position = {0, 0}, .within = 1}}};
  const CsvTable table = rows_of({disc}, one_setting("si"));
  CHECK(text_in(table, 0, "asked_most") == "place of body 1");
  CHECK(number_in(table, 0, "asked") == doctest::Approx(0.25).epsilon(1e-9));  // 0.5 s at 0.5 m/s
}
