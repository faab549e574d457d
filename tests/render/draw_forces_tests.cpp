// Forces and velocities of a drawn world: direction, length, labels.
#include "render/world_picture.hpp"

using namespace cairn;
using namespace cairn::test;

TEST_CASE(
    "forces act on body b: the normal force along the normal, friction along the normal turned by -90 "
    "degrees") {
  Snapshot world = with_ground({dynamic_body(circle(0.3), {0, 3})});
  world.contacts.push_back({.a = ground,
                            .b = {1},
                            .position = {0, 0},
                            .normal = {0, 1},
                            .normal_impulse = 0.2,
                            .friction_impulse = 0.1});
  const Theme theme = dark_theme();
  WorldPage page(theme);
  draw_contact_forces(page, world_camera, {.pixels_per_unit = 8, .longest = 200, .unit = "N"}, world);
  const Image image = page.canvas().read();
  // 0.2 N s / 0.02 s = 10 N: 80 px upwards; 5 N: 40 px to the right.
  CHECK(distance_at(image, {0, 0}, theme.normal, 0, -40) <= 30);
  CHECK(distance_at(image, {0, 0}, theme.background, 0, -84) <= 2);
  CHECK(distance_at(image, {0, 0}, theme.background, 0, 10) <= 2);
  CHECK(distance_at(image, {0, 0}, theme.friction, 20, 0) <= 30);
  CHECK(distance_at(image, {0, 0}, theme.background, -10, 0) <= 2);
  CHECK(is_written(page, "10.00"));  // 360 px of height: numbers only
  CHECK(is_written(page, "5.00"));
}

TEST_CASE("on a large page a force is labelled with its symbol and unit, among many not at all") {
  for (const int count : {1, 13}) {
    Page page(1280, 720, light_theme());
    page.begin({.title = "World"});
    Snapshot world = with_ground({dynamic_body(box(1, 1), {0, 5})});
    for (int i = 0; i < count; ++i) {
      world.contacts.push_back(
          {.b = {1}, .position = {i - 6.0, 0}, .normal = {0, 1}, .normal_impulse = 0.1732});
    }
    Camera camera = world_camera;
    camera.viewport = page.area();
    draw_contact_forces(page, camera, {.pixels_per_unit = 10, .longest = 200, .unit = "N"}, world);
    CHECK(is_written(page, "λ_{n} = 8.66 N") == (count == 1));
    CHECK(lint(page) == List<std::string>{});
  }
}

TEST_CASE("a force passes behind the number of a body") {
  Snapshot world = with_ground({dynamic_body(circle(1), {0, -1})});
  WorldPage page;
  draw_world(page, world_camera, world);
  REQUIRE(page.canvas().text_boxes().size() > 1);
  const TextBox number = page.canvas().text_boxes().back();
  REQUIRE(number.text == "1");
  world.contacts.push_back({.b = {1}, .position = {0, -2}, .normal = {0, 1}, .normal_impulse = 0.2});
  draw_contact_forces(page, world_camera, {.pixels_per_unit = 10, .longest = 200, .unit = "N"}, world);
  const Image image = page.canvas().read();
  for (double y = number.rect.y + 2; y < number.rect.y + number.rect.height - 2; ++y) {
    for (double x = number.rect.x + 1; x < number.rect.x + number.rect.width - 1; ++x) {
      REQUIRE(distance_at(image, Point(x, y), page.theme().normal) > 40);
    }
  }
  CHECK(distance_at(image, {0, -1.7}, page.theme().normal, 0, 0) <= 30);
}

TEST_CASE("a velocity is drawn for every dynamic body, and only for those") {
  Snapshot world = with_ground();
  world.bodies[ground].velocity = {5, 0, 0};
  world.bodies.push_back(dynamic_body(box(0.2, 0.2), {0, 0}));
  world.bodies[{1}].velocity = {2, 0, 0};
  WorldPage page;
  draw_velocities(page, world_camera, {.pixels_per_unit = 30, .longest = 200, .unit = "m/s"}, world);
  const Image image = page.canvas().read();
  CHECK(distance_at(image, {0, 0}, page.theme().velocity, 30, 0) <= 30);
  CHECK(distance_at(image, {0, 0}, page.theme().background, 64, 0) <= 2);
  CHECK(is_written(page, "2.00"));
  CHECK_FALSE(is_written(page, "5.00"));
}

TEST_CASE("a torque from outside is a bow on the side to which it turns, and half as far for half of it") {
  Snapshot world = with_ground({dynamic_body(circle(0.1), {-2, 0}), dynamic_body(circle(0.1), {2, 0})});
  world.forces = {{.body = {1}, .point = {-2, 0}, .torque = 4}, {.body = {2}, .point = {2, 0}, .torque = -2}};
  const Image image = picture_of_world(world);
  const Theme theme = light_theme();
  const auto distance = [&](double x, double degrees) {  // of what is 20 px from the body's middle
    const double angle = degrees * pi / 180;
    return distance_at(image, {x, 0}, theme.external, 20 * std::cos(angle), -20 * std::sin(angle));
  };
  // From below: three quarters of a turn counterclockwise, and three eighths of one clockwise.
  for (const double passed : {-60, 0, 90, 150}) CHECK(distance(-2, passed) <= 2);
  for (const double passed : {-120, 180, 150}) CHECK(distance(2, passed) <= 2);
  CHECK(distance(-2, -135) > 30);
  for (const double open : {-45, 0, 90}) CHECK(distance(2, open) > 30);
}

TEST_CASE("the way of a body that is led is dashed, with a ring at each of its points") {
  Snapshot world = with_ground();
  world.paths.push_back({.body = {1}, .points = {{-3, 0}, {3, 0}, {3, 2}}});
  const Image image = picture_of_world(world);
  const Theme theme = light_theme();
  for (const Vec2<double>& point : world.paths[0].points) {
    CHECK(distance_at(image, point, theme.background, 0, 0) <= 2);
    CHECK(distance_at(image, point, theme.velocity, -3.5 / std::sqrt(2), -3.5 / std::sqrt(2)) < 120);
  }
  const double y = world_camera.project(Vec2<double>(0, 0)).y();
  // 240 px in dashes of 11 px, of which the first and the last may be under rings.
  CHECK(std::abs(strokes_in_row(image, y, theme.background, 20) - 240 / 11) <= 3);
  world.paths[0].points[1].x() = no_number;
  CHECK(picture_of_world(world).pixels == picture_of_world(with_ground()).pixels);
}
