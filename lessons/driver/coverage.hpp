// What of the paper is met in which lesson.
#pragma once

#include <string>

#include "lessons/driver/catalogue.hpp"
#include "math/list.hpp"

namespace cairn::driver {

/// An equation, the algorithm, or a claim.
struct PaperItem {
  std::string name = {};  // "(22)", "4.3 blocks"
  std::string what = {};
};

/// Everything that the paper states and a lesson has to meet.
const List<PaperItem>& paper_items();

/// Where a lesson meets an item, as its covers.txt says.
struct Covered {
  std::string item = {};
  int frame = 0;           // of all frames, from 1
  std::string check = {};  // how the claim begins
};

/// @throws std::runtime_error for a line that is not "item | frame | check" or names no item.
List<Covered> covered_by(const Program& lesson);

}  // namespace cairn::driver
