// Writes the lesson book and the handouts: what the lessons say, draw and print, as pages.
#include "lessons/driver/book.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <regex>
#include <set>

#include "lessons/driver/book_making.hpp"
#include "lessons/driver/book_parts.hpp"
#include "lessons/driver/book_reference.hpp"
#include "lessons/driver/commands.hpp"
#include "lessons/driver/exercises.hpp"
#include "lessons/driver/interruption.hpp"
#include "lessons/driver/process.hpp"
#include "lessons/driver/work_folder.hpp"
#include "measure/whole_file.hpp"

namespace cairn::driver {
namespace {

namespace fs = std::filesystem;
using Words = List<std::string>;

constexpr int cannot_make = 3;

/// Pictures of an earlier book that this one does not show.
void remove_old_pictures(const fs::path& folder, const Book& book) {
  std::set<std::string> shown;
  for (const BookLesson& lesson : book) {
    for (const BookFrame& frame : lesson.frames) shown.insert({frame.light, frame.dark});
  }
  static const std::regex ours("lesson[0-9]{2}_[0-9]{4,}_(light|dark)\\.png");
  List<fs::path> old;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (std::regex_match(name, ours) && shown.count(name) == 0) old.push_back(entry.path());
  }
  for (const fs::path& file : old) fs::remove(file);
}

/// The texts of the project that the book shows beside its lessons.
struct ProjectTexts {
  std::string glossary = text_of(lessons_folder() / "glossary.md");
  std::string prerequisites = text_of(lessons_folder() / "prerequisites.md");
  std::string your_solver = text_of(lessons_folder() / "your_solver/README.md");
  std::string notation = text_of(lessons_folder() / "../src/NOTATION.md");
};

/// By their names. Teachers' notes and the table of contents are not searched.
std::map<std::string, std::string> searched_pages(const Book& book, const ProjectTexts& texts) {
  std::map<std::string, std::string> pages;
  for (int i = 0; i < book.size(); ++i) pages[page_name(book[i].program)] = lesson_page(book, i);
  const std::string equations = equations_page(book, pages);
  pages["equations.html"] = equations;
  pages["glossary.html"] = glossary_page(book, texts.glossary);
  pages["notation.html"] = notation_page(book, texts.notation);
  pages["your_solver.html"] = text_page(book, texts.your_solver, "A solver of your own");
  pages["prerequisites.html"] = text_page(book, texts.prerequisites, "Prerequisites");
  return pages;
}

void write_pages(const fs::path& folder, Book& book) {
  const fs::path source = lessons_folder() / "driver";
  const ProjectTexts texts;
  book.symbols = symbols_of(texts.notation);
  book.terms = terms_of(texts.glossary);
  std::map<std::string, std::string> files = searched_pages(book, texts);
  files["search.js"] = search_index(files, book.terms);
  files["search.html"] = search_page();
  files["teachers.html"] = teachers_page(book);
  for (const BookLesson& lesson : book) {
    if (lesson.teaching.empty()) continue;
    files["teaching" + two_digits(lesson.program.number) + ".html"] =
        text_page(book, lesson.teaching, numbered(lesson) + ", for teachers");
  }
  if (book.has_playground) files["playground.html"] = text_of(playground_file);
  for (const char* name : {"book.css", "book.js"}) files[name] = text_of(source / name);
  files["index.html"] = index_page(book, text_of(source / "book.md"));
  for (const auto& [name, text] : files) write_whole_file(folder / name, text);
}

/// Puts the whole book in its place, over an earlier one.
void deliver(const fs::path& made, const fs::path& folder, const Book& book) {
  require_uninterrupted();
  fs::create_directories(folder / "frames");
  for (const auto& entry : fs::recursive_directory_iterator(made)) {
    if (entry.is_regular_file()) move_to(entry.path(), folder / entry.path().lexically_relative(made));
  }
  remove_old_pictures(folder / "frames", book);
}

std::uintmax_t size_of(const fs::path& folder) {
  std::uintmax_t size = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) size += entry.file_size();
  }
  return size;
}

