// Contact rows that are written straight into a problem, against those that are stated first: the same bits.
#include <doctest/doctest.h>

#include "../geometry/random_shapes.hpp"
#include "constraints/contact.hpp"

namespace cairn {
namespace {

template <Scalar Real>
struct Touching {
  Manifold<Real> manifold;
  ContactMaterial<Real> material;
  PerBody<Pose<Real>> poses;
  PerBody<Vec3<Real>> velocity_before;
  VelocityProblem<Real> problem;
};

template <Scalar Real>
Vec2<Real> random_place(double most, test::Random& random) {
  return random.point(most).cast<Real>();
}

/// Two bodies that overlap, touch or are apart; slow or fast enough to rebound; one may be immovable.
template <Scalar Real>
Touching<Real> random_touch(test::Random& random) {
  const auto number = [&](double lower, double upper) {
    return static_cast<Real>(random.uniform(lower, upper));
  };
  Touching<Real> touching;
  touching.manifold.normal = Rotation<Real>(number(-3, 3)) * Vec2<Real>(0, 1);
  touching.manifold.count = 1 + random.below(2);
  for (int i = 0; i < touching.manifold.count; ++i) {
    touching.manifold.points[i] = {random_place<Real>(1, random), number(-0.05, 0.02),
                                   static_cast<std::uint32_t>(random.below(1000))};
  }
  touching.material = {
      .friction = random.below(3) == 0 ? Real(0) : number(0, 1),
      .restitution = random.below(2) == 0 ? Real(0) : number(0, 1),
      .restitution_threshold = Real(0.5),
      .friction_rows = random.below(2) == 0 ? FrictionRows::per_point : FrictionRows::per_manifold,
      .slop_limit = number(0.001, 0.01),
      .gravity = random.below(2) == 0 ? Real(0) : Real(10)};
  for (int body = 0; body < 3; ++body) {
    touching.poses.push_back({random_place<Real>(2, random), number(-3, 3)});
    touching.velocity_before.push_back({number(-2, 2), number(-2, 2), number(-2, 2)});
    touching.problem.velocity.push_back({number(-2, 2), number(-2, 2), number(-2, 2)});
    const Real inverse = body == 0 ? Real(0) : number(0.1, 2);
    touching.problem.inverse_mass.push_back({inverse, inverse, body == 2 ? Real(0) : inverse * 3});
  }
  touching.problem.dt = number(0.001, 0.02);
  return touching;
}

template <Scalar Real>
bool same_row_bits(const ConstraintRow<Real>& one, const ConstraintRow<Real>& other) {
  const Bounds<Real>&left = one.bounds, &right = other.bounds;
  return one.a == other.a && one.b == other.b && one.jacobian_a == other.jacobian_a &&
         one.jacobian_b == other.jacobian_b && one.bias == other.bias && one.softness == other.softness &&
         left.lower == right.lower && left.upper == right.upper && left.friction == right.friction &&
         left.disc == right.disc && left.normal_row == right.normal_row &&
         left.second_normal_row == right.second_normal_row && one.key == other.key &&
         one.first_extra == other.first_extra && one.extra_count == other.extra_count;
}

}  // namespace

TEST_CASE_TEMPLATE("contact rows written at once have the bits of those that are stated and stabilized", Real,
                   float, double, long double) {
  test::Random random(29);
  for (const auto policy : {StabilizationPolicy::none, StabilizationPolicy::baumgarte,
                            StabilizationPolicy::soft, StabilizationPolicy::split_impulse}) {
    for (const auto pass :
         {StabilizationPass::velocity, StabilizationPass::relax, StabilizationPass::position}) {
      for (int round = 0; round < 100; ++round) {
        Touching<Real> touching = random_touch<Real>(random);
        VelocityProblem<Real>& problem = touching.problem;
        const Stabilization stabilization = {
            .policy = policy, .max_speed = round % 2 == 0 ? 4 : std::numeric_limits<double>::infinity()};
        const BodyId a{random.below(2)}, b{2};
        const int before = 3;  // rows of something else
        RowSpecs<Real> specs;
        append_contact_rows(touching.manifold, a, b, touching.material, touching.poses,
                            touching.velocity_before, specs);
        const BodyState<Real> begin = {{}, problem.velocity, problem.inverse_mass};
        List<ConstraintRow<Real>> expected;
        for (const RowSpec<Real>& spec : specs) {
          stabilize_row(spec, stabilization, pass, begin, problem, 77, before, expected.emplace_back());
        }
        problem.rows.resize(random.below(10) + before);  // longer or shorter than what will be written
        int next = before;
        write_contact_rows(touching.manifold, a, b, touching.material, touching.poses,
                           touching.velocity_before,
                           ContactStabilization<Real>(stabilization, pass, problem.dt), 77, problem, next);
        REQUIRE(next == before + expected.size());
        for (int i = 0; i < expected.size(); ++i) CHECK(same_row_bits(problem.rows[before + i], expected[i]));
      }
    }
  }
}

TEST_CASE("between bodies that nothing moves no contact row is written") {
  test::Random random(2);
  Touching<double> touching = random_touch<double>(random);
  touching.problem.inverse_mass.assign(3, Vec3<double>::Zero());
  int next = 0;
  write_contact_rows(touching.manifold, {0}, {1}, touching.material, touching.poses, touching.velocity_before,
                     ContactStabilization<double>({}, StabilizationPass::velocity, 0.01), 1, touching.problem,
                     next);
  CHECK(next == 0);
}

}  // namespace cairn
