// The reader's own solver where it runs wild, or where the place to grade it is not there.
#include <doctest/doctest.h>
#include <signal.h>

#include <filesystem>
#include <string>
#include <utility>

#include "run_solver.hpp"

namespace {

namespace fs = std::filesystem;
using namespace cairn::solver_tests;

/// What the grader says of the model of stage 00 where make_box does something more; `before` stands in front
/// of it.
Ended solver_that(const std::string& deed, const std::string& before) {
  const fs::path scratch = scratch_folder("wild");
  std::string model = model_of(0);
  const std::string first = "Body box;";
  model.insert(model.find(first) + first.size(), deed);
  write_file(scratch / "my_solver.cpp", before + model);
  return run_solver(scratch, "0");
}

}  // namespace

TEST_CASE("a solver that ends the program, crashes or prints without end has not passed, and is told why") {
  for (const auto& [deed, words] :
       {std::pair("std::exit(0);", "ended the program before the grader was done (exit code 0)"),
        std::pair("std::puts(\"Passed.\"), std::quick_exit(0);",
                  "ended the program before the grader was done"),
        std::pair("int* volatile nowhere = nullptr; *nowhere = 1;", "a null pointer: signal 11"),
        std::pair("throw std::runtime_error(\"no box\");",
                  "thrown an exception, and nothing in it catches that: no box"),
        std::pair("while (true) std::puts(\"CHECK ok\");", "it printed more than 1 MB")}) {
    const std::string shown = deed;
    INFO(shown);
    const Ended ended = solver_that(deed, "#include <cstdio>\n#include <cstdlib>\n#include <stdexcept>\n");
    CHECK(ended.code == 1);
    CHECK_MESSAGE(ended.out.find(words) != std::string::npos, ended.out);
    CHECK(ended.out.find("Not yet.") != std::string::npos);
    CHECK(ended.out.size() < 1'100'000);
  }
}

TEST_CASE("a solver that ignores SIGTERM and leaves a process behind is ended with it, in time") {
  const Ended ended =
      solver_that("signal(SIGTERM, SIG_IGN); if (fork() == 0) { setsid(); note(); } while (true) pause();",
                  "#include <signal.h>\n#include <unistd.h>\n#include <fstream>\n"
                  "void note() { std::ofstream(\"left\") << getpid() << std::endl; }\n");
  CHECK(ended.code == 1);
  CHECK(ended.out.find("did not end within 10 s") != std::string::npos);
  const std::string left = text_of(fs::path(CAIRN_BINARY_DIR) / "reader_tests/wild/left");
  REQUIRE_FALSE(left.empty());
  CHECK(kill(std::stoi(left), 0) != 0);
}

TEST_CASE("a reader's file may have a main() of its own, and a function without a body is named") {
  const fs::path folder = scratch_folder("with_main");
  write_file(folder / "my_solver.cpp", model_of(0) + "\nint main() { return 7; }\n");
  CHECK(run_solver(folder, "0").code == 0);
  const std::string model = model_of(0);
  write_file(folder / "my_solver.cpp", model.substr(0, model.find("// The second half")) +
                                           "void move_bodies(std::vector<Body>&, double);\n");
  const Ended lacking = run_solver(folder, "0");
  CHECK(lacking.code == 1);
  CHECK(lacking.out.find("my_solver.cpp declares move_bodies(") != std::string::npos);
}

TEST_CASE("where nothing can be written for the compiler, the place is blamed and not the reader's file") {
  const fs::path folder = scratch_folder("nowhere");
  write_file(folder / "my_solver.cpp", model_of(0));
  const std::string solver = " bash " + in_quotes(CAIRN_SOURCE_DIR "/lessons/run") + " solver";
  for (const char* words : {" 0", ""}) {
    const Ended ended =
        run_line("cd " + in_quotes(folder.string()) + " && TMPDIR=/dev/null" + solver + words);
    CHECK(ended.code == 3);
    CHECK(ended.out == "solver: cannot make a folder in /dev/null, which TMPDIR names\n");
  }
}
