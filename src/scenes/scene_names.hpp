// Floor 8. What the bodies and joints of a scene file are called.
#pragma once

#include <map>
#include <set>
#include <string>
#include <variant>

#include <cairn/dynamics/body.hpp>
#include <cairn/math/list.hpp>
#include <cairn/scenes/scene_table.hpp>
#include <cairn/world/scene_joints.hpp>

namespace cairn {

/// Finds what the keys of a file name; a refusal names the nearest that there is.
class SceneNames {
 public:
  /// The name that a table gives, or else `fallback`. @throws std::invalid_argument for one that is taken.
  std::string claim(const SceneTable& table, const std::string& fallback);
  /// The next body. @throws std::invalid_argument where another has the name.
  void add(const SceneTable& table, const std::string& name, BodyId body);
  /// Nothing else has the name.
  void add(const std::string& name, JointId joint) { joint_ids_.emplace(name, joint); }

  /// A name of its own that a key gives. @throws std::invalid_argument for what is none.
  static std::string given(const SceneTable& table, const std::string& key);
  /// The body that a key names.
  BodyId body(const SceneTable& table, const std::string& key) const;
  /// The same, or with "row.*" all bodies of a row.
  List<BodyId> bodies(const SceneTable& table, const std::string& key) const;
  /// The joint that a key names.
  JointId joint(const SceneTable& table, const std::string& key) const;
  /// Whichever of them a key names.
  std::variant<BodyId, JointId> body_or_joint(const SceneTable& table, const std::string& key) const;
  /// Of all bodies.
  const PerBody<std::string>& of_bodies() const { return names_; }
  /// All joints, by name.
  const std::map<std::string, JointId>& joint_ids() const { return joint_ids_; }
  /// Of these bodies, with commas between them.
  std::string of(const List<BodyId>& bodies) const;

 private:
  List<std::string> of_joints() const;

  PerBody<std::string> names_ = {"ground"};
  std::map<std::string, BodyId> body_ids_ = {{"ground", ground}};
  std::map<std::string, JointId> joint_ids_ = {};
  std::set<std::string> claimed_ = {"ground"};
};

}  // namespace cairn
