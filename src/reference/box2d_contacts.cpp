// Floor 7. From Box2D's contacts to Cairn's conventions.
#include <cairn/reference/box2d_contacts.hpp>
#include <cairn/math/list.hpp>
#include <cairn/reference/box2d_shapes.hpp>

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>

#include <algorithm>

namespace cairn {

namespace {

int part_number(const b2Fixture& fixture) {
  return static_cast<int>(const_cast<b2Fixture&>(fixture).GetUserData().pointer);
}

/// How far Box2D's surface lies outside the scene's [m]: a circle's radius is its own, and the middle of a
/// capsule lies inside.
double skin(const b2Fixture& fixture) {
  if (fixture.GetType() == b2Shape::e_circle) return 0;
  const bool is_middle = part_number(fixture) % most_box2d_parts != 0;
  return is_middle ? -capsule_middle_depth : static_cast<double>(fixture.GetShape()->m_radius);
}

/// Of a chain, its links are numbered on from the chain's own number; other shapes have one child, number 0.
int part_a(const b2Contact& contact) {
  return part_number(*contact.GetFixtureA()) + most_box2d_parts * contact.GetChildIndexA();
}

int part_b(const b2Contact& contact) {
  return part_number(*contact.GetFixtureB()) + most_box2d_parts * contact.GetChildIndexB();
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

Box2DContacts::Parts Box2DContacts::parts_of(const b2Contact& contact) {
  return std::minmax({part_a(contact), part_b(contact)});
}

Box2DContacts::Box2DContacts(const Scene& scene) : mixing_(scene.settings().mixing) {
  for (const BodyId id : scene.bodies().indices()) {
    const BodySpec& spec = scene.bodies()[id].spec;
    for (const Shape<double>& shape : spec.shapes)
      surfaces_.resize(surfaces_.size() + piece_count(shape), {id, spec.material});
  }
}

/// Box2D asks anew in every step; friction and restitution by its own rules it has from its fixtures.
void Box2DContacts::describe(b2Contact& contact, const Parts& parts) const {
  const Surface& a = surfaces_[parts.first / most_box2d_parts];
  const Surface& b = surfaces_[parts.second / most_box2d_parts];
  contact.SetTangentSpeed(static_cast<float>(a.material.surface_speed + b.material.surface_speed));
  if (mixing_.is_usual()) return;
  const PairSurface surface = mixed(mixing_, a.body, a.material, b.body, b.material);
  contact.SetFriction(static_cast<float>(surface.friction));
  contact.SetRestitution(static_cast<float>(surface.restitution));
}

void Box2DContacts::begin_step() {
  ++step_;
  for (auto& [parts, touching] : touching_) {
    for (Point& point : touching.points) point.contact.is_new = false;
  }
}

void Box2DContacts::EndContact(b2Contact* contact) { touching_.erase(parts_of(*contact)); }

/// Called once when the step begins, and again where continuous collision stops a body within the step: then
/// the points that are known already stay where they were.
void Box2DContacts::PreSolve(b2Contact* contact, const b2Manifold* old_manifold) {
  const Parts parts = parts_of(*contact);
  describe(*contact, parts);
  Touching& touching = touching_[parts];
  if (touching.step != step_) touching = {.step = step_};
  b2WorldManifold world;
  contact->GetWorldManifold(&world);
  const b2Manifold& manifold = *contact->GetManifold();
  const bool swapped = part_a(*contact) > part_b(*contact);
  for (int i = 0; i < manifold.pointCount; ++i) {
    const uint32 id = manifold.points[i].id.key;
    const bool known = std::any_of(touching.points.begin(), touching.points.end(),
                                   [id](const Point& point) { return point.id == id; });
    if (known) continue;
    Point point{.id = id, .contact = contact_point(*contact, world, i)};
    if (swapped) point.contact.normal = -point.contact.normal;
    point.contact.is_new = !in_manifold(*old_manifold, id);
    point.contact.feature = id;
    touching.points.push_back(point);
  }
}

/// Exchanging a and b turns the normal, the tangent and the impulse around: the two numbers stay.
void Box2DContacts::PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) {
  const b2Manifold& manifold = *contact->GetManifold();
  for (Point& point : touching_[parts_of(*contact)].points) {
    for (int i = 0; i < impulse->count; ++i) {
      if (manifold.points[i].id.key != point.id) continue;
      point.contact.normal_impulse += static_cast<double>(impulse->normalImpulses[i]);
      point.contact.friction_impulse += static_cast<double>(impulse->tangentImpulses[i]);
    }
  }
}

List<SnapshotContact> Box2DContacts::contacts(const List<BodyId>& colliders) const {
  List<SnapshotContact> result;
  for (const auto& [parts, touching] : touching_) {
    for (const Point& point : touching.points) {
      result.push_back(point.contact);
      result.back().a = colliders[parts.first / most_box2d_parts];
      result.back().b = colliders[parts.second / most_box2d_parts];
    }
  }
  return result;
}

}  // namespace cairn
