// Floor 8. Friction as taught, impacts that are passed on, and bodies of any outline.
#include <fmt/format.h>

#include <cmath>

#include <cairn/geometry/mass.hpp>
#include <cairn/geometry/shape.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double held_friction = 0.6, sliding_friction = 0.3;  // mu_s and mu

/// A block that rests on a slope of this tangent: gravity is turned, and the ground level.
Scene block_on_slope(double tangent, double frequency) {
  const double angle = std::atan(tangent);
  const Material material = {.friction = sliding_friction, .static_friction = held_friction};
  Scene scene(
      {.gravity = standard_gravity * Vec2<double>(std::sin(angle), -std::cos(angle)), .dt = 1 / frequency});
  scene.add_ground({.material = material});
  scene.add({.shapes = {box(1, 0.5)}, .position = {0, 0.25}, .material = material});
  return scene;
}

double speed_on_slope(const EngineMaker& make, double tangent, double frequency) {
  return run_scene(make, block_on_slope(tangent, frequency), 60, 1).bodies.back().velocity.x();
}

// It lets go once it is faster than mu g cos dt m/m_t, with m/m_t = 1 + m (b/2)^2/I = 1.6 on its lower edge:
// after n steps of (tan - mu_s) g cos dt, in which friction gives mu_s, and so (mu_s - mu) g cos n dt less in
// all.
ValidationResult letting_go(const EngineMaker& make) {
  const double tangent = 0.75, cosine = std::cos(std::atan(tangent));
  const double ideal = standard_gravity * cosine * (tangent - sliding_friction);
  const double steps = std::floor(1.6 * sliding_friction / (tangent - held_friction)) + 1;
  const double lost = steps * standard_gravity * cosine * (held_friction - sliding_friction) * standard_dt;
  ValidationResult result;
  const Bracket found = bisected({.before = 0.4, .after = 0.8}, 1e-4, [&](double slope) {
    return std::abs(speed_on_slope(make, slope, 60)) > 1e-3;
  });
  add_bracket(result.numbers,
              measured("tangent of the slope", 0)
                  .by("mu_s", held_friction)
                  .within(1e-3, "1 mm/s after 1 s is reached 1.2e-4 above mu_s"),
              found, " up to which it rests", " from which on it slides");
  result.add(measured("speed 1 s after it let go, at 60 Hz", speed_on_slope(make, tangent, 60), "m/s")
                 .by("g cos (tan - mu) t - g cos (mu_s - mu) n dt", ideal - lost)
                 .within(1e-9, "the sums are exact; 60 sweeps of a contact at two points leave rounding"));
  result.convergence = converges("speed after 1 s, to g cos (tan - mu) t", [&](double frequency) {
    return speed_on_slope(make, tangent, frequency) - ideal;
  });
  return result;
}

const double resistance = 0.03, wheel_radius = 0.5, rolling_speed = 2;  // [m], [m], [m/s]

Scene disc_that_rolls(double frequency) {
  Scene scene({.dt = 1 / frequency});
  scene.add_ground();
  scene.add({.shapes = {circle(wheel_radius)},
             .position = {0, wheel_radius},
             .velocity = {rolling_speed, 0},
             .angular_velocity = -rolling_speed / wheel_radius,
             .material = {.rolling_resistance = resistance}});
  return scene;
}

