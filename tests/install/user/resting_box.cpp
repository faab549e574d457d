// A box that rests on the ground: the whole of a program that uses Cairn.
#include <iostream>

#include <cairn/cairn.hpp>

int main() {
  cairn::Scene scene;
  scene.add_ground({.material = {.friction = 0.6}});
  const cairn::BodyId box = scene.add({.shapes = {cairn::box(1, 1)}, .position = {0, 0.5}, .mass = 2.0});

  cairn::World world(scene);
  cairn::SequentialImpulse solver({.iterations = 20});
  for (int step = 0; step < 60; ++step) world.step(solver);

  const cairn::Snapshot now = cairn::snapshot(world);
  std::cout << "newtons: " << cairn::normal_impulse_between(now, cairn::ground, box) / now.dt << '\n';
}
