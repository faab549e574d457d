// Floor 9. What cannot be simulated: shapes, masses and numbers.
#include <fmt/format.h>

#include <cmath>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/study/extremes/extreme_axes.hpp>
#include <cairn/math/check.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/world/world.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

const double no_number = std::numeric_limits<double>::quiet_NaN();

/// Steps a body of the shape on the ground, where it may sink in by slop and springs, however thin it is. Of
/// all shapes a rod gives way most: each of its ends bears half the weight m g at 1 + (l/2)^2 / (l^2/12) = 4
/// / m.
ExtremeFinding rests(const Shape<double>& shape, double height, const Setting& setting) {
  Scene scene;
  scene.add_ground({.half_width = 2e4});
  scene.add({.shapes = {shape}, .position = {0, height}, .mass = 1});
  return run_extreme(scene, setting,
                     {.seconds = 1,
                      .measure = farthest_place(),
                      .limit = 0.05,
                      .thinnest = 1e300,
                      .floor = -usual_slop - spring_sag(setting, 10.0 / 2, 4)});
}

List<ExtremeCase> shape_cases() {
  AxisCases cases("shape");
  const auto refused = [&](const std::string& value, const std::function<void()>& act) {
    cases.add_refusal(value, act);
  };
  for (const double bad : {0.0, -1.0, no_number, double(INFINITY)}) {
    refused("circle of radius " + shortest(bad), [bad] { circle(bad); });
    refused("box of width " + shortest(bad), [bad] { box(bad, 1); });
    refused("capsule of radius " + shortest(bad), [bad] { capsule({0, 0}, {1, 0}, bad); });
  }
  refused("polygon of 2 points", [] { polygon({{0, 0}, {1, 0}}); });
  refused("polygon of 17 points", [] {
    List<Vec2<double>> points;
    for (int i = 0; i < 17; ++i) points.emplace_back(std::cos(2 * pi * i / 17), std::sin(2 * pi * i / 17));
    polygon(points);
  });
  refused("polygon on a line", [] { polygon({{0, 0}, {1, 0}, {2, 0}}); });
  refused("polygon with a point twice", [] { polygon({{0, 0}, {1, 0}, {1, 0}, {0, 1}}); });
  refused("polygon with a dent", [] { polygon({{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}); });
  refused("capsule of one point", [] { capsule({1, 1}, {1, 1}, 0.5); });
  refused("segment of one point", [] { segment({1, 1}, {1, 1}); });
  refused("dynamic body without area", [] { Scene().add({.shapes = {segment({0, 0}, {1, 0})}}); });
  for (const ExtremeSetting& tried : usual_settings()) {
    const auto stepped = [&](const std::string& value, ExtremeVerdict required, const auto& run) {
      cases.add(value, tried, required, run);
    };
    stepped("polygon given clockwise", ExtremeVerdict::ok, [](const Setting& setting) {
      return rests(polygon({{-0.5, -0.5}, {-0.5, 0.5}, {0.5, 0.5}, {0.5, -0.5}}), 0.5, setting);
    });
    stepped("sliver of 1e-9 m", ExtremeVerdict::bound,
            [](const Setting& setting) { return rests(box(1, 1e-9), 5e-10, setting); });
    stepped("plank of 1 m x 0.1 mm", ExtremeVerdict::bound,
            [](const Setting& setting) { return rests(box(1, 1e-4), 5e-5, setting); });
    stepped("plank of 10 km x 1 m", ExtremeVerdict::bound,
            [](const Setting& setting) { return rests(box(1e4, 1), 0.5, setting); });
  }
  return cases.all();
}

/// A kinematic body that moves through static ones, and a ball that it pushes against one of them.
Scene press() {
  Scene scene({.gravity = {0, 0}});
  scene.add({.type = BodyType::static_body, .shapes = {box(1, 4)}, .position = {3, 0}});
  scene.add({.type = BodyType::kinematic, .shapes = {box(1, 1)}, .velocity = {1, 0}});
  scene.add({.shapes = {circle(0.3)}, .position = {1.5, 0}});
  return scene;
}

/// The heaviest or the lightest body that may be, in the air and on the ground.
ExtremeFinding of_mass(double mass, const Setting& setting) {
  Scene scene;
  scene.add_ground();
  scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}, .mass = mass, .inertia = mass});
  return run_extreme(scene, setting, {.measure = farthest_place(), .limit = 0.01, .floor = 0});
}

/// What cannot give way presses the ball: it may be pushed out, and must not explode.
ExtremeFinding pressed(const Setting& setting) {
  return run_extreme(
      press(), setting,
      {.seconds = 4,
       .measure = farthest_place(),
       .limit = 10,
       .thinnest = 1e300,
       .energy_gain = 1e300,
       .escaped = [](const Snapshot& now) { return now.bodies.back().velocity.norm() > 100; }});
}

