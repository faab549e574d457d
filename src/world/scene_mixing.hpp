// Floor 5. What two surfaces have in common where they touch.
#pragma once

#include <optional>

#include <cairn/dynamics/body.hpp>
#include <cairn/math/list.hpp>
#include <cairn/math/shared_list.hpp>

namespace cairn {

/// What a surface is like. What two that touch have in common follows by the scene's Mixing.
///
/// Friction is that of Coulomb: surfaces that slide on each other have `friction`, and those that stick hold
/// up to `static_friction`. They stick while they are no faster along each other than `friction` could stop
/// within a substep: a speed that vanishes with dt, as in Stribeck's curve (1902). Rolling
/// resistance is that of textbooks, too (Coulomb, 1785): a moment of at most mu_r N against the turning of
/// one body on the other, where N presses them together at one point. Of two surfaces the larger mu_r holds;
/// it needs friction.
struct Material {
  double friction = 0.6;                       // mu
  std::optional<double> static_friction = {};  // mu_s, at least mu; left out: mu
  double restitution = 0;                      // e, in [0, 1]
  double rolling_resistance = 0;               // [m] mu_r: how far the load moves ahead of the contact
  double surface_speed = 0;  // [m/s] with which it runs around its body, as a belt does: to the right where
                             // it faces up

  /// mu_s.
  double holding_friction() const { return static_friction.value_or(friction); }
  /// Member by member.
  bool operator==(const Material&) const = default;
};

/// How one number follows from those of two surfaces x and y.
enum class MixingRule {
  geometric_mean,  // sqrt(x y), Box2D's for friction
  minimum,         // of the two
  average,         // (x + y) / 2
  maximum,         // of the two, Box2D's for restitution
  product,         // x y
};

/// What is known of two surfaces together holds in place of what a rule makes of each: tables of friction
/// give coefficients of pairs.
struct PairMaterial {
  List<BodyId> a = {};                         // each of these bodies, in the order of their ids,
  List<BodyId> b = {};                         // with each of those
  std::optional<double> friction = {};         // mu
  std::optional<double> static_friction = {};  // mu_s, at least mu; left out beside mu: mu
  std::optional<double> restitution = {};      // e

  /// Member by member.
  bool operator==(const PairMaterial&) const = default;
};

/// What two surfaces have in common.
struct Mixing {
  MixingRule friction = MixingRule::geometric_mean;  // of mu, and of mu_s
  MixingRule restitution = MixingRule::maximum;      // of e
  SharedList<PairMaterial> pairs = {};               // the last one holds that says something of two bodies

  /// Whether bodies say all of it, by Box2D's rules.
  bool is_usual() const { return *this == Mixing(); }
  /// Member by member.
  bool operator==(const Mixing&) const = default;
};

/// What holds between two bodies.
struct PairSurface {
  double friction = 0;         // mu
  double static_friction = 0;  // mu_s
  double restitution = 0;      // e
};

/// Of bodies with these materials.
PairSurface mixed(const Mixing& mixing, BodyId a, const Material& of_a, BodyId b, const Material& of_b);

/// @throws std::invalid_argument unless friction is from 0 to 1e6, static friction from friction on to 1e6,
/// restitution in [0, 1], rolling resistance not negative and the surface speed finite.
void require_material(const Material& material, const char* place);

/// @throws std::invalid_argument for bodies beyond the first `bodies` ones, lists of them that are empty or
/// not in order, and numbers out of the ranges of a material.
void require_mixing(const Mixing& mixing, int bodies);

}  // namespace cairn
