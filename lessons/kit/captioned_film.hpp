// A lesson as one film: each frame with its caption below, for as long as that takes to read.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "lessons/kit/arguments.hpp"
#include <cairn/math/list.hpp>
#include "render/palette.hpp"
#include "render/sequence.hpp"
#include "render/theme.hpp"

namespace cairn {

/// How long a caption is shown [s], in tenths: a second, and a quarter for each word that the caption before
/// it does not have.
double reading_time(std::string_view caption, std::string_view before);

/// Takes every picture twice: first all to choose the colours, then all to write them.
class CaptionedFilm {
 public:
  /// `captions`: one for each frame. The pictures stay for 1/fps where the options say so, else for their
  /// reading_time().
  CaptionedFilm(const Options& options, const render::Theme& theme, List<std::string> captions);

  /// Takes the next picture the first time.
  void look_at(const render::Image& picture);
  /// From now on pictures are written. @throws render::WriteError
  void begin(const std::filesystem::path& file);
  /// Takes the next picture the second time. @throws render::WriteError
  void add(const render::Image& picture);
  /// Puts the film in its place. @throws render::WriteError
  void finish() { film_->finish(); }
  /// How long a frame stays [s].
  double seconds(int frame) const;

 private:
  render::Image captioned(const render::Image& picture);

  std::optional<double> fps_;
  double scale_;  // pixels of the image to one of the page
  render::Theme theme_;
  List<std::string> captions_;
  render::ColorCount colors_ = {};
  std::optional<render::Canvas> strip_ = {};  // made for the first picture
  std::optional<render::ApngWriter> film_ = {};
  int next_ = 0;
};

}  // namespace cairn
