// What Box2D 3 measures itself by, as far as all engines can have it: no springs in the joints of the
// figures, no feet on them, and sharp corners. And scenes that mix what others have apart.
#include <cmath>

#include <cairn/constraints/revolute_joint.hpp>
#include "peer_scenes.hpp"

namespace cairn::bench {

namespace {

using Place = Vec2<double>;

/// A part of a figure that stands on the ground: an upright capsule.
struct Bone {
  int parent = 0;               // that it is pinned to; the hip has none
  double height = 0;            // [m] of the frame
  double low = 0, high = 0;     // [m] the ends of the capsule, from there
  double radius = 0;            // [m]
  double pin = 0;               // [m] the height of the joint
  double lower = 0, upper = 0;  // in parts of pi, from where they hang down
  double friction = 0;          // [N m] of the joint, at most
};

/// Hip, trunk and head, then twice thigh and shank, upper arm and forearm. Knees and elbows begin straight,
/// a little beyond their limits.
const List<Bone>& bones() {
  static const List<Bone> all = [] {
    List<Bone> figure = {{-1, 0.95, -0.02, 0.02, 0.095, 0, 0, 0, 0},
                         {0, 1.2, -0.135, 0.135, 0.09, 1, -0.25, 0, 0.025},
                         {1, 1.475, -0.038, 0.039, 0.075, 1.4, -0.3, 0.1, 0.0125}};
    for (int side = 0; side < 2; ++side) {
      figure.push_back({0, 0.775, -0.125, 0.125, 0.06, 0.9, -0.05, 0.4, 0.05});
      figure.push_back({figure.size() - 1, 0.475, -0.155, 0.125, 0.045, 0.625, -0.5, -0.02, 0.025});
      figure.push_back({1, 1.225, -0.125, 0.125, 0.035, 1.35, -0.1, 0.8, 0.025});
      figure.push_back({figure.size() - 1, 0.975, -0.125, 0.125, 0.03, 1.1, 0.05, 0.55, 0.005});
    }
    return figure;
  }();
  return all;
}

/// Its bones do not touch those of its kind, and so not each other.
void add_figure(Scene& scene, const Place& feet, int kind) {
  List<BodyId> added;
  for (const Bone& bone : bones()) {
    added.push_back(scene.add({.shapes = {capsule({0, bone.low}, {0, bone.high}, bone.radius)},
                               .position = feet + Place(0, bone.height),
                               .material = {.friction = 0.2},
                               .filter = {.category = 2u << kind, .collides_with = ~(2u << kind)}}));
    if (bone.parent < 0) continue;
    scene.join<RevoluteJoint>({.a = added[bone.parent],
                               .b = added.back(),
                               .anchor = feet + Place(0, bone.pin),
                               .lower = bone.lower * pi,
                               .upper = bone.upper * pi,
                               .motor = RevoluteJoint::Motor{.speed = 0, .max_torque = bone.friction}});
  }
}

/// Groups of five above a floor of 501 blocks, each group higher than the one before, so that one lands after
/// the other.
Scene rain(int groups) {
  const double width = 250;  // [m]
  Scene scene;
  BodySpec floor = {.type = BodyType::static_body};
  for (int i = 0; i <= 500; ++i) floor.shapes.push_back(moved(box(0.5, 0.5), {0.5 * i - width / 2, 0}));
  scene.add(floor);
  for (int group = 0; group < groups; ++group) {
    const Place feet(width * ((group + 0.5) / groups - 0.5), 1.0 + group);
    for (int kind = 0; kind < 5; ++kind) add_figure(scene, feet + Place(0.5 * kind, 0), kind);
  }
  return scene;
}

/// Boxes that touch, `size` [m] wide, their lower left corner at `corner`.
void add_wall(Scene& scene, int columns, int rows, double size, const Place& corner,
              const Vec2<double>& velocity) {
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      scene.add({.shapes = {box(size, size)},
                 .position = corner + size * Place(i + 0.5, j + 0.5),
                 .velocity = velocity});
    }
  }
}

Scene smash(int columns, int rows) {
  Scene scene({.gravity = {0, 0}});
  scene.add({.shapes = {box(8, 8)}, .position = {-6, 0}, .velocity = {40, 0}, .density = 8});
  add_wall(scene, columns, rows, 0.4, {0, -0.2 * rows}, {0, 0});
  return scene;
}

const Place spinner_center(0, 32);
const double spinner_radius = 40;  // [m]

Scene spinner(int count) {
  Scene scene;
  List<Place> circle_points;
  for (int i = 0; i < 360; ++i) {
    const double angle = -i * pi / 180;  // clockwise: a room
    circle_points.push_back(spinner_center + spinner_radius * Place(std::cos(angle), std::sin(angle)));
  }
  const BodyId room = scene.add({.type = BodyType::static_body,
                                 .shapes = {chain(circle_points, {.closed = true})},
                                 .material = {.friction = 0.1}});
  const BodyId bar =
      scene.add({.shapes = {box(1.2, 40.4)}, .position = {0, 12}, .material = {.friction = 0}});
  scene.join<RevoluteJoint>(
      {.a = room, .b = bar, .anchor = {0, 12}, .motor = RevoluteJoint::Motor{.speed = 5, .max_torque = 1e9}});
  const Shape<double> shapes[] = {capsule({-0.25, 0}, {0.25, 0}, 0.25), circle(0.35), box(0.7, 0.7)};
  for (int i = 0; i < count; ++i) {
    scene.add({.shapes = {shapes[i % 3]},
               .position = {0.5 * (i % 92) - 23, 2 + 0.5 * (i / 92)},
               .density = 0.25,
               .material = {.friction = 0.1, .restitution = 0.1}});
  }
  return scene;
}

