// Scenes from TOML: every field arrives where it belongs.
#include <cairn/scenes/scene_file.hpp>

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <cairn/scenes/scene_formula.hpp>

using namespace cairn;

namespace {

namespace fs = std::filesystem;

double scene_formula_value(const std::string& text) {
  const FormulaResult result = evaluate_formula(text, {{"mu", 0.25}});
  CHECK(result.problem == "");
  return result.value;
}

const SceneBody& scene_body_at(const Scene& scene, int i) { return scene.bodies().at({i}); }

}  // namespace

TEST_CASE("a sum in quotes is computed as in school, from the left, with pi, deg and functions") {
  CHECK(scene_formula_value("1 + 2 * 3 - -4") == 11);
  CHECK(scene_formula_value("8 / 4 / 2") == 1);
  CHECK(scene_formula_value("(1 + 2) * 3") == 9);
  CHECK(scene_formula_value("30 deg") == 30 * pi / 180);
  CHECK(scene_formula_value("-0.5 rad") == -0.5);
  CHECK(scene_formula_value("2 / 3 * mu") == 2.0 / 3 * 0.25);
  CHECK(scene_formula_value("sqrt(abs(-16)) + atan(tan(0))") == 4);
  CHECK(scene_formula_value("1e-3") == 1e-3);
  for (const char* text : {"", "1 +", "(1", "1)", "two", "1 2", "sqrt 2", "1 / 0", "3 m", "0x10", "1..2"}) {
    CAPTURE(text);
    CHECK_FALSE(evaluate_formula(text, {}).problem.empty());
  }
  CHECK_FALSE(evaluate_formula(std::string(100000, '('), {}).problem.empty());
  CHECK_FALSE(evaluate_formula(std::string(100000, '-'), {}).problem.empty());
}

TEST_CASE("every field of a body can be given, and arrives") {
  const Scene scene = read_scene_text(R"([[body]]
name = "all"
box = [2, 1]
position = [1, 2]
angle = "90 deg"
velocity = [3, 4]
angular_velocity = 5
mass = 6
inertia = 7
density = 8
friction = 0.9
restitution = 0.1
linear_damping = 0.2
angular_damping = 0.3
gravity_scale = 0.4
sensor = true
category = 2
collides_with = 5
[[body]]
type = "static"
circle = 1
[[body]]
type = "kinematic"
circle = 1
fixed_rotation = true
)",
                                      "all.toml")
                          .make();
  const SceneBody& all = scene_body_at(scene, 1);
  CHECK(all.pose.position == Vec2<double>(1, 2));
  CHECK(all.pose.angle == 90 * pi / 180);
  CHECK(all.spec.velocity == Vec2<double>(3, 4));
  CHECK(all.spec.angular_velocity == 5);
  CHECK(all.mass == 6);
  CHECK(all.inertia == 7);
  CHECK(all.spec.density == 8);
  CHECK(all.spec.material.friction == 0.9);
  CHECK(all.spec.material.restitution == 0.1);
  CHECK(all.spec.damping.linear == 0.2);
  CHECK(all.spec.damping.angular == 0.3);
  CHECK(all.spec.gravity_scale == 0.4);
  CHECK(all.spec.sensor);
  CHECK_FALSE(all.spec.fixed_rotation);
  CHECK(all.spec.filter.category == 2);
  CHECK(all.spec.filter.collides_with == 5);
  CHECK(scene_body_at(scene, 2).spec.type == BodyType::static_body);
  CHECK(scene_body_at(scene, 3).spec.type == BodyType::kinematic);
  CHECK(scene_body_at(scene, 3).spec.fixed_rotation);
}

