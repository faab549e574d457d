// What every page of the book is put together from.
#pragma once

#include <string>

#include "lessons/driver/book.hpp"
#include "lessons/driver/book_text.hpp"

namespace cairn::driver {

struct PageParts {
  std::string title = {};
  std::string description = {};
  std::string kind = {};  // "lesson": for the style sheet
  std::string body = {};
  std::string scripts = {};
};

/// The whole page: head, navigation, body, foot.
std::string page(const PageParts& parts);

/// "06 Sequential impulses".
std::string numbered(const BookLesson& lesson);

/// A link to the page of a lesson; `words` are HTML.
std::string page_link(const BookLesson& lesson, const std::string& words, const std::string& relation = {});

/// A frame in two themes.
std::string picture(const BookLesson& lesson, const BookFrame& frame);

/// The frame that stands for a lesson, as a figure; "" where there is none.
std::string cover_figure(const BookLesson& lesson);

/// The inside of a lesson's page, its answer folded.
std::string lesson_body(const Book& book, int index);

/// Where the links, pictures and symbols of a text of this book lead.
TextPlaces places_in(const Book& book);

}  // namespace cairn::driver
