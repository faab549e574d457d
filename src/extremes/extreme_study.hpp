// Floor 12. The extremes as a study: case by case on disk, and read back from there.
#pragma once

#include <string>

#include "extremes/extreme.hpp"
#include "study/journal.hpp"
#include "math/list.hpp"

namespace cairn {

enum class ExtremePart { all, quick };

struct ExtremeChoice {
  ExtremePart part = ExtremePart::all;
  List<std::string> axes = {};  // names; empty: all
};

/// A case and its finding, as a table shows them.
struct ExtremeRow {
  std::string axis = {};
  std::string value = {};
  std::string solver = {};  // with its sweeps and substeps
  std::string policy = {};
  std::string required = {};
  std::string verdict = {};
  std::string quantity = {};
  double measured = 0;
  double limit = 0;
  std::string note = {};
  bool meets = false;
};

/// One task for each case that is chosen. @throws std::invalid_argument where none is.
Study extreme_study(const ExtremeChoice& choice);
/// From Journal::csv(). @throws std::invalid_argument for a table that is not of such a study.
List<ExtremeRow> extreme_rows(const std::string& csv);
/// An object: "build", what the numbers come from, and "cases", an object a row.
std::string extreme_json(const List<ExtremeRow>& rows);

}  // namespace cairn