TEST_CASE("every shape can be given, alone or as one of several") {
  const Scene scene = read_scene_text(R"([[body]]
box = [2, 1]
radius = 0.1
[[body]]
capsule = [[-1, 0], [1, 0]]
radius = 0.2
[[body]]
polygon = [[0, 0], [1, 0], [0, 1]]
[[body]]
type = "static"
segment = [[0, 0], [1, 0]]
[[body]]
shapes = [{ circle = 0.5, offset = [1, 0] }, { box = [2, 1], offset = [-1, 0], turn = "90 deg" }]
)",
                                      "shapes.toml")
                          .make();
  CHECK(std::get<Polygon<double>>(scene_body_at(scene, 1).spec.shapes[0]).radius == 0.1);
  // Areas of 2 x 1 with a rim of 0.1: the box, four strips and a disc.
  CHECK(scene_body_at(scene, 1).mass == doctest::Approx(2 + 6 * 0.1 + pi * 0.01).epsilon(1e-14));
  CHECK(scene_body_at(scene, 2).mass == doctest::Approx(2 * 0.4 + pi * 0.04).epsilon(1e-14));
  CHECK(scene_body_at(scene, 3).mass == doctest::Approx(0.5).epsilon(1e-15));
  CHECK(std::holds_alternative<Segment<double>>(scene_body_at(scene, 4).spec.shapes[0]));
  CHECK(scene_body_at(scene, 5).spec.shapes.size() == 2);
  const double disc = pi / 4;  // the area; its centre is at 1, that of the box at -1
  CHECK(scene_body_at(scene, 5).pose.position.x() == doctest::Approx((disc - 2) / (disc + 2)).epsilon(1e-14));
}

TEST_CASE("what is said of the whole scene arrives") {
  const SceneEntry entry = read_scene_text(R"(title = "a title"
look = "What to see."
seconds = 4
order = 7
gravity = [1, -2]
camera = { center = [3, 4], height = 5 }
ground = { height = 0.5, half_width = 6, friction = 0.7, restitution = 0.8 }
[step]
dt = "1 / 120"
substeps = 3
contact_search = "when moved"
warm_start = false
speculative_margin = 0.03
restitution_threshold = 0.6
friction_rows = "per manifold"
[step.stabilization]
policy = "split impulse"
baumgarte = 0.3
slop = 0.004
max_speed = 9
frequency = 20
damping_ratio = 2
joint_frequency = 40
joint_damping_ratio = 3
[step.sleeping]
speed = 0.1
angular_speed = 0.2
time = 0.3
[expect]
penetration = 0.01
drift = 0.02
energy_gain = 3
energy_loss = 8
stands = 0.04
)",
                                           "some/folder/whole.toml");
  CHECK(entry.name == "whole");
  CHECK(entry.title == "a title");
  CHECK(entry.look == "What to see.");
  CHECK(entry.seconds == 4);
  CHECK(entry.order == 7);
  REQUIRE(entry.camera.has_value());
  CHECK(entry.camera->center == Vec2<double>(3, 4));
  CHECK(entry.camera->height == 5);
  const Scene scene = entry.make();
  const SceneSettings& settings = scene.settings();
  CHECK(settings.gravity == Vec2<double>(1, -2));
  CHECK(settings.dt == 1.0 / 120);
  CHECK(settings.substeps == 3);
  CHECK(settings.contact_search == ContactSearch::when_moved);
  CHECK_FALSE(settings.warm_start);
  CHECK(settings.speculative_margin == 0.03);
  CHECK(settings.restitution_threshold == 0.6);
  CHECK(settings.friction_rows == FrictionRows::per_manifold);
  CHECK(settings.stabilization.policy == StabilizationPolicy::split_impulse);
  CHECK(settings.stabilization.baumgarte == 0.3);
  CHECK(settings.stabilization.slop == 0.004);
  CHECK(settings.stabilization.max_speed == 9);
  CHECK(settings.stabilization.soft.frequency == 20);
  CHECK(settings.stabilization.soft.damping_ratio == 2);
  CHECK(settings.stabilization.joint_soft.frequency == 40);
  CHECK(settings.stabilization.joint_soft.damping_ratio == 3);
  REQUIRE(settings.sleeping.has_value());
  CHECK(settings.sleeping->speed == 0.1);
  CHECK(settings.sleeping->angular_speed == 0.2);
  CHECK(settings.sleeping->time == 0.3);
  CHECK(scene_body_at(scene, 0).spec.material.friction == 0.7);
  CHECK(scene_body_at(scene, 0).spec.material.restitution == 0.8);
  CHECK(entry.expectations.penetration == 0.01);
  CHECK(entry.expectations.drift == 0.02);
  CHECK(entry.expectations.energy_gain == 3);
  CHECK(entry.expectations.energy_loss == 8);
  CHECK(entry.expectations.stands == 0.04);
  // What is recommended is as the scene steps, unless it says otherwise.
  CHECK(setting_text(entry.setting) ==
        "newton x20, 120 Hz x3, contacts when moved, split impulse 0.3 slop 0.004 m at most 9 m/s, double, "
        "cold");
}

