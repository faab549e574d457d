// Checks of a page's layout that need no picture to compare with.
#include "render/lint.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cairn::render {
namespace {

constexpr double allowed_overlap = 1;  // [px] of two text boxes: their rims hold no ink

// One channel of sRGB as light (WCAG 2.2, "relative luminance").
double linear(double channel) {
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(Color color) {
  return 0.2126 * linear(static_cast<double>(color.r)) + 0.7152 * linear(static_cast<double>(color.g)) +
         0.0722 * linear(static_cast<double>(color.b));
}

Color over(Color front, Color back) {
  const float a = front.a;
  return {a * front.r + (1 - a) * back.r, a * front.g + (1 - a) * back.g, a * front.b + (1 - a) * back.b, 1};
}

bool has_halo(const TextBox& box) { return box.style.halo.a > 0; }

// "λ = 3" at (20, 30)
std::string named(const TextBox& box) {
  return fmt::format("text \"{}\" at ({:.0f}, {:.0f})", box.text, box.rect.x, box.rect.y);
}

double contrast_upon(const TextBox& box, Color back) {
  const Color behind = over(box.style.halo, back);
  return contrast(over(box.style.color, behind), behind);
}

void check_size(const TextBox& box, double smallest, List<std::string>& faults) {
  if (!(box.style.size >= smallest)) {
    faults.push_back(
        fmt::format("{} is {:.3g} px high, less than {} px", named(box), box.style.size, smallest));
  }
}

void check_place(const TextBox& box, const Canvas& canvas, List<std::string>& faults) {
  const Rect& r = box.rect;
  const bool inside =
      r.x >= 0 && r.y >= 0 && r.x + r.width <= canvas.width() && r.y + r.height <= canvas.height();
  if (!inside) faults.push_back(fmt::format("{} reaches outside the page", named(box)));
}

void check_contrast(const TextBox& box, const Theme& theme, List<std::string>& faults) {
  const double least = box.style.bold && box.style.size >= large_text ? 3 : 4.5;
  const double found = std::min(contrast_upon(box, theme.background), contrast_upon(box, theme.panel));
  if (!(found >= least)) {
    faults.push_back(
        fmt::format("{} has a contrast of {:.2f} : 1, less than {} : 1", named(box), found, least));
  }
}

bool boxes_overlap(const Rect& a, const Rect& b) {
  const double width = std::min(a.x + a.width, b.x + b.width) - std::max(a.x, b.x);
  const double height = std::min(a.y + a.height, b.y + b.height) - std::max(a.y, b.y);
  return width > allowed_overlap && height > allowed_overlap;
}

// Narrows the part [enter, leave] of a segment to where one coordinate lies between low and high.
bool narrow(double from, double to, double low, double high, double& enter, double& leave) {
  const double run = to - from;
  if (run == 0) return from > low && from < high;
  enter = std::max(enter, ((run > 0 ? low : high) - from) / run);
  leave = std::min(leave, ((run > 0 ? high : low) - from) / run);
  return enter < leave;
}

// Exact, where samples along the segment could miss a small box. A gap in the curve (NaN) meets nothing.
bool meets(const Point& from, const Point& to, const Rect& box) {
  if (!from.allFinite() || !to.allFinite()) return false;
  double enter = 0;
  double leave = 1;
  return narrow(from.x(), to.x(), box.x, box.x + box.width, enter, leave) &&
         narrow(from.y(), to.y(), box.y, box.y + box.height, enter, leave);
}

bool on_curve(const TextBox& box, const List<Point>& curve) {
  const Rect ink = inset(box.rect, allowed_overlap);
  for (int i = 1; i < curve.size(); ++i) {
    if (meets(curve[i - 1], curve[i], ink)) return true;
  }
  return false;
}

void check_curves(const TextBox& box, const Page& page, List<std::string>& faults) {
  if (has_halo(box)) return;
  const auto& curves = page.curves();
  if (std::any_of(curves.begin(), curves.end(), [&](const auto& curve) { return on_curve(box, curve); })) {
    faults.push_back(fmt::format("{} stands on a curve without a halo", named(box)));
  }
}

}  // namespace

double contrast(Color first, Color second) {
  const double a = luminance(first);
  const double b = luminance(second);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

Color ink_on(Color fill) {
  const Color black = rgb(0x000000);
  const Color white = rgb(0xFFFFFF);
  return contrast(black, fill) >= contrast(white, fill) ? black : white;
}

List<std::string> lint(const Page& page) {
  List<TextBox> boxes;
  for (const TextBox& box : page.canvas().text_boxes()) {
    if (box.text.find_first_not_of(' ') != std::string::npos) boxes.push_back(box);
  }
  List<std::string> faults;
  for (int i = 0; i < boxes.size(); ++i) {
    check_size(boxes[i], page.sizes().smallest, faults);
    check_place(boxes[i], page.canvas(), faults);
    check_contrast(boxes[i], page.theme(), faults);
    check_curves(boxes[i], page, faults);
    for (int j = i + 1; j < boxes.size(); ++j) {
      if (!boxes_overlap(boxes[i].rect, boxes[j].rect)) continue;
      faults.push_back(fmt::format("{} overlaps {}", named(boxes[i]), named(boxes[j])));
    }
  }
  return faults;
}

}  // namespace cairn::render
