// What stands where in a frame.
#include "lessons/sandbox/scene_film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/kit/words.hpp"
#include "lessons/sandbox/film_text.hpp"
#include <cairn/measure/violation.hpp>
#include "render/draw.hpp"
#include "render/lint.hpp"
#include "render/solver_style.hpp"
#include "render/text_layout.hpp"

namespace cairn::sandbox {
namespace {

using render::Rect;

constexpr double bar_height = 6;  // [px] above a panel, in the solver's colour
constexpr int few_contacts = 40;
constexpr double least_speed = 0.05;  // [m/s] of the longest arrow: what rests must not look fast
constexpr double arrow_share = 0.4;   // of the length that a lesson gives its arrows: here they are many
constexpr double arrow_room = 0.12;   // of the view's extent, on every side

render::Theme film_theme(const FilmLook& look) {
  return look.dark ? render::dark_theme() : render::light_theme();
}

/// The 95th of a hundred: one jolt must not make all other arrows dots.
double usual_largest(List<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<int>(0.95 * (values.size() - 1))];
}

double load_of(const Snapshot& snapshot) {
  double largest = 0;
  if (!(snapshot.dt > 0)) return 0;
  for (const SnapshotContact& contact : snapshot.contacts)
    largest = std::max(largest, contact.normal_impulse / snapshot.dt);
  for (const SnapshotJoint& joint : snapshot.joints)
    largest = std::max(largest, joint.impulse.norm() / snapshot.dt);
  return largest;
}

double speed_of(const Snapshot& snapshot) {
  double largest = 0;
  for (const SnapshotBody& body : snapshot.bodies) {
    if (body.type == BodyType::dynamic) largest = std::max(largest, body.velocity.head<2>().norm());
  }
  return largest;
}

/// Columns, or two rows of two.
List<Rect> panels_in(const Rect& area, int count, double gap) {
  if (count < SceneFilm::most_panels) return render::columns(area, List<double>(count, 1), gap);
  List<Rect> panels;
  for (const Rect& row : render::rows(area, {1, 1}, gap)) {
    for (const Rect& panel : render::columns(row, {1, 1}, gap)) panels.push_back(panel);
  }
  return panels;
}

render::ArrowScale many_arrows(double largest, const std::string& unit, const render::Camera& camera) {
  render::ArrowScale scale = render::arrow_scale(largest, unit, camera);
  scale.pixels_per_unit *= arrow_share;
  return scale;
}

/// A line that is made to fit.
void write_fitted(render::Page& page, const render::Point& at, double width, const std::string& text,
                  render::TextStyle style) {
  style = render::shrunk(page.canvas(), text, width, style, page.sizes().smallest);
  page.canvas().text(at, render::ellipsized(page.canvas(), text, width, style), style);
}

}  // namespace

List<Flag> look_flags() {
  return {{"size", "WxH", "of a picture [px], or small (960x540), medium (1280x720), large (1920x1080)"},
          {"theme", "WHICH", "light or dark (light)"},
          {"show", "WHAT,WHAT",
           "loads, contacts, velocities, trails, overlaps, numbers or none (contacts, where they are few)",
           true}};
}

FilmLook look_of(const Words& words, const std::string& standard) {
  FilmLook look;
  std::string size = words.text("size").value_or(standard);
  if (size == "small") size = "960x540";
  if (size == "medium") size = "1280x720";
  if (size == "large") size = "1920x1080";
  const std::size_t cross = size.find('x');
  const double width = parse_number(size.substr(0, cross)).value_or(0);
  const double height = cross == std::string::npos ? 0 : parse_number(size.substr(cross + 1)).value_or(0);
  const auto is_side = [](double side, double least) {
    return std::trunc(side) == side && side >= least && side <= 7680;
  };
  if (!is_side(width, 320) || !is_side(height, 180)) {
    words.refuse("size", "small, medium, large, or from 320x180 to 7680x7680", size);
  }
  look.width = static_cast<int>(width);
  look.height = static_cast<int>(height);
  look.dark = words.word("theme", "light", {"light", "dark"}) == "dark";
  const List<std::string> known = {"loads",    "contacts", "velocities", "trails",
                                   "overlaps", "numbers",  "none"};
  look.contacts_if_few = !words.has("show");
  for (const std::string& what : words.texts("show")) {
    if (std::find(known.begin(), known.end(), what) == known.end()) {
      const std::string meant = nearest(what, known);
      words.refuse("show", "of " + joined(known, ", "),
                   what + (meant.empty() ? "" : "; did you mean " + meant + "?"));
    }
    look.shows.insert(what);
  }
  return look;
}

