// Matrices as heat maps. A small one is cells with numbers, a large one a spy plot.
#include "render/matrix.hpp"

#include <algorithm>
#include <cmath>

#include "render/matrix_grid.hpp"

namespace cairn::render {
namespace {

constexpr double largest_cell = 64;   // [px]
constexpr double cell_of_lines = 5;   // [px] smaller cells have no lines between them, and no dots
constexpr double faintest = 0.12;     // how much colour the smallest number has that is not zero
constexpr double faintest_dot = 0.5;  // the same in cells so small that less would not be seen
// What cancels exactly on paper leaves rounding errors behind; relative to the largest entry they are zero.
constexpr double zero_tolerance = 1e-13;

Color mix(Color from, Color to, double part) {
  const float t = static_cast<float>(part);
  return {from.r + t * (to.r - from.r), from.g + t * (to.g - from.g), from.b + t * (to.b - from.b), 1};
}

// Of each block of `block` x `block` entries the one that matters most: not a number, else the largest.
Eigen::MatrixXd thinned(const Eigen::MatrixXd& values, Eigen::Index block) {
  Eigen::MatrixXd result =
      Eigen::MatrixXd::Zero((values.rows() + block - 1) / block, (values.cols() + block - 1) / block);
  for (Eigen::Index j = 0; j < values.cols(); ++j) {
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
      double& kept = result(i / block, j / block);
      if (std::isnan(kept)) continue;
      if (!(std::abs(values(i, j)) <= std::abs(kept))) kept = values(i, j);
    }
  }
  return result;
}

double largest_finite(const Eigen::MatrixXd& values) {
  double largest = 0;
  for (const double value : values.reshaped()) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  return largest;
}

// Whole pixels for a cell where it has any, so that all cells look alike.
MatrixGrid lay_out(Page& page, const Rect& rect, const MatrixView& view) {
  MatrixGrid grid = {.page = page,
                     .view = view,
                     .shown = view.values,
                     .largest = std::max(largest_finite(view.values), view.strongest)};
  const double top = view.title.empty() ? 2 : std::round(1.7 * matrix_title(page).size);
  const double names =
      view.row_names.empty() ? 0 : std::ceil(widest_name(page, view.row_names)) + matrix_name_gap;
  const double left = std::max(2.0, std::min(names, rect.width / 2));
  const double bottom = view.column_names.empty() ? 2 : std::round(1.6 * matrix_names(page).size);
  const double width = std::max(1.0, rect.width - left - 2);
  const double height = std::max(1.0, rect.height - top - bottom);
  const auto fits = [&](Eigen::Index rows, Eigen::Index columns) {
    return std::min({largest_cell, width / static_cast<double>(columns), height / static_cast<double>(rows)});
  };
  if (const double cell = fits(grid.shown.rows(), grid.shown.cols()); cell < 1) {
    grid.shown = thinned(view.values, static_cast<Eigen::Index>(std::ceil(1 / cell)));
  }
  grid.cell = std::max(1.0, std::floor(fits(grid.shown.rows(), grid.shown.cols())));
  grid.cells = {std::round(rect.x + left), std::round(rect.y + top),
                grid.cell * static_cast<double>(grid.shown.cols()),
                grid.cell * static_cast<double>(grid.shown.rows())};
  return grid;
}

void draw_cells(MatrixGrid& grid) {
  const Theme& theme = grid.page.theme();
  Canvas& canvas = grid.page.canvas();
  canvas.rect(grid.cells, {.fill = theme.background});
  for (Eigen::Index row = 0; row < grid.shown.rows(); ++row) {
    for (Eigen::Index column = 0; column < grid.shown.cols(); ++column) {
      const double value = grid.shown(row, column);
      const Rect rect = cell_rect(grid, row, column);
      if (is_unknown(grid, row, column)) {
        const Point corner(rect.x, rect.y), right(grid.cell, 0), down(0, grid.cell);
        canvas.hatch(List<Point>{corner, corner + right, corner + right + down, corner + down},
                     {.width = 1, .color = theme.frame_line}, 8);
      } else if (!is_zero(grid, value)) {
        canvas.rect(rect, {.fill = color_of(grid, value)});
      } else if (grid.cell >= 2 * cell_of_lines) {
        canvas.circle(middle_of(rect), grid.cell >= matrix_cell_of_text ? 2 : 0.75,
                      {.fill = theme.secondary_text});
      }
    }
  }
}

void draw_lines(MatrixGrid& grid) {
  Canvas& canvas = grid.page.canvas();
  const Theme& theme = grid.page.theme();
  const Rect& cells = grid.cells;
  const auto vertical = [&](double column, const Stroke& stroke, double shift) {
    const double x = cells.x + grid.cell * column + shift;
    canvas.line({x, cells.y}, {x, cells.y + cells.height}, stroke);
  };
  const Stroke thin = {.width = 1, .color = theme.frame_line};
  if (grid.cell >= cell_of_lines) {  // on pixel centres
    for (Eigen::Index i = 1; i < grid.shown.cols(); ++i) vertical(static_cast<double>(i), thin, -0.5);
    for (Eigen::Index i = 1; i < grid.shown.rows(); ++i) {
      const double y = cells.y + grid.cell * static_cast<double>(i) - 0.5;
      canvas.line({cells.x, y}, {cells.x + cells.width, y}, thin);
    }
  }
  const bool small = grid.cell < cell_of_lines;
  const int group = grid.thinned() ? 0 : grid.view.column_group;
  for (int i = group; i > 0 && i < grid.shown.cols(); i += group) {
    vertical(i, {.width = small ? 1.0 : 2.0, .color = small ? theme.frame_line : theme.text},
             small ? 0.5 : 0);
  }
  canvas.rect(inset(cells, -1), {.outline = theme.text, .outline_width = 2});
}

void frame_cells(MatrixGrid& grid, const Rect& frame, double width) {
  const Theme& theme = grid.page.theme();
  // Around small cells it would hide the neighbours.
  const bool roomy = grid.cell >= 36;
  const Rect around = inset(frame, roomy ? -3 : -1);
  if (roomy) grid.page.canvas().rect(around, {.outline = theme.background, .outline_width = width + 3}, 2);
  grid.page.canvas().rect(around, {.outline = theme.text, .outline_width = roomy ? width : 2}, 2);
}

void frame_active(MatrixGrid& grid) {
  if (grid.thinned()) return;
  const int row = grid.view.active_row;
  const int column = grid.view.active_column;
  const bool has_row = row >= 0 && row < grid.shown.rows();
  const bool has_column = column >= 0 && column < grid.shown.cols();
  const double width = grid.page.sizes().active_outline;
  const Rect first = cell_rect(grid, std::max(row, 0), std::max(column, 0));
  if (has_row) frame_cells(grid, {grid.cells.x, first.y, grid.cells.width, grid.cell}, width);
  if (has_column) frame_cells(grid, {first.x, grid.cells.y, grid.cell, grid.cells.height}, width);
  if (has_row && has_column) frame_cells(grid, first, 2 * width);
}

}  // namespace

