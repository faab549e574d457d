// Markdown of the lessons as HTML, with links that lead somewhere in the book.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "math/list.hpp"

namespace cairn::driver {

/// The text with & < > " as entities.
std::string escaped(std::string_view text);

/// @throws std::runtime_error when this build cannot read Markdown.
std::string html_of(const std::string& markdown);

/// Where the links and pictures of a lesson's text go.
struct TextPlaces {
  std::map<std::string, std::string> pages = {};  // "06_sequential_impulses" -> "lesson06.html"
  std::map<std::string, std::string> files = {};  // shown on this page: "exercise.cpp" -> "#exercise.cpp"
  std::string cover = {};                         // HTML that stands for every picture of the text
  bool has_playground = false;                    // beside the page: playground.html
};

/// A heading of the second level and what follows it; the first has none, and begins with the title.
struct Section {
  std::string title = {};
  std::string html = {};  // the heading in it
};

/// The text of a lesson in sections: links led on, blocks of code named, headings with anchors.
List<Section> sections_of(const std::string& markdown, const TextPlaces& places);

/// A file or an excerpt as a figure with a caption; `caption` is HTML.
std::string code_figure(const std::string& anchor, const std::string& caption, std::string_view code);

}  // namespace cairn::driver
