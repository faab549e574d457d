// The pages of the book: one for each lesson, and the table of contents.
#include <fmt/format.h>

#include <sstream>

#include "lessons/driver/book.hpp"
#include "lessons/driver/book_text.hpp"
#include "lessons/driver/exercises.hpp"
#include "math/list.hpp"

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
</head>
<body>
<a class="skip" href="#main">Skip to the text</a>
<header>
<nav aria-label="Book">{navigation}</nav>
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

struct PageParts {
  std::string title = {};
  std::string description = {};
  std::string navigation = {};
  std::string kind = {};
  std::string body = {};
};

std::string page(const PageParts& parts) {
  return fmt::format(page_frame, fmt::arg("title", escaped(parts.title)),
                     fmt::arg("description", escaped(parts.description)),
                     fmt::arg("navigation", parts.navigation), fmt::arg("kind", parts.kind),
                     fmt::arg("body", parts.body), fmt::arg("version", CAIRN_VERSION));
}

std::string numbered(const BookLesson& lesson) {
  return two_digits(lesson.program.number) + " " + lesson.program.card.title;
}

std::string page_link(const BookLesson& lesson, const std::string& words, const std::string& relation = {}) {
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

std::string frame_item(const BookLesson& lesson, const BookFrame& frame) {
  const std::string state = frame.state.empty() ? "" : " · " + escaped(frame.state);
  return fmt::format(
      "<li id=\"frame-{0}\"><figure>{1}\n<figcaption>\n<p><a href=\"#frame-{0}\">Frame {0} of "
      "{2}</a>{3}</p>\n"
      "<details><summary>What it shows</summary><p>{4}</p></details>\n</figcaption></figure></li>\n",
      frame.number, picture(lesson, frame), lesson.frames_in_all, state, escaped(frame.alt));
}

constexpr const char* player_controls = R"(<div class="controls" hidden>
<button type="button" class="previous" aria-label="Previous frame">◀&#xFE0E;</button>
<button type="button" class="play">Play</button>
<button type="button" class="next" aria-label="Next frame">▶&#xFE0E;</button>
<input type="range" min="0" max="{}" value="0" step="1" aria-label="Frame">
<button type="button" class="enlarge" aria-label="Frames in full size" aria-pressed="false">1:1</button>
</div>
<div class="caption" hidden></div>
)";

std::string player(const BookLesson& lesson) {
  if (lesson.frames.empty()) return "";
  std::string text = "<section class=\"player\" aria-label=\"Frames\">\n<ol class=\"frames\">\n";
  for (const BookFrame& frame : lesson.frames) text += frame_item(lesson, frame);
  text += "</ol>\n" + fmt::format(player_controls, lesson.frames.size() - 1);
  if (lesson.frames.size() < lesson.frames_in_all) {
    text += fmt::format(
        "<p class=\"note\">{} of {} frames; <code>bash lessons/run {} --frames all</code> draws the others "
        "too.</p>\n",
        lesson.frames.size(), lesson.frames_in_all, lesson.program.number);
  }
  return text + "</section>\n";
}

std::string console_figure(const BookLesson& lesson) {
  const std::string caption =
      fmt::format("What <code>bash lessons/run {}</code> prints", lesson.program.number);
  return code_figure("output", caption, lesson.console);
}

std::string exercise_figures(const BookLesson& lesson) {
  const std::string folder = lesson_folder(lesson.program).filename().string();
  std::string text;
  for (const BookSource& source : lesson.exercise) {
    text +=
        code_figure(source.name, fmt::format("<code>lessons/{}/{}</code>", folder, source.name), source.text);
  }
  return text;
}

TextPlaces places_for(const Book& book, const BookLesson& lesson) {
  TextPlaces places = {.cover = cover_figure(lesson), .has_playground = book.has_playground};
  for (const BookLesson& other : book) {
    places.pages[lesson_folder(other.program).filename().string()] = page_name(other.program);
  }
  for (const BookSource& source : lesson.exercise) places.files[source.name] = "#" + source.name;
  return places;
}

