// Floor 5. Finds pins.
#include "world/pins.hpp"

#include <algorithm>

#include "constraints/revolute_joint.hpp"

namespace cairn {

Pins find_pins(const Scene& scene) {
  Pins pins;
  for (int i = 0; i < scene.joints().size(); ++i) {
    pins.of_joint.push_back(std::nullopt);
    const auto* revolute = dynamic_cast<const RevoluteJoint*>(scene.joints()[i].get());
    if (revolute == nullptr || !revolute->is_free()) continue;
    const JointEnds& ends = revolute->ends();
    const auto source = static_cast<std::uint64_t>(scene.joint_id(i).index);
    pins.of_joint.back() = {ends.a, ends.b, ends.local_a, ends.local_b, source};
    pins.bodies.push_back(ends.a);
    pins.bodies.push_back(ends.b);
  }
  std::sort(pins.bodies.begin(), pins.bodies.end());
  pins.bodies.erase(std::unique(pins.bodies.begin(), pins.bodies.end()), pins.bodies.end());
  return pins;
}

}  // namespace cairn
