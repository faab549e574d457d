// The reader's own solver: the models pass their graders, states that begin a stage fail it, and every wrong
// answer that is known fails with the words that name it.
#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "math/list.hpp"
#include "run_solver.hpp"

namespace {

namespace fs = std::filesystem;
using cairn::List;
using namespace cairn::solver_tests;

constexpr int solver_stages = 10;

/// One wrong answer: the model with one or more changes, and words that the grader has to say.
struct WrongAnswer {
  std::string name = {};
  List<std::pair<std::string, std::string>> changes = {};  // from, to
  std::string words = {};
};

List<WrongAnswer> wrong_answers(int stage) {
  std::ifstream in(solver_folder / "stages" / ("0" + std::to_string(stage) + ".wrong"));
  List<WrongAnswer> answers;
  char last = ' ';
  for (std::string line; std::getline(in, line);) {
    if (line.empty()) continue;
    const std::string text = line.substr(std::min<std::size_t>(2, line.size()));
    if (line[0] == '=') answers.push_back({.name = text});
    if (line[0] == '-' && last != '-')
      answers.back().changes.push_back({text, ""});
    else if (line[0] == '-')
      answers.back().changes.back().first += "\n" + text;
    if (line[0] == '+') answers.back().changes.back().second += text + "\n";
    if (line[0] == '>') answers.back().words = text;
    last = line[0];
  }
  return answers;
}

bool is_space(char c) { return c == ' ' || c == '\n'; }

/// Where `part` ends if the text has it at `begin`, with any white space for white space; else npos.
std::size_t end_of(const std::string& part, const std::string& text, std::size_t begin) {
  std::size_t at = begin;
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (is_space(part[i])) {
      if (at == text.size() || !is_space(text[at])) return std::string::npos;
      while (at < text.size() && is_space(text[at])) ++at;
      while (i + 1 < part.size() && is_space(part[i + 1])) ++i;
    } else if (at == text.size() || text[at++] != part[i]) {
      return std::string::npos;
    }
  }
  return at;
}

std::string changed(std::string text, const WrongAnswer& wrong) {
  for (const auto& [from, to] : wrong.changes) {
    const std::string shown = from;
    CAPTURE(shown);
    List<std::pair<std::size_t, std::size_t>> places;
    for (std::size_t begin = 0; begin < text.size(); ++begin) {
      const std::size_t end = end_of(from, text, begin);
      if (end != std::string::npos) places.push_back({begin, end});
    }
    REQUIRE(places.size() == 1);
    text.replace(places[0].first, places[0].second - places[0].first, to.substr(0, to.size() - 1));
  }
  return text;
}

/// One program of the model of a stage (number 0) and all its wrong answers, each in a namespace of its own:
/// its first argument chooses. The standard headers are read once.
fs::path program_of(int stage, const List<WrongAnswer>& answers) {
  const fs::path folder = solver_scratch("stage" + std::to_string(stage));
  const std::string model = model_of(stage);
  std::ostringstream text;
  for (const char* header : {"algorithm", "array", "cmath", "cstdlib", "limits", "vector"})
    text << "#include <" << header << ">\n";
  text << "#include \"report.hpp\"\n";
  const std::string function = "grade_0" + std::to_string(stage);
  const std::string grader = "stages/0" + std::to_string(stage) + ".cpp";
  std::string choice;
  for (int k = 0; k <= answers.size(); ++k) {
    const std::string name = "answer_" + std::to_string(k);
    const WrongAnswer wrong = k == 0 ? WrongAnswer{} : answers[k - 1];
    INFO(wrong.name);
    text << "namespace " << name << " {\nnamespace {\n"
         << changed(model, wrong) << "#include \"" << grader << "\"\n}\n}\n";
    choice += "  if (chosen == " + std::to_string(k) + ") " + name + "::" + function + "(report);\n";
  }
  text
      << "int main(int, char** words) {\n  const int chosen = std::atoi(words[1]);\n  grading::Report report("
      << stage << ");\n"
      << choice << "  return report.passed() ? 0 : 1;\n}\n";
  write_file(folder / "answers.cpp", text.str());
  const std::string compiler = std::string(CAIRN_LAUNCHER " ") + in_quotes(CAIRN_COMPILER);
  const Ended compiled =
      run_line("cd " + in_quotes(folder.string()) + " && " + compiler +
               " -std=c++20 -O0 -D_GLIBCXX_ASSERTIONS -I" + in_quotes(solver_folder.string()) +
               " -c answers.cpp && " + in_quotes(CAIRN_COMPILER) + " -o answers answers.o");
  REQUIRE_MESSAGE(compiled.code == 0, compiled.out.substr(0, 2000));
  return folder / "answers";
}

