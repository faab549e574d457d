// Capsules and filters in two engines: where they rest, which way they push, and who meets whom.
#include "engines.hpp"
#include "testing.hpp"

namespace cairn::reference_tests {

namespace {

constexpr double capsule_radius = 0.25, capsule_half = 0.5;  // [m] of the capsule, and of the line in it

/// A capsule that begins 0.02 m above the ground; it stands or lies.
Scene capsule_on_ground(bool stands) {
  Scene scene;
  scene.add_ground();
  const Vec2<double> end = stands ? Vec2<double>(0, capsule_half) : Vec2<double>(capsule_half, 0);
  scene.add({.shapes = {capsule(-end, end, capsule_radius)},
             .position = {0, capsule_radius + (stands ? capsule_half : 0) + 0.02},
             .fixed_rotation = stands});
  return scene;
}

/// Whether a box that begins 0.1 m above a plate is there after a second, or has fallen through.
bool is_held(const Snapshot& snapshot) { return snapshot.bodies[{2}].pose.position.y() > 0; }

}  // namespace

TEST_CASE("a capsule lies on two points and stands on one, which carry its weight, in both engines") {
  for (const bool stands : {false, true}) {
    CAPTURE(stands);
    const Scene scene = capsule_on_ground(stands);
    Engines engines(scene);
    engines.step(120);
    const double rest = capsule_radius + (stands ? capsule_half : 0);
    const double weight = scene.bodies()[{1}].mass * 10;
    for (const Snapshot& view : {snapshot(engines.cairn), engines.box2d.snapshot()}) {
      REQUIRE(view.contacts.size() == (stands ? 1 : 2));
      double carried = 0;
      for (const SnapshotContact& contact : view.contacts) {
        carried += contact.normal_impulse;
        CHECK(std::abs(contact.normal.y()) == doctest::Approx(1).epsilon(1e-6));
        if (!stands) CHECK(std::abs(contact.position.x()) == doctest::Approx(capsule_half).epsilon(0.01));
      }
      CHECK(carried == doctest::Approx(weight / 60).epsilon(1e-3));
    }
    // Cairn leaves up to its slop of overlap; in Box2D the ground's skin is pressed in by as much.
    CHECK(std::abs(body(snapshot(engines.cairn), {1}).pose.position.y() - rest) <= 0.005 + 1e-6);
    const double in_box2d = body(engines.box2d.snapshot(), {1}).pose.position.y() - rest;
    CHECK(in_box2d >= box2d_skin - box2d_slop - 1e-3);
    CHECK(in_box2d <= box2d_skin + 1e-3);
  }
}

TEST_CASE("the end of a capsule is round to a disc: both engines push it away from the middle of that end") {
  Scene scene({.gravity = {0, 0}});
  scene.add({.type = BodyType::static_body,
             .shapes = {capsule({0, -capsule_half}, {0, capsule_half}, capsule_radius)}});
  const Vec2<double> away(0.6, 0.8);  // from the upper end to the disc, unit
  const double overlap = 0.002, radius = 0.3;
  const Vec2<double> end(0, capsule_half);
  scene.add({.shapes = {circle(radius)}, .position = end + (capsule_radius + radius - overlap) * away});
  Engines engines(scene);
  engines.step(1);
  for (const Snapshot& view : {snapshot(engines.cairn), engines.box2d.snapshot()}) {
    REQUIRE(view.contacts.size() == 1);
    CHECK((view.contacts[0].normal - away).norm() <= 100 * float_rounding);
    CHECK(view.contacts[0].separation == doctest::Approx(-overlap).epsilon(100 * float_rounding / overlap));
  }
}

TEST_CASE("a ball lies on the middle of a capsule, between its ends, in both engines") {
  Scene scene;
  scene.add({.type = BodyType::static_body,
             .shapes = {capsule({-capsule_half, 0}, {capsule_half, 0}, capsule_radius)}});
  scene.add({.shapes = {circle(0.1)}, .position = {0, capsule_radius + 0.12}});
  Engines engines(scene);
  engines.step(120);
  const double rest = capsule_radius + 0.1;
  CHECK(std::abs(body(snapshot(engines.cairn), {2}).pose.position.y() - rest) <= 0.005 + 1e-6);
  // The middle is 0.01 m inside, and its skin is pressed in by the slop.
  CHECK(body(engines.box2d.snapshot(), {2}).pose.position.y() ==
        doctest::Approx(rest - 0.01 - box2d_slop).epsilon(0.01));
  REQUIRE(engines.box2d.snapshot().contacts.size() == 1);
  CHECK(engines.box2d.snapshot().contacts[0].separation == doctest::Approx(-0.01 - box2d_slop).epsilon(0.1));
}

TEST_CASE("bodies meet in both engines where each accepts the other's category, and only there") {
  struct Filter {
    std::uint32_t plate_accepts, box_accepts;
    bool held;
  };
  // The plate is of category 2, the box of category 4; bits beyond 16 are of no category that Box2D knows.
  for (const Filter& filter : {Filter{4, 2, true}, Filter{~0u, ~0u, true}, Filter{1u << 20 | 4, 2, true},
                               Filter{1, 2, false}, Filter{4, 1, false}, Filter{1u << 18, 2, false}}) {
    CAPTURE(filter.plate_accepts);
    CAPTURE(filter.box_accepts);
    Scene scene;
    scene.add({.type = BodyType::static_body,
               .shapes = {box(4, 0.2)},
               .position = {0, -0.1},
               .filter = {.category = 2, .collides_with = filter.plate_accepts}});
    scene.add({.shapes = {box(1, 1)},
               .position = {0, 0.6},
               .filter = {.category = 4, .collides_with = filter.box_accepts}});
    Engines engines(scene);
    engines.step(60);
    CHECK(is_held(snapshot(engines.cairn)) == filter.held);
    CHECK(is_held(engines.box2d.snapshot()) == filter.held);
  }
}

}  // namespace cairn::reference_tests
