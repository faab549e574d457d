// Floor 5. Building a scene, and refusing what cannot be simulated.
#include <cairn/world/scene.hpp>

#include <algorithm>

#include <cairn/geometry/aabb.hpp>
#include <cairn/geometry/mass.hpp>
#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

void require_range(double value, double least, const char* place, const char* field, const char* unit) {
  if (value >= least && std::isfinite(value)) return;
  require(false, place, field, ">= " + shortest(least) + (*unit ? " " : "") + unit + " and finite", value);
}

/// Masses and inertias: their inverses must be finite in every scalar type, and products of a few of them
/// too.
void require_weight(double value, const char* place, const char* field, const char* unit) {
  require(value >= 1e-15 && value <= 1e15, place, field, std::string("from 1e-15 to 1e15 ") + unit, value);
}

std::string text(const Vec2<double>& point) {
  return "(" + shortest(point.x()) + ", " + shortest(point.y()) + ")";
}

void check_motion(const BodySpec& spec, const char* place) {
  require_finite(spec.position, place, "position", "m");
  require_finite(spec.angle, place, "angle", "rad");
  require_finite(spec.velocity, place, "velocity", "m/s");
  require_finite(spec.angular_velocity, place, "angular_velocity", "rad/s");
  require_finite(spec.gravity_scale, place, "gravity_scale", "");
  require_finite(spec.filter.one_way, place, "one_way", "");
  require(spec.filter.one_way.isZero(0) || spec.type != BodyType::dynamic, place, "one_way",
          "left out of a dynamic body: it would pass what it lies on", "a direction");
  if (spec.type != BodyType::static_body) return;
  require(spec.velocity.isZero(0) && spec.angular_velocity == 0, place, "velocity", "0 for a static body",
          spec.velocity.norm());
}

void check_material(const BodySpec& spec, const char* place) {
  if (spec.mass) require_weight(*spec.mass, place, "mass", "kg");
  if (spec.inertia) require_weight(*spec.inertia, place, "inertia", "kg m^2");
  require(spec.density > 0 && std::isfinite(spec.density), place, "density", "> 0 kg/m^2 and finite",
          spec.density);
  require_material(spec.material, place);
  require_range(spec.damping.linear, 0, place, "linear_damping", "1/s");
  require_range(spec.damping.angular, 0, place, "angular_damping", "1/s");
  require_range(spec.damping.quadratic, 0, place, "drag", "kg/m");
}

/// Makers of shapes refuse bad numbers; a shape written by hand has asked none of them.
void check_shapes(const BodySpec& spec, const char* place) {
  for (int i = 0; i < spec.shapes.size(); ++i) {
    const Aabb<double> box = bounding_box(spec.shapes[i], Pose<double>{});
    const Vec2<double> size = box.upper - box.lower;
    const bool has_size = size.allFinite() && size.minCoeff() >= 0 && size.maxCoeff() > 0;
    require(has_size, place, "size of shapes[" + std::to_string(i) + "]", "> 0 m and finite",
            size.maxCoeff());
    const bool is_chain = std::holds_alternative<Chain<double>>(spec.shapes[i]);
    require(!is_chain || spec.type != BodyType::dynamic, place, "shapes[" + std::to_string(i) + "]",
            "no chain on a dynamic body: chains are for static and kinematic ones", "a chain");
  }
}

void check_body(const BodySpec& spec, const char* place) {
  check_motion(spec, place);
  check_material(spec, place);
  check_shapes(spec, place);
}

/// Mass and inertia of a dynamic body from its shapes, unless they are given.
void set_mass(SceneBody& body, const char* place) {
  const BodySpec& spec = body.spec;
  if (spec.type != BodyType::dynamic) return;
  require(body.area > 0 || spec.mass.has_value(), place, "shapes",
          "of some area for a dynamic body without a mass of its own", body.area);
  body.mass = spec.mass.value_or(spec.density * body.area);
  require_weight(body.mass, place, "mass", "kg");
  require(body.area_inertia > 0 || spec.inertia.has_value() || spec.fixed_rotation, place, "inertia",
          "given for a dynamic body whose shapes have no area, unless its rotation is fixed",
          body.area_inertia);
  if (spec.fixed_rotation) return;
  body.inertia = spec.inertia ? *spec.inertia : body.mass * body.area_inertia / body.area;
  require_weight(body.inertia, place, "inertia", "kg m^2");
}

