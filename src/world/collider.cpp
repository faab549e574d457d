// Floor 5. The pieces in which a scene's shapes collide.
#include <cairn/world/collider.hpp>

#include <map>
#include <unordered_map>
#include <utility>

#include <cairn/geometry/aabb.hpp>

namespace cairn {
namespace {

/// [m] Of what is around the shape's core.
template <Scalar Real>
Real core_radius(const Shape<Real>& shape) {
  const auto radius = [](const auto& held) -> Real {
    if constexpr (requires { held.radius; }) return held.radius;
    return 0;
  };
  return std::visit(radius, shape);
}

template <Scalar Real>
void set_around(Collider<Real>& collider, const Neighbours<double>& around) {
  ColliderForm<Real> form = *collider.form;
  form.around = std::make_shared<const Neighbours<Real>>(neighbours_cast<Real>(around));
  collider.form = std::make_shared<const ColliderForm<Real>>(form);
}

/// Makes colliders, and one form for all that have the same shape.
template <Scalar Real>
class ColliderMaker {
 public:
  void add(BodyId body, const Shape<double>& shape) {
    auto& form = known_sources_[&shape];  // bodies that are alike share their shapes
    if (!form) form = shared(shape_cast<Real>(shape));
    colliders.push_back({.body = body, .form = form});
  }
  void add_links(BodyId body, const Chain<double>& chain) {
    const Shape<Real> cast = shape_cast<Real>(chain);
    const Chain<Real>& points = std::get<Chain<Real>>(cast);
    for (int i = 0; i < points.link_count(); ++i) {
      colliders.push_back(
          {.body = body, .form = shared(Segment<Real>{points.point(i), points.point(i + 1)})});
      set_around(colliders.back(), link_neighbours(chain, i));
    }
  }

  List<Collider<Real>> colliders = {};

 private:
  using Form = ColliderForm<Real>;

  std::shared_ptr<const Form> shared(const Shape<Real>& shape) {
    const Real radius = bounding_radius(shape);
    auto [next, end] = known_.equal_range(radius);
    for (; next != end; ++next) {
      if (*next->second->shape == shape) return next->second;
    }
    const Form form = {radius, core_radius(shape), std::make_shared<const Shape<Real>>(shape)};
    return known_.emplace(radius, std::make_shared<const Form>(form))->second;
  }

  std::multimap<Real, std::shared_ptr<const Form>> known_;  // by the radius around them
  std::unordered_map<const Shape<double>*, std::shared_ptr<const Form>> known_sources_;
};

/// Numbers for bodies that nothing pushes: static ones that collide with the same bodies have the same one.
/// Sensors, bodies that a joint keeps apart from others, and what moves have one of their own.
class Groups {
 public:
  explicit Groups(const Scene& scene) : alone_(scene.bodies().size(), 0) {
    for (const auto& [a, b] : scene.joints().apart()) alone_[a] = alone_[b] = 1;
  }
  int of(BodyId id, const BodySpec& spec) {
    if (spec.sensor || alone_[id] || spec.type != BodyType::static_body) return -1 - id.index;
    return groups_
        .insert({{spec.filter.category, spec.filter.collides_with}, static_cast<int>(groups_.size())})
        .first->second;
  }

 private:
  PerBody<char> alone_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> groups_;
};

template <Scalar Real>
void set_neighbours(const Scene& scene, List<Collider<Real>>& colliders) {
  Groups groups(scene);
  List<StillShape> still;
  List<int> places;  // of their colliders
  int next = 0;
  for (const BodyId id : scene.bodies().indices()) {
    const SceneBody& body = scene.bodies()[id];
    for (const Shape<double>& shape : body.spec.shapes) {
      const bool is_still =
          body.spec.type != BodyType::dynamic && !std::holds_alternative<Chain<double>>(shape);
      if (is_piece(shape) || is_still) {
        still.push_back({&shape, body.pose, groups.of(id, body.spec)});
        places.push_back(next);
      }
      next += piece_count(shape);
    }
  }
  const List<std::optional<Neighbours<double>>> found = find_neighbours(still);
  for (const int i : found.indices()) {
    if (found[i]) set_around(colliders[places[i]], *found[i]);
  }
}

}  // namespace

template <Scalar Real>
List<Collider<Real>> make_colliders(const Scene& scene) {
  ColliderMaker<Real> maker;
  maker.colliders.reserve(scene.bodies().size());  // mostly of a shape each
  for (const BodyId id : scene.bodies().indices()) {
    for (const Shape<double>& shape : scene.bodies()[id].spec.shapes) {
      if (const auto* chain = std::get_if<Chain<double>>(&shape)) {
        maker.add_links(id, *chain);
      } else {
        maker.add(id, shape);
      }
    }
  }
  set_neighbours(scene, maker.colliders);
  return std::move(maker.colliders);
}

template List<Collider<float>> make_colliders(const Scene&);
template List<Collider<double>> make_colliders(const Scene&);

}  // namespace cairn
