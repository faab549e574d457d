// Floor 5. The rows of a step whose solver needed none.
#include "world/contact_cache.hpp"
#include "world/world.hpp"

namespace cairn {

namespace {

/// Puts the rows of the contacts behind those of joints, as they were solved last.
template <Scalar Real>
void write_contacts(const Plan& plan, StepRecord<Real>& record) {
  VelocityProblem<Real>& problem = record.problem;
  const BodyState<Real> before{
      .pose = record.pose_before, .velocity = record.velocity_before, .inverse_mass = problem.inverse_mass};
  const ContactWriter<Real> writer(plan.settings, before, StabilizationPass::velocity, problem.dt);
  const int first = record.joint_rows();
  problem.blocks.resize(record.first_contact_block);
  int next = first;
  List<RelaxedRow<Real>> relaxed(first);
  for (int i = 0; i < record.contacts.size(); ++i)
    writer.write(record.contacts[i], record.manifolds[i], problem, next, &relaxed);
  problem.rows.resize(next);
  for (int i = first; plan.relaxes && i < next; ++i) {
    problem.rows[i].bias = relaxed[i].bias;
    problem.rows[i].softness = relaxed[i].softness;
  }
}

}  // namespace

template <Scalar Real>
StepRecord<Real> with_rows(const World<Real>& world) {
  const StepRecord<Real>& record = world.last_step();
  StepRecord<Real> result = record;
  if (record.has_rows) return result;
  VelocityProblem<Real>& problem = result.problem;
  problem.velocity = record.free_velocity;
  write_contacts(make_plan(world.scene()), result);
  problem.velocity = record.problem.velocity;
  problem.impulse.resize(record.joint_rows());
  for (const Contact<Real>& contact : record.contacts) {
    for (const Real impulse : record.impulses(contact)) problem.impulse.push_back(impulse);
  }
  result.has_rows = true;
  return result;
}

template StepRecord<float> with_rows(const World<float>&);
template StepRecord<double> with_rows(const World<double>&);
template StepRecord<long double> with_rows(const World<long double>&);

}  // namespace cairn
