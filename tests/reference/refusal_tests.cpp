// What Box2D 2.4.1 does not have is refused, in words.
#include "engines.hpp"
#include "testing.hpp"

namespace cairn::reference_tests {

namespace {

std::string refusal(const Scene& scene, const Box2DSettings& settings = {}) {
  return testing::message_of([&] { const Box2DWorld world(scene, settings); });
}

Scene scene_with(const Shape<double>& shape) {
  Scene scene;
  scene.add({.shapes = {shape}});
  return scene;
}

Polygon<double> regular_polygon(int count) {
  List<Vec2<double>> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  return polygon(points);
}

/// A joint of one's own, which Box2D cannot know.
class Magnet final : public ConstraintOf<Magnet> {
 public:
  std::string name() const override { return "magnet"; }
  List<Attachment> attachments() const override { return {{ground, {0, 0}}, {{1}, {0, 0}}}; }
  template <Scalar Real>
  void rows(const Placements<Real>&, RowWriter<Real>&) const {}
};

TEST_CASE("sensors, and categories for which Box2D has no bit, are refused") {
  Scene sensing, filtering;
  sensing.add({.shapes = {box(1, 1)}, .sensor = true});
  filtering.add({.shapes = {box(1, 1)}, .filter = {.category = 1u << 16}});
  CHECK(refusal(sensing) == "Box2DWorld: sensor must be false: sensors are not taken over, got true");
  CHECK(refusal(filtering) ==
        "Box2DWorld: category must be of the first 16 bits, as Box2D 2.4.1 has no more, got 65536");
}

TEST_CASE("Box2D has one coefficient of friction, no rolling resistance and one law of impacts") {
  const auto with = [](const Material& material, Impacts impacts) {
    Scene scene({.impacts = impacts});
    scene.add_ground();
    scene.add({.shapes = {circle(1)}, .position = {0, 1}, .material = material});
    return refusal(scene);
  };
  CHECK(with({.static_friction = 0.8}, Impacts::at_once) ==
        "Box2DWorld: static_friction must be that of sliding, as Box2D has one coefficient, got more");
  CHECK(with({.rolling_resistance = 0.01}, Impacts::at_once) ==
        "Box2DWorld: rolling_resistance must be 0, as Box2D 2.4.1 has none, got more");
  CHECK(with({.restitution = 1}, Impacts::sequence) ==
        "Box2DWorld: impacts must be at once, as Box2D has no other law, got a sequence");
  CHECK(with({.restitution = 1}, Impacts::at_once).empty());
}

TEST_CASE("Box2D has no rounded polygons, and no polygons of more than 8 vertices") {
  CHECK(refusal(scene_with(box(1, 1, 0.1))) ==
        "Box2DWorld: polygon radius must be 0 m, as Box2D 2.4.1 does not round the corners of polygons, got "
        "0.1");
  CHECK(refusal(scene_with(regular_polygon(9))) ==
        "Box2DWorld: polygon vertices must be at most 8, as Box2D 2.4.1 has no room for more, got 9");
  CHECK(refusal(scene_with(regular_polygon(8))).empty());
  CHECK(refusal(scene_with(circle(0.5))).empty());
  CHECK(refusal(scene_with(capsule({0, 0}, {1, 0}, 0.5))).empty());
  CHECK(refusal(scene_with(capsule({0, 0}, {1, 0}, 0.0199)))
            .starts_with("Box2DWorld: capsule radius must be > 0.02 m, as Box2D 2.4.1 has no capsules"));
}

TEST_CASE("Box2D takes what it has of joints, and refuses others and rods shorter than its slop by name") {
  Scene scene = scene_with(circle(0.5));
  scene.join<DistanceJoint>({.a = ground, .b = {1}, .anchor_a = {0, 2}, .anchor_b = {0, 0}});
  scene.join<RevoluteJoint>({.a = ground, .b = {1}, .anchor = {0, 2}});
  CHECK(refusal(scene).empty());

  Scene short_rod = scene_with(circle(0.5));
  short_rod.join<DistanceJoint>({.a = ground, .b = {1}, .length = 0.0025});
  CHECK(refusal(short_rod).starts_with("Box2DWorld: rod length must be >= 0.005 m"));

  Scene other = scene_with(circle(0.5));
  other.join(std::make_shared<const Magnet>());
  CHECK(refusal(other) == "Box2DWorld: joint must be of a kind that Box2D 2.4.1 has, got magnet");

  const auto refused_of = []<typename Joint>(const typename Joint::Spec& spec, std::type_identity<Joint>) {
    Scene two = scene_with(circle(0.5));
    two.add({.shapes = {circle(0.5)}, .position = {3, 0}});
    two.join<Joint>(spec);
    return refusal(two);
  };
  const SpringSoftness soft{.stiffness = 5};
  CHECK(refused_of({.b = {1}, .anchor_a = {0, 2}, .kind = DistanceJoint::Kind::rope, .softness = soft},
                   std::type_identity<DistanceJoint>()) ==
        "Box2DWorld: rope must be without softness, as Box2D 2.4.1 has no elastic ropes, got one");
  CHECK(
      refused_of({.b = {1}, .ratchet = 1}, std::type_identity<RevoluteJoint>()) ==
      "Box2DWorld: revolute joint must be without a ratchet, as Box2D 2.4.1 has no ratchets there, got one");
  CHECK(refused_of({.b = {1}, .spring = JointSpring{}}, std::type_identity<PrismaticJoint>()) ==
        "Box2DWorld: prismatic joint must be without a spring, as Box2D 2.4.1 has no springs there, got one");
  CHECK(refused_of({.b = {1}, .softness = soft}, std::type_identity<WeldJoint>()) ==
        "Box2DWorld: weld must be rigid in its place, as Box2D 2.4.1 only lets it bend, got soft");
  CHECK(
      refused_of({.a = {1}, .b = {2}}, std::type_identity<GearJoint>())
          .starts_with("Box2DWorld: gear must be between bodies that a revolute or a prismatic joint holds"));
}

TEST_CASE("Box2D refuses negative iteration counts, and questions about bodies that are not there") {
  CHECK(refusal(Scene(), {.velocity_iterations = -1}) ==
        "Box2DWorld: velocity_iterations must be >= 0, got -1");
  CHECK(refusal(Scene(), {.position_iterations = -1}) ==
        "Box2DWorld: position_iterations must be >= 0, got -1");
  CHECK_THROWS_AS(Box2DWorld(Scene()).is_awake(BodyId{1}), std::invalid_argument);
}

}  // namespace

}  // namespace cairn::reference_tests