// The moment mu_r m g turns 3/2 m r^2 about the point of contact. Each step goes as far as the speed that is
// left: v0 dt/2 less in all.
ValidationResult rolling_out(const EngineMaker& make) {
  const double slowing = 2 * resistance * standard_gravity / (3 * wheel_radius);
  const double stops = rolling_speed / slowing, ideal = rolling_speed * stops / 2;  // [s], [m]
  const std::string reason = "the sums are exact; the rows of a disc act on each other little";
  ValidationResult result;
  result.add(measured("speed after 2 s",
                      run_scene(make, disc_that_rolls(60), 60, 2).bodies.back().velocity.x(), "m/s")
                 .by("v0 - 2 mu_r g t/(3 r)", rolling_speed - 2 * slowing)
                 .within(1e-9, reason));
  const auto way = [&](double frequency) {
    return run_scene(make, disc_that_rolls(frequency), 60, stops + 0.5).bodies.back().pose.position.x();
  };
  result.add(measured("way until it rests at 60 Hz", way(60), "m")
                 .by("3 r v0^2/(4 mu_r g) - v0 dt/2", ideal - rolling_speed * standard_dt / 2)
                 .within(1e-8, reason));
  result.convergence = converges("way until it rests, to 3 r v0^2/(4 mu_r g)",
                                 [&](double frequency) { return way(frequency) - ideal; });
  return result;
}

/// Five balls that touch, of which so many come in from the left at 1 m/s.
Scene touching_balls(int incoming, double restitution) {
  Scene scene({.gravity = {0, 0}, .impacts = Impacts::sequence});
  for (int i = 0; i < 5; ++i) {
    scene.add({.shapes = {circle(0.5)},
               .position = {static_cast<double>(i), 0},
               .velocity = {i < incoming ? 1.0 : 0.0, 0},
               .mass = 1,
               .material = {.friction = 0, .restitution = restitution}});
  }
  return scene;
}

ValidationResult passed_on(const EngineMaker& make) {
  const std::string reason = "stages of a sequence are solved to 64 roundings";
  ValidationResult result;
  for (int incoming = 1; incoming < 5; ++incoming) {
    const Snapshot end = run_scene(make, touching_balls(incoming, 1), 10, 0.05);
    for (int i = 1; i <= 5; ++i) {
      const double expected = i > 5 - incoming ? 1 : 0;
      result.add(measured(fmt::format("speed of ball {}, {} come in", i, incoming),
                          end.bodies[{i}].velocity.x(), "m/s")
                     .by(expected > 0 ? "v" : "0", expected)
                     .within(1e-11, reason));
    }
  }
  const double e = 0.8;
  const Snapshot end = run_scene(make, touching_balls(1, e), 10, 0.05);
  result.add(measured("speed of the last ball, e = 0.8", end.bodies[{5}].velocity.x(), "m/s")
                 .by("((1 + e)/2)^4 v", std::pow((1 + e) / 2, 4))
                 .within(1e-11, reason));
  return result;
}

const double pair_friction = 0.25, pair_restitution = 0.5;

/// A block slides on the ground, and a ball falls on it beside, each with what a table says of the pair.
Scene pairs_of_a_table() {
  Scene scene;
  scene.add_ground({.material = {.friction = 0.9, .restitution = 1}});
  const BodyId block = scene.add(
      {.shapes = {box(1, 0.5)}, .position = {0, 0.25}, .velocity = {4, 0}, .material = {.friction = 0.7}});
  const BodyId ball = scene.add({.shapes = {circle(0.5)}, .position = {-5, 0.5}, .velocity = {0, -4}});
  SceneSettings settings = scene.settings();
  settings.gravity = {0, -standard_gravity};
  settings.mixing.pairs = {{.a = {ground}, .b = {block}, .friction = pair_friction, .restitution = 0},
                           {.a = {ground}, .b = {ball}, .friction = 0, .restitution = pair_restitution}};
  scene.set_settings(settings);
  return scene;
}

ValidationResult of_pairs(const EngineMaker& make) {
  ValidationResult result;
  const Snapshot end = run_scene(make, pairs_of_a_table(), 50, 0.5);
  result.add(measured("speed of a block after 0.5 s", end.bodies[{1}].velocity.x(), "m/s")
                 .by("v0 - mu_ab g t", 4 - pair_friction * standard_gravity * 0.5)
                 .within(1e-5, "Box2D computes in float"));
  const Snapshot first = run_scene(make, pairs_of_a_table(), 50, standard_dt);
  result.add(measured("speed of a ball after it struck", first.bodies[{2}].velocity.y(), "m/s")
                 .by("e_ab v0", pair_restitution * 4)
                 .within(pair_restitution * standard_gravity * standard_dt + 1e-5,
                         "Box2D bounces from the speed after gravity"));
  return result;
}

