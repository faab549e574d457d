// Worlds at the extremes: exploded, nowhere, far away, tiny, huge, and crowded.
#include "render/world_picture.hpp"

namespace {

using namespace cairn;
using namespace cairn::test;

const Rect extreme_view = world_camera.viewport;
const Point extreme_middle(extreme_view.x + extreme_view.width / 2, extreme_view.y + extreme_view.height / 2);

int texts_with(const Page& page, const std::string& part) {
  int count = 0;
  for (const TextBox& box : page.canvas().text_boxes()) count += box.text.find(part) != std::string::npos;
  return count;
}

/// Pixels of a colour within a rectangle.
int count_within(const Image& image, const Rect& rect, const Color& color) {
  int count = 0;
  for (int y = static_cast<int>(rect.y); y < rect.y + rect.height; ++y) {
    for (int x = static_cast<int>(rect.x); x < rect.x + rect.width; ++x)
      count += distance_at(image, Point(x, y), color) < 24 ? 1 : 0;
  }
  return count;
}

/// A box in the middle, and others that have flown off in all directions.
Snapshot exploded(int flown, double distance) {
  Snapshot world = with_ground({dynamic_body(box(1, 1), {0, 0})});
  for (int i = 0; i < flown; ++i) {
    const double angle = 2 * pi * i / flown;
    world.bodies.push_back(
        dynamic_body(box(1, 1), distance * Vec2<double>(std::cos(angle), std::sin(angle))));
  }
  return world;
}

/// The same world, and everything in it so much farther to the right.
Snapshot shifted(Snapshot world, double x) {
  for (SnapshotBody& body : world.bodies) body.pose.position.x() += x;
  for (SnapshotContact& contact : world.contacts) contact.position.x() += x;
  return world;
}

}  // namespace

TEST_CASE(
    "bodies that have flown off are announced at the border with name and distance, the others counted") {
  for (const Theme& theme : {light_theme(), dark_theme()}) {
    for (const double distance : {20.0, 3.2e4, 1e30, 1e300}) {
      WorldPage page(theme);
      const Snapshot world = exploded(16, distance);
      draw_world(page, world_camera, world);
      draw_unseen(page, world_camera, world);
      CHECK(texts_with(page, " m away") == 4);
      CHECK(is_written(page, "body 2, " + significant(distance, 2) + " m away"));
      CHECK(is_written(page, "and 12 more outside of the picture"));
      CHECK(lint(page) == List<std::string>{});
      // Body 2 is to the right: there is an arrow of about 13 px by 10 px, half of which is filled.
      const Rect at_right{extreme_view.x + extreme_view.width - 17, extreme_middle.y() - 6, 17, 12};
      const int ink = count_within(page.canvas().read(), at_right, theme.text);
      CHECK(ink > 40);
      CHECK(ink < 90);
    }
  }
}

TEST_CASE("a body with a name is announced by it, whatever is in the name") {
  Snapshot world = with_ground({dynamic_body(box(1, 1), {500, 0})});
  WorldPage page;
  draw_unseen(page, world_camera, world, {.numbers = false, .names = {"ground", "left_ball"}});
  CHECK(is_written(page, "left\\_ball, 500 m away"));
}

TEST_CASE("of a world that is seen as a whole nothing is said") {
  Snapshot world = with_ground();
  world.bodies.push_back(dynamic_body(box(1, 1), {0, 0}));
  world.bodies.push_back(dynamic_body(circle(0.5), {7.9, 0}));  // half of it
  WorldPage page;
  draw_world(page, world_camera, world);
  const Image before = page.canvas().read();
  draw_unseen(page, world_camera, world);
  CHECK(compare(before, page.canvas().read()).differing == 0);
}

TEST_CASE("bodies without a finite pose are not drawn, and named in a note") {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const Pose<double>& pose :
       {Pose<double>{{no_number, 0}, 0}, Pose<double>{{0, -infinite}, 0}, Pose<double>{{0, 0}, no_number}}) {
    Snapshot world = with_ground({dynamic_body(box(1, 1), {0, 0})});
    WorldPage sane;
    draw_world(sane, world_camera, world);
    const Image image = sane.canvas().read();
    world.bodies.push_back(dynamic_body(box(1, 1), {0, 0}));
    world.bodies[{2}].pose = pose;
    WorldPage page;
    draw_world(page, world_camera, world);
    CHECK(compare(image, page.canvas().read()).differing == 0);
    draw_unseen(page, world_camera, world);
    CHECK(is_written(page, "body 2 is nowhere: not finite"));
    world.bodies.push_back(world.bodies[{2}]);
    world.bodies.push_back(world.bodies[{2}]);
    draw_unseen(page, world_camera, world);
    CHECK(is_written(page, "body 2 and 2 more are nowhere: not finite"));
    CHECK(lint(page) == List<std::string>{});
  }
}