List<ExtremeCase> mass_cases() {
  AxisCases cases("mass");
  for (const double bad : {0.0, -1.0, 1e-16, 1e16, no_number, double(INFINITY)}) {
    cases.add_refusal("mass " + shortest(bad), [bad] { Scene().add({.shapes = {circle(1)}, .mass = bad}); });
    cases.add_refusal("inertia " + shortest(bad),
                      [bad] { Scene().add({.shapes = {circle(1)}, .mass = 1, .inertia = bad}); });
  }
  cases.add_refusal("joint of ground and wall", [] {
    Scene scene;
    const BodyId wall = scene.add({.type = BodyType::static_body, .shapes = {box(1, 1)}});
    scene.join<RevoluteJoint>({.a = ground, .b = wall});
  });
  for (const ExtremeSetting& tried : usual_settings()) {
    for (const double mass : {1e-15, 1e15}) {
      cases.add("mass " + shortest(mass), tried, ExtremeVerdict::ok,
                [mass](const Setting& setting) { return of_mass(mass, setting); });
    }
    cases.add("kinematic through static", tried, ExtremeVerdict::bound, pressed);
  }
  return cases.all();
}

/// A number of a body, of the scene's settings or of a solver, under its name.
struct NumberField {
  std::string name;
  std::function<void(double)> use;
};

std::function<void(double)> for_body(const std::function<void(BodySpec&, double)>& set) {
  return [set](double value) {
    BodySpec spec{.shapes = {circle(1)}};
    set(spec, value);
    Scene().add(spec);
  };
}

std::function<void(double)> for_scene(const std::function<void(SceneSettings&, double)>& set) {
  return [set](double value) {
    SceneSettings settings;
    set(settings, value);
    Scene scene(settings);
  };
}

List<NumberField> number_fields() {
  return {
      {"position", for_body([](BodySpec& s, double x) { s.position.y() = x; })},
      {"angle", for_body([](BodySpec& s, double x) { s.angle = x; })},
      {"velocity", for_body([](BodySpec& s, double x) { s.velocity.x() = x; })},
      {"angular velocity", for_body([](BodySpec& s, double x) { s.angular_velocity = x; })},
      {"density", for_body([](BodySpec& s, double x) { s.density = x; })},
      {"linear damping", for_body([](BodySpec& s, double x) { s.damping.linear = x; })},
      {"angular damping", for_body([](BodySpec& s, double x) { s.damping.angular = x; })},
      {"gravity scale", for_body([](BodySpec& s, double x) { s.gravity_scale = x; })},
      {"gravity", for_scene([](SceneSettings& s, double x) { s.gravity.y() = x; })},
      {"baumgarte", for_scene([](SceneSettings& s, double x) { s.stabilization.baumgarte = x; })},
      {"slop", for_scene([](SceneSettings& s, double x) { s.stabilization.slop = x; })},
      {"soft frequency", for_scene([](SceneSettings& s, double x) { s.stabilization.soft.frequency = x; })},
      {"margin", for_scene([](SceneSettings& s, double x) { s.speculative_margin = x; })},
      {"threshold", for_scene([](SceneSettings& s, double x) { s.restitution_threshold = x; })},
      {"height of the ground", [](double x) { Scene().add_ground({.height = x}); }},
      {"tolerance", [](double x) { make_solver<double>("si", {.tolerance = x}); }},
      {"relaxation", [](double x) { make_solver<double>("si", {.relaxation = x}); }}};
}

List<ExtremeCase> field_cases() {
  AxisCases cases("input");
  for (const NumberField& field : number_fields()) {
    for (const double bad : {no_number, double(INFINITY), -double(INFINITY)})
      cases.add_refusal(field.name + " " + shortest(bad), [use = field.use, bad] { use(bad); });
  }
  for (const std::string what : {"position", "velocity"}) {
    const bool place = what == "position";
    cases.add_refusal(what + " 1e39 in float", [place] {
      Scene scene;
      scene.add(
          {.shapes = {circle(1)}, .position = {place ? 1e39 : 0.0, 0}, .velocity = {place ? 0.0 : 1e39, 0}});
      World<float> world(scene);
    });
  }
  return cases.all();
}

}  // namespace

List<ExtremeAxis> input_axes() {
  const std::string usual =
      "si and block under every policy, block-contact, PGS, accelerated, where it is stepped";
  return {{"shape", "shapes that are hardly any, or none", usual, shape_cases},
          {"mass", "masses that are none, and those that cannot be moved", usual, mass_cases},
          {"input", "numbers that are none", "no solver comes to see them", field_cases}};
}

}  // namespace cairn
