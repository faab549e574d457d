// Floor 5. Rows of joints: written where bodies are, and given the impulses of before.
#include <cairn/world/joint_writer.hpp>

#include <cmath>
#include <optional>

namespace cairn {

namespace {

// Of the length of a scene, and of 1 rad, in a substep: the arc of a shorter way, the square of this, is lost
// in rounding.
constexpr double still_way = 1e-9;

template <Scalar Real>
std::shared_ptr<const PerBody<Real>> radii_of(const Model<Real>& model) {
  PerBody<Real> radius;
  for (const BodyId body : model.scene->bodies().indices()) radius.push_back((*model.kinds)[body].radius);
  return std::make_shared<const PerBody<Real>>(std::move(radius));
}

}  // namespace

template <Scalar Real>
JointWriter<Real>::JointWriter(const Model<Real>& model)
    : radius_(radii_of(model)), impulses_(model.scene->joints().size() + 1) {}

template <Scalar Real>
void JointWriter<Real>::add_stiffness(const Substep<Real>& step, ForcesOf when,
                                      const VelocityProblem<Real>& problem, RowForces<Real>& forces,
                                      PerBody<Vec3<Real>>& stiffness) {
  const Placements<Real> at(step.state.pose, rotations_);
  for (int i = 0; i < step.joint_count(); ++i) {
    if (step.asleep(i)) continue;
    const auto part = [&](const RowBlock& block, int k) { return problem.rows[block.first + k].key.part; };
    take_forces(when, impulses_[i], problem, i, part, forces);
    if (!forces.rows.empty()) step.joint(i).add_stiffness(at, forces, stiffness);
  }
}

template <Scalar Real>
int JointWriter<Real>::write(const Substep<Real>& step, StabilizationPass pass,
                             VelocityProblem<Real>& problem, int& next, List<SecondRow<Real>>* second_rows) {
  if (step.joint_count() == 0) return 0;
  if (step.plan.follows_arcs) look_along_arcs(step);
  const Placements<Real> at(step.state.pose, rotations_);
  const Arcs<Real> arcs{{poses_ahead_, rotations_ahead_}, goes_along_arc_, errors_ahead_};
  RowWriting<Real> writing{.begin = step.state,
                           .problem = problem,
                           .next = next,
                           .second_rows = second_rows,
                           .arcs = step.plan.follows_arcs ? &arcs : nullptr,
                           .radius = radius_.get()};
  Stabilization stabilization = step.plan.settings.stabilization;
  const auto use_spring = [&](const SwingSoftness& spring) {
    stabilization.joint_soft = spring;
    writing.rule = joint_rule(stabilization, pass, step.dt);
    writing.second_rule = joint_rule(stabilization, StabilizationPass::second, step.dt);
  };
  const SwingSoftness usual = stabilization.joint_soft;
  use_spring(usual);
  int apart = 0;
  for (int i = 0; i < step.joint_count(); ++i) {
    const int first = next;
    if (!step.asleep(i)) {
      if (!step.is_hand(i)) {  // the hand has one of its own
        const SwingSoftness spring = step.scene.joints().hold(i).soft.value_or(usual);
        if (!(stabilization.joint_soft == spring)) use_spring(spring);
      }
      const auto& before = impulses_[i];
      ProblemRows<Real> rows(writing, step.source(i), &step.joint(i), {before.rows.data(), before.count});
      step.joint(i).write_rows(at, rows);
      apart += rows.is_apart() ? 1 : 0;
    }
    problem.blocks.push_back({first, next - first});
  }
  return apart;
}

template <Scalar Real>
void JointWriter<Real>::look_along_arcs(const Substep<Real>& step) {
  poses_ahead_ = step.state.pose;
  goes_along_arc_.resize(poses_ahead_.size());
  const Real length = static_cast<Real>(step.plan.length), still = static_cast<Real>(still_way);
  for (const BodyId body : poses_ahead_.indices()) {
    const Vec3<Real> way = step.dt * step.state.velocity[body];
    poses_ahead_[body].position += way.template head<2>();
    poses_ahead_[body].angle += way.z();
    goes_along_arc_[body] = !(way.template head<2>().squaredNorm() < still * still * length * length &&
                              std::abs(way.z()) < still);
  }
}

template <Scalar Real>
void JointWriter<Real>::start(const Substep<Real>& step, VelocityProblem<Real>& problem,
                              PerRow<char>& is_new) const {
  for (int i = 0; i < step.joint_count(); ++i) {
    const RowBlock& block = problem.blocks[i];
    const auto part = [&](int k) { return problem.rows[block.first + k].key.part; };
    start_rows(impulses_[i], block, part, step.plan.settings.warm_start, problem, is_new);
  }
}

template <Scalar Real>
void JointWriter<Real>::remember(const Substep<Real>& step, const VelocityProblem<Real>& problem) {
  for (int i = 0; i < step.joint_count(); ++i) {
    const RowBlock& block = problem.blocks[i];
    const auto part = [&](int k) { return problem.rows[block.first + k].key.part; };
    if (!step.asleep(i)) remember_rows(impulses_[i], block, part, problem);
  }
}

template <Scalar Real>
void JointWriter<Real>::carry_over(const JointWriter& before, const Scene& then, const Substep<Real>& step) {
  const SceneJoints& joints = step.scene.joints();
  for (int i = 0; i < joints.size(); ++i) {
    const std::optional<int> number = then.joints().number_of(joints.id(i));
    if (number) impulses_[i] = before.impulses_[*number];
  }
  if (step.hand) impulses_.back() = before.impulses_.back();
}

template class JointWriter<float>;
template class JointWriter<double>;

}  // namespace cairn
