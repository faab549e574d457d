// Floor 0. Reads UTF-8 and escapes what is not for showing.
#include <cairn/math/printable.hpp>

#include <fmt/format.h>

namespace cairn {

namespace {

/// One character of UTF-8.
struct CodePoint {
  std::size_t bytes = 0;  // 0: the text does not begin with one
  char32_t code = 0;
};

CodePoint first_code_point(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) return {.bytes = 1, .code = lead};
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return {};
  char32_t code = lead & (0x7fu >> bytes);
  for (const char next : text.substr(1, bytes - 1)) {
    const auto byte = static_cast<unsigned char>(next);
    if ((byte & 0xc0u) != 0x80) return {};
    code = code << 6 | (byte & 0x3fu);
  }
  constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};  // fewer bytes would do below
  const bool is_surrogate = code >= 0xd800 && code < 0xe000;
  if (code < least[bytes] || code > 0x10ffff || is_surrogate) return {};
  return {.bytes = bytes, .code = code};
}

bool is_control(char32_t code) { return (code < 0x20 && code != '\n') || (code >= 0x7f && code < 0xa0); }

/// Marks of direction, and ends of lines and paragraphs.
bool turns_text(char32_t code) {
  return code == 0x61c || code == 0x200e || code == 0x200f || (code >= 0x2028 && code <= 0x202e) ||
         (code >= 0x2066 && code <= 0x2069);
}

/// The first place from `place` on where a character begins.
std::size_t next_beginning(std::string_view text, std::size_t place) {
  while (place < text.size() && (static_cast<unsigned char>(text[place]) & 0xc0u) == 0x80) ++place;
  return place;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const CodePoint first = first_code_point(text);
    if (first.bytes == 0) {
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
    } else if (is_control(first.code)) {
      result += fmt::format("\\x{:02x}", static_cast<unsigned>(first.code));
    } else if (turns_text(first.code)) {
      result += fmt::format("\\u{:04x}", static_cast<unsigned>(first.code));
    } else {
      result += text.substr(0, first.bytes);
    }
    text.remove_prefix(first.bytes == 0 ? 1 : first.bytes);
  }
  return result;
}

std::string excerpt(std::string_view text, std::size_t longest) {
  std::string line;
  for (const char letter : printable(text)) line += letter == '\n' ? "\\n" : std::string(1, letter);
  if (line.size() <= longest) return line;
  const std::size_t head = next_beginning(line, longest * 2 / 3);
  return line.substr(0, head) + "..." + line.substr(next_beginning(line, line.size() - longest / 3));
}

}  // namespace cairn
