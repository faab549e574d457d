// Lesson NN. TITLE: two lines on what happens here.
#include "lessons/lesson.hpp"

#include <fmt/format.h>

#include "cairn.hpp"
#include "math/list.hpp"
#include "render/draw.hpp"

namespace {

using namespace cairn;
using render::Page;

// [impulse]
/// (22) times Δt: the impulse [N s] that stops a ball of this mass [kg] that comes down at this speed [m/s].
double impulse_by_hand(double mass, double speed) {
  const double jv = -speed;              // the row points up
  const double inverse_mass = 1 / mass;  // j M⁻¹ jᵀ: the ground gives nothing to it
  return (0 - jv) / inverse_mass;        // ζ is 0
}
// [/impulse]

/// The ball as it touches the ground, and a step later.
struct Landing {
  Snapshot before = {};
  Snapshot after = {};
  double impulse = 0;  // [N s]
};

Landing land(double mass, double speed) {
  Scene scene({.gravity = {0, 0}, .dt = 0.02});
  scene.add_ground();
  scene.add({.shapes = {circle(0.5)}, .position = {0, 0.5}, .velocity = {0, -speed}, .mass = mass});
  World world(scene);
  Landing landing{.before = snapshot(world)};
  SequentialImpulse solver({.iterations = 1});
  world.step(solver);
  landing.after = snapshot(world);
  for (const SnapshotContact& contact : landing.after.contacts) landing.impulse += contact.normal_impulse;
  return landing;
}

/// The scene at the left, words at the right.
void draw(Page& page, const Snapshot& snapshot, const std::string& title, const std::string& text) {
  const List<render::Rect> parts = columns(page.area(), {0.6, 0.4}, page.sizes().gap);
  const render::Camera camera = render::fit(parts[0], {{-2, -0.5}, {2, 2}});
  draw_world(page, camera, snapshot);
  draw_velocities(page, camera, {.pixels_per_unit = 60, .unit = "m/s"}, snapshot);
  page.note(parts[1], title, text);
}

List<Shot> shots_of(const Landing& landing) {
  const std::string impulse = fmt::format("{:g} N s", landing.impulse);
  return {
      {.state = "before",
       .alt = "A ball has just come down on the ground.",
       .draw =
           [landing](Page& page) { draw(page, landing.before, "Predict", "Which impulse stops the ball?"); },
       .key = true},
      {.state = "after",
       .alt = "The ball rests on the ground, which has given it " + impulse + ".",
       .draw = [landing, impulse](Page& page) { draw(page, landing.after, "Answer", impulse + ": m v."); },
       .key = true}};
}

void run(Lesson& lesson) {
  const double mass = lesson.real("mass"), speed = lesson.real("speed");
  lesson.print(fmt::format("Scene: a ball of {:g} kg comes down on the ground at {:g} m/s", mass, speed));
  lesson.predict();
  const Landing landing = land(mass, speed);
  const double by_hand = impulse_by_hand(mass, speed);
  lesson.print(fmt::format("The ground gives {:g} N s; by hand it is {:g} N s.", landing.impulse, by_hand));
  lesson.answer({by_hand}, 0.01 * by_hand, "The row divides the speed by 1/m.");
  // A division, a product and two sums: each rounds by half a unit in the last place.
  lesson.check_equal("the solver's impulse is (22) times Δt (N s)", landing.impulse, by_hand,
                     4 * 2.3e-16 * by_hand);
  lesson.film(shots_of(landing));
  lesson.data({.header = {"mass", "speed", "impulse"}, .rows = {{mass, speed, landing.impulse}}});
  lesson.fingerprint(landing.after);
}

}  // namespace

int main(int argc, char** argv) { return run_lesson(card(), run, argc, argv); }
