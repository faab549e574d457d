// What the search looks through, and all lessons on one page.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "lessons/driver/book_parts.hpp"
#include "lessons/driver/book_reference.hpp"
#include "lessons/driver/book_text.hpp"

namespace cairn::driver {
namespace {

constexpr const char* fold = "<details class=\"fold\">";

std::string between(const std::string& html, const std::string& open, const std::string& close) {
  const std::size_t begin = html.find(open);
  if (begin == std::string::npos) return "";
  const std::size_t from = begin + open.size();
  return html.substr(from, html.find(close, from) - from);
}

/// One entry a section: where it is, the page, the heading, the text without what is folded in it, and
/// whether the section itself is folded until somebody has guessed.
void add_sections(nlohmann::json& entries, const std::string& name, const std::string& html) {
  const std::string title = unescaped(without_tags(between(html, "<h1>", "</h1>")));
  const std::string main = between(html, "<main", "</main>");
  for (std::size_t begin = main.find("<h1>"); begin != std::string::npos && begin < main.size();) {
    const std::size_t end = std::min(main.find("<h2", begin + 1), main.size());
    const bool is_folded = main.rfind(fold, begin) < begin;
    const auto nothing = [](const std::string&) { return std::string(); };
    const std::string open = replaced(main.substr(begin, end - begin), "<nav", "</nav>", nothing);
    const std::string section = replaced(open, "</summary>", "</details>", nothing);
    const std::string heading = unescaped(without_tags("<" + between(section, "<h2", "</h2>")));
    const std::string anchor = heading.empty() ? "" : "#" + between(section, "<h2 id=\"", "\"");
    entries.push_back({name + anchor, title, heading, unescaped(without_tags(section)), is_folded});
    begin = end;
  }
}

}  // namespace

std::string search_page() {
  return page({.title = "Search · Cairn",
               .description = "A search over all pages of the lesson book.",
               .kind = "reference",
               .body =
                   "<h1>Search</h1>\n<p class=\"found\" role=\"status\">The search needs JavaScript.</p>\n"
                   "<ol class=\"results\"></ol>\n",
               .scripts = "<script src=\"search.js\"></script>\n"});
}

std::string search_index(const std::map<std::string, std::string>& pages, const List<Term>& terms) {
  nlohmann::json entries = nlohmann::json::array();
  for (const Term& term : terms) {
    entries.push_back({"glossary.html#" + term.anchor, "Glossary", term.name, term.meaning, false});
  }
  for (const auto& [name, html] : pages) {
    if (name != "glossary.html") add_sections(entries, name, html);
  }
  return "const cairnSections = " + entries.dump(0) + ";\n";
}

std::string handouts_page(const Book& book) {
  std::string contents, body;
  for (int i = 0; i < book.size(); ++i) {
    const std::string name = page_name(book[i].program);
    const LessonInfo& card = book[i].program.card;
    contents +=
        fmt::format("<li><a href=\"#{}\">{}</a><br>{}</li>\n", name, escaped(card.title), escaped(card.idea));
    const std::string stem = name.substr(0, name.find('.')) + "-";
    std::string html = replaced(lesson_body(book, i), fold, "</summary>",
                                [](const std::string&) { return std::string("<div>"); });
    const std::size_t end = html.rfind("</details>");
    if (end != std::string::npos) html.replace(end, std::string("</details>").size(), "</div>");
    html = replaced(html, " id=\"", "\"",
                    [&stem](const std::string& id) { return " id=\"" + stem + id + "\""; });
    html = replaced(html, " href=\"#", "\"",
                    [&stem](const std::string& id) { return " href=\"#" + stem + id + "\""; });
    body += "<article id=\"" + name + "\">\n" + html + "</article>\n";
  }
  return page({.title = "Cairn: handouts",
               .description = "All lessons on one page, for print.",
               .kind = "lesson handouts",
               .body = "<article class=\"front\">\n<h1>Cairn: the lessons</h1>\n<ol start=\"0\">\n" +
                       contents + "</ol>\n</article>\n" + body});
}

}  // namespace cairn::driver
