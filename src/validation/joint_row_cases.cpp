// Floor 8. Single rows: a rope on many bodies, wheels in mesh, a spring.
#include <algorithm>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/constraints/gear_joint.hpp>
#include <cairn/constraints/pulley_joint.hpp>
#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/geometry/shape.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_problems.hpp>
#include <cairn/validation/worst.hpp>
#include <cairn/world/world.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

/// A body of a few centimetres, that touches nothing.
BodySpec small_body(const Vec2<double>& position, double mass, double inertia = 1) {
  return {.shapes = {circle(0.1)}, .position = position, .mass = mass, .inertia = inertia};
}

struct RopeCase {
  std::string about = {};
  List<double> parts = {};   // r_i, of rope at each body
  List<double> masses = {};  // [kg]
};

/// All accelerations are T r_i / m_i - g, and sum r_i a_i is 0.
double rope_tension(const RopeCase& rope) {
  double sum = 0, inverse = 0;
  for (int i = 0; i < rope.parts.size(); ++i) {
    sum += rope.parts[i];
    inverse += rope.parts[i] * rope.parts[i] / rope.masses[i];
  }
  return sum * standard_gravity / inverse;
}

/// The tension [N] after one step of one sweep.
template <Scalar Real>
double measured_tension(const RopeCase& rope, const SolverMaker<Real>& make) {
  Scene scene;
  PulleyJoint::Spec spec;
  for (int i = 0; i < rope.parts.size(); ++i) {
    const double x = 2 * static_cast<double>(i);
    const BodyId body = scene.add(small_body({x, 0}, rope.masses[i]));
    spec.ends.push_back({.body = body, .anchor = {x, 0}, .roller = {x, 5}, .parts = rope.parts[i]});
  }
  scene.join<PulleyJoint>(spec);
  World<Real> world(scene);
  world.step(*make({.iterations = 1}));
  return static_cast<double>(world.last_step().problem.impulse.at(0)) / standard_dt;
}

template <Scalar Real>
void add_tensions(const RopeCase& rope, Worst& worst) {
  const auto epsilon = static_cast<double>(std::numeric_limits<Real>::epsilon());
  const double expected = rope_tension(rope);
  for (const SolverMaker<Real>& make : all_solvers<Real>(Iterates::any)) {
    worst.add(expected, measured_tension(rope, make), 16 * epsilon * expected);
  }
}

// A17
ValidationResult rope_on_many_bodies(const EngineMaker&) {
  const List<RopeCase> ropes = {{"r = 1, 1, m = 2, 1 kg (Atwood)", {1, 1}, {2, 1}},
                                {"r = 1, 2, 1, m = 1, 2, 3 kg", {1, 2, 1}, {1, 2, 3}},
                                {"r = 1, 2, 2, 1, m = 3, 1, 2, 5 kg", {1, 2, 2, 1}, {3, 1, 2, 5}}};
  ValidationResult result;
  for (const RopeCase& rope : ropes) {
    Worst worst = Worst("tension after one sweep, " + rope.about + ": worst of 10 solvers and 2 scalars", "N")
                      .by("sum r_i g / sum (r_i^2 / m_i)")
                      .since("one row, one division: 16 epsilon of the scalar");
    add_tensions<float>(rope, worst);
    add_tensions<double>(rope, worst);
    result.add(worst.number());
  }
  return result;
}

// Of the wheels in mesh.
const double gear_torque = 3;            // [N m] on wheel 1
const double gear_inertia[] = {0.5, 8};  // [kg m^2]
const double gear_radius[] = {1, 2};     // [m]
const int gear_steps = 60;

struct GearMotion {
  double driven = 0;  // [rad/s] w1
  double other = 0;   // [rad/s] w2
  double tooth = 0;   // [N s] between the teeth, in the last step
};

GearMotion run_gear(GearJoint::Mesh mesh, Solver<double>& solver) {
  Scene scene;
  for (int i = 0; i < 2; ++i) {
    const double x = 3.0 * i;
    const BodyId wheel = scene.add(small_body({x, 0}, 1, gear_inertia[i]));
    RevoluteJoint::Spec axle{.a = ground, .b = wheel, .anchor = {x, 0}};
    // A motor that never reaches its speed gives all of its torque, always.
    if (i == 0) axle.motor = RevoluteJoint::Motor{.speed = 1e6, .max_torque = gear_torque};
    scene.join<RevoluteJoint>(axle);
  }
  scene.join<GearJoint>(
      {.a = {1}, .b = {2}, .radius_a = gear_radius[0], .radius_b = gear_radius[1], .mesh = mesh});
  World world(scene);
  for (int step = 0; step < gear_steps; ++step) world.step(solver);
  return {.driven = world.bodies().velocity[{1}].z(),
          .other = world.bodies().velocity[{2}].z(),
          .tooth = std::abs(world.last_step().problem.impulse.back())};
}

