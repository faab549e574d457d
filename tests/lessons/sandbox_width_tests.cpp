// What cairn prints fits the window: no line is longer, and no word is broken.
#include <doctest/doctest.h>

#include <cstdlib>
#include <set>
#include <sstream>
#include <string>

#include "lessons/kit/words.hpp"
#include <cairn/math/list.hpp>
#include "sandbox_program.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// What it prints in a window of so many columns; in a file where there are none.
std::string printed(const List<std::string>& words, const char* columns) {
  columns == nullptr ? unsetenv("COLUMNS") : setenv("COLUMNS", columns, 1);
  const Ran ran = run_cairn(words);
  unsetenv("COLUMNS");
  return ran.out + ran.err;
}

int longest_line(const std::string& text) {
  std::istringstream lines(text);
  int widest = 0;
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, display_width(line));
  return widest;
}

std::set<std::string> single_words(const std::string& text) {
  std::istringstream stream(text);
  std::set<std::string> words;
  for (std::string word; stream >> word;) words.insert(word);
  return words;
}

/// Without times, which differ from run to run.
bool is_no_number(const std::string& text) { return text.find_first_of("0123456789") == std::string::npos; }

}  // namespace

TEST_CASE("the rows of a recommendation stand below heads of their own, in every window") {
  for (const char* columns : {"100", "80", "60"}) {
    CAPTURE(columns);
    std::istringstream lines(printed({"recommend"}, columns));
    int heads = 0;
    std::set<std::string> missed;
    for (std::string line, next; std::getline(lines, line);) {
      if (line.find(" misses: ") != std::string::npos) CHECK(missed.insert(line).second);
      if (line.find("  run ") != 0 && line.find("    run ") != 0) continue;
      ++heads;
      REQUIRE(std::getline(lines, next));
      CAPTURE(next);
      CHECK(line.size() == next.size());  // both end with a number, at the right
    }
    CHECK(heads > 10);
  }
}

TEST_CASE("what every verb prints fits a window of 80 and of 60 columns, with whole words") {
  const ScratchFolder scratch;
  const std::string scene = scratch.path() + "/own.toml";
  scratch.write("own.toml",
                "seconds = 0.5\n[ground]\n[[body]]\nname = \"a\"\nbox = [1, 1]\nposition = [0, 0.5]\n");
  List<List<std::string>> all = {
      {"--help"},
      {"list"},
      {"run", "chain-bob", "--seconds", "0.2s"},
      {"run", "no-such-scene-in-the-list"},
      {"explain", "stack"},
      {"compare", "stack", "--solvers", "si,accelerated,newton", "--seconds", "0.2s"},
      {"inspect", "stack", "--step", "2"},
      {"freeze", "stack", "--step", "2", "--out", scratch.path() + "/own.json"},
      {"tune", scene, "--penetration", "10mm", "--starts", "1", "--solvers", "si"},
      {"tradeoff", scene, "--quick", "--solvers", "si", "--out", scratch.path() + "/out"},
      {"tradeoff", "--list"},
      {"recommend"}};
  for (const char* verb : {"run", "explain", "compare", "inspect", "freeze", "tune", "tradeoff", "list",
                           "recommend", "extremes", "validate", "completion"})
    all.push_back({verb, "--help"});
  for (const List<std::string>& words : all) {
    CAPTURE(words.front());
    printed(words, nullptr);  // what is known from an earlier run is told otherwise
    const std::set<std::string> whole = single_words(printed(words, nullptr));
    const bool is_timed = words.front() == "tune";  // its setting is another one each time
    for (const char* columns : {"80", "60"}) {
      const std::string text = printed(words, columns);
      const bool has_path = text_has(text, scratch.path());  // a path is one word, as long as it is
      CHECK((has_path || longest_line(text) <= std::stoi(columns)));
      for (const std::string& word : single_words(text)) {
        CAPTURE(word);
        CHECK((is_timed || !is_no_number(word) || whole.count(word) == 1));
      }
    }
  }
}

TEST_CASE("the heads of a comparison stand above its numbers in a narrow window") {
  const std::string text = printed({"compare", "stack", "--solvers", "si,newton", "--seconds", "0.2s"}, "80");
  std::istringstream lines(text);
  List<std::string> rows;
  for (std::string line; std::getline(lines, line);)
    if (line.rfind("solver", 0) == 0 || line.rfind("si x", 0) == 0) rows.push_back(line);
  // A part of the table has its head before its rows: head, row, head, row.
  REQUIRE(rows.size() == 4);
  for (const int i : {0, 2}) CHECK(rows[i].rfind("solver", 0) == 0);
  for (const int i : {1, 3}) CHECK(rows[i].rfind("si x", 0) == 0);
  CHECK(rows[0].find("row updates") + 11 == rows[1].find("6400") + 4);
}
