// Floor 0. Text that somebody else wrote, as it may stand in a message.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cairn {

/// [bytes] What a program says of an error is cut to this, as excerpt() cuts.
inline constexpr std::size_t longest_message = 1000;

/// The text without what could command a terminal: control characters but for the end of a line, characters
/// that turn the direction of writing, and bytes that are no UTF-8 become "\x1b" or "\u202e".
std::string printable(std::string_view text);

/// The same on one line, "\n" where a line ended; of more than `longest` bytes the beginning and the end, and
/// "..." in between.
std::string excerpt(std::string_view text, std::size_t longest = 60);

}  // namespace cairn
