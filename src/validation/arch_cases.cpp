// Floor 8. A masonry arch, stones that only friction and thrust keep up: B36.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/case_scenes.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

/// What statics asks of the thrust at the crown, H, and its moment about the origin, M: a H + b M >= c.
struct ThrustCondition {
  double a = 0;
  double b = 0;
  double c = 0;
};

/// The weight of a stone as its area, and that times the x of its middle; of the crown its right half.
Vec2<double> weight_and_moment(const ArchSpec& spec, int i) {
  List<Vec2<double>> corners = arch_stone(spec, i);
  if (i == (spec.stones - 1) / 2) corners[2].x() = corners[3].x() = 0;
  Vec2<double> sum(0, 0);
  for (int k = 0; k < 4; ++k) {
    const Vec2<double>&p = corners[k], &q = corners[(k + 1) % 4];
    sum += cross<double>(p, q) / 2 * Vec2<double>(1, (p.x() + q.x()) / 3);
  }
  return sum;
}

/// For a radius of 1. By symmetry H is level where the crown is cut in two. At every joint, above which the
/// weight is W at x: the moment about the inner corner and that about the outer one have opposite signs, so
/// that the thrust runs in between; and what is along the joint is at most mu times what is across.
List<ThrustCondition> thrust_conditions(const ArchSpec& spec) {
  List<ThrustCondition> conditions;
  Vec2<double> above(0, 0);  // W, W x
  for (int joint = (spec.stones - 1) / 2; joint >= 0; --joint) {
    above += weight_and_moment(spec, joint);
    const double c = std::cos(joint * pi / spec.stones), s = std::sin(joint * pi / spec.stones);
    const double W = above.x(), mu = spec.friction;
    for (const double side : {-1.0, 1.0}) {
      const double r = 1 + side * spec.thickness / 2;
      conditions.push_back({side * r * s, -side, side * (above.y() - r * c * W)});
      conditions.push_back({mu * s + side * c, 0, side * W * s - mu * W * c});
    }
  }
  return conditions;
}

/// How much room the conditions leave at this H, for M or for H itself; below 0 where they contradict each
/// other. The least of many linear functions of H: concave.
double room_of_thrust(const List<ThrustCondition>& conditions, double H) {
  double lower = -std::numeric_limits<double>::infinity(), upper = -lower, room = upper;
  for (const ThrustCondition& condition : conditions) {
    const double rest = condition.c - condition.a * H;
    if (condition.b > 0) lower = std::max(lower, rest / condition.b);
    if (condition.b < 0) upper = std::min(upper, rest / condition.b);
    if (condition.b == 0) room = std::min(room, -rest);
  }
  return std::min(room, upper - lower);
}

/// Whether any thrust holds the arch.
bool thrust_exists(const ArchSpec& spec) {
  const List<ThrustCondition> conditions = thrust_conditions(spec);
  double low = 0, high = 3;
  for (int i = 0; i < 200; ++i) {
    const double left = low + (high - low) / 3, right = high - (high - low) / 3;
    if (room_of_thrust(conditions, left) < room_of_thrust(conditions, right)) {
      low = left;
    } else {
      high = right;
    }
  }
  return room_of_thrust(conditions, (low + high) / 2) >= -1e-13;
}

/// Whether the crown is at rest after 0.8 s. In that time collapses go on faster and faster.
bool arch_stands(const EngineMaker& make, const ArchSpec& spec, int iterations) {
  Motion arch(make, masonry_arch(spec), iterations);
  const BodyId crown = {(spec.stones + 1) / 2};
  const double start = arch.position(crown).y();
  while (arch.time() < 0.8) {
    arch.step();
    if (start - arch.position(crown).y() > 0.02) return false;
  }
  return arch.velocity(crown).norm() < 0.02;
}

Measured least_thickness(const EngineMaker& make, int stones, int iterations) {
  const auto has_thrust = [stones](double thickness) {
    return thrust_exists({.stones = stones, .thickness = thickness, .radius = 1});
  };
  const auto stands = [&make, stones, iterations](double thickness) {
    return arch_stands(make, {.stones = stones, .thickness = thickness}, iterations);
  };
  const double expected = bisected({0.08, 0.13}, 1e-9, has_thrust).middle();
  return measured("least thickness of " + std::to_string(stones) + " stones, of the radius",
                  bisected({0.96 * expected, 1.04 * expected}, 0.01 * expected, stands).middle())
      .by("least t/R with a line of thrust inside", expected)
      .within_share(0.02, "2 %: half a bracket is 0.5 %, and the crown sinks while sweeps find the thrust");
}

/// 9 stones that have 4 % of their thickness to spare.
Measured rest_of_the_crown(const EngineMaker& make, double least) {
  Motion arch(make, masonry_arch({.stones = 9, .thickness = 1.04 * least}), 300);
  arch.run(0.8);
  return measured("speed of the crown of 9 stones, 4 % thicker, after 0.8 s", arch.velocity({5}).norm(),
                  "m/s")
      .zero_within(1e-6, "48 warm starts of 300 sweeps: 1e-6 is far above what they leave");
}

Measured least_friction(const EngineMaker& make) {
  const auto has_thrust = [](double friction) { return thrust_exists({.friction = friction, .radius = 1}); };
  const auto sticks = [&make](double friction) { return arch_stands(make, {.friction = friction}, 300); };
  return measured("least friction of 21 stones, 0.11 of the radius thick",
                  bisected({0.38, 0.41}, 0.01, sticks).middle())
      .by("least mu with a line of thrust inside", bisected({0.3, 0.5}, 1e-9, has_thrust).middle())
      .within(0.01, "half a bracket is 0.005, and the crown sinks while sweeps find the thrust");
}

ValidationResult standing_arches(const EngineMaker& make) {
  // Stones have straight edges: 0.101525 and 0.106695 of the radius, and a friction of 0.39178. Stones bent
  // along arcs of the same thickness need 0.10213, 0.10679 and 0.395; both go to 0.1075 for many stones.
  const Measured few = least_thickness(make, 9, 300);
  return {.numbers = {few, rest_of_the_crown(make, few.expected), least_thickness(make, 21, 400),
                      least_friction(make)}};
}

}  // namespace

void add_arch_cases(ValidationCases& cases) {
  cases.push_back({.id = "B36",
                   .title = "A masonry arch stands if it is thick and rough enough to hold a line of thrust",
                   .source = "M. Milankovitch, 1907; for few stones derived",
                   .asks = Asks::any_engine,
                   .run = standing_arches});
}

}  // namespace cairn
