// Floor 5. Taking out of a scene, moving what is in it, and fastening joints.
#include <algorithm>

#include <cairn/math/check.hpp>
#include <cairn/world/scene.hpp>

namespace cairn {

namespace {

/// The bodies that a joint is fastened to, and those that only its rows name, as a gear's carrier.
List<BodyId> bodies_of(const Constraint& joint, const PerBody<Pose<double>>& poses) {
  List<BodyId> bodies;
  for (const Attachment& place : joint.attachments()) bodies.push_back(place.body);
  RowSpecs<double> rows;
  joint.append_rows(poses, rows);
  for (const RowSpec<double>& row : rows) {
    bodies.push_back(row.a);
    bodies.push_back(row.b);
    for (int k = 0; k < row.extra_count; ++k) bodies.push_back(row.extra[k].body);
  }
  return bodies;
}

}  // namespace

JointId Scene::join(std::shared_ptr<const Constraint> joint, JointCollision collision) {
  require(joint != nullptr, "Scene::join", "joint", "a constraint", "nullptr");
  std::string named;
  bool can_move = false;
  for (const Attachment& place : joint->attachments()) {
    require_body(place.body, "attachment");
    can_move |= bodies()[place.body].spec.type == BodyType::dynamic;
    named += (named.empty() ? "" : ", ") + std::to_string(place.body.index);
  }
  require(can_move, "Scene::join", "bodies", "at least one that can move", named);
  const bool collide =
      collision == JointCollision::as_usual ? joint->bodies_collide() : collision == JointCollision::on;
  return joints_.add(std::move(joint), collide);
}

/// Where in joints() a joint is.
int Scene::number_of(JointId joint, const char* who) const {
  const std::optional<int> number = joints_.number_of(joint);
  require(number.has_value(), who, "joint", "the id of a joint of this scene", joint.index);
  return *number;
}

std::shared_ptr<const Constraint> Scene::with_motor(JointId joint, const std::optional<JointMotor>& motor,
                                                    const char* who) const {
  const Constraint& before = *joints_[number_of(joint, who)];
  std::shared_ptr<const Constraint> result = before.with_motor(motor);
  require(result != nullptr, who, "joint", "one that can have a motor", before.name());
  return result;
}

void Scene::change(JointId joint, const std::optional<JointMotor>& motor) {
  const char* const who = "Scene::change";
  joints_.change(number_of(joint, who), with_motor(joint, motor, who));
}

void Scene::change(JointId joint, const SwingSoftness& spring) {
  const char* const who = "Scene::change";
  const int number = number_of(joint, who);
  require_softness(spring, who);
  joints_.change(number, spring);
}

void Scene::change(JointId joint, const JointStrength& strength) {
  const char* const who = "Scene::change";
  const int number = number_of(joint, who);
  require(strength.force > 0, who, "break_force", "> 0 N", strength.force);
  require(strength.torque > 0, who, "break_torque", "> 0 N m", strength.torque);
  require(std::isinf(strength.torque) || joints_[number]->attachments().size() <= 2, who, "break_torque",
          "left out of a joint of more than two bodies", strength.torque);
  joints_.change(number, strength);
}

void Scene::remove(JointId joint) {
  joints_.remove({number_of(joint, "Scene::remove")});
  forget_events();
}

void Scene::remove(BodyId body) {
  require_changeable(*this, body, "Scene::remove");
  const PerBody<Pose<double>> start = poses();
  List<int> held;
  for (int i = 0; i < joints_.size(); ++i) {
    if (holds(i, body, start)) held.push_back(i);
  }
  joints_.remove(held);
  own_bodies()[body] = {.spec = {.type = BodyType::static_body}, .removed = true};
  forget_events();
}

void Scene::place(BodyId body, const Pose<double>& pose, const Vec3<double>& velocity) {
  const char* const who = "Scene::place";
  require_changeable(*this, body, who);
  require_finite(pose.position, who, "position", "m");
  require_finite(pose.angle, who, "angle", "rad");
  const Vec2<double> linear = velocity.head<2>();
  require_finite(linear, who, "velocity", "m/s");
  require_finite(velocity.z(), who, "angular velocity", "rad/s");
  SceneBody& placed = own_bodies()[body];
  require(placed.spec.type != BodyType::static_body || velocity.isZero(0), who, "velocity",
          "0 for a static body", velocity.norm());
  const Vec2<double> frame = placed.pose.local(placed.spec.position);  // goes with the body
  placed.pose = pose;
  placed.spec.position = pose.world(frame);
  placed.spec.angle = pose.angle;
  placed.spec.velocity = linear;
  placed.spec.angular_velocity = velocity.z();
}

PerBody<Pose<double>> Scene::poses() const {
  PerBody<Pose<double>> result;
  for (const SceneBody& body : bodies()) result.push_back(body.pose);
  return result;
}

/// Whether joint number `joint` has to do with a body.
bool Scene::holds(int joint, BodyId body, const PerBody<Pose<double>>& start) const {
  const List<BodyId> bodies = bodies_of(*joints_[joint], start);
  return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
}

bool Scene::has_joints(BodyId body) const {
  const PerBody<Pose<double>> start = poses();
  bool found = false;
  for (int i = 0; i < joints_.size(); ++i) found |= holds(i, body, start);
  return found;
}

void Scene::require_body(BodyId id, const char* field) const {
  require(id.index >= 0 && id.index < bodies().size(), "Scene::join", field, "the id of a body of this scene",
          id.index);
  require(!bodies()[id].removed, "Scene::join", field, "a body that was not removed", id.index);
}

/// A joint needs a body that can move besides this one.
void Scene::require_other_movers(BodyId body, BodyType type) const {
  for (int i = 0; i < joints_.size(); ++i) {
    bool is_fastened = false, others_move = false;
    for (const Attachment& place : joints_[i]->attachments()) {
      is_fastened |= place.body == body;
      others_move |= place.body != body && bodies()[place.body].spec.type == BodyType::dynamic;
    }
    require(!is_fastened || others_move, "Scene::change", "type",
            "dynamic, as nothing else that joint " + std::to_string(joints_.id(i).index) +
                " is fastened to can move",
            type == BodyType::kinematic ? "kinematic" : "static");
  }
}

void displace(Scene& scene, BodyId body, const Vec2<double>& offset, double angle) {
  require_changeable(scene, body, "displace");
  require_finite(offset, "displace", "offset", "m");
  require_finite(angle, "displace", "angle", "rad");
  const SceneBody& from = scene.bodies()[body];
  const Vec2<double>& velocity = from.spec.velocity;
  scene.place(body, {from.pose.position + offset, from.pose.angle + angle},
              {velocity.x(), velocity.y(), from.spec.angular_velocity});
}

void require_changeable(const Scene& scene, BodyId body, const char* place) {
  require(body.index > 0 && body.index < scene.bodies().size(), place, "body",
          "the id of a body other than the ground", body.index);
  require(!scene.bodies()[body].removed, place, "body", "one that was not removed", body.index);
}

}  // namespace cairn
