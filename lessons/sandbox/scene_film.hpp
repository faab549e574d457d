// Frames of a film: a scene as it was at one time, once or beside itself under other settings.
#pragma once

#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "lessons/sandbox/scene_run.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>
#include "render/arrow.hpp"
#include "render/page.hpp"

namespace cairn::sandbox {

struct FilmLook {
  int width = 1280;  // [px]
  int height = 720;
  bool dark = false;
  std::set<std::string> shows = {};  // loads, contacts, velocities, trails, overlaps, numbers
  bool contacts_if_few = false;      // dots for contacts in a film that never has many
};

/// --size, --theme, --show.
List<Flag> look_flags();
/// @throws UsageError. `standard`: the size where none is asked for, such as "1280x720".
FilmLook look_of(const Words& words, const std::string& standard);

/// What of the world is to be seen.
struct FilmView {
  Aabb<double> box = {};  // [m]
  std::optional<double> bottom =
      {};  // [m] of the floor, where there is one: nothing below it is worth showing
};

/// What a film of these runs has to show: every moving body wherever it goes, short of the few that fly off,
/// and what does not move as far as it is near.
FilmView view_of(const List<SceneRun>& runs);

/// The scene's own camera, where it has one: its height whole, and of its width what there is to see.
FilmView view_of(const SceneEntry& scene, const List<SceneRun>& runs);

/// Draws one to four runs of a scene side by side.
class SceneFilm {
 public:
  static constexpr int most_panels = 4;

  /// @throws render::RenderError when nothing can be drawn. The runs must stay where they are.
  SceneFilm(const SceneEntry& scene, const List<SceneRun>& runs, const FilmLook& look);

  int frame_count() const;
  /// From 0.
  render::Image draw(int frame);
  /// What is wrong with the layout of the frame drawn last: see render/lint.hpp.
  List<std::string> findings() const;

 private:
  void draw_panel(const SceneRun& run, int frame, const render::Rect& rect);
  void draw_scene(const SceneRun& run, int frame, const render::Rect& rect);
  void draw_caption(const SceneRun& run, const std::string& ending, const std::string& errors,
                    const render::Rect& rect);
  std::string errors_text(const Snapshot& snapshot) const;
  render::Camera camera_in(const render::Rect& rect) const;

  SceneEntry scene_;
  List<const SceneRun*> runs_ = {};
  FilmLook look_;
  FilmView view_ = {};
  double largest_load_ = 0;     // [N] that arrows show
  double largest_speed_ = 0;    // [m/s]
  bool shows_overlap_ = false;  // in the caption: where there ever is one
  bool shows_drift_ = false;
  render::Page page_;
};

}  // namespace cairn::sandbox
