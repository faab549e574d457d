// Markdown of the lessons as HTML, with links that lead somewhere in the book.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "lessons/driver/book_math.hpp"
#include "math/list.hpp"

namespace cairn::driver {

/// The text with & < > " as entities.
std::string escaped(std::string_view text);
std::string unescaped(std::string text);

/// @throws std::runtime_error when this build cannot read Markdown.
std::string html_of(const std::string& markdown);

/// A word of the glossary, or a symbol of the notation.
struct Term {
  std::string name = {};               // "effective mass"
  std::string anchor = {};             // "effective-mass"
  std::string meaning = {};            // without markup
  std::string page = "glossary.html";  // that explains it
};

/// "What to look at" -> "what-to-look-at".
std::string anchor_of(const std::string& title);

/// The text of HTML: without its tags, entities as they are.
std::string without_tags(const std::string& html);

/// Where the links and pictures of a lesson's text go.
struct TextPlaces {
  std::map<std::string, std::string> pages = {};  // "06_sequential_impulses" -> "lesson06.html"
  std::map<std::string, std::string> files = {};  // shown on this page: "exercise.cpp" -> "#exercise.cpp"
  std::string cover = {};                         // HTML that stands for every picture of the text
  bool has_playground = false;                    // beside the page: playground.html
  SymbolPages symbols = {};                       // of formulas
  List<Term> terms = {};                          // linked where a text first has them
};

/// A heading of the second level and what follows it; the first has none, and begins with the title.
struct Section {
  std::string title = {};
  std::string html = {};  // the heading in it
};

/// The text of a lesson in sections: links led on, blocks of code named, headings with anchors.
List<Section> sections_of(const std::string& markdown, const TextPlaces& places);

/// Replaces every piece between `open` and `close` by what the function makes of its inside.
std::string replaced(const std::string& text, const std::string& open, const std::string& close,
                     const std::function<std::string(const std::string&)>& by);

/// A file or an output as a figure with a caption; `caption` and `code` are HTML.
std::string code_figure(const std::string& anchor, const std::string& caption, std::string_view code);

/// HTML in which the first use of each term is a link to where it is explained.
std::string with_terms(const std::string& html, const List<Term>& terms);

/// Markdown whose indented blocks are fenced, as "formula".
std::string with_formulas_fenced(const std::string& markdown);

}  // namespace cairn::driver
