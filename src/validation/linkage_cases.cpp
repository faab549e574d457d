// Floor 8. Wheels on springs, slots, racks and ropes that push: B64 to B67.
#include <algorithm>
#include <cmath>
#include <string>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/constraints/gear_joint.hpp>
#include <cairn/constraints/prismatic_joint.hpp>
#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double car_mass = 400, car_wheel_radius = 0.4, spring_stiffness = 20000;  // [kg], [m], [N/m]
const double car_speed = 8;                                                     // [rad/s] of its rear wheel

/// A chassis on two wheels, the ground level. Springs are at rest: it begins by sagging.
Scene car() {
  Scene scene;
  scene.add_ground({.half_width = 200, .material = {.friction = 0.9}});
  const BodyId chassis = scene.add({.position = {0, 1}, .mass = car_mass, .inertia = 300});
  for (const double side : {-1.0, 1.0}) {
    const Vec2<double> place(side * 1.1, car_wheel_radius);
    const BodyId wheel = scene.add(
        {.shapes = {circle(car_wheel_radius)}, .position = place, .mass = 20, .material = {.friction = 0.9}});
    PrismaticJoint::Spec spec{
        .a = chassis, .b = wheel, .anchor = place, .axis = {0, 1}, .kind = PrismaticJoint::Kind::wheel};
    spec.spring = {.softness = SpringSoftness{.stiffness = spring_stiffness, .damping = 3000}};
    if (side < 0) spec.motor = PrismaticJoint::Motor{.speed = -car_speed, .max_force = 60};
    scene.join<PrismaticJoint>(spec);
  }
  return scene;
}

ValidationResult sprung_car(const EngineMaker& make) {
  Motion motion(make, car(), 200);
  motion.run(20);
  const double sag = (motion.position({2}).y() + motion.position({3}).y()) / 2 - motion.position({1}).y() -
                     (car_wheel_radius - 1);
  ValidationResult result;
  result.add(measured("sag of a car on two wheels", sag, "m")
                 .by("m g/(2 k)", car_mass * standard_gravity / (2 * spring_stiffness))
                 .within(1e-5, "1e-5: sweeps, and of Box2D roundings of a place of 60 m"));
  result.add(measured("speed of the car after 20 s", motion.velocity({1}).x(), "m/s")
                 .by("w r", car_speed * car_wheel_radius)
                 .within(1e-3, "1e-3: sweeps, and of Box2D the skins of the ground"));
  return result;
}

/// A body whose point, l above its middle, runs on a level line without mass: its middle only goes up and
/// down, and m g l sin q turns it about that.
ValidationResult pendulum_in_a_slot(const EngineMaker& make) {
  const double mass = 3, inertia = 0.5, length = 0.75, start = 0.01;
  Scene scene({.dt = standard_dt / 4});
  const BodyId bob = scene.add({.position = {length * std::sin(start), -length * std::cos(start)},
                                .angle = start,
                                .mass = mass,
                                .inertia = inertia});
  scene.join<PrismaticJoint>({.b = bob, .kind = PrismaticJoint::Kind::slot});
  Motion motion(make, scene, 50);
  const double middle = length * std::sin(start),
               omega = std::sqrt(mass * standard_gravity * length / inertia);
  double first = -1, last = 0, aside = 0;
  int passages = 0;
  while (motion.time() < 10) {
    const double before = motion.angle(bob);
    motion.step();
    const double after = motion.angle(bob);
    aside = std::max(aside, std::abs(motion.position(bob).x() - middle));
    if (before * after > 0) continue;
    last = motion.time() - motion.dt() * after / (after - before);
    if (first < 0) first = last;
    ++passages;
  }
  ValidationResult result;
  result.add(
      measured("period of a pendulum whose pivot slides freely", 2 * (last - first) / (passages - 1), "s")
          .by("2 pi sqrt(I/(m g l))", 2 * pi / omega)
          .within_share(std::pow(omega * motion.dt(), 2) / 24 + start * start / 4 + 1e-4,
                        "(w dt)^2/24 of the step, q^2/4 of its amplitude, 1e-4 of Box2D's floats"));
  result.add(measured("its middle aside", aside, "m").zero_within(1e-5, "1e-5: of Box2D's floats"));
  return result;
}

