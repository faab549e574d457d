// Floor 5. What a world has from its scene alone.
#pragma once

#include <memory>

#include <cairn/math/list.hpp>
#include <cairn/world/acting.hpp>
#include <cairn/world/body_kinds.hpp>
#include <cairn/world/collider.hpp>
#include <cairn/world/plan.hpp>
#include <cairn/world/scene.hpp>

namespace cairn {

/// A scene and what follows from it. Nothing of it moves: worlds that were copied share it.
template <Scalar Real>
struct Model {
  std::shared_ptr<const Scene> scene = {};                     // that the others are of
  std::shared_ptr<const Plan> plan = {};                       // of its steps
  std::shared_ptr<const List<Collider<Real>>> colliders = {};  // the pieces of its shapes
  std::shared_ptr<const BodyKinds<Real>> kinds = {};           // of its bodies
  std::shared_ptr<const Acting<Real>> acting = {};             // null: nothing else acts on bodies
};

/// @throws std::invalid_argument as World.
template <Scalar Real>
Model<Real> make_model(Scene scene);

/// That of the same scene with other events, as a step makes them: the plan stays what it was.
template <Scalar Real>
Model<Real> with_events_of(Scene scene, Model<Real> model);

}  // namespace cairn