TEST_CASE("a body smaller than a pixel gets a ring and its name; many are counted instead") {
  Snapshot world = with_ground({dynamic_body(box(1e-4, 1e-4), {-2, 1})});
  WorldPage page;
  draw_world(page, world_camera, world);
  draw_unseen(page, world_camera, world);
  CHECK(is_written(page, "body 1"));
  CHECK(lint(page) == List<std::string>{});
  const Image image = page.canvas().read();
  const Point at = world_camera.project({-2, 1});
  // A ring of 9 px and 1.5 px, and a dot of 1.5 px: pixels touched are at least their area, 85 + 7 px^2, and
  // at most the area grown by half a pixel's diagonal on all sides.
  int touched = 0;
  for (int x = -12; x < 13; ++x) {
    for (int y = -12; y < 13; ++y)
      touched += distance_at(image, at + Point(x, y), page.theme().background) > 2 ? 1 : 0;
  }
  CHECK(touched >= 92);
  CHECK(touched <= 2 * pi * 9 * (1.5 + std::sqrt(2)) + pi * std::pow(1.5 + std::sqrt(0.5), 2));
  CHECK(distance_at(image, at + Point(5, 0), page.theme().background) <= 2);
  for (int i = 0; i < 6; ++i) world.bodies.push_back(dynamic_body(circle(1e-3), {0.5 * i, 0}));
  WorldPage crowd;
  draw_unseen(crowd, world_camera, world);
  CHECK(is_written(crowd, "7 bodies smaller than 2 pixels"));
  CHECK(texts_with(crowd, "body") == 0);
}

TEST_CASE("on a small page with little room everything unseen is still told without overlaps") {
  for (const Rect& view : {Rect{8, 30, 148, 60}, Rect{8, 30, 90, 120}, Rect{8, 30, 300, 130}}) {
    Page page(320, 180, light_theme());
    page.begin({.title = "World"});
    const Camera camera{.viewport = view, .center = {0, 0}, .scale = 10};
    Snapshot world = exploded(40, 1e6);
    world.bodies.push_back(dynamic_body(box(1e-4, 1e-4), {1, 1}));
    world.bodies.push_back(dynamic_body(box(1, 1), {no_number, 1}));
    draw_world(page, camera, world);
    draw_unseen(page, camera, world);
    CHECK(lint(page) == List<std::string>{});
    CHECK(page.canvas().text_boxes().size() > 2);
  }
}

TEST_CASE("a thousand contacts leave most of a body to be seen") {
  Snapshot world = with_ground({dynamic_body(box(8, 6), {0, 0})});
  const Theme theme = light_theme();
  const int bare = count_of_color(picture_of_world(world, {.numbers = false}), theme.body);
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 30; ++j) {
      world.contacts.push_back({.b = {1}, .position = {0.2 * i - 3.9, 0.2 * j - 2.9}, .normal = {0, 1}});
    }
  }
  const int left = count_of_color(picture_of_world(world, {.numbers = false}), theme.body);
  // Dots in squares four times as wide as their radius cover pi / 16 of it; pale edges add half as much.
  CHECK(left > (1 - 1.5 * pi / 16) * bare);
  CHECK(left < 0.95 * bare);  // and are there
}

TEST_CASE("contacts of boxes smaller than their markers are dots, and the boxes are seen between them") {
  Snapshot world = with_ground();
  for (int i = 0; i < 40; ++i) {  // 10 px each, at 40 px a metre; a marker is 10 px wide
    world.bodies.push_back(dynamic_body(box(0.25, 0.25), {0, -1.875 + 0.25 * i}));
    for (const double x : {-0.125, 0.125})
      world.contacts.push_back({.a = {i}, .b = {i + 1}, .position = {x, -2 + 0.25 * i}, .normal = {0, 1}});
  }
  const Theme theme = light_theme();
  const int bare = count_of_color(picture_of_world(world, {.numbers = false, .contacts = false}), theme.body);
  const int left = count_of_color(picture_of_world(world, {.numbers = false}), theme.body);
  CHECK(left > 0.5 * bare);
  CHECK(left != bare);  // the dots are there; the rim of one upon an outline may look like a body
}

