// Floor 8. Adding to a scene what its file says, each thing when what it needs is there.
#include <cairn/scenes/scene_builder.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include <cairn/math/list.hpp>
#include <cairn/world/scene_length.hpp>

namespace cairn {

BodyId SceneBuilder::add(const SceneTable& table, const BodySpec& spec, const std::string& name) {
  if (scene_.bodies().size() > most_scene_bodies) {
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
  names_.add(table, name, id);
  if (table.has("displaced") || table.has("displaced_angle")) displace(table, id);
  return id;
}

void SceneBuilder::add_ground(const SceneTable& table) {
  GroundSpec spec;
  spec.half_width *= std::max(1.0, length_);
  spec.thickness *= std::max(1.0, length_);
  table.read(spec);
  table.guard([&] { scene_.add_ground(spec); });
}

void SceneBuilder::require_room_for_joint(const SceneTable& table) const {
  const int most = 50000;
  if (scene_.joints().size() >= most) table.refuse("", "part of a scene of at most 50000 joints", "one more");
}

void SceneBuilder::require_different(const SceneTable& table, const List<BodyId>& bodies) const {
  if (std::ssize(std::set<BodyId>(bodies.begin(), bodies.end())) < bodies.size())
    table.refuse("", "between different bodies", names_.of(bodies));
}

void SceneBuilder::require_movable(const SceneTable& table, const Constraint& joint) const {
  List<BodyId> bodies;
  for (const Attachment& place : joint.attachments()) bodies.push_back(place.body);
  const auto can_move = [this](BodyId body) { return scene_.bodies()[body].spec.type == BodyType::dynamic; };
  if (std::none_of(bodies.begin(), bodies.end(), can_move))
    table.refuse("", "on at least one body that can move", names_.of(bodies));
}

SwingSoftness SceneBuilder::spring_of(const SceneTable& table) const {
  if (table.has("softness")) table.refuse("frequency", "left out where there is a softness");
  return {.frequency = table.get<double>("frequency"), .damping_ratio = table.get<double>("damping_ratio")};
}

void SceneBuilder::finish() {
  length_ = scene_length(scene_);
  for (const SceneBody& each : scene_.bodies()) poses_.push_back(each.pose);
  for (const auto& work : waiting_) work();
  for (const auto& work : last_) work();
}

void SceneBuilder::add(const SceneTable& table, const SceneEvent& event) {
  const int most = 1000;
  if (scene_.events().size() >= most) table.refuse("", "part of a scene of at most 1000 events", "one more");
  table.guard([&] { scene_.add(event); });
}

void SceneBuilder::add(const SceneTable& table, const PairMaterial& pair) {
  SceneSettings settings = scene_.settings();
  settings.mixing.pairs.push_back(pair);
  table.guard([&] { scene_.set_settings(settings); });
}

void SceneBuilder::displace(const SceneTable& table, BodyId body) {
  last_.push_back([this, table, body] {
    table.guard([&] {
      cairn::displace(scene_, body, table.get<Vec2<double>>("displaced"),
                      table.get<double>("displaced_angle"));
    });
  });
}

}  // namespace cairn
