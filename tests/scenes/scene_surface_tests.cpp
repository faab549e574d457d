// Surfaces and outlines from scene files.
#include <doctest/doctest.h>

#include <cairn/math/list.hpp>
#include <cairn/scenes/scene_file.hpp>

using namespace cairn;

namespace {

Scene scene_of(const std::string& text) { return read_scene_text(text, "my.toml").make(); }

}  // namespace

TEST_CASE("a scene file gives surfaces two coefficients, rolling resistance and rules of mixing") {
  const Scene scene = scene_of(R"(
friction_mixing = "minimum"
restitution_mixing = "product"
impacts = "sequence"
[ground]
static_friction = 0.9
rolling_resistance = 0.01
[[body]]
circle = 1
friction = 0.3
static_friction = 0.5
rolling_resistance = 0.02
)");
  CHECK(scene.settings().mixing.friction == MixingRule::minimum);
  CHECK(scene.settings().mixing.restitution == MixingRule::product);
  CHECK(scene.settings().impacts == Impacts::sequence);
  CHECK(scene.bodies()[ground].spec.material.static_friction == 0.9);
  CHECK(scene.bodies()[ground].spec.material.rolling_resistance == 0.01);
  const Material& material = scene.bodies()[{1}].spec.material;
  CHECK(material.friction == 0.3);
  CHECK(material.static_friction == 0.5);
  CHECK(material.rolling_resistance == 0.02);
}

TEST_CASE("a scene file says what two bodies, or rows of them, have where they touch") {
  const Scene scene = scene_of(R"(
[[contact]]
a = "ice"
b = "block.*"
friction = 0.02
[[contact]]
a = "ground"
b = "ice"
static_friction = 0.8
restitution = 0.1
[[row]]
name = "block"
n = 3
box = [1, 1]
first = [0, 0]
step = [2, 0]
[[body]]
name = "ice"
box = [10, 1]
position = [0, -3]
)");
  const SharedList<PairMaterial>& pairs = scene.settings().mixing.pairs;
  REQUIRE(pairs.size() == 2);
  CHECK(pairs[0].a == List<BodyId>{{4}});
  CHECK(pairs[0].b == List<BodyId>{{1}, {2}, {3}});
  CHECK(pairs[0].friction == 0.02);
  CHECK_FALSE(pairs[0].static_friction);
  CHECK(pairs[1].a == List<BodyId>{ground});
  CHECK(pairs[1].static_friction == 0.8);
  CHECK(pairs[1].restitution == 0.1);
}

TEST_CASE("a polygon of a scene file may be of any outline, also as one of several shapes, moved") {
  const Scene scene = scene_of(R"(
[[body]]
polygon = [[0, 0], [3, 0], [3, 1], [1, 1], [1, 4], [0, 4]]
[[body]]
shapes = [
  { polygon = [[0, 0], [3, 0], [3, 1], [1, 1], [1, 4], [0, 4]], offset = [5, 0] },
  { circle = 0.5 },
]
)");
  CHECK(scene.bodies()[{1}].spec.shapes.size() == 2);
  CHECK(scene.bodies()[{1}].mass == doctest::Approx(6));
  CHECK(scene.bodies()[{1}].pose.position.x() == doctest::Approx(1));
  CHECK(scene.bodies()[{2}].spec.shapes.size() == 3);
  CHECK(scene.bodies()[{2}].pose.position.x() > 4);
}
