// The page of a lesson.
#include <fmt/format.h>

#include <set>

#include "lessons/driver/book.hpp"
#include "lessons/driver/book_code.hpp"
#include "lessons/driver/book_parts.hpp"
#include "lessons/driver/book_text.hpp"
#include "lessons/driver/exercises.hpp"
#include "math/list.hpp"

namespace cairn::driver {
namespace {

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
<button type="button" class="full" aria-label="Full screen"><svg viewbox="0 0 16 16" aria-hidden="true"><path d="M2 6V2h4M10 2h4v4M14 10v4h-4M6 14H2v-4"></path></svg></button>
</div>
<div class="caption" hidden></div>
<p class="spoken" aria-live="polite"></p>
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
  return code_figure("output", caption, escaped(lesson.console));
}

std::string exercise_figures(const BookLesson& lesson) {
  const std::string folder = lesson_folder(lesson.program).filename().string();
  std::string text;
  for (const BookSource& source : lesson.exercise) {
    text += code_figure(source.name, fmt::format("<code>lessons/{}/{}</code>", folder, source.name),
                        coloured(source.text, "cpp"));
  }
  return text;
}

std::string stage_note(const BookLesson& lesson) {
  if (!lesson.has_stage) return "";
  return fmt::format(
      "<p class=\"note\">This lesson is also a stage of <a href=\"your_solver.html\">a solver of your "
      "own</a>: "
      "<code>bash lessons/run solver {}</code></p>\n",
      lesson.program.number);
}

TextPlaces places_for(const Book& book, const BookLesson& lesson) {
  TextPlaces places = places_in(book);
  places.cover = cover_figure(lesson);
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
  sections.push_back({.title = addition.title,
                      .html = fmt::format("<h2 id=\"{}\">{}</h2>\n{}", anchor_of(addition.title),
                                          addition.title, addition.html)});
}

/// The lessons before and behind this one.
std::string turning(const Book& book, int index) {
  std::string text = "<nav class=\"turn\" aria-label=\"Lessons\">\n";
  if (index > 0) text += page_link(book[index - 1], "← " + escaped(numbered(book[index - 1])), "prev") + "\n";
  text += "<a href=\"index.html\">All lessons</a>\n";
  if (!book[index].teaching.empty()) {
    text +=
        fmt::format("<a href=\"teaching{}.html\">For teachers</a>\n", two_digits(book[index].program.number));
  }
  if (index + 1 < book.size())
    text += page_link(book[index + 1], escaped(numbered(book[index + 1])) + " →", "next") + "\n";
  return text + "</nav>\n";
}

constexpr const char* fold_mark = "<!-- fold -->";
constexpr const char* fold_begin = R"(<form class="guess" hidden>
<label>Your guess <input name="guess" autocomplete="off"></label>
<button>Go on</button>
</form>
<details class="fold"><summary>Go on to the answer</summary>
)";

/// Links to the sections of a text.
std::string section_links(const std::string& html) {
  std::string items;
  replaced(html, "<h2 id=\"", "</h2>", [&items](const std::string& heading) {
    const std::size_t quote = heading.find('"');
    items += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", heading.substr(0, quote),
                         without_tags("<" + heading.substr(quote)));
    return heading;
  });
  return "<nav class=\"sections\" aria-label=\"On this page\">\n<ul>\n" + items + "</ul>\n</nav>\n";
}

/// Closes everything behind the question. What is there is listed there: headings tell, too.
std::string folded(const std::string& body) {
  const std::size_t fold = body.find(fold_mark);
  if (fold == std::string::npos) return body;
  const std::string behind = body.substr(fold + std::string(fold_mark).size());
  return body.substr(0, fold) + fold_begin + section_links(behind) + behind + "</details>\n";
}

/// An anchor for the first place of each numbered equation: "eq-22".
std::string with_equation_anchors(const std::string& body) {
  std::set<std::string> seen;
  return replaced(body, "<span class=\"tag\">", "<", [&seen](const std::string& tag) {
    const std::string anchor = "eq-" + anchor_of(tag);
    const std::string id = seen.insert(anchor).second ? " id=\"" + anchor + "\"" : "";
    return "<span class=\"tag\"" + id + ">" + tag + "<";
  });
}

/// "lesson" and what the paper says of it, above the title; the idea below.
std::string with_idea(const std::string& html, const BookLesson& lesson) {
  const std::size_t end = html.find("</h1>");
  const std::size_t behind = end == std::string::npos ? 0 : end + std::string("</h1>").size();
  return fmt::format("<p class=\"kicker\">{}</p>\n{}\n<p class=\"idea\">{}</p>{}",
                     escaped(lesson.program.card.paper), html.substr(0, behind),
                     escaped(lesson.program.card.idea), html.substr(behind));
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

std::string lesson_body(const Book& book, int index) {
  const BookLesson& lesson = book[index];
  List<Section> sections = sections_of(lesson.text, places_for(book, lesson));
  if (sections.empty()) sections.push_back({.html = "<h1>" + escaped(numbered(lesson)) + "</h1>"});
  sections.front().html = with_idea(sections.front().html, lesson);
  add(sections, {"What to look at", "The frames", player(lesson), true});
  add(sections, {"Run it", "What it prints", console_figure(lesson), false});
  add(sections, {"Your turn", "The exercise", exercise_figures(lesson) + stage_note(lesson), false});
  std::string body;
  for (const Section& section : sections) body += section.html;
  return folded(with_equation_anchors(body));
}

std::string lesson_page(const Book& book, int index) {
  const BookLesson& lesson = book[index];
  return page({.title = numbered(lesson) + " · Cairn",
               .description = lesson.program.card.idea,
               .kind = "lesson",
               .body = lesson_body(book, index) + turning(book, index)});
}

}  // namespace cairn::driver
