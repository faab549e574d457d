// Geometric stiffness of contacts, against the second derivatives of their gaps.
#include "geometry/random_shapes.hpp"
#include <cairn/collision/collide.hpp>
#include <cairn/constraints/contact_stiffness.hpp>
#include "testing.hpp"

namespace cairn {
namespace {

constexpr BodyId pressed_a = {0}, pressed_b = {1};
constexpr double everywhere = std::numeric_limits<double>::infinity();  // a margin: all points count

/// [m] By which the core of a shape is rounded.
double rounding(const Shape<double>& shape) {
  return static_cast<double>(test::core(shape, Pose<double>{}).radius);
}

/// Two bodies of one shape each, pressed together by a force at each point of contact.
struct Press {
  Shape<double> shape_a;
  Shape<double> shape_b;
  PerBody<Pose<double>> poses;
  FixedList<double, 2> forces = {1, 1};  // [N]

  Manifold<double> found() const {
    return collide(shape_a, poses[pressed_a], shape_b, poses[pressed_b], 10.0);
  }
  KeptManifold<double> kept() const {
    return keep<double>(found(), poses[pressed_a], rounding(shape_a), poses[pressed_b], rounding(shape_b));
  }
  /// [J] -sum of lambda C of these manifolds.
  double energy(const Manifold<double>& manifold) const {
    double sum = 0;
    for (int i = 0; i < manifold.count; ++i) sum -= forces[i] * manifold.points[i].separation;
    return sum;
  }
  /// [N m/rad] As it is stated.
  double stated(BodyId body) const {
    const Manifold<double> manifold = found();
    RowForces<double> rows;
    for (int i = 0; i < manifold.count; ++i)
      rows.rows.push_back({normal_part(manifold.points[i].feature), forces[i]});
    PerBody<Vec3<double>> stiffness(2, Vec3<double>::Zero());
    const Contact<double> contact{.a = pressed_a,
                                  .b = pressed_b,
                                  .manifold = manifold,
                                  .center_a = poses[pressed_a].position,
                                  .center_b = poses[pressed_b].position};
    add_contact_stiffness(contact, rounding(shape_a), rounding(shape_b), rows, stiffness);
    CHECK(stiffness[body].head<2>().isZero(0));
    return stiffness[body].z();
  }
};

constexpr double small_turn = 1e-4;  // [rad]
// [N m] Of energies of two forces of 50 N on arms of 4 m, of which a difference has four.
constexpr double rounding_of_differences = 4 * 2 * 50 * 4 * std::numeric_limits<double>::epsilon();

/// [N m/rad] The second derivative in how a body turns of what energy_at(poses) is.
template <typename EnergyAt>
double turning_stiffness(PerBody<Pose<double>> poses, BodyId body, const EnergyAt& energy_at) {
  const double here = energy_at(poses);
  poses[body].angle += small_turn;
  const double ahead = energy_at(poses);
  poses[body].angle -= 2 * small_turn;
  return (ahead - 2 * here + energy_at(poses)) / (small_turn * small_turn);
}

}  // namespace

TEST_CASE("the geometric stiffness that a contact states is that of its gaps, whatever touches") {
  test::Random random(11);
  int corners = 0, faces = 0;
  for (int round = 0; round < 2000; ++round) {
    CAPTURE(round);
    const Vec2<double> place = random.point(1);
    const Press press{test::random_shape(random.below(test::shape_kinds), random),
                      test::random_shape(random.below(test::shape_kinds), random),
                      {{place, random.uniform(-3, 3)}, {place + random.point(2), random.uniform(-3, 3)}},
                      {random.uniform(0, 50), random.uniform(0, 50)}};
    const Manifold<double> found = press.found();
    if (found.count == 0) continue;
    const KeptManifold<double> kept = press.kept();
    const auto energy_at = [&](const PerBody<Pose<double>>& poses) {
      return press.energy(kept.at(poses[pressed_a], poses[pressed_b], everywhere));
    };
    const bool is_corner = feature_kind(found.points[0].feature) == FeatureKind::corners;
    const double length = found.points[0].separation + kept.radius_a + kept.radius_b;
    if (is_corner && length < 0.2) continue;
    (is_corner ? corners : faces) += 1;
    for (const BodyId body : {pressed_a, pressed_b}) {
      // Between corners, s out from the centres along the normal, curvature takes away lambda s^2 / length.
      const auto& core = body == pressed_a ? kept.points[0].core_a : kept.points[0].core_b;
      const double out = found.normal.dot(Rotation<double>(press.poses[body].angle) * core);
      const double left_out = is_corner ? press.forces[0] * out * out / length : 0;
      // Differences lack square / 12 of the fourth derivative, which between corners has (s / length)^3.
      const double square = small_turn * small_turn;
      const double fourth = 2 * 50 * 4 * (is_corner ? 15 * std::pow(4 / 0.2, 3) : 1);
      const double near = square / 12 * fourth + rounding_of_differences / square;
      CHECK(std::abs(press.stated(body) - left_out - turning_stiffness(press.poses, body, energy_at)) < near);
    }
  }
  CHECK(corners > 100);
  CHECK(faces > 100);
}

TEST_CASE("a flat side on a disc has the stiffness of the disc's radius, and the disc has none") {
  const double radius = 1.5, half_height = 0.1, force = 20;
  for (const Shape<double>& flat :
       {Shape<double>(box(1, 2 * half_height)), Shape<double>(capsule({-0.5, 0}, {0.5, 0}, half_height))}) {
    const Press press{circle(radius), flat, {{{0, 0}, 0}, {{0, radius + half_height}, 0}}, {force, force}};
    const auto energy_at = [&](const PerBody<Pose<double>>& poses) {
      return press.energy(collide(press.shape_a, poses[pressed_a], press.shape_b, poses[pressed_b], 10.0));
    };
    CHECK(press.stated(pressed_b) == doctest::Approx(force * (radius + half_height)).epsilon(1e-14));
    CHECK(turning_stiffness(press.poses, pressed_b, energy_at) ==
          doctest::Approx(press.stated(pressed_b)).epsilon(1e-5));
    CHECK(press.stated(pressed_a) == 0);
    CHECK(std::abs(turning_stiffness(press.poses, pressed_a, energy_at)) < 1e-5);
  }
}

TEST_CASE("a corner that stands on a face has a negative stiffness: it topples") {
  const double half_diagonal = std::sqrt(0.5), force = 20;
  Press press{box(10, 1), box(1, 1), {{{0, -0.5}, 0}, {{0, half_diagonal}, pi / 4}}, {0, 0}};
  const Manifold<double> found = press.found();
  for (int i = 0; i < found.count; ++i) press.forces[i] = found.points[i].separation < 0.1 ? force : 0;
  CHECK(press.stated(pressed_b) == doctest::Approx(-force * half_diagonal).epsilon(1e-12));
  CHECK(press.stated(pressed_a) == doctest::Approx(force / 2).epsilon(1e-12));
}

}  // namespace cairn
