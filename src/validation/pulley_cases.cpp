// Floor 8. Ropes over rollers and drums, and a gear box: B18, B19 and B20.
#include <algorithm>
#include <cmath>
#include <string>

#include <cairn/constraints/differential_joint.hpp>
#include <cairn/constraints/pulley_joint.hpp>
#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/worst.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

/// A body that touches nothing.
BodySpec loose_body(const Vec2<double>& position, double mass, double inertia = 1) {
  return {.position = position, .mass = mass, .inertia = inertia};
}

const double pulley_height = 5;  // [m] of rollers over the bodies

/// Two bodies on one rope over fixed rollers; `parts` of rope go to the second one.
Scene two_on_a_rope(double mass_a, double mass_b, double parts, PulleyJoint::Kind kind) {
  Scene scene;
  const BodyId a = scene.add(loose_body({0, 0}, mass_a)), b = scene.add(loose_body({2, 0}, mass_b));
  scene.join<PulleyJoint>(
      {.ends = {{.body = a, .anchor = {0, 0}, .roller = {0, pulley_height}},
                {.body = b, .anchor = {2, 0}, .roller = {2, pulley_height}, .parts = parts}},
       .kind = kind});
  return scene;
}

const char* const pulley_reason = "1e-9: constant forces are exact, sweeps and rounding leave less";

void see_atwood(const EngineMaker& make, Worst& worst) {
  const double heavy = 2, light = 1;
  for (const PulleyJoint::Kind kind : {PulleyJoint::Kind::rope, PulleyJoint::Kind::taut}) {
    Motion machine(make, two_on_a_rope(heavy, light, 1, kind), 2);
    machine.run(0.5);
    for (const BodyId body : {BodyId{1}, BodyId{2}}) {
      worst.add(measured("Atwood machine of 2 and 1 kg, worst of 5 solvers",
                         std::abs(machine.velocity(body).y()) / machine.time(), "m/s^2")
                    .by("(m1 - m2) g/(m1 + m2)", (heavy - light) * standard_gravity / (heavy + light))
                    .within_share(1e-9, pulley_reason));
    }
  }
}

/// The tension is what both accelerations ask for.
void see_tackle(const EngineMaker& make, Worst& balance, Worst& tension) {
  const double light = 1.5, heavy = 4;
  for (const double ratio : {2.0, 3.0, 5.0}) {
    Motion still(make, two_on_a_rope(light, ratio * light, ratio, PulleyJoint::Kind::rope), 2);
    still.run(0.5);
    balance.add(measured("speed where m2 = r m1 after 0.5 s, worst of r = 2, 3, 5 and 5 solvers",
                         still.velocity({2}).norm(), "m/s")
                    .zero_within(1e-13, "rounding of g dt = 0.17 m/s in each of 30 steps"));
    Motion falling(make, two_on_a_rope(light, ratio * heavy, ratio, PulleyJoint::Kind::rope), 2);
    falling.run(0.25);
    const double on_light = light * (falling.velocity({1}).y() / falling.time() + standard_gravity);
    const double on_heavy = heavy * (falling.velocity({2}).y() / falling.time() + standard_gravity);
    for (const double force : {on_light, on_heavy}) {
      tension.add(
          measured("tension where m2 > r m1, by both bodies, worst of r = 2, 3, 5 and 5 solvers", force, "N")
              .by("(1 + r) g/(1/m1 + r^2/m2)", (1 + ratio) * standard_gravity / (1 / light + ratio / heavy))
              .within_share(1e-9, pulley_reason));
    }
  }
}

const double wheel_radius = 0.5;  // [m]