SceneFilm::SceneFilm(const SceneEntry& scene, const List<SceneRun>& runs, const FilmLook& look)
    : scene_(scene), look_(look), page_(look.width, look.height, film_theme(look)) {
  List<double> loads, speeds;
  int most_contacts = 0;
  for (const SceneRun& run : runs) {
    runs_.push_back(&run);
    for (const Snapshot& snapshot : run.frames) {
      loads.push_back(load_of(snapshot));
      speeds.push_back(speed_of(snapshot));
      most_contacts = std::max(most_contacts, snapshot.contacts.size());
      shows_overlap_ = shows_overlap_ || !snapshot.contacts.empty();
      shows_drift_ = shows_drift_ || worst_joint_drift(snapshot) > 0;
    }
  }
  view_ = view_of(scene, runs);
  if (look_.shows.count("loads") + look_.shows.count("velocities") > 0) {
    const double room = arrow_room * (view_.box.upper - view_.box.lower).maxCoeff();
    view_.box.lower.array() -= room;
    view_.box.upper.array() += room;
  }
  if (look_.contacts_if_few && most_contacts <= few_contacts) look_.shows.insert("contacts");
  largest_load_ = usual_largest(loads);
  largest_speed_ = std::max(usual_largest(speeds), least_speed);
}

int SceneFilm::frame_count() const {
  int count = 0;
  for (const SceneRun* run : runs_) count = std::max(count, run->frames.size());
  return count;
}

render::Camera SceneFilm::camera_in(const Rect& rect) const {
  render::Camera camera = render::fit(rect, view_.box);
  if (!view_.bottom) return camera;
  // A floor stands on the lower edge of the picture, wherever the shape of the panel leaves room below it.
  const double seen = camera.center.y() - rect.height / 2 / camera.scale;
  camera.center.y() += std::max(0.0, *view_.bottom - seen);
  return camera;
}

render::Image SceneFilm::draw(int frame) {
  const SceneRun* longest = runs_.front();
  for (const SceneRun* run : runs_) longest = run->frames.size() > longest->frames.size() ? run : longest;
  const Snapshot& now = longest->frames[frame];
  page_.begin({.title = scene_.title,
               .state = time_text(now, longest->frames.back()),
               .frame = frame,
               .frames = frame_count()});
  const Rect area = page_.area();
  const List<Rect> panels = panels_in(area, runs_.size(), page_.sizes().gap);
  for (int i = 0; i < runs_.size(); ++i) draw_panel(*runs_[i], frame, panels[i]);
  return page_.canvas().read();
}

List<std::string> SceneFilm::findings() const { return render::lint(page_); }

