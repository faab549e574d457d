// The reader's own solver, as its reader runs it: states that begin a stage fail it, and what cannot be
// graded is told in words. exercises/answers_tests.cpp has the models and the wrong answers.
#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <cairn/math/list.hpp>
#include "run_solver.hpp"

namespace {

namespace fs = std::filesystem;
using cairn::List;
using namespace cairn::solver_tests;

constexpr int solver_stages = 10;

}  // namespace

TEST_CASE("what begins a stage passes the stage before, and not its own") {
  const fs::path folder = scratch_folder("begin");
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
  const fs::path folder = scratch_folder("finished");
  const std::string model = model_of(solver_stages - 1);
  const auto lines = std::count(model.begin(), model.end(), '\n');
  CHECK(lines >= 150);
  CHECK(lines <= 260);
  write_file(folder / "my_solver.cpp", model);
  CHECK(run_solver(folder, "9").code == 0);
  const Ended graded = run_solver(folder, "8");
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
  const fs::path folder = scratch_folder("broken");
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
  const std::string made = "Body box;";
  const Ended stopped = answer(
      std::string(model).insert(model.find(made) + made.size(), " std::vector<int> none; none[3] = 1;"));
  CHECK(stopped.code == 1);
  CHECK(stopped.out.find("an index outside of a list") != std::string::npos);
}

TEST_CASE("the reader's solver refuses words that it does not know, and a stage without a file") {
  const fs::path folder = scratch_folder("refused");
  for (const auto& [words, complaint] :
       {std::pair("12", "must be a number from 0 to 9, got \"12\""), std::pair("x", "got \"x\""),
        std::pair("3 --start", "got \"--start\""), std::pair("3 --film dark", "got \"--film dark\""),
        std::pair("3", "there is no my_solver.cpp in")}) {
    const std::string shown = words;
    INFO(shown);
    const Ended refused = run_solver(folder, words);
    CHECK(refused.code == 2);
    CHECK(refused.out.find(complaint) != std::string::npos);
  }
  CHECK(fs::is_empty(folder));
}
