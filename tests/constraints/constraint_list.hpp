// The constraints under test, as errors that depend on the poses of up to four bodies: a new constraint is
// one line here.
#pragma once

#include "geometry/random_shapes.hpp"
#include <cairn/collision/collide.hpp>
#include "testing.hpp"

namespace cairn::testing {

/// States the rows that hold at the given poses of the ground and of bodies 1 to 4.
template <Scalar Real>
struct StateRows {
  std::shared_ptr<const Constraint> joint = {};                            // null: it is a contact
  std::function<RowSpecs<Real>(const PerBody<Pose<Real>>&)> contact = {};  // what states its rows

  RowSpecs<Real> operator()(const PerBody<Pose<Real>>& poses) const {
    if (!joint) return contact(poses);
    RowSpecs<Real> rows;
    joint->append_rows(poses, rows);
    return rows;
  }
};

template <Scalar Real>
struct ConstraintUnderTest {
  std::string name = {};
  StateRows<Real> rows = {};
  bool is_free = true;  // nothing of it is fastened to the ground, which is not among the bodies looked at
};

template <Scalar Real>
PerBody<Pose<Real>> poses_in(const PerBody<Pose<double>>& poses) {
  PerBody<Pose<Real>> result;
  for (const Pose<double>& pose : poses) {
    result.push_back({pose.position.cast<Real>(), static_cast<Real>(pose.angle)});
  }
  return result;
}

/// What a row has for one body.
template <Scalar Real>
Vec3<Real> jacobian_of(const RowSpec<Real>& row, BodyId body) {
  Vec3<Real> sum = Vec3<Real>::Zero();
  if (row.a == body) sum += row.jacobian_a;
  if (row.b == body) sum += row.jacobian_b;
  for (int k = 0; k < row.extra_count; ++k) {
    const RowTerm<Real>& term = row.extra[k];
    if (term.body == body) sum += term.jacobian;
  }
  return sum;
}

template <typename Joint, Scalar Real>
StateRows<Real> joint_rows(const typename Joint::Spec& spec, const PerBody<Pose<double>>& start) {
  return {.joint = std::make_shared<const Joint>(spec, start)};
}

/// The rows of a contact of bodies 1 and 2.
template <Scalar Real>
PerRow<ConstraintRow<Real>> written_contact(const Manifold<Real>& manifold, Real friction,
                                            const PerBody<Pose<Real>>& poses) {
  VelocityProblem<Real> problem;
  problem.velocity.assign(3, Vec3<Real>::Zero());
  problem.inverse_mass.assign(3, Vec3<Real>::Ones());
  problem.rule.dt = 1;
  const Contact<Real> contact{.a = {1},
                              .b = {2},
                              .manifold = manifold,
                              .center_a = poses[{1}].position,
                              .center_b = poses[{2}].position,
                              .friction = friction};
  int next = 0;
  write_contact_rows(contact, problem, next);
  return problem.rows;
}

/// The same as a joint would state them: errors in place of biases.
template <Scalar Real>
RowSpecs<Real> stated_contact(const Manifold<Real>& manifold, Real friction,
                              const PerBody<Pose<Real>>& poses) {
  RowSpecs<Real> specs;
  for (const ConstraintRow<Real>& row : written_contact(manifold, friction, poses)) {
    RowSpec<Real>& spec = specs.emplace_back();
    spec.a = row.a;
    spec.b = row.b;
    spec.jacobian_a = row.jacobian_a;
    spec.jacobian_b = row.jacobian_b;
    spec.bounds = row.bounds;
    spec.part = row.key.part;
    for (const ManifoldPoint<Real>& point : manifold.points)
      if (spec.part == normal_part(point.feature)) spec.error = point.separation;
  }
  return specs;
}

/// Two shapes without friction: a friction row has no error that its Jacobian could be the derivative of.
template <Scalar Real>
StateRows<Real> contact_rows(const Shape<double>& a, const Shape<double>& b, double friction = 0) {
  return {.contact = [=](const PerBody<Pose<Real>>& poses) {
    const Real far = 100;  // [m] margin: they need not touch
    const Manifold<Real> manifold =
        collide(shape_cast<Real>(a), poses[{1}], shape_cast<Real>(b), poses[{2}], far);
    return stated_contact<Real>(manifold, static_cast<Real>(friction), poses);
  }};
}

/// Ropes on four bodies, with and without the ground.
template <Scalar Real>
List<ConstraintUnderTest<Real>> pulleys(const PerBody<Pose<double>>& start, test::Random& random) {
  using Roller = PulleyJoint::Roller;
  const double far = 100;  // [m] margin: a slack rope has its row too
  const BodyId a{1}, b{2}, c{3}, d{4};
  PerBody<Vec2<double>> anchors, above;  // on the bodies, and 3 m above
  for (const Pose<double>& pose : start) {
    anchors.push_back(pose.position + random.point(1));
    above.push_back(anchors.back() + Vec2<double>(0, 3));
  }
  const Vec2<double> side = start[b].position + Vec2<double>(2, 0);  // of a drum
  const List<PulleyJoint::End> fixed = {{.body = a, .anchor = anchors[a], .roller = above[a]},
                                        {.body = b, .anchor = anchors[b], .roller = above[b], .parts = 2},
                                        {.body = c, .anchor = anchors[c], .roller = above[c]},
                                        {.body = d, .anchor = anchors[d], .roller = above[d], .parts = 3}};
  const List<PulleyJoint::End> carried = {
      {.body = a, .anchor = anchors[a], .roller = side, .carrier = b, .kind = Roller::drum},
      {.body = c, .anchor = anchors[c], .roller = anchors[d], .parts = 2, .carrier = d}};
  return {
      {"pulley on four bodies",
       joint_rows<PulleyJoint, Real>({.ends = fixed, .kind = PulleyJoint::Kind::taut}, start), false},
      {"pulley with a drum and a moving roller",
       joint_rows<PulleyJoint, Real>({.ends = carried, .slack_margin = far}, start)},
  };
}

/// The joints on three bodies, and those that need the ground.
template <Scalar Real>
List<ConstraintUnderTest<Real>> gears_and_drag(const PerBody<Pose<double>>& start, test::Random& random) {
  const BodyId a{1}, b{2}, c{3};
  const Vec2<double> anchor = start[b].position + random.point(1), target = random.point(3);
  return {
      {"gear", joint_rows<GearJoint, Real>({.a = a, .b = b, .radius_a = 0.5, .radius_b = 1.5}, start), false},
      {"planetary gear",
       joint_rows<GearJoint, Real>(
           {.a = a, .b = b, .c = c, .radius_a = 1.5, .radius_b = 0.5, .mesh = GearJoint::Mesh::internal},
           start)},
      {"differential", joint_rows<DifferentialJoint, Real>({.a = a, .b = b, .c = c}, start)},
      {"drag", joint_rows<DragJoint, Real>({.body = b, .anchor = anchor, .target = target}, start), false},
  };
}

/// What joints have besides: servos, springs, ratchets and softness; and slots, wheels and racks.
template <Scalar Real>
List<ConstraintUnderTest<Real>> driven_joints(const PerBody<Pose<double>>& start, test::Random& random) {
  using Kind = PrismaticJoint::Kind;
  const BodyId a{1}, b{2}, c{3};
  const Vec2<double> anchor = start[a].position + random.point(1),
                     far_b = start[b].position + random.point(1);
  const Vec2<double> axis = Rotation<double>(random.uniform(-pi, pi)) * Vec2<double>(1, 0);
  const double far = 100;  // [m or rad] margin of limits, and a tooth that is never passed
  const JointSpring spring{.softness = SwingSoftness{.frequency = 2, .damping_ratio = 0.5}, .rest = 0.3};
  return {
      {"revolute with a servo, a spring and a ratchet",
       joint_rows<RevoluteJoint, Real>(
           {.a = a,
            .b = b,
            .anchor = anchor,
            .motor = RevoluteJoint::Motor{.speed = 2, .max_torque = 50, .target = 1},
            .spring = spring,
            .ratchet = -far},
           start)},
      {"slot", joint_rows<PrismaticJoint, Real>({.a = a,
                                                 .b = b,
                                                 .anchor = anchor,
                                                 .axis = axis,
                                                 .kind = Kind::slot,
                                                 .lower = -0.1,
                                                 .upper = 0.3,
                                                 .limit_margin = far},
                                                start)},
      {"wheel", joint_rows<PrismaticJoint, Real>(
                    {.a = a,
                     .b = b,
                     .anchor = far_b,
                     .axis = axis,
                     .kind = Kind::wheel,
                     .motor = PrismaticJoint::Motor{.speed = 1, .max_force = 9, .target = 0.2},
                     .spring = spring},
                    start)},
      {"soft weld", joint_rows<WeldJoint, Real>({.a = a,
                                                 .b = b,
                                                 .anchor = anchor,
                                                 .softness = spring.softness,
                                                 .bending = SpringSoftness{.stiffness = 9, .damping = 1}},
                                                start)},
      {"rope with a least length", joint_rows<DistanceJoint, Real>({.a = a,
                                                                    .b = b,
                                                                    .anchor_a = anchor,
                                                                    .anchor_b = far_b,
                                                                    .kind = DistanceJoint::Kind::rope,
                                                                    .least = 0.5,
                                                                    .slack_margin = far},
                                                                   start)},
      {"rack",
       joint_rows<GearJoint, Real>(
           {.a = a, .b = b, .radius_a = 0.5, .mesh = GearJoint::Mesh::rack, .axis = axis}, start),
       false},
      {"rack on a carrier",
       joint_rows<GearJoint, Real>(
           {.a = a, .b = b, .c = c, .radius_a = 0.5, .mesh = GearJoint::Mesh::rack, .axis = axis}, start)},
  };
}

/// The joints of two bodies, and contacts, between bodies 1 and 2 that start from these poses.
template <Scalar Real>
List<ConstraintUnderTest<Real>> constraints_of_two(const PerBody<Pose<double>>& start, test::Random& random) {
  const BodyId a{1}, b{2};
  const Vec2<double> near_a = start[a].position + random.point(1);
  const Vec2<double> near_b = start[b].position + random.point(1);
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
      {"slide on the ground",
       joint_rows<PrismaticJoint, Real>(
           {.b = b, .anchor = near_b, .axis = axis, .lower = -0.1, .upper = 0.3, .limit_margin = far}, start),
       false},
      {"contact of discs", contact_rows<Real>(circle(0.3, offset_a), circle(0.5, {0.3, 0.1}))},
      {"contact of a disc and a box", contact_rows<Real>(circle(0.3, offset_a), box(40, 1))},
  };
}

/// Everything that states rows, between bodies 1 to 4 that start from these poses.
template <Scalar Real>
List<ConstraintUnderTest<Real>> all_constraints(const PerBody<Pose<double>>& start, test::Random& random) {
  List<ConstraintUnderTest<Real>> constraints = constraints_of_two<Real>(start, random);
  for (const auto& more : {pulleys<Real>(start, random), gears_and_drag<Real>(start, random),
                           driven_joints<Real>(start, random)}) {
    constraints.insert(constraints.end(), more.begin(), more.end());
  }
  return constraints;
}

/// The ground, and two bodies some 4 m apart, one above the other, at any angle (the second one nearly
/// level); and two more, 4 m apart on the right.
inline PerBody<Pose<double>> random_poses(test::Random& random) {
  const Vec2<double> place = random.point(2);
  const Vec2<double> other = place + Vec2<double>(random.uniform(-1, 1), random.uniform(-5, -3));
  const Vec2<double> right(4, 0);
  return {{},
          {place, random.uniform(-pi, pi)},
          {other, random.uniform(-0.3, 0.3)},
          {place + right, random.uniform(-pi, pi)},
          {other + right, random.uniform(-pi, pi)}};
}

}  // namespace cairn::testing
