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

SecondSolve second_solve(StabilizationPolicy policy, bool has_rows) {
  if (policy == StabilizationPolicy::soft) return SecondSolve::from_answer;
  if (policy == StabilizationPolicy::split_impulse) return SecondSolve::positions;
  return policy == StabilizationPolicy::relaxed && has_rows ? SecondSolve::from_start : SecondSolve::none;
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
    rubbing_bodies += spec.material.friction > 0 && !spec.shapes.empty();
    plan.restitution |= spec.material.restitution > 0 && !spec.shapes.empty();
    plan.extras.surface_speed |=
        spec.material.surface_speed != 0 && spec.material.friction > 0 && !spec.shapes.empty();
    plan.extras.one_way |= !spec.filter.one_way.isZero(0) && !spec.shapes.empty();
    for (const Shape<double>& shape : spec.shapes) {
      plan.size.colliders += piece_count(shape);
      kinds.insert(shape_name(shape));
    }
  }
  plan.collision = plan.collision && plan.size.colliders > 1 && any_may_meet(scene);
  plan.friction = plan.collision && rubbing_bodies > 1;
  plan.restitution &= plan.collision;
  plan.extras.surface_speed &= plan.friction;
  plan.extras.one_way &= plan.collision;
  plan.size.joints = scene.joints().size();
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
  text +=
      line("joints", plan.size.joints > 0 ? fmt::format("{}", plan.size.joints) : "left out: there are none");
  const bool per_point = plan.settings.friction_rows == FrictionRows::per_point;
  text += line("friction", either(plan.friction,
                                  per_point ? "one row a contact point, where mu > 0"
                                            : "one row a manifold, where mu > 0",
                                  "left out: no two bodies with mu > 0, no friction rows"));
  text += line("restitution", either(plan.restitution, "e > 0 on some body", "left out: e is 0 everywhere"));
  if (plan.extras.surface_speed)
    text += line("surfaces", "some run like belts: friction asks for their speed");
  if (plan.extras.one_way)
    text += line("one-way", "some bodies hold off only what comes from their outer side");
  if (plan.extras.touches)
    text += line("touches", "events wait for them: after each step it is seen who touches");
  if (plan.extras.breaks) text += line("breaking", "what some joints hold is added up in each step");
  text += line("gravity", either(plan.gravity, "on", "left out: nothing feels it"));
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
