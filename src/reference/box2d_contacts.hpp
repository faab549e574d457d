// Floor 7. What Box2D reports of its contacts while it steps, collected for a snapshot.
#pragma once

#include <box2d/b2_contact.h>
#include <box2d/b2_world_callbacks.h>

#include <map>
#include <utility>

#include <cairn/world/scene.hpp>
#include <cairn/world/snapshot.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Hears of every contact before and after it is solved. Box2D's own manifolds would not do: their points
/// move on with the bodies, and their impulses leave out what continuous collision adds.
class Box2DContacts final : public b2ContactListener {
 public:
  /// Of this scene's surfaces.
  explicit Box2DContacts(const Scene& scene);

  /// Forgets that contacts were new. Those that Box2D does not report in this step, because their bodies
  /// sleep, stay as they are.
  void begin_step();

  /// Forgets the contact.
  void EndContact(b2Contact* contact) override;
  /// Notes where its points are before they are solved, and tells Box2D what surfaces are like.
  void PreSolve(b2Contact* contact, const b2Manifold* old_manifold) override;
  /// Adds the impulses [N s] that it was given.
  void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override;

  /// Ordered by colliders. `colliders` names each one's body.
  List<SnapshotContact> contacts(const List<BodyId>& colliders) const;

 private:
  struct Point {
    uint32 id = 0;  // Box2D's name of the features that touch
    SnapshotContact contact = {};
  };
  struct Touching {
    int step = 0;
    List<Point> points = {};
  };
  struct Surface {
    BodyId body = {};
    Material material = {};
  };
  using Parts = std::pair<int, int>;  // of shapes: most_box2d_parts numbers for each collider

  void describe(b2Contact& contact, const Parts& parts) const;
  static Parts parts_of(const b2Contact& contact);

  List<Surface> surfaces_;  // of each collider
  Mixing mixing_;
  int step_ = 0;
  std::map<Parts, Touching> touching_;
};

}  // namespace cairn
