// Floor 8. What joints have besides, against statics and swings: B60 to B63.
#include <algorithm>
#include <cmath>
#include <string>

#include <cairn/constraints/prismatic_joint.hpp>
#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/constraints/weld_joint.hpp>
#include <cairn/math/check.hpp>
#include <cairn/measure/energy.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/worst.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double arm_mass = 3, arm_inertia = 0.5, arm_length = 0.75;     // [kg], [kg m^2], [m]
const double arm_moment = arm_mass * standard_gravity * arm_length;  // [N m] of a level arm
const double wheel_inertia = 0.5;                                    // [kg m^2]
const int drive_sweeps = 400;                                        // a pin and a motor share a body

/// A load at the end of an arm, which is level and pinned at the origin.
Scene level_arm(const RevoluteJoint::Motor& motor) {
  Scene scene;
  const BodyId arm = scene.add({.position = {arm_length, 0}, .mass = arm_mass, .inertia = arm_inertia});
  scene.join<RevoluteJoint>({.a = ground, .b = arm, .motor = motor});
  return scene;
}

/// A wheel on an axle through its middle.
Scene free_wheel(RevoluteJoint::Spec spec, double angular_velocity, double dt) {
  Scene scene({.dt = dt});
  spec.b = scene.add({.angular_velocity = angular_velocity, .mass = 2, .inertia = wheel_inertia});
  scene.join<RevoluteJoint>(spec);
  return scene;
}

/// A load on an upright slide, which a servo is to hold where it is.
Scene lift(double max_force) {
  Scene scene;
  const BodyId load = scene.add({.mass = arm_mass, .inertia = arm_inertia});
  scene.join<PrismaticJoint>(
      {.b = load,
       .axis = {0, 1},
       .motor = PrismaticJoint::Motor{.speed = 1, .max_force = max_force, .target = 0}});
  return scene;
}

void add_servo_that_holds(const EngineMaker& make, ValidationResult& result) {
  const double target = 0.75 * pi;
  for (const double share : {1.5, 100.0}) {
    Motion arm(make, level_arm({.speed = 1, .max_torque = share * arm_moment, .target = target}),
               drive_sweeps);
    double farthest_angle = 0;
    while (arm.time() < 8) {
      arm.step();
      farthest_angle = std::max(farthest_angle, arm.angle({1}));
    }
    const std::string with = " of a servo of " + shortest(share) + " m g l";
    result.add(measured("angle after 8 s" + with, arm.angle({1}), "rad")
                   .by("target", target)
                   .within(1e-6, "1e-6: what is missing fades by e^-50; sweeps and, of Box2D, floats"));
    result.add(measured("beyond the target" + with, std::max(0.0, farthest_angle - target), "rad")
                   .by("0", 0)
                   .within(1e-6, "the same"));
  }
}

/// Steps of 1/60 s: until what is missing is speed / rate the servo goes evenly, and then takes rate dt of it
/// in each step.
void add_servo_that_goes(const EngineMaker& make, ValidationResult& result) {
  const double speed = 2, rate = 5, target = 3;
  const RevoluteJoint::Motor motor{.speed = speed, .max_torque = 1e6, .target = target, .rate = rate};
  Motion wheel(make, free_wheel({.motor = motor}, 0, standard_dt), drive_sweeps);
  wheel.run(1);
  result.add(measured("angle after 1 s at full speed", wheel.angle({1}), "rad")
                 .by("speed t", speed)
                 .within(1e-5, "1e-5: roundings, of Box2D those of a float"));
  double missing = target - speed;
  while (missing > speed / rate) missing -= speed * standard_dt;
  while (std::abs(target - wheel.angle({1})) > speed / rate) wheel.step();
  const double begin = target - wheel.angle({1});
  for (int step = 0; step < 30; ++step) wheel.step();
  result.add(measured("still missing 30 steps later", target - wheel.angle({1}), "rad")
                 .by("e (1 - rate dt)^30", begin * std::pow(1 - rate * standard_dt, 30))
                 .within(1e-5, "the same"));
}

void add_servo_too_weak(const EngineMaker& make, ValidationResult& result) {
  const double seconds = 0.5, weight = arm_mass * standard_gravity;
  Motion held(make, lift(1.01 * weight), drive_sweeps), falls(make, lift(0.6 * weight), drive_sweeps);
  held.run(seconds);
  falls.run(seconds);
  result.add(measured("height of a load on a servo of 1.01 m g", held.position({1}).y(), "m")
                 .by("0", 0)
                 .within(1e-6, "1e-6: roundings, of Box2D those of a float"));
  result.add(measured("speed of a load on a servo of 0.6 m g after 0.5 s", falls.velocity({1}).y(), "m/s")
                 .by("-(g - F/m) t", -0.4 * standard_gravity * seconds)
                 .within(1e-5, "the same"));
}

ValidationResult servo(const EngineMaker& make) {
  ValidationResult result;
  add_servo_that_holds(make, result);
  add_servo_that_goes(make, result);
  add_servo_too_weak(make, result);
  return result;
}

struct Swings {
  double period = 0;  // [s] between the first and the last passage of the middle
  double energy = 0;  // [J] at the end
};

