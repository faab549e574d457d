// The table of contents, around the text of book.md.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "lessons/driver/book.hpp"
#include "lessons/driver/book_parts.hpp"
#include "lessons/driver/book_text.hpp"

namespace cairn::driver {
namespace {

std::string order_links(const Book& book, const std::string& numbers) {
  std::istringstream words(numbers);
  std::string text;
  for (int number = 0; words >> number;) {
    for (const BookLesson& lesson : book) {
      if (lesson.program.number != number) continue;
      text += (text.empty() ? "" : ", ") + page_link(lesson, escaped(numbered(lesson)));
    }
  }
  return text;
}

std::string contents(const Book& book) {
  std::string text = "<ol class=\"contents\">\n";
  for (const BookLesson& lesson : book) {
    const BookFrame* cover = cover_of(lesson);
    text += fmt::format("<li>{}<div><h3>{}</h3><p>{}</p></div></li>\n",
                        cover == nullptr ? "" : picture(lesson, *cover),
                        page_link(lesson, escaped(numbered(lesson))), escaped(lesson.program.card.idea));
  }
  return text + "</ol>\n";
}

/// The picture of the book: the tower, where it was drawn.
std::string book_cover(const Book& book) {
  for (const BookLesson& lesson : book) {
    if (lesson.program.number == 17 && !lesson.frames.empty()) return cover_figure(lesson);
  }
  return book.empty() ? "" : cover_figure(book.front());
}

std::string playground_words(const Book& book) {
  if (book.has_playground) {
    return "<p><a href=\"playground.html\">Open the playground</a>: the lessons lead to it with scenes of "
           "their own.</p>\n";
  }
  return "<p><code>bash lessons/run playground</code> makes it; then <code>bash lessons/run book</code> puts "
         "it into this "
         "book.</p>\n";
}

/// "prerequisites.html five questions" as a link to that page of the book.
std::string book_link(const std::string& target) {
  const std::size_t blank = target.find(' ');
  return "<a href=\"" + target.substr(0, blank) + "\">" + target.substr(blank + 1) + "</a>";
}

/// What a line such as <!-- contents --> of book.md stands for.
std::string filled_in(const Book& book, const std::string& mark) {
  const std::string order = "order: ";
  if (mark == "cover") return book_cover(book);
  if (mark == "contents") return contents(book);
  if (mark == "playground") return playground_words(book);
  if (mark.rfind("link: ", 0) == 0) return book_link(mark.substr(6));
  return mark.rfind(order, 0) == 0 ? order_links(book, mark.substr(order.size())) : "";
}

}  // namespace

std::string index_page(const Book& book, const std::string& text) {
  std::string html = html_of(text);
  std::string body;
  for (std::size_t at = 0; at < html.size();) {
    const std::size_t begin = std::min(html.find("<!-- ", at), html.size());
    const std::size_t end = std::min(html.find(" -->", begin), html.size());
    body += html.substr(at, begin - at);
    if (begin < html.size()) body += filled_in(book, html.substr(begin + 5, end - begin - 5));
    at = end + 4;
  }
  return page({.title = "Cairn: the lesson book",
               .description = "How constraint solvers work, lesson by lesson.",
               .kind = "index",
               .body = body});
}

}  // namespace cairn::driver
