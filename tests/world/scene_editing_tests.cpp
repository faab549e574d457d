// Editing a scene: bodies and joints that go, and what is refused.
#include "edited_scenes.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

using Pairs = List<std::pair<BodyId, BodyId>>;

}  // namespace

TEST_CASE("a removed body leaves an empty place: others keep their ids, and the next gets a new one") {
  HangingChain chain;
  Scene& scene = chain.scene;
  scene.remove(BodyId{2});
  REQUIRE(scene.bodies().size() == 4);
  const SceneBody& gone = scene.bodies()[{2}];
  CHECK(gone.removed);
  CHECK(gone.spec.type == BodyType::static_body);
  CHECK(gone.spec.shapes.empty());
  CHECK(gone.mass == 0);
  CHECK_FALSE(scene.bodies()[{3}].removed);
  CHECK(scene.bodies()[{3}].pose.position == Vec2<double>(3, 0));
  CHECK(scene.add({.shapes = {circle(1)}}) == BodyId{4});
}

TEST_CASE("the joints of a removed body go with it, and what they kept apart may touch") {
  HangingChain chain;
  chain.scene.remove(BodyId{2});
  CHECK(ids_of(chain.scene) == List<JointId>{chain.joints[0]});
  CHECK(chain.scene.joints().apart() == Pairs{{{0}, {1}}});
}

TEST_CASE("a planetary gear goes with its carrier, which it is not fastened to") {
  Scene scene;
  for (int i = 0; i < 3; ++i) scene.add({.shapes = {circle(1)}, .position = {3.0 * i, 0}});
  scene.join<GearJoint>({.a = {1}, .b = {2}, .c = {3}, .radius_a = 2, .radius_b = 1});
  scene.remove(BodyId{3});
  CHECK(scene.joints().empty());
}

TEST_CASE("a world without a body steps as one that never had it, and does not count it") {
  HangingChain chain;
  chain.scene.add_ground({.height = -0.5});
  chain.scene.remove(BodyId{2});
  Scene never;
  never.add({.shapes = {circle(0.5)}, .position = {1, 0}});
  never.add({.shapes = {circle(0.5)}, .position = {3, 0}});
  never.join<DistanceJoint>({.b = {1}, .anchor_a = {0, 0}, .anchor_b = {1, 0}});
  never.add_ground({.height = -0.5});
  World edited(chain.scene), plain(never);
  SequentialImpulse<double> solver;
  for (int step = 0; step < 30; ++step) {
    edited.step(solver);
    plain.step(solver);
  }
  CHECK(edited.bodies().velocity[{1}] == plain.bodies().velocity[{1}]);
  CHECK(edited.bodies().pose[{3}].position == plain.bodies().pose[{2}].position);
  CHECK(explain(make_plan(edited.scene())) == explain(make_plan(plain.scene())));
  CHECK(make_plan(edited.scene()).size.bodies == 3);
  const Snapshot now = snapshot(edited);
  CHECK(now.bodies[{2}].removed);
  CHECK(now.bodies[{2}].shapes.empty());
  CHECK_FALSE(now.bodies[{3}].removed);
}

TEST_CASE("a joint keeps its id while others come and go, and the id is not used again") {
  HangingChain chain;
  Scene& scene = chain.scene;
  CHECK(ids_of(scene) == chain.joints);
  const auto last = scene.joints()[3];
  scene.remove(chain.joints[1]);
  CHECK(ids_of(scene) == List<JointId>{chain.joints[0], chain.joints[2], chain.joints[3]});
  CHECK(scene.joints()[2] == last);
  scene.remove(chain.joints[3]);
  const JointId next = scene.join(last);
  CHECK(next > chain.joints[3]);
  CHECK(scene.joints().id(2) == next);
}

