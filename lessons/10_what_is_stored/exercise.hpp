// Exercise 10: the entries of A that are not 0.
#pragma once

#include "lessons/exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise10 {

/// The two bodies of a row.
struct RowBodies {
  int a = 0;
  int b = 0;
};

/// How many entries of A = J M^-1 J^T there are between rows that share a body which can move, with the
/// diagonal and with both halves. `inverse_mass` [1/kg] is 0 for a body that cannot move; every row has one
/// that can.
int entries(const List<RowBodies>& rows, const List<double>& inverse_mass);

using Answer = int (*)(const List<RowBodies>&, const List<double>&);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise10
