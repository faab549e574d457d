// Deadlines: what ends, when, and what is not touched.
#include <cairn/math/deadline.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <thread>

using cairn::Deadline;
using cairn::TimeUp;

TEST_CASE("a computation ends once its time is up, and no sooner") {
  Deadline::go_on();
  {
    const Deadline deadline(1e-9);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    CHECK_THROWS_AS(Deadline::go_on(), TimeUp);
  }
  Deadline::go_on();
  const Deadline later(1000);
  Deadline::go_on();
}

TEST_CASE("of deadlines inside each other the earlier holds") {
  const Deadline outside(1e-9);
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
  for (const double seconds : {0.0, 1000.0, 1e300, std::nan("")}) {
    const Deadline inside(seconds);
    CHECK_THROWS_AS(Deadline::go_on(), TimeUp);
  }
  CHECK_THROWS_AS(Deadline::go_on(), TimeUp);
}

TEST_CASE("a deadline is of its thread alone") {
  const Deadline deadline(1e-9);
  bool went_on = false;
  std::thread([&] {
    Deadline::go_on();
    went_on = true;
  }).join();
  CHECK(went_on);
}
