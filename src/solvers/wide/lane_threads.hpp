// Floor 4. Threads that share the batches of a colour.
#pragma once

#include <memory>
#include <utility>

namespace cairn {

/// Shares pieces of work among threads, which it keeps for the next ones. A thread begins with pieces of its
/// own, the same ones each time: so what they read is still in its cache. Then it takes those that others
/// have not begun: where the processor has no time for a thread, nobody waits for it but for the piece that
/// it is at. Threads that find nothing to do for some microseconds sleep.
class LaneThreads {
 public:
  /// So many, the caller's among them. The others begin with the first work; the system may give fewer.
  explicit LaneThreads(int count);
  ~LaneThreads();
  /// A copy begins threads of its own.
  LaneThreads(const LaneThreads& other);
  /// Keeps its threads, where it is to have as many.
  LaneThreads& operator=(const LaneThreads& other);
  /// Takes the threads over. The other one begins new ones if it has to.
  LaneThreads(LaneThreads&& other) noexcept;
  /// Takes the threads over.
  LaneThreads& operator=(LaneThreads&& other) noexcept;

  /// Calls `piece(i)` once for each i from 0 to `pieces` - 1, in any order and on any thread, and returns
  /// when all are done. It must not throw.
  template <typename Piece>
  void share(int pieces, const Piece& piece) {
    const auto call = [](const void* work, int i) { (*static_cast<const Piece*>(work))(i); };
    share(pieces, call, &piece);
  }

 private:
  using Call = void (*)(const void* work, int piece);
  class Crew;

  void share(int pieces, Call call, const void* work);

  int count_ = 1;
  std::unique_ptr<Crew> crew_;  // where there was work for more than one
};

}  // namespace cairn
