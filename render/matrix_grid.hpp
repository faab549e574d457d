// The layout of a matrix: which entry is where. Shared by what draws cells and what writes in and beside
// them.
#pragma once

#include <string>

#include <cairn/math/list.hpp>
#include "render/matrix.hpp"

namespace cairn::render {

inline constexpr double matrix_name_gap = 8;       // [px] between names and cells
inline constexpr double matrix_cell_of_text = 28;  // [px] smaller cells hold no numbers

/// The matrix on its page.
struct MatrixGrid {
  Page& page;
  const MatrixView& view;
  Eigen::MatrixXd shown =
      {};              // as in the view, or the largest entry of each block if one has less than a pixel
  double largest = 0;  // finite magnitude
  Rect cells = {};     // [px]
  double cell = 0;     // [px]

  bool thinned() const { return shown.size() != view.values.size(); }
};

Rect cell_rect(const MatrixGrid& grid, Eigen::Index row, Eigen::Index column);
bool is_unknown(const MatrixGrid& grid, Eigen::Index row, Eigen::Index column);
bool is_zero(const MatrixGrid& grid, double value);
Color color_of(const MatrixGrid& grid, double value);

TextStyle matrix_title(const Page& page);
TextStyle matrix_names(const Page& page);
double widest_name(const Page& page, const List<std::string>& names);

/// Title, names and numbers.
void write_matrix_texts(MatrixGrid& grid, const Rect& rect);

inline Point middle_of(const Rect& rect) { return {rect.x + rect.width / 2, rect.y + rect.height / 2}; }

}  // namespace cairn::render
