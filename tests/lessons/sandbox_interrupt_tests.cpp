// The program `cairn` when it is told to stop: at once, with 130, and without half a file.
#include <doctest/doctest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>

#include <cairn/math/list.hpp>
#include "sandbox_program.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds long_enough(20);  // to get into its work, or out of it, on a busy machine

bool comes_true(const std::function<bool()>& what) {
  for (const auto deadline = Clock::now() + long_enough; !what() && Clock::now() < deadline;)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return what();
}

/// How the program ended, or -1 where it did not within `long_enough`.
int code_of(pid_t child) {
  int status = 0;
  if (comes_true([&] { return waitpid(child, &status, WNOHANG) != 0; }))
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  kill(child, SIGKILL);
  waitpid(child, &status, 0);
  return -1;
}

int code_after(pid_t child, int signal) {
  kill(child, signal);
  return code_of(child);
}

/// In the middle of its work, whatever that is: none of these commands ends by itself within a minute.
int code_after_a_second(const List<std::string>& words, int signal) {
  const pid_t child = started_cairn(words, "/dev/null");
  std::this_thread::sleep_for(std::chrono::seconds(1));
  return code_after(child, signal);
}

bool is_running(const std::string& pid) { return kill(std::stoi(pid), 0) == 0; }

}  // namespace

TEST_CASE("SIGINT and SIGTERM end every long verb with 130, in the middle of a solve or of a trial") {
  const ScratchFolder folder;
  const std::string many = "si:1000000", out = folder.path();
  CHECK(code_after_a_second({"run", "stack", "--solver", many, "--seconds", "60s"}, SIGINT) == 130);
  CHECK(code_after_a_second({"compare", "stack", "--solvers", many, "--seconds", "60s"}, SIGTERM) == 130);
  CHECK(code_after_a_second({"inspect", "stack", "--solver", many, "--step", "1000"}, SIGINT) == 130);
  CHECK(code_after_a_second({"freeze", "stack", "--step", "1000000", "--sweeps", "1000", "--out", out + "/f"},
                            SIGTERM) == 130);
  CHECK(code_after_a_second({"tune", "stack", "--residual", "1e-14", "--time", "600s"}, SIGINT) == 130);
  CHECK(code_after_a_second({"recommend", "--renew", "--out", out + "/r"}, SIGTERM) == 130);
  CHECK(code_after_a_second({"tradeoff", "--all", "--level", "2", "--out", out + "/t"}, SIGINT) == 130);
  CHECK(code_after_a_second({"extremes", "--out", out + "/e"}, SIGTERM) == 130);
  for (const std::string& name : folder.names()) {
    CAPTURE(name);
    CHECK((name == "r.renewing" || name == "t" || name == "e"));  // nothing but what the command goes on from
  }
}

TEST_CASE("a renewal of the recommendations that is stopped says what it goes on from, and does") {
  const ScratchFolder folder;
  const std::string file = folder.path() + "/r.json";
  const List<std::string> renew = {"--preserve-status", "-s",      "INT",   "2", CAIRN_BIN_DIR "/cairn",
                                   "recommend",         "--renew", "--out", file};
  for (int i = 0; i < 2; ++i) {  // the second goes on
    const Ran ran = run_program("/usr/bin/timeout", renew);
    CHECK(ran.code == 130);
    CHECK(text_has(ran.err, "stopped; the same command goes on from " + file + ".renewing\n"));
    CHECK(folder.names() == List<std::string>{"r.json.renewing"});
  }
  const std::string other = "# another study\n";
  folder.write("r.json.renewing", other);
  const Ran refused = run_cairn({"recommend", "--renew", "--out", file});
  CHECK(refused.code == 2);
  CHECK(text_has(refused.err, file + ".renewing: journal must be of the study"));
  CHECK(text_has(refused.err, "delete the journal to begin anew"));
  CHECK(folder.text("r.json.renewing") == other);
}

TEST_CASE("a study that is stopped in the middle of a task says that it goes on where it was") {
  const ScratchFolder folder;
  const Ran ran = run_program(
      "/usr/bin/timeout", {"--preserve-status", "-s", "INT", "1", CAIRN_BIN_DIR "/cairn", "tradeoff", "--all",
                           "--level", "2", "--out", folder.path() + "/study"});
  CHECK(ran.code == 130);
  CHECK(text_has(ran.err, "stopped; the same command goes on where it was\n"));
}

TEST_CASE("validate ends with 130 once it is told to stop, which takes it a few seconds otherwise") {
  const ScratchFolder folder;
  const pid_t child = started_cairn({"validate"}, folder.path() + "/out");
  CHECK(comes_true([&] { return !folder.text("out").empty(); }));
  CHECK(code_after(child, SIGINT) == 130);
}

TEST_CASE("what is no file is refused as one, at once: a FIFO would keep the program waiting for ever") {
  const ScratchFolder folder;
  const std::string fifo = folder.path() + "/fifo.toml";
  REQUIRE(mkfifo(fifo.c_str(), 0600) == 0);
  for (const std::string& place : {fifo, folder.path() + "/", std::string("/dev/zero")}) {
    CAPTURE(place);
    CHECK(code_of(started_cairn({"run", place}, "/dev/null")) == 2);
    CHECK(code_of(started_cairn({"recommend", "--from", place}, "/dev/null")) == 2);
    CHECK(code_of(started_cairn({"tradeoff", "stack10", "--out", folder.path() + "/out", "--merge", place},
                                "/dev/null")) == 2);
  }
}

TEST_CASE("a film that another program writes is stopped with that program, and leaves nothing") {
  const ScratchFolder folder;
  const std::string path = folder.path(), before = std::getenv("PATH");
  folder.write("ffmpeg", "#!/bin/sh\nfor last; do :; done\necho half > \"$last\"\necho $$ > " + path +
                             "/started\nmv " + path + "/started " + path + "/pid\nexec sleep 600\n");
  fs::permissions(path + "/ffmpeg", fs::perms::owner_all);
  setenv("PATH", (path + ":" + before).c_str(), 1);
  const pid_t child = started_cairn(
      {"run", "stack", "--seconds", "0.1s", "--size", "320x180", "--gif", path + "/film.gif"}, "/dev/null");
  setenv("PATH", before.c_str(), 1);
  CHECK(comes_true([&] { return fs::exists(path + "/pid"); }));
  CHECK(code_after(child, SIGINT) == 130);
  REQUIRE_FALSE(folder.text("pid").empty());
  CHECK_FALSE(is_running(folder.text("pid")));
  CHECK(folder.names() == List<std::string>{"ffmpeg", "pid"});
}