/// A rack on a level slide, and a wheel that a constant torque turns: a motor that never comes to its speed.
ValidationResult rack_and_wheel(const EngineMaker& make) {
  const double radius = 0.3, inertia = 0.5, mass = 4, torque = 6, seconds = 2;
  Scene scene({.gravity = {0, 0}});
  const BodyId wheel = scene.add({.mass = 2, .inertia = inertia});
  const BodyId rack = scene.add({.position = {0, -radius}, .mass = mass, .inertia = 1});
  scene.join<RevoluteJoint>({.b = wheel, .motor = RevoluteJoint::Motor{.speed = 1e6, .max_torque = torque}});
  scene.join<PrismaticJoint>({.b = rack, .anchor = {0, -radius}});
  scene.join<GearJoint>({.a = wheel, .b = rack, .radius_a = radius, .mesh = GearJoint::Mesh::rack});
  Motion motion(make, scene, 400);
  motion.run(seconds);
  const double acceleration = torque * radius / (inertia + mass * radius * radius);
  ValidationResult result;
  result.add(measured("place of the rack", motion.position(rack).x(), "m")
                 .by("r q", radius * motion.angle(wheel))
                 .within(1e-4, "1e-4: of Box2D's floats"));
  result.add(measured("speed of the rack after 2 s", motion.velocity(rack).x(), "m/s")
                 .by("T r t/(I + m r^2)", acceleration * seconds)
                 .within_share(1e-4, "the same"));
  return result;
}

/// A ball thrown at its post comes to rest a least length before it, and one above its post stands on that.
ValidationResult least_length(const EngineMaker& make) {
  const double least = 0.4, mass = 3;
  Scene thrown({.gravity = {0, 0}}), standing;
  for (Scene* const scene : {&thrown, &standing}) {
    const bool stands = scene == &standing;
    const Vec2<double> place = stands ? Vec2<double>(0, least) : Vec2<double>(1, 0);
    const Vec2<double> velocity = stands ? Vec2<double>(0, 0) : Vec2<double>(-7, 0);
    const BodyId ball =
        scene->add({.position = place, .velocity = velocity, .mass = mass, .fixed_rotation = true});
    scene->join<DistanceJoint>({.b = ball,
                                .anchor_b = place,
                                .length = 2,
                                .kind = DistanceJoint::Kind::rope,
                                .least = least,
                                .slack_margin = 3});
  }
  Motion flies(make, thrown, 50), rests(make, standing, 50);
  flies.run(2);
  rests.run(2);
  ValidationResult result;
  result.add(measured("where a ball stops before its post", flies.position({1}).x(), "m")
                 .by("least", least)
                 .within(1e-6, "1e-6: of Box2D's floats"));
  result.add(measured("push of a rope under a ball that stands on it",
                      rests.now().joints[0].impulse.y() / standard_dt, "N")
                 .by("m g", mass * standard_gravity)
                 .within(1e-4, "the same"));
  return result;
}

}  // namespace

void add_linkage_cases(ValidationCases& cases) {
  cases.push_back({.id = "B64",
                   .title = "A car on sprung wheels sags by m g / 2 k and drives at w r",
                   .asks = Asks::any_engine,
                   .run = sprung_car});
  cases.push_back({.id = "B65",
                   .title = "A pendulum whose pivot runs freely in a slot swings with 2 pi sqrt(I / m g l)",
                   .asks = Asks::any_engine,
                   .run = pendulum_in_a_slot});
  cases.push_back({.id = "B66",
                   .title = "A rack goes by r q, and its mass counts r^2 in the inertia of the wheel",
                   .asks = Asks::any_engine,
                   .run = rack_and_wheel});
  cases.push_back({.id = "B67",
                   .title = "A rope with a least length stops what comes nearer, and carries it",
                   .asks = Asks::any_engine,
                   .run = least_length});
}

}  // namespace cairn
