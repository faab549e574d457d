// Floor 9. Towers, chains, piles, bullets, and boxes far off.
#include <cairn/study/tuning/recommend_scenes.hpp>

#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/study/jitter.hpp>
#include <cairn/validation/case_scenes.hpp>

namespace cairn {

Scene tower_of_boxes(int boxes, double top) {
  List<double> masses(boxes, 1.0);
  masses.back() = top;
  return jittered(cases::box_column(masses, 0, 2.0 * boxes + 10), 1e-6, 1);
}

Scene chain_with_bob(int links, double bob, ChainStart start) {
  const double length = 0.5, thickness = 0.1, radius = 0.25;  // [m]
  const bool level = start == ChainStart::level;
  const Vec2<double> along = level ? Vec2<double>(1, 0) : Vec2<double>(0, -1);
  Scene scene;
  BodyId above = ground;
  for (int i = 0; i < links; ++i) {
    const Vec2<double> pin = i * length * along, middle = (i + 0.5) * length * along;
    const BodyId link = scene.add({.shapes = {level ? box(length, thickness) : box(thickness, length)},
                                   .position = middle,
                                   .mass = 1,
                                   .filter = {.collides_with = 0}});
    scene.join<RevoluteJoint>({.a = above, .b = link, .anchor = pin});
    above = link;
  }
  const Vec2<double> end = links * length * along, center = end + radius * along;
  const BodyId ball = scene.add(
      {.shapes = {circle(radius)}, .position = center, .mass = bob, .filter = {.collides_with = 0}});
  scene.join<RevoluteJoint>({.a = above, .b = ball, .anchor = end});
  return scene;
}

Scene pyramid_of_boxes(int rows) {
  Scene scene;
  scene.add_ground({.half_width = 50});
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < rows - row; ++i) {
      scene.add({.shapes = {box(1, 1)}, .position = {1.01 * (i - 0.5 * (rows - row - 1)), 0.5 + row}});
    }
  }
  return jittered(scene, 1e-6, 1);
}

Scene bin_of_bodies(int bodies) {
  Scene scene;
  scene.add_ground({.half_width = 50});
  for (const double x : {-5.0, 5.0})
    scene.add({.type = BodyType::static_body, .shapes = {box(1, 40)}, .position = {x, 20}});
  for (int i = 0; i < bodies; ++i) {
    const int row = i / 8, column = i % 8;
    const Vec2<double> place(-4 + 1.1 * column + 0.13 * (row % 3), 0.6 + 1.1 * row);
    const Shape<double> shape = i % 2 == 0 ? Shape<double>(box(0.9, 0.9)) : Shape<double>(circle(0.45));
    scene.add({.shapes = {shape}, .position = place});
  }
  return scene;
}

Scene shot_at_wall(double speed, const Shape<double>& shape, double restitution) {
  Scene scene({.gravity = {0, 0}});
  scene.add({.type = BodyType::static_body, .shapes = {box(0.1, 4)}});
  scene.add({.shapes = {shape},
             .position = {-3.3, 0.1},
             .velocity = {speed, 0},
             .material = {.restitution = restitution}});
  return scene;
}

Scene boxes_far_off(double x) {
  Scene scene;
  scene.add({.type = BodyType::static_body, .shapes = {box(20, 2)}, .position = {x, x - 1}});
  for (int i = 0; i < 3; ++i) scene.add({.shapes = {box(1, 1)}, .position = {x, x + 0.5 + i}});
  return scene;
}

}  // namespace cairn
