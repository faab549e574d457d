// Floor 5. From a world to plain values.
#include <cairn/world/snapshot.hpp>

#include <algorithm>

#include <cairn/math/list.hpp>
#include <cairn/world/scene_snapshot.hpp>
#include <cairn/world/world.hpp>

namespace cairn {

namespace {

/// One friction row for two points: each has the share that its normal impulse has of the load.
void share_friction(double impulse, SnapshotContact& first, SnapshotContact& second) {
  const double load = first.normal_impulse + second.normal_impulse;
  const double share = load > 0 ? first.normal_impulse / load : 0.5;
  first.friction_impulse = share * impulse;
  second.friction_impulse = (1 - share) * impulse;
}

/// The points of contact i.
template <Scalar Real>
void append_contact(const StepRecord<Real>& record, int i, List<SnapshotContact>& contacts) {
  const VelocityProblem<Real>& problem = record.problem;
  const Contact<Real>& contact = problem.contacts[i];
  const Manifold<Real>& manifold = contact.manifold;
  const RowBlock& block = problem.blocks[problem.joint_blocks() + i];
  if (block.count == 0) return;
  const bool rubs_at_points = block.count >= 2 * manifold.count;
  const auto impulse = [&](int row) { return static_cast<double>(problem.impulse[row]); };
  for (int k = 0; k < manifold.count; ++k) {
    const ManifoldPoint<Real>& point = manifold.points[k];
    const int row = block.first + (rubs_at_points ? 2 * k : k);
    contacts.push_back({.a = contact.a,
                        .b = contact.b,
                        .position = point.position.template cast<double>(),
                        .normal = manifold.normal.template cast<double>(),
                        .separation = static_cast<double>(point.separation),
                        .normal_impulse = impulse(row),
                        .friction = static_cast<double>(contact.friction),
                        .is_new = record.is_new[row] != 0,
                        .feature = point.feature});
    if (rubs_at_points) contacts.back().friction_impulse = impulse(row + 1);
  }
  if (block.count == manifold.count + 1 && !rubs_at_points)
    share_friction(impulse(block.first + manifold.count), contacts[contacts.size() - 2], contacts.back());
}

}  // namespace

template <Scalar Real>
List<SnapshotContact> contacts_of(const StepRecord<Real>& record) {
  List<SnapshotContact> contacts;
  for (int i = 0; i < record.problem.contacts.size(); ++i) append_contact(record, i, contacts);
  return contacts;
}

template <Scalar Real>
Vec2<double> joint_impulse(const StepRecord<Real>& record, int joint) {
  const VelocityProblem<Real>& problem = record.problem;
  const RowBlock& block = problem.blocks[joint];
  Vec2<double> impulse = {0, 0};
  for (int row = block.first; row < block.first + block.count; ++row) {
    const Vec2<Real> push = problem.rows[row].jacobian_b.template head<2>() * problem.impulse[row];
    impulse += push.template cast<double>();
  }
  return impulse;
}

template <Scalar Real>
Snapshot snapshot(const World<Real>& world) {
  const Scene& scene = world.scene();
  const StepRecord<Real>& record = world.last_step();
  Snapshot result{.time = world.clock().time,
                  .step = world.clock().steps,
                  .dt = world.clock().dt / scene.settings().substeps,
                  .gravity = scene.settings().gravity,
                  .fields = scene.settings().fields};
  result.apart = scene.joints().apart();
  for (const BodyId body : scene.bodies().indices()) {
    const Pose<Real>& pose = world.bodies().pose[body];
    const Pose<double> double_pose{pose.position.template cast<double>(), static_cast<double>(pose.angle)};
    result.bodies.push_back(snapshot_body(scene.bodies()[body], double_pose,
                                          world.bodies().velocity[body].template cast<double>()));
    result.bodies.back().awake = world.is_awake({body});
  }
  add_actions(scene, result);
  const int joints = scene.joints().size();
  for (int i = 0; i < joints + (world.hand().joint() ? 1 : 0); ++i) {
    SnapshotJoint joint =
        snapshot_joint(i < joints ? *scene.joints()[i] : *world.hand().joint(), world.bodies());
    joint.id = i < joints ? scene.joints().id(i) : JointId{-1};
    if (i < record.problem.joint_blocks()) joint.impulse = joint_impulse(record, i);
    result.joints.push_back(joint);
  }
  result.contacts = contacts_of(record);
  for (const std::pair<BodyId, BodyId>& pair : record.passing) {
    const auto where = std::lower_bound(result.apart.begin(), result.apart.end(), pair);
    if (where == result.apart.end() || *where != pair) result.apart.insert(where, pair);
  }
  result.sensed = record.sensed;
  add_occurrences(scene, world.bodies(), result);
  return result;
}

template List<SnapshotContact> contacts_of(const StepRecord<float>&);
template List<SnapshotContact> contacts_of(const StepRecord<double>&);
template Vec2<double> joint_impulse(const StepRecord<float>&, int);
template Vec2<double> joint_impulse(const StepRecord<double>&, int);
template Snapshot snapshot(const World<float>&);
template Snapshot snapshot(const World<double>&);

}  // namespace cairn
