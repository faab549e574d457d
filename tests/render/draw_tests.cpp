// A drawn world: bodies where the camera says, what is lit, marked or left out, and blow-ups.
#include "render/world_picture.hpp"

namespace {

using namespace cairn;
using namespace cairn::test;

/// A block that slides down a ramp, a disk on a rod, a pinned beam, and two boxes that overlap.
Snapshot sample_world() {
  Snapshot world = with_ground();
  SnapshotBody ramp;
  ramp.shapes.push_back(polygon({{-7, -2}, {-1, -2}, {-7, 1}}));
  world.bodies.push_back(ramp);
  const double angle = -std::atan(0.5);
  const Vec2<double> up(-std::sin(angle), std::cos(angle));
  const Vec2<double> foot(-4, -0.5);
  world.bodies.push_back(dynamic_body(box(1.6, 1), foot + 0.5 * up, angle));
  world.contacts.push_back({.a = {1},
                            .b = {2},
                            .position = foot,
                            .normal = up,
                            .normal_impulse = 0.17,
                            .friction_impulse = -0.08,
                            .friction = 0.6});
  world.bodies.push_back(dynamic_body(circle(0.5), {2, 0.5}, 0.7));
  world.joints.push_back({.name = "rod",
                          .traits = {.is_line = true},
                          .a = ground,
                          .b = {3},
                          .anchor_a = {1, 3},
                          .anchor_b = {2, 0.5}});
  world.bodies.push_back(dynamic_body(capsule({-1, 0}, {1, 0}, 0.2), {5, 2}, -0.3));
  world.joints.push_back({.name = "revolute",
                          .a = ground,
                          .b = {4},
                          .anchor_a = world.bodies[{4}].pose.world({-1, 0}),
                          .anchor_b = world.bodies[{4}].pose.world({-1, 0})});
  world.bodies.push_back(dynamic_body(box(1.5, 1), {5, -1.5}));
  world.bodies.push_back(dynamic_body(box(1, 1), {5.2, -0.65}));
  world.contacts.push_back(
      {.a = {5}, .b = {6}, .position = {5.2, -1.075}, .normal = {0, 1}, .separation = -0.15, .is_new = true});
  return world;
}

}  // namespace

TEST_CASE("a body is painted where the camera sees it, with its outline on its edge") {
  Snapshot world = with_ground({dynamic_body(box(2, 1), {3, 1})});
  const Theme theme = light_theme();
  const Image image = picture_of_world(world, {.numbers = false});
  CHECK(distance_at(image, {3, 1}, theme.body, 0, 0) <= 2);
  CHECK(distance_at(image, {2, 1}, theme.outline, 0, 0) < 80);  // half of the edge's pixel
  CHECK(distance_at(image, {2, 1}, theme.body, 4, 0) <= 2);
  CHECK(distance_at(image, {2, 1}, theme.background, -4, 0) <= 2);
  CHECK(distance_at(image, {3, 1.5}, theme.body, 0, 4) <= 2);
  CHECK(distance_at(image, {3, 1.5}, theme.background, 0, -4) <= 2);
}

TEST_CASE("a body that sleeps is pale, with a grey outline, and in its lit colour where it is lit") {
  Snapshot world = with_ground({dynamic_body(box(2, 1), {3, 1})});
  world.bodies[{1}].awake = false;
  const Theme theme = light_theme();
  const Image asleep = picture_of_world(world, {.numbers = false});
  CHECK(distance_at(asleep, {3, 1}, theme.sleeping, 0, 0) <= 2);
  CHECK(distance_at(asleep, {2, 1}, theme.inactive, 0, 0) < 80);  // half of the edge's pixel
  const Image lit = picture_of_world(world, {.numbers = false, .active_a = {1}});
  CHECK(distance_at(lit, {3, 1}, theme.active_a, 0, 0) <= 2);
}

TEST_CASE("the ground reaches from end to end of the viewport, and not beyond") {
  const Theme theme = light_theme();
  const Image image = picture_of_world(with_ground());
  for (const double x : {11.5, 200.5, 628.5}) {
    const double surface = world_camera.project({0, -2}).y();
    CHECK(distance_at(image, Point(x, surface), theme.outline) < 80);
    CHECK(distance_at(image, Point(x, surface - 4), theme.background) <= 2);
    CHECK(distance_at(image, Point(x, surface + 10), theme.background) > 30);  // fill or hatch
  }
  const double below = world_camera.project({0, -2.4}).y();
  CHECK(distance_at(image, Point(8, below), theme.background) <= 2);
  CHECK(distance_at(image, Point(632, below), theme.background) <= 2);
  // Hatch lines every 10 px of 620; the margins at both ends are no part of the ground either.
  CHECK(std::abs(strokes_in_row(image, below, theme.static_body, 25) - 62) <= 3);
}