void SceneFilm::draw_panel(const SceneRun& run, int frame, const Rect& rect) {
  const render::Theme& theme = page_.theme();
  const double line = std::round(1.5 * page_.sizes().label);
  const bool is_alone = runs_.size() == 1;
  const Rect world = {rect.x, rect.y, rect.width, rect.height - (is_alone ? 1.2 : 2.2) * line};
  page_.canvas().rect({rect.x + 0.5, rect.y + 0.5, rect.width - 1, world.height - 1},
                      {.fill = theme.panel, .outline = theme.frame_line, .outline_width = 1});
  if (!is_alone) {
    page_.canvas().rect({rect.x, rect.y, rect.width, bar_height},
                        {.fill = render::style_of_solver(theme, run.setting.solver).color});
  }
  const double top = is_alone ? 1 : bar_height;
  const bool is_over = frame >= run.frames.size();
  const bool is_at_end = frame + 1 >= run.frames.size();
  if (!run.frames.empty()) {
    draw_scene(run, std::min(frame, run.frames.size() - 1),
               {world.x + 1, world.y + top, world.width - 2, world.height - top - 1});
  }
  const Rect below = {rect.x, rect.y + world.height, rect.width, rect.height - world.height};
  std::string errors;
  if (is_over) {
    errors = fmt::format("{} after {:.3g} s", status_text(run.result.status), run.result.seconds);
  } else {
    errors = errors_text(run.frames[frame]);
  }
  draw_caption(run, is_at_end ? ending_text(scene_, run) : "", errors, below);
}

void SceneFilm::draw_scene(const SceneRun& run, int frame, const Rect& rect) {
  const Snapshot& snapshot = run.frames[frame];
  const render::Camera camera = camera_in(rect);
  if (look_.shows.count("trails") != 0) {
    for (const BodyId body : snapshot.bodies.indices()) {
      if (snapshot.bodies[body].type != BodyType::dynamic) continue;
      List<Vec2<double>> path;
      for (int k = 0; k <= frame; ++k) path.push_back(run.frames[k].bodies[body].pose.position);
      render::draw_trail(page_, camera, path, {.color = page_.theme().velocity});
    }
  }
  render::WorldLook look{.numbers = look_.shows.count("numbers") != 0};
  look.penetration = look_.shows.count("overlaps") != 0;
  look.contacts = look_.shows.count("contacts") != 0;
  render::draw_world(page_, camera, snapshot, look);
  if (look_.shows.count("loads") != 0) {
    const render::ArrowScale scale = many_arrows(largest_load_, "N", camera);
    render::draw_contact_forces(page_, camera, scale, snapshot);
    render::draw_joint_forces(page_, camera, scale, snapshot);
  }
  if (look_.shows.count("velocities") != 0) {
    render::draw_velocities(page_, camera, many_arrows(largest_speed_, "m/s", camera), snapshot);
  }
  render::draw_unseen(page_, camera, snapshot, {.names = scene_.body_names});
}

std::string SceneFilm::errors_text(const Snapshot& snapshot) const {
  std::string text;
  if (shows_overlap_) text = "overlap " + error_text(worst_penetration(snapshot));
  if (!shows_drift_) return text;
  return text + (text.empty() ? "" : "  ") + "drift " + error_text(worst_joint_drift(snapshot));
}

/// The setting, and the errors beside it; where a run has ended badly, its ending in place of one of them.
void SceneFilm::draw_caption(const SceneRun& run, const std::string& ending, const std::string& errors,
                             const Rect& rect) {
  const double line = std::round(1.5 * page_.sizes().label);
  const double base = rect.y + std::round(0.95 * line);
  render::TextStyle left = page_.label();
  render::TextStyle right = page_.value();
  right.color = page_.theme().secondary_text;
  render::TextStyle end = left;
  end.bold = true;
  if (runs_.size() > 1) {
    write_fitted(page_, {rect.x, base}, rect.width, setting_text(run.setting), left);
    const bool has_ended = !ending.empty();
    write_fitted(page_, {rect.x, base + line}, rect.width, has_ended ? ending : errors,
                 has_ended ? end : right);
    return;
  }
  right.align = render::Align::right;
  const double used = page_.canvas().text_width(errors, right) + page_.sizes().gap;
  page_.canvas().text({rect.x + rect.width, base}, errors, right);
  if (ending.empty()) {
    write_fitted(page_, {rect.x, base}, rect.width - used, setting_text(run.setting), left);
  } else {
    write_fitted(page_, {rect.x, base}, rect.width - used, ending, end);
  }
}

}  // namespace cairn::sandbox