/// Moves the frame of a body to its centre of mass; in the world, its shapes stay where they are.
void center(SceneBody& body, const Vec2<double>& centroid) {
  if (!(body.area > 0)) return;
  body.pose.position = body.pose.world(centroid);
  List<Shape<double>> shapes;
  for (const Shape<double>& shape : body.spec.shapes) shapes.push_back(moved(shape, -centroid));
  body.spec.shapes = std::move(shapes);
}

/// A body with the shapes of one of the last few shares them.
void share_shapes(SceneBody& body, const PerBody<SceneBody>& bodies) {
  const int few = 16;
  for (int i = bodies.size() - 1; i > 0 && i >= bodies.size() - few; --i) {
    const SharedList<Shape<double>>& shapes = bodies[{i}].spec.shapes;
    if (shapes == body.spec.shapes) {
      body.spec.shapes = shapes;
      return;
    }
  }
}

/// Whether shapes with these properties need no new mass and no new centre.
bool weigh_the_same(const MassProperties& a, const MassProperties& b) {
  return a.area == b.area && a.centroid == b.centroid && a.inertia == b.inertia;
}

void require_positive(double value, const char* field, const char* unit) {
  require(value > 0 && std::isfinite(value), "Scene", field, std::string("> 0 ") + unit + " and finite",
          value);
}

void check_fields(const Fields& fields) {
  require_finite(fields.wind, "Scene", "wind", "m/s");
  require_range(fields.gravitation, 0, "Scene", "gravitation", "m^3/(kg s^2)");
  for (const Attraction& star : fields.attractions) {
    require_finite(star.point, "Scene", "attraction.point", "m");
    require_finite(star.strength, "Scene", "attraction.strength", "m^3/s^2");
    require_range(star.radius, 0, "Scene", "attraction.radius", "m");
  }
  if (!fields.water) return;
  require_finite(fields.water->level, "Scene", "water.level", "m");
  require_positive(fields.water->density, "water.density", "kg/m^2");
  require_range(fields.water->drag, 0, "Scene", "water.drag", "1/s");
  require_finite(fields.water->flow, "Scene", "water.flow", "m/s");
}

void check_settings(const SceneSettings& settings, int bodies) {
  require_mixing(settings.mixing, bodies);
  require_finite(settings.gravity, "Scene", "gravity", "m/s^2");
  check_fields(settings.fields);
  require_time_step(settings.dt, "Scene");
  require(settings.substeps >= 1 && settings.substeps <= SceneSettings::most_substeps, "Scene", "substeps",
          "from 1 to " + std::to_string(SceneSettings::most_substeps), settings.substeps);
  require_time_step(settings.dt / settings.substeps, "Scene (a substep)");
  require_range(settings.stabilization.baumgarte, 0, "Scene", "stabilization.baumgarte", "");
  require_range(settings.stabilization.slop.value_or(0), 0, "Scene", "stabilization.slop", "m");
  require(most_speed(settings.stabilization) > 0, "Scene", "stabilization.max_speed", "> 0 m/s",
          most_speed(settings.stabilization));
  require_softness(settings.stabilization.soft, "Scene: stabilization.soft");
  require_softness(settings.stabilization.joint_soft, "Scene: stabilization.joint_soft");
  require_range(settings.speculative_margin.value_or(0), 0, "Scene", "speculative_margin", "m");
  require_range(settings.restitution_threshold.value_or(0), 0, "Scene", "restitution_threshold", "m/s");
  if (settings.sleeping) {
    require_positive(settings.sleeping->speed, "sleeping.speed", "m/s");
    require_positive(settings.sleeping->angular_speed, "sleeping.angular_speed", "rad/s");
    require_positive(settings.sleeping->time, "sleeping.time", "s");
  }
}

}  // namespace

