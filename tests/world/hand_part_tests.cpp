// The hand alone: what it does, refuses and lets go of.
#include "testing.hpp"

using namespace cairn;

namespace {

/// A box that moves, and one that does not.
struct TwoBoxes {
  Scene scene;
  BodyId loose, fixed;
  PerBody<Pose<double>> poses;

  TwoBoxes() {
    loose = scene.add({.shapes = {box(1, 1)}, .position = {2, 3}});
    fixed = scene.add({.type = BodyType::static_body, .shapes = {box(1, 1)}});
    for (const SceneBody& body : scene.bodies()) poses.push_back(body.pose);
  }
};

}  // namespace

TEST_CASE("a hand keeps all that it did, with the step before which it did it") {
  const TwoBoxes boxes;
  Hand hand;
  hand.move(HandInput::let_go(), 3, boxes.scene, {});  // of nothing: that is no input
  CHECK(hand.inputs().empty());
  hand.move(HandInput::grab({.body = boxes.loose, .target = {5, 6}}), 4, boxes.scene, boxes.poses);
  hand.move(HandInput::drag_to({7, 8}), 9, boxes.scene, {});
  REQUIRE(hand.joint() != nullptr);
  CHECK(hand.joint()->body() == boxes.loose);
  CHECK(hand.joint()->attachments().front().anchor == Vec2<double>(7, 8));
  hand.move(HandInput::let_go(), 9, boxes.scene, {});
  CHECK(hand.joint() == nullptr);
  REQUIRE(hand.inputs().size() == 3);
  CHECK(hand.inputs()[0].step == 4);
  CHECK(hand.inputs()[1].step == 9);
  CHECK(hand.inputs()[2].kind == HandInput::Kind::let_go);
}

TEST_CASE("what a hand refuses leaves it as it was") {
  const TwoBoxes boxes;
  Hand hand;
  CHECK_THROWS_AS(hand.move(HandInput::drag_to({0, 0}), 0, boxes.scene, {}), std::invalid_argument);
  hand.move(HandInput::grab({.body = boxes.loose}), 0, boxes.scene, boxes.poses);
  const DragJoint* const before = hand.joint();
  CHECK_THROWS_AS(hand.move(HandInput::grab({.body = boxes.fixed}), 1, boxes.scene, boxes.poses),
                  std::invalid_argument);
  CHECK(hand.joint() == before);
  CHECK(hand.inputs().size() == 1);
}

TEST_CASE("in a scene without the body that it holds, a hand has let go, and knows what it did") {
  const TwoBoxes boxes;
  Hand hand;
  hand.move(HandInput::grab({.body = boxes.loose}), 0, boxes.scene, boxes.poses);
  CHECK(hand.in(boxes.scene).joint() == hand.joint());
  Scene without = boxes.scene;
  without.remove(boxes.loose);
  CHECK(hand.in(without).joint() == nullptr);
  CHECK(hand.in(without).inputs().size() == 1);
}
