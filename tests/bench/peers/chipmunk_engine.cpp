// Chipmunk 7 as a peer.
#include <chipmunk/chipmunk.h>

#include <cmath>
#include <memory>
#include <variant>

#include "engine.hpp"

namespace cairn::bench {

namespace {

struct Free {
  void operator()(cpSpace* space) const { cpSpaceFree(space); }
  void operator()(cpBody* body) const { cpBodyFree(body); }
  void operator()(cpShape* shape) const { cpShapeFree(shape); }
  void operator()(cpConstraint* joint) const { cpConstraintFree(joint); }
};
template <typename T>
using Owned = std::unique_ptr<T, Free>;

cpVect to_chipmunk(const Vec2<double>& v) { return cpv(v.x(), v.y()); }

/// One for each shape, and for each link of a chain, which Chipmunk does not have.
struct MakeShapes {
  cpBody* body;

  List<cpShape*> operator()(const Circle<double>& circle) const {
    return {cpCircleShapeNew(body, circle.radius, to_chipmunk(circle.center))};
  }
  List<cpShape*> operator()(const Polygon<double>& polygon) const {
    List<cpVect> corners;
    for (int i = 0; i < polygon.vertices.size(); ++i) corners.push_back(to_chipmunk(polygon.vertices[i]));
    return {cpPolyShapeNewRaw(body, corners.size(), corners.data(), polygon.radius)};
  }
  List<cpShape*> operator()(const Segment<double>& segment) const {
    return {cpSegmentShapeNew(body, to_chipmunk(segment.point1), to_chipmunk(segment.point2), 0)};
  }
  List<cpShape*> operator()(const Capsule<double>& capsule) const {
    return {
        cpSegmentShapeNew(body, to_chipmunk(capsule.point1), to_chipmunk(capsule.point2), capsule.radius)};
  }
  List<cpShape*> operator()(const Chain<double>& chain) const {
    List<cpShape*> links;
    for (int i = 0; i < chain.link_count(); ++i) {
      links.push_back(
          cpSegmentShapeNew(body, to_chipmunk(chain.point(i)), to_chipmunk(chain.point(i + 1)), 0));
      cpSegmentShapeSetNeighbors(links.back(), to_chipmunk(chain.point(i - 1)),
                                 to_chipmunk(chain.point(i + 2)));
    }
    return links;
  }
};

class ChipmunkEngine final : public Engine {
 public:
  ChipmunkEngine(const Scene& scene, const PeerSettings& settings)
      : dt_(scene.settings().dt), space_(cpSpaceNew()) {
    cpSpaceSetIterations(space_.get(), settings.iterations);
    cpSpaceSetGravity(space_.get(), to_chipmunk(scene.settings().gravity));
    cpSpaceSetCollisionSlop(space_.get(), 0.005);
    for (const SceneBody& body : scene.bodies()) add(body);
    for (const Pin& joint : pins_of(scene)) pin(joint);
  }
  void step() override { cpSpaceStep(space_.get(), dt_); }
  PerBody<Pose<double>> poses() const override {
    PerBody<Pose<double>> result;
    for (const Owned<cpBody>& body : bodies_) {
      const cpVect center = cpBodyGetPosition(body.get());
      result.push_back({.position = {center.x, center.y}, .angle = cpBodyGetAngle(body.get())});
    }
    return result;
  }
  PerBody<Vec3<double>> velocities() const override {
    PerBody<Vec3<double>> result;
    for (const Owned<cpBody>& body : bodies_) {
      const cpVect velocity = cpBodyGetVelocity(body.get());
      result.push_back({velocity.x, velocity.y, cpBodyGetAngularVelocity(body.get())});
    }
    return result;
  }

 private:
  void add(const SceneBody& body) {
    const BodySpec& spec = body.spec;
    cpBody* made = spec.type == BodyType::dynamic     ? cpBodyNew(body.mass, body.inertia)
                   : spec.type == BodyType::kinematic ? cpBodyNewKinematic()
                                                      : cpBodyNewStatic();
    bodies_.push_back(Owned<cpBody>(made));
    cpBodySetPosition(made, to_chipmunk(body.pose.position));
    cpBodySetAngle(made, body.pose.angle);
    if (spec.type != BodyType::static_body) {
      cpBodySetVelocity(made, to_chipmunk(spec.velocity));
      cpBodySetAngularVelocity(made, spec.angular_velocity);
    }
    cpSpaceAddBody(space_.get(), made);
    for (const Shape<double>& shape : spec.shapes) {
      for (cpShape* converted : std::visit(MakeShapes{made}, shape)) {
        shapes_.push_back(Owned<cpShape>(converted));
        // It multiplies those of two shapes.
        cpShapeSetFriction(converted, std::sqrt(spec.material.friction));
        cpShapeSetElasticity(converted, std::sqrt(spec.material.restitution));
        cpShapeSetFilter(converted,
                         cpShapeFilterNew(CP_NO_GROUP, spec.filter.category, spec.filter.collides_with));
        cpSpaceAddShape(space_.get(), converted);
      }
    }
  }
  /// A pin, its limits and its motor are three constraints.
  void pin(const Pin& pin) {
    cpBody *a = bodies_[pin.a].get(), *b = bodies_[pin.b].get();
    add(cpPivotJointNew2(a, b, to_chipmunk(pin.anchor_a), to_chipmunk(pin.anchor_b)), pin);
    if (pin.lower) add(cpRotaryLimitJointNew(a, b, pin.start + *pin.lower, pin.start + *pin.upper), pin);
    if (pin.motor) {
      // Its speed is that of a, seen from b.
      cpConstraint* motor = cpSimpleMotorNew(a, b, -pin.motor->speed);
      cpConstraintSetMaxForce(motor, pin.motor->max_force);
      add(motor, pin);
    }
  }
  void add(cpConstraint* constraint, const Pin& pin) {
    joints_.push_back(Owned<cpConstraint>(constraint));
    cpConstraintSetCollideBodies(constraint, pin.touch ? cpTrue : cpFalse);
    cpSpaceAddConstraint(space_.get(), constraint);
  }

  double dt_;  // [s]
  // Freed from the last to the first: the space goes before what is in it, as its destructor looks at that.
  PerBody<Owned<cpBody>> bodies_ = {};
  List<Owned<cpShape>> shapes_ = {};
  List<Owned<cpConstraint>> joints_ = {};
  Owned<cpSpace> space_;
};

}  // namespace

std::unique_ptr<Engine> make_chipmunk(const Scene& scene, const PeerSettings& settings) {
  return std::make_unique<ChipmunkEngine>(scene, settings);
}

std::string chipmunk_version() { return cpVersionString; }

}  // namespace cairn::bench
