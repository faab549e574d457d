// Floor 5. From a world to plain values.
#include "world/snapshot.hpp"

#include "constraints/springs.hpp"
#include "world/world.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

SnapshotBody snapshot_body(const SceneBody& body, const Pose<double>& pose, const Vec3<double>& velocity) {
  return {.type = body.spec.type,
          .pose = pose,
          .velocity = velocity,
          .mass = body.mass,
          .inertia = body.inertia,
          .gravity_scale = body.spec.gravity_scale,
          .removed = body.removed,
          .sensor = body.spec.sensor,
          .category = body.spec.category,
          .collides_with = body.spec.collides_with,
          .shapes = body.spec.shapes};
}

/// What the rows of a contact gave: a normal row for each point, and a friction row behind it, or behind
/// both, where there is friction.
template <Scalar Real>
struct ContactAnswer {
  BodyId a = {};                 // the first body
  BodyId b = {};                 // the second body
  Real friction = 0;             // mu
  Span<const Real> impulse;      // [N s] of each row
  const char* is_new = nullptr;  // likewise: it had no impulse to start from
};

/// Of contact i of a record, whose rows are, or would be, behind so many rows.
template <Scalar Real>
ContactAnswer<Real> answer_of(const StepRecord<Real>& record, int i, int rows_before) {
  const char* const is_new = record.is_new.as_vector().data() + rows_before;
  if (!record.has_rows) {
    const Contact<Real>& contact = record.contacts[i];
    return {contact.a, contact.b, contact.friction, record.impulses(contact), is_new};
  }
  const RowBlock& block = record.problem.blocks[record.first_contact_block + i];
  if (block.count == 0) return {};
  const ConstraintRow<Real>& first = record.problem.rows[block.first];
  const ConstraintRow<Real>& last = record.problem.rows[block.first + block.count - 1];
  const Real friction = last.bounds.is_friction() ? last.bounds.friction : Real(0);
  return {first.a, first.b, friction, record.impulses(block), is_new};
}

/// One friction row for two points: each has the share that its normal impulse has of the load.
void share_friction(double impulse, SnapshotContact& first, SnapshotContact& second) {
  const double load = first.normal_impulse + second.normal_impulse;
  const double share = load > 0 ? first.normal_impulse / load : 0.5;
  first.friction_impulse = share * impulse;
  second.friction_impulse = (1 - share) * impulse;
}

/// The points of one manifold.
template <Scalar Real>
void append_contacts(const Manifold<Real>& manifold, const ContactAnswer<Real>& answer,
                     List<SnapshotContact>& contacts) {
  const int rows = answer.impulse.size();
  if (rows == 0) return;
  const bool rubs_at_points = rows == 2 * manifold.count;
  for (int i = 0; i < manifold.count; ++i) {
    const ManifoldPoint<Real>& point = manifold.points[i];
    const int row = rubs_at_points ? 2 * i : i;
    contacts.push_back({.a = answer.a,
                        .b = answer.b,
                        .position = point.position.template cast<double>(),
                        .normal = manifold.normal.template cast<double>(),
                        .separation = static_cast<double>(point.separation),
                        .normal_impulse = static_cast<double>(answer.impulse[row]),
                        .friction = static_cast<double>(answer.friction),
                        .is_new = answer.is_new[row] != 0});
    if (rubs_at_points) contacts.back().friction_impulse = static_cast<double>(answer.impulse[row + 1]);
  }
  if (rows == manifold.count + 1 && !rubs_at_points)
    share_friction(static_cast<double>(answer.impulse[rows - 1]), contacts[contacts.size() - 2],
                   contacts.back());
}

template <Scalar Real>
SnapshotJoint snapshot_joint(const Constraint& joint, const BodyState<Real>& state) {
  const List<Attachment> places = joint.attachments();
  const auto world_point = [&state](const Attachment& place) -> Vec2<double> {
    Pose<Real> pose = state.pose[place.body];
    if (!place.turns) pose.angle = 0;
    return pose.world(place.anchor.template cast<Real>()).template cast<double>();
  };
  SnapshotJoint result{.name = joint.name(), .a = places.front().body, .b = places.back().body};
  result.anchor_a = world_point(places.front());
  result.anchor_b = world_point(places.back());
  for (int i = 1; i + 1 < places.size(); ++i) result.between.push_back(world_point(places[i]));
  RowSpecs<Real> specs;
  joint.append_rows(state.pose, specs);
  double sum = 0;
  for (const RowSpec<Real>& spec : specs) {
    sum += static_cast<double>(violation(spec) * violation(spec));
    result.energy += spring_energy(spec, state.inverse_mass);
  }
  result.drift = std::sqrt(sum);
  return result;
}

}  // namespace

template <Scalar Real>
Snapshot snapshot(const World<Real>& world) {
  const Scene& scene = world.scene();
  const StepRecord<Real>& record = world.last_step();
  Snapshot result{.time = world.clock().time,
                  .step = world.clock().steps,
                  .dt = world.clock().dt / scene.settings().substeps,
                  .gravity = scene.settings().gravity};
  result.apart = scene.apart();
  for (const BodyId body : scene.bodies().indices()) {
    const Pose<Real>& pose = world.bodies().pose[body];
    const Pose<double> double_pose{pose.position.template cast<double>(), static_cast<double>(pose.angle)};
    result.bodies.push_back(snapshot_body(scene.bodies()[body], double_pose,
                                          world.bodies().velocity[body].template cast<double>()));
    result.bodies.back().awake = world.is_awake({body});
  }
  const int joints = scene.joints().size();
  for (int i = 0; i < joints + (world.hand().joint() ? 1 : 0); ++i) {
    SnapshotJoint joint =
        snapshot_joint(i < joints ? *scene.joints()[i] : *world.hand().joint(), world.bodies());
    if (i < record.first_contact_block) {
      const RowBlock& block = record.problem.blocks[i];
      for (int index = block.first; index < block.first + block.count; ++index) {
        const Vec2<Real> push =
            record.problem.rows[index].jacobian_b.template head<2>() * record.problem.impulse[index];
        joint.impulse += push.template cast<double>();
      }
    }
    result.joints.push_back(joint);
  }
  int rows = record.joint_rows();
  for (int i = 0; i < record.manifolds.size(); ++i) {
    const ContactAnswer<Real> answer = answer_of(record, i, rows);
    append_contacts(record.manifolds[i], answer, result.contacts);
    rows += answer.impulse.size();
  }
  return result;
}

template Snapshot snapshot(const World<float>&);
template Snapshot snapshot(const World<double>&);
template Snapshot snapshot(const World<long double>&);

}  // namespace cairn
