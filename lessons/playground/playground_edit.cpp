// Changing the scene: in the world that runs, and in its text.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/math/check.hpp>
#include "lessons/playground/playground.hpp"
#include "lessons/playground/pointing.hpp"
#include <cairn/scenes/scene_file.hpp>

namespace cairn::playground {

namespace {

constexpr double hand_pull =
    20;  // times the weight of what it holds, or of 1 kg m/s^2 where nothing has weight

std::optional<BodyId> body_named(const PerBody<std::string>& names, const std::string& name) {
  for (const BodyId body : names.indices()) {
    if (names[body] == name) return body;
  }
  return std::nullopt;
}

/// The dynamic body that stands highest.
BodyId uppermost(const Scene& scene) {
  BodyId found = ground;
  for (const BodyId body : scene.bodies().indices()) {
    const SceneBody& candidate = scene.bodies()[body];
    if (candidate.spec.type != BodyType::dynamic) continue;
    if (found == ground || candidate.pose.position.y() > scene.bodies()[found].pose.position.y())
      found = body;
  }
  return found;
}

std::string point_text(const Vec2<double>& point) {
  return fmt::format("[{}, {}]", shortest(point.x()), shortest(point.y()));
}

}  // namespace

/// Friction and masses as the controls have them; the scene's own are those of `start`, whose bodies have
/// other numbers.
void Playground::give_materials(Scene& scene, const Scene& start, const PerBody<std::string>& names,
                                const PerBody<std::string>& start_names, const Controls& controls) {
  const BodyId heaviest = uppermost(start);
  for (const BodyId body : scene.bodies().indices()) {
    const std::optional<BodyId> own = body_named(start_names, names[body]);
    if (scene.bodies()[body].removed || !own) continue;
    if (body == ground) continue;
    const SceneBody& original = start.bodies()[*own];
    BodySpec spec = scene.bodies()[body].spec;
    spec.material.friction = controls.friction.value_or(original.spec.material.friction);
    spec.mass = original.spec.mass;
    if (*own == heaviest && *own != ground && controls.mass_ratio != 1)
      spec.mass = original.mass * controls.mass_ratio;
    if (!(spec == scene.bodies()[body].spec)) scene.change(body, spec);
  }
}

void Playground::edit(const std::string& addition, const std::string& words,
                      const PerBody<std::string>& names, const std::function<void(Scene&)>& change) {
  const std::string text = text_ + addition;
  const SceneEntry entry = read_scene_text(text, file_);
  const Scene start = entry.make();
  Moment before = now();
  for (const auto& bench : before.benches) bench->edit(change);
  List<SolveLook> looks = looks_of(before.benches);
  before.benches.swap(benches_);
  changes_.push_back({std::move(before), words});
  text_ = text;
  entry_ = entry;
  start_ = start;
  names_ = names;
  lit_row_ = -1;
  prediction_.reset();
  forget_solve();
  looks_ = std::move(looks);
  keep_now();
  history_.keep(benches_[0]->snapshot());
  words_ = words;
}

std::string Playground::unused_name() const {
  for (int i = 1;; ++i) {
    const std::string name = fmt::format("box-{}", i);
    if (!body_named(names_, name)) return name;
  }
}

void Playground::add_box(const Vec2<double>& middle, const Vec2<double>& size) {
  const std::string name = unused_name();
  const std::string table = fmt::format("\n[[body]]\nname = \"{}\"\nbox = {}\nposition = {}\n", name,
                                        point_text(size), point_text(middle));
  const SceneEntry with_box = read_scene_text(text_ + table, file_);
  const BodySpec spec = with_box.make().bodies()[body_named(with_box.body_names, name).value()].spec;
  PerBody<std::string> names = names_;
  names.push_back(name);
  edit(table, "A box more: " + name + ".", names, [&](Scene& scene) { scene.add(spec); });
}

void Playground::remove(BodyId body) {
  require(body.index >= 0 && body.index < names_.size(), "remove", "body", "one of the scene", body.index);
  const std::string name = names_[body];
  const std::string table = fmt::format("\n[[event]]\ntime = 0\nremove = \"{}\"\n", name);
  edit(table, "Taken out: " + name + ".", names_, [&](Scene& scene) { scene.remove(body); });
}

void Playground::pin(BodyId a, BodyId b, const Vec2<double>& point) {
  for (const BodyId body : {a, b})
    require(body.index >= 0 && body.index < names_.size(), "pin", "body", "one of the scene", body.index);
  // In the file the pin stands where the bodies begin.
  const BodyId own_in_file = body_named(entry_.body_names, names_[b]).value_or(ground);
  const Vec2<double> in_file =
      start_.bodies()[own_in_file].pose.world(benches_[0]->snapshot().bodies[b].pose.local(point));
  std::string table = "\n[[joint]]\ntype = \"revolute\"\n";
  if (a != ground) table += fmt::format("a = \"{}\"\n", names_[a]);
  table += fmt::format("b = \"{}\"\nanchor = {}\n", names_[b], point_text(in_file));
  edit(table, fmt::format("{} is pinned to {}.", names_[b], a == ground ? "the ground" : names_[a]), names_,
       [&](Scene& scene) { scene.join<RevoluteJoint>({.a = a, .b = b, .anchor = point}); });
}

void Playground::undo() {
  if (changes_.empty()) throw std::invalid_argument("There is nothing to undo.");
  const Change& last = changes_.back();
  const std::string words = "Undone: " + last.words;
  return_to(last.before, copies(last.before.benches));
  while (!checkpoints_.empty() && checkpoints_.back().changes > changes_.size()) checkpoints_.pop_back();
  words_ = words;
}

void Playground::grab(const Vec2<double>& point, double near) {
  require_finite(point, "grab", "point", "m");
  const Snapshot now = benches_[0]->snapshot();
  const std::optional<BodyId> found = movable_body_at(now, point, near);
  if (!found) throw std::invalid_argument("There is no body that can move.");
  const BodyId body = *found;
  const double gravity = now.gravity.norm() > 0 ? now.gravity.norm() : 1;
  const DragJoint::Spec grip{.body = body,
                             .anchor = point,
                             .target = point,
                             .max_force = hand_pull * now.bodies[body].mass * gravity};
  all_or_nothing([&] {
    for (const auto& bench : benches_) bench->repeat({.kind = HandInput::Kind::grab, .grip = grip});
  });
  words_ = "You hold " + names_[body] + ".";
}

void Playground::drag(const Vec2<double>& target) {
  for (const auto& bench : benches_) bench->repeat({.kind = HandInput::Kind::drag_to, .target = target});
  forget_solve();
}

void Playground::let_go() {
  for (const auto& bench : benches_) bench->repeat({.kind = HandInput::Kind::let_go});
  forget_solve();
  words_ = "You have let go.";
}

}  // namespace cairn::playground
