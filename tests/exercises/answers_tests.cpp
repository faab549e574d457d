// What readers may write, right and wrong, in the exercises and in the stages of their own solver: every
// model passes, every wrong answer fails with the words that name it, and so does an exercise as it comes.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <utility>

#include "lessons/kit/exercise.hpp"
#include <cairn/math/list.hpp>
#include "your_solver/run_solver.hpp"

namespace {

namespace fs = std::filesystem;
using cairn::List;
using namespace cairn::solver_tests;

constexpr int fewest_wrong_answers = 8, solver_stages = 10;

/// A wrong answer: what is changed in the model, from and to, and words that the grader has to say. What
/// replaces nothing is the whole answer.
struct WrongAnswer {
  std::string name = {};
  List<std::string> words = {};
  List<std::pair<std::string, std::string>> changes = {};
};

/// From "= what it does > words > more words" and the lines "- from" and "+ to" below it.
List<WrongAnswer> wrong_answers(const fs::path& file) {
  std::ifstream in(file);
  List<WrongAnswer> answers;
  char last = ' ';
  for (std::string line; std::getline(in, line); last = line.empty() ? ' ' : line[0]) {
    if (line.empty()) continue;
    const std::string text = line.size() > 2 ? line.substr(2) : "";
    if (line[0] == '=') {
      const std::regex words(" > ");
      const std::sregex_token_iterator end;
      const List<std::string> parts(std::sregex_token_iterator(text.begin(), text.end(), words, -1), end);
      answers.push_back({.name = parts[0], .words = {parts.begin() + 1, parts.end()}});
      REQUIRE_MESSAGE(parts.size() > 1, line);
      continue;
    }
    REQUIRE_MESSAGE(((line[0] == '-' || line[0] == '+') && !answers.empty()), line);
    auto& changes = answers.back().changes;
    if ((line[0] == '-' && last != '-') || changes.empty()) changes.push_back({"", ""});
    std::string& side = line[0] == '-' ? changes.back().first : changes.back().second;
    side += (side.empty() ? "" : "\n") + text;
  }
  return answers;
}

/// The model with the changes. Its comments do not count; any white space stands for any other.
std::string changed(const std::string& model, const WrongAnswer& wrong) {
  std::string text = std::regex_replace(model, std::regex("//[^\n]*"), "");
  for (const auto& [from, to] : wrong.changes) {
    if (from.empty()) return to;
    const std::string shown = from;
    CAPTURE(shown);
    const std::string quoted = std::regex_replace(from, std::regex("[^\\w\\s]"), "\\$&");
    const std::regex pattern(std::regex_replace(quoted, std::regex("\\s+"), "\\s+"));
    REQUIRE(std::distance(std::sregex_iterator(text.begin(), text.end(), pattern), {}) == 1);
    std::smatch place;
    std::regex_search(text, place, pattern);
    text = place.prefix().str() + to + place.suffix().str();
  }
  return text;
}

/// Compiles main.cpp of this folder, whose first argument chooses an answer: 0 is the model, and what follows
/// the wrong ones is as wrong.
void check_program(const fs::path& folder, const List<WrongAnswer>& answers, int count) {
  const std::string compiled_by = "cd " + in_quotes(folder.string()) + " && " CAIRN_LAUNCHER " ";
  const Ended compiled =
      run_line(compiled_by + in_quotes(CAIRN_COMPILER) +
               " " CAIRN_ANSWER_FLAGS " -I" CAIRN_SOURCE_DIR " -I" CAIRN_INCLUDE " -c main.cpp && " +
               in_quotes(CAIRN_COMPILER) + " " CAIRN_ANSWER_FLAGS " -o answers main.o " CAIRN_FMT);
  REQUIRE_MESSAGE(compiled.code == 0, compiled.out.substr(0, 2000));
  CHECK(answers.size() >= fewest_wrong_answers);
  for (int k = 0; k < count; ++k) {
    const WrongAnswer wrong = 0 < k && k <= answers.size() ? answers[k - 1] : WrongAnswer{};
    const Ended graded = run_line(in_quotes((folder / "answers").string()) + " " + std::to_string(k));
    INFO(folder.string(), ", ", k, ": ", wrong.name, "\n", graded.out);
    CHECK(graded.code == (k == 0 ? 0 : 1));
    CHECK(graded.out.find("CHECK") != std::string::npos);
    const std::string comments = std::regex_replace(graded.out, std::regex("CHECK[^\n]*\n"), "");
    for (const std::string& words : wrong.words) CHECK(comments.find(words) != std::string::npos);
  }
}

/// All answers of an exercise fill its one gap, and a number says which of them runs.
void check_exercise(const fs::path& source) {
  const std::string number = source.filename().string().substr(0, 2);
  const fs::path folder = scratch_folder("exercise" + number);
  const cairn::GapText exercise = cairn::split_at_gap(text_of(source / "exercise.cpp"));
  const std::string model = text_of(source / "model.txt");
  const List<WrongAnswer> answers = wrong_answers(source / "exercise.wrong");
  List<std::string> texts = {model};
  for (const WrongAnswer& wrong : answers) {
    INFO(source.string(), ": ", wrong.name);
    texts.push_back(changed(model, wrong));
  }
  texts.push_back(exercise.gap);
  std::string gap = "  ";
  for (int k = 0; k < texts.size(); ++k)
    gap += "if (chosen_answer == " + std::to_string(k) + ") {\n" + texts[k] + "\n} else ";
  write_file(folder / "exercise.cpp", exercise.before + gap + "{}\n" + exercise.behind);
  fs::copy(source / "grade.cpp", folder);
  write_file(folder / "main.cpp",
             "#include <cstdlib>\nstatic int chosen_answer = 0;\n#include \"grade.cpp\"\n"
             "int main(int, char** words) {\n  chosen_answer = std::atoi(words[1]);\n  cairn::Grade grade;\n"
             "  cairn::exercise" +
                 number +
                 "::exercise().grade(grade);\n"
                 "  return grade.passed() ? 0 : 1;\n}\n");
  check_program(folder, answers, texts.size());
}

/// The model of a stage and its wrong answers, each in a namespace of its own. The standard headers are read
/// once.
void check_stage(int stage) {
  const std::string number = "0" + std::to_string(stage), model = model_of(stage);
  const fs::path folder = scratch_folder("stage" + number);
  const List<WrongAnswer> answers = wrong_answers(solver_folder / "stages" / (number + ".wrong"));
  std::string text =
      "#include <array>\n#include <cstdlib>\n#include <limits>\n#include \"lessons/kit/grading.hpp\"\n";
  std::string choice;
  for (int k = 0; k <= answers.size(); ++k) {
    const WrongAnswer wrong = k == 0 ? WrongAnswer{} : answers[k - 1];
    INFO("stage ", number, ": ", wrong.name);
    const std::string name = "answer_" + std::to_string(k);
    text += "namespace " + name + " {\nnamespace {\n" + changed(model, wrong) +
            "#include \"lessons/your_solver/stages/" + number + ".cpp\"\n}\n}\n";
    choice += "  if (chosen == " + std::to_string(k) + ") " + name + "::grade_" + number + "(grade);\n";
  }
  write_file(folder / "main.cpp",
             text +
                 "int main(int, char** words) {\n  const int chosen = std::atoi(words[1]);\n"
                 "  cairn::Grade grade({.only_first = true});\n" +
                 choice + "  return grade.passed() ? 0 : 1;\n}\n");
  check_program(folder, answers, answers.size() + 1);
}

}  // namespace

