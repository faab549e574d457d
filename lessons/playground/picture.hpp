// The playground's picture: the scene beside its rows.
#pragma once

#include <memory>
#include <string>

#include <cairn/math/list.hpp>
#include "lessons/playground/bar_lines.hpp"
#include "lessons/playground/playground.hpp"
#include "render/arrow.hpp"
#include "render/bars.hpp"
#include "render/camera.hpp"
#include "render/page.hpp"

namespace cairn::playground {

/// What is at a place of the picture.
struct PictureSpot {
  enum class Kind { nothing, scene, bar };

  Kind kind = Kind::nothing;
  int number = -1;              // of the body there, -1: none; or of the row
  Vec2<double> point = {0, 0};  // [m] in the scene; on a bar x is a force [N]
};

class Picture {
 public:
  /// @throws render::RenderError where nothing can be drawn on.
  Picture();

  /// [px], each of them `scale` pixels of the screen wide. @throws std::invalid_argument unless at least 320
  /// x 180, for more than 6144 pixels of the screen a side, or for a scale that Canvas refuses.
  void resize(int width, int height, double scale);
  /// "light" or "dark". @throws std::invalid_argument for another word.
  void choose_theme(const std::string& theme);

  /// Whether residuals and the equation of a row are beside scene and bars, as at first; and whether rows of
  /// friction have bars, and every row its own, too.
  void show(bool has_panels, bool all_rows);
  /// How much of the last row update is drawn, from 0 to 1, as at first: for a picture that moves.
  void set_moment(double share);

  void draw(const Playground& playground);
  /// Shows the scenes larger by this factor, around a place of the picture that was drawn last [px].
  /// @throws std::invalid_argument unless the factor is > 0 and finite, and the place is finite.
  void zoom(double factor, const render::Point& place);
  /// Moves them by so much [px]. @throws std::invalid_argument unless it is finite.
  void pan(const render::Point& by);
  /// Shows all of them, as at first.
  void show_all();

  /// Of the picture that was drawn last.
  PictureSpot at(const Playground& playground, const render::Point& place) const;
  /// Where a point of the scene [m] is on it.
  render::Point place(const Vec2<double>& point) const;
  /// The part of the scene that it shows, but for a narrow border [m].
  Aabb<double> room() const;
  /// What was drawn.
  render::Page& page() { return *page_; }

 private:
  /// The panels of a frame.
  struct Panels {
    List<render::Rect> scenes = {};  // one for each world
    render::Rect bars = {}, curve = {}, equation = {};
  };

  void begin(int width, int height, double scale, bool is_dark);
  Panels panels(const Playground& playground) const;
  void draw_scene(const Playground& playground, int number, const render::Rect& rect);
  void draw_forces(const Playground& playground, int number, const render::Camera& camera);
  void draw_velocities(const Playground& playground, int number, const render::Camera& camera);
  void draw_hand(const Bench& bench, const render::Camera& camera);
  void draw_jacobian(const Playground& playground, const render::Camera& camera);
  /// Before its first row update, where nothing but scene and bars is shown: what is to be seen has yet to
  /// begin.
  bool is_before(const Playground& playground) const { return !has_panels_ && !playground.cursor(); }
  const PerRow<double>& impulses(const Playground& playground, int number) const;
  render::Bar bar_of(const Playground& playground, const BarLine& line) const;
  void choose_lines(const Playground& playground, const render::Rect& rect);
  std::string bars_title(const Playground& playground) const;
  ForceRange range_of(const Playground& playground) const;
  void draw_rows(const Playground& playground, const render::Rect& rect);
  void draw_residuals(const Playground& playground, const render::Rect& rect);
  void draw_equation(const Playground& playground, const render::Rect& rect);

  bool is_dark_ = false;
  std::unique_ptr<render::Page> page_;
  List<render::Camera> cameras_;
  double zoom_ = 1;
  Vec2<double> shift_ = {0, 0};  // [m] of the middle of the scenes
  render::BarPlaces bar_places_;
  List<BarLine> lines_;
  int first_bar_ = 0;  // the line of the first bar
  int bar_count_ = 0;
  bool has_panels_ = true;
  bool shows_all_rows_ = false;
  double moment_ = 1;
};

}  // namespace cairn::playground
