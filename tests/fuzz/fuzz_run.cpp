// A child process feeds the target and notes in shared memory what it is at; its parent watches.
#include "fuzz/fuzz_run.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>
#include <sstream>
#include <utility>

#include "fuzz/mutate.hpp"
#include "fuzz/random_world.hpp"

#if defined(__SANITIZE_ADDRESS__)
#define CAIRN_UNDER_ASAN 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define CAIRN_UNDER_ASAN 1
#endif
#endif

namespace cairn::fuzz {

namespace {

using Clock = std::chrono::steady_clock;

const int found_something = 77;      // the exit code of a child with a message
const rlim_t longest_case = 5;       // [s] of processor time
const std::size_t tail_size = 4000;  // [bytes] of a log that is kept
const std::uint64_t usual_worlds = 200;

/// What child and parent share.
struct Shared {
  std::atomic<std::uint64_t> number = 0;
  std::atomic<std::uint64_t> accepted = 0;
  char message[2000] = {};
};

/// Memory that both processes see.
class SharedPage {
 public:
  SharedPage() {
    void* const memory =
        mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::runtime_error("cairn_fuzz: there is no shared memory");
    shared_ = ::new (memory) Shared;
  }
  ~SharedPage() { munmap(shared_, sizeof(Shared)); }
  SharedPage(const SharedPage&) = delete;
  SharedPage& operator=(const SharedPage&) = delete;
  Shared* operator->() { return shared_; }

 private:
  Shared* shared_;
};

/// A folder that is empty at first and gone at last: what inputs write goes there.
struct Scratch {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("cairn_fuzz_" + std::to_string(getpid()));
  Scratch() { std::filesystem::create_directories(path); }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
};

/// The kernel ends the process once it has used so many seconds more than now.
void allow_seconds() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto spent = static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec);
  const rlimit limit{.rlim_cur = spent + longest_case + 1, .rlim_max = RLIM_INFINITY};
  setrlimit(RLIMIT_CPU, &limit);
}

void limit_memory() {
  if (is_under_asan()) return;  // which reserves terabytes of addresses
  const rlimit limit{.rlim_cur = rlim_t{1} << 30, .rlim_max = rlim_t{1} << 30};
  setrlimit(RLIMIT_AS, &limit);
}

void send_to(int stream, const char* path, int flags) {
  const int file = open(path, flags, 0600);
  if (file >= 0) dup2(file, stream);
  if (file >= 0) close(file);
}

[[noreturn]] void feed_from(std::uint64_t first, const Run& run, Clock::time_point end, SharedPage& page,
                            const Scratch& scratch) {
  send_to(STDIN_FILENO, "/dev/null", O_RDONLY);
  send_to(STDOUT_FILENO, "/dev/null", O_WRONLY);
  send_to(STDERR_FILENO, (scratch.path / "stderr").c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND);
  std::filesystem::current_path(scratch.path);
  limit_memory();
  for (std::uint64_t number = first; std::cmp_less(number, run.seeds.size()) || Clock::now() < end;
       ++number) {
    page->number = number;
    allow_seconds();
    try {
      if (feed(run.target, input(run.seeds, run.seed, number)).accepted) ++page->accepted;
    } catch (const std::exception& error) {
      std::strncpy(page->message, error.what(), sizeof(page->message) - 1);
      _exit(found_something);
    }
  }
  page->number = std::max<std::uint64_t>(page->number + 1, first);
  _exit(0);
}

std::string tail_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  const std::string all = text.str();
  return all.size() <= tail_size ? all : all.substr(all.size() - tail_size);
}

std::string ending_of(int status, SharedPage& page) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == found_something) return page->message;
  if (WIFEXITED(status)) return "it ended with code " + std::to_string(WEXITSTATUS(status));
  if (WTERMSIG(status) == SIGXCPU) return "it took more than 5 s";
  return "it ended with signal " + std::to_string(WTERMSIG(status));
}

std::string contents_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

bool is_under_asan() {
#ifdef CAIRN_UNDER_ASAN
  return true;
#else
  return false;
#endif
}

RunReport run(const Run& run) {
  RunReport report;
  SharedPage page;
  const Scratch scratch;
  const Clock::time_point end =
      Clock::now() + std::chrono::microseconds(static_cast<std::int64_t>(run.seconds * 1e6));
  for (std::uint64_t first = 0;;) {
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cairn_fuzz: there is no room for another process");
    if (child == 0) feed_from(first, run, end, page, scratch);
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
    }
    report.inputs = page->number;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) break;
    report.harm.push_back({page->number, ending_of(status, page), tail_of(scratch.path / "stderr")});
    if (report.harm.size() >= run.most_findings) break;
    first = page->number + 1;
    if (std::cmp_greater_equal(first, run.seeds.size()) && Clock::now() >= end) break;
  }
  report.accepted = page->accepted;
  return report;
}

List<std::string> read_seeds(const List<std::string>& paths) {
  List<std::string> seeds;
  for (const std::string& path : paths) {
    List<std::filesystem::path> files = {path};
    if (std::filesystem::is_directory(path)) {
      files.clear();
      for (const auto& entry : std::filesystem::directory_iterator(path)) {
        if (entry.is_regular_file()) files.push_back(entry.path());
      }
      std::sort(files.begin(), files.end());
    }
    for (const std::filesystem::path& file : files) seeds.push_back(contents_of(file));
  }
  return seeds;
}

List<std::string> usual_seeds(Target target, const std::string& source_folder) {
  List<std::string> paths = {source_folder + "/tests/fuzz/corpus/" +
                             target_names()[static_cast<int>(target)]};
  if (target == Target::scene) paths.push_back(source_folder + "/lessons/scenes");
  if (target == Target::frozen) paths.push_back(source_folder + "/tests/frozen/problems");
  List<std::string> seeds = read_seeds(paths);
  List<std::string> more;
  if (target == Target::words) more = word_seeds();
  if (target == Target::world) {
    for (std::uint64_t number = 0; number < usual_worlds; ++number) more.push_back(world_bytes(number));
  }
  seeds.insert(seeds.end(), more.begin(), more.end());
  return seeds;
}

}  // namespace cairn::fuzz
