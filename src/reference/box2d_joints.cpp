// Floor 7. From Cairn's joints to Box2D's.
#include <cairn/reference/box2d_joints.hpp>

#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/constraints/drag_joint.hpp>
#include <cairn/constraints/friction_joint.hpp>
#include <cairn/constraints/gear_joint.hpp>
#include <cairn/constraints/prismatic_joint.hpp>
#include <cairn/constraints/pulley_joint.hpp>
#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/constraints/weld_joint.hpp>
#include <cairn/math/check.hpp>
#include <cairn/reference/box2d_shapes.hpp>

namespace cairn {

namespace {

const char* const who = "Box2DWorld";
constexpr float far = 1e9f;  // [m or rad] a limit that is none

float in_float(double number) { return static_cast<float>(number); }

/// The two bodies of a joint in Box2D.
struct Box2DPair {
  b2Body* a = nullptr;
  b2Body* b = nullptr;
};

template <typename Definition>
void set_spring(Definition& definition, const Softness& softness, const Box2DPair& pair, bool turns) {
  if (const auto* spring = std::get_if<SpringSoftness>(&softness)) {
    definition.stiffness = in_float(spring->stiffness);
    definition.damping = in_float(spring->damping);
    return;
  }
  const SwingSoftness& swing = std::get<SwingSoftness>(softness);
  (turns ? b2AngularStiffness : b2LinearStiffness)(definition.stiffness, definition.damping,
                                                   in_float(swing.frequency), in_float(swing.damping_ratio),
                                                   pair.a, pair.b);
}

template <typename Definition>
void set_anchors(Definition& definition, const JointEnds& ends) {
  definition.localAnchorA = to_box2d(ends.local_a);
  definition.localAnchorB = to_box2d(ends.local_b);
}

/// [rad or m]
template <typename Bound>
void set_limits(const JointLimits& limits, double shift, bool& enable, Bound& lower, Bound& upper) {
  enable = limits.lower || limits.upper;
  lower = limits.lower ? in_float(*limits.lower - shift) : -far;
  upper = limits.upper ? in_float(*limits.upper - shift) : far;
}

b2DistanceJointDef definition(const DistanceJoint& joint, const Box2DPair& pair) {
  using Kind = DistanceJoint::Kind;
  const std::string name = joint.name();
  require(joint.length() >= b2_linearSlop, who, (name + " length").c_str(),
          ">= 0.005 m, the shortest in Box2D 2.4.1", joint.length());
  b2DistanceJointDef result;
  result.localAnchorA = to_box2d(joint.attachments()[0].anchor);
  result.localAnchorB = to_box2d(joint.attachments()[1].anchor);
  result.length = in_float(joint.length());
  result.maxLength = joint.kind() == Kind::spring ? far : result.length;
  result.minLength = joint.kind() == Kind::rod ? result.length : in_float(joint.least());
  if (joint.kind() == Kind::rope)
    require(!joint.softness(), who, "rope", "without softness, as Box2D 2.4.1 has no elastic ropes", "one");
  if (joint.softness()) set_spring(result, *joint.softness(), pair, false);
  return result;
}

/// What Box2D has of none of its joints.
void require_plain(const JointCoordinate& coordinate, const std::string& name, bool may_have_spring) {
  const auto refuse_if = [&](bool has, const char* what, const char* plural) {
    require(!has, who, name.c_str(),
            std::string("without a ") + what + ", as Box2D 2.4.1 has no " + plural + " there", "one");
  };
  refuse_if(coordinate.ratchet().has_value(), "ratchet", "ratchets");
  refuse_if(coordinate.spring() && !may_have_spring, "spring", "springs");
}

b2RevoluteJointDef definition(const RevoluteJoint& joint, const Box2DPair&) {
  require_plain(joint.turn(), "revolute joint", false);
  b2RevoluteJointDef result;
  set_anchors(result, joint.ends());
  result.referenceAngle = in_float(joint.ends().reference_angle);
  set_limits(joint.turn().limits(), 0, result.enableLimit, result.lowerAngle, result.upperAngle);
  return result;
}

b2PrismaticJointDef slide_definition(const PrismaticJoint& joint) {
  require_plain(joint.slide(), "prismatic joint", false);
  b2PrismaticJointDef result;
  set_anchors(result, joint.ends());
  result.localAxisA = to_box2d(joint.axis());
  result.referenceAngle = in_float(joint.ends().reference_angle);
  set_limits(joint.slide().limits(), 0, result.enableLimit, result.lowerTranslation, result.upperTranslation);
  return result;
}

/// A slot is a wheel without its motor. Box2D's spring rests where the anchors meet.
b2WheelJointDef wheel_definition(const PrismaticJoint& joint, const Box2DPair& pair) {
  const JointCoordinate& slide = joint.slide();
  require_plain(slide, joint.name(), true);
  require(!slide.motor(), who, "slot", "without a motor, as Box2D 2.4.1 has none there", "one");
  const double rest = slide.spring() ? slide.spring()->rest : 0;
  b2WheelJointDef result;
  set_anchors(result, joint.ends());
  result.localAnchorA = to_box2d(joint.ends().local_a + rest * joint.axis());
  result.localAxisA = to_box2d(joint.axis());
  set_limits(slide.limits(), rest, result.enableLimit, result.lowerTranslation, result.upperTranslation);
  if (slide.spring()) set_spring(result, slide.spring()->softness, pair, false);
  return result;
}

b2WeldJointDef definition(const WeldJoint& joint, const Box2DPair& pair) {
  require(!joint.softness(), who, "weld", "rigid in its place, as Box2D 2.4.1 only lets it bend", "soft");
  b2WeldJointDef result;
  set_anchors(result, joint.ends());
  result.referenceAngle = in_float(joint.ends().reference_angle);
  if (joint.bending()) set_spring(result, *joint.bending(), pair, true);
  return result;
}

b2FrictionJointDef definition(const FrictionJoint& joint, const Box2DPair&) {
  require(joint.shape() == FrictionShape::circle, who, "friction shape",
          "a circle, the one that Box2D 2.4.1 has", "a square");
  b2FrictionJointDef result;
  result.localAnchorA = to_box2d(joint.attachments()[0].anchor);
  result.localAnchorB = to_box2d(joint.attachments()[1].anchor);
  result.maxForce = in_float(joint.max_force());
  result.maxTorque = in_float(joint.max_torque());
  return result;
}

/// Its anchor is where the target is while the joint is made: it is moved away behind that.
b2MouseJointDef definition(const DragJoint& joint, const Box2DPair& pair) {
  b2MouseJointDef result;
  result.target = pair.b->GetWorldPoint(to_box2d(joint.attachments()[1].anchor));
  result.maxForce = in_float(joint.max_force());
  set_spring(result, joint.softness(), pair, false);
  return result;
}

b2PulleyJointDef definition(const PulleyJoint& joint, const Box2DPair& pair) {
  const List<double> parts = joint.parts();
  const List<Attachment> places = joint.attachments();
  require(parts.size() == 2 && places.size() == 4, who, "pulley", "of two ends, as in Box2D 2.4.1",
          parts.size());
  for (int i = 1; i < 3; ++i) {
    require(places[i].body == ground && places[i].turns, who, "pulley roller",
            "on the ground, as in Box2D 2.4.1", places[i].body.index);
  }
  b2PulleyJointDef result;
  result.localAnchorA = to_box2d(places[0].anchor);
  result.localAnchorB = to_box2d(places[3].anchor);
  result.groundAnchorA = to_box2d(places[1].anchor);
  result.groundAnchorB = to_box2d(places[2].anchor);
  // Its length is lengthA + ratio lengthB, with lengths that only need that sum.
  const b2Vec2 rope_a = pair.a->GetWorldPoint(result.localAnchorA) - result.groundAnchorA;
  result.lengthA = rope_a.Length();
  result.lengthB =
      in_float((joint.length() / parts[0] - static_cast<double>(result.lengthA)) * parts[0] / parts[1]);
  result.ratio = in_float(parts[1] / parts[0]);
  return result;
}

/// What a body's pin or slide on the carrier is in Box2D: what a gear turns.
b2Joint* axle_of(b2Body* body, b2Body* carrier, const List<b2Joint*>& joints, b2JointType type) {
  for (b2Joint* const joint : joints) {
    if (joint != nullptr && joint->GetType() == type && joint->GetBodyB() == body &&
        joint->GetBodyA() == carrier)
      return joint;
  }
  return nullptr;
}

b2GearJointDef definition(const GearJoint& joint, const PerBody<b2Body*>& bodies,
                          const List<b2Joint*>& joints) {
  require(joint.carrier() == ground, who, "gear carrier", "the ground, as in Box2D 2.4.1",
          joint.carrier().index);
  b2Body* const carrier = bodies[joint.carrier()];
  b2GearJointDef result;
  result.joint1 = axle_of(bodies[joint.wheel()], carrier, joints, e_revoluteJoint);
  result.joint2 =
      axle_of(bodies[joint.other()], carrier, joints, joint.is_rack() ? e_prismaticJoint : e_revoluteJoint);
  require(result.joint1 != nullptr && result.joint2 != nullptr, who, "gear",
          "between bodies that a revolute or a prismatic joint holds to the ground, as in Box2D 2.4.1",
          "others");
  double ratio = 1 / joint.ratio();
  if (joint.is_rack()) {
    const b2Vec2 slide = static_cast<b2PrismaticJoint*>(result.joint2)->GetLocalAxisA();
    const double along = static_cast<double>(b2Dot(slide, to_box2d(joint.axis())));
    require(std::abs(std::abs(along) - 1) < 1e-5, who, "gear axis", "that of the slide, as in Box2D 2.4.1",
            "another");
    ratio *= along;
  }
  result.ratio = in_float(ratio);
  return result;
}

/// Calls create(definition) with what the joint is in Box2D, if it is something.
template <typename Create>
void define(const Constraint& joint, const Box2DPair& pair, const Create& create) {
  const auto define_if = [&]<typename Joint>(std::type_identity<Joint>) {
    if (const auto* known = dynamic_cast<const Joint*>(&joint)) create(definition(*known, pair));
  };
  define_if(std::type_identity<DistanceJoint>());
  define_if(std::type_identity<RevoluteJoint>());
  define_if(std::type_identity<WeldJoint>());
  define_if(std::type_identity<FrictionJoint>());
  define_if(std::type_identity<PulleyJoint>());
  define_if(std::type_identity<DragJoint>());
  const auto* const slide = dynamic_cast<const PrismaticJoint*>(&joint);
  if (slide == nullptr) return;
  if (slide->kind() == PrismaticJoint::Kind::prismatic) return create(slide_definition(*slide));
  create(wheel_definition(*slide, pair));
}

/// What a joint has once it is made.
void finish(const Constraint& joint, b2Joint& made) {
  if (joint.motor()) set_motor(made, joint.motor());
  if (made.GetType() == e_mouseJoint)
    static_cast<b2MouseJoint&>(made).SetTarget(to_box2d(joint.attachments().front().anchor));
}

}  // namespace

List<b2Joint*> create_joints(b2World& world, const Scene& scene, const PerBody<b2Body*>& bodies) {
  List<b2Joint*> joints(scene.joints().size(), nullptr);
  for (const bool gears : {false, true}) {
    for (int i = 0; i < scene.joints().size(); ++i) {
      const Constraint& joint = *scene.joints()[i];
      const auto* const gear = dynamic_cast<const GearJoint*>(&joint);
      if ((gear != nullptr) != gears) continue;
      const List<Attachment> places = joint.attachments();
      const Box2DPair pair{bodies[places.front().body], bodies[places.back().body]};
      const std::pair<BodyId, BodyId> ends = std::minmax(places.front().body, places.back().body);
      const List<std::pair<BodyId, BodyId>> apart = scene.joints().apart();
      const auto create = [&](auto definition) {
        definition.bodyA = pair.a;
        definition.bodyB = pair.b;
        definition.collideConnected = !std::binary_search(apart.begin(), apart.end(), ends);
        joints[i] = world.CreateJoint(&definition);
      };
      if (gears) {
        create(definition(*gear, bodies, joints));
      } else {
        define(joint, pair, create);
      }
      require(joints[i] != nullptr, who, "joint", "of a kind that Box2D 2.4.1 has", joint.name());
      finish(joint, *joints[i]);
    }
  }
  return joints;
}

}  // namespace cairn
