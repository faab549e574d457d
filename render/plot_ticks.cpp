// Ranges of axes, round ticks, decades, and what is written at them.
#include <algorithm>
#include <cmath>

#include <cairn/math/list.hpp>
#include "render/plot_parts.hpp"

namespace cairn::render {
namespace {

constexpr double slack = 1e-9;  // [steps] a tick that is beyond the range by rounding only is inside

/// mantissa * 10^exponent, mantissa 1, 2 or 5.
struct Step {
  int mantissa = 1;
  int exponent = 0;
};

// Division where the power is negative: 3 steps of 0.1 are 0.3, and not 0.30000000000000004.
double times(double count, const Step& step) {
  const double power = std::pow(10.0, std::abs(step.exponent));
  return step.exponent < 0 ? count * step.mantissa / power : count * step.mantissa * power;
}

/// The steps inside a range, as whole numbers.
struct Steps {
  double first = 0;
  double last = -1;
  double count() const { return last - first + 1; }
};

Steps inside(const Range& range, const Step& step) {
  const double size = times(1, step);
  return {std::ceil(range.min / size - slack), std::floor(range.max / size + slack)};
}

Steps around(const Range& range, const Step& step) {
  const double size = times(1, step);
  return {std::floor(range.min / size + slack), std::ceil(range.max / size - slack)};
}

// The smallest step of which at most `count` are found.
template <typename Find>
Step smallest_step(const Range& range, int count, Find find) {
  const int start = static_cast<int>(std::floor(std::log10((range.max - range.min) / count))) - 1;
  for (int exponent = std::max(start, -300);; ++exponent) {
    for (const int mantissa : {1, 2, 5}) {
      const Step step{mantissa, exponent};
      if (find(range, step).count() <= count || exponent > 300) return step;
    }
  }
}

bool spans(double min, double max) {
  // Closer than this, the ticks would not be different numbers.
  return std::isfinite(max - min) && max - min > 1e-12 * std::max(std::abs(min), std::abs(max)) &&
         max - min > 1e-290;
}

std::string power_of_ten(int exponent) {
  if (exponent == 0) return "1";
  if (exponent == 1) return "10";
  return "10^{" + fixed(exponent, 0) + "}";
}

List<std::string> linear_labels(const List<double>& ticks) {
  if (ticks.empty()) return {};
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : std::abs(ticks[0]);
  const double largest = std::max(std::abs(ticks.front()), std::abs(ticks.back()));
  const bool plain = largest == 0 || (largest < 1e5 && step > 0.9e-3);
  const int exponent = plain ? 0 : static_cast<int>(std::floor(std::log10(largest) + slack));
  const double unit = std::pow(10.0, exponent);
  const int decimals =
      step > 0 ? std::clamp(-static_cast<int>(std::floor(std::log10(step) - exponent + slack)), 0, 12) : 0;
  List<std::string> labels;
  for (const double tick : ticks) {
    const std::string number = fixed(tick / unit, decimals);
    const bool bare = plain || tick == 0;
    labels.push_back(tick == 0 ? "0" : bare ? number : number + "×10^{" + fixed(exponent, 0) + "}");
  }
  return labels;
}

List<std::string> decade_labels(const List<double>& ticks) {
  List<std::string> labels;
  for (const double tick : ticks)
    labels.push_back(power_of_ten(static_cast<int>(std::lround(std::log10(tick)))));
  return labels;
}

/// 1, 2 and 5 times each power of ten inside the range.
List<double> finer_decades(const Range& range) {
  List<double> ticks;
  const int first = static_cast<int>(std::floor(std::log10(range.min)));
  const int last = static_cast<int>(std::floor(std::log10(range.max) + slack));
  for (int exponent = first; exponent <= last; ++exponent) {
    for (const int mantissa : {1, 2, 5}) {
      const double tick = times(1, {mantissa, exponent});
      if (tick >= range.min * (1 - slack) && tick <= range.max * (1 + slack)) ticks.push_back(tick);
    }
  }
  return ticks;
}

// A single value stands in the middle.
Range opened(const Range& range, AxisScale scale) {
  const double middle = 0.5 * range.min + 0.5 * range.max;
  if (scale == AxisScale::logarithmic) {
    return range.max > range.min * (1 + slack) ? range : Range{range.min / 10, range.max * 10};
  }
  if (range.max > range.min && spans(range.min, range.max)) return range;
  const double reach = middle == 0 ? 1 : 0.5 * std::abs(middle);
  return {middle - reach, middle + reach};
}

std::optional<double> given(const std::optional<double>& end, AxisScale scale) {
  return end && plottable(*end, scale) ? end : std::nullopt;
}

}  // namespace

List<double> round_ticks(double min, double max, int count) {
  if (count < 1 || !spans(min, max)) return {};
  const Range range{min, max};
  const Step step = smallest_step(range, count, inside);
  const Steps steps = inside(range, step);
  List<double> ticks;
  for (double i = steps.first; i <= steps.last && ticks.size() < count; ++i) {
    ticks.push_back(i == 0 ? 0 : times(i, step));  // never -0
  }
  return ticks;
}

List<double> decade_ticks(double min, double max, int count) {
  if (count < 1 || !(min > 0) || !(max >= min) || !std::isfinite(max)) return {};
  const int first = static_cast<int>(std::ceil(std::log10(min) - slack));
  const int last = static_cast<int>(std::floor(std::log10(max) + slack));
  for (const int stride : {1, 2, 3, 5, 10, 20, 50, 100, 1000}) {
    List<double> ticks;
    for (int exponent = first; exponent <= last; ++exponent) {
      if (exponent % stride == 0) ticks.push_back(std::pow(10.0, exponent));
    }
    if (ticks.size() > count) continue;
    if (ticks.size() > 1 || first >= last || count < 2) return ticks;
    return {std::pow(10.0, first), std::pow(10.0, last)};  // one tick alone would not tell the scale
  }
  return {};
}

bool plottable(double value, AxisScale scale) {
  // Beyond 1e300 the length of the range itself would overflow.
  return std::abs(value) < 1e300 && (scale == AxisScale::linear || value > 1e-300);
}

Range range_of(const Axis& axis, const List<double>& values) {
  std::optional<double> low;
  std::optional<double> high;
  for (const double value : values) {
    if (!plottable(value, axis.scale)) continue;
    low = std::min(low.value_or(value), value);
    high = std::max(high.value_or(value), value);
  }
  low = given(axis.min, axis.scale) ? axis.min : low;
  high = given(axis.max, axis.scale) ? axis.max : high;
  if (!low && !high) return axis.scale == AxisScale::linear ? Range{0, 1} : Range{0.1, 1};
  const double from = low.value_or(*high);
  const double to = high.value_or(from);
  return opened({std::min(from, to), std::max(from, to)}, axis.scale);
}

Range widened(const Range& range, const Axis& axis, int count) {
  Range wide = range;
  if (axis.scale == AxisScale::logarithmic) {
    wide = {std::pow(10.0, std::floor(std::log10(range.min) + slack)),
            std::pow(10.0, std::ceil(std::log10(range.max) - slack))};
  } else if (spans(range.min, range.max)) {
    const Step step = smallest_step(range, std::max(count, 5), around);
    const Steps steps = around(range, step);
    wide = {times(steps.first, step), times(steps.last, step)};
  }
  if (given(axis.min, axis.scale)) wide.min = range.min;
  if (given(axis.max, axis.scale)) wide.max = range.max;
  return wide;
}

void set_ticks(AxisView& axis, int count) {
  const Range& range = axis.range;
  if (axis.scale == AxisScale::logarithmic) {
    axis.ticks = decade_ticks(range.min, range.max, count);
    axis.labels = decade_labels(axis.ticks);
    if (axis.ticks.size() > 3) return;
    const List<double> finer = finer_decades(range);
    if (finer.size() > axis.ticks.size() && finer.size() > 2 && finer.size() <= count) {
      axis.ticks = finer;
      axis.labels.clear();
      for (const double tick : finer) axis.labels.push_back(significant(tick, 1));
    }
    if (axis.ticks.size() > 1) return;  // less than two decades are read better with round numbers
  }
  axis.ticks = round_ticks(range.min, range.max, count);
  const auto has_no_place = [&axis](double tick) { return !plottable(tick, axis.scale); };
  axis.ticks.erase(std::remove_if(axis.ticks.begin(), axis.ticks.end(), has_no_place), axis.ticks.end());
  axis.labels = linear_labels(axis.ticks);
}

double AxisView::pixel(double value) const {
  if (scale == AxisScale::linear) return from + (to - from) * ((value - range.min) / (range.max - range.min));
  return from + (to - from) * (std::log10(value / range.min) / std::log10(range.max / range.min));
}

}  // namespace cairn::render
