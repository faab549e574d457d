// Contacts, overlaps and joints of a drawn world.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include <cairn/math/list.hpp>
#include "render/draw_parts.hpp"
#include "render/lint.hpp"
#include "render/text_layout.hpp"

namespace cairn::render {
namespace {

constexpr double least_depth = 2;  // [px] overlaps of less are not marked
constexpr int most_depths = 4;     // that are written
constexpr int some_contacts = 60;  // fewer are always drawn whole
constexpr int many_contacts = 400;

bool is_finite(const Camera& camera, const Vec2<double>& point) {
  return is_drawable(camera, {.position = point, .angle = 0});
}

/// The deepest contact of each pair of bodies.
List<SnapshotContact> deepest_of_pairs(const Camera& camera, const Snapshot& snapshot) {
  List<SnapshotContact> deepest;
  for (const SnapshotContact& contact : snapshot.contacts) {
    if (!(-contact.separation * camera.scale > least_depth) || !is_finite(camera, contact.position)) continue;
    const auto same = std::find_if(deepest.begin(), deepest.end(), [&](const SnapshotContact& other) {
      return other.a == contact.a && other.b == contact.b;
    });
    if (same == deepest.end()) {
      deepest.push_back(contact);
    } else if (contact.separation < same->separation) {
      *same = contact;
    }
  }
  std::stable_sort(deepest.begin(), deepest.end(), [](const SnapshotContact& x, const SnapshotContact& y) {
    return x.separation < y.separation;
  });
  return deepest;
}

// Hatch lines of the other direction than Canvas::hatch() draws.
void counter_hatch(Canvas& canvas, const Outline& outline, const Stroke& stroke, double pitch) {
  double low = 1e9;
  double high = -1e9;
  for (const Point& point : outline) {
    low = std::min(low, point.x() - point.y());
    high = std::max(high, point.x() - point.y());
  }
  for (double offset = std::ceil(low / pitch) * pitch; offset < high; offset += pitch) {
    // x - y = offset: where it crosses the edges.
    List<Point> ends;
    for (int i = 0; i < outline.size(); ++i) {
      const Point& from = outline[i];
      const Point& to = outline[(i + 1) % outline.size()];
      const double here = from.x() - from.y() - offset;
      const double there = to.x() - to.y() - offset;
      if ((here >= 0) != (there >= 0)) ends.emplace_back(from + here / (here - there) * (to - from));
    }
    if (ends.size() == 2) canvas.line(ends[0], ends[1], stroke);
  }
}

void draw_overlap(Page& page, const Outline& overlap) {
  Canvas& canvas = page.canvas();
  const Color ink = ink_on(page.theme().penetration);
  const Stroke lines{.width = 1, .color = faded(ink, 0.8)};
  canvas.polygon(overlap, {.fill = page.theme().penetration});
  canvas.hatch(overlap, lines, 0.7 * page.sizes().hatch_pitch);
  counter_hatch(canvas, overlap, lines, 0.7 * page.sizes().hatch_pitch);
  canvas.polygon(overlap, {.outline = ink, .outline_width = 1});
}

/// Returns the box around all that was marked, around the contact point if nothing was.
Rect draw_overlaps(Page& page, const Camera& camera, const SnapshotBody& a, const SnapshotBody& b,
                   const Point& contact) {
  Point low = contact;
  Point high = contact;
  const Rect view = inset(camera.viewport, -4);
  for (const Shape<double>& of_a : a.shapes) {
    for (const Shape<double>& of_b : b.shapes) {
      const Outline overlap =
          clipped(common_part(outline_of(camera, a.pose, of_a), outline_of(camera, b.pose, of_b)), view);
      if (!(area(overlap) > 1)) continue;
      draw_overlap(page, overlap);
      for (const Point& point : overlap) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
      }
    }
  }
  return {low.x(), low.y(), high.x() - low.x(), high.y() - low.y()};
}

void write_depth(Page& page, const Camera& camera, const SnapshotContact& contact, const Rect& overlap) {
  const double millimetres = -1000 * contact.separation;
  TextStyle style = page.value();
  style.color = page.theme().text;
  style.halo = page.theme().background;
  const std::string text = readable(millimetres, millimetres < 10 ? 1 : 0) + " mm";
  const double right = overlap.x + overlap.width + 10;
  const double left = overlap.x - 10 - page.canvas().text_width(text, style);
  const double middle = overlap.y + overlap.height / 2;
  List<Point> places;
  for (const double shift : {0.0, -1.1, 1.1, -2.2, 2.2}) {
    const double y = baseline_around(middle + shift * style.size, style.size);
    places.emplace_back(right, y);
    places.emplace_back(left, y);
  }
  write_if_free(page, places, camera.viewport, text, style);
}

// An arm from the body's middle to an anchor outside of its shapes.
void draw_arm(Page& page, const Camera& camera, const SnapshotBody* body, const Vec2<double>& anchor) {
  if (body == nullptr || body->type == BodyType::static_body || !is_drawable(camera, body->pose)) return;
  if (depth_in(*body, body->pose.local(anchor)) * camera.scale > -1) return;
  page.canvas().line(camera.project(body->pose.position), camera.project(anchor),
                     {.width = page.sizes().outline, .color = page.theme().joint});
}

void draw_rod(Page& page, const Point& from, const Point& to) {
  const double gap = page.sizes().outline;
  page.canvas().line(from, to, {.width = 3 * gap, .color = page.theme().joint});
  page.canvas().line(from, to, {.width = gap, .color = page.theme().background});
}

/// Joints of angles and velocities have no line that shows them: their bodies do.
bool is_seen(const Camera& camera, const SnapshotJoint& joint) {
  return joint.traits.holds_points && joint.traits.is_shown && is_finite(camera, joint.anchor_a) &&
         is_finite(camera, joint.anchor_b) &&
         std::all_of(joint.between.begin(), joint.between.end(),
                     [&](const Vec2<double>& point) { return is_finite(camera, point); });
}

/// The way of a rope over what is between its ends.
List<Point> way_of(const Camera& camera, const SnapshotJoint& joint) {
  List<Point> way = {camera.project(joint.anchor_a)};
  for (const Vec2<double>& point : joint.between) way.push_back(camera.project(point));
  way.push_back(camera.project(joint.anchor_b));
  return way;
}

void draw_ring(Page& page, const Point& at) {
  page.canvas().circle(at, page.sizes().joint,
                       {.fill = page.theme().background,
                        .outline = page.theme().joint,
                        .outline_width = page.sizes().outline});
}

/// Whether markers of the usual size would hide the bodies: there are very many, or a fair number stand upon
/// one another.
bool is_crowded(const Page& page, const Camera& camera, const Snapshot& snapshot) {
  if (snapshot.contacts.size() > many_contacts) return true;
  if (snapshot.contacts.size() <= some_contacts) return false;
  const double cell = 4 * page.sizes().contact;  // two markers wide
  std::set<std::pair<long, long>> taken;
  for (const SnapshotContact& contact : snapshot.contacts) {
    if (!is_finite(camera, contact.position)) continue;
    const Point at = camera.project(contact.position);
    taken.emplace(std::lround(at.x() / cell), std::lround(at.y() / cell));
  }
  return 4 * std::ssize(taken) < 3 * snapshot.contacts.size();
}

/// Plain dots, at most one in a square twice as wide: they cover no more than a fifth of what is behind them.
void draw_many_contacts(Page& page, const Camera& camera, const Snapshot& snapshot, const WorldLook& look) {
  const double radius = 0.5 * page.sizes().contact;
  std::set<std::pair<long, long>> taken;
  for (int i = 0; i < snapshot.contacts.size(); ++i) {
    const Vec2<double>& position = snapshot.contacts[i].position;
    if (!is_finite(camera, position)) continue;
    const Point at = camera.project(position);
    const bool is_active = i == look.active_contact;
    const bool is_first =
        taken.emplace(std::lround(at.x() / (4 * radius)), std::lround(at.y() / (4 * radius))).second;
    if (is_first || is_active) {
      page.canvas().circle(at, is_active ? page.sizes().contact : radius,
                           {.fill = is_active ? page.theme().normal : page.theme().secondary_text});
    }
  }
}

}  // namespace

