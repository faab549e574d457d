// Floor 7. From Box2D's contacts to Cairn's conventions.
#include "reference/box2d_contacts.hpp"
#include "math/list.hpp"

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>

#include <algorithm>

namespace cairn {

namespace {

/// How far Box2D's surface lies outside the scene's [m]: a circle's radius is its own.
double skin(const b2Fixture& fixture) {
  return fixture.GetType() == b2Shape::e_circle ? 0 : static_cast<double>(fixture.GetShape()->m_radius);
}

int collider(const b2Fixture& fixture) {
  return static_cast<int>(const_cast<b2Fixture&>(fixture).GetUserData().pointer);
}

/// Of a chain, its links are numbered on from the chain's own number; other shapes have one child, number 0.
int collider_a(const b2Contact& contact) {
  return collider(*contact.GetFixtureA()) + contact.GetChildIndexA();
}

int collider_b(const b2Contact& contact) {
  return collider(*contact.GetFixtureB()) + contact.GetChildIndexB();
}

bool in_manifold(const b2Manifold& manifold, uint32 id) {
  const auto* end = manifold.points + manifold.pointCount;
  return std::any_of(manifold.points, end, [id](const b2ManifoldPoint& point) { return point.id.key == id; });
}

/// Point i of the manifold, as the bodies stand now; from Box2D's fixture A to B.
SnapshotContact contact_point(const b2Contact& contact, const b2WorldManifold& world, int i) {
  const double skin_a = skin(*contact.GetFixtureA());
  const double skin_b = skin(*contact.GetFixtureB());
  SnapshotContact result;
  result.normal = {world.normal.x, world.normal.y};
  // Box2D's point lies midway between the skins.
  result.position =
      Vec2<double>(world.points[i].x, world.points[i].y) + (skin_b - skin_a) / 2 * result.normal;
  result.separation = static_cast<double>(world.separations[i]) + skin_a + skin_b;
  result.friction = static_cast<double>(contact.GetFriction());
  return result;
}

}  // namespace

Box2DContacts::Colliders Box2DContacts::colliders_of(const b2Contact& contact) {
  return std::minmax({collider_a(contact), collider_b(contact)});
}

void Box2DContacts::begin_step() {
  ++step_;
  for (auto& [colliders, touching] : touching_) {
    for (Point& point : touching.points) point.contact.is_new = false;
  }
}

void Box2DContacts::EndContact(b2Contact* contact) { touching_.erase(colliders_of(*contact)); }

/// Called once when the step begins, and again where continuous collision stops a body within the step: then
/// the points that are known already stay where they were.
void Box2DContacts::PreSolve(b2Contact* contact, const b2Manifold* old_manifold) {
  Touching& touching = touching_[colliders_of(*contact)];
  if (touching.step != step_) touching = {.step = step_};
  b2WorldManifold world;
  contact->GetWorldManifold(&world);
  const b2Manifold& manifold = *contact->GetManifold();
  const bool swapped = collider_a(*contact) > collider_b(*contact);
  for (int i = 0; i < manifold.pointCount; ++i) {
    const uint32 id = manifold.points[i].id.key;
    const bool known = std::any_of(touching.points.begin(), touching.points.end(),
                                   [id](const Point& point) { return point.id == id; });
    if (known) continue;
    Point point{.id = id, .contact = contact_point(*contact, world, i)};
    if (swapped) point.contact.normal = -point.contact.normal;
    point.contact.is_new = !in_manifold(*old_manifold, id);
    touching.points.push_back(point);
  }
}

/// Exchanging a and b turns the normal, the tangent and the impulse around: the two numbers stay.
void Box2DContacts::PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) {
  const b2Manifold& manifold = *contact->GetManifold();
  for (Point& point : touching_[colliders_of(*contact)].points) {
    for (int i = 0; i < impulse->count; ++i) {
      if (manifold.points[i].id.key != point.id) continue;
      point.contact.normal_impulse += static_cast<double>(impulse->normalImpulses[i]);
      point.contact.friction_impulse += static_cast<double>(impulse->tangentImpulses[i]);
    }
  }
}

List<SnapshotContact> Box2DContacts::contacts(const List<BodyId>& colliders) const {
  List<SnapshotContact> result;
  for (const auto& [pair, touching] : touching_) {
    for (const Point& point : touching.points) {
      result.push_back(point.contact);
      result.back().a = colliders[pair.first];
      result.back().b = colliders[pair.second];
    }
  }
  return result;
}

}  // namespace cairn
