// Quantities over time by name, held against motions with formulas.
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const TrackNames ball_names = {.bodies = {"ground", "ball", "bob"}, .joints = {{"rod", {0}}}};

/// A ball of 2 kg on the ground, and 3 kg that hang from a rod.
Scene resting_scene() {
  Scene scene({.substeps = 4});
  scene.add_ground();
  scene.add({.shapes = {circle(0.5)}, .position = {0, 0.5}, .mass = 2});
  const BodyId bob = scene.add({.shapes = {circle(0.25)}, .position = {8, 3}, .mass = 3});
  scene.join<DistanceJoint>({.a = ground, .b = bob, .anchor_a = {8, 5}, .anchor_b = {8, 3}});
  return scene;
}

void follow(const Scene& scene, int steps, TrackRecorder& recorder) {
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = 50});
  StepImpulses impulses;
  recorder.add(snapshot(world));
  for (int step = 0; step < steps; ++step) {
    world.step(solver, impulses);
    recorder.add(impulses.in(snapshot(world)));
  }
}

double last(const TrackRecorder& recorder, const std::string& name) {
  for (const Track& track : recorder.tracks()) {
    if (track.name == name) return track.values.back();
  }
  FAIL("no track ", name);
  return 0;
}

std::string refusal(const std::string& pattern) {
  try {
    TrackRecorder recorder({pattern}, ball_names);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("forces of what rests are its weight, and energies those of formulas") {
  TrackRecorder recorder({"ground:ball.normal", "ball:ground.fy", "rod.force", "rod.fy", "bob.vy",
                          "potential", "kinetic", "spring", "energy", "py"},
                         ball_names);
  follow(resting_scene(), 30, recorder);
  CHECK(last(recorder, "ground:ball.normal") == doctest::Approx(20).epsilon(1e-9));
  CHECK(last(recorder, "ball:ground.fy") == doctest::Approx(-20).epsilon(1e-9));
  CHECK(last(recorder, "rod.force") == doctest::Approx(30).epsilon(1e-9));
  CHECK(last(recorder, "rod.fy") == doctest::Approx(30).epsilon(1e-9));
  CHECK(std::abs(last(recorder, "bob.vy")) <= 1e-12);
  CHECK(last(recorder, "potential") == doctest::Approx(2 * 10 * 0.5 + 3 * 10 * 3).epsilon(1e-9));
  CHECK(last(recorder, "kinetic") <= 1e-20);
  CHECK(last(recorder, "spring") == 0);
  CHECK(last(recorder, "energy") == doctest::Approx(100).epsilon(1e-9));
  CHECK(std::abs(last(recorder, "py")) <= 1e-9);
}

TEST_CASE("a ball in flight has the speeds and the energy of its steps") {
  Scene scene;
  scene.add({.shapes = {circle(0.5)}, .velocity = {3, 4}, .angular_velocity = 2, .mass = 2});
  TrackRecorder recorder({"ball.*"}, {.bodies = {"ground", "ball"}});
  follow(scene, 60, recorder);
  CHECK(recorder.tracks().size() == 8);
  CHECK(last(recorder, "ball.vx") == 3);
  CHECK(last(recorder, "ball.vy") == doctest::Approx(4 - 10).epsilon(1e-12));
  CHECK(last(recorder, "ball.speed") == doctest::Approx(std::hypot(3, 6)).epsilon(1e-12));
  CHECK(last(recorder, "ball.x") == doctest::Approx(3).epsilon(1e-12));
  // Semi-implicit Euler: 4 t - g t (t + dt) / 2.
  CHECK(last(recorder, "ball.y") == doctest::Approx(4 - 5 * (1 + 1 / 60.0)).epsilon(1e-12));
  CHECK(last(recorder, "ball.angle") == doctest::Approx(2).epsilon(1e-12));
  CHECK(last(recorder, "ball.kinetic") ==
        doctest::Approx(0.5 * 2 * 45 + 0.5 * (2 * 0.25 / 2) * 4).epsilon(1e-12));
}

TEST_CASE("contacts that a star stands for come once they are met, and gave nothing before") {
  Scene scene;
  scene.add_ground();
  scene.add({.shapes = {circle(0.5)}, .position = {0, 0.6}, .mass = 2});
  TrackRecorder recorder({"*:ground.normal", "ball.y"}, {.bodies = {"ground", "ball"}});
  follow(scene, 60, recorder);
  REQUIRE(recorder.tracks().size() == 2);
  CHECK(recorder.tracks()[0].name == "ball.y");
  CHECK(recorder.tracks()[1].name == "ball:ground.normal");
  CHECK(recorder.tracks()[1].values.size() == recorder.times().size());
  CHECK(recorder.tracks()[1].values[1] == 0);
  CHECK(recorder.tracks()[1].values.back() == doctest::Approx(20).epsilon(1e-9));
}

TEST_CASE(
    "a table has the units in its header, every so many rows and the last, and nothing of what is gone") {
  Scene scene;
  scene.add({.shapes = {circle(0.5)}, .velocity = {3, 0}, .mass = 2});
  const BodyId other = scene.add({.shapes = {circle(0.5)}, .position = {9, 0}, .mass = 2});
  scene.add({.time = 0.05, .action = RemoveBody{other}});
  TrackRecorder recorder({"ball.vx", "bob.omega", "contacts"}, {.bodies = {"ground", "ball", "bob"}});
  follow(scene, 10, recorder);
  const CsvTable table = recorder.table(4);
  CHECK(table.header == List<std::string>{"step", "time_s", "ball.vx_m_s", "bob.omega_rad_s", "contacts"});
  REQUIRE(table.rows.size() == 4);  // 0, 4, 8, 10
  CHECK(std::get<long long>(table.rows[3][0]) == 10);
  CHECK(std::get<double>(table.rows[1][2]) == 3);
  CHECK(std::get<std::string>(table.rows[3][3]).empty());
}

TEST_CASE("a track of what is not there is refused, with what it may be") {
  CHECK(refusal("bal.y") == "TrackRecorder: track must be a known quantity (ball.y?), got bal.y");
  CHECK(refusal("rod.forse") == "TrackRecorder: track must be a known quantity (rod.force?), got rod.forse");
  CHECK(refusal("enrgy") == "TrackRecorder: track must be a known quantity (energy?), got enrgy");
  for (const char* const pattern : {"", ".", "ground.y", "ball:ball.force", "ball:nobody.force",
                                    "a*:b*.normal", "ball:*.speed", "rod:ball.force", "*.mass"}) {
    CAPTURE(pattern);
    CHECK(refusal(pattern).find("track must be") != std::string::npos);
  }
}

TEST_CASE("sensors say how many bodies touch them, and counters how often events counted") {
  Scene scene;
  scene.add_ground();
  const BodyId ball = scene.add({.shapes = {circle(0.5)}, .position = {0, 3.5}});
  scene.add({.shapes = {circle(0.25)}, .position = {3, 0.25}});
  const BodyId sensor =
      scene.add({.type = BodyType::static_body, .shapes = {box(9, 2)}, .position = {0, 1}, .sensor = true});
  scene.add({.action = CountTouches{"hits"}, .touch = TouchCondition{.a = {ball}, .b = {ground}}});
  const TrackNames names{.bodies = {"ground", "ball", "bob", "zone"},
                         .sensors = sensors_of(scene),
                         .counters = counters_of(scene)};
  CHECK(names.sensors == List<BodyId>{sensor});
  CHECK(names.counters == List<std::string>{"hits"});
  TrackRecorder recorder({"zone.touching", "hits.count"}, names);
  follow(scene, 60, recorder);
  const List<Track>& tracks = recorder.tracks();
  REQUIRE(tracks.size() == 2);
  CHECK(tracks[0].values[1] == 1);  // the bob alone
  CHECK(tracks[0].values.back() == 2);
  CHECK(tracks[1].values[1] == 0);
  CHECK(tracks[1].values.back() == 1);
  CHECK_THROWS_AS(TrackRecorder({"ball.touching"}, names), std::invalid_argument);
}
