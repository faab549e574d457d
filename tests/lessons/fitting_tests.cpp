// Text that fits a window, and what a reader at a terminal is asked.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "child_lesson.hpp"
#include "lessons/kit/fitting.hpp"
#include "lessons/kit/words.hpp"
#include <cairn/math/list.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

int widest_line(const std::string& text) {
  std::istringstream lines(text);
  int widest = 0;
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, display_width(line));
  return widest;
}

/// The end columns of the words of a line.
List<int> word_ends(const std::string& line) {
  List<int> ends;
  for (int i = 0; i < static_cast<int>(line.size()); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (line[at] != ' ' && (at + 1 == line.size() || line[at + 1] == ' ')) ends.push_back(i);
  }
  return ends;
}

List<std::string> lines_in(const std::string& text) {
  std::istringstream stream(text);
  List<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// With COLUMNS set for what is run meanwhile.
struct Window {
  explicit Window(const char* columns) { setenv("COLUMNS", columns, 1); }
  ~Window() { unsetenv("COLUMNS"); }
};

}  // namespace

TEST_CASE("text that fits stays as it is, and prose is wrapped below its first word") {
  CHECK(fitted("a   b\nc   d\n", 80) == "a   b\nc   d\n");
  CHECK(fitted("Scene: one two three\n", 14) == "Scene: one two\n       three\n");
  CHECK(fitted("  one two three four\n", 14) == "  one two\n  three four\n");
}

TEST_CASE("a table becomes narrower between its columns before it is cut into two") {
  const std::string table = "row      value      end\n  1      10.00     5.00\n  2     −20.00     2.50\n";
  CHECK(fitted(table, 18) == "row   value   end\n  1   10.00  5.00\n  2  −20.00  2.50\n");
  CHECK(fitted(table, 12) == "row   value\n  1   10.00\n  2  −20.00\nrow   end\n  1  5.00\n  2  2.50\n");
}

TEST_CASE("a last column of prose is wrapped within its column") {
  CHECK(fitted("--a      the first of all flags here\n--long   two\n", 32) ==
        "--a     the first of all flags\n        here\n--long  two\n");
}

TEST_CASE("heads and numbers end in the same columns when Greek letters are spelt out") {
  const std::string table = "  λ_corr    λ_old\n    1.50   −20.00\n";
  const List<std::string> lines = lines_in(fitted(table, unlimited, true));
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].find("lambda_corr") != std::string::npos);
  CHECK(word_ends(lines[0]) == word_ends(lines[1]));
}

TEST_CASE("one blank behind numbers parts columns, so that heads go where their numbers go") {
  const std::string table =
      "name   ms a step row updates  cost\n"
      "first      0.435        6400     1\n"
      "next       0.854         640    12\n";
  CHECK(fitted(table, 24) ==
        "name   ms a step\nfirst      0.435\nnext       0.854\n"
        "name  row updates  cost\nfirst        6400     1\nnext          640    12\n");
}

TEST_CASE("units go below their heads before a table is cut into two") {
  const std::string table =
      "row  speed (m/s)  force (N)\n  1       1.2500      12.00\n  2       0.5000      13.00\n";
  CHECK(fitted(table, 20) == "row  speed force\n     (m/s)   (N)\n  1 1.2500 12.00\n  2 0.5000 13.00\n");
}

TEST_CASE("a title between the rows of a table does not end it") {
  const std::string table =
      "  run        work   error\n  the first title of all\n  short      1.00    2.00\n  longer    10.00   "
      "20.00\n";
  CHECK(fitted(table, 22) ==
        "  run      work  error\n  the first title of\n  all\n  short    1.00   2.00\n  longer  10.00  "
        "20.00\n");
}

TEST_CASE("the table of lesson 3 stays whole in a window of 80 columns, also in ASCII") {
  const Window window("80");
  for (const char* flag : {"--color=never", "--plain"}) {
    const std::string text = run_program("lesson03_sequential_impulses", {"--frames", "none", flag}).out;
    int heads = 0;
    for (const std::string& line : lines_in(text)) heads += line.rfind("sweep row", 0) == 0 ? 1 : 0;
    CHECK(heads == 1);
  }
}

TEST_CASE("every line of every lesson, of its help and of the lists fits a window of 80 and of 60 columns") {
  for (const char* columns : {"80", "60"}) {
    const Window window(columns);
    const int width = std::stoi(columns);
    int lessons = 0;
    for (const auto& entry : std::filesystem::directory_iterator(CAIRN_BIN_DIR)) {
      const std::string name = entry.path().filename().string();
      if (name.rfind("lesson", 0) != 0 || name == "lessons") continue;
      ++lessons;
      CAPTURE(name);
      CHECK(widest_line(run_program(name, {"--frames", "none", "--checks"}).out) <= width);
      CHECK(widest_line(run_program(name, {"--help"}).out) <= width);
    }
    CHECK(lessons >= 20);
    for (const char* word : {"list", "--help", "legend", "coverage", "progress", "export --help"}) {
      CAPTURE(word);
      std::istringstream stream(word);
      List<std::string> words;
      for (std::string each; stream >> each;) words.push_back(each);
      CHECK(widest_line(run_program("lessons", words).out) <= width);
    }
  }
}

