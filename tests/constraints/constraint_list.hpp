// The constraints under test, as errors that depend on the poses of two bodies: a new constraint is one line
// here.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "../geometry/random_shapes.hpp"
#include "collision/collide.hpp"
#include "constraints/contact.hpp"
#include "constraints/distance_joint.hpp"
#include "constraints/prismatic_joint.hpp"
#include "constraints/revolute_joint.hpp"
#include "constraints/weld_joint.hpp"

namespace cairn::testing {

/// Writes the rows that hold at the given poses of the ground and of bodies 1 and 2.
template <Scalar Real>
using RowWriter = std::function<RowSpecs<Real>(const std::vector<Pose<Real>>&)>;

template <Scalar Real>
struct ConstraintUnderTest {
  std::string name = {};
  RowWriter<Real> rows = {};
};

template <typename Joint, Scalar Real>
RowWriter<Real> joint_rows(const typename Joint::Spec& spec, const std::vector<Pose<double>>& start) {
  return [joint = Joint(spec, start)](const std::vector<Pose<Real>>& poses) {
    RowSpecs<Real> rows;
    joint.append_rows(poses, rows);
    return rows;
  };
}

/// Two shapes without friction: a friction row has no error that its Jacobian could be the derivative of.
template <Scalar Real>
RowWriter<Real> contact_rows(const Shape<double>& a, const Shape<double>& b, double friction = 0) {
  return [=](const std::vector<Pose<Real>>& poses) {
    const Real far = 100;  // [m] margin: they need not touch
    const Manifold<Real> manifold =
        collide(shape_cast<Real>(a), poses[1], shape_cast<Real>(b), poses[2], far);
    RowSpecs<Real> rows;
    const std::vector<Vec3<Real>> at_rest(3, Vec3<Real>::Zero());
    append_contact_rows<Real>(manifold, {1}, {2}, {.friction = static_cast<Real>(friction)}, poses, at_rest,
                              rows);
    return rows;
  };
}

/// Everything that states rows, between bodies 1 and 2 that start from these poses.
template <Scalar Real>
std::vector<ConstraintUnderTest<Real>> all_constraints(const std::vector<Pose<double>>& start,
                                                       test::Random& random) {
  const BodyId a{1}, b{2};
  const Vec2<double> near_a = start[1].position + random.point(1);
  const Vec2<double> near_b = start[2].position + random.point(1);
  const Vec2<double> offset_a = random.point(0.2);
  const Vec2<double> axis = Rotation<double>(random.uniform(-pi, pi)) * Vec2<double>(1, 0);
  const double far = 100;  // [m or rad] margin: limits have rows wherever the bodies are
  const Softness soft = SwingSoftness{.frequency = 2, .damping_ratio = 0.5};
  return {
      {"distance",
       joint_rows<DistanceJoint, Real>({.a = a, .b = b, .anchor_a = near_a, .anchor_b = near_b}, start)},
      {"rope", joint_rows<DistanceJoint, Real>({.a = a,
                                                .b = b,
                                                .anchor_a = near_a,
                                                .anchor_b = near_b,
                                                .kind = DistanceJoint::Kind::rope,
                                                .slack_margin = far},
                                               start)},
      {"spring", joint_rows<DistanceJoint, Real>({.a = a,
                                                  .b = b,
                                                  .anchor_a = near_a,
                                                  .anchor_b = near_b,
                                                  .kind = DistanceJoint::Kind::spring,
                                                  .softness = soft},
                                                 start)},
      {"revolute", joint_rows<RevoluteJoint, Real>({.a = a, .b = b, .anchor = near_a}, start)},
      {"revolute with limits",
       joint_rows<RevoluteJoint, Real>(
           {.a = a, .b = b, .anchor = near_a, .lower = -0.1, .upper = 0.3, .limit_margin = far}, start)},
      {"weld", joint_rows<WeldJoint, Real>({.a = a, .b = b, .anchor = near_a}, start)},
      {"prismatic with limits",
       joint_rows<PrismaticJoint, Real>(
           {.a = a, .b = b, .anchor = near_a, .axis = axis, .lower = -0.1, .upper = 0.3, .limit_margin = far},
           start)},
      {"contact of discs", contact_rows<Real>(circle(0.3, offset_a), circle(0.5, {0.3, 0.1}))},
      {"contact of a disc and a box", contact_rows<Real>(circle(0.3, offset_a), box(40, 1))},
  };
}

/// The ground, and two bodies some 4 m apart, one above the other, at any angle (the second one nearly
/// level).
inline std::vector<Pose<double>> random_poses(test::Random& random) {
  const Vec2<double> place = random.point(2);
  const Vec2<double> other = place + Vec2<double>(random.uniform(-1, 1), random.uniform(-5, -3));
  return {{}, {place, random.uniform(-pi, pi)}, {other, random.uniform(-0.3, 0.3)}};
}

}  // namespace cairn::testing
