// Small worlds with one question each.
#include "lesson.hpp"

#include <cairn/samples/samples.hpp>

namespace cairn::edges {

namespace {

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// A joint with a mistake in it: its error is 0 / 0.
class BrokenJoint final : public ConstraintOf<BrokenJoint> {
 public:
  BrokenJoint(BodyId a, BodyId b) : a_(a), b_(b) {}

  std::string name() const override { return "broken"; }
  List<Attachment> attachments() const override { return {{a_, {0, 0}}, {b_, {0, 0}}}; }

  template <Scalar Real>
  void rows(const Placements<Real>&, RowWriter<Real>& rows) const {
    RowSpec<Real> row;
    row.a = a_;
    row.b = b_;
    row.jacobian_a = {-1, 0, 0};
    row.jacobian_b = {1, 0, 0};
    row.error = static_cast<Real>(not_a_number);
    rows.add(row);
  }

 private:
  BodyId a_;
  BodyId b_;
};

std::string message_of(const std::function<void()>& attempt) {
  try {
    attempt();
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
  return "";
}

Scene tower_of(double mass) {
  Scene scene({.gravity = {0, -gravity},
               .dt = time_step,
               .stabilization = {.policy = StabilizationPolicy::baumgarte}});
  scene.add_ground();
  samples::add_stack(scene, 5, {.shapes = {box(1, 1)}, .position = {0, 0.5}, .mass = mass});
  return scene;
}

double heights_apart(double mass, int sweeps) {
  SequentialImpulse<double> solver({.iterations = sweeps});
  World one(tower_of(1)), other(tower_of(mass));
  double apart = 0;
  for (int k = 0; k < 60; ++k) {
    one.step(solver);
    other.step(solver);
    for (int i = 1; i <= 5; ++i) {
      const double gap = one.bodies().pose[{i}].position.y() - other.bodies().pose[{i}].position.y();
      apart = std::max(apart, std::abs(gap));
    }
  }
  return apart;
}

Scene pendulum(int rods) {
  Scene scene({.gravity = {0, -gravity},
               .dt = time_step,
               .stabilization = {.policy = StabilizationPolicy::baumgarte}});
  const BodyId bob = scene.add({.shapes = {circle(0.1)}, .position = {1, 0}, .mass = 1});
  for (int i = 0; i < rods; ++i)
    scene.join<DistanceJoint>({.a = ground, .b = bob, .anchor_a = {0, 0}, .anchor_b = {1, 0}});
  return scene;
}

}  // namespace

List<Refusal> try_bad_input() {
  const Shape<double> shape = circle(0.5);
  const List<std::pair<std::string, std::function<void()>>> attempts = {
      {"a mass of 0", [&] { Scene().add({.shapes = {shape}, .mass = 0}); }},
      {"a step of 0 s", [] { Scene({.dt = 0}); }},
      {"a place nowhere",
       [&] {
         Scene().add({.shapes = {shape}, .position = {not_a_number, 0}});
       }},
      {"a rod without length",
       [&] {
         Scene scene;
         const BodyId body = scene.add({.shapes = {shape}});
         scene.join<DistanceJoint>({.a = ground, .b = body});
       }},
      {"friction below 0", [&] { Scene().add({.shapes = {shape}, .material = {.friction = -0.1}}); }}};
  List<Refusal> refusals;
  for (const auto& attempt : attempts) refusals.push_back({attempt.first, message_of(attempt.second)});
  return refusals;
}

Guarded try_not_a_number() {
  Scene scene({.gravity = {0, -gravity},
               .dt = time_step,
               .stabilization = {.policy = StabilizationPolicy::baumgarte}});
  const BodyId bystander = scene.add({.shapes = {circle(0.5)}, .position = {5, 1}});
  const BodyId first = scene.add({.shapes = {circle(0.5)}, .position = {0, 1}});
  const BodyId second = scene.add({.shapes = {circle(0.5)}, .position = {2, 1}});
  scene.join(std::make_shared<const BrokenJoint>(first, second));
  World world(scene);
  SequentialImpulse<double> solver;
  const StepReport report = world.step(solver);
  Guarded guarded{.joined = first.index, .finite = true};
  if (report.not_finite) guarded.body = report.not_finite->index;
  for (const BodyId body : {bystander, first, second}) {
    const Pose<double>& pose = world.bodies().pose[body];
    guarded.moved = std::max(guarded.moved, (pose.position - scene.bodies()[body].pose.position).norm());
    guarded.finite = guarded.finite && pose.position.allFinite() && world.bodies().velocity[body].allFinite();
  }
  return guarded;
}

Scaled try_scaled_masses(int sweeps) {
  return {.heavy = heights_apart(std::ldexp(1.0, 20), sweeps),
          .light = heights_apart(std::ldexp(1.0, -20), sweeps)};
}

double try_twice(int sweeps, int steps) {
  SequentialImpulse<double> solver({.iterations = sweeps});
  World once(pendulum(1)), twice(pendulum(2));
  double apart = 0;
  for (int k = 0; k < steps; ++k) {
    once.step(solver);
    twice.step(solver);
    apart = std::max(apart, (once.bodies().pose[{1}].position - twice.bodies().pose[{1}].position).norm());
  }
  return apart;
}

Stop try_long_quarrel() {
  VelocityProblem<double> problem = World(two_pins_scene()).velocity_problem();
  return SequentialImpulse<double>({.iterations = 100000, .patience = 3}).solve(problem).stop;
}

}  // namespace cairn::edges