TEST_CASE("the active pair is lit and dotted, all other bodies have one fill") {
  Snapshot world = with_ground();
  for (int i = 0; i < 4; ++i) world.bodies.push_back(dynamic_body(box(1.8, 1.8), {2.0 * i - 3, 0}));
  const Theme theme = light_theme();
  WorldPage page;
  draw_world(page, world_camera, world, {.active_a = {2}, .active_b = {3}});
  const Image image = page.canvas().read();
  const List<Color> fills = {theme.body, theme.active_a, theme.active_b, theme.body};
  for (int i = 0; i < 4; ++i) {
    CHECK(distance_at(image, world.bodies[{i + 1}].pose.position, fills[i], -20, -20) <= 2);
  }
  CHECK(is_written(page, "body a"));
  CHECK(is_written(page, "body b"));
  CHECK(lint(page) == List<std::string>{});
}

TEST_CASE("a body's number is scaled to the body, and left out where there is no room") {
  Snapshot world = with_ground();
  for (const double size : {3.0, 1.0, 0.6, 0.2}) {
    world.bodies.push_back(dynamic_body(box(size, size), {2.5 * world.bodies.size() - 6, 1}));
  }
  WorldPage page;
  draw_world(page, world_camera, world);
  CHECK(is_written(page, "1"));
  CHECK(is_written(page, "2"));
  CHECK_FALSE(is_written(page, "4"));  // 8 px
  double before = page.sizes().body_number;
  for (const TextBox& box : page.canvas().text_boxes()) {
    if (box.text.size() != 1) continue;
    CHECK(box.style.size >= 12);
    CHECK(box.style.size <= before);
    before = box.style.size;
  }
  WorldPage named;
  draw_world(named, world_camera, world, {.names = {"", "A", ""}});
  CHECK(is_written(named, "A"));
  CHECK_FALSE(is_written(named, "2"));
}

TEST_CASE("a body that blew up disturbs nothing else in the picture") {
  const double infinite = std::numeric_limits<double>::infinity();
  const List<Pose<double>> lost = {{{no_number, 0}, 0},
                                   {{0, infinite}, 0},
                                   {{1e30, -1e30}, 0},
                                   {{0, 0}, no_number},
                                   {{-1e300, 1e300}, 1e300}};
  Snapshot sane = sample_world();
  Snapshot broken = sane;
  for (const Pose<double>& pose : lost) {
    SnapshotBody body = dynamic_body(box(1, 1), {0, 0});
    sane.bodies.push_back(
        {.type = BodyType::dynamic, .pose = pose});  // without a shape there is nothing to draw
    body.pose = pose;
    body.velocity = {no_number, 1e308, infinite};
    broken.bodies.push_back(body);
    broken.joints.push_back(
        {.name = "rod", .a = ground, .b = {3}, .anchor_b = pose.position + Vec2<double>(infinite, 0)});
    broken.contacts.push_back({.a = {1},
                               .b = {99},
                               .position = {no_number, 1e30},
                               .normal = {no_number, 1},
                               .separation = -infinite,
                               .normal_impulse = infinite});
  }
  const auto draw_all = [](const Snapshot& world) {
    WorldPage page;
    const ArrowScale scale{.pixels_per_unit = 5, .longest = 80, .unit = "N"};
    const List<Snapshot> past(3, world);
    draw_ghosts(page, world_camera, past);
    draw_world(page, world_camera, world);
    draw_contact_forces(page, world_camera, scale, world);
    draw_joint_forces(page, world_camera, scale, world);
    draw_velocities(page, world_camera, scale, world);
    return page.canvas().read();
  };
  const ImageDifference difference = compare(draw_all(sane), draw_all(broken));
  CHECK(difference.differing == 0);
}

TEST_CASE("at most 7 ghosts are drawn, the first and the newest among them, the older the paler") {
  List<Snapshot> past;
  for (int i = 0; i < 25; ++i) {
    Snapshot world = with_ground({dynamic_body(circle(0.2), {0.5 * i - 6, 1})});
    past.push_back(world);
  }
  WorldPage page;
  draw_ghosts(page, world_camera, past);
  const Image image = page.canvas().read();
  const Color background = page.theme().background;
  CHECK(strokes_in_row(image, world_camera.project({0, 1}).y(), background, 20) == 2 * 7);  // two sides each
  const Vec2<double> left_edge(-0.2, 0);
  const int oldest = distance_at(image, past.front().bodies[{1}].pose.position + left_edge, background, 0, 0);
  const int newest = distance_at(image, past.back().bodies[{1}].pose.position + left_edge, background, 0, 0);
  CHECK(oldest > 20);
  CHECK(newest > 1.5 * oldest);
  CHECK(distance_at(image, past.back().bodies[{1}].pose.position, background, 0, 0) <= 2);  // never filled
}

