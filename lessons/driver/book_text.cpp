// Markdown of the lessons as HTML: md4c reads it, and what it gives is then fitted into the page.
#include "lessons/driver/book_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <stdexcept>

#ifdef CAIRN_HAVE_MD4C
#include <md4c-html.h>
#endif

#include "lessons/driver/book.hpp"
#include "lessons/driver/book_code.hpp"

namespace cairn::driver {
namespace {

constexpr const char* source_mark = "<!-- source: ";
constexpr const char* output_mark = "<!-- output of: ";

/// Where a link of a lesson's text leads in the book; "" for nowhere.
std::string led_on(const std::string& target, const TextPlaces& places) {
  if (target.rfind("http", 0) == 0 || target.rfind("#", 0) == 0) return target;
  if (target.rfind("playground.html", 0) == 0) return target;
  const auto file = places.files.find(target);
  if (file != places.files.end()) return file->second;
  if (target.rfind("NOTATION.md") != std::string::npos) return "notation.html";
  if (target.rfind("your_solver/README.md") != std::string::npos) return "your_solver.html";
  if (target.rfind("glossary.md") != std::string::npos) return "glossary.html";
  for (const auto& [folder, page] : places.pages) {
    if (target == "../" + folder + "/README.md" || target == folder + "/README.md") return page;
  }
  return "";
}

/// A paragraph that is a link to the playground, with a scene and settings as its title, is the playground
/// itself; or, where there is none, says how to have it.
std::string with_playgrounds(const std::string& html, const TextPlaces& places) {
  const std::string open = "<p><a href=\"../playground/README.md\" title=\"";
  return replaced(html, open, "</a></p>", [&places](const std::string& link) {
    const std::string address = link.substr(0, link.find('"'));
    if (!places.has_playground) {
      return std::string(
          "<p class=\"note\">The playground would stand here: <code>bash lessons/run playground</code> makes "
          "it, and then "
          "<code>bash lessons/run book</code> puts it into the book.</p>");
    }
    return fmt::format(
        "<figure class=\"playground\">\n<iframe src=\"playground.html{0}&amp;embed=1\" title=\"Playground\" "
        "loading=\"lazy\"></iframe>\n<figcaption><a href=\"playground.html{0}\">On a page of its "
        "own</a></figcaption>\n"
        "</figure>",
        address);
  });
}

/// A link that leads nowhere in the book, to a source file that is not on this page, is its text alone.
std::string with_links(const std::string& html, const TextPlaces& places) {
  return replaced(html, "<a href=\"", "</a>", [&places](const std::string& link) {
    const std::size_t quote = link.find('"');
    const std::string target = led_on(link.substr(0, quote), places);
    const std::string words = link.substr(link.find('>') + 1);
    return target.empty() ? words : fmt::format("<a href=\"{}\">{}</a>", target, words);
  });
}

/// "../../src/solvers/iterative/jacobi.cpp" -> "src/solvers/iterative/jacobi.cpp".
std::string without_dots(std::string file) {
  while (file.rfind("../", 0) == 0) file.erase(0, 3);
  return file;
}

/// "peg.cpp push", as a comment names a quoted piece of a file.
struct Quote {
  std::string file = {};
  std::string name = {};