int make_book(const Context& context, const fs::path& folder, const Words& flags) {
  Console console(context.settings);
  const WorkFolder work(folder);
  const Workshop shop = {.book = work.path / "book", .work = work.path / "runs", .flags = flags};
  bool all_held = true;
  Book book = gathered(context, shop, all_held);
  write_pages(shop.book, book);
  const double megabytes = static_cast<double>(size_of(shop.book)) / 1e6;
  deliver(shop.book, folder, book);
  int pictures = 0;
  for (const BookLesson& lesson : book) pictures += 2 * lesson.frames.size();
  console.result(fmt::format("{} lessons, {} pictures, {:.1f} MB: open {}", book.size(), pictures, megabytes,
                             (folder / "index.html").string()));
  if (!all_held) console.warn("lessons: a lesson's own check failed; its page shows which");
  return all_held ? 0 : 1;
}

/// Chromium prints the page that has all lessons.
int make_handouts(const Context& context, const fs::path& file, const std::string& browser) {
  Console console(context.settings);
  const WorkFolder work(fs::absolute(file).parent_path());
  const Workshop shop = {.book = work.path / "book", .work = work.path / "runs"};
  const fs::path print = work.path / "handouts.pdf";
  bool all_held = true;
  Book book = gathered(context, shop, all_held);
  write_pages(shop.book, book);
  write_whole_file(shop.book / "handouts.html", handouts_page(book));
  const ProcessResult printed =
      run_quietly({browser, "--headless", "--no-sandbox", "--disable-gpu", "--no-pdf-header-footer",
                   "--user-data-dir=" + (shop.book / "browser").string(), "--print-to-pdf=" + print.string(),
                   "file://" + (shop.book / "handouts.html").string()});
  require_uninterrupted();
  if (printed.code != 0 || !fs::exists(print)) {
    console.warn("lessons: chromium cannot print " + file.string() + ":\n" + printed.output);
    return cannot_make;
  }
  move_to(print, file);
  console.result(fmt::format("{} lessons: {}", book.size(), file.string()));
  return all_held ? 0 : 1;
}

/// "" where there is none.
std::string chromium() {
  for (const char* path : {"/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"}) {
    if (fs::exists(path)) return path;
  }
  return "";
}

bool asks_for_help(const Words& words) {
  return std::any_of(words.begin(), words.end(),
                     [](const std::string& word) { return word == "-h" || word == "--help"; });
}

/// Why a build cannot make pages; "" where it can.
std::string missing_reader() {
  if (can_make_books()) return "";
  return "lessons: this build cannot read Markdown; apt-get install libmd4c-dev libmd4c-html0-dev, then "
         "configure anew";
}

/// Makes it, or says why it is as it was before.
int made_or_refused(Console& console, const fs::path& place, const std::function<int()>& make) {
  note_interrupts();
  try {
    return make();
  } catch (const LessonFailed& failure) {
    console.warn(std::string("lessons: ") + failure.what());
    return failure.code;
  } catch (const Interrupted&) {
    const char* state = fs::exists(place) ? " is as it was" : " was not written";
    console.warn("lessons: interrupted; " + place.string() + state);
    return stopped;
  }
}

}  // namespace

int handouts(const Context& context, const Words& words) {
  Console console(context.settings);
  if (asks_for_help(words)) {
    console.result("lessons handouts [FILE (out/handouts.pdf)]: all lessons as one PDF for print");
    return 0;
  }
  const fs::path file = words.empty() ? "out/handouts.pdf" : words.front();
  if (words.size() > 1 || file.extension() != ".pdf") {
    console.warn("lessons: handouts takes one file that ends in .pdf, got \"" +
                 (words.size() > 1 ? words[1] : file.string()) + "\"");
    return 2;
  }
  const std::string browser = chromium();
  if (browser.empty() || !missing_reader().empty()) {
    console.warn(browser.empty()
                     ? "lessons: handouts needs chromium, which prints them; apt-get install chromium"
                     : missing_reader());
    return cannot_make;
  }
  return made_or_refused(console, file, [&] { return make_handouts(context, file, browser); });
}

int book(const Context& context, const Words& words) {
  Console console(context.settings);
  if (asks_for_help(words)) {
    console.result(
        "lessons book [FOLDER (out/book)] [flags of the lessons, such as --frames all --size medium]");
    return 0;
  }
  if (!missing_reader().empty()) {
    console.warn(missing_reader());
    return cannot_make;
  }
  const bool has_folder = !words.empty() && words.front().rfind("-", 0) != 0;
  const fs::path folder = has_folder ? words.front() : "out/book";
  const Words flags(words.begin() + (has_folder ? 1 : 0), words.end());
  return made_or_refused(console, folder, [&] { return make_book(context, folder, flags); });
}

}  // namespace cairn::driver
