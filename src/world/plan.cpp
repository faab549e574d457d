// Floor 5. Reading a scene for what its steps need.
#include <cairn/world/plan.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include <cairn/world/scene_length.hpp>

namespace cairn {

namespace {

// Below about this many shapes, comparing every two boxes costs less than sorting them.
constexpr int all_pairs_limit = 32;

/// Whether two bodies with shapes, one of them dynamic, may ever touch each other: bodies of the same
/// categories are looked at once.
bool any_may_meet(const Scene& scene) {
  struct Kind {
    const BodySpec* spec = nullptr;
    bool has_two = false;  // bodies
    bool has_dynamic = false;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Kind> kinds;
  for (const SceneBody& body : scene.bodies()) {
    if (body.removed || body.spec.shapes.empty()) continue;
    Kind& kind = kinds[{body.spec.filter.category, body.spec.filter.collides_with}];
    kind.has_two = kind.spec != nullptr;
    kind.spec = &body.spec;
    kind.has_dynamic |= body.spec.type == BodyType::dynamic;
  }
  for (const auto& [one_name, one] : kinds) {
    for (const auto& [other_name, other] : kinds) {
      const bool are_two = one_name != other_name || one.has_two;
      if (are_two && (one.has_dynamic || other.has_dynamic) &&
          may_touch(one.spec->filter, other.spec->filter))
        return true;
    }
  }
  return false;
}

/// What follows from `rubbing_bodies` with mu > 0 by the rule that mixes them, and from what is known of
/// pairs.
void add_pairs(const Mixing& mixing, int rubbing_bodies, Plan& plan) {
  const bool is_one_enough = mixing.friction == MixingRule::average || mixing.friction == MixingRule::maximum;
  plan.friction = rubbing_bodies > (is_one_enough ? 0 : 1);
  for (const PairMaterial& pair : mixing.pairs) {
    plan.friction |= pair.friction.value_or(0) > 0 || pair.static_friction.value_or(0) > 0;
    plan.extras.static_friction |= pair.static_friction.value_or(0) > pair.friction.value_or(0);
    plan.restitution |= pair.restitution.value_or(0) > 0;
  }
  plan.friction &= plan.collision;
}

SecondSolve second_solve(StabilizationPolicy policy, bool has_rows) {
  if (policy == StabilizationPolicy::soft) return SecondSolve::from_answer;
  if (policy == StabilizationPolicy::split_impulse) return SecondSolve::positions;
  return policy == StabilizationPolicy::relaxed && has_rows ? SecondSolve::from_start : SecondSolve::none;
}

/// What Acting does for the scene.
List<std::string> acting_on(const Scene& scene) {
  const Fields& fields = scene.settings().fields;
  int forces = 0, paths = 0, drags = 0;
  for (const SceneEvent& event : scene.events()) {
    forces += std::holds_alternative<ApplyForce>(event.action);
    paths += std::holds_alternative<FollowPath>(event.action);
  }
  for (const SceneBody& body : scene.bodies())
    drags += body.spec.type == BodyType::dynamic && body.spec.damping.quadratic > 0;
  List<std::string> names;
  const auto count = [&](int number, const char* of_one, const char* of_many) {
    if (number > 0) names.push_back(fmt::format("{} {}", number, number == 1 ? of_one : of_many));
  };
  count(forces, "force", "forces");
  count(fields.attractions.size(), "attraction", "attractions");
  if (fields.gravitation != 0) names.push_back("gravitation between all bodies");
  if (fields.water) names.push_back("water");
  count(drags, "body with drag in the air", "bodies with drag in the air");
  count(paths, "path", "paths");
  return names;
}

/// What one body adds to what the scene requires. Collision is not decided yet.
void add_body(const SceneBody& body, const SceneSettings& settings, Plan& plan) {
  const BodySpec& spec = body.spec;
  const bool dynamic = spec.type == BodyType::dynamic;
  plan.size.bodies += 1;
  plan.size.dynamic_bodies += dynamic;
  plan.size.turning_bodies += dynamic && body.inertia > 0;
  plan.collision |= dynamic && !spec.shapes.empty();
  plan.gravity |= dynamic && spec.gravity_scale != 0 && !settings.gravity.isZero(0);
  plan.damping |= dynamic && (spec.damping.linear > 0 || spec.damping.angular > 0);
  if (spec.shapes.empty()) return;
  const Material& material = spec.material;
  plan.restitution |= material.restitution > 0;
  plan.extras.surface_speed |=
      material.surface_speed != 0 && (material.holding_friction() > 0 || !settings.mixing.is_usual());
  plan.extras.static_friction |= material.holding_friction() > material.friction;
  plan.extras.rolling_resistance |= material.rolling_resistance > 0;
  plan.extras.one_way |= !spec.filter.one_way.isZero(0);
  for (const Shape<double>& shape : spec.shapes) {
    plan.size.colliders += piece_count(shape);
    plan.size.pieces += is_piece(shape);
  }
}

/// The kinds of shapes that occur, sorted.
List<std::string> shape_kinds(const Scene& scene) {
  std::array<const Shape<double>*, std::variant_size_v<Shape<double>>> one_of = {};  // each kind
  for (const SceneBody& body : scene.bodies()) {
    for (const Shape<double>& shape : body.spec.shapes) one_of[shape.index()] = &shape;
  }
  List<std::string> kinds;
  for (const Shape<double>* shape : one_of) {
    if (shape != nullptr) kinds.push_back(shape_name(*shape));
  }
  std::sort(kinds.begin(), kinds.end());
  return kinds;
}

/// How many bodies have shapes that rub.
int rubbing_bodies(const Scene& scene) {
  return static_cast<int>(
      std::count_if(scene.bodies().begin(), scene.bodies().end(), [](const SceneBody& body) {
        return body.spec.material.holding_friction() > 0 && !body.spec.shapes.empty();
      }));
}

/// What only counts where something collides, or rubs.
void drop_what_has_no_use(Plan& plan) {
  plan.restitution &= plan.collision;
  plan.extras.impact_sequence = plan.restitution && plan.settings.impacts == Impacts::sequence;
  plan.extras.surface_speed &= plan.friction;
  plan.extras.static_friction &= plan.collision;
  plan.extras.rolling_resistance &= plan.friction;
  plan.extras.one_way &= plan.collision;
}

void add_joints(const SceneJoints& joints, Plan& plan) {
  plan.size.joints = joints.size();
  for (int i = 0; i < joints.size(); ++i) {
    const JointTraits traits = joints[i]->traits();
    plan.size.servos += traits.has_servo;
    plan.size.joint_springs += traits.has_spring;
    plan.size.ratchets += traits.has_ratchet;
    plan.extras.breaks |= joints.hold(i).strength.is_finite();
  }
}

/// How contacts are found, and what is solved besides.
void choose_methods(Plan& plan) {
  const SceneSettings& settings = plan.settings;
  plan.broadphase = plan.size.colliders > all_pairs_limit ? BroadphaseKind::grid : BroadphaseKind::all_pairs;
  plan.keeps_manifolds = settings.contact_search == ContactSearch::when_moved;
  plan.moves_manifolds =
      plan.keeps_manifolds || (settings.contact_search == ContactSearch::every_step && settings.substeps > 1);
  const StabilizationPolicy policy = settings.stabilization.policy;
  plan.follows_arcs = policy == StabilizationPolicy::relaxed && plan.size.joints > 0;
  plan.second_solve = second_solve(policy, plan.collision || plan.size.joints > 0);
}

}  // namespace

Plan make_plan(const Scene& scene) {
  const double length = unit_length(scene);
  Plan plan{.settings = full_settings(scene.settings(), length),
            .length = length,
            .lengths = lengths_text(scene.settings(), length)};
  for (const SceneBody& body : scene.bodies()) {
    if (!body.removed) add_body(body, scene.settings(), plan);
  }
  plan.size.shape_kinds = shape_kinds(scene);
  plan.size.acting = acting_on(scene);
  plan.collision = plan.collision && plan.size.colliders > 1 && any_may_meet(scene);
  add_pairs(scene.settings().mixing, rubbing_bodies(scene), plan);
  drop_what_has_no_use(plan);
  add_joints(scene.joints(), plan);
  for (const SceneEvent& event : scene.events()) plan.extras.touches |= event.touch.has_value();
  choose_methods(plan);
  return plan;
}

}  // namespace cairn
