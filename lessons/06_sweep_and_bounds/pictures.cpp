// The intervals of all kinds of rows, and the order of all frames.
#include "lesson.hpp"

namespace cairn::sweeps {

namespace {

Color color_of(const Theme& theme, const Bounds<double>& bounds) {
  if (bounds.is_friction()) return theme.friction;
  return bounds.is_unilateral() ? theme.normal : theme.joint;
}

/// One interval on a number line: a thick piece, with a bracket where it ends or a head where it does not.
void draw_interval(Page& page, const Rect& rect, const Interval& kind) {
  const PerRow<double> impulse = {10.0};
  const double low = kind.bounds.clamp(-1e9, impulse);
  const double high = kind.bounds.clamp(1e9, impulse);
  const double scale = rect.width / 24;
  const double y = rect.y + rect.height / 2;
  const double zero = rect.x + rect.width / 2;
  Canvas& canvas = page.canvas();
  canvas.line({rect.x, y}, {rect.x + rect.width, y}, {.width = 1.5, .color = page.theme().frame_line});
  const double thick = 9, tall = 16;
  const double from = std::max(zero + low * scale, rect.x + tall);
  const double to = std::min(zero + high * scale, rect.x + rect.width - tall);
  const Color color = color_of(page.theme(), kind.bounds);
  canvas.line({from, y}, {to, y}, {.width = thick, .color = color});
  TextStyle style = page.value();
  style.size *= 1.3;
  style.align = Align::center;
  for (const double sign : {-1.0, 1.0}) {
    const double end = sign < 0 ? low : high;
    const double x = sign < 0 ? from : to;
    const Point below(std::clamp(x, rect.x + 0.5 * style.size, rect.x + rect.width - style.size),
                      y + tall + 1.1 * style.size);
    canvas.text(below, sign < 0 ? kind.lower : kind.upper, style);
    if (std::abs(end) < 1e6) {
      canvas.line({x, y - tall}, {x, y + tall}, {.width = thick / 2, .color = color});
      continue;
    }
    const FixedList<Point, 3> head = {Point(x + sign * tall, y), Point(x - sign * 0.3 * tall, y - tall),
                                      Point(x - sign * 0.3 * tall, y + tall)};
    canvas.polygon(head, {.fill = color});
  }
  canvas.circle(
      {zero, y}, page.sizes().contact,
      {.fill = page.theme().panel, .outline = page.theme().text, .outline_width = page.sizes().outline});
}

void draw_intervals(Page& page) {
  const Rect inside = page.panel(page.area(), "the interval of a row's impulse (○ is 0)");
  const List<Interval> kinds = kinds_of_rows();
  const List<double> weights(kinds.size(), 1.0);
  const List<Rect> lines = rows(inside, weights, page.sizes().gap / 2);
  for (int k = 0; k < kinds.size(); ++k) {
    const List<Rect> parts = in_columns(page, lines[k], {0.34, 0.66});
    const Rect& words = parts[0];
    TextStyle name = page.label(), reason = page.secondary();
    name.size *= 1.35, name.bold = true, reason.size *= 1.12;
    const double middle = words.y + words.height / 2;
    page.canvas().text({words.x, middle - 4}, kinds[k].name, name);
    page.canvas().text({words.x, middle + reason.size + 4}, kinds[k].reason, reason);
    draw_interval(page, parts[1], kinds[k]);
  }
}

/// Which of the other lambda are new already: rows before this one have had their turn.
std::string sources(const SystemMatrices<double>& system, int i) {
  std::string text;
  for (int j = 0; j < system.b.size(); ++j) {
    if (j == i || system.A(i, j) == 0) continue;
    text += fmt::format("{}λ_{{{}}} {}", text.empty() ? "" : ", ", j + 1,
                        j < i ? "of this sweep" : "of the last sweep");
  }
  if (text.empty()) return "no other λ in this row";
  return "with " + text;
}

}  // namespace

void draw_system(Page& page, const Rect& rect, const SystemMatrices<double>& system, int active) {
  const auto n = static_cast<int>(system.b.size());
  MatrixView view{.title = "A, and b (m/s²)", .column_group = n, .active_row = active};
  view.values.resize(n, n + 1);
  view.values << system.A, system.b;
  for (int i = 1; i <= n; ++i) view.row_names.push_back(fmt::format("{}", i));
  view.column_names = view.row_names;
  view.column_names.push_back("b");
  draw_matrix(page, page.panel(rect, ""), view);
}

Equation equation_28(const Page& page, const SystemMatrices<double>& system, const Swept& swept, int update) {
  const int i = swept.updates[update].row;
  std::string symbols = fmt::format("b_{{{}}}", i + 1);
  std::string numbers = brief(system.b(i));
  double rest = system.b(i);
  for (int j = 0; j < system.b.size(); ++j) {
    if (j == i || system.A(i, j) == 0) continue;
    const double other = update > 0 ? swept.after[update - 1][j] : 0;
    rest -= system.A(i, j) * other;
    symbols += fmt::format(" − A_{{{}{}}} λ_{{{}}}", i + 1, j + 1, j + 1);
    numbers += fmt::format(" − {} × {}", in_brackets(brief(system.A(i, j))), brief(other));
  }
  const double value = rest / system.A(i, i);
  const double after = swept.after[update][i];
  const bool cut = value < after - 1e-9;
  const bool alone = symbols.find("−") == std::string::npos;
  if (!alone) symbols = "(" + symbols + ")", numbers = "(" + numbers + ")";
  return {.number = "eq (28)",
          .symbols = fmt::format("λ_{{{0}}} = {1} / A_{{{0}{0}}}", i + 1, symbols),
          .numbers = fmt::format("= {} / {}", numbers, brief(system.A(i, i))),
          .result = fmt::format("= {} N", brief(value)),
          .algorithm = cut ? fmt::format("clamped: λ_{{{}}} ≥ 0", i + 1) : sources(system, i),
          .color = cut ? page.theme().secondary_text : page.theme().normal};
}

List<Shot> sweep_shots(const SweepRun& run) {
  List<Shot> shots = {question_shot(run)};
  const List<Shot> rod = rod_shots(run);
  shots.insert(shots.end(), rod.begin(), rod.end());
  shots.push_back({.state = "intervals",
                   .alt = "Number lines: the interval of a contact or rope, of a joint, of a motor and of "
                          "friction.",
                   .draw = [](Page& page) { draw_intervals(page); },
                   .key = true});
  shots.push_back(answer_shot(run));
  return shots;
}

}  // namespace cairn::sweeps