Swings swings_of(Motion& motion, double seconds, const std::function<double()>& place) {
  double first = -1, last = 0;
  int passages = 0;
  while (motion.time() < seconds) {
    const double before = place();
    motion.step();
    const double after = place();
    if (before * after > 0 || after == before) continue;
    last = motion.time() - motion.dt() * after / (after - before);
    if (first < 0) first = last;
    ++passages;
  }
  return {2 * (last - first) / (passages - 1), total_energy(motion.now())};
}

ValidationResult torsion_pendulum(const EngineMaker& make) {
  ValidationResult result;
  const double rest = 0.25, spin = 3, dt = standard_dt / 4;
  for (const double stiffness : {2.0, 8.0, 32.0}) {
    const double omega = std::sqrt(stiffness / wheel_inertia), turn = omega * dt;
    const JointSpring spring{.softness = SpringSoftness{.stiffness = stiffness}, .rest = rest};
    Motion wheel(make, free_wheel({.spring = spring}, spin, dt), drive_sweeps);
    const Swings got = swings_of(wheel, 20, [&] { return wheel.angle({1}) - rest; });
    const std::string with = " on a spring of " + shortest(stiffness) + " N m/rad";
    result.add(measured("period" + with, got.period, "s")
                   .by("2 pi sqrt(I/k)", 2 * pi / omega)
                   .within_share(1.5 * turn * turn / 12, "1.5 (w dt)^2/12: a step turns by 2 atan(w dt/2)"));
    const double energy = (wheel_inertia * spin * spin + stiffness * rest * rest) / 2;
    result.add(
        measured("kinetic and potential energy after 20 s" + with, got.energy, "J")
            .by("I w^2/2 + k q^2/2", energy)
            .within_share(turn + 20 * omega * std::pow(turn, 4),
                          "w dt: half a step parts place and speed, at both ends; 2 pi (w dt)^5 a swing"));
  }
  return result;
}

/// A level arm whose end is welded to the ground at the origin, softly.
ValidationResult soft_weld(const EngineMaker& make) {
  const double bending = 40, stiffness = 900, seconds = 30;
  const auto welded = [&](const WeldJoint::Spec& soft) {
    Scene scene;
    WeldJoint::Spec spec = soft;
    spec.b = scene.add({.position = {arm_length, 0}, .mass = arm_mass, .inertia = arm_inertia});
    scene.join<WeldJoint>(spec);
    return scene;
  };
  Motion bent(make, welded({.bending = SpringSoftness{.stiffness = bending, .damping = 10}}), drive_sweeps);
  Motion sunk(make, welded({.softness = SpringSoftness{.stiffness = stiffness, .damping = 60}}),
              drive_sweeps);
  bent.run(seconds);
  sunk.run(seconds);
  double angle = 0;
  for (int i = 0; i < 200; ++i) angle = (angle - arm_moment / bending * std::cos(angle)) / 2;
  const std::string reason = "1e-6: swings fade by e^-25 and more in 30 s; sweeps";
  ValidationResult result;
  result.add(measured("angle of an arm on a soft weld", bent.angle({1}), "rad")
                 .by("k q = -m g l cos q", angle)
                 .within(1e-6, reason));
  result.add(measured("sag of an arm on a weld that is soft in its place", -sunk.position({1}).y(), "m")
                 .by("m g/k", arm_mass * standard_gravity / stiffness)
                 .within(1e-6, reason));
  return result;
}

ValidationResult ratchet(const EngineMaker& make) {
  ValidationResult result;
  const double tooth = in_radians(15);
  for (const double side : {1.0, -1.0}) {
    // So fast that it turns through 40 degrees before gravity turns it back: to the second tooth.
    const double inertia = arm_inertia + arm_mass * arm_length * arm_length;
    const double spin = std::sqrt(2 * arm_moment * std::sin(in_radians(40)) / inertia);
    Scene scene;
    const BodyId arm = scene.add({.position = {side * arm_length, 0},
                                  .velocity = {0, spin * arm_length},
                                  .angular_velocity = side * spin,
                                  .mass = arm_mass,
                                  .inertia = arm_inertia});
    scene.join<RevoluteJoint>({.b = arm, .ratchet = side * tooth});
    Motion lever(make, scene, drive_sweeps);
    lever.run(4);
    result.add(measured(side > 0 ? "lever on a ratchet" : "lever on a ratchet the other way round",
                        lever.angle({1}), "rad")
                   .by("2 teeth", side * 2 * tooth)
                   .within(1e-6, "1e-6: sweeps"));
  }
  return result;
}

}  // namespace

void add_drive_cases(ValidationCases& cases) {
  cases.push_back({.id = "B60",
                   .title = "A servo goes to its target at its speed, does not overshoot, and holds any load "
                            "below its strength there",
                   .asks = Asks::any_engine,
                   .run = servo});
  cases.push_back({.id = "B61",
                   .title = "A wheel on a torsion spring swings with the period 2 pi sqrt(I / k)",
                   .source = "C.-A. Coulomb, 1784",
                   .run = torsion_pendulum});
  cases.push_back({.id = "B62",
                   .title = "A soft weld bends by k q = m g l cos q and sags by m g / k",
                   .source = "R. Hooke, 1678",
                   .run = soft_weld});
  cases.push_back(
      {.id = "B63", .title = "A ratchet holds a lever at the last tooth that it has passed", .run = ratchet});
}

}  // namespace cairn
