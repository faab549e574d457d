// Pins, whose rows a world writes by itself: those of any other joint that writes a pin, to the last bit.
#include <doctest/doctest.h>

#include "constraints/joint_rows.hpp"
#include "constraints/revolute_joint.hpp"
#include "math/list.hpp"
#include "solvers/iterative/block_sequential_impulse.hpp"
#include "solvers/iterative/sequential_impulse.hpp"
#include "world/world.hpp"

using namespace cairn;

namespace {

/// A joint of one's own with the rows of a pin, of which no world knows that it is one.
class UnknownPin final : public ConstraintOf<UnknownPin> {
 public:
  using Spec = RevoluteJoint::Spec;
  UnknownPin(const Spec& spec, PerBodySpan<const Pose<double>> poses)
      : ends_(spec.a, spec.b, spec.anchor, spec.anchor, poses) {}
  std::string name() const override { return "unknown"; }
  List<Attachment> attachments() const override { return ends_.attachments(); }
  template <Scalar Real>
  void rows(const PerBody<Pose<Real>>& poses, RowSpecs<Real>& rows) const {
    append_pin_rows(ends_.a, ends_.b, ends_.arms(poses), rows);
  }
  template <Scalar Real>
  void stiffen(const PerBody<Pose<Real>>& poses, const RowForces<Real>& forces,
               PerBody<Vec3<Real>>& stiffness) const {
    add_pin_stiffness(ends_.a, ends_.b, ends_.arms(poses), pin_force(forces), stiffness);
  }

 private:
  JointEnds ends_;
};

/// A chain on the ground that swings round fast enough to leave its arcs, a post beside it to which a link
/// returns, one joint that hangs open and one on a spring of its own.
template <typename Joint>
Scene swinging_chain(const SceneSettings& settings) {
  Scene scene(settings);
  const BodyId post = scene.add({.type = BodyType::static_body, .position = {1, 3}});
  BodyId last = ground;
  for (int i = 0; i < 5; ++i) {
    const BodyId next = scene.add({.shapes = {box(0.8, 0.1 + 0.02 * i)},
                                   .position = {0.8 * i + 0.4, 3 + 0.1 * i},
                                   .angle = 0.1 * i,
                                   .velocity = {0, 0.5 * i},
                                   .angular_velocity = i - 1.5,
                                   .friction = 0});
    const JointId joint = scene.join<Joint>({.a = last, .b = next, .anchor = {0.8 * i, 3 + 0.1 * i}});
    if (i == 2) scene.set_joint_soft(joint, {.frequency = 20, .damping_ratio = 2});
    last = next;
  }
  scene.join<Joint>({.a = last, .b = post, .anchor = {1, 3.2}});
  scene.displace({4}, {0.3, -0.2}, 0.4);
  return scene;
}

template <Scalar Real>
bool same_rows(const VelocityProblem<Real>& one, const VelocityProblem<Real>& other) {
  const auto same = [](const ConstraintRow<Real>& x, const ConstraintRow<Real>& y) {
    return x.a == y.a && x.b == y.b && x.jacobian_a == y.jacobian_a && x.jacobian_b == y.jacobian_b &&
           x.bias == y.bias && x.softness == y.softness && x.bounds.is_equality() == y.bounds.is_equality() &&
           x.key == y.key && x.first_extra == y.first_extra && x.extra_count == y.extra_count;
  };
  return one.impulse == other.impulse && one.velocity == other.velocity &&
         std::equal(one.rows.begin(), one.rows.end(), other.rows.begin(), other.rows.end(), same);
}

template <Scalar Real, typename SolverType>
void check_twins(const SceneSettings& settings) {
  World<Real> pins(swinging_chain<RevoluteJoint>(settings)), others(swinging_chain<UnknownPin>(settings));
  SolverType solver({.iterations = 6});
  for (int step = 0; step < 30; ++step) {
    const StepReport one = pins.step(solver), other = others.step(solver);
    CHECK(one.joints_apart == other.joints_apart);
    REQUIRE(same_rows(pins.last_step().problem, others.last_step().problem));
  }
  CHECK(pins.last_step().problem.row_count() == 12);
}

}  // namespace

TEST_CASE_TEMPLATE("a pin written in place has the rows of any joint that writes a pin", Real, float, double,
                   long double) {
  using enum StabilizationPolicy;
  for (const StabilizationPolicy policy : {none, baumgarte, relaxed, soft, split_impulse}) {
    for (const int substeps : {1, 3}) {
      SceneSettings settings = {.substeps = substeps};
      settings.stabilization.policy = policy;
      CAPTURE(static_cast<int>(policy));
      check_twins<Real, SequentialImpulse<Real>>(settings);
      check_twins<Real, BlockSequentialImpulse<Real>>(settings);
    }
  }
}

TEST_CASE("a pin that gets a motor is written as a joint with one") {
  Scene scene;
  const BodyId wheel = scene.add({.shapes = {circle(0.5)}, .position = {1, 0}});
  const JointId joint = scene.join<RevoluteJoint>({.a = ground, .b = wheel, .anchor = {0, 0}});
  World world(scene);
  CHECK(world.velocity_problem().row_count() == 2);
  world.edit([&](Scene& now) { now.set_motor(joint, JointMotor{.speed = 1, .max_force = 1}); });
  CHECK(world.velocity_problem().row_count() == 3);
  world.edit([&](Scene& now) { now.set_motor(joint, std::nullopt); });
  CHECK(world.velocity_problem().row_count() == 2);
}
