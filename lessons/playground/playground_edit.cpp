// Changing the scene: in the world that runs, and in its text.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

// A rope: links of so many metres, but for short and for long ones, each four times as long as thick.
constexpr double rope_link = 0.4;
constexpr double shortest_rope = 0.05, longest_rope = 100;
constexpr int most_links = 24;
constexpr int rope_density = 4;  // [kg/m^2] so that a link is not too light for what hangs from it

constexpr double wall_thickness = 0.5;  // times the longer side of the room, so that nothing comes through

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

/// Friction, bounce and masses as the controls have them; the scene's own are those of `start`, whose bodies
/// have other numbers.
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
    spec.material.restitution = controls.bounce.value_or(original.spec.material.restitution);
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
  stay_here();
  Moment before = now();
  for (const auto& bench : before.benches) bench->edit(change);
  List<SolveLook> looks = looks_of(before.benches);
  before.benches.swap(benches_);
  changes_.push_back({std::move(before), words});
  text_ = text;
  entry_ = entry;
  start_ = start;
  names_ = names;
  is_changed_ |= benches_[0]->steps() > 0;
  lit_row_ = -1;
  prediction_.reset();
  forget_solve();
  looks_ = std::move(looks);
  keep_now();
  history_.keep(benches_[0]->snapshot());
  words_ = words;
}

std::string Playground::unused_name(const std::string& kind) const {
  for (int i = 1;; ++i) {
    const std::string name = fmt::format("{}-{}", kind, i);
    if (!body_named(names_, name) && !body_named(names_, name + ".1")) return name;
  }
}

void Playground::add_body(const std::string& kind, const std::string& shape, const Vec2<double>& middle,
                          const std::string& words) {
  const std::string name = unused_name(kind);
  const std::string table =
      fmt::format("\n[[body]]\nname = \"{}\"\n{}\nposition = {}\n", name, shape, point_text(middle));
  const SceneEntry with_body = read_scene_text(text_ + table, file_);
  const BodySpec spec = with_body.make().bodies()[body_named(with_body.body_names, name).value()].spec;
  PerBody<std::string> names = names_;
  names.push_back(name);
  edit(table, words + ": " + name + ".", names, [&](Scene& scene) { scene.add(spec); });
}

void Playground::add_box(const Vec2<double>& middle, const Vec2<double>& size) {
  add_body("box", "box = " + point_text(size), middle, "A box more");
}

void Playground::add_ball(const Vec2<double>& middle, double radius) {
  add_body("ball", "circle = " + shortest(radius), middle, "A ball more");
}

void Playground::add_walls(const Aabb<double>& room) {
  require_finite(room.lower, "walls", "room", "m");
  require_finite(room.upper, "walls", "room", "m");
  const Vec2<double> size = room.upper - room.lower;
  require(size.x() > 0 && size.y() > 0, "walls", "room", "of a width and a height above 0 m",
          point_text(size));
  const double thick = wall_thickness * size.maxCoeff();
  const Vec2<double> away = (size + Vec2<double>(thick, thick)) / 2;  // of a wall from the middle
  const auto wall = [](double width, double height, double x, double y) {
    return fmt::format("  {{ box = {}, offset = {} }},\n", point_text({width, height}), point_text({x, y}));
  };
  const std::string shapes = wall(thick, size.y(), -away.x(), 0) + wall(thick, size.y(), away.x(), 0) +
                             wall(size.x() + 2 * thick, thick, 0, -away.y()) +
                             wall(size.x() + 2 * thick, thick, 0, away.y());
  add_body("walls", "type = \"static\"\nshapes = [\n" + shapes + "]", (room.lower + room.upper) / 2,
           "Walls around what is seen");
}

void Playground::require_bodies(const char* act, std::initializer_list<BodyId> bodies) const {
  for (const BodyId body : bodies)
    require(body.index >= 0 && body.index < names_.size(), act, "body", "one of the scene", body.index);
}

/// In the file a point of a body stands where the body begins.
Vec2<double> Playground::point_in_file(BodyId body, const Vec2<double>& point) const {
  const BodyId in_file = body_named(entry_.body_names, names_[body]).value_or(ground);
  return start_.bodies()[in_file].pose.world(benches_[0]->snapshot().bodies[body].pose.local(point));
}

void Playground::add_rope(BodyId a, const Vec2<double>& from, BodyId b, const Vec2<double>& to) {
  require_bodies("rope", {a, b});
  require_finite(from, "rope", "from", "m");
  require_finite(to, "rope", "to", "m");
  require(a == ground || a != b, "rope", "body", "another one at its other end", names_[a]);
  const double length = (to - from).norm();  // [m]
  require(length >= shortest_rope && length <= longest_rope, "rope", "length",
          fmt::format("from {} to {} m", shortest_rope, longest_rope), length);
  const int links = std::clamp(static_cast<int>(std::lround(length / rope_link)), 2, most_links);
  const std::string name = unused_name("rope");
  const auto table = [&](const Vec2<double>& begin, const Vec2<double>& end) {
    return fmt::format(
        "\n[[chain]]\nname = \"{}\"\nn = {}\nfrom = {}\nto = {}\nthickness = {}\ndensity = {}\n", name, links,
        point_text(begin), point_text(end), shortest(length / links / 4), rope_density);
  };
  const SceneEntry alone = read_scene_text(table(from, to), file_);
  const Scene scene_alone = alone.make();
  PerBody<std::string> names = names_;
  for (int i = 1; i <= links; ++i) names.push_back(alone.body_names[BodyId{i}]);
  const std::string ends = fmt::format("a = \"{}\"\nb = \"{}\"\n", names_[a], names_[b]);
  edit(table(point_in_file(a, from), point_in_file(b, to)) + ends, "A rope more: " + name + ".", names,
       [&](Scene& scene) {
         BodyId last = a;
         for (int i = 1; i <= links; ++i) {
           const BodyId link = scene.add(scene_alone.bodies()[BodyId{i}].spec);
           const Vec2<double> anchor = from + (i - 1.0) / links * (to - from);
           scene.join<RevoluteJoint>({.a = last, .b = link, .anchor = anchor});
           last = link;
         }
         scene.join<RevoluteJoint>({.a = last, .b = b, .anchor = to});
       });
}

void Playground::remove(BodyId body) {
  require_bodies("remove", {body});
  const std::string name = names_[body];
  const std::string table = fmt::format("\n[[event]]\ntime = 0\nremove = \"{}\"\n", name);
  edit(table, "Taken out: " + name + ".", names_, [&](Scene& scene) { scene.remove(body); });
}

void Playground::pin(BodyId a, BodyId b, const Vec2<double>& point) {
  require_bodies("pin", {a, b});
  std::string table = "\n[[joint]]\ntype = \"revolute\"\n";
  if (a != ground) table += fmt::format("a = \"{}\"\n", names_[a]);
  table += fmt::format("b = \"{}\"\nanchor = {}\n", names_[b], point_text(point_in_file(b, point)));
  edit(table, fmt::format("{} is pinned to {}.", names_[b], a == ground ? "the ground" : names_[a]), names_,
       [&](Scene& scene) { scene.join<RevoluteJoint>({.a = a, .b = b, .anchor = point}); });
}

void Playground::undo() {
  stay_here();
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
