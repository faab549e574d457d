// Floor 9. What an engine must do at the edges of what it can be asked: cases, and a study of them.
#pragma once

#include <functional>
#include <string>

#include <cairn/math/list.hpp>
#include <cairn/measure/csv.hpp>
#include <cairn/scenes/setting.hpp>
#include <cairn/study/journal.hpp>

namespace cairn {

/// How a case ended.
enum class ExtremeVerdict {
  ok,      // within the tolerance of its quantity
  bound,   // not, but finite, without an energy gain above 1 %, and nothing went through anything else
  refuse,  // std::invalid_argument that names field and value, or std::length_error for what needs too much
           // memory
  told,    // not even bounded, and R_E says why: what solves left undone may move a body by half its size
  fail,    // none of these
};

/// "OK", "BOUND", "REFUSE", "TOLD" or "FAIL".
std::string verdict_text(ExtremeVerdict verdict);

/// Whether a case that must end as `required` may end so. What must be bounded may be right as well; and it
/// may go wrong where R_E tells, for so many sweeps do not carry every load.
bool meets(ExtremeVerdict required, ExtremeVerdict found);

/// What was measured, and how it ended.
struct ExtremeFinding {
  ExtremeVerdict verdict = ExtremeVerdict::fail;
  std::string quantity = {};  // "drift / link"
  double value = 0;
  double limit = 0;       // at most, for OK
  std::string note = {};  // the message of a refusal, or why it failed
};

struct ExtremeCase {
  std::string axis = {};
  std::string value = {};  // of the axis, as text
  Setting setting = {};
  ExtremeVerdict required = ExtremeVerdict::bound;
  bool quick = false;  // is in the part that tests can afford
  std::function<ExtremeFinding(const Setting&)> run = {};
};

/// One thing that is driven to its extremes.
struct ExtremeAxis {
  std::string name = {};
  std::string title = {};
  std::string settings = {};  // solvers and policies that it is tried with, and why
  std::function<List<ExtremeCase>()> make = {};
};

/// All of them; cases are made when they are asked for.
const List<ExtremeAxis>& extreme_axes();

/// Runs a case. Whatever it throws is a finding: a refusal, or a failure.
ExtremeFinding find_out(const ExtremeCase& extreme);

enum class ExtremePart { all, quick };

struct ExtremeChoice {
  ExtremePart part = ExtremePart::all;
  List<std::string> axes = {};  // names; empty: all
};

/// One task for each case that is chosen. @throws std::invalid_argument where none is.
Study extreme_study(const ExtremeChoice& choice);
/// From Journal::csv(): a case and its finding a row; 1 where it `meets` what is required.
/// @throws std::invalid_argument for a table that is not of such a study.
CsvTable extreme_table(const std::string& csv);
/// An object: "build", what the numbers come from, and "cases", an object a row.
std::string extreme_json(const CsvTable& table);

}  // namespace cairn
