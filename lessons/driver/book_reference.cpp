// Pages made of one text each, and the index of equations.
#include "lessons/driver/book_reference.hpp"

#include <fmt/format.h>

#include <sstream>

#include "lessons/driver/book_glyphs.hpp"
#include "lessons/driver/book_parts.hpp"
#include "lessons/driver/book_text.hpp"
#include "lessons/driver/coverage.hpp"

namespace cairn::driver {
namespace {

constexpr const char* term_mark = "- **";

/// A row of the table of symbols begins "| v (1), (16) |": its first symbols, without what stands behind
/// them.
List<std::string> symbols_in(const std::string& row) {
  std::istringstream parts(row.substr(2, row.find(" |", 2) - 2));
  List<std::string> symbols;
  for (std::string part; std::getline(parts, part, ',');) {
    const Glyphs glyphs = glyphs_of(part.substr(std::min(part.find_first_not_of(' '), part.size())));
    if (glyphs.empty() || (!is_latin(glyphs[0]) && !is_greek(glyphs[0]))) continue;
    const bool is_two = glyphs[0] == "Δ" && glyphs.size() > 1;
    const std::string next = glyphs.size() > 1 ? glyphs[1] : " ";
    if (!is_two && is_latin(next)) continue;  // a word
    symbols.push_back(is_two ? glyphs[0] + glyphs[1] : glyphs[0]);
  }
  return symbols;
}

std::string joined_sections(const Book& book, const std::string& markdown) {
  std::string html;
  for (const Section& section : sections_of(markdown, places_in(book))) html += section.html;
  return html;
}

std::string page_of(const std::string& title, const std::string& body) {
  return page({.title = title + " · Cairn",
               .description = title + " of the lesson book.",
               .kind = "reference",
               .body = body});
}

/// Where a lesson has an item: its page, the frame if the book shows it, the formula if the text has it.
std::string places_of(const BookLesson& lesson, const Covered& covered, const std::string& html) {
  const std::string name = page_name(lesson.program);
  std::string text = page_link(lesson, escaped(numbered(lesson)));
  const std::string frame = fmt::format("frame-{}", covered.frame);
  const bool is_shown = html.find("id=\"" + frame + "\"") != std::string::npos;
  text += is_shown ? fmt::format(", <a href=\"{}#{}\">frame {}</a>", name, frame, covered.frame)
                   : fmt::format(", frame {}", covered.frame);
  return text;
}

}  // namespace

List<Term> terms_of(const std::string& markdown) {
  std::istringstream lines(markdown);
  List<Term> terms;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(term_mark, 0) == 0) {
      const std::size_t end = line.find("**: ");
      const std::string name = line.substr(4, end - 4);
      terms.push_back({.name = name, .anchor = anchor_of(name), .meaning = line.substr(end + 4)});
    } else if (!terms.empty() && line.rfind("  ", 0) == 0) {
      terms.back().meaning += " " + line.substr(2);
    }
  }
  for (Term& term : terms) term.meaning = without_tags(html_of(term.meaning));
  return terms;
}

SymbolPages symbols_of(const std::string& markdown) {
  std::istringstream lines(markdown);
  SymbolPages pages;
  int row = -1;  // the head
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("| ", 0) != 0) continue;
    for (const std::string& symbol : row < 0 ? List<std::string>{} : symbols_in(line)) {
      pages.insert({symbol, fmt::format("notation.html#symbol-{}", row)});
    }
    ++row;
  }
  return pages;
}

std::string text_page(const Book& book, const std::string& markdown, const std::string& title) {
  return page_of(title, joined_sections(book, markdown));
}

std::string glossary_page(const Book& book, const std::string& markdown) {
  Book plain;  // its own terms are no links
  static_cast<List<BookLesson>&>(plain) = book;
  const std::string html =
      replaced(joined_sections(plain, markdown), "<li><strong>", "</strong>", [](const std::string& name) {
        return "<li id=\"" + anchor_of(name) + "\"><strong>" + name + "</strong>";
      });
  return page_of("Glossary", html);
}

std::string notation_page(const Book& book, const std::string& markdown) {
  int row = 0;
  Book plain;
  static_cast<List<BookLesson>&>(plain) = book;
  std::string html = joined_sections(plain, markdown);
  const std::size_t body = html.find("<tbody>");
  html =
      html.substr(0, body) + replaced(html.substr(body), "<tr>", "</tr>", [&row](const std::string& cells) {
        return fmt::format("<tr id=\"symbol-{}\">{}</tr>", row++, cells);
      });
  return page_of("Notation", html);
}

std::string equations_page(const Book& book, const std::map<std::string, std::string>& pages) {
  std::string rows;
  for (const PaperItem& item : paper_items()) {
    std::string places;
    for (const BookLesson& lesson : book) {
      const std::string& html = pages.at(page_name(lesson.program));
      const std::string formula = "eq-" + anchor_of(item.name);
      bool is_covered = false;
      for (const Covered& covered : covered_by(lesson.program)) {
        if (covered.item != item.name || is_covered) continue;
        is_covered = true;
        places += (places.empty() ? "" : "<br>") + places_of(lesson, covered, html);
      }
      if (html.find("id=\"" + formula + "\"") == std::string::npos) continue;
      const std::string address = page_name(lesson.program) + "#" + formula;
      const std::string words = is_covered ? "in its text" : escaped(numbered(lesson)) + ", in its text";
      places += (is_covered       ? ", "
                 : places.empty() ? ""
                                  : "<br>") +
                fmt::format("<a href=\"{}\">{}</a>", address, words);
    }
    const std::optional<std::string> math = math_of(item.what, book.symbols);
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td></tr>\n", escaped(item.name),
                        math ? *math : escaped(item.what), places);
  }
  return page_of(
      "Equations",
      "<h1>Equations</h1>\n<p>The equations, the algorithm and the claims of the paper, and the lessons "
      "that show them.</p>\n<div class=\"table\" role=\"region\" aria-label=\"Table\" tabindex=\"0\">"
      "<table><thead><tr><th>Paper</th><th>What it says</th><th>Where</th></tr></thead>\n<tbody>\n" +
          rows + "</tbody></table></div>\n");
}

std::string teachers_page(const Book& book) {
  std::string items;
  for (const BookLesson& lesson : book) {
    if (lesson.teaching.empty()) continue;
    items += fmt::format("<li><a href=\"teaching{}.html\">{}</a></li>\n", two_digits(lesson.program.number),
                         escaped(numbered(lesson)));
  }
  return page_of(
      "Notes for teachers",
      "<h1>Notes for teachers</h1>\n<p>Minutes, misconceptions and what to draw on the board: a page for "
      "each lesson. <code>bash lessons/run handouts</code> makes all lessons one PDF for print.</p>\n<ul>\n" +
          items + "</ul>\n");
}

}  // namespace cairn::driver