/// What a page shows beside the text, and the section of the text that it belongs to.
struct Addition {
  std::string section = {};
  std::string title = {};  // of a section of its own, for texts without that one
  std::string html = {};
  bool is_first = false;  // behind the heading instead of at the end
};

void add(List<Section>& sections, const Addition& addition) {
  if (addition.html.empty()) return;
  for (Section& section : sections) {
    if (section.title != addition.section) continue;
    const std::size_t heading = section.html.find("</h2>") + std::string("</h2>").size();
    section.html.insert(addition.is_first ? heading : section.html.size(), "\n" + addition.html);
    return;
  }
  sections.push_back({.title = addition.title, .html = "<h2>" + addition.title + "</h2>\n" + addition.html});
}

/// The lessons before and behind this one.
std::string turning(const Book& book, int index) {
  std::string text = "<nav class=\"turn\" aria-label=\"Lessons\">\n";
  if (index > 0) text += page_link(book[index - 1], "← " + escaped(numbered(book[index - 1])), "prev") + "\n";
  text += "<a href=\"index.html\">All lessons</a>\n";
  if (index + 1 < book.size())
    text += page_link(book[index + 1], escaped(numbered(book[index + 1])) + " →", "next") + "\n";
  return text + "</nav>\n";
}

/// "lesson" and what the paper says of it, above the title; the idea below.
std::string with_idea(const std::string& html, const BookLesson& lesson) {
  const std::size_t end = html.find("</h1>");
  const std::size_t behind = end == std::string::npos ? 0 : end + std::string("</h1>").size();
  return fmt::format("<p class=\"kicker\">{}</p>\n{}\n<p class=\"idea\">{}</p>{}",
                     escaped(lesson.program.card.paper), html.substr(0, behind),
                     escaped(lesson.program.card.idea), html.substr(behind));
}

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

/// What a line such as <!-- contents --> of book.md stands for.
std::string filled_in(const Book& book, const std::string& mark) {
  const std::string order = "order: ";
  if (mark == "cover") return book_cover(book);
  if (mark == "contents") return contents(book);
  if (mark == "playground") return playground_words(book);
  return mark.rfind(order, 0) == 0 ? order_links(book, mark.substr(order.size())) : "";
}

}  // namespace

std::string page_name(const Program& program) { return "lesson" + two_digits(program.number) + ".html"; }

const BookFrame* cover_of(const BookLesson& lesson) {
  const int cover = lesson.program.card.cover;
  const int number = cover < 0 ? lesson.frames_in_all + 1 + cover : cover;
  for (const BookFrame& frame : lesson.frames) {
    if (frame.number == number) return &frame;
  }
  return lesson.frames.empty() ? nullptr : &lesson.frames.front();
}

std::string lesson_page(const Book& book, int index) {
  const BookLesson& lesson = book[index];
  List<Section> sections = sections_of(lesson.text, places_for(book, lesson));
  if (sections.empty()) sections.push_back({.html = "<h1>" + escaped(numbered(lesson)) + "</h1>"});
  sections.front().html = with_idea(sections.front().html, lesson);
  add(sections, {"What to look at", "The frames", player(lesson), true});
  add(sections, {"Run it", "What it prints", console_figure(lesson), false});
  add(sections, {"Your turn", "The exercise", exercise_figures(lesson), false});
  std::string body;
  for (const Section& section : sections) body += section.html;
  return page({.title = numbered(lesson) + " · Cairn",
               .description = lesson.program.card.idea,
               .navigation = "<a href=\"index.html\">Cairn: the lesson book</a>",
               .kind = "lesson",
               .body = body + turning(book, index)});
}

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
               .navigation = "<a href=\"index.html\" aria-current=\"page\">Cairn: the lesson book</a>",
               .kind = "index",
               .body = body});
}

}  // namespace cairn::driver
