// Panels that hold text: an equation with its numbers, a question or an answer.
#include <algorithm>
#include <cmath>

#include "math/list.hpp"
#include "render/page.hpp"
#include "render/text_layout.hpp"

namespace cairn::render {

namespace {

struct PlacedLine {
  Point at = {0, 0};
  std::string text = {};
  TextStyle style = {};
};

struct EquationLayout {
  List<PlacedLine> lines = {};
  bool fits = true;
};

/// What of an equation is shown, and where its number stands.
enum class EquationParts { all, number_beside, without_remarks, symbols_and_result };

/// How an equation panel is set: tried from the most generous to the tightest.
struct EquationType {
  double size = 26;    // [px]
  double pitch = 1.6;  // of the lines, as a part of the em
  EquationParts parts = EquationParts::all;
};

/// Where the "=" of the first line stands: the lines below it begin there.
double equals_offset(const Canvas& canvas, const std::string& symbols, const TextStyle& style) {
  const std::size_t at = symbols.find(" = ");
  return at == std::string::npos ? 0 : canvas.text_width(symbols.substr(0, at + 1), style);
}

class EquationSetter {
 public:
  EquationSetter(const Page& page, const Rect& inner, const Equation& equation, const EquationType& type)
      : page_(page),
        inner_(inner),
        equation_(equation),
        type_(type),
        top_(inner.y),
        bottom_(inner.y + inner.height) {}

  EquationLayout set() {
    if (type_.parts == EquationParts::all || type_.parts == EquationParts::number_beside) {
      set_number();
      set_algorithm();
    }
    const TextStyle plain = {.size = type_.size, .color = page_.theme().text};
    TextStyle result = plain;
    result.bold = true;
    if (equation_.color.a > 0 && type_.size >= large_text) result.color = equation_.color;
    double baseline = top_ + 1.05 * type_.size;
    const double offset = equals_offset(page_.canvas(), equation_.symbols, plain);
    const double offset_inside = std::min(offset, 0.25 * inner_.width);
    set_line(equation_.symbols, 0, plain, baseline);
    if (type_.parts != EquationParts::symbols_and_result) {
      set_line(equation_.numbers, equation_.numbers.starts_with("=") ? offset_inside : 0, plain, baseline);
    }
    set_line(equation_.result, equation_.result.starts_with("=") ? offset_inside : 0, result, baseline);
    const double last = baseline - type_.pitch * type_.size;
    if (last + 0.3 * type_.size > bottom_) layout_.fits = false;
    return layout_;
  }

 private:
  void set_number() {
    if (equation_.number.empty()) return;
    TextStyle small = page_.secondary();
    const double baseline = std::round(top_ + 0.85 * small.size);
    if (type_.parts == EquationParts::all) {
      layout_.lines.push_back({{inner_.x, baseline}, equation_.number, small});
      top_ = baseline + 0.6 * small.size;
      return;
    }
    small.align = Align::right;
    layout_.lines.push_back({{inner_.x + inner_.width, baseline}, equation_.number, small});
    const TextStyle plain = {.size = type_.size};
    const double beside = page_.canvas().text_width(equation_.number, small) + 2 * small.size;
    if (page_.canvas().text_width(equation_.symbols, plain) + beside > inner_.width) layout_.fits = false;
  }

  void set_algorithm() {
    if (equation_.algorithm.empty()) return;
    TextStyle small = page_.secondary();
    small.mono = true;
    small.size = std::min(small.size, type_.size);
    small = shrunk(page_.canvas(), equation_.algorithm, inner_.width, small, page_.sizes().smallest);
    const List<std::string> lines = wrapped(page_.canvas(), equation_.algorithm, inner_.width, small);
    const double pitch = std::round(1.35 * small.size);
    double baseline = std::round(bottom_ - 0.2 * small.size) - pitch * (lines.size() - 1);
    bottom_ = baseline - 1.1 * small.size;
    for (const std::string& line : lines) {
      layout_.lines.push_back({{inner_.x, baseline}, line, small});
      baseline += pitch;
    }
  }

  /// Only the smallest type is wrapped; a larger one that is too wide does not fit.
  void set_line(const std::string& text, double indent, const TextStyle& style, double& baseline) {
    if (text.empty()) return;
    const double width = inner_.width - indent;
    const bool too_wide = page_.canvas().text_width(text, style) > width;
    if (too_wide && (type_.size > page_.sizes().smallest || type_.parts == EquationParts::number_beside))
      layout_.fits = false;
    List<std::string> lines = {text};
    if (too_wide) lines = wrapped(page_.canvas(), text, width, style);
    for (const std::string& line : lines) {
      layout_.lines.push_back({{inner_.x + indent, std::round(baseline)}, line, style});
      baseline += type_.pitch * type_.size;
    }
  }

  const Page& page_;
  Rect inner_;
  const Equation& equation_;
  EquationType type_;
  double top_, bottom_;
  EquationLayout layout_ = {};
};

/// From the largest size down to the smallest, first with generous, then with tight lines; then with the
/// number beside the first line; at last without what is least needed.
List<EquationType> equation_types(double largest, double smallest) {
  List<EquationType> types;
  for (double size = largest; size >= smallest; --size) {
    for (const double pitch : {1.6, 1.35}) types.push_back({.size = size, .pitch = pitch});
  }
  for (double size = largest; size >= smallest; --size) {
    types.push_back({.size = size, .pitch = 1.35, .parts = EquationParts::number_beside});
  }
  for (const EquationParts parts : {EquationParts::without_remarks, EquationParts::symbols_and_result}) {
    types.push_back({.size = smallest, .pitch = 1.25, .parts = parts});
  }
  return types;
}

}  // namespace

void Page::equation(const Rect& rect, const Equation& equation) {
  const Rect inner = panel(rect, "");
  panels_.push_back({equation.number, rect});
  EquationLayout layout;
  for (const EquationType& type : equation_types(sizes_.equation, sizes_.smallest)) {
    layout = EquationSetter(*this, inner, equation, type).set();
    if (layout.fits) break;
  }
  canvas_.push_clip(rect);
  for (const PlacedLine& line : layout.lines) canvas_.text(line.at, line.text, line.style);
  canvas_.pop_clip();
}

void Page::note(const Rect& rect, std::string_view title, std::string_view text, double growth) {
  const Rect inner = panel(rect, title);
  TextStyle style = {.size = std::round(growth * sizes_.question), .color = theme_.text};
  const auto height_of = [&] {
    const double lines = wrapped(canvas_, text, inner.width, style).size();
    return std::round(leading * style.size) * (lines - 1) + style.size;
  };
  const auto room = [&] { return style.size > sizes_.question ? 0.7 * inner.height : inner.height; };
  while (style.size > sizes_.smallest && height_of() > room())
    style.size = std::max(sizes_.smallest, style.size - 1);
  canvas_.push_clip(rect);
  paragraph({inner.x, std::round(inner.y + 0.85 * style.size)}, inner.width, text, style);
  canvas_.pop_clip();
}

}  // namespace cairn::render
