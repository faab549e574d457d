// The pages beside the lessons: glossary, notation, equations, prerequisites, teacher's notes, search.
#pragma once

#include <map>
#include <string>

#include "lessons/driver/book.hpp"

namespace cairn::driver {

/// The terms of lessons/glossary.md: "- **term**: what it means".
List<Term> terms_of(const std::string& markdown);

/// Which row of the table of src/NOTATION.md explains a symbol.
SymbolPages symbols_of(const std::string& markdown);

/// A page of its own for a text of the project; what formulas and links it has lead on as those of a lesson.
std::string text_page(const Book& book, const std::string& markdown, const std::string& title);

/// As text_page, with an anchor for each term.
std::string glossary_page(const Book& book, const std::string& markdown);

/// As text_page, with an anchor for each row of the table.
std::string notation_page(const Book& book, const std::string& markdown);

/// Every equation, algorithm and claim of the paper, with the lessons that have it. `pages` are the HTML of
/// the lessons, by name.
std::string equations_page(const Book& book, const std::map<std::string, std::string>& pages);

/// A list of the lessons' teacher's notes.
std::string teachers_page(const Book& book);

/// The page that searches, and the script with every term and the text of every section of `pages`.
std::string search_page();
std::string search_index(const std::map<std::string, std::string>& pages, const List<Term>& terms);

/// Every lesson on one page without a fold, for paper.
std::string handouts_page(const Book& book);

}  // namespace cairn::driver