const List<Vec2<double>> ell = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}};

bool tips(const EngineMaker& make, double foot) {
  Scene scene;
  scene.add({.type = BodyType::static_body, .shapes = {box(2, 1)}, .position = {foot - 1, -0.5}});
  scene.add({.shapes = outline(ell)});
  return std::abs(run_scene(make, scene, 50, 2).bodies.back().pose.angle) > 0.05;
}

// Two boxes of 3 m^2, whose middles are (1.5, 0.5) and (0.5, 2.5): sqrt(1 + 4) m apart.
ValidationResult outlines(const EngineMaker& make) {
  const std::string reason = "sums of a few terms";
  const MassProperties l = mass_properties(outline(ell));
  ValidationResult result;
  result.add(measured("area of an L", l.area, "m^2").by("a t + (b - t) t", 6).within(1e-14 * 6, reason));
  result.add(
      measured("centre of an L", l.centroid.x(), "m").by("(3 1.5 + 3 0.5)/6", 1).within(1e-14, reason));
  result.add(measured("inertia of an L", l.inertia, "m^4")
                 .by("2 3 (1 + 9)/12 + 6 (5/4)", 5 + 7.5)
                 .within(1e-13 * 12.5, reason));
  List<Vec2<double>> star;
  const double outer = 2, inner = 0.8, step = pi / 5;
  for (int i = 0; i < 10; ++i)
    star.push_back((i % 2 == 0 ? outer : inner) * Vec2<double>(std::cos(i * step), std::sin(i * step)));
  const MassProperties s = mass_properties(outline(star));
  const double area = 5 * outer * inner * std::sin(step);
  const double inertia = area / 6 * (outer * outer + inner * inner + outer * inner * std::cos(step));
  result.add(measured("area of a star of n tips", s.area, "m^2")
                 .by("n R r sin(pi/n)", area)
                 .within(1e-14 * area, reason));
  result.add(measured("inertia of a star", s.inertia, "m^4")
                 .by("A (R^2 + r^2 + R r cos(pi/n))/6", inertia)
                 .within(1e-13 * inertia, reason));
  add_bracket(
      result.numbers,
      measured("width of the foot under an L", 0, "m")
          .by("x of its centre", 1)
          .within(0.02, "within 2 s it falls only from 0.0003 rad off its balance on; and the slop of 5 mm"),
      bisected({.before = 1.5, .after = 0.5}, 1e-3, [&](double foot) { return tips(make, foot); }),
      " on which it stands", " from which it tips");
  return result;
}

}  // namespace

void add_contact_cases(ValidationCases& cases) {
  cases.push_back({.id = "B45",
                   .title = "A block that sticks lets go at tan = mu_s, and then slides with mu",
                   .source = "C. A. Coulomb, 1785",
                   .run = letting_go});
  cases.push_back({.id = "B46",
                   .title = "A disc rolls 3 r v0^2 / (4 mu_r g) far against a rolling resistance",
                   .source = "C. A. Coulomb, 1785",
                   .run = rolling_out});
  cases.push_back(
      {.id = "B47",
       .title = "Of five balls that touch, as many go out as come in, where impacts are a sequence",
       .source = "Smith et al., 2012",
       .run = passed_on});
  cases.push_back({.id = "B48",
                   .title = "Two bodies rub and rebound by what a table says of their pair",
                   .asks = Asks::any_engine,
                   .run = of_pairs});
  cases.push_back(
      {.id = "B49",
       .title = "An L stands until its centre of mass is beyond its foot; a star weighs by formula",
       .asks = Asks::any_engine,
       .run = outlines});
}

}  // namespace cairn
