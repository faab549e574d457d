// Floor 0. Only sums, products, quotients and square roots, which IEEE 754 rounds alike everywhere.
#include <cairn/math/elementary.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace cairn {

namespace {

__extension__ using Unsigned128 = unsigned __int128;
__extension__ using Signed128 = __int128;

/// A number in two parts, the second far below the first's last place.
struct TwoParts {
  double high = 0;
  double low = 0;
};

const TwoParts quarter_turn = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};  // pi/2 in 106 bits

/// What an angle has beyond its nearest whole number of quarter turns.
struct Remainder {
  TwoParts angle;      // [rad] in [-pi/4, pi/4]
  unsigned turns = 0;  // quarter turns, modulo four
};

/// 64 bits of zero, and then the binary digits of 2/pi.
constexpr std::array<std::uint64_t, 20> two_over_pi = {
    0x0000000000000000, 0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041, 0xfe5163abdebbc561,
    0xb7246e3a424dd2e0, 0x06492eea09d1921c, 0xfe1deb1cb129a73e, 0xe88235f52ebb4484, 0xe99c7026b45f7e41,
    0x3991d639835339f4, 0x9c845f8bbdf9283b, 0x1ff897ffde05980f, 0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7,
    0x4f463f669e5fea2d, 0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab};

/// 64 of its digits, from digit `first` on.
std::uint64_t digits_of_two_over_pi(int first) {
  const auto word = static_cast<unsigned>(first) / 64, shift = static_cast<unsigned>(first) % 64;
  const std::uint64_t next = shift == 0 ? 0 : two_over_pi[word + 1] >> (64 - shift);
  return two_over_pi[word] << shift | next;
}

/// Of an angle of at least 2^-10, by Payne and Hanek (1983): digits of 2/pi that only give whole turns are
/// left out, and 192 others leave an error of 2^-137 quarter turns. No double lies within 2^-62 of a multiple
/// of pi/2.
Remainder remainder_by_digits(double size) {
  const auto bits = std::bit_cast<std::uint64_t>(size);
  const std::uint64_t mantissa = (bits & 0xfffffffffffff) | 0x10000000000000;
  const int exponent = static_cast<int>(bits >> 52) - 1075;  // size = mantissa 2^exponent
  const int first = exponent + 62;                           // the digit that gives quarter turns times two
  const Unsigned128 low = Unsigned128(mantissa) * digits_of_two_over_pi(first + 128);
  const Unsigned128 middle = Unsigned128(mantissa) * digits_of_two_over_pi(first + 64) + (low >> 64);
  const Unsigned128 high = ((Unsigned128(mantissa) * digits_of_two_over_pi(first)) << 64) + middle;
  const Unsigned128 fraction = high << 2 | (static_cast<std::uint64_t>(low) >> 62);  // of a quarter turn
  const bool is_over_half = fraction >> 127 != 0;
  const auto rest = static_cast<Signed128>(fraction);  // beyond the nearest: above a half it is negative
  const auto head = static_cast<double>(rest);
  const double tail = static_cast<double>(rest - static_cast<Signed128>(head));
  const double product = head * quarter_turn.high;
  const double rounding = std::fma(head, quarter_turn.high, -product);
  return {.angle = {product * 0x1p-128,
                    (rounding + (head * quarter_turn.low + tail * quarter_turn.high)) * 0x1p-128},
          .turns = static_cast<unsigned>(high >> 126) + (is_over_half ? 1u : 0u)};
}

/// a - b, and what rounding left out of it (Knuth 1969).
TwoParts exact_difference(double a, double b) {
  const double difference = a - b, of_b = a - difference;
  return {difference, (a - (difference + of_b)) + (of_b - b)};
}

/// Of an angle of zero or more.
Remainder remainder_of(double size) {
  if (size <= quarter_turn.high / 2) return {.angle = {size, 0}};
  if (size < 0x1p20) {
    // pi/2 in parts of 33, 33 and 53 bits: products of the first two with the count are exact.
    const double first = 0x1.921fb54400000p+0, second = 0x1.0b4611a600000p-34, third = 0x1.3198a2e037073p-69;
    const auto turns = static_cast<int>(size * (1 / quarter_turn.high) + 0.5);
    const TwoParts left = exact_difference(size - turns * first, turns * second);
    const double low = left.low - turns * third, high = left.high + low;
    // The product with the third is off by 2^-122 of the count, and so is the third itself.
    if (std::abs(high) >= turns * 0x1p-60) {
      return {.angle = {high, left.high - high + low}, .turns = static_cast<unsigned>(turns)};
    }
  }
  return remainder_by_digits(size);
}

