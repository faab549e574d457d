// One frame of a lesson: header, body with panels, footer; and a record of its layout for checks.
#pragma once

#include <string>
#include <string_view>

#include <cairn/math/list.hpp>
#include "render/canvas.hpp"
#include "render/theme.hpp"

namespace cairn::render {

struct Header {
  std::string number = {};  // "03"
  std::string title = {};
  std::string state = {};  // right, in mono: "sweep 2/10 · row 2 of 3"
  int frame = 0;           // from 0
  int frames = 1;
};

/// An equation with its numbers: symbols, the same with numbers filled in, the result with its unit.
struct Equation {
  std::string number = {};     // "eq (22)"
  std::string symbols = {};    // "λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)"
  std::string numbers = {};    // "= (0 − (−0.150)) / (2 × 0.02)"
  std::string result = {};     // "= 3.75 N"
  std::string algorithm = {};  // "Algorithm 1, line 13:  λ₂: 5.00 → 8.75"
  Color color = transparent;   // of the result; transparent: the text's colour
};

/// Where a panel was drawn.
struct PanelPlace {
  std::string title = {};
  Rect rect = {};
};

/// Rows of text in columns: words left-aligned, numbers right-aligned, in mono.
struct TableView {
  List<std::string> header = {};
  List<List<std::string>> rows = {};
  int active_row = -1;
  int text_columns = 1;  // the first ones, which are words
};

/// A frame being drawn. Everything that draws takes a Page: canvas, theme and sizes in one hand.
class Page {
 public:
  /// An image of width * scale by height * scale: the same frame, sharper.
  /// @throws RenderError when no context can be made, std::invalid_argument unless at least 320 x 180 px, or
  /// for a scale that Canvas refuses.
  Page(int width, int height, const Theme& theme, double scale = 1);
  /// An image of this size that is laid out as one of 1280 x 720 px (wider or higher, where the image is), so
  /// that type and lines grow and shrink with it. @throws as above unless at least 960 x 540 px
  Page(const ImageSize& image, const Theme& theme);

  /// What frames stand on from now on, in place of the theme's background.
  void set_paper(Color paper) { paper_ = paper; }
  /// Begins a new frame with its header, and the footer's scrubber when there is more than one frame.
  void begin(const Header& header);

  Canvas& canvas() { return canvas_; }
  const Canvas& canvas() const { return canvas_; }
  const Theme& theme() const { return theme_; }
  const Sizes& sizes() const { return sizes_; }
  /// Below 540 px of height: one panel less, units dropped from repeated labels.
  bool compact() const { return canvas_.height() < 540; }
  /// Between header and footer, inside the margins.
  Rect area() const;

  TextStyle label() const;      // sans
  TextStyle secondary() const;  // sans, secondary colour
  TextStyle value() const;      // mono
  TextStyle tick() const;

  /// A framed panel with a title in its top left corner ("" for none). Returns what is free inside.
  Rect panel(const Rect& rect, std::string_view title);
  /// The panels of this frame that have titles.
  const List<PanelPlace>& panels() const { return panels_; }
  /// A panel with the lines of an equation; type shrinks until the longest line fits.
  void equation(const Rect& rect, const Equation& equation);
  /// A panel with a table; the active row is lit. Type shrinks until all rows fit; where there is room to
  /// spare it may be larger by `growth`.
  void table(const Rect& rect, std::string_view title, const TableView& table, double growth = 1.35);
  /// A panel with a text, wrapped at words, around the middle. Type shrinks until the text fits; where there
  /// is room to spare it may be larger by `growth`.
  void note(const Rect& rect, std::string_view title, std::string_view text, double growth = 1);
  /// The same in a panel at the top of `rect` that is as high as its text. Returns what is left below.
  Rect card(const Rect& rect, std::string_view title, std::string_view text, double growth = 1);
  /// Wraps at words and returns the height used [px]. `at`: base line of the first line.
  double paragraph(const Point& at, double width, std::string_view text, const TextStyle& style);
  /// Writes at the first place whose text box meets no other text and stays inside `within`, and if there is
  /// a choice off the lines told to avoid() and note_curve(); the first place if there is none. Each place is
  /// a base line, aligned as the style says.
  void place_text(const List<Point>& places, const Rect& within, std::string_view text,
                  const TextStyle& style);

  /// Remembers a curve for lint(): text must not stand on it without a halo.
  void note_curve(List<Point> points) { curves_.push_back(std::move(points)); }
  const List<List<Point>>& curves() const { return curves_; }
  /// A line, such as a body's outline or an arrow, that place_text() keeps off where it can. lint() does not
  /// mind it.
  void avoid(List<Point> line) { avoided_.push_back(std::move(line)); }

 private:
  Canvas canvas_;
  Theme theme_;
  Sizes sizes_;
  Color paper_;
  List<PanelPlace> panels_;
  List<List<Point>> curves_;
  List<List<Point>> avoided_;
};

/// Cuts a rectangle into columns (or rows) with the given weights and a gap [px] between them.
List<Rect> columns(const Rect& rect, const List<double>& weights, double gap);
List<Rect> rows(const Rect& rect, const List<double>& weights, double gap);
/// The rectangle without `by` px on every side.
Rect inset(const Rect& rect, double by);

/// A number for people: fixed decimals, minus sign U+2212, "+" in front if positive and asked for.
enum class Sign { negative_only, always };
std::string fixed(double value, int decimals, Sign sign = Sign::negative_only);
/// Fixed decimals below 100,000, beyond it three significant digits: a number that never fills a line.
std::string readable(double value, int decimals);
/// Up to `digits` significant digits, 1.1e−13 as "1.1×10^{−13}", minus sign U+2212.
std::string significant(double value, int digits = 3);

}  // namespace cairn::render
