// Runs, checks and lists lessons.
#include "lessons/driver/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lessons/driver/exercises.hpp"
#include "lessons/driver/process.hpp"
#include "lessons/kit/words.hpp"

namespace cairn::driver {
namespace {

namespace fs = std::filesystem;
using Color = Console::Color;

constexpr int list_width = 100;

List<std::string> command(const Program& program, const List<std::string>& words,
                          const List<std::string>& flags) {
  List<std::string> command = {program.path.string()};
  command.insert(command.end(), words.begin(), words.end());
  command.insert(command.end(), flags.begin(), flags.end());
  return command;
}

List<std::string> lines_of(const std::string& text) {
  List<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

/// What one lesson of many came to.
struct Outcome {
  int code = 0;
  int checks = 0;
  int held = 0;
  int pictures = 0;
  double seconds = 0;
  List<std::string> complaints = {};
};

void read_checks(const std::string& output, Outcome& outcome) {
  for (const std::string& line : lines_of(output)) {
    const bool is_check = line.rfind("CHECK", 0) == 0;
    const bool holds = is_check && line.size() > 3 && line.compare(line.size() - 3, 3, " ok") == 0;
    outcome.checks += is_check ? 1 : 0;
    outcome.held += holds ? 1 : 0;
    if (!holds) outcome.complaints.push_back(line);
  }
}

Outcome run_one_of_many(const Program& program, const List<std::string>& flags) {
  const fs::path out = fs::path("out") / program.name.substr(0, 8);
  const auto start = std::chrono::steady_clock::now();
  const ProcessResult result = run_quietly(
      command(program, {"-q", "--color", "never", "--progress", "never", "-o", out.string()}, flags));
  Outcome outcome = {.code = result.code};
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  read_checks(result.output, outcome);
  std::ifstream stream(out / "run.json");
  const auto record = nlohmann::json::parse(stream, nullptr, false);
  if (result.code <= 1 && record.is_object()) outcome.pictures = record.value("pictures", 0);
  return outcome;
}

std::string outcome_text(const Outcome& outcome, const Console& console) {
  if (outcome.code == skipped) return console.colored("skipped", Color::faint);
  const std::string checks = fmt::format("{:>2} of {:>2} checks", outcome.held, outcome.checks);
  const std::string verdict = outcome.code == 0
                                  ? console.colored("ok", Color::good)
                                  : console.colored(fmt::format("FAILED ({})", outcome.code), Color::bad);
  return fmt::format("{}  {:>3} pictures  {:>5.1f} s  {}", checks, outcome.pictures, outcome.seconds,
                     verdict);
}

}  // namespace

std::string short_list(const Context& context) {
  std::string text;
  for (const Program& program : context.programs) {
    text += fmt::format("  {}  {}\n", two_digits(program.number), program.card.title);
  }
  return text;
}

int run_all(const Context& context, const List<std::string>& flags) {
  Console console(context.settings);
  const List<Program> programs = built(context.programs);
  if (programs.empty()) {
    console.warn("lessons: no lesson is built beside this program; bash lessons/run builds them");
    return not_built;
  }
  Progress progress(context.settings, "lessons", programs.size());
  int failed = 0;
  int pictures = 0;
  for (int i = 0; i < programs.size(); ++i) {
    const Program& program = programs[i];
    progress.advance(i);
    const Outcome outcome = run_one_of_many(program, flags);
    progress.clear();
    console.result(fmt::format("{}  {} {}", two_digits(program.number),
                               padded(console.spelt(program.card.title), 31),
                               outcome_text(outcome, console)));
    console.flush();
    if (outcome.code != 0) {
      for (const std::string& line : outcome.complaints) console.result("      " + line);
    }
    if (outcome.code == bad_usage) return bad_usage;  // the others would say the same
    failed += outcome.code != 0 && outcome.code != skipped ? 1 : 0;
    pictures += outcome.pictures;
  }
  if (pictures > 0) {
    console.narrate(fmt::format("{} picture{}: out/{}/index.html to out/{}/index.html", pictures,
                                pictures == 1 ? "" : "s", programs.front().name.substr(0, 8),
                                programs.back().name.substr(0, 8)));
  }
  console.narrate(
      "One lesson with its text: bash lessons/run 3     what there is: bash lessons/run list     more: "
      "--help");
  if (failed > 0) console.result(fmt::format("{} of {} lessons failed", failed, programs.size()));
  return failed > 0 ? 1 : 0;
}

int list(const Context& context) {
  Console console(context.settings);
  const ProgressNotes notes = read_progress(context.progress_file);
  const int width = std::min(list_width, console.width());
  for (const Program& program : context.programs) {
    const auto note = notes.find(program.number);
    const std::string done =
        note == notes.end() ? "" : console.colored("   done " + note->second, Color::good);
    const std::string title = two_digits(program.number) + "  " + console.spelt(program.card.title);
    console.result(console.colored(title, Color::bold) + done);
    console.result("    " + wrapped(console.spelt(program.card.idea), width - 4, 4));
  }
  return 0;
}

int next(const Context& context, const List<std::string>& flags) {
  Console console(context.settings);
  const ProgressNotes notes = read_progress(context.progress_file);
  for (const Program& program : context.programs) {
    if (notes.count(program.number) > 0) continue;
    console.narrate(
        fmt::format("Next is lesson {0}; when it is done: bash lessons/run check {0}", program.number));
    require_built(program);
    return become(command(program, {}, flags));
  }
  console.result(
      "Every lesson is done. bash lessons/run list shows them, bash lessons/run 3 runs one again.");
  return 0;
}

int check_one(const Context& context, const Program& program, const List<std::string>& flags) {
  Console console(context.settings);
  require_built(program);
  const std::optional<ExerciseFiles> exercise = exercise_of(program);
  int code = 0;
  if (exercise) {  // what the reader waits for is the grade: the lesson's own checks are told where one fails
    const ProcessResult own = run_quietly(command(program, {"--check"}, flags));
    code = own.code == 0 ? grade_exercise(program, *exercise) : own.code;
    if (own.code != 0) console.result(own.output);
  } else {
    code = run_aloud(command(program, {"--check"}, flags));
  }
  if (code == 0 && !note_pass(context.progress_file, program.number)) {
    console.warn("lessons: cannot write " + context.progress_file.string() + "; your progress is not kept");
  }
  return code;
}

int hint(const Context& context, const Program& program, const List<std::string>& number) {
  if (const std::optional<ExerciseFiles> exercise = exercise_of(program))
    return show_exercise_hint(program, *exercise, number);
  List<std::string> words = {program.path.string(), "--hint"};
  words.insert(words.end(), number.begin(), number.end());
  if (context.settings.plain) words.push_back("--plain");
  require_built(program);
  return become(words);
}

int solution(const Context& context, const Program& program) {
  const std::optional<ExerciseFiles> exercise = exercise_of(program);
  Console console(context.settings);
  if (!exercise) {
    console.warn(fmt::format("lessons: lesson {} has no exercise", program.number));
    return bad_usage;
  }
  if (read_progress(context.progress_file).count(program.number) == 0) {
    console.warn(fmt::format("lessons: the answer is shown when yours has passed: bash lessons/run check {}",
                             program.number));
    return 1;
  }
  return show_solution(program, *exercise);
}

int check_all(const Context& context, const List<std::string>& flags) {
  const List<Program> programs = built(context.programs);
  int failed = 0;
  for (const Program& program : programs) {
    const int code = run_aloud(command(program, {"--check"}, flags));
    failed += code != 0 && code != skipped ? 1 : 0;
  }
  Console console(context.settings);
  if (failed > 0) console.result(fmt::format("{} of {} lessons failed", failed, programs.size()));
  return failed > 0 ? 1 : 0;
}

int progress(const Context& context) {
  Console console(context.settings);
  const ProgressNotes notes = read_progress(context.progress_file);
  int done = 0;
  for (const Program& program : context.programs) {
    const auto note = notes.find(program.number);
    done += note != notes.end() ? 1 : 0;
    console.result(fmt::format("{}  {} {}", two_digits(program.number),
                               padded(console.spelt(program.card.title), 32),
                               note == notes.end() ? "-" : "passed " + note->second));
  }
  console.result(fmt::format("{} of {} lessons passed", done, context.programs.size()));
  return 0;
}

}  // namespace cairn::driver
