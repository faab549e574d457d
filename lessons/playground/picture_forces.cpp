// What is drawn over the scene: forces of contacts, velocities, the hand, and the j of a row.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <cairn/constraints/contact_rows.hpp>
#include "lessons/playground/picture.hpp"
#include "render/arrow.hpp"

namespace cairn::playground {

namespace {

using render::Point;

constexpr double arrow_share = 0.5;  // of the usual length of arrows, where other panels show the same forces
constexpr double velocity_share = 0.35;
constexpr double shortest_arrow = 8;  // [px] as in render/arrow.cpp: a shorter one would be a dot
constexpr double dot_share = 0.06;    // of a body's smaller side, for the radius of a dot
constexpr double least_dot = 1.5, largest_dot = 5;  // [px]

/// Of the last update's row, as far as the update has come [N s].
double impulse_at(const RowUpdate<double>& update, double share) {
  return update.impulse_before + share * (update.impulse_after - update.impulse_before);
}

double least_side(const SnapshotBody& body) {
  double least = std::numeric_limits<double>::infinity();  // [m]
  for (const Shape<double>& shape : body.shapes) {
    const Aabb<double> box = bounding_box<double>(shape, body.pose);
    least = std::min(least, (box.upper - box.lower).minCoeff());
  }
  return least;
}

/// Where a row pushes that is being updated, with too little for an arrow.
void draw_dot(render::Page& page, const render::Camera& camera, const Vec2<double>& at, double side) {
  const double radius = std::clamp(dot_share * side * camera.scale, least_dot, largest_dot);
  page.canvas().circle(camera.project(at), radius, {.fill = page.theme().normal});
}

/// Where a contact is [m]. The j of its normal row on body b is a direction n and the moment of n about b's
/// middle, which says how far aside the point is; that of its friction, a quarter turn aside, says how far
/// along n. Without friction it is taken to be on the side of b.
Vec2<double> point_of(const Vec3<double>& normal, const Vec3<double>* tangent, const SnapshotBody& b) {
  const Vec2<double> n = normal.head<2>(), left = perpendicular<double>(n);
  const Vec2<double> aside = b.pose.position - normal.z() * left;
  if (tangent) return aside + cross<double>(n, tangent->head<2>()) * tangent->z() * n;
  double reach = 0;
  for (const Shape<double>& shape : b.shapes) {
    const Aabb<double> box = bounding_box<double>(shape, b.pose);
    reach = std::max(reach, n.cwiseAbs().dot(box.upper - box.lower) / 2);
  }
  return aside - reach * n;
}

}  // namespace

const PerRow<double>& Picture::impulses(const Playground& playground, int number) const {
  const SolveLook& look = playground.look(number);
  return is_before(playground) ? look.given.impulse : look.impulse;
}

/// The impulses of contacts, as they are in the solve, where they push.
void Picture::draw_forces(const Playground& playground, int number, const render::Camera& camera) {
  const SolveLook& look = playground.look(number);
  const Snapshot snapshot = playground.bench(number).snapshot();
  render::ArrowScale scale = render::arrow_scale(std::max(playground.forces().largest(), 1e-9), "N", camera);
  if (has_panels_) scale.pixels_per_unit *= arrow_share;
  const int rows = look.given.row_count(), lit = playground.lit_row();
  const PerRow<double>& impulse = impulses(playground, number);
  const int updated = look.last ? look.last->row : -1;
  List<int> friction_of(rows, -1);
  for (int i = 0; i < rows; ++i) {
    const Bounds<double>& bounds = look.given.rows[i].bounds;
    const bool is_of_a_point = bounds.is_friction() && bounds.second_normal_row < 0 && !(bounds.disc > 0) &&
                               !is_rolling(look.given.rows[i]);
    if (is_of_a_point) friction_of[bounds.normal_row] = i;
  }
  for (int i = 0; i < rows; ++i) {
    const ConstraintRow<double>& row = look.given.rows[i];
    if (!row.bounds.is_unilateral() || std::abs(row.jacobian_b.head<2>().norm() - 1) > 1e-6) continue;
    const int friction = friction_of[i];
    const Vec3<double>* tangent = friction < 0 ? nullptr : &look.given.rows[friction].jacobian_b;
    const Vec2<double> tail = point_of(row.jacobian_b, tangent, snapshot.bodies[row.b]);
    const auto draw = [&](render::ArrowKind kind, int of) {
      const double force = (of == updated ? impulse_at(*look.last, moment_) : impulse[of]) / look.given.dt;
      if (std::abs(force) * scale.pixels_per_unit < shortest_arrow) {
        if (of == updated) draw_dot(*page_, camera, tail, least_side(snapshot.bodies[row.b]));
        return;
      }
      const bool is_active = lit < 0 || lit == i || lit == friction;
      render::draw_arrow(*page_, camera, scale,
                         {.kind = kind,
                          .tail = tail,
                          .value = force * look.given.rows[of].jacobian_b.head<2>(),
                          .active = is_active});
    };
    draw(render::ArrowKind::normal, i);
    if (friction >= 0) draw(render::ArrowKind::friction, friction);
  }
}

/// Of all bodies within the step under way, with the last update as far as it is drawn.
void Picture::draw_velocities(const Playground& playground, int number, const render::Camera& camera) {
  const SolveLook& look = playground.look(number);
  const Snapshot snapshot = playground.bench(number).snapshot();
  double fastest = 0;  // [m/s] before the first update
  for (const Vec3<double>& velocity : look.given.velocity)
    fastest = std::max(fastest, velocity.head<2>().norm());
  render::ArrowScale scale = render::arrow_scale(std::max(fastest, 1e-9), "m/s", camera);
  scale.pixels_per_unit *= velocity_share;
  for (const BodyId body : snapshot.bodies.indices()) {
    if (!(snapshot.bodies[body].mass > 0)) continue;
    Vec2<double> velocity = (is_before(playground) ? look.given.velocity : look.velocity)[body].head<2>();
    if (look.last) {
      const ConstraintRow<double>& row = look.given.rows[look.last->row];
      const double lacking = impulse_at(*look.last, 1) - impulse_at(*look.last, moment_);
      const auto take_back = [&](BodyId end, const Vec3<double>& j) {
        if (end == body) velocity -= lacking * look.given.inverse_mass[body].x() * j.head<2>();
      };
      take_back(row.a, row.jacobian_a);
      take_back(row.b, row.jacobian_b);
    }
    if (velocity.norm() * scale.pixels_per_unit < shortest_arrow) continue;
    render::draw_arrow(*page_, camera, scale,
                       {.kind = render::ArrowKind::velocity,
                        .tail = snapshot.bodies[body].pose.position,
                        .value = velocity});
  }
}

void Picture::draw_hand(const Bench& bench, const render::Camera& camera) {
  if (!bench.hand()) return;
  const List<Attachment> ends = bench.hand()->attachments();
  const Point target = camera.project(ends[0].anchor);
  const Point held = camera.project(bench.snapshot().bodies[ends[1].body].pose.world(ends[1].anchor));
  const render::Color color = page_->theme().external;
  page_->canvas().line(held, target, {.width = page_->sizes().arrow, .color = color});
  page_->canvas().circle(held, page_->sizes().contact, {.fill = color});
  page_->canvas().circle(target, 2 * page_->sizes().contact,
                         {.outline = color, .outline_width = page_->sizes().outline});
}

/// j of the lit row: a direction on each of its bodies.
void Picture::draw_jacobian(const Playground& playground, const render::Camera& camera) {
  const SolveLook& look = playground.look(0);
  const ConstraintRow<double>& row = look.given.rows[playground.lit_row()];
  const Snapshot snapshot = playground.bench(0).snapshot();
  const render::ArrowScale scale{.pixels_per_unit = 0.1 * camera.viewport.height,
                                 .longest = 0.2 * camera.viewport.height};
  for (const auto& [body, jacobian] : {std::pair(row.a, row.jacobian_a), std::pair(row.b, row.jacobian_b)}) {
    if (!(snapshot.bodies[body].mass > 0)) continue;
    const Vec2<double> direction = jacobian.head<2>();
    render::draw_arrow(*page_, camera, scale,
                       {.kind = render::ArrowKind::joint,
                        .tail = snapshot.bodies[body].pose.position,
                        .value = direction,
                        .label = body == row.a ? "j_{a}" : "j_{b}"});
  }
}

}  // namespace cairn::playground