/// Bodies 1 to 3: a wheel on an axle, and a body on each side of it, on ropes that do not slip.
Scene wheel_with_two_loads(double wheel_mass, double left_mass, double right_mass) {
  const double radius = wheel_radius;
  Scene scene;
  const BodyId wheel =
      scene.add(loose_body({0, pulley_height}, wheel_mass, wheel_mass * radius * radius / 2));
  scene.join<RevoluteJoint>({.a = ground, .b = wheel, .anchor = {0, pulley_height}});
  const auto hang = [&](double x, double mass) {
    const BodyId body = scene.add(loose_body({x, 0}, mass));
    scene.join<PulleyJoint>({.ends = {{.body = body,
                                       .anchor = {x, 0},
                                       .roller = {x, pulley_height},
                                       .carrier = wheel,
                                       .kind = PulleyJoint::Roller::drum}}});
  };
  hang(-radius, left_mass);
  hang(radius, right_mass);
  return scene;
}

void see_massive_wheel(const EngineMaker& make, Worst& acceleration, Worst& axle) {
  const double wheel = 2, heavy = 3, light = 1;
  Motion machine(make, wheel_with_two_loads(wheel, heavy, light), 300);
  machine.run(1.0 / 3);
  const double a = (heavy - light) * standard_gravity / (heavy + light + wheel / 2);
  const double rim = machine.velocity({1}).z() * wheel_radius;
  for (const double speed : {-machine.velocity({2}).y(), machine.velocity({3}).y(), rim}) {
    acceleration.add(
        measured("Atwood machine of 3 and 1 kg with a wheel of 2 kg: worst of loads, rim and 5 solvers",
                 speed / machine.time(), "m/s^2")
            .by("(m1 - m2) g/(m1 + m2 + M/2)", a)
            .within_share(1e-9, pulley_reason));
  }
  const double load =
      heavy * (standard_gravity - a) + light * (standard_gravity + a) + wheel * standard_gravity;
  axle.add(measured("force of its axle, worst of 5 solvers",
                    machine.now().joints[0].impulse.y() / machine.dt(), "N")
               .by("m1 (g - a) + m2 (g + a) + M g", load)
               .within_share(1e-9, pulley_reason));
}

ValidationResult pulleys(const EngineMaker&) {
  Worst atwood, balance, tension, wheel, axle;
  for (const EngineMaker& make : gauss_seidel_engines()) {
    see_atwood(make, atwood);
    see_tackle(make, balance, tension);
    see_massive_wheel(make, wheel, axle);
  }
  return {.numbers = {atwood.number(), wheel.number(), axle.number(), balance.number(), tension.number()}};
}

/// A spool whose string leaves it on its left, straight up to the ground.
Scene falling_spool(double mass, double inertia, double radius) {
  Scene scene;
  const BodyId spool = scene.add(loose_body({0, 0}, mass, inertia));
  scene.join<PulleyJoint>({.ends = {{.body = ground,
                                     .anchor = {-radius, 1},
                                     .roller = {-radius, 0},
                                     .carrier = spool,
                                     .kind = PulleyJoint::Roller::drum}}});
  return scene;
}

ValidationResult spools(const EngineMaker&) {
  const double radius = 0.2, mass = 3;
  const char* const names[] = {"disc", "hoop", "yo-yo on a thin axle"};
  const double shares[] = {0.5, 1, 10};  // I / m R^2
  ValidationResult result;
  for (int kind = 0; kind < 3; ++kind) {
    Worst fall, turn, string;
    const double a = standard_gravity / (1 + shares[kind]);
    for (const EngineMaker& make : gauss_seidel_engines()) {
      Motion spool(make, falling_spool(mass, shares[kind] * mass * radius * radius, radius), 1);
      spool.run(0.5);
      const std::string reason = "1e-12: one row is solved by one sweep; rounding of 30 steps";
      const std::string name = names[kind];
      fall.add(measured(name + ": falls with, worst of 5 solvers", -spool.velocity({1}).y() / spool.time(),
                        "m/s^2")
                   .by("g/(1 + I/m R^2)", a)
                   .within_share(1e-12, reason));
      turn.add(measured(name + ": turns with, worst of 5 solvers", -spool.velocity({1}).z() / spool.time(),
                        "rad/s^2")
                   .by("a/R", a / radius)
                   .within_share(1e-12, reason));
      string.add(measured(name + ": its string pulls with, worst of 5 solvers",
                          spool.now().joints[0].impulse.norm() / spool.dt(), "N")
                     .by("m (g - a)", mass * (standard_gravity - a))
                     .within_share(1e-12, reason));
    }
    result.numbers.insert(result.numbers.end(), {fall.number(), turn.number(), string.number()});
  }
  return result;
}

