// One frame of a lesson as a file.
#include "lessons/kit/picture.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace cairn {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string text_of(const List<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

}  // namespace

PictureMaker::PictureMaker(const Options& options, render::Page& page)
    : options_(options),
      page_(page),
      drawing_(options.text ? render::Letters::text : render::Letters::outlines) {
  if (options_.format == Options::Format::svg) page_.canvas().record(&drawing_);
}

PictureMaker::~PictureMaker() { page_.canvas().record(nullptr); }

std::optional<render::Rect> PictureMaker::view() const {
  const render::Canvas& canvas = page_.canvas();
  if (options_.panel.empty())
    return render::Rect{0, 0, double{1} * canvas.width(), double{1} * canvas.height()};
  for (const render::PanelPlace& panel : page_.panels()) {
    if (lower(panel.title).find(lower(options_.panel)) != std::string::npos) return panel.rect;
  }
  return {};
}

render::Image PictureMaker::image(const std::function<void()>& draw) {
  draw();
  const render::Image image = page_.canvas().read();
  if (options_.panel.empty()) return image;
  const render::Rect part = view().value();
  const double scale = page_.canvas().scale();
  const int left = std::max(0, static_cast<int>(std::floor(scale * part.x)));
  const int top = std::max(0, static_cast<int>(std::floor(scale * part.y)));
  const int right = std::min(image.width, static_cast<int>(std::ceil(scale * (part.x + part.width))));
  const int bottom = std::min(image.height, static_cast<int>(std::ceil(scale * (part.y + part.height))));
  return render::part_of(image, left, top, right - left, bottom - top);
}

std::string PictureMaker::file(const std::function<void()>& draw, const std::string& alt) {
  if (options_.format == Options::Format::svg) {
    draw();
    const render::Color paper = options_.transparent ? render::transparent : page_.theme().background;
    return drawing_.file(view().value(), paper, alt);
  }
  if (!options_.transparent) return text_of(render::encode_png(image(draw)));
  page_.set_paper(render::rgb(0x000000));
  const render::Image on_black = image(draw);
  page_.set_paper(render::rgb(0xFFFFFF));
  return text_of(render::encode_transparent_png(on_black, image(draw)));
}

}  // namespace cairn
