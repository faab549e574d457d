// Small tools for HTML and Markdown as text.
#include <algorithm>
#include <cctype>
#include <sstream>

#include "lessons/driver/book_text.hpp"

namespace cairn::driver {
namespace {

bool is_list_item(const std::string& line) {
  const std::size_t digits = line.find_first_not_of("0123456789");
  const bool is_numbered = digits != std::string::npos && digits > 0 && line.compare(digits, 2, ". ") == 0;
  return is_numbered || line.rfind("- ", 0) == 0 || line.rfind("* ", 0) == 0;
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 128; }

/// Where a text has a word, its first letter large or small, its end with or without an s. A symbol begins no
/// later than its glyph does: not within "Δλ".
std::size_t place_of(const std::string& text, const std::string& word) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  auto at = text.begin();
  while (true) {
    at = std::search(at, text.end(), word.begin(), word.end(), same);
    if (at == text.end()) return std::string::npos;
    auto end = at + static_cast<std::ptrdiff_t>(word.size());
    if (end != text.end() && *end == 's') ++end;
    const bool begins = at == text.begin() || (!is_letter(*(at - 1)) && *(at - 1) != '-' &&
                                               (is_ascii(word[0]) || is_ascii(*(at - 1))));
    if (begins && (end == text.end() || !is_letter(*end))) return static_cast<std::size_t>(at - text.begin());
    ++at;
  }
}

/// Elements whose text stays as it is.
bool is_closed_to_terms(const std::string& tag) {
  for (const char* name : {"a", "code", "pre", "h1", "h2", "h3", "summary", "figure", "math", "th", "nav"}) {
    if (tag == name) return true;
  }
  return false;
}

/// Links each term in one piece of text, and forgets those that it has linked.
std::string linked(std::string text, List<Term>& left) {
  for (int i = 0; i < left.size();) {
    const std::size_t at = place_of(text, left[i].name);
    if (at == std::string::npos) {
      ++i;
      continue;
    }
    std::size_t length = left[i].name.size();
    if (at + length < text.size() && text[at + length] == 's') ++length;
    const std::string link = "<a class=\"term\" href=\"" + left[i].page + "#" + left[i].anchor +
                             "\" title=\"" + escaped(left[i].meaning) + "\">" + text.substr(at, length) +
                             "</a>";
    const std::string behind = text.substr(at + length);
    left.erase(left.begin() + i);
    return linked(text.substr(0, at), left) + link + linked(behind, left);
  }
  return text;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string unescaped(std::string text) {
  const std::pair<const char*, const char*> entities[] = {
      {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}};
  for (const auto& [entity, character] : entities) {
    const std::string wanted = entity;
    for (std::size_t at = 0; (at = text.find(wanted, at)) != std::string::npos; ++at) {
      text.replace(at, wanted.size(), character);
    }
  }
  return text;
}

std::string replaced(const std::string& text, const std::string& open, const std::string& close,
                     const std::function<std::string(const std::string&)>& by) {
  std::string result;
  std::size_t at = 0;
  while (true) {
    const std::size_t begin = text.find(open, at);
    const std::size_t end = begin == std::string::npos ? begin : text.find(close, begin + open.size());
    if (end == std::string::npos) return result + text.substr(at);
    result += text.substr(at, begin - at);
    result += by(text.substr(begin + open.size(), end - begin - open.size()));
    at = end + close.size();
  }
}

std::string anchor_of(const std::string& title) {
  std::string anchor;
  bool is_in_tag = false;
  for (const char c : title) {
    if (c == '<' || c == '>') is_in_tag = c == '<';
    if (is_in_tag) continue;
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!anchor.empty() && anchor.back() != '-') {
      anchor += '-';
    }
  }
  while (!anchor.empty() && anchor.back() == '-') anchor.pop_back();
  return anchor;
}

std::string without_tags(const std::string& html) {
  std::string text;
  bool is_in_tag = false;
  for (const char c : html) {
    if (c == '<') is_in_tag = true;
    if (!is_in_tag) text += c;
    if (c == '>') {
      is_in_tag = false;
      text += ' ';
    }
  }
  std::istringstream words(text);
  std::string even;
  for (std::string word; words >> word;) even += (even.empty() ? "" : " ") + word;
  return even;
}

std::string with_terms(const std::string& html, const List<Term>& terms) {
  List<Term> left = terms;
  List<std::string> closed;  // elements that are open here and closed to terms
  std::string result;
  for (std::size_t at = 0; at < html.size();) {
    const std::size_t tag = std::min(html.find('<', at), html.size());
    const std::string text = html.substr(at, tag - at);
    result += closed.empty() ? linked(text, left) : text;
    const std::size_t end = std::min(html.find('>', tag), html.size() - 1) + 1;
    if (tag < html.size()) {
      const bool ends = html[tag + 1] == '/';
      const std::size_t name = tag + (ends ? 2 : 1);
      const std::string element = html.substr(name, html.find_first_of(" >", name) - name);
      if (!ends && is_closed_to_terms(element)) closed.push_back(element);
      if (ends && !closed.empty() && closed.back() == element) closed.pop_back();
      result += html.substr(tag, end - tag);
    }
    at = tag < html.size() ? end : tag;
  }
  return result;
}

std::string with_formulas_fenced(const std::string& markdown) {
  std::istringstream lines(markdown);
  std::string result;
  bool is_fenced = false, is_block = false, is_list = false, was_blank = true;
  for (std::string line; std::getline(lines, line);) {
    const bool is_blank = line.find_first_not_of(' ') == std::string::npos;
    const bool is_indented = line.rfind("    ", 0) == 0 && !is_blank;
    if (is_block && !is_indented) {
      result += "```\n";
      is_block = false;
    }
    if (line.rfind("```", 0) == 0) is_fenced = !is_fenced;
    if (!is_blank && line[0] != ' ' && (was_blank || is_list_item(line))) is_list = is_list_item(line);
    if (!is_block && is_indented && was_blank && !is_fenced && !is_list) {
      result += "```formula\n";
      is_block = true;
    }
    result += (is_block ? line.substr(4) : line) + "\n";
    was_blank = is_blank;
  }
  return result + (is_block ? "```\n" : "");
}

}  // namespace cairn::driver
