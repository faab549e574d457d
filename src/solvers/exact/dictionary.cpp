// Floor 4. Pivots in a dense table.
#include <cairn/solvers/exact/dictionary.hpp>
#include <cairn/math/list.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include <cairn/math/deadline.hpp>

namespace cairn {

namespace {

struct PivotPlace {
  int row = 0;
  int column = 0;
  long double size = 0;
};

/// The largest entry in the rows and columns not pivoted yet: those from `done` on in the two orders.
PivotPlace largest_entry(const Dictionary& table, const List<int>& row_order, const List<int>& column_order,
                         int done) {
  PivotPlace best;
  for (int i = done; i < table.rows(); ++i) {
    const long double* row = table.row(row_order[i]);
    for (int j = done; j < table.columns(); ++j) {
      const long double size = std::abs(row[column_order[j]]);
      if (size > best.size) best = {i, j, size};
    }
  }
  return best;
}

List<int> counted_up(int count) {
  List<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

}  // namespace

Dictionary::Dictionary(int rows, int columns) : rows_(rows), columns_(columns), values_(rows * stride(), 0) {}

void Dictionary::exchange(int i, int j) {
  Deadline::go_on();
  long double* pivot_row = row(i);
  assert(pivot_row[j] != 0);
  const long double inverse = 1 / pivot_row[j];
  for (int k = 0; k <= columns_; ++k) pivot_row[k] *= -inverse;
  pivot_row[j] = inverse;
  for (int other = 0; other < rows_; ++other) {
    if (other == i) continue;
    long double* target = row(other);
    const long double factor = target[j];
    if (factor == 0) continue;
    target[j] = 0;
    for (int k = 0; k <= columns_; ++k) target[k] += factor * pivot_row[k];
  }
}

LinearSolutions solve_linear(const Matrix<long double>& M, const Vector<long double>& rhs,
                             long double threshold) {
  const int rows = static_cast<int>(M.rows()), columns = static_cast<int>(M.cols());
  Dictionary table(rows, columns);  // of the errors M x - rhs, and of x itself once it is basic
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) table.row(i)[j] = M(i, j);
    table.set_constant(i, -rhs(i));
  }
  List<int> row_order = counted_up(rows), column_order = counted_up(columns);
  LinearSolutions result;
  while (result.rank < std::min(rows, columns)) {
    const PivotPlace place = largest_entry(table, row_order, column_order, result.rank);
    if (!(place.size > threshold)) break;
    const auto done = result.rank;
    std::swap(row_order[done], row_order[place.row]);
    std::swap(column_order[done], column_order[place.column]);
    table.exchange(row_order[done], column_order[done]);
    ++result.rank;
  }
  result.solution = Vector<long double>::Zero(columns);
  result.null_space = Matrix<long double>::Zero(columns, columns - result.rank);
  for (int k = 0; k < rows; ++k) {
    const int i = row_order[k];
    if (k >= result.rank) {
      result.contradiction = std::max(result.contradiction, std::abs(table.constant(i)));
      continue;
    }
    const int variable = column_order[k];
    result.solution(variable) = table.constant(i);
    for (int f = result.rank; f < columns; ++f) {
      result.null_space(variable, f - result.rank) = table.row(i)[column_order[f]];
    }
  }
  for (int f = result.rank; f < columns; ++f) {
    result.null_space(column_order[f], f - result.rank) = 1;
  }
  return result;
}

}  // namespace cairn
