// Floor 4. Pieces are claimed by counting down, without locks.
#include "solvers/wide/lane_threads.hpp"

#include <atomic>
#include <cstdint>
#include <system_error>
#include <thread>

#include "math/list.hpp"

namespace cairn {

namespace {

// How often an idle thread looks before it sleeps: 50 to 200 microseconds, by processor. The next colour has
// work for it sooner, and to wake it takes about as long.
const int looks_before_sleep = 4000;

void pause() {
#ifdef __x86_64__
  __builtin_ia32_pause();
#endif
}

}  // namespace

/// Threads at work. All that they share is atomic, or written before pieces can be claimed and read by
/// whoever has claimed one: until that one is done, nothing is written again.
class LaneThreads::Crew {
 public:
  explicit Crew(int count) : parts_(count) {
    threads_.reserve(count - 1);
    try {
      for (int me = 1; me < count; ++me) threads_.emplace_back([this, me] { serve(me); });
    } catch (const std::system_error&) {  // those that began will do, and so would none
    }
  }

  ~Crew() {
    is_over_.store(true);
    wake();
  }

  void share(int pieces, Call call, const void* work) {
    unfinished_.store(pieces, std::memory_order_relaxed);
    ++round_;
    const std::int64_t count = parts_.size();
    for (int k = 0; k < parts_.size(); ++k) {
      Part& part = parts_[k];
      const int begin = static_cast<int>(pieces * k / count);
      part.end = static_cast<int>(pieces * (k + 1) / count);
      part.call = call;
      part.work = work;
      part.left.store(round_ << 32 | static_cast<std::uint64_t>(part.end - begin));
    }
    if (sleepers_.load() > 0) wake();
    take_part(0);
    for (int looks = 0; unfinished_.load(std::memory_order_acquire) > 0; ++looks) {
      if (looks < looks_before_sleep) {
        pause();
      } else {
        std::this_thread::yield();
      }
    }
  }

 private:
  /// The pieces that one thread begins with, in a cache line of its own. The upper half of `left` counts
  /// rounds: whoever looked at it in an earlier one claims nothing.
  struct alignas(64) Part {
    std::atomic<std::uint64_t> left = 0;
    int end = 0;
    Call call = nullptr;
    const void* work = nullptr;
  };

  void wake() {
    calls_.fetch_add(1);
    calls_.notify_all();
  }

  void serve(int me) {
    std::uint64_t round = 0;
    while (!is_over_.load()) {
      wait_for_other_than(round, parts_[me]);
      round = parts_[me].left.load() >> 32;
      take_part(me);
    }
  }

  /// Whoever shares looks for sleepers after the new round is there, whoever sleeps looks for a new round
  /// after it can be seen: one of the two sees the other.
  void wait_for_other_than(std::uint64_t round, const Part& part) {
    for (int looks = 0; looks < looks_before_sleep; ++looks) {
      if (part.left.load(std::memory_order_acquire) >> 32 != round) return;
      pause();
    }
    const std::uint32_t calls = calls_.load();
    sleepers_.fetch_add(1);
    if (part.left.load() >> 32 == round && !is_over_.load()) calls_.wait(calls);
    sleepers_.fetch_sub(1);
  }

  /// Its own pieces first.
  void take_part(int me) {
    for (int k = me; k < parts_.size(); ++k) take(parts_[k]);
    for (int k = 0; k < me; ++k) take(parts_[k]);
  }

  void take(Part& part) {
    int done = 0;
    std::uint64_t left = part.left.load(std::memory_order_acquire);
    while (static_cast<std::uint32_t>(left) > 0) {
      if (!part.left.compare_exchange_weak(left, left - 1, std::memory_order_acq_rel,
                                           std::memory_order_acquire)) {
        continue;
      }
      part.call(part.work, part.end - static_cast<int>(static_cast<std::uint32_t>(left)));
      ++done;
      left = part.left.load(std::memory_order_acquire);
    }
    if (done > 0) unfinished_.fetch_sub(done, std::memory_order_release);
  }

  List<Part> parts_;  // one for each thread, the caller's first
  std::uint64_t round_ = 0;
  alignas(64) std::atomic<int> unfinished_ = 0;
  alignas(64) std::atomic<int> sleepers_ = 0;
  std::atomic<std::uint32_t> calls_ = 0;
  std::atomic<bool> is_over_ = false;
  List<std::jthread> threads_;  // last: they end before what they read
};

LaneThreads::LaneThreads(int count) : count_(count) {}
LaneThreads::~LaneThreads() = default;
LaneThreads::LaneThreads(const LaneThreads& other) : count_(other.count_) {}
LaneThreads::LaneThreads(LaneThreads&& other) noexcept = default;
LaneThreads& LaneThreads::operator=(LaneThreads&& other) noexcept = default;

LaneThreads& LaneThreads::operator=(const LaneThreads& other) {
  if (count_ != other.count_) crew_.reset();
  count_ = other.count_;
  return *this;
}

void LaneThreads::share(int pieces, Call call, const void* work) {
  if (count_ == 1) {
    for (int i = 0; i < pieces; ++i) call(work, i);
    return;
  }
  if (!crew_) crew_ = std::make_unique<Crew>(count_);
  crew_->share(pieces, call, work);
}

}  // namespace cairn
