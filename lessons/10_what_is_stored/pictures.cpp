// The question, a small pyramid row by row beside its A, the patterns of three, and the answer.
#include "lesson.hpp"

namespace cairn::stored {

namespace {

constexpr int small = 1;  // of the pyramids: large enough to have an overlap inside
constexpr int largest = 3;

void draw_box(Page& page, const Camera& camera, const SnapshotBody& body, Color fill) {
  const Point corner = camera.project(body.pose.position + Vec2<double>(-0.5, 0.5));
  page.canvas().rect({corner.x(), corner.y(), camera.scale, camera.scale},
                     {.fill = fill, .outline = page.theme().outline, .outline_width = 1});
}

Camera draw_pyramid(Page& page, const Rect& rect, const StoredRun& run, int which) {
  const Count& count = run.pyramids[which];
  const Rect inside = page.panel(rect, fmt::format("{} boxes: m = {:g} rows", count.bodies, count.rows));
  const double half = 0.5 * run.settings.spacing * count.base + 0.3;
  const Camera camera = fit(inside, {{-half, -0.5}, {half, count.base + 0.3}});
  // So small that lines as thick as in other scenes would fill the gaps.
  Snapshot floor = run.snapshots[which];
  floor.bodies.resize(1);
  draw_world(page, camera, floor, {.contacts = false});
  for (const SnapshotBody& body : run.snapshots[which].bodies)
    if (body.type != BodyType::static_body) draw_box(page, camera, body, page.theme().body);
  return camera;
}

/// The two boxes of the row that the question is about, in the largest.
void mark_asked(Page& page, const Camera& camera, const StoredRun& run) {
  const int asked = run.problems[largest].row_count() / 2;
  const ConstraintRow<double>& row = run.problems[largest].rows[asked];
  const PerBody<SnapshotBody>& bodies = run.snapshots[largest].bodies;
  for (const BodyId body : {row.a, row.b}) draw_box(page, camera, bodies[body], page.theme().normal);
  const Vec2<double> overlap = 0.5 * (bodies[row.a].pose.position + bodies[row.b].pose.position);
  const Point from = camera.project(overlap), to(camera.project({-0.5 * run.settings.base, 0}).x(), from.y());
  page.canvas().line(from, to, {.width = 3, .color = page.theme().normal});
  page.canvas().text(to + Point(-6, 6), fmt::format("row {}", asked + 1),
                     aligned(page.label(), Align::right));
}

/// Where a contact is, filled with the colour of the box that it shares with the active row.
void draw_contact(Page& page, const Point& at, const List<BodyId>& shared, BodyId a) {
  render::Paint paint{.fill = page.theme().inactive};
  if (shared.size() == 1) paint.fill = shared[0] == a ? page.theme().active_a : page.theme().active_b;
  if (shared.size() == 2) paint.fill = page.theme().normal;
  if (!shared.empty()) {
    paint.outline = page.theme().outline;
    paint.outline_width = 1.5;
  }
  page.canvas().circle(at, shared.empty() ? page.sizes().contact : 1.5 * page.sizes().contact, paint);
}

/// The boxes among the two of row `active` that row j is on, too. The ground is none.
List<BodyId> shared_boxes(const VelocityProblem<double>& problem, int active, int j) {
  List<BodyId> shared;
  for (const BodyId box : {problem.rows[active].a, problem.rows[active].b})
    if (box != ground && (problem.rows[j].a == box || problem.rows[j].b == box)) shared.push_back(box);
  return shared;
}

/// The contacts of a small pyramid: those of either box of the active row, those of both, and the others.
void draw_met(Page& page, const Rect& rect, const StoredRun& run, int active) {
  const Rect inside = page.panel(rect, "");
  const double base = run.pyramids[small].base, half = 0.5 * run.settings.spacing * base + 0.1;
  const Camera camera = fit(inside, {{-half, -0.4}, {half, base + 0.1}});
  const VelocityProblem<double>& problem = run.problems[small];
  const ConstraintRow<double>& row = problem.rows[active];
  draw_world(
      page, camera, run.snapshots[small],
      {.numbers = false, .active_a = row.a, .active_b = row.b, .contacts = false, .penetration = false});
  const List<SnapshotContact>& contacts = run.snapshots[small].contacts;
  TextStyle style = page.tick();
  style.bold = true;
  for (int j = 0; j < contacts.size(); ++j) {
    const Point at = camera.project(contacts[j].position);
    const List<BodyId> shared = shared_boxes(problem, active, j);
    draw_contact(page, at, shared, row.a);
    if (shared.empty()) continue;
    // The two points of an overlap have their numbers between them, in the upper and in the lower box.
    const bool is_left = j % 2 == 0;
    const bool is_above = is_left || problem.rows[j].a == ground;
    style.align = is_left ? Align::left : Align::right;
    const Point beside(at.x() + (is_left ? 4 : -4), at.y() + (is_above ? -10 : 10 + 0.8 * style.size));
    page.canvas().text(beside, fmt::format("{}", j + 1), style);
  }
}

/// "8 rows act on its upper box, 8 on its lower, and 2 on both: 8 + 8 − 2 = 14 entries".
std::string count_of(const VelocityProblem<double>& problem, int active) {
  int on_a = 0, on_b = 0, met = 0;
  for (int j = 0; j < problem.row_count(); ++j) {
    const List<BodyId> shared = shared_boxes(problem, active, j);
    for (const BodyId box : shared) ++(box == problem.rows[active].a ? on_a : on_b);
    met += shared.empty() ? 0 : 1;
  }
  if (on_a == 0)
    return fmt::format("{} rows act on its box, and the ground does not move: {} entries", on_b, met);
  return fmt::format(
      "{} rows act on its lower box, {} on its upper, and {} on both: {} + {} − {} = {} entries", on_a, on_b,
      on_a + on_b - met, on_a, on_b, on_a + on_b - met, met);
}

void draw_row(Page& page, const StoredRun& run, int active) {
  const List<Rect> parts = in_columns(page, {{0.52, {0.82, 0.18}}, 0.48});
  const VelocityProblem<double>& problem = run.problems[small];
  draw_met(page, parts[0], run, active);
  page.note(
      parts[1], "",
      fmt::format("Row {}: {}. All others in this row of A are 0.", active + 1, count_of(problem, active)));
  MatrixView view{.title = fmt::format("A, base {}: red > 0, blue < 0", run.pyramids[small].base),
                  .values = system_matrices(problem).A,
                  .active_row = active,
                  .numbers = false};
  for (int j = 1; j <= problem.row_count(); ++j)
    view.row_names.push_back(j == 1 || j % 10 == 0 ? fmt::format("{}", j) : "");
  view.column_names = view.row_names;
  draw_matrix(page, parts[2], view);
}

void draw_patterns(Page& page, const StoredRun& run) {
  const List<Rect> bands = in_rows(page, {0.7, 0.3});
  for (const int which : {0, 1, 2}) {
    draw_pattern(page, in_columns(page, bands[0], {1, 1, 1})[which], run.pyramids[which],
                 run.problems[which]);
    draw_pyramid(page, in_columns(page, bands[1], {1, 1, 1})[which], run, which);
  }
}

/// Columns `first` to `end` of a row of A as a strip.
void draw_entries(Page& page, const Rect& strip, const List<char>& row, int first, int end) {
  const double cell = strip.width / (end - first);
  for (int j = first; j < end; ++j) {
    if (!row[j]) continue;
    page.canvas().rect({strip.x + cell * (j - first), strip.y, std::max(1.0, cell - 1), strip.height},
                       {.fill = page.theme().outline});
  }
  page.canvas().rect(strip, {.outline = page.theme().outline, .outline_width = page.sizes().outline});
}

/// The middle row of the largest A, and below it, enlarged, what is left without the zeros at its two ends.
/// The question asks what stands there.
void draw_strip(Page& page, const Rect& rect, const VelocityProblem<double>& problem, bool asked) {
  const int m = problem.row_count();
  const List<char> row = pattern(problem)[m / 2];
  const auto entry_count = std::count(row.begin(), row.end(), 1);
  const int first = static_cast<int>(std::find(row.begin(), row.end(), 1) - row.begin());
  const int end = m - static_cast<int>(std::find(row.rbegin(), row.rend(), 1) - row.rbegin());
  const Rect inside = page.panel(
      rect, asked ? fmt::format("row {} of A: {} entries, how many are not zero?", m / 2 + 1, m)
                  : fmt::format("row {}: {} of {} entries are not zero; below, columns {} to {} enlarged",
                                m / 2 + 1, entry_count, m, first + 1, end));
  if (asked) {
    const Rect strip{inside.x, inside.y + 0.2 * inside.height, inside.width, 0.6 * inside.height};
    draw_entries(page, strip, List<char>(m, 0), 0, m);
    TextStyle style = page.label();
    style.size = 0.8 * strip.height;
    style.align = Align::center;
    page.canvas().text({strip.x + strip.width / 2, strip.y + 0.78 * strip.height}, "?", style);
    return;
  }
  const List<Rect> strips = rows(inside, {0.38, 0.38}, 0.24 * inside.height);
  draw_entries(page, strips[0], row, 0, m);
  draw_entries(page, strips[1], row, first, end);
  const double below = strips[0].y + strips[0].height, width = inside.width;
  page.canvas().line({inside.x + width * first / m, below}, {inside.x, strips[1].y},
                     {.width = 1, .color = page.theme().secondary_text});
  page.canvas().line({inside.x + width * end / m, below}, {inside.x + width, strips[1].y},
                     {.width = 1, .color = page.theme().secondary_text});
}

/// The largest A with its middle row lit, and that row below it.
void draw_largest(Page& page, const Rect& rect, const StoredRun& run) {
  const List<Rect> parts = in_rows(page, rect, {0.76, 0.24});
  const Rect matrix = draw_pattern(page, parts[0], run.pyramids[largest], run.problems[largest]);
  const double middle = matrix.y + matrix.height / 2;
  page.canvas().line({matrix.x - 8, middle}, {matrix.x + matrix.width + 8, middle},
                     {.width = 3, .color = page.theme().normal});
  page.canvas().text({matrix.x + matrix.width + 14, middle + 6},
                     fmt::format("row {:g}", run.pyramids[largest].rows / 2 + 1), page.label());
  draw_strip(page, parts[1], run.problems[largest], false);
}

void draw_counts(Page& page, const Rect& rect, const StoredRun& run) {
  TableView table{.header = {"", "full A", "not zero", "per row"}, .active_row = largest};
  for (const Count& count : run.pyramids) {
    table.rows.push_back({count.name, spaced(count.dense), spaced(count.non_zeros),
                          fmt::format("{:.1f}", count.non_zeros / count.rows)});
  }
  page.table(rect, "", table);
}

Shot row_shot(const StoredRun& run, int row) {
  const VelocityProblem<double>& problem = run.problems[small];
  return {.state = fmt::format("row {} of {}", row + 1, problem.row_count()),
          .alt = fmt::format(
              "A pyramid of base {}, with the two boxes of row {} and all contacts on them lit; beside "
              "it A as a heat map with that row framed. {}.",
              run.pyramids[small].base, row + 1, count_of(problem, row)),
          .draw = [&run, row](Page& page) { draw_row(page, run, row); },
          .key = row == problem.row_count() / 2 + 5};
}

QuestionFrame question_frame(const StoredRun& run) {
  return {.state = run.pyramids[largest].name,
          .alt =
              "A large pyramid of boxes, two of them marked, an empty strip for their row of A, and the "
              "question.",
          .scene = [&run](Page& page, const Rect& rect) {
            const List<Rect> parts = in_rows(page, rect, {0.8, 0.2});
            mark_asked(page, draw_pyramid(page, parts[0], run, largest), run);
            draw_strip(page, parts[1], run.problems[largest], true);
          }};
}

QuestionFrame answer_frame(const StoredRun& run) {
  return {.state = run.pyramids[largest].name,
          .alt = fmt::format(
              "The pattern of A for {:g} rows, a thin band; one of its rows, and a piece of it enlarged; the "
              "counts for four pyramids; and the answer.",
              run.pyramids[largest].rows),
          .scene = [&run](Page& page, const Rect& rect) { draw_largest(page, rect, run); },
          .evidence = [&run](Page& page, const Rect& rect) { draw_counts(page, rect, run); }};
}

}  // namespace

/// What lies together in a row is drawn in one piece, on whole pixels, or seams would show.
Rect draw_pattern(Page& page, const Rect& rect, const Count& count, const VelocityProblem<double>& problem) {
  const Rect inside = page.panel(rect, fmt::format("{}: {} of {} entries are not zero", count.name,
                                                   spaced(count.non_zeros), spaced(count.dense)));
  const List<List<char>> entries = pattern(problem);
  const int m = entries.size();
  const double side = std::min(inside.width, inside.height);
  const double left = std::round(inside.x + (inside.width - side) / 2), top = std::round(inside.y);
  const auto edge = [&](int k) { return std::round(side * k / m); };
  for (int i = 0; i < m; ++i) {
    const double height = std::max(1.0, edge(i + 1) - edge(i));
    for (int first = 0, end = 0; first < m; first = end) {
      while (end < m && entries[i][end] == entries[i][first]) ++end;
      if (!entries[i][first]) continue;
      page.canvas().rect({left + edge(first), top + edge(i), edge(end) - edge(first), height},
                         {.fill = page.theme().outline});
    }
  }
  const Rect square{left, top, edge(m), edge(m)};
  page.canvas().rect(square, {.outline = page.theme().outline, .outline_width = page.sizes().outline});
  return square;
}

List<Shot> stored_shots(const StoredRun& run) {
  List<Shot> shots = {question_shot(card(), question_frame(run))};
  for (int row = 0; row < run.problems[small].row_count(); ++row) shots.push_back(row_shot(run, row));
  shots.push_back(
      key_shot(run, "three patterns",
               "The patterns of A for pyramids of base 3, 5 and 10: three bands of entries that get "
               "thinner.",
               draw_patterns));
  for (Shot& shot : cost_shots(run)) shots.push_back(std::move(shot));
  const Count& count = run.pyramids[largest];
  shots.push_back(answer_shot(
      card(), answer_frame(run),
      fmt::format("14 of {:g}, as many as in any row inside the pyramid, however high it is. On average it "
                  "is {:.1f}.",
                  count.rows, count.non_zeros / count.rows)));
  return shots;
}

}  // namespace cairn::stored
