// The box on its peg: velocities, the push, and curves of the effective mass.
#include "lesson.hpp"

namespace cairn::one_push {

namespace {

constexpr double longest_push = 0.8;  // [m] of the arrow in the middle
constexpr double longest_bar = 0.55;  // [m]
constexpr double longest_ray = 0.75;  // [m]
// [m] that the box would have fallen, for each outline; the last one is darkest
constexpr FixedList<double, 3> ways = {0.15, 0.1, 0.05};

void draw_fall(Page& page, const Camera& camera, const Pushes& all, const Push& push, const PegLook& look) {
  const Vec3<double>& v = (look.after ? push.after : push.before).bodies[{2}].velocity;
  const ArrowScale scale{
      .pixels_per_unit = 0.42 * camera.scale / all.settings.speed, .longest = 1e4, .unit = "m/s"};
  // Before the push all of the box has one velocity: the arrow stands beside a push near the middle.
  Vec2<double> tail = push.before.bodies[{2}].pose.position;
  if (look.push && push.x < 0.4) tail.x() -= 0.35;
  if (std::abs(v.y()) > 1e-9 * all.settings.speed)
    draw_arrow(page, camera, scale,
               {.kind = ArrowKind::velocity,
                .tail = tail,
                .value = v.head<2>(),
                .label = significant(std::abs(v.y()), 3) + " m/s"});
}

/// A turning sense around the middle of the box, above it.
void draw_turning(Page& page, const Camera& camera, const Push& push) {
  const double w = push.after.bodies[{2}].velocity.z();
  const Vec2<double> middle = push.before.bodies[{2}].pose.position;
  if (std::abs(w) < 1e-9) return;
  List<Point> points;
  for (int k = 0; k <= 32; ++k) {
    const double angle = 0.5 * pi + (w > 0 ? 1 : -1) * 0.6 * (k / 16.0 - 1);
    points.push_back(camera.project(middle + Rotation<double>(angle) * Vec2<double>(0.85, 0)));
  }
  const Point tip = points.back();
  const Point along = (tip - points[points.size() - 5]).normalized();
  const Point side = 0.5 * page.sizes().head_width * perpendicular(along);
  const Point base = tip - 0.9 * page.sizes().head_length * along;
  page.canvas().polyline(points,
                         {.width = 0.8 * page.sizes().arrow, .color = page.theme().velocity, .dash = {}});
  const FixedList<Point, 3> head = {base - side, tip, base + side};
  page.canvas().polyline(head,
                         {.width = 0.65 * page.sizes().arrow, .color = page.theme().velocity, .dash = {}});
  TextStyle style = aligned(page.value(), Align::center);
  style.color = page.theme().velocity;
  style.size = render::large_text;
  style.bold = true;
  page.canvas().text(points[16] + Point(0, -12), significant(w, 3) + " rad/s", style);
}

void draw_impulse(Page& page, const Camera& camera, const Pushes& all, const Push& push) {
  const double whole = all.settings.mass * all.settings.speed;  // of the middle
  const ArrowScale scale{
      .pixels_per_unit = longest_push * camera.scale / whole, .longest = 1e4, .unit = "N s"};
  const Vec2<double> tail(push.x, 0);
  draw_arrow(page, camera, scale,
             {.kind = ArrowKind::normal,
              .tail = tail,
              .value = {0, push.impulse},
              .label = significant(push.impulse, 3) + " N s"});
}

/// How heavy the box is for a push upwards, all along its underside.
void draw_bars(Page& page, const Camera& camera, const Pushes& all) {
  for (int k = -4; k <= 4; ++k) {  // the outermost ones end with the box
    const double x = 0.125 * k;
    const double mass = mass_at(all.settings.mass, {x, -0.5}, {0, 1});
    const double length = longest_bar * mass / all.settings.mass;
    const Point top = camera.project({0.92 * x - 0.04, -0.02});
    page.canvas().rect({top.x(), top.y(), 0.08 * camera.scale, length * camera.scale},
                       {.fill = page.theme().normal, .outline = page.theme().outline, .outline_width = 1});
    if (k % 4 != 0) continue;
    TextStyle style = page.value();
    const std::string text = significant(mass, 3) + " kg";
    style.align = k == 0 ? Align::center : k > 0 ? Align::left : Align::right;
    const Point aside = k == 0 ? Point(0, style.size + 8) : Point(k > 0 ? 8 : -8, 0);
    const Vec2<double> end(x + 0.01 * k, -0.02 - length);
    page.canvas().text(camera.project(end) + aside, text, style);
  }
}

/// The effective mass in every direction at one point: as far from it as the mass is large.
void draw_directions(Page& page, const Camera& camera, const Pushes& all, const Push& push) {
  const Vec2<double> contact(push.x, 0);
  const Vec2<double> arm = contact - push.before.bodies[{2}].pose.position;
  const double scale = longest_ray / all.settings.mass;
  List<Point> points;
  for (int k = 0; k <= 180; ++k) {
    const Vec2<double> direction = Rotation<double>(pi * k / 90) * Vec2<double>(1, 0);
    points.push_back(
        camera.project(contact + direction * (scale * mass_at(all.settings.mass, arm, direction))));
  }
  page.canvas().polyline(points, {.width = page.sizes().curve, .color = page.theme().normal, .dash = {}});
  page.avoid(points);
  const Vec2<double> second = push.x > 0 ? Vec2<double>(-arm.normalized()) : Vec2<double>(1, 0);
  for (const Vec2<double>& ray : {Vec2<double>(0, 1), second}) {
    const double mass = mass_at(all.settings.mass, arm, ray);
    draw_arrow(page, camera, {.pixels_per_unit = scale * camera.scale, .longest = 1e4, .unit = "kg"},
               {.kind = ArrowKind::normal, .tail = contact, .value = mass * ray});
    // Beside the tip, where the other arrow is not.
    TextStyle style = page.value();
    style.halo = page.theme().background;
    const std::string text = significant(mass, 3) + " kg";
    const double width = page.canvas().text_width(text, style);
    const Point aside = ray.x() < 0   ? Point(-width - 8, -6)
                        : ray.x() > 0 ? Point(8, style.size + 6)
                                      : Point(8, -8);
    page.canvas().text(camera.project(contact + scale * mass * ray) + aside, text, style);
  }
}

/// Where the velocities after the push lead, for a while.
void draw_way(Page& page, const Camera& camera, const Pushes& all, const Push& push) {
  List<Snapshot> later;
  for (const double way : ways) {
    Snapshot moved = push.after;
    Pose<double>& pose = moved.bodies[{2}].pose;
    const Vec3<double>& v = moved.bodies[{2}].velocity;
    const double t = way / all.settings.speed;
    pose.position += t * v.head<2>();
    pose.angle += t * v.z();
    later.push_back(moved);
  }
  draw_ghosts(page, camera, later);
}

std::string title_of(const Pushes& all, const Push& push, const PegLook& look) {
  const double speed = all.settings.speed;
  if (look.after && push.after.bodies[{2}].velocity.norm() < 1e-9 * speed) return "it stands still";
  if (look.after) {
    return fmt::format("outlines: if it kept this velocity for {}, {} and {} s", significant(ways[2] / speed),
                       significant(ways[1] / speed), significant(ways[0] / speed));
  }
  if (!look.directions && !look.named) return "";
  if (look.directions)
    return fmt::format("x = {} m: distance from the point = effective mass that way", significant(push.x));
  return push.x > 0 ? fmt::format("{} m to the right of the centre", significant(push.x))
                    : "below the centre";
}

}  // namespace

void draw_push(Page& page, const Rect& rect, const Pushes& all, const Push& push, const PegLook& look) {
  const bool no_peg = look.masses || look.directions;
  const Rect inside = page.panel(rect, title_of(all, push, look));
  const double lowest = no_peg ? -0.8 : -0.5;
  const double highest = look.after ? 1.6 : 1.15;  // room for the turning sense
  const Camera camera = fit(inside, {{-0.9, lowest}, {look.directions ? 1.1 : 0.9, highest}});
  page.canvas().push_clip(inside);
  Snapshot seen = push.before;
  seen.contacts.clear();
  if (no_peg) seen.bodies[{1}].shapes.clear();
  draw_world(page, camera, seen, {.names = {"", "", ""}, .contacts = false});
  if (look.after) draw_way(page, camera, all, push);
  if (!no_peg)
    page.canvas().circle(camera.project({push.x, 0}), page.sizes().contact, {.fill = page.theme().normal});
  if (look.push) draw_impulse(page, camera, all, push);
  if (look.asked && (push.x == 0 || push.x == all.at.back().x)) {
    page.canvas().text(camera.project({push.x, -0.35}),
                       push.x == 0 ? significant(push.impulse, 3) + " N s" : "? N s",
                       {.size = 24, .color = page.theme().normal, .bold = true, .align = Align::center});
  }
  if (!no_peg && !(look.named && look.push)) draw_fall(page, camera, all, push, look);
  if (look.after) draw_turning(page, camera, push);
  if (look.masses) draw_bars(page, camera, all);
  if (look.directions) draw_directions(page, camera, all, push);
  page.canvas().pop_clip();
}

}  // namespace cairn::one_push
