// Lesson 00. In the plane a body is three numbers, x, y and an angle, and v of (1) says how fast they change.
// A step of semi-implicit Euler changes v first, by (12), and then moves the body with the
// new v. A box is thrown and nothing touches it, so we know where it should be: on a parabola. We fly it
// three times, with the library, with the same two lines by hand, and with the two lines swapped (explicit
// Euler), and look how far from the parabola each ends. Then the two orders on a spring.
#include "lesson.hpp"

namespace {

using namespace cairn;
using namespace cairn::one_body;

/// Nothing but the box: no ground to hit, so that all we see is the integrator.
World<double> thrown_box(const Throw& thrown) {
  Scene scene({.gravity = {0, -thrown.gravity}, .dt = thrown.dt});
  scene.add({.shapes = {box(1, 1)},
             .position = thrown.start,
             .velocity = thrown.velocity.head<2>(),
             .angular_velocity = thrown.velocity.z(),
             .mass = 1});
  return World(std::move(scene));
}

Flight fly(const Throw& thrown) {
  World<double> world = thrown_box(thrown);
  SequentialImpulse<double> solver;  // has no rows to solve here
  const Vec2<double> gravity(0, -thrown.gravity);
  const double dt = thrown.dt;
  Particle semi_implicit = {thrown.start, thrown.velocity.head<2>()};
  Particle explicit_euler = semi_implicit;
  Flight flight = {.thrown = thrown, .inverse_mass = world.bodies().inverse_mass[{1}]};
  record(flight, world, semi_implicit, explicit_euler);
  for (int step = 1; step <= thrown.steps; ++step) {
    semi_implicit.velocity += gravity * dt;                 // (12) first the velocity,
    semi_implicit.position += semi_implicit.velocity * dt;  // then the position, with the new velocity

    explicit_euler.position += explicit_euler.velocity * dt;  // the other order: with the old velocity
    explicit_euler.velocity += gravity * dt;

    world.step(solver);  // the library: the first two lines again, for x, y and the angle of every body
    record(flight, world, semi_implicit, explicit_euler);
  }
  return flight;
}

void run(Lesson& lesson) {
  Throw thrown = {.gravity = lesson.real("gravity"), .dt = lesson.real("dt"), .steps = lesson.whole("steps")};
  thrown.velocity.z() = lesson.real("spin");
  const Flight flight = fly(thrown);
  const Springs springs = swing(thrown.dt);

  lesson.predict();
  tell_springs(lesson, springs);
  lesson.answer({swing_at_end(springs.explicit_euler)}, 1,
                fmt::format("Each step multiplies the swing by √(1 + (4π Δt)²), and there are many of them. "
                            "(At 2 s the box is at {} m, and not yet at its turning point.)",
                            fixed(springs.explicit_euler.x.back(), 1)));
  tell_scene(lesson, flight);
  tell_steps(lesson, flight);
  check_claims(lesson, flight);
  check_springs(lesson, springs);
  lesson.data(table_of(flight));
  lesson.fingerprint(flight.cairn.back());
  if (lesson.draws()) lesson.print("Pictures are drawn offscreen by " + Canvas(64, 64).backend() + ".");
  lesson.film(pictures({flight, springs}));
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(card(), run, argc, argv); }
