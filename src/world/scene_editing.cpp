// Floor 5. Taking out of a scene, moving what is in it, and fastening joints.
#include <algorithm>

#include "math/check.hpp"
#include "world/scene.hpp"

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

/// Gives a body another pose; the frame that its shapes were given in goes with it.
void set_pose(SceneBody& body, const Pose<double>& pose) {
  const Vec2<double> frame = body.pose.local(body.spec.position);
  body.pose = pose;
  body.spec.position = pose.world(frame);
  body.spec.angle = pose.angle;
}

}  // namespace

JointId Scene::add_joint(std::shared_ptr<const Constraint> joint, JointCollision collision) {
  require(joint != nullptr, "Scene::add_joint", "joint", "a constraint", "nullptr");
  std::string named;
  bool can_move = false;
  for (const Attachment& place : joint->attachments()) {
    require_body(place.body, "attachment");
    can_move |= bodies()[place.body].spec.type == BodyType::dynamic;
    named += (named.empty() ? "" : ", ") + std::to_string(place.body.index);
  }
  require(can_move, "Scene::add_joint", "bodies", "at least one that can move", named);

  const bool collide =
      collision == JointCollision::as_usual ? joint->bodies_collide() : collision == JointCollision::on;
  if (!collide) keep_apart(*joint);
  const JointId id{joints_made_++};
  fastenings_.push_back({.id = id, .collide = collide});
  joints_.push_back(std::move(joint));
  return id;
}

JointId Scene::joint_id(int number) const {
  require(number >= 0 && number < joints_.size(), "Scene::joint_id", "number", "that of a joint in joints()",
          number);
  return fastenings_[number].id;
}

/// Where in joints() a joint is.
int Scene::number_of(JointId joint, const char* who) const {
  const auto is_it = [joint](const Fastening& one) { return one.id == joint; };
  const auto found = std::find_if(fastenings_.begin(), fastenings_.end(), is_it);
  require(found != fastenings_.end(), who, "joint", "the id of a joint of this scene", joint.index);
  return static_cast<int>(found - fastenings_.begin());
}

void Scene::set_joint_soft(JointId joint, const SwingSoftness& spring) {
  const int number = number_of(joint, "Scene::set_joint_soft");
  require_softness(spring, "Scene::set_joint_soft");
  fastenings_[number].soft = spring;
}

const SwingSoftness& Scene::joint_soft(int number) const {
  const std::optional<SwingSoftness>& own = fastenings_[number].soft;
  return own ? *own : settings_.stabilization.joint_soft;
}

void Scene::remove(JointId joint) {
  const int number = number_of(joint, "Scene::remove");
  joints_.erase(joints_.begin() + number);
  fastenings_.erase(fastenings_.begin() + number);
  find_apart();
  forget_events();
}

void Scene::remove(BodyId body) {
  require_changeable(body, "Scene::remove");
  const PerBody<Pose<double>> start = poses();
  for (int i = joints_.size() - 1; i >= 0; --i) {
    if (!holds(i, body, start)) continue;
    joints_.erase(joints_.begin() + i);
    fastenings_.erase(fastenings_.begin() + i);
  }
  find_apart();
  own_bodies()[body] = {.spec = {.type = BodyType::static_body}, .removed = true};
  forget_events();
}

void Scene::place(BodyId body, const Pose<double>& pose, const Vec3<double>& velocity) {
  const char* const who = "Scene::place";
  require_changeable(body, who);
  require_finite(pose.position, who, "position", "m");
  require_finite(pose.angle, who, "angle", "rad");
  const Vec2<double> linear = velocity.head<2>();
  require_finite(linear, who, "velocity", "m/s");
  require_finite(velocity.z(), who, "angular velocity", "rad/s");
  SceneBody& placed = own_bodies()[body];
  require(placed.spec.type != BodyType::static_body || velocity.isZero(0), who, "velocity",
          "0 for a static body", velocity.norm());
  set_pose(placed, pose);
  placed.spec.velocity = linear;
  placed.spec.angular_velocity = velocity.z();
}

void Scene::displace(BodyId body, const Vec2<double>& offset, double angle) {
  require_changeable(body, "Scene::displace");
  require_finite(offset, "Scene::displace", "offset", "m");
  require_finite(angle, "Scene::displace", "angle", "rad");
  SceneBody& moved_body = own_bodies()[body];
  const Pose<double> pose = {moved_body.pose.position + offset, moved_body.pose.angle + angle};
  require_finite(pose.position, "Scene::displace", "position", "m");
  set_pose(moved_body, pose);
}

PerBody<Pose<double>> Scene::poses() const {
  PerBody<Pose<double>> result;
  for (const SceneBody& body : bodies()) result.push_back(body.pose);
  return result;
}

void Scene::keep_apart(const Constraint& joint) {
  const List<Attachment> places = joint.attachments();
  for (int i = 0; i < places.size(); ++i) {
    for (int k = 0; k < i; ++k) {
      const std::pair<BodyId, BodyId> pair = std::minmax(places[i].body, places[k].body);
      const auto where = std::lower_bound(apart_.begin(), apart_.end(), pair);
      if (where == apart_.end() || *where != pair) apart_.insert(where, pair);
    }
  }
}

/// A pair stays apart while one of its joints says so.
void Scene::find_apart() {
  apart_.clear();
  for (const int i : joints_.indices()) {
    if (!fastenings_[i].collide) keep_apart(*joints_[i]);
  }
}

/// Whether joint number `joint` has to do with a body.
bool Scene::holds(int joint, BodyId body, const PerBody<Pose<double>>& start) const {
  const List<BodyId> bodies = bodies_of(*joints_[joint], start);
  return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
}

bool Scene::has_joints(BodyId body) const {
  const PerBody<Pose<double>> start = poses();
  bool found = false;
  for (const int i : joints_.indices()) found |= holds(i, body, start);
  return found;
}

void Scene::require_body(BodyId id, const char* field) const {
  require(id.index >= 0 && id.index < bodies().size(), "Scene::join", field, "the id of a body of this scene",
          id.index);
  require(!bodies()[id].removed, "Scene::join", field, "a body that was not removed", id.index);
}

void Scene::require_changeable(BodyId id, const char* who) const {
  require(id.index > 0 && id.index < bodies().size(), who, "body", "the id of a body other than the ground",
          id.index);
  require(!bodies()[id].removed, who, "body", "one that was not removed", id.index);
}

/// A joint needs a body that can move besides this one.
void Scene::require_other_movers(BodyId body, BodyType type) const {
  for (const int i : joints_.indices()) {
    bool is_fastened = false, others_move = false;
    for (const Attachment& place : joints_[i]->attachments()) {
      is_fastened |= place.body == body;
      others_move |= place.body != body && bodies()[place.body].spec.type == BodyType::dynamic;
    }
    require(!is_fastened || others_move, "Scene::change", "type",
            "dynamic, as nothing else that joint " + std::to_string(fastenings_[i].id.index) +
                " is fastened to can move",
            type == BodyType::kinematic ? "kinematic" : "static");
  }
}

}  // namespace cairn
