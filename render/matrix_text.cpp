// All text of a matrix: title, names, and numbers in the cells.
#include <algorithm>
#include <cmath>

#include <cairn/math/list.hpp>
#include "render/lint.hpp"
#include "render/matrix_grid.hpp"
#include "render/text_layout.hpp"

namespace cairn::render {
namespace {

std::string number_of(double value, int digits, Sign sign) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value < 0 ? "−∞" : sign == Sign::always ? "+∞" : "∞";
  return (value > 0 && sign == Sign::always ? "+" : "") + significant(value, digits);
}

struct NumberFormat {
  int digits = 3;
  Sign sign = Sign::always;
  double size = 0;  // [px]
};

// The width of the widest number at the smallest size [px].
double widest_number(const MatrixGrid& grid, const NumberFormat& format, const TextStyle& style) {
  double width = 0;
  for (const double value : grid.shown.reshaped()) {
    if (is_zero(grid, value)) continue;
    const std::string text = number_of(value, format.digits, format.sign);
    width = std::max(width, grid.page.canvas().text_width(text, style));
  }
  return width;
}

TextStyle number_style(const MatrixGrid& grid, double size) {
  TextStyle style = grid.page.value();
  style.bold = true;
  style.size = size;
  style.align = Align::center;
  return style;
}

// One format for the whole matrix: as many digits as fit, then as large as fits. Colour tells the sign, too,
// so "+" goes before digits go. The last format may leave some numbers out.
NumberFormat format_of(const MatrixGrid& grid) {
  const Sign sign = grid.view.colors == MatrixColors::magnitude ? Sign::negative_only : Sign::always;
  const FixedList<NumberFormat, 4> formats = {{{.digits = 3, .sign = sign},
                                               {.digits = 3, .sign = Sign::negative_only},
                                               {.digits = 2, .sign = sign},
                                               {.digits = 2, .sign = Sign::negative_only}}};
  const double room = grid.cell - 5;
  const double smallest = grid.page.sizes().smallest;
  for (NumberFormat format : formats) {
    const double width = widest_number(grid, format, number_style(grid, smallest));
    if (width > room) continue;
    const double largest = std::min(grid.page.value().size, 0.5 * grid.cell);
    const double fitting = width > 0 ? std::floor(smallest * room / width) : largest;
    format.size = std::max(smallest, std::min(largest, fitting));
    return format;
  }
  NumberFormat last = formats.back();
  last.size = smallest;
  return last;
}

// The halo has the cell's colour: unseen, and it tells lint() what the number stands on.
void write_numbers(MatrixGrid& grid) {
  if (!grid.view.numbers || grid.cell < matrix_cell_of_text) return;
  const NumberFormat format = format_of(grid);
  TextStyle style = number_style(grid, format.size);
  for (Eigen::Index row = 0; row < grid.shown.rows(); ++row) {
    for (Eigen::Index column = 0; column < grid.shown.cols(); ++column) {
      const double value = grid.shown(row, column);
      const bool unknown = is_unknown(grid, row, column);
      if (!unknown && is_zero(grid, value)) continue;
      const std::string text = unknown ? "?" : number_of(value, format.digits, format.sign);
      if (grid.page.canvas().text_width(text, style) > grid.cell - 2) continue;
      style.halo = unknown ? grid.page.theme().background : color_of(grid, value);
      style.color = ink_on(style.halo);
      const Point middle = middle_of(cell_rect(grid, row, column));
      grid.page.canvas().text({middle.x(), baseline_around(middle.y(), style.size)}, text, style);
    }
  }
}

// Every k-th name, so that none touches the next.
int name_step(double needed, double cell) {
  return static_cast<int>(std::max(1.0, std::ceil(needed / cell)));
}

void write_row_names(MatrixGrid& grid, const Rect& rect) {
  Canvas& canvas = grid.page.canvas();
  TextStyle style = matrix_names(grid.page);
  style.align = Align::right;
  const double right = grid.cells.x - matrix_name_gap;
  const int step = name_step(1.25 * style.size, grid.cell);
  const Eigen::Index rows = std::min<Eigen::Index>(grid.view.row_names.size(), grid.view.values.rows());
  for (int row = 0; row < rows; row += step) {
    style.bold = row == grid.view.active_row;
    style.color = style.bold ? grid.page.theme().text : grid.page.theme().secondary_text;
    const double y = grid.cells.y + grid.cell * (row + 0.5);
    const std::string name = ellipsized(canvas, grid.view.row_names[row], right - rect.x, style);
    canvas.text({right, baseline_around(y, style.size)}, name, style);
  }
}

void write_column_names(MatrixGrid& grid) {
  Canvas& canvas = grid.page.canvas();
  TextStyle style = matrix_names(grid.page);
  style.align = Align::center;
  const Eigen::Index columns = std::min<Eigen::Index>(grid.view.column_names.size(), grid.view.values.cols());
  const double base = grid.cells.y + grid.cells.height + std::round(1.25 * style.size);
  double free = 0;  // [px] from there on
  for (int column = 0; column < columns; ++column) {
    const std::string& name = grid.view.column_names[column];
    const double x = grid.cells.x + grid.cell * (column + 0.5), half = 0.5 * canvas.text_width(name, style);
    if (name.empty() || x - half < free) continue;
    canvas.text({x, base}, name, style);
    free = x + half + 4;
  }
}

// Above the cells; further left, smaller or cut where it would leave the rectangle.
void write_title(MatrixGrid& grid, const Rect& rect) {
  Canvas& canvas = grid.page.canvas();
  const TextStyle style =
      shrunk(canvas, grid.view.title, rect.width, matrix_title(grid.page), grid.page.sizes().smallest);
  const std::string title = ellipsized(canvas, grid.view.title, rect.width, style);
  const double width = canvas.text_width(title, style);
  const double x = std::max(rect.x, std::min(grid.cells.x, rect.x + rect.width - width));
  canvas.text({x, rect.y + std::round(style.size)}, title, style);
}

}  // namespace

TextStyle matrix_names(const Page& page) {
  TextStyle style = page.value();
  style.size = std::min(style.size, page.sizes().tick);
  style.color = page.theme().secondary_text;
  return style;
}

TextStyle matrix_title(const Page& page) {
  TextStyle style = page.label();
  style.bold = true;
  style.color = page.theme().text;
  return style;
}

double widest_name(const Page& page, const List<std::string>& names) {
  TextStyle style = matrix_names(page);
  style.bold = true;  // the active row's
  double width = 0;
  for (const std::string& name : names) width = std::max(width, page.canvas().text_width(name, style));
  return width;
}

void write_matrix_texts(MatrixGrid& grid, const Rect& rect) {
  write_numbers(grid);
  if (!grid.thinned()) {
    write_row_names(grid, rect);
    write_column_names(grid);
  }
  if (!grid.view.title.empty()) write_title(grid, rect);
}

}  // namespace cairn::render
