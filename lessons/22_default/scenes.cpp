// The scenes: a bridge with loads, a beam, a tower, a pile of stones between walls.
#include "lesson.hpp"

#include "lessons/kit/random.hpp"

namespace cairn::usual {

Kind beam(int pieces) {
  constexpr double piece = 0.5;
  Scene scene({.gravity = {0, -10}});
  BodyId before = scene.add({.type = BodyType::static_body, .shapes = {box(0.6, 3)}, .position = {-0.3, 0}});
  for (int i = 0; i < pieces; ++i) {
    const BodyId body =
        scene.add({.shapes = {box(piece, 0.4)}, .position = {piece * (i + 0.5), 0}, .mass = 1});
    scene.join<WeldJoint>({.a = before, .b = body, .anchor = {piece * i, 0}});
    before = body;
  }
  const double length = piece * pieces;
  return {"beam", scene, before, {{-0.6, -0.3 * length}, {length + 0.2, 0.06 * length}}};
}

Kind tower(int boxes) {
  Scene scene({.gravity = {0, -10}});
  scene.add_ground();
  BodyId top = {};
  for (int i = 0; i < boxes; ++i)
    top = scene.add(
        {.shapes = {box(1, 1)}, .position = {0, 0.5 + i}, .mass = 1, .material = {.friction = 0.6}});
  return {"tower", scene, top, {{-4, -0.5}, {4, boxes + 0.5}}};
}

Kind pile(int stones) {
  constexpr int columns = 6;
  Scene scene({.gravity = {0, -10}});
  scene.add_ground();
  for (const double side : {-1.0, 1.0})
    scene.add({.type = BodyType::static_body, .shapes = {box(0.4, 8)}, .position = {1.7 * side, 4}});
  Random random(1);
  for (int i = 0; i < stones; ++i) {
    const double x = -1.2 + 0.48 * (i % columns) + random.between(-0.05, 0.05);
    scene.add({.shapes = {box(random.between(0.25, 0.35), random.between(0.25, 0.35))},
               .position = {x, 0.3 + 0.5 * (i / columns)},
               .angle = random.between(-0.5, 0.5),
               .material = {.friction = 0.5}});
  }
  return {"pile", scene, {}, {{-2, -0.3}, {2, 3.5}}};
}

Kind bridge(int planks, double density) {
  Scene scene({.gravity = {0, -10}});
  FixedList<BodyId, 2> banks;
  const double end = planks / 2.0;
  for (const int side : {0, 1})
    banks[side] = scene.add({.type = BodyType::static_body,
                             .shapes = {box(3, 4)},
                             .position = {side == 0 ? -end - 1.5 : end + 1.5, -1.875}});
  BodyId before = banks[0];
  for (int i = 0; i <= planks; ++i) {
    const BodyId plank = i == planks ? banks[1]
                                     : scene.add({.shapes = {box(0.98, 0.25)},
                                                  .position = {-end + 0.5 + i, 0},
                                                  .density = 4,
                                                  .material = {.friction = 0.5}});
    scene.join<RevoluteJoint>({.a = before, .b = plank, .anchor = {-end + i, 0}});
    before = plank;
  }
  const auto add_load = [&scene, density](double x) {
    return scene.add({.shapes = {box(0.8, 0.8)},
                      .position = {x, 0.525},
                      .density = density,
                      .material = {.friction = 0.5}});
  };
  add_load(-0.4 * end);
  add_load(0.4 * end);
  const BodyId middle = add_load(0);
  return {"bridge", scene, middle, {{-end - 1, -1.6}, {end + 1, 1.4}}};
}

}  // namespace cairn::usual