const double differential_torque = 5;                                     // [N m] on the case
const double shaft_inertia_a = 1, shaft_inertia_b = 3, case_inertia = 2;  // [kg m^2]

/// Bodies 1 and 2 are the shafts, 3 is the case, which a motor turns.
Scene driven_differential() {
  Scene scene;
  const auto on_axle = [&scene](double x, double inertia, double torque) {
    const BodyId wheel = scene.add(loose_body({x, 0}, 1, inertia));
    RevoluteJoint::Spec axle{.a = ground, .b = wheel, .anchor = {x, 0}};
    // A motor that never comes to its speed gives all of its torque.
    if (torque > 0) axle.motor = RevoluteJoint::Motor{.speed = 1e6, .max_torque = torque};
    scene.join<RevoluteJoint>(axle);
    return wheel;
  };
  const BodyId a = on_axle(-3, shaft_inertia_a, 0), b = on_axle(3, shaft_inertia_b, 0);
  const BodyId c = on_axle(0, case_inertia, differential_torque);
  scene.join<DifferentialJoint>({.a = a, .b = b, .c = c});
  return scene;
}

ValidationResult differential(const EngineMaker&) {
  // I_a alpha_a = I_b alpha_b = T, I_c alpha_c = tau - 2 T, and alpha_a + alpha_b = 2 alpha_c.
  const double torque =
      2 * differential_torque / case_inertia / (1 / shaft_inertia_a + 1 / shaft_inertia_b + 4 / case_inertia);
  const double expected[] = {torque / shaft_inertia_a, torque / shaft_inertia_b,
                             (differential_torque - 2 * torque) / case_inertia};
  const char* const names[] = {"first shaft", "second shaft", "case"};
  const char* const formulas[] = {"T/I1, T = 2 tau/I3/(1/I1 + 1/I2 + 4/I3)", "T/I2", "(tau - 2 T)/I3"};
  Worst kept, turning[3];
  for (const EngineMaker& make : gauss_seidel_engines()) {
    Motion gears(make, driven_differential(), 20);
    double largest = 0;
    for (int step = 0; step < 60; ++step) {
      gears.step();
      const double w1 = gears.velocity({1}).z(), w2 = gears.velocity({2}).z(), w3 = gears.velocity({3}).z();
      largest = std::max(largest, std::abs(w1 + w2 - 2 * w3));
    }
    kept.add(measured("w1 + w2 - 2 w3, worst of 60 steps and 5 solvers", largest, "rad/s")
                 .zero_within(1e-12, "its row is solved last: rounding of speeds below 10 rad/s"));
    for (int i = 0; i < 3; ++i) {
      turning[i].add(
          measured(std::string(names[i]) + ", worst of 5 solvers", gears.velocity({i + 1}).z() / gears.time(),
                   "rad/s^2")
              .by(formulas[i], expected[i])
              .within_share(1e-9, "1e-9: motor and gears agree after 20 sweeps, but for rounding"));
    }
  }
  return {.numbers = {kept.number(), turning[0].number(), turning[1].number(), turning[2].number()}};
}

}  // namespace

void add_pulley_cases(ValidationCases& cases) {
  cases.push_back({.id = "B18",
                   .title = "Ropes over rollers move and balance loads as Atwood's machine and tackles do",
                   .source = "G. Atwood, 1784",
                   .run = pulleys});
  cases.push_back({.id = "B19",
                   .title = "A disc on a string that it unwinds falls with 2 g / 3, on a third of its weight",
                   .run = spools});
  cases.push_back({.id = "B20",
                   .title = "A differential keeps w1 + w2 = 2 w3, and gives both shafts the same torque",
                   .run = differential});
}

}  // namespace cairn
