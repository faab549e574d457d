// A frame's zones, its header and footer, panels, and how rectangles are divided.
#include "render/page.hpp"

#include <algorithm>
#include <cmath>

#include <cairn/math/check.hpp>
#include "render/text_layout.hpp"

namespace cairn::render {

namespace {

int checked(int pixels, int least, const char* field) {
  require(pixels >= least, "Page", field, "at least " + std::to_string(least) + " px", pixels);
  return pixels;
}

/// 1, 2, 5, 10, 20, ... frames: the first step whose ticks stand at least `apart` px from one another.
int tick_step(double frame_pitch, double apart) {
  for (int decade = 1; decade <= 100'000'000; decade *= 10) {
    for (const int factor : {1, 2, 5}) {
      if (factor * decade * frame_pitch >= apart) return factor * decade;
    }
  }
  return 1'000'000'000;
}

void draw_ticks(Canvas& canvas, const Point& start, double length, int intervals, double half, Color color) {
  const double pitch = length / intervals;
  const int small = tick_step(pitch, 8);
  const int large = tick_step(pitch, 48);
  for (int i = 0; i <= intervals; i += small) {
    const bool tall = i % large == 0;
    const double x = std::round(start.x() + i * pitch - 0.5) + 0.5;
    const double reach = tall ? half : 0.5 * half;
    canvas.line({x, start.y() - reach}, {x, start.y() + reach}, {.width = 1, .color = color, .dash = {}});
    if (i > intervals - small) break;  // no overflow when the step is huge
  }
}

/// A line with a tick per frame, the part done thicker, a dot at the current frame.
void draw_scrubber(Canvas& canvas, const Theme& theme, const Sizes& sizes, const Header& header) {
  const double y = std::round(canvas.height() - sizes.footer / 2);
  const double length = canvas.width() - 2 * sizes.margin;
  const int frame = std::clamp(header.frame, 0, header.frames - 1);
  const double x = sizes.margin + length * frame / (header.frames - 1);
  const double radius = 0.25 * sizes.footer;
  const Point start(sizes.margin, y);
  draw_ticks(canvas, start, length, header.frames - 1, 0.8 * radius, theme.inactive);
  canvas.line(start, {sizes.margin + length, y}, {.width = 2, .color = theme.frame_line, .dash = {}});
  canvas.line(start, {x, y}, {.width = 0.6 * radius, .color = theme.secondary_text, .dash = {}});
  canvas.circle({x, y}, radius, {.fill = theme.secondary_text});
}

/// Number and title on the left, the state on the right in what room they leave.
void draw_header(Canvas& canvas, const Theme& theme, const Sizes& sizes, const Header& header) {
  const double baseline = std::round(baseline_around(0.54 * sizes.header, sizes.title));
  const double right = canvas.width() - sizes.margin;
  TextStyle state = {.size = sizes.state, .color = theme.secondary_text, .mono = true, .align = Align::right};
  TextStyle title = {.size = sizes.title, .color = theme.secondary_text, .bold = true};
  double x = sizes.margin;
  if (!header.number.empty()) {
    canvas.text({x, baseline}, header.number, title);
    x += canvas.text_width(header.number, title) + 0.55 * title.size;
  }
  // A long title leaves the state a third of the line, or what its smallest type needs if that is less.
  const double between = 1.5 * sizes.title;
  TextStyle smallest = state;
  smallest.size = sizes.smallest;
  double kept = 0;
  if (!header.state.empty()) {
    kept = std::min(canvas.text_width(header.state, smallest), (right - sizes.margin) / 3) + between;
  }
  title.color = theme.text;
  title = shrunk(canvas, header.title, right - kept - x, title, std::min(title.size, 14.0));
  const std::string shown = ellipsized(canvas, header.title, right - kept - x, title);
  if (!shown.empty()) canvas.text({x, baseline}, shown, title);
  x += canvas.text_width(shown, title);
  if (header.state.empty()) return;
  const double room = right - x - between;
  state = shrunk(canvas, header.state, room, state, sizes.smallest);
  canvas.text({right, baseline}, ellipsized(canvas, header.state, room, state), state);
}

}  // namespace

Page::Page(const ImageSize& image, const Theme& theme)
    : canvas_({checked(image.width, 960, "width"), checked(image.height, 540, "height")},
              std::min(image.width / 1280.0, image.height / 720.0)),
      theme_(theme),
      sizes_(sizes_for(canvas_.height())),
      paper_(theme.background) {
  sizes_.smallest = 15;  // 11 px and more of the smallest image
  canvas_.clear(paper_);
}

Page::Page(int width, int height, const Theme& theme, double scale)
    : canvas_(checked(width, 320, "width"), checked(height, 180, "height"), scale),
      theme_(theme),
      sizes_(sizes_for(height)),
      paper_(theme.background) {
  canvas_.clear(paper_);
}

void Page::begin(const Header& header) {
  canvas_.clear(paper_);
  panels_.clear();
  curves_.clear();
  avoided_.clear();
  draw_header(canvas_, theme_, sizes_, header);
  if (header.frames > 1) draw_scrubber(canvas_, theme_, sizes_, header);
}

Rect Page::area() const {
  const double top = sizes_.header + sizes_.gap / 2;
  const double bottom = canvas_.height() - sizes_.footer - sizes_.gap;
  return {sizes_.margin, top, canvas_.width() - 2 * sizes_.margin, bottom - top};
}

TextStyle Page::label() const { return {.size = sizes_.label, .color = theme_.text}; }

TextStyle Page::secondary() const { return {.size = sizes_.label, .color = theme_.secondary_text}; }

TextStyle Page::value() const { return {.size = sizes_.label, .color = theme_.text, .mono = true}; }

TextStyle Page::tick() const { return {.size = sizes_.tick, .color = theme_.secondary_text}; }

Rect Page::panel(const Rect& rect, std::string_view title) {
  // On pixel centres a line of 1 px is one row of pixels, not two pale ones.
  const double x = std::floor(rect.x) + 0.5, y = std::floor(rect.y) + 0.5;
  const Rect frame = {x, y, std::floor(rect.x + rect.width) - 0.5 - x,
                      std::floor(rect.y + rect.height) - 0.5 - y};
  canvas_.rect(frame, {.fill = theme_.panel, .outline = theme_.frame_line, .outline_width = 1});
  Rect inner = inset(rect, sizes_.padding);
  if (title.empty()) return inner;
  panels_.push_back({std::string(title), {frame.x - 0.5, frame.y - 0.5, frame.width + 1, frame.height + 1}});
  const TextStyle style = shrunk(canvas_, title, inner.width, secondary(), sizes_.smallest);
  const double baseline = std::round(inner.y + 0.85 * sizes_.label);
  canvas_.text({inner.x, baseline}, ellipsized(canvas_, title, inner.width, style), style);
  const double used = baseline + (title_pitch - 0.85) * sizes_.label - inner.y;
  inner.y += used;
  inner.height = std::max(0.0, inner.height - used);
  return inner;
}

List<Rect> columns(const Rect& rect, const List<double>& weights, double gap) {
  double sum = 0;
  for (const double weight : weights) sum += weight;
  require(weights.empty() || sum > 0, "columns", "weights", "of positive sum", sum);
  const double gaps = weights.empty() ? 0 : gap * (weights.size() - 1);
  List<Rect> parts;
  double x = rect.x;
  for (const double weight : weights) {
    const double width = (rect.width - gaps) * weight / sum;
    parts.push_back({x, rect.y, width, rect.height});
    x += width + gap;
  }
  return parts;
}

List<Rect> rows(const Rect& rect, const List<double>& weights, double gap) {
  List<Rect> parts;
  for (const Rect& part : columns({rect.y, rect.x, rect.height, rect.width}, weights, gap)) {
    parts.push_back({part.y, part.x, part.height, part.width});
  }
  return parts;
}

Rect inset(const Rect& rect, double by) {
  return {rect.x + by, rect.y + by, std::max(0.0, rect.width - 2 * by), std::max(0.0, rect.height - 2 * by)};
}

}  // namespace cairn::render
