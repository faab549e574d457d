// What of the paper is in which lesson, and how.
#pragma once

#include <string>

#include "lessons/driver/catalogue.hpp"
#include <cairn/math/list.hpp>

namespace cairn::driver {

/// An equation, the algorithm, or a claim.
struct PaperItem {
  std::string name = {};  // "(22)", "4.3 blocks"
  std::string what = {};
};

/// Everything that the paper states and a lesson has to have.
const List<PaperItem>& paper_items();

/// How a lesson has an item: a check is named for it alone, a frame or a printed line shows it, or the text
/// says it.
enum class Coverage { met, shown, mentioned };

/// Where a lesson has an item, as its covers.txt says.
struct Covered {
  std::string item = {};
  Coverage how = Coverage::mentioned;
  int frame = 0;          // of all frames, from 1; 0: none, which leaves the printed lines or the text
  std::string what = {};  // how the check begins; what is shown; the words of the text
};

/// @throws std::runtime_error for a line that is not "item | met FRAME | check", "item | shown FRAME | what",
/// "item | shown | a printed line" or "item | mentioned | words of the text", or that names no item.
List<Covered> covered_by(const Program& lesson);

}  // namespace cairn::driver
