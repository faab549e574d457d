// Floor 5. Reading a scene for what its steps need.
#include <cairn/world/plan.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <set>

#include <cairn/world/scene_length.hpp>

namespace cairn {

namespace {

// Below about this many shapes, comparing every two boxes costs less than sorting them.
constexpr int all_pairs_limit = 32;

std::string line(const char* what, const std::string& how) { return fmt::format("  {:<14}{}\n", what, how); }

std::string either(bool used, const char* yes, const char* no) { return used ? yes : no; }

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

/// What some joints have besides; empty: none has.
std::string lines_of_joints(const SceneSize& size) {
  std::string text;
  const auto add = [&text](int count, const char* what, const char* how) {
    if (count > 0) text += line(what, fmt::format("{}: {}", count, how));
  };
  add(size.servos, "servos", "a row each, whose speed follows what is missing");
  add(size.joint_springs, "joint springs", "a soft row each, along what the joint leaves free");
  add(size.ratchets, "ratchets", "a row each, which only pushes away from the last tooth");
  return text;
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

/// What slower approaches do not do is said: an elastic ball that comes to rest is a question often asked.
std::string restitution_text(const Plan& plan) {
  if (!plan.restitution) return "left out: e is 0 everywhere";
  const double threshold = *plan.settings.restitution_threshold;
  if (threshold == 0) return "e > 0 on some body";
  return fmt::format("e > 0 on some body; what approaches more slowly than {:.3g} m/s does not rebound",
                     threshold);
}

std::string mixing_text(const Mixing& mixing) {
  const auto word = [](MixingRule rule) {
    switch (rule) {
      case MixingRule::geometric_mean:
        return "geometric mean";
      case MixingRule::minimum:
        return "minimum";
      case MixingRule::average:
        return "average";
      case MixingRule::maximum:
        return "maximum";
      case MixingRule::product:
        break;
    }
    return "product";
  };
  const std::string pairs =
      mixing.pairs.empty() ? "" : fmt::format("; {} for pairs of bodies", mixing.pairs.size());
  return fmt::format("friction by the {}, restitution by the {} of two surfaces{}", word(mixing.friction),
                     word(mixing.restitution), pairs);
}

}  // namespace

Plan make_plan(const Scene& scene) {
  const double length = unit_length(scene);
  Plan plan{.settings = full_settings(scene.settings(), length),
            .length = length,
            .lengths = lengths_text(scene.settings(), length)};
  std::set<std::string> kinds;
  int rubbing_bodies = 0;
  for (const SceneBody& body : scene.bodies()) {
    if (body.removed) continue;
    const BodySpec& spec = body.spec;
    const bool dynamic = spec.type == BodyType::dynamic;
    plan.size.bodies += 1;
    plan.size.dynamic_bodies += dynamic;
    plan.size.turning_bodies += dynamic && body.inertia > 0;
    plan.collision |= dynamic && !spec.shapes.empty();
    plan.gravity |= dynamic && spec.gravity_scale != 0 && !scene.settings().gravity.isZero(0);
    plan.damping |= dynamic && (spec.damping.linear > 0 || spec.damping.angular > 0);
    const bool rubs = spec.material.holding_friction() > 0 && !spec.shapes.empty();
    rubbing_bodies += rubs;
    plan.restitution |= spec.material.restitution > 0 && !spec.shapes.empty();
    plan.extras.surface_speed |=
        spec.material.surface_speed != 0 && (rubs || !scene.settings().mixing.is_usual());
    plan.extras.static_friction |=
        spec.material.holding_friction() > spec.material.friction && !spec.shapes.empty();
    plan.extras.rolling_resistance |= spec.material.rolling_resistance > 0 && !spec.shapes.empty();
    plan.extras.one_way |= !spec.filter.one_way.isZero(0) && !spec.shapes.empty();
    for (const Shape<double>& shape : spec.shapes) {
      plan.size.colliders += piece_count(shape);
      plan.size.pieces += is_piece(shape);
      kinds.insert(shape_name(shape));
    }
  }
  plan.size.acting = acting_on(scene);
  plan.collision = plan.collision && plan.size.colliders > 1 && any_may_meet(scene);
  add_pairs(scene.settings().mixing, rubbing_bodies, plan);
  plan.restitution &= plan.collision;
  plan.extras.impact_sequence = plan.restitution && scene.settings().impacts == Impacts::sequence;
  plan.extras.surface_speed &= plan.friction;
  plan.extras.static_friction &= plan.collision;
  plan.extras.rolling_resistance &= plan.friction;
  plan.extras.one_way &= plan.collision;
  plan.size.joints = scene.joints().size();
  for (const std::shared_ptr<const Constraint>& joint : scene.joints()) {
    const JointTraits traits = joint->traits();
    plan.size.servos += traits.has_servo;
    plan.size.joint_springs += traits.has_spring;
    plan.size.ratchets += traits.has_ratchet;
  }
  for (int i = 0; i < plan.size.joints; ++i)
    plan.extras.breaks |= scene.joints().hold(i).strength.is_finite();
  for (const SceneEvent& event : scene.events()) plan.extras.touches |= event.touch.has_value();
  plan.broadphase = plan.size.colliders > all_pairs_limit ? BroadphaseKind::grid : BroadphaseKind::all_pairs;
  const SceneSettings& settings = scene.settings();
  const ContactSearch search = settings.contact_search;
  plan.keeps_manifolds = search == ContactSearch::when_moved;
  plan.moves_manifolds =
      search == ContactSearch::when_moved || (search == ContactSearch::every_step && settings.substeps > 1);
  const StabilizationPolicy policy = settings.stabilization.policy;
  plan.follows_arcs = policy == StabilizationPolicy::relaxed && plan.size.joints > 0;
  plan.second_solve = second_solve(policy, plan.collision || plan.size.joints > 0);
  plan.size.shape_kinds.assign(kinds.begin(), kinds.end());
  return plan;
}

std::string explain(const Plan& plan) {
  std::string phase = plan.broadphase == BroadphaseKind::grid ? "grid of cells" : "all pairs of boxes";
  if (plan.moves_manifolds) phase += plan.keeps_manifolds ? " when moved" : " once a step";
  std::string text = "This scene needs\n";
  text +=
      line("bodies", fmt::format("{} dynamic of {}; {} velocities a step", plan.size.dynamic_bodies,
                                 plan.size.bodies, 2 * plan.size.dynamic_bodies + plan.size.turning_bodies));
  text += line("collision", plan.collision ? fmt::format("{}, {} shapes ({})", phase, plan.size.colliders,
                                                         fmt::join(plan.size.shape_kinds, ", "))
                                           : "left out: nothing can meet");
  if (plan.size.pieces > 0)
    text += line("outlines",
                 fmt::format("cut into {} of these shapes, as they are not convex", plan.size.pieces));
  text +=
      line("joints", plan.size.joints > 0 ? fmt::format("{}", plan.size.joints) : "left out: there are none");
  text += lines_of_joints(plan.size);
  const bool per_point = plan.settings.friction_rows == FrictionRows::per_point;
  text += line("friction", either(plan.friction,
                                  per_point ? "one row a contact point, where mu > 0"
                                            : "one row a manifold, where mu > 0",
                                  "left out: no two bodies with mu > 0, no friction rows"));
  text += line("restitution", restitution_text(plan));
  if (plan.extras.static_friction)
    text += line("static", "what sticks holds more than mu: each contact sticks or slides");
  if (plan.extras.rolling_resistance)
    text += line("rolling", "one row more where a body stands on one point: a moment resists");
  if (!plan.settings.mixing.is_usual()) text += line("mixing", mixing_text(plan.settings.mixing));
  if (plan.extras.impact_sequence) text += line("impacts", "one after the other, as bodies pass them on");
  if (plan.extras.surface_speed)
    text += line("surfaces", "some run like belts: friction asks for their speed");
  if (plan.extras.one_way)
    text += line("one-way", "some bodies hold off only what comes from their outer side");
  if (plan.extras.touches)
    text += line("touches", "events wait for them: after each step it is seen who touches");
  if (plan.extras.breaks) text += line("breaking", "what some joints hold is added up in each step");
  text += line("gravity", either(plan.gravity, "on", "left out: nothing feels it"));
  if (!plan.size.acting.empty()) text += line("also", fmt::format("{}", fmt::join(plan.size.acting, ", ")));
  text += line("damping", either(plan.damping, "on", "left out: no body is damped"));
  text += line("rotation", plan.size.turning_bodies == plan.size.dynamic_bodies
                               ? std::string("every dynamic body turns")
                               : fmt::format("left out for {} of {} dynamic bodies: 1/I is 0",
                                             plan.size.dynamic_bodies - plan.size.turning_bodies,
                                             plan.size.dynamic_bodies));
  text += line("warm start", either(plan.settings.warm_start, "impulses are kept from step to step",
                                    "left out by setting"));
  text += line("substeps", plan.settings.substeps > 1 ? fmt::format("{} a step", plan.settings.substeps)
                                                      : std::string("left out: one solve a step"));
  std::string second = "left out: positions need none of their own";
  if (plan.solves_again()) second = "each step is solved again without the speed that removes errors";
  if (plan.second_solve == SecondSolve::positions)
    second = "split impulse: errors are removed apart from the velocities";
  text += line("second solve", second);
  text += line("sleeping", either(plan.settings.sleeping.has_value(),
                                  "islands at rest take no part until something wakes them",
                                  "left out: every body takes part in every step"));
  return text;
}

}  // namespace cairn
