// A frame in vectors: what a canvas draws, as SVG.
#include "render/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/batch.hpp"
#include "render/font.hpp"

namespace cairn::render {
namespace {

/// To a hundredth of a pixel, as short as it can be written.
std::string short_number(double value) {
  const double rounded = std::round(100 * value) / 100;
  return fmt::format("{:g}", rounded == 0 ? 0 : rounded);
}

std::string pair_of(const Point& point) { return short_number(point.x()) + " " + short_number(point.y()); }

int byte_of(float channel) { return static_cast<int>(std::lround(255 * std::clamp(channel, 0.0F, 1.0F))); }

/// fill="#RRGGBB", and its opacity where it has one.
std::string color_attribute(const char* name, const Color& color) {
  if (color.a <= 0) return fmt::format(" {}=\"none\"", name);
  std::string text =
      fmt::format(" {}=\"#{:02x}{:02x}{:02x}\"", name, byte_of(color.r), byte_of(color.g), byte_of(color.b));
  if (color.a < 1) text += fmt::format(" {}-opacity=\"{}\"", name, short_number(color.a));
  return text;
}

std::string paint_attributes(const Paint& paint) {
  std::string text = color_attribute("fill", paint.fill);
  if (paint.outline.a > 0 && paint.outline_width > 0) {
    text += color_attribute("stroke", paint.outline) +
            fmt::format(" stroke-width=\"{}\"", short_number(paint.outline_width));
  }
  return text;
}

std::string stroke_attributes(const Stroke& stroke) {
  std::string text =
      " fill=\"none\"" + color_attribute("stroke", stroke.color) +
      fmt::format(" stroke-width=\"{}\" stroke-linejoin=\"round\"", short_number(stroke.width));
  if (stroke.dash.empty()) return text;
  text += " stroke-dasharray=\"";
  for (const double length : stroke.dash) text += short_number(length) + " ";
  text.back() = '"';
  return text;
}

bool are_usable(Span<const Point> points) {
  return std::all_of(points.begin(), points.end(), [](const Point& point) { return usable(point); });
}

double twice_area(Span<const Point> points) {
  double sum = 0;
  for (int i = 0; i < points.size(); ++i) {
    const Point& from = points[i];
    const Point& to = points[(i + 1) % points.size()];
    sum += from.x() * to.y() - from.y() * to.x();
  }
  return sum;
}

/// A convex polygon, grown by a radius: its edges moved outwards, and an arc around each corner.
std::string rounded_path(List<Point> points, double rounding) {
  if (twice_area(points) < 0) std::reverse(points.begin(), points.end());  // y is down: this turns clockwise
  std::string path;
  for (int i = 0; i < points.size(); ++i) {
    const Point& from = points[i];
    const Point& to = points[(i + 1) % points.size()];
    if ((to - from).norm() == 0) continue;
    const Point along = (to - from).normalized();
    const Point out = rounding * Point(along.y(), -along.x());
    if (!path.empty()) {
      path +=
          rounding > 0 ? fmt::format("A{0} {0} 0 0 1 {1}", short_number(rounding), pair_of(from + out)) : "";
    } else {
      path = "M" + pair_of(from + out);
    }
    if (rounding > 0 || i + 1 < points.size()) path += "L" + pair_of(to + out);  // Z draws the last side
  }
  if (path.empty() || rounding <= 0) return path.empty() ? path : path + "Z";
  const std::string first = path.substr(1, path.find('L') - 1);
  return path + fmt::format("A{0} {0} 0 0 1 {1}Z", short_number(rounding), first);
}

/// Where the line x + y = sum crosses the edges of a convex polygon.
List<Point> crossings(Span<const Point> points, double sum) {
  List<Point> found;
  for (int i = 0; i < points.size(); ++i) {
    const Point& from = points[i];
    const Point& to = points[(i + 1) % points.size()];
    const double before = from.x() + from.y() - sum;
    const double after = to.x() + to.y() - sum;
    if ((before < 0) == (after < 0)) continue;
    found.push_back(from + before / (before - after) * (to - from));
  }
  return found;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const char* const entity = c == '&'   ? "&amp;"
                               : c == '<' ? "&lt;"
                               : c == '>' ? "&gt;"
                               : c == '"' ? "&quot;"
                                          : nullptr;
    if (entity != nullptr) {
      result += entity;
    } else {
      result += c;
    }
  }
  return result;
}

/// Glyphs side by side in one font, at one size and on one base line.
List<Span<const PlacedGlyph>> runs_of(const GlyphLine& line) {
  const auto go_together = [](const PlacedGlyph& a, const PlacedGlyph& b) {
    return a.name.face == b.name.face && a.name.slanted == b.name.slanted && a.size == b.size &&
           a.drop == b.drop && a.x < b.x;
  };
  List<Span<const PlacedGlyph>> runs;
  const Span<const PlacedGlyph> all = line.glyphs;
  for (int begin = 0, end = 0; begin < all.size(); begin = end) {
    for (end = begin + 1; end < all.size() && go_together(all[end - 1], all[end]);) ++end;
    runs.push_back(all.subspan(begin, end - begin));
  }
  return runs;
}

/// Where a run stands, in which font, and how wide it is.
std::string place_attributes(const Point& start, Span<const PlacedGlyph> run) {
  const PlacedGlyph& first = run.front();
  const PlacedGlyph& last = run.back();
  const Face face = first.name.face;
  const bool is_mono = face == Face::mono || face == Face::mono_bold;
  const bool is_bold = face == Face::bold || face == Face::mono_bold;
  return fmt::format(
      " x=\"{}\" y=\"{}\" font-family=\"{}\"{}{} font-size=\"{}\" textLength=\"{}\" "
      "lengthAdjust=\"spacingAndGlyphs\"",
      short_number(start.x() + first.x), short_number(start.y() + first.drop),
      is_mono ? "DejaVu Sans Mono, Menlo, Consolas, monospace"
              : "DejaVu Sans, Verdana, Helvetica, sans-serif",
      is_bold ? " font-weight=\"bold\"" : "", first.name.slanted ? " font-style=\"italic\"" : "",
      short_number(first.size), short_number(last.x + advance(last.name, last.size) - first.x));
}

std::string letters_of(Span<const PlacedGlyph> run) {
  std::string text;
  for (const PlacedGlyph& placed : run) text += placed.sign;
  return escaped(text);
}

}  // namespace

