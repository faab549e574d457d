// Elimination, λ from the top down, the velocities after it, and what a larger stack would cost.
#include "lesson.hpp"

namespace cairn::big {

namespace {

/// "(0, −1, 2 | 0)", times a factor.
std::string row_in_numbers(const Eigen::MatrixXd& stage, int row, double factor) {
  std::string text;
  for (Eigen::Index k = 0; k < stage.cols(); ++k) {
    const char* const before = k == 0 ? "(" : k + 1 == stage.cols() ? " | " : ", ";
    text += before + brief(factor * stage(row, k) + 0.0);
  }
  return text + ")";
}

void draw_elimination(Page& page, const StackRun& run, int row) {
  const List<Rect> parts = in_columns(page, {0.3, {0.7, {0.52, 0.48}}});
  draw_stack(page, parts[0], run, {.contact = row});
  const Eigen::MatrixXd &before = run.stages[row - 1], &after = run.stages[row];
  List<MatrixView> both = system_views(run, before, row);
  for (const MatrixView& view : system_views(run, after, row)) both.push_back(view);
  draw_product(page, parts[1], both, {"λ =", "→", "λ ="});
  const double factor = before(row, row - 1) / before(row - 1, row - 1);
  page.equation(parts[2],
                {.number = fmt::format("row {} loses its λ_{{{}}}", row + 1, row),
                 .symbols = fmt::format("row {} − {} × row {}", row + 1, in_brackets(brief(factor)), row),
                 .numbers = fmt::format("= {} + {}", row_in_numbers(before, row, 1),
                                        row_in_numbers(before, row - 1, -factor)),
                 .result = "= " + row_in_numbers(after, row, 1),
                 .algorithm = row + 1 == run.boxes() ? "this row has a single λ left" : ""});
}

void draw_back(Page& page, const StackRun& run, int row) {
  const int n = run.boxes();
  const List<Rect> parts = in_columns(page, {0.38, {0.62, {0.52, 0.48}}});
  draw_stack(page, parts[0], run, {.contact = row, .known = n - row});
  draw_product(page, parts[1], system_views(run, run.stages.back(), row), {"λ ="});
  const Eigen::MatrixXd& last = run.stages.back();
  const std::string pivot = brief(last(row, row));
  const bool is_last = row + 1 == n;
  const std::string symbols =
      is_last
          ? fmt::format("λ_{{{0}}} = b_{{{0}}} / A_{{{0}{0}}}", n)
          : fmt::format("λ_{{{0}}} = (b_{{{0}}} − A_{{{0}{1}}} λ_{{{1}}}) / A_{{{0}{0}}}", row + 1, row + 2);
  const std::string numbers =
      is_last ? fmt::format("= {} / {}", brief(last(row, n)), pivot)
              : fmt::format("= ({} − {} × {}) / {}", brief(last(row, n)),
                            in_brackets(brief(last(row, row + 1))), brief(run.lambda(row + 1)), pivot);
  page.equation(parts[2], {.number = "eq (14)",
                           .symbols = symbols,
                           .numbers = numbers,
                           .result = fmt::format("= {} N", brief(run.lambda(row))),
                           .color = page.theme().normal});
}

void draw_velocities(Page& page, const StackRun& run) {
  const int n = run.boxes();
  const List<Rect> parts = in_columns(page, {0.4, {0.6, {0.42, 0.58}}});
  draw_stack(page, parts[0], run, {.known = n, .velocity = run.velocity});
  TableView table;
  table.header = {"box", "v_{1} (m/s)", "from below (N)", "from above (N)", "v_{2} (m/s)"};
  for (int i = n - 1; i >= 0; --i) {
    table.rows.push_back({fmt::format("{}", i + 1), fixed(run.system.velocity(3 * i + 1), 3),
                          fixed(run.lambda(i), 2), i + 1 < n ? fixed(-run.lambda(i + 1), 2) : "·",
                          fixed(run.velocity(3 * i + 1) + 0.0, 3)});
  }
  table.active_row = n - 1;
  page.table(parts[1], "M^{−1} J^{T} λ Δt, box by box", table);
  page.equation(
      parts[2],
      {.number = "eq (12), box 1",
       .symbols = "v_{2} = v_{1} + (λ_{1} − λ_{2}) Δt / m",
       .numbers = fmt::format("= {} + ({} − {}) × {}", fixed(run.system.velocity(1), 3),
                              fixed(run.lambda(0), 2), fixed(run.lambda(1), 2), brief(run.settings.dt)),
       .result = fmt::format("= {} m/s", fixed(run.velocity(1) + 0.0, 3)),
       .algorithm = run.settings.sunk > 0 ? "(11): J v = ζ" : "(11): J v = 0, and nothing falls",
       .color = page.theme().velocity});
}

void draw_without_gravity(Page& page, const StackRun& run) {
  const List<Rect> parts = in_columns(page, {0.4, {0.6, {0.4, 0.25, 0.35}}});
  draw_stack(page, parts[0], run, {.velocity = run.velocity_without});
  page.note(parts[1], "A trap",
            "(12) has no force in it but those of the rows. If v_{1} is the velocity of a "
            "stack at rest, and gravity comes afterwards, b does not know of it: no contact "
            "carries any weight, and the stack falls.");
  TableView table;
  table.header = {"gravity is added", "b_{1} (m/s²)", "λ_{1} (N)", "v after (m/s)"};
  const double b = run.system.zeta(0) / run.settings.dt;
  table.rows = {
      {"before b", brief(run.system.b(0)), fixed(run.lambda(0), 2), fixed(run.velocity(1) + 0.0, 3)},
      {"after", brief(b), fixed(run.lambda_without(0) + 0.0, 2), fixed(run.velocity_without(1), 3)}};
  table.active_row = 1;
  page.table(parts[2], "the lowest box", table);
  const std::string dt = brief(run.settings.dt);
  page.equation(parts[3], {.number = "eq (15), at rest",
                           .symbols = "b_{1} = ζ/Δt − j_{1}·v_{1}/Δt",
                           .numbers = fmt::format("= {}/{} − 0/{}", brief(run.system.zeta(0)), dt, dt),
                           .result = fmt::format("= {} m/s²", brief(b))});
}

Shot back_shot(const StackRun& run, int row) {
  return {
      .state = fmt::format("λ of row {}", row + 1),
      .alt = fmt::format("After elimination row {} gives {:.4g} N; pushes that are known stand beside the "
                         "stack.",
                         row + 1, run.lambda(row)),
      .draw = [&run, row](Page& page) { draw_back(page, run, row); },
      .key = row == 0};
}

}  // namespace

List<Shot> solving_shots(const StackRun& run) {
  const int n = run.boxes();
  List<Shot> shots;
  for (int row = 1; row < n; ++row) {
    shots.push_back(
        {.state = fmt::format("elimination · row {}", row + 1),
         .alt = fmt::format("A and b once λ of row {} has been eliminated from row {}.", row, row + 1),
         .draw = [&run, row](Page& page) { draw_elimination(page, run, row); },
         .key = row + 1 == n});
  }
  for (int row = n - 1; row >= 0; --row) shots.push_back(back_shot(run, row));
  shots.push_back(key_shot(run, "v₂ = v₁ + M⁻¹ Jᵀ λ Δt",
                           "Velocities before and after, and the two pushes upon each box.",
                           draw_velocities));
  shots.push_back(key_shot(run, "gravity after b",
                           "The same stack with gravity added after b was formed: no contact holds it.",
                           draw_without_gravity));
  return shots;
}

}  // namespace cairn::big
