// Panels that hold text: an equation with its numbers, a question or an answer.
#include <algorithm>
#include <cmath>

#include <cairn/math/list.hpp>
#include "render/page.hpp"
#include "render/text_layout.hpp"

namespace cairn::render {

namespace {

/// Where a text stands that leaves room in its panel: the share of that room above it.
constexpr double in_the_middle = 0.4;

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
    const int remarks = layout_.lines.size();
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
    const double spare = bottom_ - (baseline - type_.pitch * type_.size + 0.3 * type_.size);
    if (spare < 0) layout_.fits = false;
    for (int i = remarks; i < layout_.lines.size(); ++i)
      layout_.lines[i].at.y() += std::round(in_the_middle * std::max(spare, 0.0));
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
    const TextStyle formula = {.size = type_.size};
    const double beside = page_.canvas().text_width(equation_.number, small) + 2 * small.size;
    if (page_.canvas().text_width(equation_.symbols, formula) + beside > inner_.width) layout_.fits = false;
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

/// How much larger than usual an equation may be where there is room to spare.
constexpr double equation_growth = 1.25;

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

struct NoteLayout {
  TextStyle style = {};
  double height = 0;  // [px] of the text
};

/// The largest type of which all lines fit; what is larger than usual leaves air around it.
NoteLayout note_layout(const Page& page, double width, double height, std::string_view text, double growth) {
  const double usual = page.sizes().question, smallest = page.sizes().smallest;
  NoteLayout layout{.style = {.size = std::round(growth * usual), .color = page.theme().text}};
  for (;; layout.style.size = std::max(smallest, layout.style.size - 1)) {
    const TextStyle& style = layout.style;
    const double lines = wrapped(page.canvas(), text, width, style).size();
    layout.height = std::round(leading * style.size) * (lines - 1) + style.size;
    const double room = style.size > usual ? 0.8 * height : height;
    if (style.size <= smallest || layout.height <= room) return layout;
  }
}

void draw_note(Page& page, const Rect& rect, const Rect& inner, const NoteLayout& layout,
               std::string_view text) {
  const double top = inner.y + in_the_middle * std::max(0.0, inner.height - layout.height);
  page.canvas().push_clip(rect);
  page.paragraph({inner.x, std::round(top + 0.85 * layout.style.size)}, inner.width, text, layout.style);
  page.canvas().pop_clip();
}

}  // namespace

void Page::equation(const Rect& rect, const Equation& equation) {
  const Rect inner = panel(rect, "");
  panels_.push_back({equation.number, rect});
  EquationLayout layout;
  for (const EquationType& type : equation_types(equation_growth * sizes_.equation, sizes_.smallest)) {
    layout = EquationSetter(*this, inner, equation, type).set();
    if (layout.fits) break;
  }
  canvas_.push_clip(rect);
  for (const PlacedLine& line : layout.lines) canvas_.text(line.at, line.text, line.style);
  canvas_.pop_clip();
}

void Page::note(const Rect& rect, std::string_view title, std::string_view text, double growth) {
  const Rect inner = panel(rect, title);
  draw_note(*this, rect, inner, note_layout(*this, inner.width, inner.height, text, growth), text);
}

Rect Page::card(const Rect& rect, std::string_view title, std::string_view text, double growth) {
  const double frame = 2 * sizes_.padding + (title.empty() ? 0 : std::ceil(title_pitch * sizes_.label) + 1);
  const NoteLayout layout =
      note_layout(*this, rect.width - 2 * sizes_.padding, rect.height - frame, text, growth);
  const double height = std::min(rect.height, frame + std::ceil(layout.height) + 0.5 * sizes_.padding);
  const Rect card = {rect.x, rect.y, rect.width, height};
  draw_note(*this, card, panel(card, title), layout, text);
  const double below = std::min(rect.height, height + sizes_.gap);
  return {rect.x, rect.y + below, rect.width, rect.height - below};
}

}  // namespace cairn::render
