// Floor 8. A rope round a post, how much more than the other side one side of it can hold: B32.
#include <cmath>
#include <string>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/geometry/shape.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_problems.hpp>
#include <cairn/validation/case_runs.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double capstan_friction = 0.3;
const double capstan_post = 1, capstan_bead = 0.05;  // [m] radii

/// n discs without weight on a round post, tied to each other by rods; from the first one hangs `ratio` [kg],
/// body 2, and from the last one 1 kg.
Scene rope_round_post(int n, double ratio) {
  const double reach = capstan_post + capstan_bead;
  Scene scene({.stabilization = {.slop = 1e-4}});
  scene.add({.type = BodyType::static_body,
             .shapes = {circle(capstan_post)},
             .material = {.friction = capstan_friction}});
  const auto out = [n](int i) -> Vec2<double> {
    const double angle = (i + 0.5) * pi / n;
    return {std::cos(angle), std::sin(angle)};
  };
  Vec2<double> place(reach * out(0).x(), -2);
  BodyId last = scene.add({.shapes = {circle(capstan_bead)}, .position = place, .mass = ratio});
  const auto tie = [&](const BodySpec& spec) {
    const BodyId next = scene.add(spec);
    scene.join<DistanceJoint>({.a = last, .b = next, .anchor_a = place, .anchor_b = spec.position});
    last = next;
    place = spec.position;
  };
  for (int i = 0; i < n; ++i) {
    tie({.shapes = {circle(capstan_bead)},
         .position = reach * out(i),
         .mass = 0.5,
         .material = {.friction = capstan_friction},
         .gravity_scale = 0,
         .fixed_rotation = true});
  }
  tie({.shapes = {circle(capstan_bead)}, .position = {-reach * out(0).x(), -2}, .mass = 1});
  return scene;
}

/// Whether the heavy weight sinks faster than 5e-4 m/s after a quarter of a second.
bool capstan_slips(const EngineMaker& make, int n, double ratio) {
  Motion rope(make, rope_round_post(n, ratio), 600);
  rope.run(0.25);
  return rope.velocity({2}).y() < -5e-4;
}

ValidationResult capstan(const EngineMaker& make) {
  ValidationResult result;
  for (const int n : {3, 6, 12}) {
    const double expected = capstan_ratio(n, capstan_friction);
    // 0.1 % too much gives accelerations of 1.7e-3 m/s^2 and more: 4e-4 m/s in a quarter of a second.
    const auto slips = [&make, n](double ratio) { return capstan_slips(make, n, ratio); };
    const double got = bisected({0.95 * expected, 1.05 * expected}, 0.002 * expected, slips).middle();
    result.add(measured("ratio of weights that a rope with " + std::to_string(n) + " corners holds", got)
                   .by("((1 + mu tan h)/(1 - mu tan h))^n, h = pi/2n", expected)
                   .within_share(
                       0.0025, "half a bracket of 0.2 %, and up to 0.13 % more to reach 5e-4 m/s in 0.25 s"));
  }
  // tan(h) = h + h^3 / 3 and atanh(x) = x + x^3 / 3.
  const double mu = capstan_friction;
  result.add(measured("the same with 12 corners, beside a round rope", result.numbers.back().got)
                 .by("e^(mu pi)", std::exp(mu * pi))
                 .within_share(1.5 * mu * (1 + mu * mu) * std::pow(pi, 3) / (12 * 12 * 12) + 0.0025,
                               "1.5 mu (1 + mu^2) pi^3/12 n^2 of the corners, and as above"));
  return result;
}

}  // namespace

void add_capstan_cases(ValidationCases& cases) {
  cases.push_back(
      {.id = "B32",
       .title = "A rope round a post holds ((1 + mu tan h) / (1 - mu tan h))^n times the other pull",
       .source = "L. Euler, 1769; corners derived",
       .asks = Asks::any_engine,
       .run = capstan});
}

}  // namespace cairn
