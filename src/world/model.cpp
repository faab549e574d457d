// Floor 5. From a scene to what its steps use, and what of it is refused.
#include <cairn/world/model.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <cairn/geometry/aabb.hpp>
#include <cairn/math/check.hpp>

namespace cairn {

namespace {

// Of the smallest shape of a body: what it may sink in at most, whatever the slop. Bodies of 0.1 m and more
// keep the usual slop of 5 mm.
constexpr double slop_share = 0.05;
// Likewise: what is deeper in another has passed half of the way to its middle.
constexpr double failed_share = 0.25;

/// [m] the longer side of the box around a shape.
double extent(const Shape<double>& shape) {
  const Aabb<double> box = bounding_box(shape, Pose<double>{});
  return (box.upper - box.lower).maxCoeff();
}

template <Scalar Real>
void require_number(double value, BodyId id, const char* field) {
  if (std::isfinite(static_cast<Real>(value))) return;
  require(false, "World", field + (" of body " + std::to_string(id.index)), "a number of its scalar type",
          value);
}

/// A body no longer than the distance of neighbouring numbers cannot touch anything in earnest. `smallest` is
/// the extent of its smallest shape [m].
template <Scalar Real>
void require_place(const SceneBody& body, BodyId id, double smallest) {
  for (int axis = 0; axis < 2; ++axis) {
    const double place = body.pose.position[axis];
    require_number<Real>(place, id, "position");
    require_number<Real>(body.spec.velocity[axis], id, "velocity");
    const Real at = static_cast<Real>(std::abs(place));
    const double step = static_cast<double>(std::nextafter(at, std::numeric_limits<Real>::infinity()) - at);
    if (step < smallest) continue;
    require(false, "World", "position of body " + std::to_string(id.index),
            "nearer to the origin in this scalar type, for a shape of " + shortest(smallest) + " m", place);
  }
  require_number<Real>(body.pose.angle, id, "angle");
  require_number<Real>(body.spec.angular_velocity, id, "angular_velocity");
}

/// [m] Infinite without shapes. Pieces of an outline are one shape, into however many it was cut.
double smallest_extent(const BodySpec& spec) {
  const double infinity = std::numeric_limits<double>::infinity();
  double smallest = infinity;
  Aabb<double> pieces = {.lower = {infinity, infinity}, .upper = {-infinity, -infinity}};
  for (const Shape<double>& shape : spec.shapes) {
    if (!is_piece(shape)) {
      smallest = std::min(smallest, extent(shape));
      continue;
    }
    const Aabb<double> box = bounding_box(shape, Pose<double>{});
    pieces.lower = pieces.lower.cwiseMin(box.lower);
    pieces.upper = pieces.upper.cwiseMax(box.upper);
  }
  const double whole = (pieces.upper - pieces.lower).maxCoeff();
  return whole > 0 ? std::min(smallest, whole) : smallest;
}

/// Springs that give way to a weight by half the length of a body let it through.
void require_springs_hold(const SceneSettings& settings, const SceneBody& body, BodyId id, double smallest) {
  const Stabilization& stabilization = settings.stabilization;
  const bool on_springs = stabilization.policy == StabilizationPolicy::soft;
  if (!on_springs || body.spec.type != BodyType::dynamic) return;
  const double weight = std::abs(body.spec.gravity_scale) * settings.gravity.norm();  // [N/kg]
  const double sag = spring_sag(stabilization.soft, settings.dt / settings.substeps, weight);
  if (sag < smallest / 2) return;
  require(false, "World", "stabilization.soft",
          "stiffer, or substeps shorter, for body " + std::to_string(id.index) + " of " + shortest(smallest) +
              " m, into which springs may give way by less than half",
          shortest(sag) + " m");
}

template <Scalar Real>
BodyForces<Real> forces_on(const BodySpec& spec) {
  return {.gravity_scale = static_cast<Real>(spec.gravity_scale),
          .linear_damping = static_cast<Real>(spec.damping.linear),
          .angular_damping = static_cast<Real>(spec.damping.angular)};
}

template <Scalar Real>
BodyTraits<Real> traits_of(const BodySpec& spec, double smallest, Real radius) {
  return {.slop_limit = static_cast<Real>(slop_share * smallest),
          .failed_error = static_cast<Real>(failed_share * smallest),
          .friction_root = std::sqrt(spec.material.friction),
          .surface_speed = static_cast<Real>(spec.material.surface_speed),
          .rolling_resistance = static_cast<Real>(spec.material.rolling_resistance),
          .radius = radius};
}

template <Scalar Real>
BodyKinds<Real> make_kinds(const Scene& scene, const Plan& plan, const List<Collider<Real>>& colliders) {
  PerBody<Real> radius(scene.bodies().size());
  for (const Collider<Real>& collider : colliders)
    radius[collider.body] = std::max(radius[collider.body], collider.form->radius);
  BodyKinds<Real> kinds;
  const Shape<double>* measured = nullptr;  // bodies that are alike share their shapes
  double smallest = smallest_extent({});    // of these shapes
  for (const BodyId id : scene.bodies().indices()) {
    const SceneBody& body = scene.bodies()[id];
    const BodySpec& spec = body.spec;
    if (spec.shapes.data() != measured) smallest = smallest_extent(spec);
    measured = spec.shapes.data();
    require_place<Real>(body, id, smallest);
    if (plan.collision) require_springs_hold(scene.settings(), body, id, smallest);
    kinds.add(forces_on<Real>(spec), traits_of(spec, smallest, radius[id]));
  }
  return kinds;
}

}  // namespace

template <Scalar Real>
Model<Real> make_model(Scene its_scene) {
  const auto scene = std::make_shared<const Scene>(std::move(its_scene));
  const auto plan = std::make_shared<const Plan>(make_plan(*scene));
  const auto colliders = std::make_shared<const List<Collider<Real>>>(make_colliders<Real>(*scene));
  const auto kinds = std::make_shared<const BodyKinds<Real>>(make_kinds(*scene, *plan, *colliders));
  const auto acting =
      Acting<Real>::is_needed(*scene) ? std::make_shared<const Acting<Real>>(*scene) : nullptr;
  return {scene, plan, colliders, kinds, acting};
}

template <Scalar Real>
Model<Real> with_events_of(Scene scene, Model<Real> model) {
  model.scene = std::make_shared<const Scene>(std::move(scene));
  if (model.acting) model.acting = std::make_shared<const Acting<Real>>(*model.scene);
  return model;
}

template Model<float> make_model(Scene);
template Model<double> make_model(Scene);
template Model<float> with_events_of(Scene, Model<float>);
template Model<double> with_events_of(Scene, Model<double>);

}  // namespace cairn