// A18. With the force F between the teeth: tau - F r1 = I1 a1, F r2 = I2 a2, r1 a1 = r2 a2.
ValidationResult wheels_in_mesh(const EngineMaker&) {
  const double ratio = gear_radius[0] / gear_radius[1], time = gear_steps * standard_dt;
  const double acceleration = gear_torque / (gear_inertia[0] + gear_inertia[1] * ratio * ratio);
  const std::string any = ": worst of inner and outer teeth and 5 solvers";
  const std::string reason = "20 sweeps of warm start: 1e-9 of it";
  Worst driven = Worst("acceleration of the driven wheel" + any, "rad/s^2")
                     .by("tau / (I1 + I2 (r1/r2)^2)")
                     .since(reason);
  Worst other = Worst("acceleration of the other wheel" + any, "rad/s^2").by("a1 r1/r2").since(reason);
  Worst tooth = Worst("force between the teeth" + any, "N").by("I2 a2 / r2").since(reason);
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const GearJoint::Mesh mesh : {GearJoint::Mesh::external, GearJoint::Mesh::internal}) {
      const GearMotion motion = run_gear(mesh, *make({.iterations = 20}));
      const double sense = mesh == GearJoint::Mesh::external ? -1 : 1;
      driven.add(acceleration, motion.driven / time, 1e-9 * acceleration);
      other.add(acceleration * ratio, sense * motion.other / time, 1e-9 * acceleration);
      const double force = gear_inertia[1] * acceleration * ratio / gear_radius[1];
      tooth.add(force, motion.tooth / standard_dt, 1e-9 * force);
    }
  }
  return {.numbers = {driven.number(), other.number(), tooth.number()}};
}

const double spring_length = 2, spring_mass = 3, spring_stretch = 0.25;  // [m], [kg], [m] at the start

/// The largest error of ten steps of a bob on a spring of 3 Hz, in epsilon times the number of steps; of
/// stretch [m] and of speed over w [m].
template <Scalar Real>
double spring_error(double zeta) {
  Scene scene;
  const Vec2<double> place(0, -spring_length - spring_stretch);
  const BodyId bob = scene.add(small_body(place, spring_mass));
  scene.join<DistanceJoint>({.a = ground,
                             .b = bob,
                             .anchor_a = {0, 0},
                             .anchor_b = place,
                             .length = spring_length,
                             .kind = DistanceJoint::Kind::spring,
                             .softness = SwingSoftness{.frequency = 3, .damping_ratio = zeta}});
  World<Real> world(scene);
  SequentialImpulse<Real> solver({.iterations = 1});
  const Real h = static_cast<Real>(standard_dt), w = 2 * std::numbers::pi_v<Real> * 3;
  Real x = static_cast<Real>(spring_stretch), v = 0, largest = 0;
  for (int step = 1; step <= 10; ++step) {
    world.step(solver);
    swing_step(x, v, h, w, static_cast<Real>(zeta), static_cast<Real>(standard_gravity));
    const Real stretch = world.bodies().pose[{1}].position.norm() - static_cast<Real>(spring_length);
    const Real speed = -world.bodies().velocity[{1}].y();
    const Real error = std::max(std::abs(stretch - x), std::abs(speed - v) / w);
    const Real epsilons = error / (std::numeric_limits<Real>::epsilon() * static_cast<Real>(step));
    if (!(epsilons <= largest)) largest = epsilons;
  }
  return static_cast<double>(largest);
}

template <Scalar Real>
Measured spring_number(const std::string& scalar) {
  Worst worst = Worst("error of 10 steps in " + scalar +
                          ", in epsilon a step: worst of stretch, speed / w, zeta = 0, 0.5, 2",
                      "m")
                    .by("v' = (v (1 + b s - (1 - p) q) + h g - h w^2 x) / (1 + a s + p q)")
                    .since("64 roundings a step of lengths of 2 m");
  for (const double zeta : {0.0, 0.5, 2.0}) worst.add(0, spring_error<Real>(zeta), 64);
  return worst.number();
}

// A19. The formula of swing_step(), with s = (w h)^2 and q = 2 zeta w h.
ValidationResult spring_step_by_step(const EngineMaker&) {
  return {.numbers = {spring_number<float>("float"), spring_number<double>("double")}};
}

}  // namespace

void add_joint_row_cases(ValidationCases& cases) {
  cases.push_back({"A17",
                   "A rope on 2, 3 or 4 bodies pulls with sum r_i g / sum (r_i^2 / m_i) after one sweep",
                   "derived", Asks::cairn, rope_on_many_bodies});
  cases.push_back({"A18", "A driven wheel in mesh with another accelerates with tau / (I1 + I2 (r1 / r2)^2)",
                   "derived", Asks::cairn, wheels_in_mesh});
  cases.push_back(
      {"A19", "A spring moves its bob exactly as a damped oscillator that is taken in the middle of the step",
       "N. Newmark, 1959; derived", Asks::cairn, spring_step_by_step});
}

}  // namespace cairn
