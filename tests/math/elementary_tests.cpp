// Sine, cosine, arcs and lengths of our own, against the C library's in long double, which has 11 bits more
// where these tests run: their own errors are below 0.001 units in the last place of a double.
#include <bit>
#include <random>

#include "testing.hpp"

using namespace cairn;

namespace {

/// How far a number is from what it should be, in units in the last place of the latter.
double units_off(double got, long double expected) {
  const auto rounded = static_cast<double>(expected);
  if (got == rounded) return 0;
  int exponent = 0;
  std::frexp(rounded, &exponent);
  const long double unit = std::ldexp(1.0L, std::max(exponent - 53, -1074));
  return static_cast<double>(std::abs(static_cast<long double>(got) - expected) / unit);
}

bool is_good(double angle) {
  const auto exact = static_cast<long double>(angle);
  const CosineAndSine<double> both = cosine_and_sine(angle);
  return units_off(both.cosine, std::cos(exact)) < 1 && units_off(both.sine, std::sin(exact)) < 1 &&
         units_off(tangent(angle), std::tan(exact)) < 2.5;
}

/// Of all doubles alike, from the least to the largest.
double any_double(std::mt19937_64& random) {
  while (true) {
    const auto number = std::bit_cast<double>(random());
    if (std::isfinite(number)) return number;
  }
}

}  // namespace

TEST_CASE("Sine and cosine are within a unit in the last place, at angles of any size") {
  std::mt19937_64 random(1);
  int bad = 0;
  for (int i = 0; i < 100000; ++i) bad += is_good(any_double(random)) ? 0 : 1;
  for (const double range : {0.8, 4.0, 100.0, 1e4, 2e6, 1e9, 1e18}) {
    std::uniform_real_distribution<double> angle(-range, range);
    for (int i = 0; i < 20000; ++i) bad += is_good(angle(random)) ? 0 : 1;
  }
  CHECK(bad == 0);
  CHECK(sine(0) == 0);
  CHECK(std::signbit(sine(-0.0)));
  CHECK(cosine(0) == 1);
  CHECK(sine(std::numeric_limits<double>::denorm_min()) == std::numeric_limits<double>::denorm_min());
  for (const double none :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(std::isnan(sine(none)));
    CHECK(std::isnan(cosine(-none)));
  }
}

TEST_CASE("Sine and cosine keep their digits beside multiples of a quarter turn") {
  int bad = 0;
  for (int turns = 1; turns < 100000; ++turns) {
    const auto near = static_cast<double>(turns * (std::numbers::pi_v<long double> / 2));
    for (const double angle : {std::nextafter(near, 0.0), near, std::nextafter(near, 1e300)}) {
      bad += is_good(angle) ? 0 : 1;
    }
  }
  CHECK(bad == 0);
  // Of all doubles this one is nearest to a multiple of pi/2 (Kahan 1983): 2^-61 of a turn.
  CHECK(is_good(6381956970095103.0 * 0x1p797));
  CHECK(cosine(6381956970095103.0 * 0x1p797) == doctest::Approx(-4.68716592425462761112e-19).epsilon(1e-15));
}

TEST_CASE("A float's sine and cosine are a double's, rounded") {
  for (const float angle : {0.0f, 0.3f, -2.0f, 1e4f, -3e30f}) {
    const CosineAndSine<float> both = cosine_and_sine(angle);
    CHECK(both.cosine == static_cast<float>(std::cos(static_cast<long double>(angle))));
    CHECK(both.sine == static_cast<float>(std::sin(static_cast<long double>(angle))));
  }
}

TEST_CASE("Arcs are within the units that their comments name, and lengths within 2^-52 of themselves") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> number(-1, 1);
  int bad = 0;
  for (int i = 0; i < 100000; ++i) {
    double x = number(random), y = number(random);
    if (i % 2 == 1) y = std::ldexp(y, static_cast<int>(random() % 600) - 300);
    if (i % 10 == 9) x = any_double(random), y = any_double(random);
    const auto exact_x = static_cast<long double>(x), exact_y = static_cast<long double>(y);
    bad += units_off(arc_tangent(y, x), std::atan2(exact_y, exact_x)) < 3 ? 0 : 1;
    const long double length = std::hypot(exact_x, exact_y);
    if (length <= static_cast<long double>(std::numeric_limits<double>::max())) {
      const long double off = std::abs(static_cast<long double>(hypotenuse(x, y)) - length);
      bad += off <= std::max(0x1p-52L * length, 0x1p-1074L) ? 0 : 1;
    }
    if (!(std::abs(x) <= 1)) continue;
    bad += units_off(arc_sine(x), std::asin(exact_x)) < 4 ? 0 : 1;
    bad += units_off(arc_cosine(x), std::acos(exact_x)) < 4 ? 0 : 1;
  }
  CHECK(bad == 0);
  CHECK(std::isnan(arc_sine(1.5)));
  CHECK(std::isnan(hypotenuse(std::numeric_limits<double>::quiet_NaN(), 1)));
}

TEST_CASE("The arc tangent's signs and ends are those of IEEE 754's atan2") {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double y : {0.0, 1.0, infinite}) {
    for (const double x : {0.0, 1.0, infinite}) {
      for (const double up : {y, -y}) {
        for (const double across : {x, -x}) {
          CAPTURE(up);
          CAPTURE(across);
          CHECK(arc_tangent(up, across) == std::atan2(up, across));
          CHECK(std::signbit(arc_tangent(up, across)) == std::signbit(up));
        }
      }
    }
  }
}

TEST_CASE("A dot product of three adds in the same order everywhere") {
  // Half a unit in the last place vanishes beside 1, but not where the two small ones are added first.
  const Vec3<double> ones = Vec3<double>::Ones();
  CHECK(dot<double>(ones, {1, 0x1p-53, 0x1p-53}) == 1);
  CHECK(dot<double>(ones, {0x1p-53, 0x1p-53, 1}) == 1 + 0x1p-52);
  const Vec3<float> wide = Vec3<float>::Ones();
  CHECK(dot<float>(wide, {1, 0x1p-24f, 0x1p-24f}) == 1 + 0x1p-23f);
  CHECK(dot<float>(wide, {0x1p-24f, 0x1p-24f, 1}) == 1);
}
