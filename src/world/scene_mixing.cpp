// Floor 5. From two materials to what their surfaces have in common.
#include <cairn/world/scene_mixing.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <cairn/math/check.hpp>

namespace cairn {

namespace {

// Huge coefficients are as good as infinite ones, and infinity times an impulse of 0 has no value.
constexpr double most_friction = 1e6;

double mix(MixingRule rule, double x, double y) {
  switch (rule) {
    case MixingRule::geometric_mean:
      return std::sqrt(x) * std::sqrt(y);
    case MixingRule::minimum:
      return std::min(x, y);
    case MixingRule::average:
      return (x + y) / 2;
    case MixingRule::maximum:
      return std::max(x, y);
    case MixingRule::product:
      break;
  }
  return x * y;
}

bool is_among(const List<BodyId>& bodies, BodyId body) {
  return std::binary_search(bodies.begin(), bodies.end(), body);
}

bool is_of(const PairMaterial& pair, BodyId a, BodyId b) {
  return (is_among(pair.a, a) && is_among(pair.b, b)) || (is_among(pair.a, b) && is_among(pair.b, a));
}

void require_friction(double value, const std::string& place, const char* field) {
  require(value >= 0 && value <= most_friction, place, field, "from 0 to 1e6", value);
}

void require_static_friction(double value, double kinetic, const std::string& place) {
  require(value >= kinetic && value <= most_friction, place, "static_friction",
          "from friction, " + shortest(kinetic) + ", to 1e6", value);
}

void require_restitution(double value, const std::string& place) {
  require(value >= 0 && value <= 1, place, "restitution", "in [0, 1]", value);
}

void require_bodies(const List<BodyId>& ids, int bodies, const std::string& place, const char* field) {
  const bool in_order = std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<BodyId>()) == ids.end();
  require(!ids.empty() && in_order && ids[0].index >= 0 && ids.back().index < bodies, place, field,
          "bodies of the scene, in the order of their ids",
          ids.empty() ? std::string("none") : std::to_string(ids.back().index));
}

}  // namespace

PairSurface mixed(const Mixing& mixing, BodyId a, const Material& of_a, BodyId b, const Material& of_b) {
  PairSurface result;
  result.friction = mix(mixing.friction, of_a.friction, of_b.friction);
  result.static_friction = mix(mixing.friction, of_a.holding_friction(), of_b.holding_friction());
  result.restitution = mix(mixing.restitution, of_a.restitution, of_b.restitution);
  for (const PairMaterial& pair : mixing.pairs) {
    if (!is_of(pair, a, b)) continue;
    if (pair.friction) result.friction = result.static_friction = *pair.friction;
    if (pair.static_friction) result.static_friction = *pair.static_friction;
    if (pair.restitution) result.restitution = *pair.restitution;
  }
  result.static_friction = std::max(result.friction, result.static_friction);
  return result;
}

void require_material(const Material& material, const char* place) {
  require_friction(material.friction, place, "friction");
  if (material.static_friction) require_static_friction(*material.static_friction, material.friction, place);
  require_restitution(material.restitution, place);
  require(material.rolling_resistance >= 0 && std::isfinite(material.rolling_resistance), place,
          "rolling_resistance", ">= 0 m and finite", material.rolling_resistance);
  require_finite(material.surface_speed, place, "surface_speed", "m/s");
}

void require_mixing(const Mixing& mixing, int bodies) {
  for (int i = 0; i < mixing.pairs.size(); ++i) {
    const PairMaterial& pair = mixing.pairs[i];
    const std::string place = "Scene: mixing.pairs[" + std::to_string(i) + "]";
    require_bodies(pair.a, bodies, place, "a");
    require_bodies(pair.b, bodies, place, "b");
    if (pair.friction) require_friction(*pair.friction, place, "friction");
    if (pair.static_friction)
      require_static_friction(*pair.static_friction, pair.friction.value_or(0), place);
    if (pair.restitution) require_restitution(*pair.restitution, place);
  }
}

}  // namespace cairn
