// J row by row, A entry by entry, b row by row: where each number comes from.
#include "lesson.hpp"

namespace cairn::big {

namespace {

using Entry = std::pair<int, int>;

/// The first `rows_known` rows of J.
MatrixView view_of_J(const StackRun& run, int rows_known, int active) {
  MatrixView view{.title = "J, without the ground's columns",
                  .values = run.system.J,
                  .row_names = row_names(run.boxes()),
                  .column_names = column_names(run.boxes()),
                  .column_group = 3,
                  .active_row = active};
  for (int row = rows_known; row < run.boxes(); ++row) {
    for (int column = 0; column < 3 * run.boxes(); ++column) view.unknown.push_back({row, column});
  }
  return view;
}

void draw_row(Page& page, const StackRun& run, int row) {
  const List<Rect> parts = in_columns(page, {0.4, {0.6, {0.46, 0.54}}});
  draw_stack(page, parts[0], run, {.contact = row, .velocity = run.system.velocity});
  draw_product(page, parts[1], {view_of_J(run, row + 1, row)}, {});
  const double v = run.system.velocity(1);
  const std::string below = row > 0 ? fmt::format("−1 × {} + ", in_brackets(fixed(v, 3))) : "";
  page.equation(
      parts[2],
      {.number = "eq (5)",
       .symbols =
           row > 0 ? fmt::format("j_{{{0}}}·v = −v_{{y{1}}} + v_{{y{0}}}", row + 1, row) : "j_{1}·v = v_{y1}",
       .numbers = fmt::format("= {}1 × {}", below, in_brackets(fixed(v, 3))),
       .result = fmt::format("= {} m/s", fixed(run.row_velocity(row) + 0.0, 3)),
       .algorithm = row > 0 ? fmt::format("how fast boxes {} and {}, body a and body b, part", row, row + 1)
                            : "how fast box 1 leaves the ground"});
}

/// The entries of A that come after this one, row by row; A is symmetric.
List<Entry> entries_after(const StackRun& run, const Entry& last) {
  List<Entry> unknown;
  for (int i = 0; i < run.boxes(); ++i) {
    for (int j = 0; j < run.boxes(); ++j) {
      if (Entry(std::minmax(i, j)) > last) unknown.push_back({i, j});
    }
  }
  return unknown;
}

/// Left the stack; returns the upper part at the right, and two below it.
List<Rect> lay_out_building(Page& page, const StackRun& run, const StackView& stack, double left) {
  const List<Rect> parts = in_columns(page, {0.36, {0.64, {0.42, {0.58, {left, 1 - left}}}}});
  draw_stack(page, parts[0], run, stack);
  return {parts[1], parts[2], parts[3]};
}

/// "1 × 1 × (−1) + 0 × 1 × 1": one product for each box that is in either row; only y is not 0.
std::string entry_in_numbers(const StackRun& run, int i, int j) {
  std::string sum;
  for (int box = 0; box < run.boxes(); ++box) {
    const double left = run.system.J(i, 3 * box + 1), right = run.system.J(j, 3 * box + 1);
    if (left == 0 && right == 0) continue;
    sum += fmt::format("{}{} × {} × {}", sum.empty() ? "" : " + ", in_brackets(brief(left)),
                       brief(run.system.inverse_mass(3 * box + 1)), in_brackets(brief(right)));
  }
  return sum;
}

void draw_entry(Page& page, const StackRun& run, int i, int j) {
  const bool shared = j == i + 1;
  const List<Rect> parts = lay_out_building(page, run, {.row = i, .other_row = i == j ? -1 : j}, 0.34);
  MatrixView J{.column_names = column_names(run.boxes()), .column_group = 3};
  J.title = i == j ? fmt::format("row {} of J", i + 1) : fmt::format("rows {} and {} of J", i + 1, j + 1);
  J.values.resize(i == j ? 1 : 2, 3 * run.boxes());
  J.values.row(0) = run.system.J.row(i);
  J.values.row(J.values.rows() - 1) = run.system.J.row(j);
  for (const int row : i == j ? List<int>{i} : List<int>{i, j})
    J.row_names.push_back(row_names(row + 1).back());
  draw_product(page, parts[0], {J}, {});
  draw_product(page, parts[1],
               {{.title = "A (kg^{−1})",
                 .values = run.system.A,
                 .row_names = row_names(run.boxes()),
                 .column_names = row_names(run.boxes()),
                 .active_row = i,
                 .active_column = j,
                 .unknown = entries_after(run, {i, j})}},
               {});
  const std::string reason = shared   ? fmt::format("box {} is in both rows", i + 1)
                             : i == j ? "a row with itself"
                                      : "no box is in both rows";
  page.equation(parts[2],
                {.number = "eq (15)",
                 .symbols = fmt::format("A_{{{0}{1}}} = j_{{{0}}} M^{{−1}} j_{{{1}}}^{{T}}", i + 1, j + 1),
                 .numbers = "= " + entry_in_numbers(run, i, j),
                 .result = fmt::format("= {} kg^{{−1}}", brief(run.system.A(i, j))),
                 .algorithm = reason});
}

void draw_right_side(Page& page, const StackRun& run, int row) {
  const int n = run.boxes();
  const List<Rect> parts =
      lay_out_building(page, run, {.contact = row, .velocity = run.system.velocity}, 0.48);
  draw_product(page, parts[0], {view_of_J(run, n, row)}, {});
  List<MatrixView> system = system_views(run, row);
  for (int later = row + 1; later < n; ++later) system[1].unknown.push_back({later, 0});
  draw_product(page, parts[1], system, {"λ ="});
  const std::string dt = brief(run.settings.dt);
  const double jv = run.row_velocity(row) + 0.0;
  const std::string reason = row == 0 ? fmt::format("box 1 approaches the ground at {} m/s", brief(-jv))
                                      : fmt::format("boxes {} and {} fall alike: 0", row, row + 1);
  page.equation(parts[2], {.number = "eq (15)",
                           .symbols = fmt::format("b_{{{0}}} = ζ/Δt − j_{{{0}}}·v_{{1}}/Δt", row + 1),
                           .numbers = fmt::format("= {}/{} − {}/{}", brief(run.system.zeta(row)), dt,
                                                  in_brackets(brief(jv)), dt),
                           .result = fmt::format("= {} m/s²", brief(run.system.b(row))),
                           .algorithm = reason});
}

Shot entry_shot(const StackRun& run, int i, int j) {
  return {.state = fmt::format("A · row {}, column {}", i + 1, j + 1),
          .alt = fmt::format(
              "Two rows of J, the boxes that they have, and A as far as it is known: entry {}, {} is "
              "{:.4g} per kg.",
              i + 1, j + 1, run.system.A(i, j)),
          .draw = [&run, i, j](Page& page) { draw_entry(page, run, i, j); },
          .key = i == 0 && j == 1};
}

}  // namespace

List<Shot> building_shots(const StackRun& run) {
  const int n = run.boxes();
  List<Shot> shots;
  for (int row = 0; row < n; ++row) {
    shots.push_back({.state = fmt::format("J · row {} of {}", row + 1, n),
                     .alt = fmt::format("Row {} of J; its boxes part at {:.3f} m/s.", row + 1,
                                        run.row_velocity(row) + 0.0),
                     .draw = [&run, row](Page& page) { draw_row(page, run, row); },
                     .key = row == 1});
  }
  for (int i = 0; i < n; ++i) {
    for (int j = i; j < n; ++j) shots.push_back(entry_shot(run, i, j));
  }
  for (int row = 0; row < n; ++row) {
    shots.push_back({.state = fmt::format("b · row {} of {}", row + 1, n),
                     .alt = fmt::format("A and b as far as it is known: b of row {} is {:.4g} m/s².", row + 1,
                                        run.system.b(row) + 0.0),
                     .draw = [&run, row](Page& page) { draw_right_side(page, run, row); },
                     .key = row == 0});
  }
  return shots;
}

}  // namespace cairn::big
