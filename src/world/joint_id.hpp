// Floor 5. What names a joint of a scene.
#pragma once

#include <compare>

namespace cairn {

/// A joint, for as long as it is in its scene; its number is not used again.
struct JointId {
  int index = 0;  // from 0, in the order of adding
  /// By index.
  auto operator<=>(const JointId&) const = default;
};

}  // namespace cairn
