// Colours for the code that the pages show.
#pragma once

#include <string>
#include <string_view>

namespace cairn::driver {

/// HTML of C++ or of commands, its words in spans of a class each: k keyword, c comment, s text, n number.
/// Any other language is escaped and nothing more.
std::string coloured(std::string_view code, std::string_view language);

}  // namespace cairn::driver