TEST_CASE("a scene file takes its words with blanks, hyphens or underscores, and lists one spelling") {
  const auto scene_with = [](const std::string& blank) {
    return read_scene_text("step = { friction_rows = \"per" + blank + "manifold\", contact_search = \"when" +
                               blank + "moved\", stabilization = { policy = \"split" + blank +
                               "impulse\" } }\n[recommended]\nsolver = \"wide" + blank + "accelerated\"\n",
                           "words.toml");
  };
  for (const char* blank : {" ", "-", "_"}) {
    CAPTURE(blank);
    const SceneEntry entry = scene_with(blank);
    CHECK(setting_text(entry.setting) ==
          "wide-accelerated x10, 60 Hz x4, contacts when moved, split impulse, double");
    CHECK(entry.make().settings().friction_rows == FrictionRows::per_manifold);
  }
  CHECK_THROWS_WITH_AS(read_scene_text("[recommended]\nsolver = \"wideaccelerated\"\n", "words.toml"),
                       "words.toml:2:10: recommended.solver must be the name of a solver "
                       "(wide-accelerated?), got \"wideaccelerated\"",
                       std::invalid_argument);
}

TEST_CASE("a world of any number type but float and double is refused, with both") {
  CHECK_THROWS_WITH_AS(
      read_scene_text("[recommended]\nscalar = \"long double\"\n", "words.toml"),
      "words.toml:2:10: recommended.scalar must be one of float, double, got \"long double\"",
      std::invalid_argument);
}

TEST_CASE("every field of what is recommended arrives") {
  const Setting setting = read_scene_text(R"(view = "top"
[recommended]
solver = "pgs"
iterations = 20
tolerance = 1e-6
time_budget = 0.5
row_order = "shuffled"
seed = 3
relaxation = 1.2
patience = 4
scalar = "float"
dt = 0.01
substeps = 2
contact_search = "every step"
warm_start = false
position_iterations = 5
stabilization = { policy = "soft", frequency = 60 }
)",
                                          "recommended.toml")
                              .setting;
  CHECK(setting_text(setting) ==
        "pgs x20 to 1e-06 omega 1.2 patience 4 within 0.5 s shuffled 3, 100 Hz x2, contacts every "
        "step, "
        "soft 60 Hz, float, cold");
  CHECK(setting.position_iterations == 5);
}

TEST_CASE("a file is read by its path, and a folder by the order that its scenes ask for") {
  const fs::path folder = fs::temp_directory_path() / "cairn_scene_file_tests";
  fs::remove_all(folder);
  fs::create_directories(folder);
  CHECK_THROWS_AS(read_scene_folder(folder.string()), std::invalid_argument);
  std::ofstream(folder / "b.toml") << "order = 2\n";
  std::ofstream(folder / "a.toml") << "order = 2\n";
  std::ofstream(folder / "z.toml") << "order = 1\n";
  std::ofstream(folder / "notes.txt") << "no scene\n";
  const List<SceneEntry> entries = read_scene_folder(folder.string());
  REQUIRE(entries.size() == 3);
  CHECK(entries[0].name + entries[1].name + entries[2].name == "zab");
  CHECK(scene_entry((folder / "z.toml").string()).name == "z");
  CHECK_THROWS_AS(read_scene_file((folder / "none.toml").string()), std::invalid_argument);
  CHECK_THROWS_AS(read_scene_file(folder.string()), std::invalid_argument);
  REQUIRE(mkfifo((folder / "pipe.toml").c_str(), 0600) == 0);
  CHECK_THROWS_AS(read_scene_file((folder / "pipe.toml").string()), std::invalid_argument);
  std::ofstream(folder / "large.toml") << "#" << std::string(3000000, 'x');
  CHECK_THROWS_WITH_AS(
      read_scene_file((folder / "large.toml").string()),
      ((folder / "large.toml").string() + ":1:1: the file must be at most 1000000 bytes, got 3000001")
          .c_str(),
      std::invalid_argument);
  fs::remove_all(folder);
}
