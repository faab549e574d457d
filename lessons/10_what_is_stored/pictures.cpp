// The question, the smallest pyramid row by row beside its A, the pattern of a larger one, and the answer.
#include "parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "lessons/question.hpp"
#include "math/list.hpp"
#include "render/draw.hpp"
#include "render/matrix.hpp"

namespace cairn::stored {

namespace {

using render::Page;
using render::Point;
using render::Rect;

constexpr int smallest = 0;  // of the pyramids
constexpr int middle = 2;
constexpr int largest = 3;

void draw_pyramid(Page& page, const Rect& rect, const StoredRun& run, int which) {
  const Rect inside = page.panel(rect, "");
  const double base = run.pyramids[which].base;
  const double half = 0.5 * run.settings.spacing * base + 0.3;
  const render::Camera camera = render::fit(inside, {{-half, -0.5}, {half, base + 0.3}});
  render::WorldLook look;
  look.contacts = false;
  look.penetration = false;
  look.numbers = camera.scale > 30;
  draw_world(page, camera, run.snapshots[which], look);
}

/// Whether rows i and j of the smallest pyramid meet in A.
bool meet(const Eigen::MatrixXd& A, int i, int j) { return std::abs(A(i, j)) > 1e-12; }

/// The contacts of the smallest pyramid: the active one, those that it meets, and the others.
void draw_met(Page& page, const Rect& rect, const StoredRun& run, const Eigen::MatrixXd& A, int active) {
  const Rect inside = page.panel(rect, "");
  const double half = 0.5 * run.settings.spacing * 3 + 0.4;
  const render::Camera camera = render::fit(inside, {{-half, -0.5}, {half, 3.3}});
  const VelocityProblem<double>& problem = run.problems[smallest];
  const ConstraintRow<double>& row = problem.rows[active];
  render::WorldLook look;
  look.contacts = false;
  look.penetration = false;
  look.active_a = row.a;
  look.active_b = row.b;
  draw_world(page, camera, run.snapshots[smallest], look);
  const List<SnapshotContact>& contacts = run.snapshots[smallest].contacts;
  render::TextStyle style = page.tick();
  for (int j = 0; j < contacts.size(); ++j) {
    const Point at = camera.project(contacts[j].position);
    const bool is_met = meet(A, active, j);
    const double radius = j == active ? page.sizes().new_contact : page.sizes().contact;
    page.canvas().circle(at, radius,
                         {.fill = is_met ? page.theme().normal : page.theme().inactive,
                          .outline = page.theme().outline,
                          .outline_width = j == active ? 2.0 : 0.0});
    style.bold = is_met;
    // The two points of an overlap have their numbers between them, in the upper and in the lower box.
    const bool is_left = j % 2 == 0;
    const bool is_above = is_left || problem.rows[j].a == ground;
    style.align = is_left ? render::Align::left : render::Align::right;
    const Point beside(at.x() + (is_left ? 8 : -8), at.y() + (is_above ? -7 : 7 + 0.8 * style.size));
    page.canvas().text(beside, fmt::format("{}", j + 1), style);
  }
}

std::string body_name(BodyId body) {
  return body == ground ? "the ground" : fmt::format("box {}", body.index);
}

void draw_row(Page& page, const StoredRun& run, int active) {
  const List<Rect> halves = columns(page.area(), {0.44, 0.56}, page.sizes().gap);
  const List<Rect> left = rows(halves[0], {0.62, 0.38}, page.sizes().gap);
  const VelocityProblem<double>& problem = run.problems[smallest];
  const Eigen::MatrixXd A = system_matrices(problem).A;
  draw_met(page, left[0], run, A, active);
  const ConstraintRow<double>& row = problem.rows[active];
  int met = 0;
  for (int j = 0; j < problem.row_count(); ++j) met += meet(A, active, j);
  page.note(left[1], "",
            fmt::format("Row {}: {} and {}. A push here changes how {} of {} contacts close in, "
                        "itself among them: those on the same boxes. All else in this row of A is 0.",
                        active + 1, body_name(row.a), body_name(row.b), met, problem.row_count()));
  render::MatrixView view{
      .title = "A, base 3: red > 0, blue < 0", .values = A, .active_row = active, .numbers = false};
  for (int j = 1; j <= problem.row_count(); ++j) view.row_names.push_back(fmt::format("{}", j));
  view.column_names = view.row_names;
  draw_matrix(page, halves[1], view);
}

/// Dark: in A. Grey, as all that does nothing: zero in A, and counted by (30).
render::Color colour_of(const render::Theme& theme, Entry entry) {
  return entry == Entry::printed_only ? theme.inactive : theme.outline;
}

/// The pattern of a pyramid's A as large as `rect` allows; what lies together in a row is drawn in one piece,
/// on whole pixels, or seams would show.
void draw_entries(Page& page, const Rect& rect, const StoredRun& run, int which) {
  const List<List<Entry>> entries = pattern(run.problems[which]);
  const int m = entries.size();
  const double side = std::min(rect.width, rect.height);
  const double left = std::round(rect.x), top = std::round(rect.y);
  const auto edge = [&](int k) { return std::round(side * k / m); };
  for (int i = 0; i < m; ++i) {
    const double height = std::max(1.0, edge(i + 1) - edge(i));
    for (int first = 0, end = 0; first < m; first = end) {
      while (end < m && entries[i][end] == entries[i][first]) ++end;
      if (entries[i][first] == Entry::zero) continue;
      page.canvas().rect({left + edge(first), top + edge(i), edge(end) - edge(first), height},
                         {.fill = colour_of(page.theme(), entries[i][first])});
    }
  }
  page.canvas().rect({left, top, edge(m), edge(m)},
                     {.outline = page.theme().outline, .outline_width = page.sizes().outline});
}

/// What the two colours of a pattern say.
void draw_colours(Page& page, const Rect& rect) {
  const Rect inside = page.panel(rect, "");
  const double side = page.label().size;
  double y = inside.y + 4;
  const List<std::pair<render::Color, const char*>> meanings = {
      {colour_of(page.theme(), Entry::true_entry), "in A"},
      {colour_of(page.theme(), Entry::printed_only), "counted by (30), 0 in A"}};
  for (const auto& meaning : meanings) {
    page.canvas().rect({inside.x, y, side, side}, {.fill = meaning.first});
    page.canvas().text({inside.x + side + 8, y + 0.85 * side}, meaning.second, page.label());
    y += 1.6 * side;
  }
}

void draw_pattern(Page& page, const StoredRun& run) {
  const List<Rect> parts = columns(page.area(), {0.56, 0.44}, page.sizes().gap);
  draw_entries(page, parts[0], run, middle);
  const List<double> weights = List<double>{0.16, 0.36, 0.48};
  const List<Rect> right = rows(parts[1], weights, page.sizes().gap);
  draw_colours(page, right[0]);
  const Count& count = run.pyramids[middle];
  render::TableView table{.header = {"base 10", "numbers"}};
  table.rows = {{"full A", fmt::format("{:.0f}", count.dense)},
                {"(30) as printed", fmt::format("{:.0f}", count.printed)},
                {"not zero", fmt::format("{:.0f}", count.non_zeros)},
                {"SI", fmt::format("{:.0f}", count.rows)}};
  page.table(right[1], "", table);
  page.note(right[2], "",
            "Grey: the lowest boxes have only the ground in common. It cannot be moved, so "
            "nothing that one does reaches the other. (30) has no M^{−1} and counts them.",
            question_growth);
}

void draw_two_patterns(Page& page, const StoredRun& run) {
  const List<Rect> panels = columns(page.area(), {0.37, 0.37, 0.26}, page.sizes().gap);
  for (const int which : {smallest, smallest + 1}) {
    const List<Rect> parts = rows(panels[which], {0.76, 0.24}, page.sizes().gap);
    const Rect inside = page.panel(parts[0], fmt::format("base {}: {:g} × {:g}", run.pyramids[which].base,
                                                         run.pyramids[which].rows, run.pyramids[which].rows));
    draw_entries(page, inside, run, which);
    draw_pyramid(page, parts[1], run, which);
  }
  page.note(panels[2], "",
            "Dark: rows that share a box, not 0. Grey: rows that share only the ground, 0 in "
            "A, but counted by (30). The larger the pyramid, the emptier is A.",
            question_growth);
}

void draw_question(Page& page, const StoredRun& run) {
  const List<Rect> halves = columns(page.area(), {0.52, 0.48}, page.sizes().gap);
  draw_pyramid(page, halves[0], run, largest);
  const Count& count = run.pyramids[largest];
  const List<Rect> right = rows(halves[1], {0.6, 0.4}, page.sizes().gap);
  page.note(
      right[0], "The question",
      fmt::format("{} boxes, two rows for each overlap: m = {:.0f} rows. A full A has m × m entries, and SI "
                  "keeps m numbers. How many entries in an average row of A are not zero?",
                  count.bodies, count.rows),
      question_growth);
  page.equation(right[1], {.number = "numbers to keep",
                           .symbols = fmt::format("SI: m = {:.0f}", count.rows),
                           .numbers = fmt::format("full A: m × m = {:.0f}", count.dense),
                           .result = "A without its zeros: m × ?"});
}

void draw_answer(Page& page, const StoredRun& run) {
  const List<Rect> halves = columns(page.area(), {0.5, 0.5}, page.sizes().gap);
  const Rect inside = page.panel(halves[0], fmt::format("base {0}: {1:g} × {1:g}", run.pyramids[largest].base,
                                                        run.pyramids[largest].rows));
  draw_entries(page, inside, run, largest);
  const List<Rect> parts = rows(halves[1], {0.44, 0.56}, page.sizes().gap);
  render::TableView table;
  table.header = {"", "rows", "full A", "(30)", "not zero", "SI"};
  for (const Count& count : run.pyramids) {
    table.rows.push_back({count.name, fmt::format("{:.0f}", count.rows), fmt::format("{:.0f}", count.dense),
                          fmt::format("{:.0f}", count.printed), fmt::format("{:.0f}", count.non_zeros),
                          fmt::format("{:.0f}", count.rows)});
  }
  table.active_row = largest;
  page.table(parts[0], "numbers to keep", table);
  const Count& count = run.pyramids[largest];
  page.note(parts[1], "The answer",
            fmt::format("{:.1f} of {:.0f}, and never more than 14. PGS without the zeros grows like m, as SI "
                        "does, and does the same work in a sweep: {:.0f} multiply-adds against {:.0f}. "
                        "Memory remains, and the work of building A in every step.",
                        count.non_zeros / count.rows, count.rows, work_of(count).sparse, work_of(count).si),
            question_growth);
}

Shot row_shot(const Run& run, int row) {
  return {.state = fmt::format("row {} of {}", row + 1, run->problems[smallest].row_count()),
          .alt = fmt::format("A pyramid of six boxes: contact {} is lit with all contacts on the same boxes; "
                             "beside it A as a heat map with row {} framed.",
                             row + 1, row + 1),
          .draw = [run, row](Page& page) { draw_row(page, *run, row); },
          .key = row == 0 || row == 8};
}

}  // namespace

List<Shot> stored_shots(const StoredRun& recorded) {
  const Run run = std::make_shared<const StoredRun>(recorded);
  List<Shot> shots;
  shots.push_back(
      {.state = "count first",
       .alt = "A large pyramid of boxes, the count of a full A and of what SI keeps, and the question.",
       .draw = [run](Page& page) { draw_question(page, *run); },
       .key = true});
  for (int row = 0; row < run->problems[smallest].row_count(); ++row) shots.push_back(row_shot(run, row));
  shots.push_back({.state = "base 3 and 5",
                   .alt =
                       "The patterns of A for pyramids of base 3 and 5: entries in A, and entries that only "
                       "equation 30 counts.",
                   .draw = [run](Page& page) { draw_two_patterns(page, *run); },
                   .key = true});
  shots.push_back({.state = "base 10",
                   .alt =
                       "The pattern of A for 200 rows: a narrow band, and what equation 30 counts beside it, "
                       "with four numbers to compare.",
                   .draw = [run](Page& page) { draw_pattern(page, *run); },
                   .key = true});
  for (const List<Shot>& part : {case_shots(run), cost_shots(run)}) {
    shots.insert(shots.end(), part.begin(), part.end());
  }
  shots.push_back(
      {.state = "answer",
       .alt = "The pattern of A for 800 rows, a thin band; what is stored for four pyramids; and the answer.",
       .draw = [run](Page& page) { draw_answer(page, *run); },
       .key = true});
  return shots;
}

}  // namespace cairn::stored
