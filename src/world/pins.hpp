// Floor 5. Joints that are nothing but a pin, of which a scene may have thousands: by their data alone.
#pragma once

#include <cstdint>
#include <optional>

#include "constraints/stabilization.hpp"
#include "math/list.hpp"
#include "world/scene.hpp"

namespace cairn {

/// What the rows of a pin are written from.
struct Pin {
  BodyId a = {};                  // the first body
  BodyId b = {};                  // the second body
  Vec2<double> local_a = {0, 0};  // [m] the anchor in the frame of a
  Vec2<double> local_b = {0, 0};  // [m]
  std::uint64_t source = 0;       // of its rows: RowKey::source
};

/// The pins of a scene.
struct Pins {
  List<std::optional<Pin>> of_joint = {};  // for each joint; none: it is something else
  List<BodyId> bodies = {};                // that they hold, each once
};

/// How errors of pins go, which all pins on the same spring share.
template <Scalar Real>
struct PinRules {
  RowRule<Real> now = {};    // in the pass that rows are written for
  RowRule<Real> again = {};  // in the second solve
};

/// Revolute joints without motor and limits.
Pins find_pins(const Scene& scene);

}  // namespace cairn
