// The lesson book: what a page is made of, and the pages themselves.
#pragma once

#include <filesystem>
#include <string>

#include "lessons/driver/book_text.hpp"
#include "lessons/driver/catalogue.hpp"
#include "math/list.hpp"

namespace cairn::driver {

/// A picture of a lesson, drawn twice. The names are those of files in the book's folder frames/.
struct BookFrame {
  int number = 0;          // of all frames of the lesson, from 1
  std::string state = {};  // "sweep 2/10 · row 2 of 3"
  std::string alt = {};    // what it shows
  std::string light = {};
  std::string dark = {};
};

/// A source file that a page shows whole.
struct BookSource {
  std::string name = {};  // "exercise.cpp"
  std::string text = {};
};

struct BookLesson {
  Program program = {};
  std::string text = {};     // README.md
  std::string console = {};  // what the program printed
  int frames_in_all = 0;
  int width = 0;  // [px] of its pictures
  int height = 0;
  List<BookFrame> frames = {};
  List<BookSource> exercise = {};
  std::string teaching = {};  // teaching.md; "" where there is none
  bool has_stage = false;     // of the reader's own solver
};

struct Book : List<BookLesson> {
  bool has_playground = false;  // beside the pages: playground.html
  SymbolPages symbols = {};     // of src/NOTATION.md
  List<Term> terms = {};        // of lessons/glossary.md
};

/// "lesson06.html".
std::string page_name(const Program& program);

/// The frame that stands for the lesson, or its first; nullptr where there is none.
const BookFrame* cover_of(const BookLesson& lesson);

/// HTML of the page of one lesson. @throws std::runtime_error when this build cannot read Markdown.
std::string lesson_page(const Book& book, int index);

/// HTML of the table of contents, around the text of book.md.
std::string index_page(const Book& book, const std::string& text);

/// Whether this build reads Markdown.
bool can_make_books();

}  // namespace cairn::driver
