// Floor 6. Energy and momentum of a snapshot.
#pragma once

#include <cairn/world/snapshot.hpp>

namespace cairn {

/// sum (m |v|^2 + I w^2) / 2 [J] over the dynamic bodies.
double kinetic_energy(const Snapshot& snapshot);

/// That of one body.
double kinetic_energy(const SnapshotBody& body);

/// -sum m s g . x + sum k C^2 / 2 [J] with the gravity scale s of each body and the springs of joints: 0 with
/// all centres of mass at the origin and all springs at rest. Attractions and the water that bodies displace
/// have theirs.
double potential_energy(const Snapshot& snapshot);

/// Kinetic and potential [J].
double total_energy(const Snapshot& snapshot);

/// sum (m v) in x and y [N s], and the angular momentum about the world's origin, sum (I w + x x m v) [N m
/// s].
Vec3<double> momentum(const Snapshot& snapshot);

}  // namespace cairn
