// Floor 5. A plan in words: what is modelled, and what was left out and why.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cairn/world/plan.hpp>

namespace cairn {

namespace {

std::string line(const char* what, const std::string& how) { return fmt::format("  {:<14}{}\n", what, how); }

std::string either(bool used, const char* yes, const char* no) { return used ? yes : no; }

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

std::string collision_text(const Plan& plan) {
  if (!plan.collision) return "left out: nothing can meet";
  std::string phase = plan.broadphase == BroadphaseKind::grid ? "grid of cells" : "all pairs of boxes";
  if (plan.moves_manifolds) phase += plan.keeps_manifolds ? " when moved" : " once a step";
  return fmt::format("{}, {} shapes ({})", phase, plan.size.colliders,
                     fmt::join(plan.size.shape_kinds, ", "));
}

std::string friction_text(const Plan& plan) {
  if (!plan.friction) return "left out: no two bodies with mu > 0, no friction rows";
  const bool per_point = plan.settings.friction_rows == FrictionRows::per_point;
  return fmt::format("one row a {}, where mu > 0", per_point ? "contact point" : "manifold");
}

std::string rotation_text(const SceneSize& size) {
  if (size.turning_bodies == size.dynamic_bodies) return "every dynamic body turns";
  return fmt::format("left out for {} of {} dynamic bodies: 1/I is 0",
                     size.dynamic_bodies - size.turning_bodies, size.dynamic_bodies);
}

std::string second_solve_text(const Plan& plan) {
  if (plan.solves_again()) return "each step is solved again without the speed that removes errors";
  if (plan.second_solve == SecondSolve::positions)
    return "split impulse: errors are removed apart from the velocities";
  return "left out: positions need none of their own";
}

/// A line for each of what few scenes have.
std::string lines_of_extras(const Plan& plan) {
  const PlanExtras& extras = plan.extras;
  std::string text;
  const auto add = [&text](bool is_there, const char* what, const std::string& how) {
    if (is_there) text += line(what, how);
  };
  add(extras.static_friction, "static", "what sticks holds more than mu: each contact sticks or slides");
  add(extras.rolling_resistance, "rolling",
      "one row more where a body stands on one point: a moment resists");
  add(!plan.settings.mixing.is_usual(), "mixing", mixing_text(plan.settings.mixing));
  add(extras.impact_sequence, "impacts", "one after the other, as bodies pass them on");
  add(extras.surface_speed, "surfaces", "some run like belts: friction asks for their speed");
  add(extras.one_way, "one-way", "some bodies hold off only what comes from their outer side");
  add(extras.touches, "touches", "events wait for them: after each step it is seen who touches");
  add(extras.breaks, "breaking", "what some joints hold is added up in each step");
  return text;
}

}  // namespace

std::string explain(const Plan& plan) {
  const SceneSize& size = plan.size;
  const SceneSettings& settings = plan.settings;
  std::string text = "This scene needs\n";
  text += line("bodies", fmt::format("{} dynamic of {}; {} velocities a step", size.dynamic_bodies,
                                     size.bodies, 2 * size.dynamic_bodies + size.turning_bodies));
  text += line("collision", collision_text(plan));
  if (size.pieces > 0)
    text += line("outlines", fmt::format("cut into {} of these shapes, as they are not convex", size.pieces));
  text += line("joints", size.joints > 0 ? std::to_string(size.joints) : "left out: there are none");
  text += lines_of_joints(size);
  text += line("friction", friction_text(plan));
  text += line("restitution", restitution_text(plan));
  text += lines_of_extras(plan);
  text += line("gravity", either(plan.gravity, "on", "left out: nothing feels it"));
  if (!size.acting.empty()) text += line("also", fmt::format("{}", fmt::join(size.acting, ", ")));
  text += line("damping", either(plan.damping, "on", "left out: no body is damped"));
  text += line("rotation", rotation_text(size));
  text += line("warm start",
               either(settings.warm_start, "impulses are kept from step to step", "left out by setting"));
  text += line("substeps", settings.substeps > 1 ? fmt::format("{} a step", settings.substeps)
                                                 : std::string("left out: one solve a step"));
  text += line("second solve", second_solve_text(plan));
  text += line("sleeping", either(settings.sleeping.has_value(),
                                  "islands at rest take no part until something wakes them",
                                  "left out: every body takes part in every step"));
  return text;
}

}  // namespace cairn
