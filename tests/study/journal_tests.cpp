// Studies that are stopped, taken up again, and shared out.
#include <cairn/study/journal.hpp>

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "scratch_folder.hpp"
#include <cairn/study/build_info.hpp>

using namespace cairn;
using cairn::testing::ScratchFolder;

namespace {

namespace fs = std::filesystem;

/// Task k answers k^2, in digits and in a word with a comma; `runs` counts the tasks that were done.
Study squares(int count, int& runs) {
  Study study = {.name = "squares", .header = {"square", "word", "half"}, .tasks = {}};
  for (int k = 0; k < count; ++k) {
    study.tasks.push_back(
        {.name = std::to_string(k), .run = [k, &runs]() -> List<CsvCell> {
           ++runs;
           return {static_cast<long long>(k * k), std::string("a,") + std::to_string(k), k / 2.0};
         }});
  }
  return study;
}

const StudyProgress to_the_end = [](int, int, double) { return true; };

}  // namespace

TEST_CASE("a study that was stopped goes on where it was, whatever was cut off") {
  const ScratchFolder folder;
  int runs = 0;
  const Study study = squares(7, runs);
  const fs::path whole = folder / "whole.csv", cut = folder / "cut.csv";
  Journal at_once(whole, study);
  REQUIRE(run_study(study, {}, at_once, to_the_end));
  CHECK(runs == 7);
  {
    Journal first(cut, study);
    const bool finished = run_study(study, {}, first, [](int done, int, double) { return done < 3; });
    CHECK_FALSE(finished);
    CHECK(first.size() == 3);
  }
  std::ofstream(cut, std::ios::app) << "3,9,half a li";  // the power went out
  Journal second(cut, study);
  CHECK(second.size() == 3);
  runs = 0;
  REQUIRE(run_study(study, {}, second, to_the_end));
  CHECK(runs == 4);
  CHECK(second.csv() == at_once.csv());
  CHECK(folder.text("cut.csv") == folder.text("whole.csv"));
}

TEST_CASE("shards do every task once, and merge to the same bytes in any order") {
  const ScratchFolder folder;
  int runs = 0;
  const Study study = squares(11, runs);
  Journal at_once(folder / "whole.csv", study);
  REQUIRE(run_study(study, {}, at_once, to_the_end));
  runs = 0;
  for (int k = 1; k <= 3; ++k) {
    Journal part(folder / ("part" + std::to_string(k)), study);
    REQUIRE(run_study(study, {.number = k, .of = 3}, part, to_the_end));
  }
  CHECK(runs == 11);
  for (const std::string order : {"123", "312", "231"}) {
    Journal merged(folder / ("merged" + order), study);
    for (const char k : order) merged.absorb(folder / (std::string("part") + k));
    CHECK(merged.csv() == at_once.csv());
  }
  std::istringstream text(at_once.csv());
  const CsvTable table = read_csv(text, "squares");
  REQUIRE(table.rows.size() == 11);
  CHECK(std::get<long long>(table.rows[5][1]) == 25);
  CHECK(std::get<std::string>(table.rows[5][2]) == "a,5");
  CHECK(std::get<double>(table.rows[5][3]) == 2.5);
}

TEST_CASE("a journal that has all answers of another study or build is begun anew") {
  const ScratchFolder folder;
  int runs = 0;
  const fs::path path = folder / "journal.csv";
  const std::string squares_of_another_build =
      "# squares\n# cairn 0.0.1\ntask,square,word,half\n0,0,\"a,0\",0\n";
  {
    const Study three = squares(3, runs);
    Journal journal(path, three);
    REQUIRE(run_study(three, {}, journal, to_the_end));
    CHECK(Journal(path, three).size() == 3);  // of the same study nothing is lost
  }
  Study cubes = squares(2, runs);
  cubes.name = "cubes";
  CHECK(Journal(path, cubes).size() == 0);
  CHECK(folder.text("journal.csv").rfind("# cubes\n", 0) == 0);
  std::ofstream(path, std::ios::trunc) << squares_of_another_build << "# all done\n";
  CHECK(Journal(path, squares(3, runs)).size() == 0);
  std::ofstream(path, std::ios::trunc) << squares_of_another_build;  // it may go on
  CHECK_THROWS_AS(Journal(path, squares(3, runs)), std::invalid_argument);
}

TEST_CASE("the journal of another study is left alone, and a wrong share is refused") {
  const ScratchFolder folder;
  int runs = 0;
  Study study = squares(2, runs);
  const fs::path path = folder / "journal.csv";
  std::ofstream(path) << "my diary\n";
  CHECK_THROWS_WITH_AS(Journal(path, study), doctest::Contains("of the study \"squares\""),
                       std::invalid_argument);
  CHECK(folder.text("journal.csv") == "my diary\n");
  std::ofstream(path, std::ios::trunc) << "# squares\n# cairn 0.0.1\ntask,square,word,half\n";
  CHECK_THROWS_WITH_AS(Journal(path, study),
                       (path.string() + ": build must be " + build_text() + ", got cairn 0.0.1").c_str(),
                       std::invalid_argument);
  std::ofstream(path, std::ios::trunc) << "# squares\ntask,square,word,half\n";
  CHECK_THROWS_WITH_AS(Journal(path, study), doctest::Contains(", got none"), std::invalid_argument);
  const std::string title = "# squares\n# " + build_text() + "\n";
  std::ofstream(path, std::ios::trunc) << title << "task,square,third\n";
  CHECK_THROWS_WITH_AS(Journal(path, study), doctest::Contains("columns must be those of this version"),
                       std::invalid_argument);
  std::ofstream(path, std::ios::trunc) << title << "task,square,word,half\n9,1,2,3\n";
  CHECK_THROWS_WITH_AS(Journal(path, study), doctest::Contains("line 4"), std::invalid_argument);
  CHECK_THROWS_AS(Journal("/dev/null/journal.csv", study), std::runtime_error);
  CHECK(parse_shard("2/8").number == 2);
  CHECK(parse_shard("2/8").of == 8);
  for (const char* wrong : {"", "2", "0/3", "4/3", "1/0", "-1/2", "1/2/3", "a/b", "1/10001", "1 /2"}) {
    CHECK_THROWS_WITH_AS(parse_shard(wrong), doctest::Contains("k/n"), std::invalid_argument);
  }
}
