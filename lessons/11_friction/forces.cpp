// Lesson 11. Forces on the block, drawn upon the slope.
#include "lesson.hpp"

namespace cairn::friction {

namespace {

/// The weight is as long as 1.6 sides of the block, so that the bounds of its two corners just stay apart.
ArrowScale force_scale(const Camera& camera, const Slide& slide) {
  const double longest = 1.6 * camera.scale;
  return {longest / (slide.slope.gravity * slide.block.mass), longest, "N"};
}

struct Force {
  render::Arrow arrow = {};
  std::string text = "";
  bool is_above = false;  // the label stands above the tip, clear of others below
};

/// Writes the label at the arrow's tip: beside the middle it would stand upon the block.
void label_force(Page& page, const Camera& camera, const Rect& panel, const ArrowScale& scale,
                 const Force& force) {
  const Vec2<double>& value = force.arrow.value;
  const Point tip = camera.project(force.arrow.tail) + scale.pixels_per_unit * Point(value.x(), -value.y());
  TextStyle style = page.value();
  style.size *= 1.15;
  style.halo = page.theme().background;
  const double width = page.canvas().text_width(force.text, style);
  const double size = style.size;
  const double side = value.x() < 0 ? -width : 0;
  List<Point> places;
  if (force.is_above) places.push_back({std::max(tip.x() - 0.85 * width, panel.x + 6), tip.y() - 2.2 * size});
  if (value.x() < 0) {
    // Below the shaft, which comes down to the right from the tip, and where others stand there, below them.
    const double drop = 0.8 * width * std::abs(value.y() / value.x());
    const double left = std::max(tip.x() - 0.2 * width, panel.x + 6);
    for (int line = 0; line < 6; ++line) places.push_back({left, tip.y() + drop + (1.7 + 1.4 * line) * size});
  }
  if (value.y() < 0) {
    places.push_back(tip + Point(size, -size));  // clear of the bracket that may stand at the tip
    places.push_back(tip + Point(side, 1.4 * size));
  }
  if (value.x() > 0 && value.y() > 0) places.push_back(tip + Point(14, -0.5 * size));  // clear of the arm
  places.push_back(tip + Point(value.x() < 0 ? -width - 8 : 16, size / 3));
  places.push_back(tip + Point(side, -10));
  page.place_text(places, panel, force.text, style);
}

/// The labels of short arrows give way to those of long ones.
void draw_forces(Page& page, const Camera& camera, const Rect& panel, const ArrowScale& scale,
                 List<Force> forces) {
  for (const Force& force : forces) draw_arrow(page, camera, scale, force.arrow);
  std::ranges::stable_sort(forces, std::ranges::greater(),
                           [](const Force& force) { return force.arrow.value.norm(); });
  for (const Force& force : forces) label_force(page, camera, panel, scale, force);
}

std::string newtons(const std::string& name, double value) { return name + " " + fixed(value, 2) + " N"; }

/// The block, so large that its forces have room, and below it room for their key.
Camera draw_block(Page& page, const Rect& rect, const Slide& slide) {
  Rect inside = page.panel(rect, "");
  inside.height -= 34;
  const Vec2<double> middle = slide.frames[1].bodies[first_block].pose.position;
  const Camera camera = fit(inside, {middle - Vec2<double>(1.1, 1.05), middle + Vec2<double>(1.25, 0.95)});
  draw_world(page, camera, slide.frames[1], {.names = {"", "", ""}, .contacts = false});
  return camera;
}

/// The slope with its angle, and the block upon it.
Camera draw_slope(Page& page, const Rect& rect, const Slide& slide) {
  const Slope& slope = slide.slope;
  const Rect inside = page.panel(rect, "");
  const Vec2<double> foot(slope.length * std::cos(slope.angle), 0);
  const Camera camera =
      fit(inside, {{-0.3, -0.2}, {foot.x() + 0.1, slope.length * std::sin(slope.angle) + 0.9}});
  draw_world(page, camera, slide.frames[1],
             {.names = {"", "", significant(slide.block.mass) + " kg"}, .contacts = false});
  List<Point> arc;
  for (int i = 0; i <= 20; ++i) {
    const double angle = pi - slope.angle * i / 20;
    arc.push_back(camera.project(foot + Vec2<double>(std::cos(angle), std::sin(angle))));
  }
  page.canvas().polyline(arc, {.width = 2, .color = page.theme().text});
  TextStyle style = page.label();
  style.size *= 1.2;
  style.align = Align::right;
  style.halo = page.theme().background;
  const double middle = pi - slope.angle / 2;
  page.canvas().text(camera.project(foot + 1.1 * Vec2<double>(std::cos(middle), std::sin(middle))),
                     significant(slope.angle * 180 / pi) + "°", style);
  return camera;
}

/// Half a metre from the middle of the block down to the side where friction pulls.
void draw_arm(Page& page, const Camera& camera, const Slide& slide, const Vec2<double>& middle) {
  const Point from = camera.project(middle), to = camera.project(middle - 0.5 * slide.slope.normal());
  page.canvas().line(from, to, {.width = 2, .color = page.theme().secondary_text, .dash = {4, 4}});
  page.avoid({from, to});
  page.canvas().text(from + 0.6 * (to - from) + Point(8, 8), "0.5 m", page.label());
}

/// How long a force is drawn, and what the brackets are.
void draw_key(Page& page, const Rect& rect, const ArrowScale& scale) {
  const Point corner(rect.x + 16, rect.y + rect.height - 14);
  draw_scale_key(page, scale, corner);
  page.canvas().text(corner + Point(180, 0), "[ ] at ± μ λ_{n}: the bounds of λ_{t}", page.label());
}

}  // namespace

void draw_corners(Page& page, const Rect& rect, const Slide& slide, Corners corners) {
  const Snapshot& now = slide.frames[1];
  const bool solved = corners == Corners::solved;
  const Camera camera = solved ? draw_block(page, rect, slide) : draw_slope(page, rect, slide);
  const ArrowScale scale = force_scale(camera, slide);
  const Vec2<double> downhill = slide.slope.downhill();
  const Coulomb law = coulomb(slide.slope, slide.block);
  const Vec2<double> middle = now.bodies[first_block].pose.position;
  List<Force> forces;
  for (const SnapshotContact& contact : now.contacts) {
    const double load = contact.normal_impulse / now.dt;
    const double held = solved ? std::abs(contact.friction_impulse) / now.dt : 0.5 * law.given();
    if (solved) {
      draw_friction_limit(page, camera, scale, contact.position, downhill, contact.friction * load);
      forces.push_back(
          {{.kind = ArrowKind::normal, .tail = contact.position, .value = load * slide.slope.normal()},
           newtons("λ_{n}", load)});
    }
    // While it is asked for, only its direction is drawn: dashed, and equally long at both corners.
    forces.push_back({{.kind = solved ? ArrowKind::friction : ArrowKind::external,
                       .tail = contact.position,
                       .value = -held * downhill},
                      solved ? newtons("λ_{t}", held) : "? N",
                      solved && contact.position.x() < middle.x()});
  }
  if (solved) {
    draw_key(page, rect, scale);
    draw_arm(page, camera, slide, middle);
  }
  draw_forces(page, camera, rect, scale, forces);
}

}  // namespace cairn::friction
