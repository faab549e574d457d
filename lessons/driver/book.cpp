// Makes the lesson book: runs every lesson, and writes its text, pictures and output as pages.
#include "lessons/driver/book.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "lessons/driver/commands.hpp"
#include "lessons/driver/exercises.hpp"
#include "lessons/driver/process.hpp"
#include "measure/whole_file.hpp"

namespace cairn::driver {
namespace {

namespace fs = std::filesystem;
using Words = List<std::string>;

constexpr const char* playground_file =
    "out/playground/index.html";  // where `lessons/run playground` puts it
constexpr int lesson_skipped = 77;
constexpr int cannot_make = 3;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A folder that is gone when this is.
struct WorkFolder {
  fs::path path = {};

  explicit WorkFolder(const fs::path& folder) : path(folder) {
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~WorkFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
};

/// Where things are while the book is made.
struct Workshop {
  fs::path book = {};
  fs::path work = {};  // where the lessons leave their files
  Words flags = {};    // for every lesson
};

/// A lesson could not be run as it was asked to.
struct LessonFailed : std::runtime_error {
  LessonFailed(const std::string& what, int exit_code) : std::runtime_error(what), code(exit_code) {}
  int code;
};

fs::path lesson_out(const Program& program, const Workshop& shop, const std::string& theme) {
  return shop.work / (program.name + "_" + theme);
}

ProcessResult run_in_theme(const Program& program, const Workshop& shop, const std::string& theme) {
  Words command = {program.path.string(), "--color", "never", "--progress", "never", "--size", "small"};
  command.insert(command.end(), shop.flags.begin(), shop.flags.end());
  command.insert(command.end(), {"--theme", theme, "--out", lesson_out(program, shop, theme).string()});
  const ProcessResult result = run_quietly(command);
  if (result.code > 1 && result.code != lesson_skipped)
    throw LessonFailed(program.name + " failed:\n" + result.output, result.code);
  return result;
}

/// Without what is not the lesson's but the book's: where its pictures went, and how large they were. The
/// state is put on a line of its own, so that the line is not wider than the page.
std::string console_text(const std::string& output, const fs::path& pictures) {
  const std::string written = ": " + pictures.string() + "/";
  std::istringstream lines(output);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    if (line.find(written) != std::string::npos) continue;
    const std::size_t out = line.rfind("Again: ", 0) == 0 ? line.find(" --out ") : std::string::npos;
    const std::size_t state = line.find("     state ");
    if (out != std::string::npos && state != std::string::npos) line.replace(out, state - out, "\n  ");
    text += line + "\n";
  }
  return text;
}

nlohmann::json read_json(const fs::path& file) {
  return nlohmann::json::parse(text_of(file), nullptr, false);
}

/// Moves one picture into the book and returns its name there.
std::string taken_in(const Workshop& shop, const BookLesson& lesson, const std::string& theme,
                     const std::string& file, int number) {
  const std::string name =
      fmt::format("lesson{}_{:04}_{}.png", two_digits(lesson.program.number), number, theme);
  fs::rename(lesson_out(lesson.program, shop, theme) / file, shop.book / "frames" / name);
  return name;
}

void take_frames(const Workshop& shop, BookLesson& lesson) {
  const fs::path out = lesson_out(lesson.program, shop, "light");
  const auto index = read_json(out / "frames.json");
  const auto record = read_json(out / "run.json");
  if (!index.is_object() || !record.is_object()) return;  // it draws nothing here
  lesson.frames_in_all = index.at("frames_of_the_sequence");
  lesson.width = record.at("width");
  lesson.height = record.at("height");
  for (const auto& item : index.at("frames")) {
    BookFrame frame = {.number = item.at("frame"), .state = item.at("state"), .alt = item.at("alt")};
    const std::string file = item.at("file");
    frame.light = taken_in(shop, lesson, "light", file, frame.number);
    frame.dark = taken_in(shop, lesson, "dark", file, frame.number);
    lesson.frames.push_back(frame);
  }
}

BookLesson book_lesson(const Workshop& shop, const Program& program, bool& all_held) {
  BookLesson lesson = {.program = program};
  const ProcessResult result = run_in_theme(program, shop, "light");
  run_in_theme(program, shop, "dark");
  all_held = all_held && result.code != 1;
  lesson.console = console_text(result.output, lesson_out(program, shop, "light"));
  const fs::path folder = lesson_folder(program);
  lesson.text = text_of(folder / "README.md");
  for (const char* name : {"exercise.hpp", "exercise.cpp"}) {
    if (fs::exists(folder / name)) lesson.exercise.push_back({name, text_of(folder / name)});
  }
  take_frames(shop, lesson);
  return lesson;
}

/// Pictures of an earlier book that this one does not show.
void remove_old_pictures(const fs::path& folder, const Book& book) {
  std::set<std::string> shown;
  for (const BookLesson& lesson : book) {
    for (const BookFrame& frame : lesson.frames) shown.insert({frame.light, frame.dark});
  }
  List<fs::path> old;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const bool is_ours = name.rfind("lesson", 0) == 0 && entry.path().extension() == ".png";
    if (is_ours && shown.count(name) == 0) old.push_back(entry.path());
  }
  for (const fs::path& file : old) fs::remove(file);
}

void write_pages(const fs::path& folder, const Book& book) {
  const fs::path source = fs::path(CAIRN_LESSONS_FOLDER) / "driver";
  for (int i = 0; i < book.size(); ++i) {
    write_whole_file(folder / page_name(book[i].program), lesson_page(book, i));
  }
  if (book.has_playground) write_whole_file(folder / "playground.html", text_of(playground_file));
  for (const char* name : {"book.css", "book.js"}) write_whole_file(folder / name, text_of(source / name));
  write_whole_file(folder / "index.html", index_page(book, text_of(source / "book.md")));
  remove_old_pictures(folder / "frames", book);
}

std::uintmax_t size_of(const fs::path& folder) {
  std::uintmax_t size = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) size += entry.file_size();
  }
  return size;
}

