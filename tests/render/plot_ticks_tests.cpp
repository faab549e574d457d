// Ticks of charts, logarithmic axes, and places that move apart.
#include <cstdint>

#include "render/pictures.hpp"
#include "render/plot_parts.hpp"

namespace {

using cairn::List;
using namespace cairn::render;

/// splitmix64, as a number in [0, 1).
double next_plot_number(std::uint64_t& state) {
  state += 0x9e3779b97f4a7c15U;
  std::uint64_t z = state;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
}

bool is_plain_step(double step) {
  const double mantissa = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
  return std::min({std::abs(mantissa - 1), std::abs(mantissa - 2), std::abs(mantissa - 5)}) < 1e-6;
}

}  // namespace

TEST_CASE("round ticks lie inside the range, at steps of 1, 2 or 5 times a power of ten") {
  std::uint64_t state = 1;
  for (int trial = 0; trial < 500; ++trial) {
    const double size = std::pow(10.0, 16 * next_plot_number(state) - 8);
    const double min = size * (4 * next_plot_number(state) - 2);
    const double max = min + size * (0.01 + next_plot_number(state));
    const int count = 2 + static_cast<int>(9 * next_plot_number(state));
    const List<double> ticks = round_ticks(min, max, count);
    CAPTURE(min);
    CAPTURE(max);
    REQUIRE(ticks.size() <= count);
    // Steps grow by at most 2.5: of `count` at least a third is used, and of few at least none.
    REQUIRE(ticks.size() > count / 2.5 - 2);
    const double slack = 1e-6 * (max - min);
    for (const double tick : ticks) REQUIRE((tick >= min - slack && tick <= max + slack));
    for (int i = 1; i < ticks.size(); ++i) {
      REQUIRE(ticks[i] - ticks[i - 1] == doctest::Approx(ticks[1] - ticks[0]).epsilon(1e-6));
    }
    if (ticks.size() > 1) REQUIRE(is_plain_step(ticks[1] - ticks[0]));
  }
}

TEST_CASE("round ticks are the numbers a person would write") {
  CHECK(round_ticks(0, 1, 6) == List<double>{0, 0.2, 0.4, 0.6, 0.8, 1});
  CHECK(round_ticks(0, 10, 3) == List<double>{0, 5, 10});
  CHECK(round_ticks(-1, 1, 5) == List<double>{-1, -0.5, 0, 0.5, 1});
  CHECK(round_ticks(0.13, 0.41, 4) == List<double>{0.2, 0.3, 0.4});
  CHECK(round_ticks(1200, 4700, 8) == List<double>{1500, 2000, 2500, 3000, 3500, 4000, 4500});
}

TEST_CASE("a range that is none has no ticks") {
  CHECK(round_ticks(1, 1, 5).empty());
  CHECK(round_ticks(2, 1, 5).empty());
  CHECK(round_ticks(std::numeric_limits<double>::quiet_NaN(), 1, 5).empty());
  CHECK(round_ticks(-1.7e308, 1.7e308, 5).empty());
  CHECK(round_ticks(1e16, 1e16 + 2, 5).empty());  // neighbouring doubles: ticks would not differ
  CHECK(decade_ticks(0, 1, 5).empty());
  CHECK(decade_ticks(-1, 1, 5).empty());
  CHECK(decade_ticks(1, std::numeric_limits<double>::quiet_NaN(), 5).empty());
}

TEST_CASE("decades are thinned evenly and keep 1") {
  CHECK(decade_ticks(1e-4, 1, 5).size() == 5);
  CHECK(decade_ticks(3e-3, 40, 9).size() == 4);  // 0.01, 0.1, 1, 10
  const List<double> thinned = decade_ticks(1e-12, 1, 5);
  REQUIRE(thinned.size() == 5);
  for (int i = 0; i < 5; ++i) {
    CHECK(std::log10(thinned[i]) == doctest::Approx(-12.0 + 3.0 * i));
  }
  for (int count = 1; count < 12; ++count) {
    CHECK(static_cast<int>(decade_ticks(1e-200, 1e200, count).size()) <= count);
  }
}

TEST_CASE("a logarithmic axis of few decades has ticks at 2 and 5, a long one or a small one has not") {
  AxisView axis{.scale = AxisScale::logarithmic, .range = {3, 300}};
  set_ticks(axis, 8);
  CHECK(axis.ticks == List<double>{5, 10, 20, 50, 100, 200});
  CHECK(axis.labels == List<std::string>{"5", "10", "20", "50", "100", "200"});
  set_ticks(axis, 5);  // no room for six
  CHECK(axis.ticks == List<double>{10, 100});
  axis.range = {1e-3, 1};
  set_ticks(axis, 30);
  CHECK(axis.ticks.size() == 4);
}

TEST_CASE("on a logarithmic axis the geometric mean stands in the middle") {
  AxisView axis{.scale = AxisScale::logarithmic, .range = {1e-4, 1}, .from = 100, .to = 500};
  CHECK(axis.pixel(1e-4) == doctest::Approx(100));
  CHECK(axis.pixel(1e-2) == doctest::Approx(300));
  CHECK(axis.pixel(1) == doctest::Approx(500));
}

TEST_CASE("places move apart by no more than they must, and keep their order") {
  CHECK(moved_apart({10, 50, 90}, 20, 0, 100) == List<double>{10, 50, 90});
  CHECK(moved_apart({50, 50}, 20, 0, 100) == List<double>{40, 60});
  CHECK(moved_apart({95, 98}, 20, 0, 100) == List<double>{80, 100});
  CHECK(moved_apart({}, 20, 0, 100).empty());
  const List<double> crowd = moved_apart({10, 12, 14, 16}, 30, 0, 60);  // no room: still apart
  for (int i = 1; i < crowd.size(); ++i) CHECK(crowd[i] - crowd[i - 1] == doctest::Approx(30));
}

TEST_CASE("where there is room for two ticks, some decades are never left with one") {
  for (int last = -3; last < 9; ++last) {
    for (int count = 2; count < 5; ++count) {
      CHECK(decade_ticks(std::pow(10.0, -4), std::pow(10.0, last), count).size() >= 2);
    }
  }
}