void draw_penetrations(Page& page, const Camera& camera, const Snapshot& snapshot) {
  struct Marked {
    SnapshotContact contact = {};
    Rect overlap = {};
  };
  List<Marked> marked;
  for (const SnapshotContact& contact : deepest_of_pairs(camera, snapshot)) {
    const SnapshotBody* a = body_of(snapshot, contact.a);
    const SnapshotBody* b = body_of(snapshot, contact.b);
    if (a == nullptr || b == nullptr || !is_drawable(camera, a->pose) || !is_drawable(camera, b->pose))
      continue;
    marked.push_back({contact, draw_overlaps(page, camera, *a, *b, camera.project(contact.position))});
  }
  for (int i = 0; i < std::min(marked.size(), most_depths); ++i) {
    write_depth(page, camera, marked[i].contact, marked[i].overlap);
  }
}

void draw_contacts(Page& page, const Camera& camera, const Snapshot& snapshot, const WorldLook& look) {
  const Theme& theme = page.theme();
  if (is_crowded(page, camera, snapshot)) return draw_many_contacts(page, camera, snapshot, look);
  for (int i = 0; i < snapshot.contacts.size(); ++i) {
    const SnapshotContact& contact = snapshot.contacts[i];
    if (!is_finite(camera, contact.position)) continue;
    const bool is_active = i == look.active_contact;
    const bool is_apart = contact.separation * camera.scale > least_depth;  // about to touch: hollow
    Color fill = is_active ? theme.normal : theme.inactive;
    if (is_apart && !is_active) fill = theme.background;
    page.canvas().circle(
        camera.project(contact.position), contact.is_new ? page.sizes().new_contact : page.sizes().contact,
        {.fill = fill, .outline = theme.outline, .outline_width = 0.7 * page.sizes().outline});
  }
}

