// Runs the lessons for a book, collects what they draw and print, and has pandoc make its pages.
#pragma once

#include <filesystem>
#include <string>

#include "lessons/driver/commands.hpp"
#include <cairn/math/list.hpp>

namespace cairn::driver {

/// Where things are while the book is made.
struct Workshop {
  std::filesystem::path book = {};  // until it is whole
  std::filesystem::path work = {};  // where the lessons leave their files
  List<std::string> flags = {};     // for every lesson
  bool is_for_print = false;        // of key frames that paper shows sharp, and with pages for paper:
                                    // handouts.html has all lessons, handout06.html one
};

/// The exit code where something is missing that the pages need.
inline constexpr int cannot_make = 3;

/// How much was made.
struct BookSize {
  int lessons = 0;
  int pictures = 0;
  bool all_held = true;  // every claim of every lesson
};

/// Makes the whole book in `shop.book`, of every lesson that is built.
/// @throws ProgramFailed where a lesson does not run as it is asked to, or pandoc; Interrupted
BookSize make_pages(const Context& context, const Workshop& shop);

}  // namespace cairn::driver
