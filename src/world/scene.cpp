// Floor 5. Building a scene, and refusing what cannot be simulated.
#include "world/scene.hpp"

#include <algorithm>

#include "geometry/aabb.hpp"
#include "geometry/mass.hpp"
#include "math/check.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

void require_range(double value, double least, const char* place, const char* field, const char* unit) {
  const std::string rule = ">= " + shortest(least) + (*unit ? " " : "") + unit + " and finite";
  require(value >= least && std::isfinite(value), place, field, rule, value);
}

/// Masses and inertias: their inverses must be finite in every scalar type, and products of a few of them
/// too.
void require_weight(double value, const char* field, const char* unit) {
  require(value >= 1e-15 && value <= 1e15, "Scene::add", field, std::string("from 1e-15 to 1e15 ") + unit,
          value);
}

/// Huge coefficients are as good as infinite ones, and infinity times an impulse of 0 has no value.
void require_friction(double value, const char* place) {
  require(value >= 0 && value <= 1e6, place, "friction", "from 0 to 1e6", value);
}

void require_unit_interval(double value, const char* place, const char* field) {
  require(value >= 0 && value <= 1, place, field, "in [0, 1]", value);
}

void check_motion(const BodySpec& spec) {
  require_finite(spec.position, "Scene::add", "position", "m");
  require_finite(spec.angle, "Scene::add", "angle", "rad");
  require_finite(spec.velocity, "Scene::add", "velocity", "m/s");
  require_finite(spec.angular_velocity, "Scene::add", "angular_velocity", "rad/s");
  require_finite(spec.gravity_scale, "Scene::add", "gravity_scale", "");
}

void check_material(const BodySpec& spec) {
  if (spec.mass) require_weight(*spec.mass, "mass", "kg");
  if (spec.inertia) require_weight(*spec.inertia, "inertia", "kg m^2");
  require(spec.density > 0 && std::isfinite(spec.density), "Scene::add", "density", "> 0 kg/m^2 and finite",
          spec.density);
  require_friction(spec.friction, "Scene::add");
  require_unit_interval(spec.restitution, "Scene::add", "restitution");
  require_range(spec.linear_damping, 0, "Scene::add", "linear_damping", "1/s");
  require_range(spec.angular_damping, 0, "Scene::add", "angular_damping", "1/s");
}

/// Makers of shapes refuse bad numbers; a shape written by hand has asked none of them.
void check_shapes(const BodySpec& spec) {
  for (int i = 0; i < spec.shapes.size(); ++i) {
    const Aabb<double> box = bounding_box(spec.shapes[i], Pose<double>{});
    const Vec2<double> size = box.upper - box.lower;
    const bool has_size = size.allFinite() && size.minCoeff() >= 0 && size.maxCoeff() > 0;
    require(has_size, "Scene::add", "size of shapes[" + std::to_string(i) + "]", "> 0 m and finite",
            size.maxCoeff());
  }
}

/// Mass and inertia of a dynamic body from its shapes, unless they are given.
void set_mass(SceneBody& body, const MassProperties& shapes) {
  const BodySpec& spec = body.spec;
  require(shapes.area > 0 || spec.mass.has_value(), "Scene::add", "shapes",
          "of some area for a dynamic body without a mass of its own", shapes.area);
  body.mass = spec.mass.value_or(spec.density * shapes.area);
  require_weight(body.mass, "mass", "kg");
  require(shapes.inertia > 0 || spec.inertia.has_value() || spec.fixed_rotation, "Scene::add", "inertia",
          "given for a dynamic body whose shapes have no area, unless its rotation is fixed", shapes.inertia);
  if (spec.fixed_rotation) return;
  body.inertia = spec.inertia ? *spec.inertia : body.mass * shapes.inertia / shapes.area;
  require_weight(body.inertia, "inertia", "kg m^2");
}

void require_positive(double value, const char* field, const char* unit) {
  require(value > 0 && std::isfinite(value), "Scene", field, std::string("> 0 ") + unit + " and finite",
          value);
}

void check_settings(const SceneSettings& settings) {
  require_finite(settings.gravity, "Scene", "gravity", "m/s^2");
  require_time_step(settings.dt, "Scene");
  require(settings.substeps >= 1 && settings.substeps <= 1000000, "Scene", "substeps", "from 1 to 1000000",
          settings.substeps);
  require_time_step(settings.dt / settings.substeps, "Scene (a substep)");
  require_range(settings.stabilization.baumgarte, 0, "Scene", "stabilization.baumgarte", "");
  require_range(settings.stabilization.slop, 0, "Scene", "stabilization.slop", "m");
  require(settings.stabilization.max_speed > 0, "Scene", "stabilization.max_speed", "> 0 m/s",
          settings.stabilization.max_speed);
  require_softness(settings.stabilization.soft, "Scene: stabilization.soft");
  require_range(settings.speculative_margin, 0, "Scene", "speculative_margin", "m");
  require_range(settings.restitution_threshold, 0, "Scene", "restitution_threshold", "m/s");
  if (settings.sleeping) {
    require_positive(settings.sleeping->speed, "sleeping.speed", "m/s");
    require_positive(settings.sleeping->angular_speed, "sleeping.angular_speed", "rad/s");
    require_positive(settings.sleeping->time, "sleeping.time", "s");
  }
}

}  // namespace

