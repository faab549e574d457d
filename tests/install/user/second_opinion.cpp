// The same box in Box2D.
#include <iostream>

#include <cairn/measure/violation.hpp>
#include <cairn/reference/box2d_world.hpp>

int main() {
  cairn::Scene scene;
  scene.add_ground({.material = {.friction = 0.6}});
  const cairn::BodyId box = scene.add({.shapes = {cairn::box(1, 1)}, .position = {0, 0.5}, .mass = 2.0});

  cairn::Box2DWorld world(scene);
  for (int step = 0; step < 60; ++step) world.step();

  const cairn::Snapshot now = world.snapshot();
  std::cout << "newtons: " << cairn::normal_impulse_between(now, cairn::ground, box) / now.dt << '\n';
}
