// Floor 8. Blocks and wheels on a slope: sticking, sliding, rolling and tipping.
#include <cairn/geometry/shape.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

/// A slope that goes down to the right, and its axes.
struct CaseSlope {
  double angle = 0;  // [rad]
  Vec2<double> along() const { return {std::cos(angle), -std::sin(angle)}; }
  Vec2<double> normal() const { return {std::sin(angle), std::cos(angle)}; }
};

/// A slope through the origin and `body` on it, whose centre is `height` above the surface. Both surfaces
/// have the friction of the body.
Scene scene_on_slope(const CaseSlope& slope, BodySpec body, double height, double frequency = 60) {
  Scene scene({.dt = 1 / frequency});
  scene.add({.type = BodyType::static_body,
             .shapes = {box(40, 1)},
             .position = -0.5 * slope.normal(),
             .angle = -slope.angle,
             .material = {.friction = body.material.friction}});
  body.position = height * slope.normal();
  body.angle = -slope.angle;
  scene.add(body);
  return scene;
}

/// Of the only body on a slope.
double slope_speed(const CaseSlope& slope, const Snapshot& now) {
  return slope.along().dot(now.bodies.back().velocity.head<2>());
}
double slope_way(const CaseSlope& slope, const Snapshot& now) {
  return slope.along().dot(now.bodies.back().pose.position);
}

BodySpec slope_block(double width, double height, double friction) {
  return {.shapes = {box(width, height)}, .mass = 1, .material = {.friction = friction}};
}

/// The angles [degrees] between which a block begins to slide.
Bracket sliding_begins(const EngineMaker& make, double mu) {
  return bisected({26, 27}, 0.001, [&](double degrees) {
    const CaseSlope slope{in_radians(degrees)};
    const Snapshot end = run_scene(make, scene_on_slope(slope, slope_block(1, 0.5, mu), 0.25), 10, 1);
    // What a block reaches in a second at 0.005 degrees above the threshold: tan grows by 1 + mu^2 a radian.
    const double steepness = in_radians(0.005) * (1 + mu * mu);
    return slope_speed(slope, end) > standard_gravity * std::cos(slope.angle) * steepness;
  });
}

// Coulomb: friction m g sin up to mu m g cos. Beyond, the discrete sums of a constant pull a are exact.
ValidationResult block_on_slope(const EngineMaker& make) {
  ValidationResult result;
  add_bracket(result.numbers,
              {.what = "steepest slope, mu = 0.5: ",
               .formula = "atan(mu)",
               .unit = "degrees",
               .expected = in_degrees(std::atan(0.5)),
               .tolerance = 0.0065,
               .reason = "called sliding from 0.005 degrees on, bisected to 0.001, and half of that"},
              sliding_begins(make, 0.5), "it holds", "it slides");
  const double mu = 0.3;
  const CaseSlope slope{in_radians(30)};
  const double a = standard_gravity * (std::sin(slope.angle) - mu * std::cos(slope.angle));
  const auto after_a_second = [&](double frequency) {
    return run_scene(make, scene_on_slope(slope, slope_block(1, 0.5, mu), 0.25, frequency), 50, 1);
  };
  const Snapshot end = after_a_second(60);
  const std::string reason = "the sums are exact; 50 sweeps of a contact at two points leave rounding";
  result.add(measured("speed after 1 s at 30 degrees, mu = 0.3", slope_speed(slope, end), "m/s")
                 .by("g (sin - mu cos) t", a)
                 .within(1e-9 * a, reason));
  result.add(measured("way after 1 s at 30 degrees, mu = 0.3", slope_way(slope, end), "m")
                 .by("a t^2/2 + a t dt/2", a / 2 + a * standard_dt / 2)
                 .within(1e-9 * a, reason));
  result.convergence = converges("way after 1 s, to a t^2/2", [&](double frequency) {
    return slope_way(slope, after_a_second(frequency)) - a / 2;
  });
  return result;
}

const double slope_wheel_radius = 0.5;  // [m]

/// A wheel whose moment of inertia is `share` of m R^2, after a second on a slope of 30 degrees.
Snapshot wheel_on_slope(const EngineMaker& make, double share, double mu) {
  const double radius = slope_wheel_radius;
  const BodySpec wheel{.shapes = {circle(radius)},
                       .mass = 1,
                       .inertia = share * radius * radius,
                       .material = {.friction = mu}};
  return run_scene(make, scene_on_slope({in_radians(30)}, wheel, radius), 10, 1);
}

