// The chain as a scene, and as a row of masses on springs.
#include "lesson.hpp"

#include <Eigen/Eigenvalues>

namespace cairn::taut {

Scene chain_scene(const ChainSettings& settings, const ChainRules& rules) {
  Scene scene({.gravity = {0, -gravity},
               .dt = settings.dt,
               .substeps = rules.substeps,
               .stabilization = {.policy = rules.policy}});
  Vec2<double> above = {0, 0};
  BodyId last = ground;
  for (int i = 0; i <= settings.beads; ++i) {
    const bool is_load = i == settings.beads;
    const double own = is_load ? settings.load : settings.bead;
    const double mass = is_load || rules.masses.empty() ? own : rules.masses[i];
    const double side = is_load ? 0 : (i % 2 == 0 ? rules.bent : -rules.bent);
    const Vec2<double> place = {side, -(i + 1) * rod_length};
    const BodyId body = scene.add({.shapes = {circle(is_load ? 0.35 : 0.1)},
                                   .position = place,
                                   .mass = mass,
                                   .gravity_scale = own / mass,
                                   .fixed_rotation = true,
                                   .filter = {.collides_with = 0}});
    scene.join<DistanceJoint>({.a = last, .b = body, .anchor_a = above, .anchor_b = place});
    last = body;
    above = place;
  }
  return scene;
}

List<double> forces_of(const ChainSettings& settings) {
  List<double> forces;
  for (int i = 0; i <= settings.beads; ++i)
    forces.push_back((settings.load + (settings.beads - i) * settings.bead) * gravity);
  return forces;
}

List<double> squared_frequencies(const ChainSettings& settings, const List<double>& masses) {
  const List<double> force = forces_of(settings);
  Matrix<double> K = Matrix<double>::Zero(settings.beads + 1, settings.beads + 1);
  for (int i = 0; i <= settings.beads; ++i) {
    const double k = force[i] / rod_length;  // [N/m] of rod i, sideways
    K(i, i) += k;
    if (i == 0) continue;
    K(i - 1, i - 1) += k;
    K(i - 1, i) -= k;
    K(i, i - 1) -= k;
  }
  for (int i = 0; i <= settings.beads; ++i) {
    const double root = std::sqrt(i < settings.beads ? masses[i] : settings.load);
    K.row(i) /= root;
    K.col(i) /= root;
  }
  const Eigen::SelfAdjointEigenSolver<Matrix<double>> swings(K, Eigen::EigenvaluesOnly);
  return {swings.eigenvalues().begin(), swings.eigenvalues().end()};
}

double fastest_angle(const ChainSettings& settings) {
  return std::sqrt(squared_frequencies(settings, List<double>(settings.beads, settings.bead)).back()) *
         settings.dt;
}

double critical_load(ChainSettings settings) {
  double low = 0, high = 2 * load_by_rule(settings) + settings.bead;
  while (high - low > 1e-12 * high) {
    settings.load = (low + high) / 2;
    (fastest_angle(settings) > 2 ? high : low) = settings.load;
  }
  return low;
}

double load_by_rule(const ChainSettings& settings) {
  return rod_length * settings.bead / (settings.dt * settings.dt * gravity);
}

double growth_by_formula(double angle) {
  // [growth]
  const double half = angle * angle / 2 - 1;  // x(k+1) + 2 half x(k) + x(k-1) = 0
  return half <= 1 ? 1 : half + std::sqrt(half * half - 1);
  // [/growth]
}

List<double> masses_needed(const ChainSettings& settings) {
  const List<double> force = forces_of(settings);
  List<double> masses;
  for (int i = 0; i < settings.beads; ++i) {
    const double k = (force[i] + force[i + 1]) / rod_length;  // [N/m] of both rods
    masses.push_back(std::max(settings.bead, settings.dt * settings.dt * k / 2));
  }
  return masses;
}

}  // namespace cairn::taut
