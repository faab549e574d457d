// A grader whose reader has gone wrong, in the way that its first word names. The second is a file for the
// number of a process that it leaves behind.
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "lessons/reader_code/verdict.hpp"

namespace {

volatile int zero = 0;
int* volatile nowhere = nullptr;
int* volatile astray = reinterpret_cast<int*>(0x123456789000);
std::string second_word;

int deep(int depth) {
  volatile char much[4096] = {};
  return depth < 0 ? 0 : deep(depth + 1) + much[depth % 10];
}

void hang() {
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) ::signal(signal, SIG_IGN);
  while (true) usleep(1000);
}

/// Leaves a process in a session of its own, that does not want to end, and waits until it is so far.
void leave_a_child() {
  int ends[2] = {-1, -1};
  char byte = 0;
  if (pipe(ends) != 0) return;
  if (fork() == 0) {
    setsid();
    std::ofstream(second_word) << getpid() << std::endl;
    if (write(ends[1], "x", 1) == 1) hang();
  }
  if (read(ends[0], &byte, 1) != 1) std::abort();
}

void print_much() {
  const std::string line(99, 'x');
  for (int i = 0; i < 100'000; ++i) std::puts(line.c_str());
}

void write_much() {
  const std::string block(1 << 20, 'x');
  for (std::ofstream file(second_word); true;) file << block << std::flush;
}

void take_memory() {
  std::vector<std::vector<double>> all;
  while (true) all.emplace_back(1 << 20);
}

const std::map<std::string, std::function<void()>> misdeeds = {
    {"none", [] {}},
    {"exit", [] { std::exit(0); }},
    {"quick_exit", [] { std::quick_exit(0); }},
    {"_exit", [] { _exit(0); }},
    {"lie", [] { std::puts("ended 0\nPassed."), std::exit(0); }},
    {"other program", [] { execl("/bin/true", "true", nullptr); }},
    {"copy goes on",
     [] {
       if (fork() != 0) usleep(300'000), std::exit(0);
     }},
    {"exit at the end", [] { std::atexit([] { _exit(0); }), std::atexit([] { _exit(7); }); }},
    {"abort", [] { std::abort(); }},
    {"divide", [] { zero = 7 / zero; }},
    {"null", [] { *nowhere = 1; }},
    {"astray", [] { *astray = 1; }},
    {"stack", [] { zero = deep(0); }},
    {"index", [] { std::vector<int>(3)[static_cast<std::size_t>(zero + 3)] = 1; }},
    {"back", [] { std::vector<int>().back() = 1; }},
    {"throw", [] { throw std::runtime_error("no box"); }},
    {"throw a number", [] { throw 5; }},
    {"memory", take_memory},
    {"print", print_much},
    {"print one line",
     [] {
       while (true) std::fputs("xxxxxxxx", stderr);
     }},
    {"file", write_much},
    {"hang", hang},
    {"leave", leave_a_child},
    {"leave and hang", [] { leave_a_child(), hang(); }},
};

}  // namespace

int main(int count, char** words) {
  if (count > 2) second_word = words[2];
  return cairn::reader_code::graded([words] {
    std::puts("graded");
    misdeeds.at(words[1])();
    return std::string(words[1]) == "wrong" ? 1 : 0;
  });
}