void draw_joint_lines(Page& page, const Camera& camera, const Snapshot& snapshot) {
  for (const SnapshotJoint& joint : snapshot.joints) {
    if (!is_seen(camera, joint)) continue;
    const Point from = camera.project(joint.anchor_a);
    const Point to = camera.project(joint.anchor_b);
    if (joint.traits.is_line) {
      const List<Point> way = way_of(camera, joint);
      for (int i = 1; i < way.size(); ++i) draw_rod(page, way[i - 1], way[i]);
      continue;
    }
    draw_arm(page, camera, body_of(snapshot, joint.a), joint.anchor_a);
    draw_arm(page, camera, body_of(snapshot, joint.b), joint.anchor_b);
    // A pin that has come apart, or a joint of another kind.
    if ((to - from).norm() > 1) {
      page.canvas().line(from, to,
                         {.width = page.sizes().outline, .color = page.theme().joint, .dash = {4, 3}});
    }
  }
}

void draw_joint_ends(Page& page, const Camera& camera, const Snapshot& snapshot) {
  for (const SnapshotJoint& joint : snapshot.joints) {
    if (!is_seen(camera, joint)) continue;
    const Point from = camera.project(joint.anchor_a);
    const Point to = camera.project(joint.anchor_b);
    const bool is_apart = (to - from).norm() > 2;
    if (joint.traits.is_line) {
      page.canvas().circle(from, 0.7 * page.sizes().joint, {.fill = page.theme().joint});
      page.canvas().circle(to, 0.7 * page.sizes().joint, {.fill = page.theme().joint});
      for (const Vec2<double>& roller : joint.between) draw_ring(page, camera.project(roller));
      continue;
    }
    draw_joint_marks(page, camera, snapshot, joint);
    const bool is_end = !(joint.traits.slides && joint.traits.has_spring);  // else the spring ends elsewhere
    if (is_end) draw_ring(page, from);
    if (is_apart || !is_end) draw_ring(page, to);
  }
}

}  // namespace cairn::render