// Rolling: m a = m g sin - F and I a / R = F R give a = g sin/(1 + k) with k = I/m R^2, and F/N = tan/(1 +
// 1/k).
ValidationResult wheel_down_slope(const EngineMaker& make) {
  ValidationResult result;
  const CaseSlope slope{in_radians(30)};
  const auto add = [&](const std::string& what, const std::string& formula, double expected, double got) {
    result.add(
        measured(what, got, "m/s")
            .by(formula, expected)
            .within(1e-9 * expected, "the sums are exact; the rows of a wheel do not act on each other"));
  };
  for (const double share : {0.5, 1.0}) {
    const std::string wheel = share < 1 ? "disc" : "hoop";
    const double least_mu = std::tan(slope.angle) / (1 + 1 / share);
    const Snapshot rolls = wheel_on_slope(make, share, 1.01 * least_mu);
    const double rolling = standard_gravity * std::sin(slope.angle) / (1 + share);
    const std::string formula = share < 1 ? "2/3 g sin t" : "1/2 g sin t";
    const std::string above = share < 1 ? ", mu = 1.01 tan/3, after 1 s" : ", mu = 1.01 tan/2, after 1 s";
    add("speed of a " + wheel + above, formula, rolling, slope_speed(slope, rolls));
    add("speed of the rim of this " + wheel, formula, rolling,
        -rolls.bodies.back().velocity.z() * slope_wheel_radius);
    const double mu = 0.99 * least_mu;
    const Snapshot slips = wheel_on_slope(make, share, mu);
    const std::string below = share < 1 ? ", mu = 0.99 tan/3, after 1 s" : ", mu = 0.99 tan/2, after 1 s";
    add("speed of a " + wheel + below, "g (sin - mu cos) t",
        standard_gravity * (std::sin(slope.angle) - mu * std::cos(slope.angle)), slope_speed(slope, slips));
    add("speed of the rim of this " + wheel + ", which slips", share < 1 ? "2 mu g cos t" : "mu g cos t",
        mu * standard_gravity * std::cos(slope.angle) / share,
        -slips.bodies.back().velocity.z() * slope_wheel_radius);
  }
  return result;
}

/// The angles [degrees] between which a block 1 m wide and 2 m high, with mu = 1, begins to tip over.
Bracket tipping_begins(const EngineMaker& make) {
  return bisected({25.5, 27.5}, 0.01, [&](double degrees) {
    const CaseSlope slope{in_radians(degrees)};
    const Snapshot end = run_scene(make, scene_on_slope(slope, slope_block(1, 2, 1), 1), 30, 2);
    return std::abs(end.bodies.back().pose.angle + slope.angle) > 0.05;
  });
}

// Its weight passes the lower edge where tan = w/h; with mu < w/h friction gives way first.
ValidationResult tall_block_on_slope(const EngineMaker& make) {
  ValidationResult result;
  add_bracket(
      result.numbers,
      {.what = "steepest slope of a block of 1 m by 2 m, mu = 1: ",
       .formula = "atan(w/h)",
       .unit = "degrees",
       .expected = in_degrees(std::atan(0.5)),
       .tolerance = 0.045,
       .reason = "from 0.032 degrees on it tilts 0.05 rad in 2 s: cosh p t, p^2 = 3g/4R; bisected to 0.01"},
      tipping_begins(make), "it stands", "it tips");
  const CaseSlope slope{in_radians(30)};
  const Snapshot end = run_scene(make, scene_on_slope(slope, slope_block(1, 2, 0.4), 1), 50, 1);
  const double a = standard_gravity * (std::sin(slope.angle) - 0.4 * std::cos(slope.angle));
  result.add(
      measured("speed of the same block after 1 s at 30 degrees, mu = 0.4 < w/h", slope_speed(slope, end),
               "m/s")
          .by("g (sin - mu cos) t", a)
          .within(1e-9 * a, "the sums are exact; 50 sweeps of a contact at two points leave rounding"));
  result.add(measured("its tilt meanwhile", end.bodies.back().pose.angle + slope.angle, "rad")
                 .zero_within(1e-9, "both edges stay on the slope: what 50 sweeps leave"));
  return result;
}

}  // namespace

void add_slope_cases(ValidationCases& cases) {
  cases.push_back({.id = "B5",
                   .title = "A block stays on a slope up to tan(angle) = mu, and then slides evenly faster",
                   .source = "C. A. Coulomb, 1785",
                   .asks = Asks::any_engine,
                   .run = block_on_slope});
  cases.push_back(
      {.id = "B10",
       .title = "A disc rolls down a slope at 2/3 g sin, a hoop at 1/2 g sin, while friction holds",
       .asks = Asks::any_engine,
       .run = wheel_down_slope});
  cases.push_back({.id = "B11",
                   .title = "A tall block tips over at tan(angle) = width / height, unless it slides first",
                   .asks = Asks::any_engine,
                   .run = tall_block_on_slope});
}

}  // namespace cairn
