// Which body is at a point.
#pragma once

#include <optional>

#include <cairn/world/snapshot.hpp>

namespace cairn::playground {

/// The body that can move and has a shape at the point, or no farther away than `near` [m], if there is one.
/// Those that have the point in them come first.
std::optional<BodyId> movable_body_at(const Snapshot& snapshot, const Vec2<double>& point, double near);
/// The same; where there is none, a body that cannot move, but for the ground.
std::optional<BodyId> body_at(const Snapshot& snapshot, const Vec2<double>& point, double near);

}  // namespace cairn::playground
