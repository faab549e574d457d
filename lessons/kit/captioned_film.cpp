// Pictures with a strip of words below them.
#include "lessons/kit/captioned_film.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <utility>

#include "lessons/kit/words.hpp"
#include "render/text_layout.hpp"

namespace cairn {
namespace {

constexpr double text_size = 17;  // [px of the page]
constexpr double margin = 20;     // [px of the page], as that of pages
constexpr double tick = 0.1;      // [s]: a frame stays for a whole number of them
constexpr int palette_size = 63;  // more can hardly be told from these, and take a tenth more bytes

List<std::string> words_of(std::string_view text) {
  std::istringstream stream{std::string(text)};
  List<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

double line_pitch() { return std::round(render::leading * text_size); }

}  // namespace

double reading_time(std::string_view caption, std::string_view before) {
  const List<std::string> earlier = words_of(before);
  const std::set<std::string> known(earlier.begin(), earlier.end());
  int fresh = 0;
  for (const std::string& word : words_of(caption)) fresh += known.count(word) == 0 ? 1 : 0;
  return tick * std::ceil((1 + 0.25 * fresh) / tick - 1e-9);
}

CaptionedFilm::CaptionedFilm(const Options& options, const render::Theme& theme, List<std::string> captions)
    : fps_(options.fps),
      scale_(std::min(options.width / 1280.0, options.height / 720.0)),
      theme_(theme),
      captions_(std::move(captions)) {
  for (std::string& caption : captions_) caption = with_minus_signs(caption);
}

double CaptionedFilm::seconds(int frame) const {
  if (fps_) return 1 / *fps_;
  return reading_time(captions_[frame], frame == 0 ? "" : captions_[frame - 1]);
}

render::Image CaptionedFilm::captioned(const render::Image& picture) {
  const render::TextStyle style = {.size = text_size, .color = theme_.text};
  const double width = std::round(picture.width / scale_) - 2 * margin;
  if (!strip_) {
    const auto height_of = [&](int lines) {
      return static_cast<int>(std::lround(scale_ * (2 * margin + lines * line_pitch())));
    };
    strip_.emplace(render::ImageSize{picture.width, height_of(1)}, scale_);
    int most = 1;
    for (const std::string& caption : captions_)
      most = std::max(most, render::wrapped(*strip_, caption, width, style).size());
    strip_.emplace(render::ImageSize{picture.width, height_of(most)}, scale_);
  }
  strip_->clear(theme_.background);
  strip_->line({0, 0.5}, {width + 2 * margin, 0.5}, {.width = 1, .color = theme_.frame_line, .dash = {}});
  double y = std::round(margin + render::cap_height * text_size);
  for (const std::string& line : render::wrapped(*strip_, captions_[next_], width, style)) {
    strip_->text({margin, y}, line, style);
    y += line_pitch();
  }
  render::Image whole = picture;
  const render::Image strip = strip_->read();
  whole.height += strip.height;
  whole.pixels.insert(whole.pixels.end(), strip.pixels.begin(), strip.pixels.end());
  return whole;
}

void CaptionedFilm::look_at(const render::Image& picture) {
  colors_.add(captioned(picture));
  ++next_;
}

void CaptionedFilm::begin(const std::filesystem::path& file) {
  film_.emplace(file, captions_.size(), fps_.value_or(1 / tick), colors_.palette(palette_size));
  next_ = 0;
}

void CaptionedFilm::add(const render::Image& picture) {
  film_->add(captioned(picture), fps_ ? 1 : static_cast<int>(std::lround(seconds(next_) / tick)));
  ++next_;
}

}  // namespace cairn