const Place drum_center(0, 10);

/// Boxes in rows and columns, `size` [m] wide and so far apart.
void add_grid(Scene& scene, int count, double size, double apart) {
  for (int row = 0; row < count; ++row) {
    for (int k = 0; k < count; ++k) {
      scene.add({.shapes = {box(size, size)},
                 .position = drum_center + apart * Place(k - 0.5 * (count - 1), row - 0.5 * (count - 1))});
    }
  }
}

Scene tumbler(int count) {
  Scene scene;
  const BodyId drum = scene.add({.shapes = {moved(box(1, 20), {10, 0}), moved(box(1, 20), {-10, 0}),
                                            moved(box(20, 1), {0, 10}), moved(box(20, 1), {0, -10})},
                                 .position = drum_center,
                                 .density = 50});
  scene.join<RevoluteJoint>({.a = ground,
                             .b = drum,
                             .anchor = drum_center,
                             .motor = RevoluteJoint::Motor{.speed = 25 * pi / 180, .max_torque = 1e8}});
  add_grid(scene, count, 0.25, 0.4);
  return scene;
}

/// A ring's piece between two angles [rad] and two radii [m].
Polygon<double> sector(double from, double to, double inner, double outer) {
  const Place start(std::cos(from), std::sin(from)), end(std::cos(to), std::sin(to));
  return polygon({inner * start, outer * start, outer * end, inner * end});
}

Scene washer(int count) {
  const double part = pi / 18;  // [rad] of a piece, which is a little longer than that
  Scene scene;
  BodySpec ring = {.type = BodyType::kinematic, .position = drum_center, .angular_velocity = 25 * pi / 180};
  for (int i = 0; i < 36; ++i) {
    ring.shapes.push_back(sector((i - 0.1) * part, (i + 1.1) * part, 16, 18));
    if (i % 9 == 0) ring.shapes.push_back(sector(i * part, (i + 1) * part, 14, 16));
  }
  scene.add(ring);
  add_grid(scene, count, 0.2, 0.21);
  return scene;
}

Scene pyramid_and_pendulum() {
  Scene scene = pyramid(30);
  const BodyId bob = scene.add({.shapes = {box(1, 1)}, .position = {502, 20}});
  scene.join<RevoluteJoint>({.a = ground, .b = bob, .anchor = {500, 20}});
  return scene;
}

Scene pyramid_and_rebound() {
  Scene scene = pyramid(30);
  scene.add({.type = BodyType::static_body,
             .shapes = {box(4, 1)},
             .position = {500, -0.5},
             .material = {.restitution = 0.1}});
  scene.add({.shapes = {box(1, 1)}, .position = {500, 1.5}, .material = {.restitution = 0.1}});
  return scene;
}

Scene falling_block(int count) {
  Scene scene;
  scene.add_ground({.half_width = 200});
  add_wall(scene, count, count, 0.2, {-0.1 * count, 60}, {0, -20});
  return scene;
}

/// Whether it is farther from a place than so [m].
std::function<bool(const Place&)> farther(const Place& center, double distance) {
  return [center, distance](const Place& place) { return (place - center).norm() > distance; };
}

/// Whether it is lower than so [m].
std::function<bool(const Place&)> below(double height) {
  return [height](const Place& place) { return place.y() < height; };
}

const char* const turning =
    "a bar of 40 m turns once in 1.3 s among capsules, discs and boxes that begin in each other";

}  // namespace

List<PeerScene> benchmark_scenes() {
  return {
      {.name = "rain-200",
       .about = "200 figures of eleven capsules, whose joints have limits and friction, fall from 1 to 40 m",
       .make = [] { return rain(40); },
       .steps = 200,
       .outside = below(-0.25)},
      {.name = "smash-60x40",
       .about = "a box of 512 kg at 40 m/s hits boxes of 0.16 kg that float and touch, without gravity",
       .make = [] { return smash(60, 40); },
       .steps = 80},
      {.name = "spinner-1000",
       .about = turning,
       .make = [] { return spinner(1000); },
       .steps = 60,
       .outside = farther(spinner_center, spinner_radius)},
      {.name = "tumbler-45x45",
       .about = "a motor turns a square drum of 20 m once in 14.4 s, with boxes of 0.25 m in it",
       .make = [] { return tumbler(45); },
       .steps = 90,
       .outside = farther(drum_center, 10.5 * std::sqrt(2.0))},
      {.name = "washer-45x45",
       .about = "a kinematic ring of 32 m with four blades turns once in 14.4 s, with boxes of 0.2 m in it",
       .make = [] { return washer(45); },
       .steps = 120,
       .outside = farther(drum_center, 18)}};
}

List<PeerScene> mixed_scenes() {
  return {
      {.name = "pyramid-30-and-pendulum",
       .about = "the pyramid, and a box that swings from a pin 500 m away",
       .make = pyramid_and_pendulum,
       .stands = true,
       .loose = 1},
      {.name = "pyramid-30-and-rebound",
       .about = "the pyramid, and a box that falls through 1 m and rebounds with e = 0.1, 500 m away",
       .make = pyramid_and_rebound,
       .stands = true,
       .loose = 1},
      {.name = "block-45x45",
       .about = "boxes of 0.2 m that touch begin to fall together at 20 m/s, 60 m above the ground, and land "
                "in step 120",
       .make = [] { return falling_block(45); },
       .steps = 150,
       .outside = below(0)}};
}

}  // namespace cairn::bench
