// Writes the lesson book and the handouts: what the lessons say, draw and print, as pages.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <regex>

#include "lessons/driver/book_making.hpp"
#include "lessons/driver/commands.hpp"
#include "lessons/driver/interruption.hpp"
#include "lessons/driver/process.hpp"
#include "lessons/driver/work_folder.hpp"

namespace cairn::driver {
namespace {

namespace fs = std::filesystem;
using Words = List<std::string>;

/// Pictures of an earlier book that this one does not show.
void remove_old_pictures(const fs::path& folder, const fs::path& made) {
  static const std::regex ours("lesson[0-9]{2}_[0-9]{4,}_(light|dark)\\.png");
  List<fs::path> old;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (std::regex_match(name, ours) && !fs::exists(made / name)) old.push_back(entry.path());
  }
  for (const fs::path& file : old) fs::remove(file);
}

/// Puts the whole book in its place, over an earlier one.
void deliver(const fs::path& made, const fs::path& folder) {
  require_uninterrupted();
  fs::create_directories(folder / "frames");
  remove_old_pictures(folder / "frames", made / "frames");
  for (const auto& entry : fs::recursive_directory_iterator(made)) {
    if (entry.is_regular_file()) move_to(entry.path(), folder / entry.path().lexically_relative(made));
  }
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
  const BookSize book = make_pages(context, shop);
  const double megabytes = static_cast<double>(size_of(shop.book)) / 1e6;
  deliver(shop.book, folder);
  console.result(fmt::format("{} lessons, {} pictures, {:.1f} MB: open {}", book.lessons, book.pictures,
                             megabytes, (folder / "index.html").string()));
  if (!book.all_held) console.warn("lessons: a lesson's own check failed; its page shows which");
  return book.all_held ? 0 : 1;
}

/// Chromium prints a page. Only one that is tagged says to a screen reader what is a heading and what a list,
/// but that is a quarter of its bytes.
/// @throws ProgramFailed
void print_page(const std::string& browser, const fs::path& page, const fs::path& print, bool is_tagged) {
  Words command = {browser,
                   "--headless",
                   "--no-sandbox",
                   "--disable-gpu",
                   "--no-pdf-header-footer",
                   "--user-data-dir=" + (page.parent_path() / "browser").string(),
                   "--print-to-pdf=" + print.string()};
  if (!is_tagged) command.push_back("--disable-pdf-tagging");
  command.push_back("file://" + page.string());
  const ProcessResult printed = run_quietly(command);
  require_uninterrupted();
  if (printed.code != 0 || !fs::exists(print))
    throw ProgramFailed("chromium cannot print " + page.filename().string() + ":\n" + printed.output,
                        cannot_make);
}

/// One file of all lessons, and beside it one of each: handouts.pdf, handouts_06.pdf.
int make_handouts(const Context& context, const fs::path& file, const std::string& browser) {
  Console console(context.settings);
  const WorkFolder work(fs::absolute(file).parent_path());
  const Workshop shop = {.book = work.path / "book", .work = work.path / "runs", .is_for_print = true};
  const BookSize book = make_pages(context, shop);
  List<std::string> ends = {""};  // of the names of the files
  for (const Program& program : built(context.programs)) ends.push_back("_" + two_digits(program.number));
  Progress progress(context.settings, "files", ends.size());
  for (const std::string& end : ends) {
    const std::string page = end.empty() ? "handouts.html" : "handout" + end.substr(1) + ".html";
    print_page(browser, shop.book / page, work.path / ("handouts" + end + ".pdf"), !end.empty());
    progress.advance(static_cast<int>(&end - ends.data()) + 1);
  }
  for (const std::string& end : ends)
    move_to(work.path / ("handouts" + end + ".pdf"),
            file.parent_path() / (file.stem().string() + end + ".pdf"));
  console.result(fmt::format("{} lessons: {}, and beside it a file for each", book.lessons, file.string()));
  return book.all_held ? 0 : 1;
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

/// Why no pages can be made; "" where they can.
std::string missing_pandoc() {
  if (run_quietly({"pandoc", "--version"}).code == 0) return "";
  return "lessons: the pages are made by pandoc; apt-get install pandoc";
}

/// Makes it, or says why it is as it was before.
int made_or_refused(Console& console, const fs::path& place, const std::function<int()>& make) {
  note_interrupts();
  try {
    return make();
  } catch (const ProgramFailed& failure) {
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
    console.result(
        "lessons handouts [FILE (out/handouts.pdf)]: all lessons as one PDF for print, and beside it one of\n"
        "each lesson, such as out/handouts_06.pdf; the answers stand at the end");
    return 0;
  }
  const fs::path file = words.empty() ? "out/handouts.pdf" : words.front();
  if (words.size() > 1 || file.extension() != ".pdf") {
    console.warn("lessons: handouts takes one file that ends in .pdf, got \"" +
                 (words.size() > 1 ? words[1] : file.string()) + "\"");
    return 2;
  }
  const std::string browser = chromium();
  if (browser.empty() || !missing_pandoc().empty()) {
    console.warn(browser.empty()
                     ? "lessons: handouts needs chromium, which prints them; apt-get install chromium"
                     : missing_pandoc());
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
  if (!missing_pandoc().empty()) {
    console.warn(missing_pandoc());
    return cannot_make;
  }
  const bool has_folder = !words.empty() && words.front().rfind("-", 0) != 0;
  const fs::path folder = has_folder ? words.front() : "out/book";
  const Words flags(words.begin() + (has_folder ? 1 : 0), words.end());
  return made_or_refused(console, folder, [&] { return make_book(context, folder, flags); });
}

}  // namespace cairn::driver
