// Lays the picture out, draws the scene, and finds what is at a place.
#include "lessons/playground/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <cairn/math/check.hpp>
#include <cairn/math/nearest.hpp>
#include "lessons/playground/pointing.hpp"
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
constexpr int most_pixels = 6144;        // of a side, on the screen
constexpr double finger = 8;             // [px] by which it may miss

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

void Picture::show(bool has_panels, bool all_rows) {
  has_panels_ = has_panels;
  shows_all_rows_ = all_rows;
}

void Picture::set_moment(double share) {
  require(share >= 0 && share <= 1, "picture", "moment", "from 0 to 1", share);
  moment_ = share;
}

/// Wide: the scene above the equation, bars above the curve. Narrow, or too low for four panels: one of
/// equation and curve; neither while a narrow picture is asked about a row.
Picture::Panels Picture::panels(const Playground& playground) const {
  const render::Canvas& canvas = page_->canvas();
  const Rect area = {0, 0, static_cast<double>(canvas.width()), static_cast<double>(canvas.height())};
  const double gap = page_->sizes().gap;
  const bool is_narrow = area.width < narrow * area.height;
  const std::optional<Prediction>& prediction = playground.prediction();
  const bool is_asked = prediction && !prediction->is_revealed;
  const bool is_lit = playground.lit_row() >= 0 && !is_asked;
  const bool has_panels = has_panels_ && !(is_asked && is_narrow);
  const double rest = area.height - equation_height - gap;
  Panels panels;
  Rect scenes;
  if (!has_panels) {
    const List<Rect> parts =
        is_narrow ? render::rows(area, {1.1, 1}, gap) : render::columns(area, {1, 1.1}, gap);
    scenes = parts[0];
    panels.bars = parts[1];
  } else if (is_narrow) {
    const bool has_third = is_lit || area.height > high;
    const List<double> two = {0.55, 0.45}, three = {0.55 * rest, 0.45 * rest, equation_height + gap};
    const List<Rect> parts = render::rows(area, has_third ? three : two, gap);
    scenes = parts[0];
    panels.bars = parts[1];
    if (has_third) (is_lit ? panels.equation : panels.curve) = parts[2];
  } else {
    const List<Rect> halves = render::columns(area, {playground.bench_count() > 1 ? 1.8 : 1.1, 1}, gap);
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
  render::WorldLook look{.numbers = false, .contacts = false};
  const SolveLook& solve = playground.look(number);
  const int lit = playground.lit_row();
  if (lit >= 0 && lit < solve.given.row_count()) {
    look.active_a = solve.given.rows[lit].a;
    look.active_b = solve.given.rows[lit].b;
  }
  render::draw_world(*page_, camera, snapshot, look);
  page_->canvas().push_clip(camera.viewport);
  draw_forces(playground, number, camera);
  if (!has_panels_) {
    draw_velocities(playground, number, camera);
  } else if (lit >= 0 && lit < solve.given.row_count() && number == 0) {
    draw_jacobian(playground, camera);
  }
  draw_hand(playground.bench(number), camera);
  page_->canvas().pop_clip();
  render::draw_unseen(*page_, camera, snapshot, {.names = playground.names()});
}

PictureSpot Picture::at(const Playground& playground, const Point& place) const {
  const Rect& bars = bar_places_.rows;
  // No number of a row, yet: the place may be anywhere, or not even a number.
  const double line = bar_places_.pitch > 0 ? std::floor((place.y() - bars.y) / bar_places_.pitch) : -1;
  if (line >= 0 && line < bar_count_ && place.x() >= bars.x && place.x() <= bars.x + bars.width) {
    const Rect& plot = bar_places_.plot;
    const double share = std::clamp((place.x() - plot.x) / plot.width, 0.0, 1.0);
    const double force = bar_places_.low + share * (bar_places_.high - bar_places_.low);
    const int row = lines_[first_bar_ + static_cast<int>(line)].rows[0];
    return {.kind = PictureSpot::Kind::bar, .number = row, .point = {force, 0}};
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
