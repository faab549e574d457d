// Threads that share pieces of work.
#include "solvers/wide/lane_threads.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "math/list.hpp"

using namespace cairn;

namespace {

/// How often each piece was done, over so many rounds.
List<int> times_done(LaneThreads& threads, int pieces, int rounds) {
  List<int> times(pieces);
  for (int round = 0; round < rounds; ++round) {
    threads.share(pieces, [&](int i) { times[i] += 1; });
  }
  return times;
}

/// Whether two pieces can be at work at the same time: each waits for the other, for ten seconds at most.
bool works_side_by_side(LaneThreads& threads) {
  std::atomic<int> begun = 0, met = 0;
  threads.share(2, [&](int) {
    ++begun;
    const auto late = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (begun < 2 && std::chrono::steady_clock::now() < late) std::this_thread::yield();
    if (begun == 2) ++met;
  });
  return met == 2;
}

}  // namespace

TEST_CASE("threads do every piece once, round after round, however many there are of either") {
  for (const int count : {1, 2, 3, 7, 64}) {
    LaneThreads threads(count);
    for (const int pieces : {0, 1, 2, 5, 200}) {
      CAPTURE(count);
      CAPTURE(pieces);
      CHECK(times_done(threads, pieces, 300) == List<int>(pieces, 300));
    }
  }
}

TEST_CASE("two threads work side by side, also after they slept, and in copies and where they were moved") {
  LaneThreads threads(2);
  CHECK(works_side_by_side(threads));
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  CHECK(works_side_by_side(threads));
  LaneThreads copy = threads;
  CHECK(works_side_by_side(copy));
  LaneThreads moved = std::move(threads);
  CHECK(works_side_by_side(moved));
  LaneThreads other(1);
  other = copy;
  CHECK(works_side_by_side(other));
  other = LaneThreads(3);
  CHECK(works_side_by_side(other));
  CHECK(times_done(other, 100, 10) == List<int>(100, 10));
}

TEST_CASE("what the caller wrote before is seen by every thread, and what threads wrote is seen after") {
  LaneThreads threads(3);
  List<long> numbers(1000);
  for (long round = 1; round <= 200; ++round) {
    const long before = round;
    threads.share(numbers.size(), [&](int i) { numbers[i] += before * i; });
    long sum = 0;
    for (const long number : numbers) sum += number;
    // 1 + 2 + ... + 999, times 1 + 2 + ... + round
    CHECK(sum == 499500 * (round * (round + 1) / 2));
  }
}

TEST_CASE("several callers at once have threads of their own each") {
  List<int> wrong(4);
  {
    List<std::jthread> callers;
    for (int caller = 0; caller < wrong.size(); ++caller) {
      callers.emplace_back([&wrong, caller] {
        LaneThreads threads(2);
        if (times_done(threads, 50, 500) != List<int>(50, 500)) wrong[caller] = 1;
      });
    }
  }
  CHECK(wrong == List<int>(4, 0));
}