void SvgDrawing::clear() { *this = SvgDrawing(letters_); }

void SvgDrawing::polyline(Span<const Point> points, const Stroke& stroke) {
  std::string path;
  bool begun = false;
  for (const Point& point : points) {
    if (usable(point)) path += (begun ? "L" : "M") + pair_of(point);
    begun = usable(point);
  }
  if (path.empty() || stroke.color.a <= 0) return;
  const bool closed = points.size() > 2 && begun && points.front() == points.back();
  shapes_ += fmt::format("<path d=\"{}{}\"{}/>\n", path, closed ? "Z" : "", stroke_attributes(stroke));
}

void SvgDrawing::polygon(Span<const Point> points, const Paint& paint, double rounding) {
  if (points.size() < 2 || !are_usable(points)) return;
  shapes_ += fmt::format("<path d=\"{}\"{}/>\n", rounded_path({points.begin(), points.end()}, rounding),
                         paint_attributes(paint));
}

void SvgDrawing::capsule(const Point& from, const Point& to, double radius, const Paint& paint) {
  if (!usable(from) || !usable(to) || !usable(radius)) return;
  if (from != to) return polygon(FixedList<Point, 2>{from, to}, paint, radius);
  shapes_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>\n", short_number(from.x()),
                         short_number(from.y()), short_number(radius), paint_attributes(paint));
}

void SvgDrawing::rect(const Rect& rect, const Paint& paint, double corner_radius) {
  if (!usable(Point(rect.x, rect.y)) || !(rect.width > 0) || !(rect.height > 0)) return;
  const std::string corner =
      corner_radius > 0 ? fmt::format(" rx=\"{}\"", short_number(corner_radius)) : std::string();
  shapes_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}{}/>\n", short_number(rect.x),
                         short_number(rect.y), short_number(rect.width), short_number(rect.height), corner,
                         paint_attributes(paint));
}

