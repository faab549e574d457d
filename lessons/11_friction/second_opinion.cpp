// Lesson 11. The same slope in Box2D, where this build has it.
#include "lesson.hpp"

#ifdef CAIRN_HAVE_BOX2D
#include <cairn/reference/box2d_world.hpp>
#endif

namespace cairn::friction {

#ifdef CAIRN_HAVE_BOX2D

bool has_box2d() { return true; }

List<Snapshot> box2d_run(const Scene& scene, int steps, int sweeps) {
  Box2DWorld world(scene, {.velocity_iterations = sweeps});
  List<Snapshot> frames = {world.snapshot()};
  for (int step = 1; step <= steps; ++step) {
    world.step();
    frames.push_back(world.snapshot());
  }
  return frames;
}

#else

bool has_box2d() { return false; }

List<Snapshot> box2d_run(const Scene&, int, int) {
  throw std::logic_error("box2d_run: this build has no Box2D");
}

#endif

}  // namespace cairn::friction