TEST_CASE("bodies stay apart until the last joint that keeps them apart is removed") {
  HangingChain chain;
  Scene& scene = chain.scene;
  scene.join<RevoluteJoint>({.a = {1}, .b = {3}, .anchor = {2, 0}}, JointCollision::on);
  const Pairs all = {{{0}, {1}}, {{1}, {2}}, {{2}, {3}}};
  CHECK(scene.joints().apart() == all);
  scene.remove(chain.joints[1]);
  CHECK(scene.joints().apart() == all);
  scene.remove(chain.joints[2]);
  CHECK(scene.joints().apart() == Pairs{{{0}, {1}}, {{2}, {3}}});
}

TEST_CASE("what cannot be edited is refused by name, and nothing changes") {
  HangingChain chain;
  Scene& scene = chain.scene;
  const BodyId gone = scene.add({.shapes = {circle(1)}, .position = {9, 9}});
  scene.remove(gone);
  const BodySpec spec = scene.bodies()[{1}].spec;
  const List<std::uint64_t> before = bits_of(scene.bodies()[{1}]);
  const auto other = [&spec](auto change) {
    BodySpec changed = spec;
    change(changed);
    return changed;
  };
  const std::string no_ground = "body must be the id of a body other than the ground, got ";
  const std::string no_removed = "body must be one that was not removed, got 4";
  CHECK(message_of([&] { scene.remove(ground); }) == "Scene::remove: " + no_ground + "0");
  CHECK(message_of([&] { scene.remove(BodyId{5}); }) == "Scene::remove: " + no_ground + "5");
  CHECK(message_of([&] { scene.remove(gone); }) == "Scene::remove: " + no_removed);
  CHECK(message_of([&] { scene.change(ground, spec); }) == "Scene::change: " + no_ground + "0");
  CHECK(message_of([&] { scene.change(gone, spec); }) == "Scene::change: " + no_removed);
  CHECK(message_of([&] { displace(scene, gone, {1, 0}); }) == "displace: " + no_removed);
  CHECK(message_of([&] { scene.place(gone, {}, {0, 0, 0}); }) == "Scene::place: " + no_removed);
  CHECK(message_of([&] { scene.place({-1}, {}, {0, 0, 0}); }) == "Scene::place: " + no_ground + "-1");
  CHECK(message_of([&] {
          scene.place({1}, {{0, NAN}, 0}, {0, 0, 0});
        }) == "Scene::place: position must be finite numbers of m, got (0, nan)");
  CHECK(message_of([&] {
          scene.place({1}, {}, {0, 0, INFINITY});
        }) == "Scene::place: angular velocity must be a finite number of rad/s, got inf");
  CHECK(message_of([&] { scene.join<RevoluteJoint>({.a = {1}, .b = gone}); }) ==
        "Scene::join: b must be a body that was not removed, got 4");
  CHECK(message_of([&] { scene.remove(JointId{4}); }) ==
        "Scene::remove: joint must be the id of a joint of this scene, got 4");
  CHECK(message_of([&] { scene.joints().id(4); }) ==
        "SceneJoints::id: number must be that of a joint of the scene, got 4");
  CHECK(
      message_of([&] { scene.change({1}, other([](BodySpec& s) { s.position.x() = 2; })); }) ==
      "Scene::change: position must be that of the body, (1, 0) m (place and displace move it), got (2, 0)");
  CHECK(message_of([&] { scene.change({1}, other([](BodySpec& s) { s.angle = 2; })); }) ==
        "Scene::change: angle must be that of the body, 0 rad (place and displace turn it), got 2");
  CHECK(message_of([&] { scene.change({1}, other([](BodySpec& s) { s.density = 0; })); }) ==
        "Scene::change: density must be > 0 kg/m^2 and finite, got 0");
  CHECK(message_of([&] { scene.change({1}, other([](BodySpec& s) { s.shapes.clear(); })); }) ==
        "Scene::change: shapes must be of some area for a dynamic body without a mass of its own, got 0");
  CHECK(message_of([&] { scene.change({1}, other([](BodySpec& s) { s.type = BodyType::static_body; })); }) ==
        "Scene::change: type must be dynamic, as nothing else that joint 0 is fastened to can move, got "
        "static");
  CHECK(bits_of(scene.bodies()[{1}]) == before);
  CHECK(ids_of(scene) == chain.joints);
  CHECK(scene.bodies().size() == 5);
}