int make_book(const Context& context, const Workshop& shop) {
  Console console(context.settings);
  fs::create_directories(shop.book / "frames");
  Book book;
  book.has_playground = fs::exists(playground_file);
  bool all_held = true;
  {
    const WorkFolder folder(shop.work);
    const List<Program> programs = built(context.programs);
    Progress progress(context.settings, "lessons", programs.size());
    for (const Program& program : programs) {
      progress.advance(book.size());
      book.push_back(book_lesson(shop, program, all_held));
    }
  }
  write_pages(shop.book, book);
  int pictures = 0;
  for (const BookLesson& lesson : book) pictures += 2 * lesson.frames.size();
  console.result(fmt::format("{} lessons, {} pictures, {:.1f} MB: open {}", book.size(), pictures,
                             static_cast<double>(size_of(shop.book)) / 1e6,
                             (shop.book / "index.html").string()));
  if (!all_held) console.warn("lessons: a lesson's own check failed; its page shows which");
  return all_held ? 0 : 1;
}

}  // namespace

int book(const Context& context, const Words& words) {
  Console console(context.settings);
  for (const std::string& word : words) {
    if (word != "-h" && word != "--help") continue;
    console.result(
        "lessons book [FOLDER (out/book)] [flags of the lessons, such as --frames all --size medium]");
    return 0;
  }
  if (!can_make_books()) {
    console.warn(
        "lessons: this build cannot read Markdown; apt-get install libmd4c-dev libmd4c-html0-dev, then "
        "configure anew");
    return cannot_make;
  }
  const bool has_folder = !words.empty() && words.front().rfind("-", 0) != 0;
  Workshop shop = {.book = has_folder ? words.front() : "out/book"};
  shop.work = shop.book / "unfinished";
  shop.flags.assign(words.begin() + (has_folder ? 1 : 0), words.end());
  try {
    return make_book(context, shop);
  } catch (const LessonFailed& failure) {
    console.warn(std::string("lessons: ") + failure.what());
    return failure.code;
  }
}

}  // namespace cairn::driver
