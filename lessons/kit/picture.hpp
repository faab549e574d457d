// One frame of a lesson as a file: PNG or SVG, all of it or one panel, on the theme's background or on none.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "lessons/kit/arguments.hpp"
#include <cairn/math/list.hpp>
#include "render/image.hpp"
#include "render/page.hpp"
#include "render/svg.hpp"

namespace cairn {

/// Draws frames in the form that the options ask for.
class PictureMaker {
 public:
  PictureMaker(const Options& options, render::Page& page);
  ~PictureMaker();
  PictureMaker(const PictureMaker&) = delete;
  PictureMaker& operator=(const PictureMaker&) = delete;

  /// What of the page as it is drawn now is wanted [px of the page]; nothing where it has no such panel.
  std::optional<render::Rect> view() const;
  /// The picture that `draw` draws on the page, of which view() must not be nothing.
  render::Image image(const std::function<void()>& draw);
  /// The bytes of its file. `alt` says what it shows.
  std::string file(const std::function<void()>& draw, const std::string& alt);

 private:
  const Options& options_;
  render::Page& page_;
  render::SvgDrawing drawing_;
};

}  // namespace cairn
