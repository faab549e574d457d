// Floor 0. Giving a long computation up.
#include <cairn/math/deadline.hpp>

#include <algorithm>

namespace cairn {

thread_local Deadline::Clock::time_point Deadline::end_ = Clock::time_point::max();

TimeUp::TimeUp() : std::runtime_error("stopped when its time was up") {}

Deadline::Deadline(double seconds) : outside_(end_) {
  const double longest = 1e6;  // [s] which the clock can count
  if (!(seconds > 0 && seconds < longest)) return;
  const auto wait = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  end_ = std::min(outside_, Clock::now() + wait);
}

Deadline::~Deadline() { end_ = outside_; }

void Deadline::go_on() {
  if (end_ != Clock::time_point::max() && Clock::now() >= end_) throw TimeUp();
}

}  // namespace cairn
