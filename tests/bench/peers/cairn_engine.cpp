// Cairn behind the interface of its peers, and what adapters ask of a joint.
#include <algorithm>

#include "constraints/revolute_joint.hpp"
#include "engine.hpp"
#include "math/check.hpp"
#include "scenes/solver_list.hpp"
#include "world/world.hpp"

namespace cairn::bench {

namespace {

class CairnEngine final : public Engine {
 public:
  CairnEngine(const Scene& scene, const Setting& setting)
      : world_(scene), solver_(make_solver<double>(setting.solver, setting.sweeps)) {}
  void step() override { world_.step(*solver_); }
  PerBody<Pose<double>> poses() const override { return world_.bodies().pose; }
  PerBody<Vec3<double>> velocities() const override { return world_.bodies().velocity; }

 private:
  World<double> world_;
  std::unique_ptr<Solver<double>> solver_;
};

}  // namespace

std::unique_ptr<Engine> make_cairn(const Scene& scene, const Setting& setting) {
  check(setting);
  Scene prepared = scene;
  prepared.set_settings(with_setting(scene.settings(), setting));
  return std::make_unique<CairnEngine>(prepared, setting);
}

const RevoluteJoint& require_pin(const Constraint& joint, const std::string& engine) {
  const auto* pin = dynamic_cast<const RevoluteJoint*>(&joint);
  require(pin != nullptr && pin->is_free(), engine.c_str(), "joint", "a pin without limits and motor",
          joint.name());
  return *pin;
}

bool keeps_apart(const Scene& scene, const Constraint& joint) {
  const List<Attachment> ends = joint.attachments();
  return std::binary_search(scene.apart().begin(), scene.apart().end(),
                            std::pair<BodyId, BodyId>(std::minmax(ends.front().body, ends.back().body)));
}

}  // namespace cairn::bench
