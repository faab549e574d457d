// Floor 8. A scene under construction: bodies, and joints that wait for them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/constraints/softness.hpp>
#include <cairn/math/list.hpp>
#include <cairn/scenes/scene_list.hpp>
#include <cairn/scenes/scene_names.hpp>
#include <cairn/scenes/scene_table.hpp>
#include <cairn/world/scene.hpp>

namespace cairn {

/// Bodies come at once, in the order of the file; joints when all bodies are there, in the order of the file.
class SceneBuilder {
 public:
  explicit SceneBuilder(const SceneSettings& settings) : scene_(settings) {}

  /// As SceneNames::claim.
  std::string claim_name(const SceneTable& table, const std::string& fallback) {
    return names_.claim(table, fallback);
  }
  /// A body, which moves as its table says once all joints are there, so that they begin with an error.
  /// @throws std::invalid_argument for what Scene::add refuses, and beyond 20,000 bodies.
  BodyId add(const SceneTable& table, const BodySpec& spec, const std::string& name);
  /// Once all bodies are there, for it is as wide as they want it.
  void add_ground(const SceneTable& table);

  /// Runs `work` once all bodies are there.
  void later(std::function<void()> work) { waiting_.push_back(std::move(work)); }
  void finish();
  /// What is known of two surfaces together, once finish() was called. @throws std::invalid_argument as
  /// Scene::set_settings.
  void add(const SceneTable& table, const PairMaterial& pair);
  /// What is to happen, once finish() was called. @throws std::invalid_argument as Scene::add.
  void add(const SceneTable& table, const SceneEvent& event);
  /// Nothing else has the name.
  template <typename Joint>
  void join(const SceneTable& table, const std::string& name, const typename Joint::Spec& spec,
            JointCollision collision = JointCollision::as_usual) {
    require_room_for_joint(table);
    if constexpr (requires { spec.a; }) require_different(table, {spec.a, spec.b});
    if constexpr (requires { spec.c; }) require_different(table, {spec.a, spec.b, spec.c});
    table.guard([&] {
      const auto joint = std::make_shared<const Joint>(spec, poses_);
      require_movable(table, *joint);
      const JointId id = scene_.join(joint, collision);
      if (table.has("frequency")) scene_.change(id, spring_of(table));
      JointStrength strength;
      table.read(strength);
      if (strength.is_finite()) scene_.change(id, strength);
      names_.add(name, id);
    });
  }

  const Scene& scene() const { return scene_; }
  /// [m] scene_length() for joints, and for what comes once all bodies are there.
  double length() const { return length_; }
  const SceneNames& names() const { return names_; }
  /// Where the bodies were when the joints were made; none before finish().
  const PerBody<Pose<double>>& poses() const { return poses_; }

 private:
  void displace(const SceneTable& table, BodyId body);
  void require_room_for_joint(const SceneTable& table) const;
  // What constraints refuse by the ids of bodies, by their names.
  void require_different(const SceneTable& table, const List<BodyId>& bodies) const;
  void require_movable(const SceneTable& table, const Constraint& joint) const;
  // Of the group give. @throws std::invalid_argument for a softness beside it.
  SwingSoftness spring_of(const SceneTable& table) const;

  Scene scene_;
  double length_ = 1;  // [m]
  SceneNames names_ = {};
  List<std::function<void()>> waiting_ = {};
  List<std::function<void()>> last_ = {};  // behind all joints
  PerBody<Pose<double>> poses_ = {};       // once all bodies are there
};

/// What the keys of a table say that are members of a BodySpec.
BodySpec body_of(const SceneTable& table);
/// The shape of a table with the group shape; empty: it has none.
List<Shape<double>> shape_of(const SceneTable& table);
/// Of the table under a key; none where there is no table.
std::optional<Softness> softness_of(const SceneTable& table, const std::string& key = "softness");

/// A joint of a row or a chain as its key says: a pin or a weld at anchor_a, or else a rod, rope or spring.
void join_links(SceneBuilder& builder, const SceneTable& table, const std::string& name,
                DistanceJoint::Spec ends);
/// The name of one of many, counted from 0: "stack.1".
inline std::string numbered(const std::string& name, int i) { return name + "." + std::to_string(i + 1); }

/// Adds what the table says. Its kind is one of those that make bodies.
void build_bodies(SceneBuilder& builder, const SceneTable& table, int number);
/// `number`: which [[joint]] it is.
void build_joint(SceneBuilder& builder, const SceneContext& context, const SceneValue& value, int number);
/// `fields`, with what the tables of the file add to them.
Fields fields_of(const SceneTable& file, Fields fields);
/// When what a table says is to happen: at its time, or at a touch. What is done is left to be filled in.
/// @throws std::invalid_argument for a time beside a touch, and for keys of a touch beside none.
SceneEvent event_of(const SceneBuilder& builder, const SceneTable& table);
/// Every [[force]] and [[path]] of the file, once all bodies are there.
void build_acting(SceneBuilder& builder, const SceneTable& file);
/// Every [[contact]] of the file, once all bodies are there.
void read_contacts(SceneBuilder& builder, const SceneTable& file);
/// Every [[event]] of the file, once all bodies and joints are there.
void build_events(SceneBuilder& builder, const SceneTable& file);
/// Every [[expect.body]] of the file, once the events are known.
List<ExpectedPlace> expected_places(const SceneBuilder& builder, const SceneTable& file);

// One for each kind of table that stands for many bodies; `name` is that of the whole.
void build_link(SceneBuilder& builder, const SceneTable& table, const std::string& name);
void build_stack(SceneBuilder& builder, const SceneTable& table, const std::string& name);
void build_pyramid(SceneBuilder& builder, const SceneTable& table, const std::string& name);
void build_row(SceneBuilder& builder, const SceneTable& table, const std::string& name);
void build_pile(SceneBuilder& builder, const SceneTable& table, const std::string& name);
void build_arch(SceneBuilder& builder, const SceneTable& table, const std::string& name);
void build_dominoes(SceneBuilder& builder, const SceneTable& table, const std::string& name);
void build_cards(SceneBuilder& builder, const SceneTable& table, const std::string& name);
void build_cradle(SceneBuilder& builder, const SceneTable& table, const std::string& name);
void build_chain(SceneBuilder& builder, const SceneTable& table, const std::string& name);

}  // namespace cairn
