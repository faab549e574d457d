// The box on its rod, with level curves of c and the arrows of j, f and v.
#include "lesson.hpp"

namespace cairn::one_row {

namespace {

/// The pivot, the box, and the circles around the pivot with room for their names; or the box alone.
Camera rod_camera(const Rect& inside, const Rod& rod, const RodLook& look) {
  const Vec2<double>& anchor = rod.settings.anchor;
  if (look.asked)
    return fit(inside, {{-1, std::min(-1.0, anchor.y()) - 1.8}, {std::max(1.0, anchor.x()) + 2.5, 0.5}});
  if (look.close) return fit(inside, {anchor - Vec2<double>(1.7, 2.2), anchor + Vec2<double>(2.6, 2)});
  return fit(inside, {{std::min(-1.3, 0.9 * anchor.x() - 2.6), -rod.length - 1.5},
                      {std::max(anchor.x() + 2.6, 4.0), 0.5}});
}

List<Point> circle(const Camera& camera, double radius) {
  List<Point> points;
  for (int k = 0; k <= 720; ++k)
    points.push_back(camera.project(Rotation<double>(-pi * k / 720) * Vec2<double>(radius, 0)));
  return points;
}

/// Where c is −1, 0 and +1 m, were the anchor there.
void draw_circles(Page& page, const Camera& camera, const Rod& rod, const RodLook& look) {
  const Vec2<double> down = look.close
                                ? Vec2<double>(Rotation<double>(-0.15) * rod.settings.anchor.normalized())
                                : Vec2<double>(0, -1);  // where the names stand
  for (const double c : {-1.0, 0.0, 1.0}) {
    const double radius = rod.length + c;
    const List<Point> points = circle(camera, radius);
    Stroke stroke{.width = page.sizes().axis, .color = page.theme().inactive, .dash = {6, 5}};
    if (c == 0) stroke = {.width = page.sizes().curve, .color = page.theme().joint, .dash = {}};
    page.canvas().polyline(points, stroke);
    page.avoid(points);
    TextStyle style = page.value();
    const std::string name = c == 0 ? "c = 0" : "c = " + fixed(c, 0, Sign::always) + " m";
    const Point at = camera.project(radius * down);
    const double width = page.canvas().text_width(name, style);
    page.canvas().rect({at.x() - width / 2 - 6, at.y() - 0.7 * style.size, width + 12, 1.4 * style.size},
                       {.fill = page.theme().panel});
    page.canvas().text(at + Point(-width / 2, 0.35 * style.size), name, style);
  }
}

TextStyle bold_label(const Page& page, const Color& color) {
  return {.size = render::large_text, .color = color, .bold = true, .mono = true, .halo = page.theme().panel};
}

/// Beyond the tip of an arrow, above it or below it; first of all `aside` by so many half widths.
void write_at_tip(Page& page, const Camera& camera, const Vec2<double>& tip, const Vec2<double>& along,
                  const std::string& text, TextStyle style, double aside = 0) {
  style.align = Align::center;
  const double gap = along.y() > 0 ? -8 : 8 + style.size;
  const double half = page.canvas().text_width(text, style) / 2;
  const Point at = camera.project(tip) + Point(0, gap);
  List<Point> places = {at + Point(aside * half, 0), at};
  for (const double away : {0.0, 1.5 * gap, 3 * gap}) {
    for (const double by : {-0.7, 0.7, -1.2, 1.2}) places.push_back(at + Point(by * half, away));
  }
  page.place_text(places, camera.viewport, text, style);
}

/// c = 0 where the box covers it.
void draw_covered_goal(Page& page, const Camera& camera, const Rod& rod, const Pose<double>& box) {
  List<Point> points;
  for (const Point& point : circle(camera, rod.length)) {
    const Vec2<double> inside = Rotation<double>(-box.angle) * (camera.unproject(point) - box.position);
    if (inside.cwiseAbs().maxCoeff() < 0.5) points.push_back(point);
  }
  page.canvas().polyline(points, {.width = page.sizes().axis, .color = page.theme().joint, .dash = {6, 5}});
}

/// The unit box and its tick.
void avoid_box(Page& page, const Camera& camera, const Pose<double>& box) {
  List<Point> line;
  for (const auto& [x, y] :
       {std::pair(0.38, 0.0), {0.5, 0.0}, {0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.0}})
    line.push_back(camera.project(box.world({x, y})));
  page.avoid(line);
}

/// c of these poses: from where the anchor should be, a cross stroke, to where it is, a dot, along the rod.
void draw_errors(Page& page, const Camera& camera, const Rod& rod, const List<Pose<double>>& poses) {
  TextStyle style = page.value();
  style.halo = page.theme().panel;
  const auto ends = [&](const Pose<double>& pose) {
    const Vec2<double> anchor = pose.world(rod.local_anchor);
    return std::pair(camera.project(anchor * (rod.length / anchor.norm())), camera.project(anchor));
  };
  const Stroke thick{.width = 1.2 * page.sizes().arrow, .color = page.theme().friction};
  for (const Pose<double>& pose : poses) {
    const auto [from, to] = ends(pose);
    if ((to - from).norm() < 1) continue;
    const Point across = 9 * perpendicular((to - from).normalized());
    page.canvas().line(from, to, thick);
    page.canvas().line(from - across, from + across, {.width = 3, .color = thick.color});
    page.canvas().circle(to, page.sizes().contact, {.fill = thick.color});
    page.avoid({from, to});
  }
  for (const Pose<double>& pose : poses) {
    const auto [from, to] = ends(pose);
    if ((to - from).norm() < 1) continue;
    const std::string text = fixed(error_at(rod, pose), 2, Sign::always) + " m";
    const double width = page.canvas().text_width(text, style), rise = 0.35 * style.size;
    List<Point> places;
    for (const double away : {12, 28}) {
      places.push_back(to + Point(away, rise));
      places.push_back(to + Point(-width - away, rise));
      places.push_back(to + Point(-width / 2, rise + 1.1 * away + 3));
    }
    page.place_text(places, camera.viewport, text, style);
  }
}

/// A curve with a head at its end; `avoid`ed by labels.
void draw_curved_arrow(Page& page, const List<Point>& points, const Color& color) {
  const Point tip = points.back();
  const double length = page.sizes().head_length;
  int neck = points.size() - 1;  // where the head begins
  while (neck > 0 && (tip - points[neck]).norm() < length) --neck;
  const Point along = (tip - points[neck]).normalized();
  const Point side = 0.5 * page.sizes().head_width * perpendicular(along);
  List<Point> shaft(points.begin(), points.begin() + neck + 1);
  shaft.push_back(tip - 0.8 * length * along);
  page.canvas().polyline(shaft, {.width = 0.8 * page.sizes().arrow, .color = color});
  const FixedList<Point, 3> head = {tip - length * along - side, tip + 2 * along,
                                    tip - length * along + side};
  page.canvas().polygon(head, {.fill = color});
  page.avoid(points);
}

struct Arc {
  Vec2<double> center = {0, 0};  // [m]
  double radius = 0.8;           // [m]
  double middle = 0;             // [rad] direction of its middle
  double sign = 1;               // positive: counterclockwise
  std::string label = {};
  Color color = {};
};

/// A turning sense: an arc with a head.
void draw_arc(Page& page, const Camera& camera, const Arc& arc) {
  constexpr double half = 0.75;  // [rad] of the arc, to both sides
  const auto at = [&](double turn) {
    const Vec2<double> out = Rotation<double>(arc.middle + turn) * Vec2<double>(arc.radius, 0);
    return camera.project(arc.center + out);
  };
  List<Point> points;
  for (int k = 0; k <= 32; ++k) points.push_back(at(arc.sign * half * (k / 16.0 - 1)));
  draw_curved_arrow(page, points, arc.color);
  const TextStyle style = bold_label(page, arc.color);
  const double wide = page.canvas().text_width(arc.label, style);
  const double gap = 0.7 * page.sizes().arrow + 6, rise = 0.35 * style.size;
  const Point beside = std::sin(arc.middle) > 0.8 ? Point(-wide / 2, -gap) : Point(gap, rise);
  page.place_text(
      {at(0) + beside, at(0) + Point(-gap - wide, rise), at(0) + Point(-wide / 2, gap + style.size),
       at(1) + Point(-wide / 2, -6), at(-1) + Point(-wide / 2, 6 + style.size)},
      camera.viewport, arc.label, style);
}

/// j or f: what it has for x and y at the anchor, and for the angle around the centre.
void draw_row_arrows(Page& page, const Camera& camera, const Rod& rod, const RodLook& look) {
  const Vec3<double>& value = look.force ? rod.force : rod.jacobian;
  const double size = value.head<2>().norm();
  if (!(size > 0)) return;
  const Color color = look.force ? page.theme().normal : page.theme().text;
  const Vec2<double> anchor = look.pose.world(rod.local_anchor);
  const Vec2<double> way = value.head<2>() * (1.7 / size);  // [m]
  draw_curved_arrow(page, {camera.project(anchor), camera.project(anchor + way)}, color);
  write_at_tip(
      page, camera, anchor + way, way,
      fmt::format("({}, {}){}", significant(value.x(), 2), significant(value.y(), 2), look.force ? " N" : ""),
      bold_label(page, color));
  if (std::abs(value.z()) < 1e-6 * size) return;
  const Vec2<double> arm = rod.pose.position - rod.settings.anchor;  // away from the rod
  draw_arc(page, camera,
           {.center = look.pose.position,
            .radius = 0.95,
            .middle = std::atan2(arm.y(), arm.x()),
            .sign = value.z() > 0 ? 1.0 : -1.0,
            .label = significant(value.z(), 2) + (look.force ? " N m" : " m"),
            .color = color});
}

/// A velocity of a point of the box, with its name at the tip.
void draw_velocity(Page& page, const Camera& camera, const ArrowScale& scale, const render::Arrow& arrow,
                   const std::string& name, double aside = 0) {
  draw_arrow(page, camera, scale, arrow);
  const Vec2<double> way = arrow.value * (scale.pixels_per_unit / camera.scale);  // [m] to the tip
  page.avoid({camera.project(arrow.tail), camera.project(arrow.tail + way)});
  const Color color = arrow.active ? page.theme().velocity : page.theme().secondary_text;
  if (way.norm() > 0) write_at_tip(page, camera, arrow.tail + way, way, name, bold_label(page, color), aside);
}

Vec2<double> at_anchor(const Rod& rod, const Vec3<double>& v) { return v.head<2>() + cross(v.z(), rod.arm); }

/// A right angle between the rod and the velocity of its end.
void draw_right_angle(Page& page, const Camera& camera, const Vec2<double>& at, const Vec2<double>& way) {
  const Vec2<double> one = 0.14 * way.normalized(), other = -0.14 * at.normalized();  // [m]
  const List<Point> corner = {camera.project(at + one), camera.project(at + one + other),
                              camera.project(at + other)};
  page.canvas().polyline(corner, {.width = page.sizes().axis, .color = page.theme().text});
}

/// At the anchor: how the box moves as a whole, what its turning adds, and the sum, which is what the rod
/// sees.
void draw_velocities(Page& page, const Camera& camera, const Rod& rod, const Motion& motion) {
  const Vec2<double> sum = at_anchor(rod, motion.velocity), whole = motion.velocity.head<2>();
  const Vec2<double>& anchor = rod.settings.anchor;
  const double largest = std::max(whole.norm(), sum.norm()), metres = std::min(1.4, 2 / largest);  // [s]
  const ArrowScale scale{.pixels_per_unit = metres * camera.scale, .longest = 1e4};
  const Vec2<double> middle = anchor + metres * whole, tip = anchor + metres * sum;
  const TextStyle grey = bold_label(page, page.theme().secondary_text);
  draw_arrow(page, camera, scale,
             {.kind = ArrowKind::velocity, .tail = anchor, .value = whole, .active = false});
  draw_arrow(page, camera, scale,
             {.kind = ArrowKind::velocity, .tail = middle, .value = sum - whole, .active = false});
  page.avoid({camera.project(anchor), camera.project(middle), camera.project(tip)});
  draw_velocity(page, camera, scale, {.kind = ArrowKind::velocity, .tail = anchor, .value = sum}, "anchor",
                -0.8);
  if (motion.rate == 0 && sum.norm() > 0) draw_right_angle(page, camera, anchor, sum);
  const Point beside(12, 0.35 * grey.size);
  const Point from = camera.project(anchor), knee = camera.project(middle), to = camera.project(tip);
  if (motion.velocity.z() != 0)
    page.place_text({0.5 * (knee + to) + beside - Point(0, 6), to + beside}, camera.viewport, "turning",
                    grey);
  if (whole.norm() > 0)
    page.place_text({knee + beside + Point(0, 10), 0.5 * (from + knee) + beside}, camera.viewport,
                    "as a whole", grey);
}

/// The velocity of the question, at the centre and around it; and where the rod begins and ends.
void draw_asked(Page& page, const Camera& camera, const Rod& rod) {
  const Vec3<double>& v = rod.motion.velocity;
  const ArrowScale scale{.pixels_per_unit = 1.4 * camera.scale, .longest = 1e4};
  draw_velocity(page, camera, scale,
                {.kind = ArrowKind::velocity, .tail = rod.pose.position, .value = v.head<2>()},
                fmt::format("({}, {}) m/s", significant(v.x()), significant(v.y())));
  if (v.z() != 0)
    draw_arc(page, camera,
             {.center = rod.pose.position,
              .radius = 1.05,
              .middle = v.z() > 0 ? 1.5 : -1.7,
              .sign = v.z() > 0 ? 1.0 : -1.0,
              .label = significant(v.z()) + " rad/s",
              .color = page.theme().velocity});
  const TextStyle style = bold_label(page, page.theme().text);
  const Vec2<double>& end = rod.settings.anchor;
  page.canvas().text(camera.project({0, 0}) + Point(16, 5), "(0, 0)", style);
  page.canvas().text(camera.project(0.5 * end) + Point(16, 0), significant(rod.length) + " m", style);
  page.canvas().text(camera.project(end) + Point(-16, 5),
                     fmt::format("({}, {}) m", significant(end.x()), significant(end.y())),
                     aligned(style, Align::right));
}

}  // namespace

void draw_rod(Page& page, const Rect& rect, const Rod& rod, const RodLook& look) {
  const Rect inside = page.panel(rect, "");
  const Camera camera = rod_camera(inside, rod, look);
  page.canvas().push_clip(inside);
  if (look.circles) draw_circles(page, camera, rod, look);
  List<Snapshot> others;
  for (const Pose<double>& pose : look.others) others.push_back(moved_to(rod, pose));
  for (const Snapshot& other : others) draw_ghosts(page, camera, Span<const Snapshot>(&other, 1));
  draw_world(page, camera, moved_to(rod, look.pose), {.names = {"", ""}, .contacts = false});
  page.avoid({camera.project({0, 0}), camera.project(look.pose.world(rod.local_anchor))});
  page.canvas().circle(camera.project({0, 0}), page.sizes().joint,
                       {.fill = page.theme().panel, .outline = page.theme().outline, .outline_width = 2});
  if (look.errors) {
    List<Pose<double>> poses = look.others;
    poses.push_back(look.pose);
    draw_covered_goal(page, camera, rod, look.pose);
    for (const Pose<double>& pose : poses) avoid_box(page, camera, pose);
    draw_errors(page, camera, rod, poses);
  }
  if (look.direction || look.force) draw_row_arrows(page, camera, rod, look);
  if (look.asked) draw_asked(page, camera, rod);
  if (look.velocity) draw_velocities(page, camera, rod, rod.motion);
  page.canvas().pop_clip();
}

}  // namespace cairn::one_row
