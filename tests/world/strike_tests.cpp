// What strikes springs.
#include "testing.hpp"

using namespace cairn;

namespace {

Scene bullet(StabilizationPolicy policy, double speed, const Shape<double>& shape) {
  SceneSettings settings{.gravity = {0, 0}};
  settings.stabilization.policy = policy;
  Scene scene(settings);
  scene.add({.type = BodyType::static_body, .shapes = {box(0.1, 4)}});
  scene.add({.shapes = {shape}, .position = {-3.3, 0.1}, .velocity = {speed, 0}});
  return scene;
}

}  // namespace

TEST_CASE("a bullet whose step ends at the touch is stopped there by the next, on springs as on rigid rows") {
  for (const StabilizationPolicy policy : {StabilizationPolicy::soft, StabilizationPolicy::relaxed}) {
    for (const double speed : {10.0, 1e3, 1e5}) {
      for (const Shape<double>& shape : {Shape<double>(circle(0.1)), Shape<double>(box(0.2, 0.2))}) {
        World<double> world(bullet(policy, speed, shape)), wide_world = world;
        SequentialImpulse<double> solver({.iterations = 10});
        WideSequentialImpulse<double> wide({.iterations = 10});
        double deepest = 0;
        for (int step = 0; step < 40; ++step) {
          world.step(solver);
          wide_world.step(wide);
          deepest = std::max(
              {deepest, worst_penetration(snapshot(world)), worst_penetration(snapshot(wide_world))});
        }
        CAPTURE(speed);
        CHECK(deepest < 1.1 * 0.005);  // [m] the slop and a tenth of it
      }
    }
  }
}
