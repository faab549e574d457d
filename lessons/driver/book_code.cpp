// Takes code apart into words. What has no colour of its own is left in the colour of the text.
#include "lessons/driver/book_code.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include "lessons/driver/book_text.hpp"

namespace cairn::driver {
namespace {

using WordSet = std::set<std::string, std::less<>>;

const WordSet cpp_words = {"auto",     "bool",     "break",    "case",    "class",  "const",     "constexpr",
                           "continue", "default",  "double",   "else",    "enum",   "explicit",  "false",
                           "float",    "for",      "if",       "inline",  "int",    "namespace", "new",
                           "nullptr",  "operator", "override", "private", "public", "return",    "static",
                           "struct",   "switch",   "template", "this",    "throw",  "true",      "typename",
                           "using",    "virtual",  "void",     "while",   "final"};

bool is_word_part(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::string span(const char* kind, std::string_view text) {
  return std::string("<span class=\"") + kind + "\">" + escaped(text) + "</span>";
}

/// The length of the piece at the front that ends before any of these characters.
std::size_t up_to(std::string_view code, std::string_view ends) {
  return std::min(code.find_first_of(ends), code.size());
}

std::size_t word_length(std::string_view code) {
  return static_cast<std::size_t>(std::find_if_not(code.begin(), code.end(), is_word_part) - code.begin());
}

/// 0.02, 1e-9, 0x1F, 10'000.
std::size_t number_length(std::string_view code) {
  std::size_t length = 1;
  while (length < code.size()) {
    const bool is_sign = (code[length] == '-' || code[length] == '+') && code[length - 1] == 'e';
    if (!is_word_part(code[length]) && code[length] != '.' && code[length] != '\'' && !is_sign) break;
    ++length;
  }
  return length;
}

std::size_t quoted_length(std::string_view code) {
  std::size_t length = 1;
  while (length < code.size() && code[length] != code[0] && code[length] != '\n')
    length += code[length] == '\\' ? 2 : 1;
  return std::min(length + 1, code.size());
}

/// The class of the piece at the front of C++, and its length.
std::pair<const char*, std::size_t> cpp_piece(std::string_view code) {
  const char first = code[0];
  if (code.substr(0, 2) == "//") return {"c", up_to(code, "\n")};
  if (first == '#') return {"k", up_to(code, " \n")};
  if (first == '"' || first == '\'') return {"s", quoted_length(code)};
  if (std::isdigit(static_cast<unsigned char>(first)) != 0) return {"n", number_length(code)};
  if (!is_word_part(first)) return {"", 1};
  const std::size_t length = word_length(code);
  return {cpp_words.count(code.substr(0, length)) > 0 ? "k" : "", length};
}

/// Of a command, whose first word, flags and comments have colours.
std::pair<const char*, std::size_t> shell_piece(std::string_view code, bool begins_line) {
  if (code[0] == '#') return {"c", up_to(code, "\n")};
  if (begins_line) return {"k", std::max<std::size_t>(1, up_to(code, " \n"))};
  if (code.substr(0, 2) == " -") return {"n", std::max<std::size_t>(1, 1 + up_to(code.substr(1), " \n"))};
  return {"", 1};
}

}  // namespace

std::string coloured(std::string_view code, std::string_view language) {
  if (language != "cpp" && language != "bash") return escaped(code);
  std::string html;
  bool begins_line = true;
  while (!code.empty()) {
    const auto [kind, length] = language == "cpp" ? cpp_piece(code) : shell_piece(code, begins_line);
    const std::string_view piece = code.substr(0, length);
    html += *kind == '\0' ? escaped(piece) : span(kind, piece);
    begins_line = piece.back() == '\n';
    code.remove_prefix(length);
  }
  return html;
}

}  // namespace cairn::driver