TEST_CASE("arrows on a stack of forty boxes go without numbers, on few they have readable ones") {
  for (const int boxes : {4, 40}) {
    for (const double load : {1.0, 1e9}) {
      Snapshot world = with_ground();
      for (int i = 0; i < boxes; ++i) {
        world.bodies.push_back(dynamic_body(box(1, 0.15), {0, -1.9 + 0.16 * i}));
        world.contacts.push_back({.a = {i},
                                  .b = {i + 1},
                                  .position = {0.4, -2 + 0.16 * i},
                                  .normal = {0, 1},
                                  .normal_impulse = load * (boxes - i) / boxes * world.dt});
      }
      WorldPage page;
      draw_world(page, world_camera, world);
      draw_contact_forces(page, world_camera, {.pixels_per_unit = 60 / load, .longest = 100, .unit = "N"},
                          world);
      CHECK(lint(page) == List<std::string>{});
      CHECK((texts_with(page, "1×10^{9}") > 0) == (boxes == 4 && load > 1));
      CHECK((texts_with(page, "1.00") > 0) == (boxes == 4 && load == 1));
    }
  }
}

TEST_CASE("ten thousand kilometres from the origin the picture is the same to the last pixel") {
  Snapshot world = with_ground();
  world.bodies.push_back(dynamic_body(box(1, 0.75), {-2, 0.25}));
  world.bodies.push_back(
      dynamic_body(circle(0.5), {1.0 / 128, 0.5}));  // a third of a pixel beside the middle
  world.contacts.push_back({.a = ground, .b = {1}, .position = {-2, -0.125}, .normal = {0, 1}});
  // A power of two, so that no coordinate is rounded; floats are 1 m apart there.
  const double far = 8388608;
  Camera camera = world_camera;
  camera.center.x() = far;
  WorldPage near_page, far_page;
  draw_world(near_page, world_camera, world);
  draw_unseen(near_page, world_camera, world);
  draw_world(far_page, camera, shifted(world, far));
  draw_unseen(far_page, camera, shifted(world, far));
  CHECK(compare(near_page.canvas().read(), far_page.canvas().read()).differing == 0);
}

TEST_CASE("of a body of ten kilometres its edge is drawn where a tenth of a millimetre fills the picture") {
  const Camera camera{.viewport = extreme_view, .center = {0, 0}, .scale = 1e6};
  const Theme theme = light_theme();
  for (const Shape<double>& shape : {Shape<double>(box(1e4, 1e4)), Shape<double>(circle(5e3))}) {
    for (const BodyType type : {BodyType::dynamic, BodyType::static_body}) {
      Snapshot world{.dt = 0.02};
      world.bodies.push_back({});
      world.bodies.push_back(dynamic_body(shape, {0, -5e3}));
      world.bodies[{1}].type = type;
      world.bodies.push_back(dynamic_body(box(1e-4, 1e-4), {0, 5e-5}));
      WorldPage page;
      draw_world(page, camera, world, {.numbers = false});
      draw_unseen(page, camera, world);
      CHECK(page.canvas().text_boxes().size() == 1);  // the title: all is seen
      const Image image = page.canvas().read();
      const Color large = type == BodyType::dynamic ? theme.body : theme.static_body;
      for (const double x : {-300.0, 0.0, 300.0}) {
        int inside = 0;
        for (int y = 10; y < 60; ++y)
          inside += distance_at(image, extreme_middle + Point(x, y), large) <= 2 ? 1 : 0;
        CHECK(inside > 25);  // between the lines of the hatch, if there is one
      }
      CHECK(distance_at(image, extreme_middle + Point(-300, -20), theme.background) <= 2);
      CHECK(distance_at(image, extreme_middle + Point(0, -20), theme.body) <= 2);
    }
  }
}

TEST_CASE("a number that would fill a line is written with a power of ten") {
  CHECK(readable(1234.5, 2) == "1234.50");
  CHECK(readable(-99999.4, 1) == "−99999.4");
  CHECK(readable(1e7, 2) == "1×10^{7}");
  CHECK(readable(-2.5e300, 2) == "−2.5×10^{300}");
  CHECK(readable(std::numeric_limits<double>::infinity(), 2) == "∞");
  CHECK(readable(no_number, 2) == "NaN");
}