TEST_CASE("a new contact is larger than an old one, and the active one is lit") {
  Snapshot world = with_ground();
  world.contacts.push_back({.b = {0}, .position = {-2, 1}, .normal = {0, 1}});
  world.contacts.push_back({.b = {0}, .position = {2, 1}, .normal = {0, 1}, .is_new = true});
  const Theme theme = light_theme();
  WorldPage page;
  draw_world(page, world_camera, world, {.active_contact = 1});
  const Image image = page.canvas().read();
  CHECK(distance_at(image, {-2, 1}, theme.inactive, 0, 0) <= 2);
  CHECK(distance_at(image, {2, 1}, theme.normal, 0, 0) <= 2);
  const double between = 0.5 * (page.sizes().contact + page.sizes().new_contact) + 0.8;
  CHECK(distance_at(image, {-2, 1}, theme.background, between, 0) <
        distance_at(image, {2, 1}, theme.background, between, 0));
  CHECK(distance_at(picture_of_world(world, {.contacts = false}), {-2, 1}, theme.background, 0, 0) <= 2);
}

TEST_CASE("an overlap of more than 2 px is marked and measured in mm") {
  for (const double depth : {0.02, 0.2}) {  // 0.8 px and 8 px
    Snapshot world = with_ground({dynamic_body(box(2, 2), {0, -1 - depth})});
    for (const double x : {-1.0, 1.0}) {
      world.contacts.push_back(
          {.a = ground, .b = {1}, .position = {x, -2 - depth / 2}, .normal = {0, 1}, .separation = -depth});
    }
    WorldPage page;
    draw_world(page, world_camera, world);
    const int yellow = count_of_color(page.canvas().read(), page.theme().penetration);
    const double area = 80 * depth * 40;  // [px^2], of which the hatch leaves about half
    CHECK(yellow <= area);
    CHECK((yellow > 0.2 * area) == (depth > 0.1));
    CHECK(is_written(page, "200 mm") == (depth > 0.1));
  }
}

TEST_CASE("a rod is a double line, a pin a ring") {
  Snapshot world = with_ground();
  world.joints.push_back({.traits = {.is_line = true}, .anchor_a = {-3, -1}, .anchor_b = {-3, 2}});
  world.joints.push_back({.anchor_a = {3, 1}, .anchor_b = {3, 1}});
  const Image image = picture_of_world(world);
  const Theme theme = light_theme();
  CHECK(strokes_in_row(image, world_camera.project({0, 0.5}).y(), theme.background, 90) == 2);
  CHECK(strokes_in_row(image, world_camera.project({0, 1}).y(), theme.background, 90) == 2 + 2);
  CHECK(distance_at(image, {3, 1}, theme.background, 0, 0) <= 2);
}

TEST_CASE("the bounds are those of the dynamic bodies that can be seen") {
  CHECK(bounds_of({}).lower == Vec2<double>(0, 0));
  CHECK(bounds_of({}).upper == Vec2<double>(0, 0));
  List<Snapshot> past(2, with_ground());
  past[0].bodies.push_back(dynamic_body(box(2, 1), {3, 4}));
  past[0].bodies.push_back(dynamic_body(box(2, 1), {no_number, 4}));
  past[1].bodies.push_back(dynamic_body(circle(0.5), {-2, 1}));
  past[1].bodies.push_back(dynamic_body(circle(0.5), {1e30, 1}));
  const Aabb<double> bounds = bounds_of(past);
  CHECK((bounds.lower - Vec2<double>(-2.5, 0.5)).norm() < 1e-12);
  CHECK((bounds.upper - Vec2<double>(4, 4.5)).norm() < 1e-12);
}

TEST_CASE("a trail is a curve that is interrupted where the point was lost") {
  const List<Vec2<double>> path = {{-2, 0}, {-1, 0}, {no_number, 0}, {1, 0}, {2, 0}, {1e300, 0}};
  WorldPage page;
  draw_trail(page, world_camera, path, page.theme().pgs);
  const Image image = page.canvas().read();
  CHECK(distance_at(image, {-1.5, 0}, page.theme().pgs.color, 0, 0) <= 30);
  CHECK(distance_at(image, {1.5, 0}, page.theme().pgs.color, 0, 0) <= 30);
  CHECK(distance_at(image, {0, 0}, page.theme().background, 0, 0) <= 2);
  REQUIRE(page.curves().size() >= 2);
  CHECK(page.curves()[0].size() == 2);
}

TEST_CASE("a world looks as it did") {
  for (const auto& [name, theme] :
       {std::pair{"world_light", light_theme()}, std::pair{"world_dark", dark_theme()}}) {
    WorldPage page(theme);
    const Snapshot world = sample_world();
    draw_world(page, world_camera, world, {.active_a = {5}, .active_b = {6}, .active_contact = 1});
    draw_contact_forces(page, world_camera, {.pixels_per_unit = 8, .longest = 100, .unit = "N"}, world);
    CHECK(lint(page) == List<std::string>{});
    test::check_golden(name, page.canvas().read());
  }
}