TEST_CASE("an exercise fails as it comes, its model passes, and every wrong answer is named") {
  int exercises = 0;
  for (const char* const lessons : {CAIRN_SOURCE_DIR "/lessons", CAIRN_MADE_FOLDER "/lessons"}) {
    for (const fs::directory_entry& folder : fs::directory_iterator(lessons)) {
      if (!fs::exists(folder.path() / "grade.cpp")) continue;
      check_exercise(folder.path());
      ++exercises;
    }
  }
  CHECK(exercises > 20);
}

TEST_CASE("every model of the reader's solver passes, and every wrong answer is named") {
  for (int stage = 0; stage < solver_stages; ++stage) check_stage(stage);
}

TEST_CASE("the gap lies between its two lines, and both must be there once") {
  using cairn::split_at_gap;
  const std::string before = "a\n  // Your code begins here: two lines.\n",
                    behind = "  // Your code ends here.\nc\n";
  const cairn::GapText text = split_at_gap(before + "b\n" + behind);
  CHECK(text.before == before);
  CHECK(text.gap == "b\n");
  CHECK(text.behind == behind);
  CHECK_THROWS_WITH_AS(split_at_gap("a\n" + behind),
                       "\"// Your code begins here\" must stand in exactly one line", std::runtime_error);
  CHECK_THROWS_WITH_AS(split_at_gap(before + behind + behind),
                       "\"// Your code ends here\" must stand in exactly one line", std::runtime_error);
  CHECK_THROWS_WITH_AS(split_at_gap(behind + before),
                       "\"// Your code begins here\" must stand before \"// Your code ends here\"",
                       std::runtime_error);
}
