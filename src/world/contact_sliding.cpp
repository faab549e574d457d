// Floor 5. Which contacts slide, and which stick: for static friction.
#include <cmath>

#include <cairn/constraints/contact_rows.hpp>
#include <cairn/world/contact_cache.hpp>

namespace cairn {

namespace {

/// The relative velocity of the surfaces of a contact along a direction, as a row: in the middle of its
/// points.
template <Scalar Real>
ConstraintRow<Real> row_along(const Contact<Real>& contact, const Vec2<Real>& direction) {
  const auto& points = contact.manifold.points;
  const int last = contact.manifold.count - 1;
  const Vec2<Real> middle = (points[0].position + points[last].position) / 2;
  const Vec2<Real> arm_a = middle - contact.center_a, arm_b = middle - contact.center_b;
  ConstraintRow<Real> row;
  row.a = contact.a;
  row.b = contact.b;
  row.jacobian_a = {-direction.x(), -direction.y(), -cross(arm_a, direction)};
  row.jacobian_b = {direction.x(), direction.y(), cross(arm_b, direction)};
  return row;
}

template <Scalar Real>
ConstraintRow<Real> tangential_row(const Contact<Real>& contact) {
  return row_along<Real>(contact, -perpendicular(contact.manifold.normal));
}

/// [m/s] How fast they slide.
template <Scalar Real>
Real sliding_speed(const Contact<Real>& contact, const VelocityProblem<Real>& problem,
                   const PerBody<Vec3<Real>>& velocity) {
  const PerBody<Real>& belts = problem.surface_speed;
  const Real running = belts.empty() ? Real(0) : belts[contact.a] + belts[contact.b];
  return std::abs(row_velocity(problem, tangential_row(contact), velocity) - running);
}

/// Whether they slide at the velocities of the problem, where the normal rows gave `load` [N s]: faster than
/// friction of `kinetic`, mu, could stop within a substep. It tells what sweeps have left undone from what
/// slides, and vanishes with dt.
template <Scalar Real>
bool slides(const Contact<Real>& contact, const VelocityProblem<Real>& problem, Real kinetic, Real load) {
  return sliding_speed(contact, problem, problem.velocity) >
         kinetic * load * inverse_effective_mass(problem, tangential_row(contact));
}

/// Whether surfaces that have not touched yet come in sliding: by the same rule, with the load of the impact.
template <Scalar Real>
bool comes_sliding(const Contact<Real>& contact, const VelocityProblem<Real>& problem,
                   const PerBody<Vec3<Real>>& velocity) {
  const Real approach = row_velocity(problem, row_along<Real>(contact, contact.manifold.normal), velocity);
  return sliding_speed(contact, problem, velocity) > contact.friction * std::abs(approach);
}

}  // namespace

/// What sticks may have its static coefficient: contacts come with that of sliding.
template <Scalar Real>
void ContactCache<Real>::choose_friction(const Substep<Real>& step, VelocityProblem<Real>& problem) {
  const Scene& scene = step.scene;
  for (int i = 0; i < problem.contacts.size(); ++i) {
    Contact<Real>& contact = problem.contacts[i];
    CachedContact<Real>& cached = graph_[touching_[i]];
    if (cached.impulses.count == 0) cached.slides = comes_sliding(contact, problem, step.state.velocity);
    if (cached.slides) continue;
    const PairSurface surface =
        mixed(scene.settings().mixing, contact.a, scene.bodies()[contact.a].spec.material, contact.b,
              scene.bodies()[contact.b].spec.material);
    contact.friction = static_cast<Real>(surface.static_friction);
  }
}

/// Keeps which contacts slide, for the next substep.
template <Scalar Real>
void ContactCache<Real>::remember_sliding(const VelocityProblem<Real>& problem) {
  const int joints = problem.joint_blocks();
  for (int i = 0; i < problem.contacts.size(); ++i) {
    const RowBlock& block = problem.blocks[joints + i];
    const Contact<Real>& contact = problem.contacts[i];
    Real load = 0;
    for (int k = 0; k < block.count; ++k) {
      if (is_normal_part(contact_part(contact.manifold, block.count, k)))
        load += problem.impulse[block.first + k];
    }
    CachedContact<Real>& cached = graph_[touching_[i]];
    cached.slides = slides(contact, problem, cached.friction, load);
  }
}

template void ContactCache<float>::choose_friction(const Substep<float>&, VelocityProblem<float>&);
template void ContactCache<float>::remember_sliding(const VelocityProblem<float>&);
template void ContactCache<double>::choose_friction(const Substep<double>&, VelocityProblem<double>&);
template void ContactCache<double>::remember_sliding(const VelocityProblem<double>&);

}  // namespace cairn
