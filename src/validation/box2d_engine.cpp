// Floor 8. Box2D 2.4.1 as an engine that cases can ask.
#include <cairn/validation/box2d_engine.hpp>

#ifdef CAIRN_HAVE_BOX2D
#include <cairn/reference/box2d_world.hpp>
#endif

namespace cairn {

#ifdef CAIRN_HAVE_BOX2D

namespace {

class Box2DEngine final : public Engine {
 public:
  Box2DEngine(const Scene& scene, int iterations) : world_(scene, {.velocity_iterations = iterations}) {}
  void step() override { world_.step(); }
  Snapshot snapshot() const override { return world_.snapshot(); }

 private:
  Box2DWorld world_;
};

}  // namespace

EngineMaker box2d_engine() {
  return [](const Scene& scene, int iterations) { return std::make_unique<Box2DEngine>(scene, iterations); };
}

#else

EngineMaker box2d_engine() { return {}; }

#endif

}  // namespace cairn
