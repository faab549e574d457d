// The driver: finds the lessons beside it and runs, lists and checks them.
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <map>
#include <system_error>

#include "lessons/driver/commands.hpp"
#include "lessons/driver/process.hpp"
#include "lessons/kit/fitting.hpp"
#include "lessons/kit/output.hpp"
#include "lessons/kit/words.hpp"
#include <cairn/math/list.hpp>
#include <cairn/math/printable.hpp>

namespace {

using namespace cairn;
using namespace cairn::driver;
using Words = List<std::string>;

constexpr const char* help_text = R"(lessons - how constraint solvers work, one program per idea

  bash lessons/run             every lesson: one line each, pictures in out/
  bash lessons/run next        the first lesson that you have not passed
  bash lessons/run 3           lesson 3: it asks, then shows; flags follow: 3 --bodies 10
  bash lessons/run 3 --help    the flags of lesson 3
  bash lessons/run check 3     its checks and your exercise; a pass is noted in lessons-progress.txt
  bash lessons/run solver 5    grades stage 5 of your solver; 5 --begin writes its start, 5 --film draws it
  bash lessons/run check --all the checks of every lesson, without the exercises
  bash lessons/run book        every lesson as a page for the browser, in out/book/
  bash lessons/run export 3    its pictures for documents, with alt texts; export --help has the flags
  bash lessons/run new NAME    a folder for a lesson of your own, that already works: lessons/WRITING.md
  bash lessons/run playground  the core in a browser: one page, in out/playground/; installs emscripten
  bash lessons/run release     playground and book, tested, as they are published: out/release/
  bash lessons/run cairn       the program for scenes of your own: cairn run FILE.toml

  run [N] [flags]   list   next   check N|--all   hint N [1-3]   solution N   progress
  book [DIR]        text, code, output and pictures of all lessons; flags follow: --frames key
  handouts [FILE]   a PDF of all lessons for print, out/handouts.pdf, and one of each; needs chromium
  legend            what colours, dashes and markers mean
  coverage          what of the paper is met, shown or mentioned in which lesson
  doctor            whether pictures can be drawn here
  --plain           ASCII     --color auto|always|never     -h, --help     --version
Exit: 0 all well, 1 a lesson failed, 2 bad usage, 130 interrupted; one lesson alone: as it says.
)";

/// The folder of this program.
std::filesystem::path own_folder(const char* name) {
  std::error_code error;
  const auto path = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::filesystem::absolute(name).parent_path() : path.parent_path();
}

int complain(const Context& context, const std::string& message) {
  fmt::print(stderr, "lessons: {}\n{}", excerpt(message, longest_message), short_list(context));
  return 2;
}

/// Takes the flags that concern the driver from the front.
void take_console_flags(Words& words, ConsoleSettings& settings) {
  const std::map<std::string, When> whens = {
      {"auto", When::automatic}, {"always", When::always}, {"never", When::never}};
  while (!words.empty()) {
    const std::string word = words.front();
    const std::string when = word.rfind("--color=", 0) == 0          ? word.substr(8)
                             : word == "--color" && words.size() > 1 ? words[1]
                                                                     : "";
    const auto found = whens.find(when);
    if (word == "--plain") {
      settings.plain = true;
    } else if (found != whens.end()) {
      settings.color = found->second;
      if (word == "--color") words.erase(words.begin());
    } else {
      return;
    }
    words.erase(words.begin());
  }
}

int run_one(const Context& context, const Program& program, const Words& flags) {
  Words command = {program.path.string()};
  command.insert(command.end(), flags.begin(), flags.end());
  if (context.settings.plain) command.push_back("--plain");
  require_built(program);
  return become(command);
}

/// For words that need a lesson behind them.
int with_lesson(const Context& context, const std::string& word, const Words& rest,
                const std::function<int(const Program&, const Words&)>& action) {
  if (rest.empty()) return complain(context, word + " needs the number of a lesson");
  const Program* program = find(context.programs, rest.front());
  if (program == nullptr) return complain(context, "there is no lesson " + rest.front() + "; there are");
  return action(*program, {rest.begin() + 1, rest.end()});
}

int check(const Context& context, const Words& rest) {
  if (!rest.empty() && rest.front() == "--all") return check_all(context, {rest.begin() + 1, rest.end()});
  return with_lesson(context, "check", rest, [&context](const Program& program, const Words& flags) {
    return check_one(context, program, flags);
  });
}

int give_hint(const Context& context, const Words& rest) {
  return with_lesson(context, "hint", rest, [&context](const Program& program, const Words& number) {
    return hint(context, program, number);
  });
}

int give_solution(const Context& context, const Words& rest) {
  return with_lesson(context, "solution", rest,
                     [&context](const Program& program, const Words&) { return solution(context, program); });
}

int run(const Context& context, const Words& rest) {
  if (rest.empty() || rest.front().rfind("-", 0) == 0) return run_all(context, rest);
  return with_lesson(context, "run", rest, [&context](const Program& program, const Words& flags) {
    return run_one(context, program, flags);
  });
}

int act(const Context& context, const std::string& word, const Words& rest) {
  const std::map<std::string, std::function<int()>> actions = {
      {"run", [&] { return run(context, rest); }},
      {"list", [&] { return list(context); }},
      {"next", [&] { return next(context, rest); }},
      {"check", [&] { return check(context, rest); }},
      {"hint", [&] { return give_hint(context, rest); }},
      {"solution", [&] { return give_solution(context, rest); }},
      {"progress", [&] { return progress(context); }},
      {"doctor", [&] { return doctor(context); }},
      {"legend", [&] { return legend(context); }},
      {"coverage", [&] { return coverage(context); }},
      {"book", [&] { return book(context, rest); }},
      {"export", [&] { return export_pictures(context, rest); }},
      {"handouts", [&] { return handouts(context, rest); }}};
  const auto action = actions.find(word);
  if (action != actions.end()) return action->second();
  if (find(context.programs, word) != nullptr)
    return run(context, [&] {
      Words words = {word};
      words.insert(words.end(), rest.begin(), rest.end());
      return words;
    }());
  Words known;
  for (const auto& [name, ignored] : actions) known.push_back(name);
  const std::string meant = nearest(word, known);
  const bool is_number = word.find_first_not_of("0123456789") == std::string::npos;
  if (is_number) return complain(context, "there is no lesson " + word + "; there are");
  return complain(context, "unknown word " + word +
                               (meant.empty() ? "; lessons --help lists them. Lessons:"
                                              : "; did you mean " + meant + "? Lessons:"));
}

int drive(int argc, char** argv) {
  Words words(argv + std::min(argc, 1), argv + argc);
  Context context = {.programs = programs_in(own_folder(argc > 0 ? argv[0] : "lessons"))};
  take_console_flags(words, context.settings);
  const std::string word = words.empty() ? "run" : words.front();
  if (word == "-h" || word == "--help" || word == "help") {
    fmt::print("{}", fitted(help_text, width_of_stream(stdout)));
    return 0;
  }
  if (word == "--version") {
    fmt::print("lessons {}\n", CAIRN_VERSION);
    return 0;
  }
  if (word.rfind("-", 0) == 0) return run_all(context, words);
  return act(context, word, words.empty() ? Words{} : Words{words.begin() + 1, words.end()});
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int code = drive(argc, argv);
    if (output_is_written()) return code;
    fmt::print(stderr, "lessons: the output cannot be written\n");
    return 3;
  } catch (const std::exception& error) {
    fmt::print(stderr, "lessons: {}\n", excerpt(error.what(), longest_message));
    return 3;
  }
}
