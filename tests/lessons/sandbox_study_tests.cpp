// Studies of the program `cairn`: the same bytes, whether at once, in parts, or stopped on the way.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>

#include <cairn/math/list.hpp>
#include <cairn/measure/csv.hpp>
#include "sandbox_program.hpp"

using namespace cairn::testing;
using cairn::List;

namespace {

using Flags = List<std::string>;

/// Every number of it depends on nothing but the code: quick studies of single steps take no times.
Ran study_in(const ScratchFolder& folder, const std::string& scene, const Flags& flags) {
  Flags words = {"tradeoff", scene, "--quick", "--out", folder.path()};
  words.insert(words.end(), flags.begin(), flags.end());
  return run_cairn(words);
}

void check_same(const ScratchFolder& a, const ScratchFolder& b, const std::string& name) {
  for (const std::string ending : {".csv", ".json", ".png"}) {
    CAPTURE(ending);
    CHECK_FALSE(a.text(name + ending).empty());
    CHECK(a.text(name + ending) == b.text(name + ending));
  }
}

int exit_code_of(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

long lines_in(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

}  // namespace

TEST_CASE("two runs of a study leave the same bytes, and a third has nothing left to do") {
  const ScratchFolder first, second;
  const Ran once = study_in(first, "stack10", {"--solvers", "si,pgs"});
  CHECK(once.code == 0);
  CHECK(study_in(second, "stack10", {"--solvers", "si,pgs"}).code == 0);
  check_same(first, second, "stack10");
  CHECK(first.names() == Flags{"stack10.csv", "stack10.journal", "stack10.json", "stack10.png"});
  const std::string journal = first.text("stack10.journal");
  const Ran again = study_in(first, "stack10", {"--solvers", "si,pgs"});
  CHECK(again.code == 0);
  CHECK(text_has(again.out, "52 of them were tried before"));  // 2 solvers, 2 starts, 13 numbers of sweeps
  CHECK(first.text("stack10.journal") == journal);
  check_same(first, second, "stack10");
}

TEST_CASE("the table, the CSV and the JSON of a study hold the same numbers") {
  const ScratchFolder folder;
  const Ran people = study_in(folder, "ratio100", {"--solvers", "si"});
  const Ran programs = study_in(folder, "ratio100", {"--solvers", "si", "--json"});
  CHECK(programs.out == folder.text("ratio100.json"));
  const auto rows = nlohmann::json::parse(programs.out);
  std::istringstream file(folder.text("ratio100.csv"));
  const cairn::CsvTable table = cairn::read_csv(file, "ratio100.csv");
  REQUIRE(table.rows.size() == rows.size() + 1);  // the units come first
  int line = 0;
  for (const nlohmann::json& row : rows) {
    const List<cairn::CsvCell>& cells = table.rows[++line];
    for (int k = 0; k < table.header.size(); ++k) {
      const nlohmann::json& cell = row.at(table.header[k]);
      if (const auto* number = std::get_if<double>(&cells[k])) CHECK(cell == *number);
      if (const auto* whole = std::get_if<long long>(&cells[k])) CHECK(cell == *whole);
      if (const auto* text = std::get_if<std::string>(&cells[k])) CHECK(cell == *text);
    }
  }
  double least = 1e300;  // row updates to R_E <= 1e-2 from a cold start
  for (const auto& row : rows) {
    if (row.at("warm") == "cold" && row.at("R_E_v") <= 1e-2)
      least = std::min(least, row.at("row_updates").get<double>());
  }
  std::istringstream second_line(people.out.substr(people.out.find("  ratio100")));
  std::string scene, solver;
  double printed = 0;
  second_line >> scene >> solver >> printed;
  CHECK(solver == "si");
  CHECK(printed == least);
}

TEST_CASE("the parts of a study merge to the bytes of the whole, and one part alone is refused") {
  const ScratchFolder whole, parts, merged;
  CHECK(study_in(whole, "chain20x100", {"--solvers", "si"}).code == 0);
  Flags journals;
  for (const std::string k : {"1", "2", "3"}) {
    CHECK(study_in(parts, "chain20x100", {"--solvers", "si", "--shard", k + "/3"}).code == 0);
    journals.push_back(parts.path() + "/chain20x100." + k + "-of-3.journal");
  }
  const Ran alone = study_in(merged, "chain20x100", {"--solvers", "si", "--merge", journals[1]});
  CHECK(alone.code == 1);
  CHECK(text_has(alone.err, "--merge must be all parts"));
  CHECK(text_has(alone.err, "got 9 of 26"));
  CHECK(merged.names() == Flags{"chain20x100.journal"});
  const std::string both = journals[2] + "," + journals[0];
  CHECK(study_in(merged, "chain20x100", {"--solvers", "si", "--merge", both}).code == 0);
  check_same(whole, merged, "chain20x100");
  CHECK(study_in(merged, "chain20x100", {"--solvers", "si", "--merge", "/no/such/journal"}).code == 2);
}

TEST_CASE("the journal of another grid that may go on, and a file that is none, are left as they were") {
  const ScratchFolder folder;
  CHECK(study_in(folder, "ratio100", {"--solvers", "si", "--shard", "1/2"}).code == 0);
  const std::string before = folder.text("ratio100.1-of-2.journal");
  const Ran other = study_in(folder, "ratio100", {"--solvers", "pgs", "--shard", "1/2"});
  CHECK(other.code == 2);
  CHECK(lines_in(other.err) == 1);
  CHECK(text_has(other.err, "name another folder, or delete the journal"));
  CHECK(folder.text("ratio100.1-of-2.journal") == before);
  folder.write("stack10.journal", "notes without a line break");
  CHECK(study_in(folder, "stack10", {"--solvers", "si"}).code == 2);
  CHECK(folder.text("stack10.journal") == "notes without a line break");
}

TEST_CASE("another grid on the same problem follows one that is done, in the same folder") {
  const ScratchFolder folder, apart;
  CHECK(study_in(folder, "ratio100", {"--solvers", "si"}).code == 0);
  CHECK(study_in(folder, "ratio100", {"--solvers", "pgs"}).code == 0);
  CHECK(study_in(apart, "ratio100", {"--solvers", "pgs"}).code == 0);
  check_same(folder, apart, "ratio100");
}

TEST_CASE("a study that is interrupted ends with 130, and goes on to the bytes of one that was not") {
  const ScratchFolder whole, stopped;
  CHECK(study_in(whole, "silo60", {"--solvers", "si"}).code == 0);
  const pid_t child = started_cairn(
      {"tradeoff", "silo60", "--quick", "--out", stopped.path(), "--solvers", "si"}, "/dev/null");
  // Three lines of title, build and header, and five answers.
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (lines_in(stopped.text("silo60.journal")) < 8 && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  kill(child, SIGINT);
  CHECK(exit_code_of(child) == 130);
  CHECK(stopped.names() == Flags{"silo60.journal"});
  const long done = lines_in(stopped.text("silo60.journal")) - 3;
  CHECK(done >= 5);
  CHECK(done < 26);
  CHECK(study_in(stopped, "silo60", {"--solvers", "si"}).code == 0);
  check_same(whole, stopped, "silo60");
}

TEST_CASE("output that a full disk does not take ends with three") {
  for (const Flags& words :
       {Flags{"--help"}, Flags{"validate", "--list"}, Flags{"freeze", "stack", "--json"}}) {
    CHECK(exit_code_of(started_cairn(words, "/dev/full")) == 3);
  }
  for (const std::string command : {"lesson00_one_body --help", "lesson00_one_body --frames none",
                                    "lesson00_one_body --check --quiet", "lessons list", "lessons --help"}) {
    CAPTURE(command);
    const Ran ran = run_program("/bin/sh", {"-c", CAIRN_BIN_DIR "/" + command + " > /dev/full"});
    CHECK(ran.code == 3);
    CHECK(text_has(ran.err, "the output cannot be written"));
  }
}

TEST_CASE("the journal of another build is neither taken up nor merged") {
  const ScratchFolder folder, merged;
  const std::string name = "ratio100.1-of-2.journal";
  CHECK(study_in(folder, "ratio100", {"--solvers", "si", "--shard", "1/2"}).code == 0);
  std::string journal = folder.text(name);
  const std::size_t commit = journal.find(" of commit ");
  REQUIRE(commit != std::string::npos);
  journal.insert(commit + 11, "another");
  folder.write(name, journal);
  for (const Ran& ran :
       {study_in(folder, "ratio100", {"--solvers", "si", "--shard", "1/2"}),
        study_in(merged, "ratio100", {"--solvers", "si", "--merge", folder.path() + "/" + name})}) {
    CHECK(ran.code == 2);
    CHECK(lines_in(ran.err) == 1);
    CHECK(text_has(ran.err, name + ": build must be cairn "));
    CHECK(text_has(ran.err, ", got cairn "));
    CHECK(text_has(ran.err, " of commit another"));
  }
  CHECK(folder.text(name) == journal);
}

TEST_CASE("an error that is rounding is no reason for more work") {
  const ScratchFolder folder;
  folder.write("stack.toml", "[ground]\n[[stack]]\nn = 3\nbox = [1, 1]\n");
  const Ran ran = study_in(folder, folder.path() + "/stack.toml", {"--solvers", "newton", "--work", "updates"});
  REQUIRE(ran.code == 0);
  const std::size_t first = ran.out.find("newton");
  REQUIRE(first != std::string::npos);
  CHECK(text_has(ran.out.substr(first), " 1e-09"));
  CHECK(lines_in(ran.out.substr(first, ran.out.find("written:") - first)) == 1);
}

TEST_CASE("solvers that never arrive say in the table how they end") {
  const ScratchFolder folder;
  const Ran ran = study_in(folder, "painleve_rod", {"--solvers", "si,jacobi-split"});
  CHECK(ran.code == 0);
  const std::size_t line = ran.out.find("si ");
  REQUIRE(line != std::string::npos);
  CHECK(text_has(ran.out.substr(line, ran.out.find('\n', line) - line), "cycle"));
  CHECK(text_has(folder.text("painleve_rod.csv"), ",cycle,"));
}

TEST_CASE("tables for people stay within 110 columns") {
  const ScratchFolder folder;
  for (const Flags& flags :
       {Flags{"--solvers", "si,block-contact"}, Flags{"--solvers", "si", "--work", "time"}}) {
    std::istringstream lines(study_in(folder, flags.size() == 2 ? "stack10" : "ratio100", flags).out);
    for (std::string line; std::getline(lines, line);) {
      CAPTURE(line);
      if (line.rfind("written:", 0) != 0) CHECK(line.size() <= 110);
    }
  }
}

TEST_CASE("all frozen problems together give a profile, where a solver alone is the best of what it solves") {
  const ScratchFolder folder;
  const Ran ran = run_program("cairn", {"tradeoff", "--all", "--level", "1", "--quick", "--solvers", "block",
                                        "--out", folder.path()});
  CHECK(ran.code == 0);
  CHECK(folder.names() == Flags{"level1.csv", "level1.journal", "level1.json", "profile.png"});
  CHECK(text_has(ran.out, "share of 11 problems"));
  std::istringstream lines(ran.out);
  int solved = 0;
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    std::string scene, solver, coarse, middle;
    cells >> scene >> solver >> coarse >> middle;
    const bool is_number = !middle.empty() && middle.find_first_not_of("0123456789") == std::string::npos;
    solved += solver == "block" && is_number ? 1 : 0;
    if (scene == "block") last = line;
  }
  // The same share at every factor: its ratio is 1 wherever it arrives.
  const std::string share = std::to_string((100 * solved + 5) / 11) + "%";
  std::istringstream cells(last);
  std::string cell;
  cells >> cell;
  int count = 0;
  for (; cells >> cell; ++count) CHECK(cell == share);
  CHECK(count == 6);
}

TEST_CASE("the map of settings: the page prints what the kept table says, and a part of it runs") {
  const ScratchFolder folder;
  const std::string kept = std::string(CAIRN_SOURCE_DIR) + "/lessons/sandbox/";
  const std::string table = folder.path() + "/kept.csv";
  REQUIRE(std::system(("gzip -dc '" + kept + "map.csv.gz' > '" + table + "'").c_str()) == 0);
  const Ran told = run_program(
      "cairn", {"tradeoff", "--all", "--level", "3", "--table", table, "--quiet", "--out", folder.path()});
  CHECK(told.code == 0);
  CHECK(told.err == "");
  std::ifstream page(kept + "pages/tradeoff.md");
  std::ostringstream text;
  text << page.rdbuf();
  CHECK(told.out.size() > 1000);
  CHECK(text_has(text.str(), told.out));
  CHECK(folder.text("level3.csv") == folder.text("kept.csv"));
}

TEST_CASE("level 3 refuses what it does not know, and --table stands alone") {
  const auto refused = [](const Flags& flags) {
    Flags words = {"tradeoff", "--all"};
    words.insert(words.end(), flags.begin(), flags.end());
    return run_cairn(words).code;
  };
  CHECK(refused({"--level", "3", "--quick"}) == 2);
  CHECK(refused({"--level", "1", "--table", "x.csv"}) == 2);
  CHECK(refused({"--level", "3", "--table", "nowhere.csv"}) == 2);
  CHECK(refused({"--level", "3", "--table", "x.csv", "--shard", "1/2"}) == 2);
}
