// Floor 9. Whether the bodies of a scene keep their places once they have settled in them.
#pragma once

#include <cairn/world/snapshot.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// The place of a body is where its centre of mass is once the scene has settled: slop lets boxes sink a
/// little, and the skin of Box2D's shapes lifts each of them. A scene stands while no dynamic body is farther
/// from its place than `distance`, aside or down. Two things are bounded by half the body's bounding radius
/// instead (by `distance`, where that is more): its way from the start while the scene settles, and how far
/// it is lifted, against gravity. What rises does not fall, and shows as a gain of energy; Box2D's towers go
/// on rising for ten seconds. Toppling over its farthest corner by 2 asin(1/4) = 29 degrees moves a body by
/// half its radius: what falls while it settles has not stood.
class Standing {
 public:
  /// `distance` [m]; `settle_seconds` after the start the places are taken.
  Standing(const Snapshot& start, double distance, double settle_seconds);
  /// Of the way that a dynamic body may be from its place, the largest share that one is at this time [s]:
  /// above 1, the scene does not stand. To be asked of every step, in their order.
  double share(const Snapshot& now, double time);

 private:
  double share(const SnapshotBody& body, const Vec2<double>& gravity, BodyId id) const;

  double distance_;                      // [m]
  double settle_seconds_;                // [s]
  bool settled_ = false;                 // places_ are those after settling
  PerBody<Vec2<double>> places_ = {};    // [m]
  PerBody<double> wide_distances_ = {};  // [m] while settling, and upwards
};

}  // namespace cairn
