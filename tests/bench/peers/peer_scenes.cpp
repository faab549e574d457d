// Pyramids, stacks, chains, grids and heaps. Boxes of pyramids and stacks touch from the start,
// and side by side too.
#include "peer_scenes.hpp"

#include <algorithm>
#include <cmath>

#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/samples/samples.hpp>
#include <cairn/validation/case_scenes.hpp>

namespace cairn::bench {

namespace {

/// With ten boxes at their feet, on ledges one above the other, as many on each as there are ledges.
Scene many_pyramids(int ledges) {
  const int base = 10;
  const double apart = base + 1;  // [m]
  Scene scene;
  BodySpec shelves = {.type = BodyType::static_body};
  for (int i = 0; i < ledges; ++i) {
    shelves.shapes.push_back(segment({-apart / 2, apart * i}, {apart * (ledges - 0.5), apart * i}));
  }
  scene.add(shelves);
  for (int i = 0; i < ledges; ++i) {
    for (int k = 0; k < ledges; ++k)
      samples::add_pyramid(scene, {.base = base, .foot = {apart * k, apart * i}});
  }
  return scene;
}

/// A body of a chain or a grid touches none of the others.
BodySpec link(const Shape<double>& shape, const Vec2<double>& place) {
  return {.shapes = {shape}, .position = place, .filter = {.category = 2, .collides_with = ~2u}};
}

/// Rods of 0.5 m in a level row, the first pinned to the ground: the row falls and swings.
Scene level_chain(int links) {
  Scene scene;
  samples::add_chain(scene, links, link(box(0.5, 0.1), {0.25, 0}), {0.5, 0});
  return scene;
}

/// Discs in rows and columns 1 m apart, each pinned to its neighbours; it hangs from seven discs in the
/// middle of the top row.
Scene joint_grid(int size) {
  Scene scene;
  List<BodyId> above;
  for (int row = 0; row < size; ++row) {
    List<BodyId> discs;
    for (int k = 0; k < size; ++k) {
      const Vec2<double> place(k, -row);
      BodySpec spec = link(circle(0.4), place);
      const bool fixed = row == 0 && std::abs(k - size / 2) <= 3;
      if (fixed) spec.type = BodyType::static_body;
      discs.push_back(scene.add(spec));
      const bool left_is_fixed = row == 0 && std::abs(k - 1 - size / 2) <= 3;
      if (k > 0 && !(fixed && left_is_fixed)) {
        scene.join<RevoluteJoint>({.a = discs[k - 1], .b = discs[k], .anchor = place - Vec2<double>(0.5, 0)});
      }
      if (row > 0) {
        scene.join<RevoluteJoint>({.a = above[k], .b = discs[k], .anchor = place + Vec2<double>(0, 0.5)});
      }
    }
    above = discs;
  }
  return scene;
}

/// Circles and boxes of 0.5 to 0.9 m in turn, in columns above the ground, at random places and angles.
void pour(Scene& scene, int count, int columns) {
  const std::function<double(double, double)> uniform = cases::uniform_numbers(1);
  for (int i = 0; i < count; ++i) {
    const double size = uniform(0.5, 0.9);
    const double x = 1.2 * (i % columns - 0.5 * (columns - 1)) + uniform(-0.1, 0.1);
    const double y = 1 + 1.2 * (i / columns);
    Shape<double> shape = box(size, size);
    if (i % 2 == 0) shape = circle(size / 2);
    scene.add({.shapes = {shape}, .position = {x, y}, .angle = uniform(-0.5, 0.5)});
  }
}

Scene heap(int count) {
  Scene scene;
  scene.add_ground({.half_width = 200});
  pour(scene, count, static_cast<int>(std::lround(1.25 * std::sqrt(count))));
  return scene;
}

/// Between two walls.
Scene bin(int count) {
  const int columns = 40;
  Scene scene;
  scene.add_ground();
  for (const double side : {-1.0, 1.0}) {
    scene.add({.type = BodyType::static_body,
               .shapes = {box(2, 100)},
               .position = {side * (0.6 * columns + 1), 50}});
  }
  pour(scene, count, columns);
  return scene;
}

const char* const pile = "boxes of 1 m that touch, in rows of one fewer from row to row";
const char* const tower = "boxes of 1 m one on the other";
const char* const net = "discs 1 m apart, pinned to their neighbours, hang from the middle of the top row";
const char* const fallen = "discs and boxes of 0.5 to 0.9 m fall and come to rest";

List<PeerScene> standing_scenes() {
  return {
      {.name = "pyramid-10", .about = pile, .make = [] { return pyramid(10); }, .stands = true},
      {.name = "pyramid-30",
       .about = pile,
       .make = [] { return pyramid(30); },
       .stands = true,
       .target = Target{.error = 0.010, .sinking = 0.12}},
      {.name = "pyramid-100",
       .about = pile,
       .make = [] { return pyramid(100); },
       .stands = true,
       .quick = false,
       .target = Target{.error = 0.050, .sinking = 1}},
      {.name = "pyramids-20x20",
       .about = "400 pyramids of ten rows on 20 ledges",
       .make = [] { return many_pyramids(20); },
       .stands = true,
       .steps = 20},
      {.name = "stack-10", .about = tower, .make = [] { return samples::stack(10); }, .stands = true},
      {.name = "stack-100",
       .about = tower,
       .make = [] { return samples::stack(100); },
       .stands = true,
       .target = Target{.error = 0.050, .sinking = 1}},
  };
}

List<PeerScene> moving_scenes() {
  return {
      {.name = "chain-200",
       .about = "200 rods of 0.5 m in a level row, pinned at one end, fall and swing",
       .make = [] { return level_chain(200); }},
      {.name = "grid-50x50",
       .about = net,
       .make = [] { return joint_grid(50); },
       .target = Target{.error = 0.050}},
      {.name = "grid-100x100", .about = net, .make = [] { return joint_grid(100); }, .steps = 60},
      {.name = "heap-1000", .about = fallen, .make = [] { return heap(1000); }},
      {.name = "heap-5000", .about = fallen, .make = [] { return heap(5000); }, .quick = false},
      {.name = "bin-2000",
       .about = "discs and boxes fall between two walls",
       .make = [] { return bin(2000); },
       .quick = false},
  };
}

}  // namespace

Scene pyramid(int base) {
  Scene scene;
  scene.add_ground({.half_width = base + 10.0});
  samples::add_pyramid(scene, {.base = base});
  return scene;
}

const List<PeerScene>& peer_scenes() {
  static const List<PeerScene> scenes = [] {
    List<PeerScene> all;
    for (const List<PeerScene>& some :
         {standing_scenes(), moving_scenes(), benchmark_scenes(), mixed_scenes()}) {
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }();
  return scenes;
}

}  // namespace cairn::bench