void check_answers(int stage) {
  const List<WrongAnswer> answers = wrong_answers(stage);
  CHECK(answers.size() >= 8);
  const std::string program = in_quotes(program_of(stage, answers).string());
  const Ended model = run_line(program + " 0");
  CHECK_MESSAGE(model.code == 0, model.out);
  CHECK(model.out.find("CHECK") != std::string::npos);
  for (int k = 1; k <= answers.size(); ++k) {
    INFO("stage ", stage, ": ", answers[k - 1].name);
    REQUIRE_FALSE(answers[k - 1].words.empty());
    const Ended wrong = run_line(program + " " + std::to_string(k));
    CHECK(wrong.code == 1);
    CHECK_MESSAGE(wrong.out.find(answers[k - 1].words) != std::string::npos, wrong.out);
  }
}

}  // namespace

TEST_CASE(
    "every model of the reader's solver passes, and every wrong answer fails with the words that name it") {
  for (int stage = 0; stage < solver_stages; ++stage) check_answers(stage);
}

TEST_CASE("what begins a stage passes the stage before, and not its own") {
  const fs::path folder = solver_scratch("begin");
  for (int stage = 0; stage < solver_stages; ++stage) {
    const std::string number = std::to_string(stage);
    INFO("stage ", stage);
    const Ended begun = run_solver(folder, number + " --begin");
    CHECK(begun.code == 0);
    CHECK((begun.out.find("kept as my_solver." + number + ".cpp") != std::string::npos) == (stage > 0));
    const Ended graded = run_solver(folder, number);
    CHECK(graded.code == 1);
    CHECK(graded.out.find("Not yet.") != std::string::npos);
    CHECK(text_of(folder / "my_solver.cpp").rfind(stage == 0 ? "// Stage 00" : model_of(stage - 1), 0) == 0);
  }
  const Ended where = run_solver(folder, "");
  CHECK(where.code == 0);
  CHECK(where.out.find("9 of 10 stages pass") != std::string::npos);
  CHECK(where.out.find("Stage 09") != std::string::npos);
}

TEST_CASE("the finished solver is short, and its tower carries the loads of lesson 17") {
  const fs::path folder = solver_scratch("finished");
  const std::string model = model_of(solver_stages - 1);
  const auto lines = std::count(model.begin(), model.end(), '\n');
  CHECK(lines >= 150);
  CHECK(lines <= 260);
  write_file(folder / "my_solver.cpp", model);
  const Ended graded = run_solver(folder, "9");
  CHECK(graded.code == 0);
  List<std::string> loads;
  std::istringstream out(graded.out);
  for (std::string line; std::getline(out, line);) {
    if (line.find("ten boxes: load") == std::string::npos) continue;
    std::istringstream numbers(line.substr(line.find(" (N) ") + 5));
    double load = 0;
    numbers >> load;
    loads.push_back(fmt::format("{:.2f}", load));
  }
  CHECK(loads == List<std::string>{"35.24", "64.98", "94.17", "133.51", "96.16"});
}

TEST_CASE("a file that does not compile, lacks a function or runs wild is answered shortly") {
  const fs::path folder = solver_scratch("broken");
  const auto answer = [&folder](const std::string& text) {
    write_file(folder / "my_solver.cpp", text);
    return run_solver(folder, "0");
  };
  const std::string model = model_of(0);
  const Ended unfinished = answer(model + "\nint three() { return 3 }\n");
  CHECK(unfinished.code == 1);
  CHECK(unfinished.out.find("does not compile. Line 42: ") != std::string::npos);
  CHECK(unfinished.out.find("\n  int three() { return 3 }\n") != std::string::npos);
  const Ended lacking = answer(model.substr(0, model.find("// The second half")));
  CHECK(lacking.code == 1);
  CHECK(lacking.out.find("Stage 00 cannot use my_solver.cpp: ") != std::string::npos);
  CHECK(lacking.out.find("    void move_bodies(") != std::string::npos);
  WrongAnswer wild{.changes = {{"Body box;", "Body box; std::vector<int> none; none[3] = 1;\n"}}};
  const Ended stopped = answer(changed(model, wild));
  CHECK(stopped.code == 1);
  CHECK(stopped.out.find("an index outside of a list") != std::string::npos);
}

TEST_CASE("the reader's solver refuses words that it does not know, and a stage without a file") {
  const fs::path folder = solver_scratch("refused");
  for (const auto& [words, complaint] :
       {std::pair("12", "must be a number from 0 to 9, got \"12\""), std::pair("x", "got \"x\""),
        std::pair("3 --start", "got \"--start\""), std::pair("3", "there is no my_solver.cpp in")}) {
    const std::string shown = words;
    INFO(shown);
    const Ended refused = run_solver(folder, words);
    CHECK(refused.code == 2);
    CHECK(refused.out.find(complaint) != std::string::npos);
  }
  CHECK(fs::is_empty(folder));
}