  explicit Quote(const std::string& comment)
      : file(comment.substr(0, comment.find(' '))), name(comment.substr(comment.find(' ') + 1)) {}
  std::string anchor() const { return without_dots(file) + "-" + name; }
  std::string caption() const {
    return "<code>" + name + "</code> in <code>" + without_dots(file) + "</code>";
  }
};

/// Links to files of which a piece is quoted lead to that piece.
TextPlaces with_quotes(const TextPlaces& places, const std::string& html) {
  TextPlaces more = places;
  replaced(html, source_mark, " -->", [&more](const std::string& comment) {
    const Quote quote(comment);
    more.files.insert({quote.file, "#" + quote.anchor()});
    return std::string();
  });
  return more;
}

/// A figure of the block of code behind a comment.
std::string quoted_figure(const std::string& anchor, const std::string& caption, const std::string& piece) {
  const std::string id = anchor.empty() ? "" : " id=\"" + anchor + "\"";
  return fmt::format("<figure class=\"code\"{}>\n<figcaption>{}</figcaption>\n{}</pre>\n</figure>", id,
                     caption, piece.substr(piece.find("<pre")));
}

/// A block of code, in the colours of its language. A fence without one holds commands or what they print.
std::string block_html(const std::string& block, const TextPlaces& places) {
  const std::size_t end = block.find('>');
  const std::string head = block.substr(0, end);
  const std::string code = unescaped(block.substr(end + 1));
  if (head.find("language-formula") != std::string::npos) {
    const std::optional<std::string> formula = formula_block(code, places.symbols);
    if (formula) return *formula;
  }
  const bool is_cpp = head.find("language-cpp") != std::string::npos;
  const bool is_command = head.find("language") == std::string::npos && code.rfind("bash ", 0) == 0;
  return "<pre tabindex=\"0\"><code>" +
         coloured(code, is_cpp       ? "cpp"
                        : is_command ? "bash"
                                     : "") +
         "</code></pre>";
}

/// Blocks of code that the keyboard can scroll. A block behind a comment that says where it is from gets a
/// caption.
std::string with_code(const std::string& html, const TextPlaces& places) {
  const auto source = [](const std::string& piece) {
    const Quote quote(piece.substr(0, piece.find(" -->")));
    return quoted_figure(quote.anchor(), quote.caption(), piece);
  };
  const auto output = [](const std::string& piece) {
    const std::string mark = piece.substr(0, piece.find(" -->"));
    const std::string command = mark.substr(0, mark.find(" (not compared)"));
    return quoted_figure("", "What <code>" + escaped(command) + "</code> prints", piece);
  };
  const std::string text = replaced(html, "<pre><code", "</code></pre>", [&places](const std::string& block) {
    return block_html(block, places);
  });
  return replaced(replaced(text, source_mark, "</pre>", source), output_mark, "</pre>", output);
}

std::string with_pictures_and_tables(const std::string& html, const TextPlaces& places) {
  const auto cover = [&places](const std::string&) { return places.cover; };
  const auto table = [](const std::string& rows) {
    return "<div class=\"table\" role=\"region\" aria-label=\"Table\" tabindex=\"0\"><table>" + rows +
           "</table></div>";
  };
  return replaced(replaced(html, "<picture>", "</picture>", cover), "<table>", "</table>", table);
}

std::string with_heading_anchor(const std::string& section, const std::string& title) {
  return fmt::format("<h2 id=\"{}\">{}", anchor_of(title), section.substr(std::string("<h2>").size()));
}

}  // namespace

#ifdef CAIRN_HAVE_MD4C

bool can_make_books() { return true; }

std::string html_of(const std::string& markdown) {
  std::string html;
  const auto add = [](const MD_CHAR* text, MD_SIZE size, void* result) {
    static_cast<std::string*>(result)->append(text, size);
  };
  const int code = md_html(markdown.data(), static_cast<MD_SIZE>(markdown.size()), add, &html,
                           MD_FLAG_TABLES | MD_FLAG_STRIKETHROUGH, 0);
  if (code != 0) throw std::runtime_error("html_of: the Markdown cannot be read");
  return html;
}

#else

bool can_make_books() { return false; }

std::string html_of(const std::string&) {
  throw std::runtime_error("html_of: this build cannot read Markdown");
}

#endif

std::string code_figure(const std::string& anchor, const std::string& caption, std::string_view code) {
  return fmt::format(
      "<figure class=\"code\" id=\"{}\">\n<figcaption>{}</figcaption>\n"
      "<pre tabindex=\"0\"><code>{}</code></pre>\n</figure>\n",
      anchor, caption, code);
}

List<Section> sections_of(const std::string& markdown, const TextPlaces& places) {
  const std::string plain = html_of(with_formulas_fenced(markdown));
  const std::string linked = with_links(with_playgrounds(plain, places), with_quotes(places, plain));
  const std::string html =
      with_terms(with_pictures_and_tables(with_code(linked, places), places), places.terms);
  List<Section> sections;
  for (std::size_t begin = 0; begin < html.size();) {
    const std::size_t end = std::min(html.find("<h2>", begin + 1), html.size());
    Section section = {.html = html.substr(begin, end - begin)};
    if (section.html.rfind("<h2>", 0) == 0) {
      section.title = section.html.substr(4, section.html.find("</h2>") - 4);
      section.html = with_heading_anchor(section.html, section.title);
    }
    sections.push_back(section);
    begin = end;
  }
  return sections;
}

}  // namespace cairn::driver
