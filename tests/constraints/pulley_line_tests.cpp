// Where a rope is slack, where it goes, and which ropes cannot be.
#include "joint_worlds.hpp"
#include <cairn/math/list.hpp>

using namespace cairn;
using namespace cairn::testing;

TEST_CASE(
    "a rope only pulls, is absent while it is slack, and has no direction where an end is at its roller") {
  const PerBody<Pose<double>> start = {{}, {{0, 0}, 0}, {{2, 0}, 0}};
  PulleyJoint::Spec spec{.ends = {{.body = {1}, .anchor = {0, 0}, .roller = {0, 5}},
                                  {.body = {2}, .anchor = {2, 0}, .roller = {2, 5}}}};
  const auto rows_at = [&](double y1, double y2) {
    RowSpecs<double> rows;
    const PerBody<Pose<double>> poses = {{}, {{0, y1}, 0}, {{2, y2}, 0}};
    PulleyJoint(spec, start).append_rows(poses, rows);
    return rows;
  };
  REQUIRE(rows_at(0.25, 0).size() == 1);
  CHECK(rows_at(0.25, 0)[0].error == 0.25);  // [m] of slack
  CHECK(rows_at(0.25, 0)[0].bounds.is_unilateral());
  CHECK(rows_at(0.75, 0).empty());  // more than slack_margin
  CHECK(rows_at(5, 0).empty());     // the first end is at its roller
  spec.kind = PulleyJoint::Kind::taut;
  REQUIRE(rows_at(0.75, 0).size() == 1);
  CHECK(rows_at(0.75, 0)[0].error == -0.75);
  CHECK(rows_at(0.75, 0)[0].bounds.is_equality());
  CHECK(rows_at(5, 0).empty());
}

TEST_CASE("a rope is drawn from its first anchor over all rollers to its last") {
  const PerBody<Pose<double>> start = {{}, {{0, 0}, 0}, {{2, 0}, 0}, {{4, 0}, 0}};
  PulleyJoint::Spec spec;
  for (int i = 1; i <= 3; ++i) {
    const double x = 2 * (i - 1);
    spec.ends.push_back({.body = {i}, .anchor = {x, 0}, .roller = {x, 5}});
  }
  const List<Attachment> line = PulleyJoint(spec, start).attachments();
  const List<BodyId> bodies = {{1}, ground, ground, {2}, ground, ground, {3}};
  REQUIRE(line.size() == bodies.size());
  for (int i = 0; i < line.size(); ++i) CHECK(line[i].body == bodies[i]);
  CHECK(line[1].anchor == Vec2<double>(0, 5));
  CHECK(line[2].anchor == Vec2<double>(2, 5));
  CHECK(line[4].anchor == Vec2<double>(2, 5));
  CHECK(line[5].anchor == Vec2<double>(4, 5));
}

TEST_CASE("a rope leaves a drum at the same side, however far the drum has turned and wherever it is") {
  Scene scene({.gravity = {0, 0}});
  BodySpec turning = disc({1, 3}, 1);
  turning.velocity = {0.5, 0};
  turning.angular_velocity = 2;
  const BodyId drum = scene.add(turning), held = scene.add(disc({0.5, 0}, 1));
  scene.join<PulleyJoint>({.ends = {{.body = held,
                                     .anchor = {0.5, 0},
                                     .roller = {0.5, 3},
                                     .carrier = drum,
                                     .kind = PulleyJoint::Roller::drum}},
                           .length = 100});  // slack: it pulls nothing
  World world(scene);
  CHECK(joint_row_count(world) == 0);
  step_often(world, 60);
  const SnapshotJoint rope = snapshot(world).joints[0];
  CHECK(rope.a == held);
  CHECK(rope.b == drum);
  CHECK(rope.between.empty());
  CHECK((rope.anchor_b - Vec2<double>(1, 3)).norm() <= 1e-13);  // (0.5, 3), and 0.5 m further
}

TEST_CASE("ropes that cannot be are refused") {
  const PulleyJoint::End good{.body = {1}, .anchor = {0, 0}, .roller = {0, 5}};
  const auto refusal = [&](const auto& spoil) {
    PulleyJoint::Spec spec{.ends = {good}};
    spoil(spec);
    return refusal_of<PulleyJoint>(spec);
  };
  using Spec = PulleyJoint::Spec;
  CHECK(refusal([](Spec&) {}) == "");
  CHECK(refusal([](Spec& spec) { spec.ends.clear(); }) == "PulleyJoint: ends must be at least one, got none");
  CHECK(refusal([](Spec& spec) { spec.ends[0].body = {7}; }) ==
        "PulleyJoint: end body must be the id of a body of this scene, got 7");
  CHECK(refusal([](Spec& spec) { spec.ends[0].carrier = {-1}; }) ==
        "PulleyJoint: end carrier must be the id of a body of this scene, got -1");
  CHECK(refusal([](Spec& spec) { spec.ends[0].carrier = {1}; }) ==
        "PulleyJoint: end carrier must be another body than the end's, got 1");
  CHECK(refusal([](Spec& spec) { spec.ends[0].parts = 0; }) ==
        "PulleyJoint: end parts must be a finite number > 0, got 0");
  CHECK(refusal([](Spec& spec) { spec.ends[0].anchor.x() = std::nan(""); }) ==
        "PulleyJoint: end anchor must be finite numbers of m, got (nan, 0)");
  CHECK(refusal([](Spec& spec) { spec.ends[0].kind = PulleyJoint::Roller::drum; }) ==
        "PulleyJoint: end carrier must be a body that can turn for a drum, got 0");
  CHECK(refusal([](Spec& spec) {
          spec.ends[0].roller = {0, 0};
        }) == "PulleyJoint: length must be > 0 m and finite, got 0");
  CHECK(refusal([](Spec& spec) { spec.slack_margin = -1; }) ==
        "PulleyJoint: slack_margin must be a finite number >= 0 m, got -1");
  CHECK(refusal([](Spec& spec) {
          spec.ends[0] = {.body = ground,
                          .anchor = {0, 5},
                          .roller = {0, 1},
                          .carrier = {1},
                          .kind = PulleyJoint::Roller::drum};
        }) == "PulleyJoint: end roller must be where a rope can leave its drum sideways, got 0");

  PulleyJoint::Spec five;
  for (int i = 1; i <= 5; ++i) five.ends.push_back({.body = {i}, .anchor = {0, 0}, .roller = {0, 5}});
  CHECK_THROWS_WITH(
      PulleyJoint(five, PerBody<Pose<double>>(6)),
      "PulleyJoint: ends must be on at most 4 bodies besides the ground, carriers among them, got 5");
}
