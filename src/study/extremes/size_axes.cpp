// Floor 9. Far from the origin, very small beside very large, and one inside the other.
#include <fmt/format.h>

#include <cmath>

#include <cairn/study/extremes/extreme_axes.hpp>
#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>
#include <cairn/study/tuning/recommend_scenes.hpp>

namespace cairn {

namespace {

using Policy = StabilizationPolicy;

constexpr double far_seconds = 2;  // [s]

/// The same as at the origin: how far the boxes sink depends on the policy, and not on where they are.
ExtremeFinding as_at_the_origin(double x, const Setting& setting) {
  const double at_origin = run_trial(boxes_far_off(0), setting, {.seconds = far_seconds}).farthest;
  return run_extreme(
      boxes_far_off(x), setting,
      {.seconds = far_seconds,
       .measure = {"beside the origin (m)",
                   [at_origin](const TrialResult& run) { return std::abs(run.farthest - at_origin); }},
       .limit = usual_slop,
       .floor = x - 0.5});
}

struct Distance {
  Precision scalar = Precision::double_precision;
  double x = 0;  // [m]
};

/// [m] between neighbouring numbers at x.
double spacing_at(const Distance& distance) {
  return in_scalar(distance.scalar, [&](auto real) {
    using Real = decltype(real);
    const Real x = static_cast<Real>(distance.x);
    return static_cast<double>(std::nextafter(x, std::numeric_limits<Real>::max()) - x);
  });
}

/// As good as at the origin while neighbouring numbers are closer than a tenth of the slop; refused where a
/// body is no longer than that.
ExtremeVerdict required_of_distance(const Distance& distance) {
  const double spacing = spacing_at(distance), slop = usual_slop;
  if (spacing >= 1) return ExtremeVerdict::refuse;
  return spacing < slop / 10 ? ExtremeVerdict::ok : ExtremeVerdict::bound;
}

List<Distance> distances() {
  List<Distance> all;
  for (const double x : {0.0, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8})
    all.push_back({Precision::single_precision, x});
  for (const double x : {0.0, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12, 1e13, 1e14, 1e17})
    all.push_back({Precision::double_precision, x});
  return all;
}

List<ExtremeCase> distance_cases() {
  AxisCases cases("distance");
  for (const Distance& distance : distances()) {
    for (ExtremeSetting tried : usual_settings()) {
      tried.setting.scalar = distance.scalar;
      cases.add(fmt::format("{:g} m in {}", distance.x, word_of(distance.scalar)), tried,
                required_of_distance(distance),
                [x = distance.x](const Setting& setting) { return as_at_the_origin(x, setting); });
    }
  }
  return cases.all();
}

/// A body of `size` [m] on a box of 1 m, or a box of 1 m on one of `size`. The larger one cannot be moved: it
/// would have more inertia than is allowed, and what it sinks in itself is more than all of the smaller one.
Scene large_and_small(double size) {
  const double lower = std::max(size, 1.0), upper = std::min(size, 1.0), density = 1000;
  Scene scene;
  scene.add({.type = BodyType::static_body, .shapes = {box(lower, lower)}, .position = {0, lower / 2}});
  scene.add({.shapes = {box(upper, upper)}, .position = {0, lower + upper / 2}, .density = density});
  return scene;
}

/// A tenth of the smaller; or what slop and springs give way by, if that is more: a box of side s turns by
/// its corner so easily that each of two points bears half the weight m g at 1 + (s/2)^2 / (s^2/6) = 2.5 / m.
double size_limit(double small, const Setting& setting) {
  const double slop = std::min(setting.stabilization.slop.value_or(usual_slop), 0.05 * small);  // [m]
  return std::max(0.1, (slop + spring_sag(setting, 10.0 / 2, 2.5)) / small);
}

List<ExtremeCase> size_cases() {
  AxisCases cases("size-ratio");
  for (const double size : {1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4}) {
    for (const ExtremeSetting& tried : usual_settings()) {
      const double small = std::min(size, 1.0);
      // At 60 Hz springs give way to any weight by a millimetre, and a body of that size falls through.
      const bool gives_way = spring_sag(tried.setting, 10, 1) > small / 2;
      cases.add(shortest(size), tried, gives_way ? ExtremeVerdict::refuse : ExtremeVerdict::ok,
                [size, small](const Setting& setting) {
                  return run_extreme(
                      large_and_small(size), setting,
                      {.seconds = 2,
                       .measure = {"penetration / smaller",
                                   [small](const TrialResult& run) { return run.worst_penetration / small; }},
                       .limit = size_limit(small, setting),
                       .thinnest = small,
                       .floor = 0});
                });
    }
  }
  return cases.all();
}

/// Two bodies of 1 m without gravity, the second so far into the first.
Scene overlapping(const Shape<double>& first, const Shape<double>& second, double share) {
  Scene scene({.gravity = {0, 0}});
  scene.add({.shapes = {first}});
  scene.add({.shapes = {second}, .position = {0, 1 - share}});
  return scene;
}

/// They may part at 4 m/s, the fastest for bodies that began in each other.
ExtremeFinding part(const Scene& scene, const Setting& setting) {
  const double cap = 4;  // [m/s]
  double fastest = 0;
  const auto look = [&](const Snapshot& now) {
    for (const SnapshotBody& body : now.bodies) fastest = std::max(fastest, body.velocity.norm());
    return fastest > cap;
  };
  return run_extreme(scene, setting,
                     {.seconds = 2,
                      .measure = {"fastest body (m/s)", [&](const TrialResult&) { return fastest; }},
                      .limit = cap,
                      .thinnest = 1e300,
                      .energy_gain = 1e300,
                      .escaped = look});
}

List<ExtremeCase> overlap_cases() {
  struct Two {
    std::string text;
    Shape<double> first;
    Shape<double> second;
  };
  const Shape<double> disc = circle(0.5), square = box(1, 1), rod = capsule({-0.3, 0}, {0.3, 0}, 0.5);
  AxisCases cases("overlap");
  for (const Two& two : {Two{"discs", disc, disc}, Two{"boxes", square, square}, Two{"capsules", rod, rod},
                         Two{"disc in box", square, disc}, Two{"capsule in disc", disc, rod}}) {
    for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
      cases.add_usual(fmt::format("{:g} %, {}", 100 * share, two.text), ExtremeVerdict::bound,
                      [two, share](const Setting& setting) {
                        return part(overlapping(two.first, two.second, share), setting);
                      });
    }
  }
  return cases.all();
}

}  // namespace

List<ExtremeAxis> size_axes() {
  const std::string usual = "si and block under every policy, block-contact, PGS, accelerated";
  return {{"distance", "three boxes so far from the origin, in x and in y, 2 s", usual, distance_cases},
          {"size-ratio", "a box of so many metres beside one of 1 m, each of one material, 2 s", usual,
           size_cases},
          {"overlap", "two bodies of 1 m that begin so far in each other, 2 s", usual, overlap_cases}};
}

}  // namespace cairn
