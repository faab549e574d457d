// Matrices as heat maps with the numbers in their cells.
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>

#include <cairn/math/list.hpp>
#include "render/page.hpp"

namespace cairn::render {

enum class MatrixColors { signed_values, magnitude };

struct MatrixView {
  std::string title = {};  // "A = J M⁻¹ Jᵀ (1/kg)"
  Eigen::MatrixXd values = {};
  List<std::string> row_names = {};  // empty: none
  List<std::string> column_names = {};
  int column_group = 0;    // a thick line after every so many columns; 0: none
  int active_row = -1;     // framed
  int active_column = -1;  // framed; with a row, the cell where they cross is framed twice as strongly
  List<std::pair<int, int>> unknown =
      {};  // rows and columns of the cells not computed yet: "?" upon hatching
  MatrixColors colors = MatrixColors::signed_values;
  double strongest = 0;  // has the full colour, so that matrices can be compared; 0: the largest value
  bool numbers = true;   // false: colours alone, where most numbers would not fit
};

/// Cells are square, as large as fits up to 64 px, at the top left of `rect`. Values are printed in cells of
/// at least 28 px where they fit; zero is a dot, and so is what rounding left of a zero (1e-13 of the
/// largest). If there are more entries than pixels, a cell shows the largest entry of a block, and
/// names are left out.
void draw_matrix(Page& page, const Rect& rect, const MatrixView& view);

}  // namespace cairn::render
