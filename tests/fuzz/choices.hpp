// Choices made of bytes, so that whatever makes bytes makes choices.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace cairn::fuzz {

/// Two bytes for each choice. Once they are used up, it is always the first of all that there are.
class Choices {
 public:
  explicit Choices(std::string bytes) : bytes_(std::move(bytes)) {}

  bool are_left() const { return next_ < bytes_.size(); }
  /// From 0 to count - 1.
  int below(int count) { return take() % count; }
  bool one_in(int count) { return below(count) == count - 1; }
  /// From low to high, one of 10,001 numbers.
  double between(double low, double high) { return low + (high - low) * (take() % 10001) / 10000.0; }

 private:
  int take() {
    const auto byte = [this](std::size_t place) {
      return place < bytes_.size() ? static_cast<int>(static_cast<unsigned char>(bytes_[place])) : 0;
    };
    const int number = byte(next_) + 256 * byte(next_ + 1);
    next_ = std::min(next_ + 2, bytes_.size());
    return number;
  }

  std::string bytes_;
  std::size_t next_ = 0;
};

}  // namespace cairn::fuzz
