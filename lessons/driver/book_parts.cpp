// The frame of a page, links and pictures.
#include "lessons/driver/book_parts.hpp"

#include <fmt/format.h>

#include "lessons/driver/book_glyphs.hpp"
#include "lessons/driver/book_text.hpp"
#include "lessons/driver/exercises.hpp"

namespace cairn::driver {
namespace {

constexpr const char* page_frame = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{title}</title>
<meta name="description" content="{description}">
<link rel="icon" href="data:,">
<link rel="stylesheet" href="book.css">
<script src="book.js"></script>
{scripts}</head>
<body>
<a class="skip" href="#main">Skip to the text</a>
<header>
<nav aria-label="Book">
<a href="index.html">Cairn</a>
<a href="glossary.html">Glossary</a>
<a href="equations.html">Equations</a>
<a href="notation.html">Notation</a>
</nav>
<form class="search" role="search" action="search.html">
<input type="search" name="q" aria-label="Search the book" placeholder="Search">
</form>
<button type="button" class="theme" hidden>Dark</button>
</header>
<main id="main" class="{kind}">
{body}</main>
<footer>
<p>Cairn {version}. Pictures and numbers on these pages come from the programs that they describe.</p>
</footer>
</body>
</html>
)";

}  // namespace

std::string page(const PageParts& parts) {
  return fmt::format(page_frame, fmt::arg("title", escaped(parts.title)),
                     fmt::arg("description", escaped(parts.description)), fmt::arg("scripts", parts.scripts),
                     fmt::arg("kind", parts.kind), fmt::arg("body", parts.body),
                     fmt::arg("version", CAIRN_VERSION));
}

std::string numbered(const BookLesson& lesson) {
  return two_digits(lesson.program.number) + " " + lesson.program.card.title;
}

std::string page_link(const BookLesson& lesson, const std::string& words, const std::string& relation) {
  const std::string rel = relation.empty() ? "" : fmt::format(" rel=\"{}\"", relation);
  return fmt::format("<a href=\"{}\"{}>{}</a>", page_name(lesson.program), rel, words);
}

std::string picture(const BookLesson& lesson, const BookFrame& frame) {
  return fmt::format(
      "<picture><source media=\"screen and (prefers-color-scheme: dark)\" srcset=\"frames/{}\">"
      "<img src=\"frames/{}\" width=\"{}\" height=\"{}\" alt=\"{}\"></picture>",
      frame.dark, frame.light, lesson.width, lesson.height, escaped(frame.alt));
}

std::string cover_figure(const BookLesson& lesson) {
  const BookFrame* cover = cover_of(lesson);
  return cover == nullptr ? "" : "<figure class=\"cover\">" + picture(lesson, *cover) + "</figure>";
}

TextPlaces places_in(const Book& book) {
  TextPlaces places = {.has_playground = book.has_playground, .symbols = book.symbols, .terms = book.terms};
  for (const auto& [symbol, address] : book.symbols) {
    const std::size_t hash = address.find('#');
    if (!is_greek(glyphs_of(symbol)[0])) continue;  // a letter of English is also a word
    places.terms.push_back({.name = symbol,
                            .anchor = address.substr(hash + 1),
                            .meaning = "what " + symbol + " is in the paper and in the code",
                            .page = address.substr(0, hash)});
  }
  for (const BookLesson& lesson : book) {
    places.pages[lesson_folder(lesson.program).filename().string()] = page_name(lesson.program);
  }
  return places;
}

}  // namespace cairn::driver
