// Each lesson, run once for each theme.
#include "lessons/driver/book_making.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "lessons/driver/exercises.hpp"
#include "lessons/driver/interruption.hpp"
#include "lessons/driver/process.hpp"

namespace cairn::driver {
namespace {

namespace fs = std::filesystem;
using Words = List<std::string>;

constexpr int lesson_skipped = 77;

fs::path lesson_out(const Program& program, const Workshop& shop, const std::string& theme) {
  return shop.work / (program.name + "_" + theme);
}

ProcessResult run_in_theme(const Program& program, const Workshop& shop, const std::string& theme) {
  Words command = {program.path.string(), "--color", "never", "--progress", "never", "--size", "large"};
  command.insert(command.end(), shop.flags.begin(), shop.flags.end());
  command.insert(command.end(), {"--theme", theme, "--out", lesson_out(program, shop, theme).string()});
  const ProcessResult result = run_quietly(command);
  require_uninterrupted();
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
  if (fs::exists(folder / "exercise.cpp"))
    lesson.exercise.push_back({"exercise.cpp", text_of(folder / "exercise.cpp")});
  lesson.teaching = text_of(folder / "teaching.md");
  lesson.has_stage =
      fs::exists(folder.parent_path() / "your_solver/stages" / (two_digits(program.number) + ".txt"));
  take_frames(shop, lesson);
  return lesson;
}

}  // namespace

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Book gathered(const Context& context, const Workshop& shop, bool& all_held) {
  fs::create_directories(shop.book / "frames");
  Book book;
  book.has_playground = fs::exists(playground_file);
  const List<Program> programs = built(context.programs);
  Progress progress(context.settings, "lessons", programs.size());
  for (const Program& program : programs) {
    progress.advance(book.size());
    book.push_back(book_lesson(shop, program, all_held));
  }
  return book;
}

}  // namespace cairn::driver