/// Taylor's series up to x^17: what is left out is below 2^-62 of the sine up to pi/4.
double sine_near_zero(const TwoParts& x) {
  const double z = x.high * x.high, zz = z * z;
  const double series =
      (-1.0 / 6 + z * (1.0 / 120)) + zz * ((-1.0 / 5040 + z * (1.0 / 362880)) +
                                           zz * ((-1.0 / 39916800 + z * (1.0 / 6227020800)) +
                                                 zz * (-1.0 / 1307674368000 + z * (1.0 / 355687428096000))));
  return x.high + (x.high * z * series + x.low * (1 - z / 2));
}

/// Taylor's series up to x^16: what is left out is below 2^-58.
double cosine_near_zero(const TwoParts& x) {
  const double z = x.high * x.high, zz = z * z, half = z / 2, most = 1 - half;
  const double series =
      (1.0 / 24 - z * (1.0 / 720)) +
      zz * ((1.0 / 40320 - z * (1.0 / 3628800)) +
            zz * ((1.0 / 479001600 - z * (1.0 / 87178291200)) + zz * (1.0 / 20922789888000)));
  return most + ((1 - most - half) + (zz * series - x.high * x.low));
}

/// The arc tangents of k/8, in two parts each.
constexpr std::array<TwoParts, 9> arcs_of_eighths = {{{0, 0},
                                                      {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                                      {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                                      {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                                      {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                                      {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                                      {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                                      {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                                      {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};

/// The arc tangent of a number in [0, 1]: that of the nearest eighth, and a series for the rest, which is at
/// most 1/16.
TwoParts arc_up_to_one(double slope) {
  const auto eighth = static_cast<unsigned>(8 * slope + 0.5);
  const double from = eighth / 8.0, rest = (slope - from) / (1 + slope * from), z = rest * rest;
  const double series =
      -1.0 / 3 + z * (1.0 / 5 + z * (-1.0 / 7 + z * (1.0 / 9 + z * (-1.0 / 11 + z * (1.0 / 13)))));
  const TwoParts& arc = arcs_of_eighths[eighth];
  return {arc.high, arc.low + (rest + rest * z * series)};
}

}  // namespace

CosineAndSine<double> cosine_and_sine(double angle) {
  if (!std::isfinite(angle)) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none};
  }
  const Remainder left = remainder_of(std::abs(angle));
  const double near_cosine = cosine_near_zero(left.angle), near_sine = sine_near_zero(left.angle);
  const bool is_odd = left.turns % 2 == 1;
  const bool is_back = left.turns % 4 == 1 || left.turns % 4 == 2, is_below = left.turns % 4 >= 2;
  const double c = is_odd ? near_sine : near_cosine, s = is_odd ? near_cosine : near_sine;
  return {.cosine = is_back ? -c : c, .sine = is_below != std::signbit(angle) ? -s : s};
}

CosineAndSine<float> cosine_and_sine(float angle) {
  const CosineAndSine<double> wide = cosine_and_sine(static_cast<double>(angle));
  return {static_cast<float>(wide.cosine), static_cast<float>(wide.sine)};
}

double tangent(double angle) {
  const CosineAndSine<double> both = cosine_and_sine(angle);
  return both.sine / both.cosine;
}

double arc_tangent(double y, double x) {
  const double across = std::abs(x), up = std::abs(y), larger = std::max(across, up);
  const double slope = larger == 0 ? 0 : across == up ? 1 : std::min(across, up) / larger;
  if (!(slope <= 1)) return std::numeric_limits<double>::quiet_NaN();
  const TwoParts arc = arc_up_to_one(slope);
  const double sign = (up > across) == std::signbit(x) ? 1 : -1;  // of the arc beyond whole quarter turns
  const int turns = up > across ? 1 : std::signbit(x) ? 2 : 0;
  const double angle =
      turns * quarter_turn.high + (sign * arc.high + (turns * quarter_turn.low + sign * arc.low));
  return std::copysign(angle, y);
}

double arc_sine(double sine) { return arc_tangent(sine, std::sqrt((1 - sine) * (1 + sine))); }

double arc_cosine(double cosine) { return arc_tangent(std::sqrt((1 - cosine) * (1 + cosine)), cosine); }

double hypotenuse(double x, double y) {
  const double larger = std::max(std::abs(x), std::abs(y));
  const double scale = larger > 0x1p500 ? 0x1p-600 : larger < 0x1p-500 ? 0x1p600 : 1;
  x *= scale;
  y *= scale;
  return std::sqrt(x * x + y * y) / scale;
}

float hypotenuse(float x, float y) {
  const auto wide_x = static_cast<double>(x), wide_y = static_cast<double>(y);
  return static_cast<float>(std::sqrt(wide_x * wide_x + wide_y * wide_y));
}

}  // namespace cairn
