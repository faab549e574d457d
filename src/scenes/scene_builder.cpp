// Floor 8. Bodies by name.
#include "scenes/scene_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "math/nearest.hpp"
#include "world/scene_length.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

bool is_scene_name(const std::string& name) {
  const auto belongs = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
  return !name.empty() && name.size() <= 60 && std::all_of(name.begin(), name.end(), belongs);
}

/// `what`: "a body".
std::string names_rule(const std::string& what, const std::string& word, const List<std::string>& names) {
  const std::string near = nearest(word, names);
  if (!near.empty()) return "the name of " + what + " (" + near + "?)";
  const int most = 8;  // names that a message lists
  std::string rule = "the name of " + what + ": ";
  for (int i = 0; i < std::min(most, names.size()); ++i) rule += (i > 0 ? ", " : "") + names[i];
  return rule + (names.size() > most ? " and so on" : "");
}

}  // namespace

std::string SceneBuilder::claim_name(const SceneTable& table, const std::string& fallback) {
  const std::string name = table.has("name") ? table.text("name") : fallback;
  if (table.has("name") && !is_scene_name(name)) {
    table.refuse("name", "1 to 60 letters, digits, _ and -");
  }
  if (!claimed_.insert(name).second) {
    if (name == "ground") table.refuse("name", "another name: \"ground\" is what cannot move");
    table.refuse("name", "a name that nothing else has", '"' + name + "\" once more");
  }
  return name;
}

BodyId SceneBuilder::add(const SceneTable& table, const BodySpec& spec, const std::string& name) {
  if (names_.size() > most_scene_bodies) {
    table.refuse("", fmt::format("part of a scene of at most {} bodies", most_scene_bodies), "one more");
  }
  const bool needs_none = spec.mass && (spec.inertia || spec.fixed_rotation);
  if (spec.shapes.empty() && spec.type == BodyType::dynamic && !needs_none) {
    refuse_scene(table.context().file, table.mark(),
                 fmt::format("{}: {} has no shape; give it a box, circle, capsule or polygon, or else mass "
                             "and inertia",
                             table.path(), name));
  }
  BodyId id;
  table.guard([&] { id = scene_.add(spec); });
  if (!ids_.emplace(name, id).second) table.refuse("", "a body with a name of its own", name + " once more");
  names_.push_back(name);
  return id;
}

void SceneBuilder::add_ground(const SceneTable& table) {
  const double length = std::max(1.0, length_), enough = length * GroundSpec().half_width;
  table.guard([&] {
    scene_.add_ground({.height = table.number("height"),
                       .half_width = table.has("half_width") ? table.number("half_width") : enough,
                       .thickness = length * GroundSpec().thickness,
                       .friction = table.number("friction"),
                       .restitution = table.number("restitution")});
  });
}

BodyId SceneBuilder::body(const SceneTable& table, const std::string& key) const {
  const std::string name = table.text(key);
  const auto found = ids_.find(name);
  if (found == ids_.end()) table.refuse(key, names_rule("a body", name, {names_.begin(), names_.end()}));
  return found->second;
}

JointId SceneBuilder::joint(const SceneTable& table, const std::string& key) const {
  const std::string name = table.text(key);
  const auto found = joint_ids_.find(name);
  if (found != joint_ids_.end()) return found->second;
  if (joint_ids_.empty()) table.refuse(key, "the name of a joint, and there is none");
  table.refuse(key, names_rule("a joint", name, joint_names()));
}

std::variant<BodyId, JointId> SceneBuilder::body_or_joint(const SceneTable& table,
                                                          const std::string& key) const {
  const std::string name = table.text(key);
  if (ids_.contains(name)) return body(table, key);
  if (joint_ids_.contains(name)) return joint(table, key);
  List<std::string> names(names_.begin(), names_.end());
  for (const std::string& each : joint_names()) names.push_back(each);
  table.refuse(key, names_rule("a body or a joint", name, names));
}

List<std::string> SceneBuilder::joint_names() const {
  List<std::string> names;
  for (const auto& [name, id] : joint_ids_) names.push_back(name);
  return names;
}

List<BodyId> SceneBuilder::bodies(const SceneTable& table, const std::string& key) const {
  const std::string name = table.text(key);
  if (name.size() < 3 || name.substr(name.size() - 2) != ".*") return {body(table, key)};
  const std::string beginning = name.substr(0, name.size() - 1);
  List<BodyId> found;
  for (const BodyId body : names_.indices()) {
    if (names_[body].starts_with(beginning)) found.push_back(body);
  }
  if (found.empty()) table.refuse(key, "the name of a row, and .* behind it");
  return found;
}

void SceneBuilder::require_room_for_joint(const SceneTable& table) const {
  const int most = 50000;
  if (scene_.joints().size() >= most) table.refuse("", "part of a scene of at most 50000 joints", "one more");
}

std::string SceneBuilder::listed(const List<BodyId>& bodies) const {
  std::string text;
  for (const BodyId body : bodies) text += (text.empty() ? "" : ", ") + names_[body];
  return text;
}

void SceneBuilder::require_different(const SceneTable& table, const List<BodyId>& bodies) const {
  if (std::ssize(std::set<BodyId>(bodies.begin(), bodies.end())) < bodies.size())
    table.refuse("", "between different bodies", listed(bodies));
}

void SceneBuilder::require_movable(const SceneTable& table, const Constraint& joint) const {
  List<BodyId> bodies;
  for (const Attachment& place : joint.attachments()) bodies.push_back(place.body);
  const auto can_move = [this](BodyId body) { return scene_.bodies()[body].spec.type == BodyType::dynamic; };
  if (std::none_of(bodies.begin(), bodies.end(), can_move))
    table.refuse("", "on at least one body that can move", listed(bodies));
}

SwingSoftness SceneBuilder::spring_of(const SceneTable& table) const {
  if (table.has("softness")) table.refuse("frequency", "left out where there is a softness");
  return {.frequency = table.number("frequency"), .damping_ratio = table.number("damping_ratio")};
}

void SceneBuilder::finish() {
  length_ = scene_length(scene_);
  for (const SceneBody& each : scene_.bodies()) poses_.push_back(each.pose);
  for (const auto& work : waiting_) work();
  for (const auto& work : last_) work();
}

void SceneBuilder::add_event(const SceneTable& table, const SceneEvent& event) {
  const int most = 1000;
  if (scene_.events().size() >= most) table.refuse("", "part of a scene of at most 1000 events", "one more");
  table.guard([&] { scene_.add_event(event); });
}

void SceneBuilder::displace(const SceneTable& table, BodyId body) {
  last_.push_back([this, table, body] {
    table.guard([&] { scene_.displace(body, table.point("displaced"), table.number("displaced_angle")); });
  });
}

}  // namespace cairn