Scene::Scene(const SceneSettings& settings) : settings_(settings), bodies_(1) {
  check_settings(settings);
  bodies_[ground].spec.type = BodyType::static_body;
}

void Scene::set_settings(const SceneSettings& settings) {
  check_settings(settings);
  settings_ = settings;
}

BodyId Scene::add(const BodySpec& spec) {
  check_motion(spec);
  check_material(spec);
  check_shapes(spec);
  SceneBody body{.spec = spec, .pose = {.position = spec.position, .angle = spec.angle}};
  const MassProperties shapes = mass_properties(spec.shapes);
  if (spec.type == BodyType::dynamic) set_mass(body, shapes);
  if (spec.type == BodyType::static_body) {
    require(spec.velocity.isZero(0) && spec.angular_velocity == 0, "Scene::add", "velocity",
            "0 for a static body", spec.velocity.norm());
  }
  if (shapes.area > 0) {
    body.pose.position = body.pose.world(shapes.centroid);
    for (Shape<double>& shape : body.spec.shapes) shape = moved(shape, -shapes.centroid);
  }
  bodies_.push_back(body);
  return {bodies_.size() - 1};
}

BodyId Scene::add_ground(const GroundSpec& spec) {
  require_finite(spec.height, "Scene::add_ground", "height", "m");
  require(spec.half_width > 0 && std::isfinite(spec.half_width), "Scene::add_ground", "half_width",
          "> 0 m and finite", spec.half_width);
  require_friction(spec.friction, "Scene::add_ground");
  require_unit_interval(spec.restitution, "Scene::add_ground", "restitution");
  const double thickness = 1;  // [m]
  SceneBody& body = bodies_[ground];
  body.spec.friction = spec.friction;
  body.spec.restitution = spec.restitution;
  body.spec.shapes.push_back(moved(box(2 * spec.half_width, thickness), {0, spec.height - thickness / 2}));
  return ground;
}

void Scene::add_joint(std::shared_ptr<const Constraint> joint, JointCollision collision) {
  require(joint != nullptr, "Scene::add_joint", "joint", "a constraint", "nullptr");
  const List<Attachment> places = joint->attachments();
  std::string named;
  bool can_move = false;
  for (const Attachment& place : places) {
    require_body(place.body, "attachment");
    can_move |= bodies_[place.body].spec.type == BodyType::dynamic;
    named += (named.empty() ? "" : ", ") + std::to_string(place.body.index);
  }
  require(can_move, "Scene::add_joint", "bodies", "at least one that can move", named);

  const bool collide =
      collision == JointCollision::as_usual ? joint->bodies_collide() : collision == JointCollision::on;
  for (int i = 0; !collide && i < places.size(); ++i) {
    for (int k = 0; k < i; ++k) {
      const std::pair<BodyId, BodyId> pair = std::minmax(places[i].body, places[k].body);
      const auto place = std::lower_bound(apart_.begin(), apart_.end(), pair);
      if (place == apart_.end() || *place != pair) apart_.insert(place, pair);
    }
  }
  joints_.push_back(std::move(joint));
}

void Scene::displace(BodyId body, const Vec2<double>& offset, double angle) {
  require(body.index > 0 && body.index < bodies_.size(), "Scene::displace", "body",
          "the id of a body other than the ground", body.index);
  require_finite(offset, "Scene::displace", "offset", "m");
  require_finite(angle, "Scene::displace", "angle", "rad");
  SceneBody& moved_body = bodies_[body];
  const Vec2<double> frame = moved_body.pose.local(moved_body.spec.position);
  moved_body.pose.position += offset;
  moved_body.pose.angle += angle;
  require_finite(moved_body.pose.position, "Scene::displace", "position", "m");
  moved_body.spec.position = moved_body.pose.world(frame);
  moved_body.spec.angle += angle;
}

PerBody<Pose<double>> Scene::poses() const {
  PerBody<Pose<double>> result;
  for (const SceneBody& body : bodies_) result.push_back(body.pose);
  return result;
}

void Scene::require_body(BodyId id, const char* field) const {
  require(id.index >= 0 && id.index < bodies_.size(), "Scene::join", field, "the id of a body of this scene",
          id.index);
}

void require_time_step(double dt, const char* place) {
  require(dt >= 1e-12 && dt <= 1e6, place, "dt", "from 1e-12 to 1e6 s", dt);
}

}  // namespace cairn
