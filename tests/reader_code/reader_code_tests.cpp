// What becomes of a reader's code: its end, with all that it has started, and what is said of it.
#include "lessons/reader_code/run.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "lessons/reader_code/verdict.hpp"

using namespace cairn;
using reader_code::Ended;
using reader_code::Job;

namespace {

namespace fs = std::filesystem;

/// A folder that is gone when this is.
struct ReaderFolder {
  std::string path = (fs::temp_directory_path() / "cairn-reader-code-XXXXXX").string();

  ReaderFolder() { REQUIRE(mkdtemp(path.data()) != nullptr); }
  ~ReaderFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  ReaderFolder(const ReaderFolder&) = delete;
  ReaderFolder& operator=(const ReaderFolder&) = delete;

  std::string file(const char* name) const { return path + "/" + name; }
  std::string text(const char* name) const {
    std::ifstream stream(file(name));
    return {std::istreambuf_iterator<char>(stream), {}};
  }
};

/// A grader that goes wrong in this way, under shorter limits than a reader has.
Job misdeed(const std::string& name, const ReaderFolder& folder) {
  return {.command = {CAIRN_BIN_DIR "/misbehaving_grader", name, folder.file("left")},
          .file = "exercise.cpp",
          .limits = {.seconds = 20, .output = 100'000, .memory = 500'000'000, .file = 3'000'000}};
}

/// Runs a job while stdout, or stderr, leads to the file "out" of a folder.
Ended run_into(const ReaderFolder& folder, const Job& job, int stream = STDOUT_FILENO) {
  std::fflush(nullptr);
  const int before = dup(stream), out = open(folder.file("out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(out, stream);
  close(out);
  const Ended ended = reader_code::run(job);
  std::fflush(nullptr);
  dup2(before, stream);
  close(before);
  return ended;
}

Ended outcome(const std::string& name) {
  const ReaderFolder folder;
  return run_into(folder, misdeed(name, folder));
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

bool lives(const std::string& process) { return kill(std::stoi(process), 0) == 0; }

}  // namespace

TEST_CASE("a grader passes by its verdict alone") {
  CHECK(outcome("none").code == 0);
  CHECK(outcome("none").words.empty());
  for (const char* name : {"exit", "quick_exit", "_exit", "lie", "other program", "copy goes on"}) {
    INFO(std::string(name));
    const Ended ended = outcome(name);
    CHECK(ended.code == 1);
    CHECK(says(ended.words, "exercise.cpp ended the program before the grader was done (exit code 0)"));
  }
  const Ended late = outcome("exit at the end");
  CHECK(late.code == 1);
  CHECK(says(late.words, "after the grader was done (exit code 7)"));
}

TEST_CASE("a crash is told in words, with its signal") {
  for (const auto& [name, words] :
       {std::pair("abort", "called abort(), or something did for it"),
        std::pair("divide", "divided a whole number by 0: signal 8"),
        std::pair("null", "a null pointer: signal 11"),
        std::pair(
            "astray",
            "read or wrote where it has nothing (a null pointer, or past the end of a list): signal 11"),
        std::pair("stack", "ran out of stack"),
        std::pair("index", "used an index outside of a list: signal 6"),
        std::pair("back", "took an element from an empty list: signal 6"),
        std::pair("file", "wrote a file that is too long")}) {
    const std::string shown = name;
    INFO(shown);
    const Ended ended = outcome(name);
    CHECK(ended.code == 1);
    CHECK_MESSAGE(says(ended.words, words), ended.words);
  }
}

TEST_CASE("an exception is told by the grader, and so is memory that there is none of") {
  const auto told = [](const std::string& name) {
    const ReaderFolder folder;
    const Ended ended = run_into(folder, misdeed(name, folder));
    CHECK(ended.code == 1);
    CHECK(ended.words.empty());
    return folder.text("out");
  };
  CHECK(says(told("throw"),
             "graded\nYour code has thrown an exception, and nothing in it catches that: no box\n"));
  CHECK(says(told("throw a number"), "thrown something that is no std::exception"));
  // Where addresses have no limit, the memory of the computer would be it.
  if (!reader_code::detail::says_more_by_itself) CHECK(says(told("memory"), "more memory than it may have"));
}

TEST_CASE("what prints without end is stopped, and what was printed until then is shown") {
  const ReaderFolder folder;
  const Ended ended = run_into(folder, misdeed("print", folder));
  CHECK(ended.code == 1);
  CHECK(says(ended.words, "exercise.cpp was stopped: it printed more than 0.1 MB."));
  CHECK(says(folder.text("out"), "graded\nxxx"));
  CHECK(folder.text("out").size() == 100'001);  // and a line feed for the words behind it
  const Ended on_stderr = run_into(folder, misdeed("print one line", folder), STDERR_FILENO);
  CHECK(says(on_stderr.words, "it printed more than 0.1 MB"));
  CHECK(folder.text("out").size() < 100'001);
}

TEST_CASE("what ignores SIGTERM is ended in time, and nothing that it has started lives on") {
  const ReaderFolder folder;
  Job job = misdeed("leave and hang", folder);
  job.limits.seconds = 1;
  const auto begin = std::chrono::steady_clock::now();
  const Ended ended = run_into(folder, job);
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(10));
  CHECK(ended.code == 1);
  CHECK(ended.words == "exercise.cpp did not end within 1 s: does one of its loops never stop?");
  CHECK_FALSE(lives(folder.text("left")));
  CHECK(run_into(folder, misdeed("leave", folder)).code == 0);
  CHECK_FALSE(lives(folder.text("left")));
}

TEST_CASE("a compiler has its exit code, and its limits other words") {
  const ReaderFolder folder;
  Job job = misdeed("hang", folder);
  job.is_compiler = true;
  job.limits.seconds = 1;
  const Ended hanging = run_into(folder, job);
  CHECK(hanging.code == reader_code::limit_reached);
  CHECK(says(hanging.words, "Compiling exercise.cpp took longer than 1 s and was stopped"));
  job.command = {"sh", "-c", "exit 5"};
  CHECK(run_into(folder, job).code == 5);
  job.command = {folder.file("none")};
  const Ended missing = run_into(folder, job);
  CHECK(missing.code == 3);
  CHECK(missing.words == "cannot start " + folder.file("none") + ": No such file or directory");
}

TEST_CASE("a run ends by itself where its caller ignores the ends of children") {
  const ReaderFolder folder;
  signal(SIGCHLD, SIG_IGN);
  const Ended ended = run_into(folder, misdeed("divide", folder));
  signal(SIGCHLD, SIG_DFL);
  CHECK(says(ended.words, "signal 8"));
}

TEST_CASE("a signal to stop ends the reader's program first, and then whoever runs it") {
  const ReaderFolder folder;
  std::fflush(nullptr);
  const pid_t runner = fork();
  REQUIRE(runner >= 0);
  if (runner == 0) {
    signal(SIGINT, SIG_DFL);  // doctest has a handler
    run_into(folder, misdeed("leave and hang", folder));
    _exit(0);
  }
  while (!says(folder.text("left"), "\n") && waitpid(runner, nullptr, WNOHANG) == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  int status = 0;
  kill(runner, SIGINT);
  CHECK(waitpid(runner, &status, 0) == runner);
  CHECK(WIFSIGNALED(status));
  CHECK(WTERMSIG(status) == SIGINT);
  CHECK_FALSE(lives(folder.text("left")));
}

TEST_CASE("the program run_reader ends what it runs when the script that has started it is gone") {
  const ReaderFolder folder;
  const std::string line = CAIRN_BIN_DIR "/run_reader grader x.cpp " CAIRN_BIN_DIR
                                         "/misbehaving_grader 'leave and hang' '" +
                           folder.file("left") + "' >/dev/null; :";
  std::fflush(nullptr);
  const pid_t script = fork();
  REQUIRE(script >= 0);
  if (script == 0) {
    execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
    _exit(127);
  }
  while (!says(folder.text("left"), "\n") && waitpid(script, nullptr, WNOHANG) == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  kill(script, SIGKILL);
  waitpid(script, nullptr, 0);
  const auto end =
      std::chrono::steady_clock::now() + std::chrono::seconds(5);  // before it ends by its own limit
  while (lives(folder.text("left")) && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  CHECK_FALSE(lives(folder.text("left")));
}
