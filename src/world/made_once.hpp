// Floor 5. A value that is made when it is first asked for, by any number of threads at a time.
#pragma once

#include <atomic>
#include <memory>

namespace cairn {

/// Holds what get() has made until it is told to forget it. A copy holds nothing, and makes its own.
template <typename T>
class MadeOnce {
 public:
  /// Holds nothing.
  MadeOnce() = default;
  /// Holds nothing.
  MadeOnce(const MadeOnce&) noexcept {}
  /// Takes over what the other holds.
  MadeOnce(MadeOnce&& other) noexcept : made_(other.made_.exchange(nullptr)) {}
  /// Forgets what it holds.
  MadeOnce& operator=(const MadeOnce&) noexcept {
    forget();
    return *this;
  }
  /// Takes over what the other holds.
  MadeOnce& operator=(MadeOnce&& other) noexcept {
    delete made_.exchange(other.made_.exchange(nullptr));
    return *this;
  }
  /// Forgets what it holds.
  ~MadeOnce() { forget(); }

  /// What it holds, or else what `make()` gives, which it then holds. Threads that come at the same time may
  /// each make it, and all get the one that was ready first: make() gives all of them the same.
  template <typename Make>
  const T& get(const Make& make) const {
    const T* made = made_.load(std::memory_order_acquire);
    if (made != nullptr) return *made;
    auto fresh = std::make_unique<const T>(make());
    if (made_.compare_exchange_strong(made, fresh.get(), std::memory_order_acq_rel)) return *fresh.release();
    return *made;
  }
  /// Only while no other thread asks.
  void forget() noexcept {
    if (made_.load(std::memory_order_relaxed) != nullptr) delete made_.exchange(nullptr);
  }

 private:
  mutable std::atomic<const T*> made_ = nullptr;
};

}  // namespace cairn
