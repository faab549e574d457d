// Sines that are kept are those that would be computed anew.
#include "testing.hpp"

using namespace cairn;

TEST_CASE_TEMPLATE("a placement has the cosine and the sine of its angle, kept or not, wherever bodies turn",
                   Real, float, double) {
  PerBody<Pose<Real>> poses(3);
  PerBody<KnownRotation<Real>> known;
  const auto same_bits = [](Real one, Real other) {
    return one == other && std::signbit(one) == std::signbit(other);
  };
  for (const Real angle : {Real(-0.0), Real(0), Real(1), Real(1), Real(-7.5), Real(0), Real(-0.0)}) {
    poses[{1}] = {{angle, 2}, angle};
    poses[{2}].angle = -angle;
    const Placements<Real> anew(poses), kept(poses, known);
    for (const BodyId body : {BodyId{1}, BodyId{2}, BodyId{1}}) {
      const Placement<Real> one = anew[body], other = kept[body];
      CHECK(one.position == poses[body].position);
      CHECK(other.position == poses[body].position);
      CHECK(one.angle == poses[body].angle);
      CHECK(other.angle == poses[body].angle);
      CHECK(same_bits(one.rotation.c, other.rotation.c));
      CHECK(same_bits(one.rotation.s, other.rotation.s));
      CHECK(one.rotation.c == Rotation<Real>(poses[body].angle).c);
      CHECK(one.rotation.s == Rotation<Real>(poses[body].angle).s);
    }
  }
}