void SvgDrawing::hatch(Span<const Point> points, const Stroke& stroke, double pitch) {
  if (points.size() < 3 || !are_usable(points) || !(pitch > 0)) return;
  double least = points[0].x() + points[0].y(), most = least;
  for (const Point& point : points) {
    least = std::min(least, point.x() + point.y());
    most = std::max(most, point.x() + point.y());
  }
  const double start = points[0].x() + points[0].y();  // as Canvas does it: the lines go with the shape
  std::string path;
  for (double sum = start - pitch * std::floor((start - least) / pitch); sum <= most; sum += pitch) {
    const List<Point> ends = crossings(points, sum);
    if (ends.size() == 2) path += "M" + pair_of(ends[0]) + "L" + pair_of(ends[1]);
  }
  if (!path.empty()) shapes_ += fmt::format("<path d=\"{}\"{}/>\n", path, stroke_attributes(stroke));
}

std::string SvgDrawing::outline_of(const GlyphName& name) {
  const auto [entry, is_new] = outlines_.try_emplace({name.face, name.index, name.slanted});
  if (is_new) {
    entry->second = fmt::format("g{}-{}{}", static_cast<int>(name.face), name.index, name.slanted ? "i" : "");
    definitions_ += fmt::format("<path id=\"{}\" d=\"{}\"/>\n", entry->second, glyph_outline(name));
  }
  return entry->second;
}

void SvgDrawing::write(const Point& start, const GlyphLine& line, const std::string& look, double rim) {
  shapes_ += fmt::format("<g{}>\n", look);
  for (const PlacedGlyph& placed : line.glyphs) {
    const double scale = units_to_pixels(placed.name, placed.size);
    const std::string wide =
        rim > 0 ? fmt::format(" stroke-width=\"{:.0f}\"", 2 * rim / scale) : std::string();
    shapes_ +=
        fmt::format("<use href=\"#{0}\" transform=\"translate({1}) scale({2:.6g} -{2:.6g})\"{3}/>\n",
                    outline_of(placed.name), pair_of(start + Point(placed.x, placed.drop)), scale, wide);
  }
  shapes_ += "</g>\n";
}

void SvgDrawing::text(const Point& start, const GlyphLine& line, double rim, const TextStyle& style) {
  if (line.glyphs.empty()) return;
  if (letters_ == Letters::text) return write_text(start, line, rim, style);
  if (rim > 0) {
    write(start, line,
          color_attribute("fill", style.halo) + color_attribute("stroke", style.halo) +
              " stroke-linejoin=\"round\"",
          rim);
  }
  write(start, line, color_attribute("fill", style.color), 0);
}

void SvgDrawing::write_text(const Point& start, const GlyphLine& line, double rim, const TextStyle& style) {
  std::string look = color_attribute("fill", style.color);
  if (rim > 0) {
    look += color_attribute("stroke", style.halo) +
            fmt::format(" stroke-width=\"{}\" stroke-linejoin=\"round\" paint-order=\"stroke\"",
                        short_number(2 * rim));
  }
  const List<Span<const PlacedGlyph>> runs = runs_of(line);
  shapes_ += "<text xml:space=\"preserve\"" + look;
  if (runs.size() == 1) {
    shapes_ += place_attributes(start, runs[0]) + ">" + letters_of(runs[0]);
  } else {
    shapes_ += ">";
    for (const Span<const PlacedGlyph>& run : runs)
      shapes_ += "<tspan" + place_attributes(start, run) + ">" + letters_of(run) + "</tspan>";
  }
  shapes_ += "</text>\n";
}

void SvgDrawing::push_clip(const Rect& rect) {
  ++clips_;
  ++open_;
  definitions_ += fmt::format(
      "<clipPath id=\"c{}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n", clips_,
      short_number(rect.x), short_number(rect.y), short_number(rect.width), short_number(rect.height));
  shapes_ += fmt::format("<g clip-path=\"url(#c{})\">\n", clips_);
}

void SvgDrawing::pop_clip() {
  if (open_ == 0) return;
  --open_;
  shapes_ += "</g>\n";
}

std::string SvgDrawing::file(const Rect& view, Color background, std::string_view alt) const {
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{0} {1} {2} {3}\" width=\"{2}\" height=\"{3}\" "
      "role=\"img\">\n<title>{4}</title>\n",
      short_number(view.x), short_number(view.y), short_number(view.width), short_number(view.height),
      escaped(alt));
  text += "<defs>\n" + definitions_ + "</defs>\n";
  if (background.a > 0) {
    SvgDrawing ground;
    ground.rect(view, {.fill = background}, 0);
    text += ground.shapes_;
  }
  text += shapes_;
  for (int i = 0; i < open_; ++i) text += "</g>\n";
  return text + "</svg>\n";
}

}  // namespace cairn::render
