// The impulses of both solvers in pairs, the matrix, and numbers whose last digits differ.
#include "lesson.hpp"

namespace cairn::twice {

namespace {

/// Where the bars stand.
struct PairField {
  Rect rect = {};
  double zero = 0;        // [px] of lambda = 0
  double per_newton = 0;  // [px/N]
  double pitch = 0;       // [px] from row to row
};

/// The two bars of a row, and empty what the clamp cuts off.
void draw_pair(Page& page, const PairField& field, const Moment& moment, int i) {
  const bool active = i == moment.active;
  const double left = field.rect.x + (i + 0.1) * field.pitch;
  const auto bar = [&](double at, double width, double lambda, const render::Paint& paint) {
    const double top = field.zero - std::max(lambda, 0.0) * field.per_newton;
    page.canvas().rect(
        {left + at * field.pitch, top, width * field.pitch, std::abs(lambda) * field.per_newton}, paint);
  };
  const Color outline = page.theme().outline;
  const double line = active ? 2 : 0;
  bar(0, 0.4, moment.pgs[i], {.fill = page.theme().pgs.color, .outline = outline, .outline_width = line});
  if (!moment.si.empty())
    bar(0.4, 0.4, moment.si[i], {.fill = page.theme().si.color, .outline = outline, .outline_width = line});
  if (!moment.unclamped.empty() && moment.si[i] != moment.unclamped[i])
    bar(0, 0.8, moment.unclamped[i], {.outline = page.theme().secondary_text, .outline_width = 1.5});
  const double y = field.zero - moment.exact[i] * field.per_newton;
  page.canvas().line({left - 0.08 * field.pitch, y}, {left + 0.88 * field.pitch, y},
                     {.width = 3, .color = page.theme().text});
  const bool beside = moment.active >= 0 && std::abs(i - moment.active) == 1;
  if (!active && (beside || (i % 5 != 4 && i != 0))) return;
  TextStyle name = aligned(page.tick(), Align::center);
  name.bold = active;
  page.canvas().text({left + 0.4 * field.pitch, field.rect.y + field.rect.height + name.size + 6},
                     fmt::format("{}", i + 1), name);
}

/// The rows that share a body with the active one, it among them, or all others.
void draw_rows(Page& page, const List<Point>& places, const TwiceRun& run, int active, bool neighbours) {
  const auto& rows = run.problem.rows;
  const auto joins = [&](int i, int body) { return rows[i].a.index == body || rows[i].b.index == body; };
  for (int i = 0; i < run.problem.row_count(); ++i) {
    const int low = std::min(rows[i].a.index, rows[i].b.index);
    const int high = std::max(rows[i].a.index, rows[i].b.index);
    if ((joins(active, low) || joins(active, high)) != neighbours) continue;
    int before = 0;  // rows between the same two bodies stand side by side
    for (int k = 0; k < i; ++k) before += joins(k, low) && joins(k, high);
    const Point aside = 5.0 * before * perpendicular((places[high] - places[low]).normalized());
    Stroke stroke{.width = 1.5, .color = neighbours ? page.theme().text : page.theme().inactive};
    if (i == active) stroke = {.width = 5, .color = page.theme().normal};
    page.canvas().line(places[low] + aside, places[high] + aside, stroke);
  }
}

}  // namespace

Range range_of(const TwiceRun& run) {
  Range range;
  const auto add = [&range](double value) {
    range = {std::min(range.low, value), std::max(range.high, value)};
  };
  for (const RowStep& step : run.steps) add(step.by_27);
  std::for_each(run.exact.begin(), run.exact.end(), add);
  for (const PerRow<double>& sweep : run.si) std::for_each(sweep.begin(), sweep.end(), add);
  return range;
}

void draw_pairs(Page& page, const Rect& rect, const std::string& title, const Moment& moment,
                const Range& range) {
  Canvas& canvas = page.canvas();
  const Rect inside = page.panel(rect, title);
  double x = inside.x + canvas.text_width(title, page.secondary()) + 16;
  const char* const si = moment.si.empty() ? "SI: ?" : "SI";
  for (const auto& [name, color] :
       {std::pair("PGS", page.theme().pgs.color), std::pair(si, page.theme().si.color)}) {
    canvas.rect({x, rect.y + 17, 12, 12}, {.fill = color});
    canvas.text({x + 18, rect.y + 29}, name, page.label());
    x += 80;
  }
  canvas.line({x, rect.y + 23}, {x + 18, rect.y + 23}, {.width = 3, .color = page.theme().text});
  canvas.text({x + 24, rect.y + 29}, "answer", page.label());
  TextStyle tick = aligned(page.tick(), Align::right);
  const double gutter = canvas.text_width("−000", tick) + 6;
  PairField field{{inside.x + gutter, inside.y + 6, inside.width - gutter, inside.height - tick.size - 14}};
  field.per_newton = field.rect.height / (range.high - range.low);
  field.zero = field.rect.y + range.high * field.per_newton;
  field.pitch = field.rect.width / moment.pgs.size();
  const double end = field.rect.x + field.rect.width;
  for (const double y : render::round_ticks(range.low, range.high, 6)) {
    const double at = field.zero - y * field.per_newton;
    canvas.line({field.rect.x, at}, {end, at}, {.width = 1, .color = page.theme().grid});
    canvas.text({field.rect.x - 6, at + 0.35 * tick.size}, fixed(y, 0), tick);
  }
  for (int i = 0; i < moment.pgs.size(); ++i) draw_pair(page, field, moment, i);
  canvas.line({field.rect.x, field.zero}, {end, field.zero}, {.width = 1.5, .color = page.theme().outline});
}

void draw_system(Page& page, const Rect& rect, const TwiceRun& run, int active) {
  MatrixView view{
      .title = "A = J M^{−1} J^{T} (1/kg)", .values = run.system.A, .active_row = active, .numbers = false};
  for (int i = 1; i <= run.problem.row_count(); ++i) {
    const std::string name = i == 1 || i % 5 == 0 ? fmt::format("{}", i) : "";
    view.row_names.push_back(name);
    view.column_names.push_back(name);
  }
  draw_matrix(page, rect, view);
}

void draw_bodies(Page& page, const Rect& rect, const TwiceRun& run, int active) {
  const Rect inside = page.panel(rect, fmt::format("{} bodies, {} rows; lit: row {}", run.settings.bodies,
                                                   run.settings.rows, active + 1));
  const double radius = 15;  // [px] of a body
  const double reach = 0.5 * std::min(inside.width, inside.height) - radius - 2;
  const Point middle(inside.x + 0.5 * inside.width, inside.y + 0.5 * inside.height);
  List<Point> places;
  for (int body = 0; body < run.settings.bodies; ++body) {
    const double turn = 2 * pi * body / run.settings.bodies;
    places.push_back(middle + reach * Point(std::sin(turn), -std::cos(turn)));
  }
  for (const bool neighbours : {false, true}) draw_rows(page, places, run, active, neighbours);
  const ConstraintRow<double>& row = run.problem.rows[active];
  const TextStyle style = aligned(page.label(), Align::center);
  for (int body = 0; body < places.size(); ++body) {
    Color fill = page.theme().panel;
    if (body == row.a.index) fill = page.theme().active_a;
    if (body == row.b.index) fill = page.theme().active_b;
    page.canvas().circle(
        places[body], radius,
        {.fill = fill, .outline = page.theme().outline, .outline_width = page.sizes().outline});
    page.canvas().text(places[body] + Point(0, 5), fmt::format("{}", body + 1), style);
  }
}

void draw_digits(Page& page, const Rect& rect, const std::string& title, const List<Digits>& lines,
                 const std::string& below) {
  const Rect inside = page.panel(rect, title);
  Canvas& canvas = page.canvas();
  std::size_t same = 0;
  const std::string& first = lines[0].digits;
  const auto agree = [&](const Digits& line) {
    return line.digits.compare(0, same + 1, first, 0, same + 1) == 0;
  };
  while (same < first.size() && std::all_of(lines.begin(), lines.end(), agree)) ++same;
  const double pitch =
      std::min(44.0, inside.height / (static_cast<double>(lines.size()) + (below.empty() ? 0 : 1)));
  const TextStyle plain{.size = 24, .color = page.theme().secondary_text, .mono = true};
  TextStyle lit = plain;
  lit.bold = true;
  lit.color = page.theme().text;
  const double x = inside.x + 0.36 * inside.width;
  double y = inside.y + 0.75 * pitch;
  for (const Digits& line : lines) {
    const std::string head = line.digits.substr(0, same), tail = line.digits.substr(same);
    const double split = x + canvas.text_width(head, plain), width = canvas.text_width(tail, lit);
    canvas.text({inside.x, y}, line.name, page.label());
    canvas.text({x, y}, head, plain);
    if (!tail.empty()) canvas.rect({split - 2, y - 22, width + 4, 29}, {.fill = page.theme().active_b});
    canvas.text({split, y}, tail, lit);
    y += pitch;
  }
  canvas.text({inside.x, y}, below, page.label());
}

}  // namespace cairn::twice