Scene::Scene(const SceneSettings& settings)
    : settings_(settings), bodies_(std::make_shared<PerBody<SceneBody>>(1)) {
  check_settings(settings, 1);
  own_bodies()[ground].spec.type = BodyType::static_body;
}

/// To be changed: no other scene sees it.
PerBody<SceneBody>& Scene::own_bodies() {
  std::shared_ptr<PerBody<SceneBody>> seen = bodies_;
  if (seen.use_count() > 2) {
    const auto own = std::make_shared<PerBody<SceneBody>>();
    own->reserve(seen->size() + 1);  // for the one that add() puts behind them
    for (const SceneBody& body : *seen) own->push_back(body);
    bodies_ = own;
  }
  seen.reset();  // whoever lets go of a copy comes after those who did before, and what they read
  return *bodies_;
}

void Scene::set_settings(const SceneSettings& settings) {
  check_settings(settings, bodies().size());
  settings_ = settings;
}

BodyId Scene::add(const BodySpec& spec) {
  const char* const who = "Scene::add";
  check_body(spec, who);
  const MassProperties shapes = mass_properties(spec.shapes);
  SceneBody body{.spec = spec,
                 .pose = {.position = spec.position, .angle = spec.angle},
                 .area = shapes.area,
                 .area_inertia = shapes.inertia};
  set_mass(body, who);
  center(body, shapes.centroid);
  share_shapes(body, bodies());
  own_bodies().push_back(body);
  return {bodies().size() - 1};
}

void Scene::change(BodyId body, const BodySpec& spec) {
  const char* const who = "Scene::change";
  require_changeable(*this, body, who);
  check_body(spec, who);
  const SceneBody& before = bodies()[body];
  require(spec.position == before.spec.position, who, "position",
          "that of the body, " + text(before.spec.position) + " m (place and displace move it)",
          text(spec.position));
  require(spec.angle == before.spec.angle, who, "angle",
          "that of the body, " + shortest(before.spec.angle) + " rad (place and displace turn it)",
          spec.angle);
  if (spec.type != BodyType::dynamic) require_other_movers(body, spec.type);
  SceneBody now{.spec = spec, .pose = before.pose, .area = before.area, .area_inertia = before.area_inertia};
  const MassProperties given = mass_properties(spec.shapes);
  const bool is_reweighed = !weigh_the_same(given, mass_properties(before.spec.shapes));
  if (is_reweighed) {
    now.area = given.area;
    now.area_inertia = given.inertia;
  }
  set_mass(now, who);
  if (is_reweighed) {
    const double rounding = 1e-9 * std::sqrt(given.area);  // [m]
    require(given.centroid.norm() <= rounding || !has_joints(body), who, "shapes",
            "around the body's centre of mass, (0, 0) m, while it has joints", text(given.centroid));
    center(now, given.centroid);
  }
  own_bodies()[body] = now;
}

BodyId Scene::add_ground(const GroundSpec& spec) {
  require_finite(spec.height, "Scene::add_ground", "height", "m");
  require(spec.half_width > 0 && std::isfinite(spec.half_width), "Scene::add_ground", "half_width",
          "> 0 m and finite", spec.half_width);
  require(spec.thickness > 0 && std::isfinite(spec.thickness), "Scene::add_ground", "thickness",
          "> 0 m and finite", spec.thickness);
  require_material(spec.material, "Scene::add_ground");
  SceneBody& body = own_bodies()[ground];
  body.spec.material = spec.material;
  body.spec.shapes.push_back(
      moved(box(2 * spec.half_width, spec.thickness), {0, spec.height - spec.thickness / 2}));
  return ground;
}

void require_time_step(double dt, const char* place) {
  require(dt >= 1e-12 && dt <= 1e6, place, "dt", "from 1e-12 to 1e6 s", dt);
}

}  // namespace cairn