TEST_CASE("the command that runs a lesson again is one command, also where it takes several lines") {
  const std::string command = "bash lessons/run 3 --bodies 3 --dt 0.02 --gravity 10 --sweeps 10 --order up";
  std::string folded = folded_command("Again: " + command, 40);
  CHECK(widest_line(folded) <= 40);
  for (std::size_t at = folded.find(" \\\n"); at != std::string::npos; at = folded.find(" \\\n"))
    folded.replace(at, 10, " ");  // the break and seven blanks
  CHECK(folded == "Again: " + command);
}

TEST_CASE("checks are one line unless they are asked for, and those that fail are always whole") {
  const auto lesson = [](Lesson& run) {
    run.check_that("first", true, "yes");
    run.check_small("second", 0.5, run.real("dt"));
  };
  const std::string failed = run_in_child(lesson, {}).out;
  CHECK(failed.find("CHECK  first") == std::string::npos);
  CHECK(failed.find("CHECK  second ...") != std::string::npos);
  CHECK(failed.find("must be at most 0.02, is 0.5\n") != std::string::npos);
  CHECK(failed.find("1 of 2 checks held") != std::string::npos);
  for (const char* flag : {"--checks", "-q", "-v", "--check"})
    CHECK(run_in_child(lesson, {flag}).out.find("CHECK  first ...") != std::string::npos);
}

TEST_CASE("a lesson waits for a guess on a terminal alone") {
  const auto lesson = [](Lesson& run) {
    run.predict();
    run.answer({42}, 0, "By counting.");
  };
  CHECK(run_in_child(lesson, {}).out.find("Your guess") == std::string::npos);
  CHECK(run_in_child(lesson, {"--predict"}).out.find("Your guess") != std::string::npos);
  // script(1) gives a program a terminal; what is typed is its own input.
  const std::string program = CAIRN_BIN_DIR "/lesson03_sequential_impulses --frames none";
  if (std::system("command -v script >/dev/null 2>&1") != 0) return;
  const ScratchFolder folder;
  const std::string file = folder.path() + "/typed";
  const std::string command = "printf '0.15\\n' | script -qec '" + program + "' /dev/null >" + file;
  REQUIRE(std::system(command.c_str()) == 0);
  const std::string typed = folder.text("typed");
  CHECK(typed.find("Your guess") != std::string::npos);
  CHECK(typed.find("RIGHT    0.1500") != std::string::npos);
}

TEST_CASE("a run ends with a page that shows each of its frames with its words") {
  const ScratchFolder folder;
  const std::string out = folder.path() + "/pictures";
  const auto lesson = [](Lesson& run) {
    run.film({word_shot("one"), word_shot("two"), word_shot("<three>")});
  };
  const Ran ran = run_in_child(lesson, {"-o", out});
  CHECK(ran.out.find("3 pictures: " + out + "/index.html\n") != std::string::npos);
  const std::string page = folder.text("pictures/index.html");
  for (const char* part :
       {"id=\"frame-3\"", "src=\"l42_0002.png\"", "The word two.", "&lt;three>", "ArrowRight"})
    CHECK_MESSAGE(page.find(part) != std::string::npos, std::string(part));
  CHECK(page.find("http") == std::string::npos);  // it needs nothing from elsewhere
  CHECK(run_in_child(lesson, {"-o", out, "--frames", "1"}).out.find("1 picture: ") != std::string::npos);
}

TEST_CASE("the colour of Box2D is in no picture of a lesson that does not run it") {
  const ScratchFolder folder;
  for (const char* name : {"lesson08_warm_start", "lesson16_jacobi", "lesson18_speed_accuracy"}) {
    CAPTURE(name);
    REQUIRE(run_program(name, {"--format", "svg", "-o", folder.path() + "/" + name}).code == 0);
    int pictures = 0;
    for (const std::string& file : folder.names(name)) {
      if (!file.ends_with(".svg")) continue;
      ++pictures;
      const std::string drawn = folder.text(std::string(name) + "/" + file);
      CHECK(drawn.find("0c5b3b") == std::string::npos);
      CHECK(drawn.find("0C5B3B") == std::string::npos);
    }
    CHECK(pictures > 3);
  }
}