Rect cell_rect(const MatrixGrid& grid, Eigen::Index row, Eigen::Index column) {
  return {grid.cells.x + grid.cell * static_cast<double>(column),
          grid.cells.y + grid.cell * static_cast<double>(row), grid.cell, grid.cell};
}

bool is_unknown(const MatrixGrid& grid, Eigen::Index row, Eigen::Index column) {
  if (grid.thinned()) return false;
  const auto& unknown = grid.view.unknown;
  return std::find(unknown.begin(), unknown.end(),
                   std::pair(static_cast<int>(row), static_cast<int>(column))) != unknown.end();
}

bool is_zero(const MatrixGrid& grid, double value) {
  return std::abs(value) <= zero_tolerance * grid.largest;
}

Color color_of(const MatrixGrid& grid, double value) {
  const Theme& theme = grid.page.theme();
  if (std::isnan(value)) return theme.text;
  if (is_zero(grid, value)) return theme.background;
  const double least = grid.cell < cell_of_lines ? faintest_dot : faintest;
  const double part = std::isinf(value) ? 1 : least + (1 - least) * std::abs(value) / grid.largest;
  if (grid.view.colors == MatrixColors::magnitude) return mix(theme.grid, theme.secondary_text, part);
  return mix(theme.background, value > 0 ? theme.positive : theme.negative, part);
}

void draw_matrix(Page& page, const Rect& rect, const MatrixView& view) {
  if (view.values.size() == 0) return;
  MatrixGrid grid = lay_out(page, rect, view);
  draw_cells(grid);
  draw_lines(grid);
  frame_active(grid);
  write_matrix_texts(grid, rect);
}

}  // namespace cairn::render
