// Floor 8. Names that are given, taken and looked up.
#include <cairn/scenes/scene_names.hpp>

#include <algorithm>
#include <cctype>

#include <cairn/math/nearest.hpp>

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

std::string SceneNames::given(const SceneTable& table, const std::string& key) {
  const std::string name = table.get<std::string>(key);
  if (!is_scene_name(name)) table.refuse(key, "1 to 60 letters, digits, _ and -");
  return name;
}

std::string SceneNames::claim(const SceneTable& table, const std::string& fallback) {
  const std::string name = table.has("name") ? given(table, "name") : fallback;
  if (!claimed_.insert(name).second) {
    if (name == "ground") table.refuse("name", "another name: \"ground\" is what cannot move");
    table.refuse("name", "a name that nothing else has", '"' + name + "\" once more");
  }
  return name;
}

void SceneNames::add(const SceneTable& table, const std::string& name, BodyId body) {
  if (!body_ids_.emplace(name, body).second)
    table.refuse("", "a body with a name of its own", name + " once more");
  names_.push_back(name);
}

BodyId SceneNames::body(const SceneTable& table, const std::string& key) const {
  const std::string name = table.get<std::string>(key);
  const auto found = body_ids_.find(name);
  if (found == body_ids_.end()) table.refuse(key, names_rule("a body", name, {names_.begin(), names_.end()}));
  return found->second;
}

JointId SceneNames::joint(const SceneTable& table, const std::string& key) const {
  const std::string name = table.get<std::string>(key);
  const auto found = joint_ids_.find(name);
  if (found != joint_ids_.end()) return found->second;
  if (joint_ids_.empty()) table.refuse(key, "the name of a joint, and there is none");
  table.refuse(key, names_rule("a joint", name, of_joints()));
}

std::variant<BodyId, JointId> SceneNames::body_or_joint(const SceneTable& table,
                                                        const std::string& key) const {
  const std::string name = table.get<std::string>(key);
  if (body_ids_.contains(name)) return body(table, key);
  if (joint_ids_.contains(name)) return joint(table, key);
  List<std::string> names(names_.begin(), names_.end());
  for (const std::string& each : of_joints()) names.push_back(each);
  table.refuse(key, names_rule("a body or a joint", name, names));
}

List<std::string> SceneNames::of_joints() const {
  List<std::string> names;
  for (const auto& [name, id] : joint_ids_) names.push_back(name);
  return names;
}

List<BodyId> SceneNames::bodies(const SceneTable& table, const std::string& key) const {
  const std::string name = table.get<std::string>(key);
  if (name.size() < 3 || name.substr(name.size() - 2) != ".*") return {body(table, key)};
  const std::string beginning = name.substr(0, name.size() - 1);
  List<BodyId> found;
  for (const BodyId body : names_.indices()) {
    if (names_[body].starts_with(beginning)) found.push_back(body);
  }
  if (found.empty()) table.refuse(key, "the name of a row, and .* behind it");
  return found;
}

std::string SceneNames::of(const List<BodyId>& bodies) const {
  std::string text;
  for (const BodyId body : bodies) text += (text.empty() ? "" : ", ") + names_[body];
  return text;
}

}  // namespace cairn
