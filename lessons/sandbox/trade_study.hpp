// What `cairn tradeoff` is asked to study, and how its table is to be drawn.
#pragma once

#include <map>
#include <string>

#include "lessons/sandbox/verb.hpp"
#include "math/list.hpp"
#include "study/journal.hpp"

namespace cairn::sandbox {

struct TradeStudy {
  Study study = {};
  int level = 1;
  std::string name = {};                        // of its files
  std::string title = {};                       // of its chart
  std::string note = {};                        // below it
  std::string work = {}, error = {};            // columns
  std::string work_name = {}, error_name = {};  // at the head of a printed table
  std::string work_axis = {}, error_axis = {};
  List<std::string> curves = {};                  // at most 4 solvers
  std::map<std::string, std::string> shown = {};  // the rows that are drawn: words that columns have
};

/// @throws UsageError, std::invalid_argument.
TradeStudy trade_study(const Words& words);

}  // namespace cairn::sandbox
