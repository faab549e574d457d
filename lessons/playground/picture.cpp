// Lays the picture out, draws the scene, and finds what is at a place.
#include "lessons/playground/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <cairn/constraints/contact_rows.hpp>
#include <cairn/math/check.hpp>
#include <cairn/math/nearest.hpp>
#include "lessons/playground/pointing.hpp"
#include "render/arrow.hpp"
#include "render/draw.hpp"

namespace cairn::playground {

namespace {

using render::Page;
using render::Point;
using render::Rect;

constexpr double narrow =
    1.1;                      // a picture no wider than so many times its height has the rows below the scene
constexpr double high = 680;  // [px] a narrow picture this high has room for a curve
constexpr double equation_height = 150;  // [px]
constexpr double arrow_share = 0.5;
constexpr int most_pixels = 6144;  // of a side, on the screen
constexpr double finger = 8;       // [px] by which it may miss

/// What a scene shows at first, wherever its bodies go later: the height that its file asks for, as wide as
/// its bodies need.
Aabb<double> view_of(const Playground& playground) {
  const Aabb<double> bodies = render::bounds_of(FixedList<Snapshot, 1>{playground.first()});
  const std::optional<SceneCamera>& camera = playground.entry().camera;
  if (!camera) return bodies;
  const double middle = camera->center.x();
  const double reach = std::max(bodies.upper.x() - middle, middle - bodies.lower.x());
  const double half_width =
      std::clamp(reach + 0.05 * camera->height, 0.6 * camera->height, 0.9 * camera->height);
  const Vec2<double> half(half_width, camera->height / 2);
  return {camera->center - half, camera->center + half};
}

/// How far the body is aside that is farthest from where the other world has it.
std::string gap_text(const Snapshot& one, const Snapshot& other) {
  double largest = 0;  // [m]
  for (const BodyId body : one.bodies.indices()) {
    largest = std::max(largest, (one.bodies[body].pose.position - other.bodies[body].pose.position).norm());
  }
  return render::significant(1000 * largest, 2) + " mm";
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

Picture::Picture() { begin(1280, 720, 1, false); }

void Picture::begin(int width, int height, double scale, bool is_dark) {
  page_ =
      std::make_unique<Page>(width, height, is_dark ? render::dark_theme() : render::light_theme(), scale);
  is_dark_ = is_dark;
}

void Picture::resize(int width, int height, double scale) {
  for (const auto& [name, side] : {std::pair("width", width), std::pair("height", height)})
    require(scale * side <= most_pixels, "picture", name,
            fmt::format("at most {} px of the screen", most_pixels), side);
  const render::Canvas& now = page_->canvas();
  const bool is_same = width == now.width() && height == now.height() && scale == now.scale();
  if (!is_same) begin(width, height, scale, is_dark_);
}

void Picture::choose_theme(const std::string& theme) {
  require_known(theme, {"light", "dark"}, "picture", "theme");
  const render::Canvas& now = page_->canvas();
  if (is_dark_ != (theme == "dark")) begin(now.width(), now.height(), now.scale(), theme == "dark");
}

/// Wide: the scene above the equation, bars above the curve. Narrow, or too low for four panels: one of
/// equation and curve.
Picture::Panels Picture::panels(const Playground& playground) const {
  const render::Canvas& canvas = page_->canvas();
  const Rect area = {0, 0, static_cast<double>(canvas.width()), static_cast<double>(canvas.height())};
  const double gap = page_->sizes().gap;
  const bool is_narrow = area.width < narrow * area.height;
  const bool is_lit = playground.lit_row() >= 0;
  const double rest = area.height - equation_height - gap;
  Panels panels;
  Rect scenes;
  if (is_narrow) {
    const bool has_third = is_lit || area.height > high;
    const List<double> two = {0.55, 0.45}, three = {0.55 * rest, 0.45 * rest, equation_height + gap};
    const List<Rect> parts = render::rows(area, has_third ? three : two, gap);
    scenes = parts[0];
    panels.bars = parts[1];
    if (has_third) (is_lit ? panels.equation : panels.curve) = parts[2];
  } else {
    const List<Rect> halves = render::columns(area, {1.1, 1}, gap);
    const List<Rect> left = render::rows(halves[0], {rest, equation_height}, gap);
    const List<Rect> right = render::rows(halves[1], {1.5, 1}, gap);
    const bool is_low = page_->compact();
    scenes = is_low ? halves[0] : left[0];
    panels.bars = right[0];
    if (!is_low || !is_lit) panels.curve = right[1];
    if (!is_low || is_lit) panels.equation = is_low ? right[1] : left[1];
  }
  const List<double> equal(playground.bench_count(), 1);
  const bool are_beside = scenes.width > scenes.height;
  panels.scenes = are_beside ? render::columns(scenes, equal, gap) : render::rows(scenes, equal, gap);
  return panels;
}

void Picture::draw(const Playground& playground) {
  page_->begin({});
  const Panels panels = this->panels(playground);
  cameras_.clear();
  for (int i = 0; i < panels.scenes.size(); ++i) draw_scene(playground, i, panels.scenes[i]);
  draw_rows(playground, panels.bars);
  if (panels.curve.width > 0) draw_residuals(playground, panels.curve);
  if (panels.equation.width > 0) draw_equation(playground, panels.equation);
}

void Picture::draw_scene(const Playground& playground, int number, const Rect& rect) {
  const bool is_alone = playground.bench_count() == 1;
  const std::string solver =
      number == 0 ? playground.controls().setting.solver : *playground.controls().other;
  const Snapshot snapshot = playground.bench(number).snapshot();
  std::string title = is_alone ? "" : solver;
  if (number == 1) title += ", " + gap_text(playground.bench(0).snapshot(), snapshot) + " apart";
  const Rect inside = page_->panel(rect, title);
  render::Camera camera = render::fit(inside, view_of(playground));
  camera.scale *= zoom_;
  camera.center += shift_;
  cameras_.push_back(camera);
  render::WorldLook look{.numbers = false};
  const SolveLook& solve = playground.look(number);
  const int lit = playground.lit_row();
  if (lit >= 0 && lit < solve.given.row_count()) {
    look.active_a = solve.given.rows[lit].a;
    look.active_b = solve.given.rows[lit].b;
  }
  render::draw_world(*page_, camera, snapshot, look);
  page_->canvas().push_clip(camera.viewport);
  draw_forces(playground, number, camera);
  if (lit >= 0 && lit < solve.given.row_count() && number == 0) draw_jacobian(playground, camera);
  draw_hand(playground.bench(number), camera);
  page_->canvas().pop_clip();
  render::draw_unseen(*page_, camera, snapshot, {.names = playground.names()});
}

/// The impulses of contacts, as they are in the solve, where they push.
void Picture::draw_forces(const Playground& playground, int number, const render::Camera& camera) {
  const SolveLook& look = playground.look(number);
  const Snapshot snapshot = playground.bench(number).snapshot();
  render::ArrowScale scale = render::arrow_scale(std::max(playground.forces().largest(), 1e-9), "N", camera);
  scale.pixels_per_unit *= arrow_share;
  const int rows = look.given.row_count(), lit = playground.lit_row();
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
      const Vec2<double> value = look.impulse[of] / look.given.dt * look.given.rows[of].jacobian_b.head<2>();
      const bool is_active = lit < 0 || lit == i || lit == friction;
      render::draw_arrow(*page_, camera, scale,
                         {.kind = kind, .tail = tail, .value = value, .active = is_active});
    };
    draw(render::ArrowKind::normal, i);
    if (friction >= 0) draw(render::ArrowKind::friction, friction);
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

PictureSpot Picture::at(const Playground& playground, const Point& place) const {
  const Rect& bars = bar_places_.rows;
  // No number of a row, yet: the place may be anywhere, or not even a number.
  const double line = bar_places_.pitch > 0 ? std::floor((place.y() - bars.y) / bar_places_.pitch) : -1;
  if (line >= 0 && line < bar_count_ && place.x() >= bars.x && place.x() <= bars.x + bars.width) {
    const Rect& plot = bar_places_.plot;
    const double share = std::clamp((place.x() - plot.x) / plot.width, 0.0, 1.0);
    const double force = bar_places_.low + share * (bar_places_.high - bar_places_.low);
    return {
        .kind = PictureSpot::Kind::bar, .number = first_bar_ + static_cast<int>(line), .point = {force, 0}};
  }
  for (int i = 0; i < cameras_.size(); ++i) {
    const Rect& view = cameras_[i].viewport;
    const bool is_within = place.x() >= view.x && place.x() <= view.x + view.width && place.y() >= view.y &&
                           place.y() <= view.y + view.height;
    if (!is_within) continue;
    const Vec2<double> point = cameras_[i].unproject(place);
    // A finger misses thin bodies.
    const std::optional<BodyId> body =
        body_at(playground.bench(i).snapshot(), point, finger / cameras_[i].scale);
    return {.kind = PictureSpot::Kind::scene, .number = body ? body->index : -1, .point = point};
  }
  return {};
}

Point Picture::place(const Vec2<double>& point) const {
  return cameras_.empty() ? Point(0, 0) : cameras_[0].project(point);
}

}  // namespace cairn::playground
