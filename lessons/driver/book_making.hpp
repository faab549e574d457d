// Runs the lessons for a book and collects what they draw and print.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "lessons/driver/book.hpp"
#include "lessons/driver/commands.hpp"
#include "math/list.hpp"

namespace cairn::driver {

/// Where `lessons/run playground` puts it.
inline constexpr const char* playground_file = "out/playground/index.html";

/// The whole file; "" where there is none.
std::string text_of(const std::filesystem::path& file);

/// Where things are while the book is made.
struct Workshop {
  std::filesystem::path book = {};  // until it is whole
  std::filesystem::path work = {};  // where the lessons leave their files
  List<std::string> flags = {};     // for every lesson
};

/// A lesson could not be run as it was asked to.
struct LessonFailed : std::runtime_error {
  LessonFailed(const std::string& what, int exit_code) : std::runtime_error(what), code(exit_code) {}
  int code;
};

/// Runs every lesson that is built. `all_held` becomes false where a claim of one does not hold.
/// @throws LessonFailed, Interrupted
Book gathered(const Context& context, const Workshop& shop, bool& all_held);

}  // namespace cairn::driver
