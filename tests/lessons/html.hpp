// Pages of HTML as text, for tests that look at them.
#pragma once

#include <algorithm>
#include <regex>
#include <set>
#include <string>

#include <cairn/math/list.hpp>

namespace cairn::testing {

/// What the first group of a pattern holds, wherever the pattern matches.
inline List<std::string> all_matches(const std::string& text, const std::regex& pattern) {
  List<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
    found.push_back((*match)[1].str());
  return found;
}

/// The text of a page, but for its tags and what its blocks of code show.
inline std::string without_blocks_of_code(const std::string& page) {
  std::string text;
  for (std::size_t at = page.find("<body"); at < page.size();) {
    const bool is_code = page.compare(at, 5, "<pre ") == 0 || page.compare(at, 6, "<code>") == 0;
    if (page[at] != '<') text += page[at];
    at = page[at] != '<' ? at + 1 : is_code ? page.find("</code>", at) : page.find('>', at) + 1;
  }
  return text;
}

/// What is wrong with the nesting of the elements of a page; empty when nothing is. Terms are links in text,
/// and nowhere else.
inline std::string nesting_error(const std::string& page) {
  const std::set<std::string> without_terms = {"a",       "code",   "h1", "h2",  "h3",
                                               "summary", "figure", "th", "nav", "math"};
  const std::set<std::string> without_end = {"meta", "link", "img", "source", "input", "br", "hr"};
  List<std::string> open;
  static const std::regex tag("<(/?)([a-z][a-z0-9]*)((?:\\s+[a-z-]+(?:=\"[^\"<]*\")?)*)\\s*>");
  const std::string text = page.substr(page.find("<html"));
  int seen = 0;
  for (std::sregex_iterator match(text.begin(), text.end(), tag), end; match != end; ++match, ++seen) {
    const std::string name = (*match)[2].str();
    if ((*match)[3].str().find("class=\"term\"") != std::string::npos) {
      for (const std::string& element : open) {
        if (without_terms.count(element) > 0) return "a term in <" + element + ">";
      }
    }
    if ((*match)[1].length() == 0) {
      if (without_end.count(name) == 0) open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      return "</" + name + "> in " + (open.empty() ? "nothing" : open.back());
    } else {
      open.pop_back();
    }
  }
  // Every < is the beginning of a tag that was understood: what is text was escaped.
  if (seen != std::count(text.begin(), text.end(), '<')) return "a stray <";
  return open.empty() ? "" : "<" + open.back() + "> is not closed";
}

}  // namespace cairn::testing
