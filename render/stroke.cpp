// Lines and polylines: one quad a segment, neighbours parted at the bisector of their joint, so that noisy
// curves have neither gaps nor doubly drawn joints.
#include <algorithm>
#include <cmath>
#include <optional>

#include <cairn/math/list.hpp>
#include "render/shapes.hpp"

namespace cairn::render {
namespace {

constexpr double shortest_segment = 1e-6;  // [px]
constexpr int most_dashes = 20000;

/// The line a x + b y + c = 0 through the end of a segment. What is positive lies after it.
using Cut = FixedList<float, 3>;

/// With a normal of unit length the cut is smooth. With a steep one every pixel belongs to one side: two
/// neighbours that share the bits of a cut leave no gap and draw nothing twice.
constexpr double smooth = 1;
constexpr double steep = 4096;
// Joints lie on pixel centres more often than chance would have it; there a cut would halve the pixel twice.
constexpr double aside = 1.0 / 1237;  // [px]

Cut cut_through(const Point& point, const Point& normal, double steepness) {
  return {static_cast<float>(steepness * normal.x()), static_cast<float>(steepness * normal.y()),
          static_cast<float>(-steepness * normal.dot(point))};
}

/// None at the joint of a curve that turns straight back on itself: there both segments are drawn whole.
std::optional<Cut> bisector(const Point& joint, const Point& before, const Point& after) {
  const Point sum = before + after;
  const double length = sum.norm();
  if (length < 1e-3) {
    return std::nullopt;
  }
  const Point normal = sum / length;
  return cut_through(joint + aside * normal, normal, steep);
}

/// A run of distinct points; `directions` has one fewer.
struct Run {
  List<Point> points = {};
  List<Point> directions = {};
};

Run run_of(Span<const Point> points) {
  Run run;
  for (const Point& point : points) {
    if (run.points.empty()) {
      run.points.push_back(point);
      continue;
    }
    const Point step = point - run.points.back();
    if (step.norm() > shortest_segment) {
      run.directions.push_back(step.normalized());
      run.points.push_back(point);
    }
  }
  return run;
}

void add_segment(Batch& batch, const Point& from, const Point& to, const std::optional<Cut>& first,
                 const std::optional<Cut>& second, const Stroke& stroke) {
  const double length = (to - from).norm();
  const double half = 0.5 * stroke.width;
  const Point center = 0.5 * (from + to);
  const Point x = (to - from) / length;
  const Point y = perpendicular(x);
  Measure measure = {};
  measure.kind = Kind::box;
  measure.fill = stroke.color;
  measure.local[0] = {x.x(), x.y(), -x.dot(center)};
  measure.local[1] = {y.x(), y.y(), -y.dot(center)};
  measure.shape = {static_cast<float>(0.5 * length), 0, static_cast<float>(half), 0};
  measure.first = first.value_or(measure.first);
  measure.second = second.value_or(measure.second);
  const Point along = (0.5 * length + half + 1) * x;
  const Point across = (half + 1) * y;
  const FixedList<Point, 4> hull = {center - along - across, center + along - across, center + along + across,
                                    center - along + across};
  batch.add(hull, measure);
}

/// A curve that ends where it began has a joint there too.
bool closed(const Run& run) {
  return run.points.size() > 3 && (run.points.front() - run.points.back()).norm() <= shortest_segment;
}

void add_run(Batch& batch, Span<const Point> points, const Stroke& stroke) {
  const Run run = run_of(points);
  const int segments = run.directions.size();
  if (segments == 0) {
    return;
  }
  const auto joint = [&](int i, int before, int after) {
    return bisector(run.points[i], run.directions[before], run.directions[after]);
  };
  const bool loop = closed(run);
  const auto end = [&](int i, int segment) {
    return loop ? joint(0, segments - 1, 0) : cut_through(run.points[i], run.directions[segment], smooth);
  };
  for (int i = 0; i < segments; ++i) {
    const std::optional<Cut> first = i == 0 ? end(0, 0) : joint(i, i - 1, i);
    const std::optional<Cut> second = i + 1 == segments ? end(i + 1, i) : joint(i + 1, i, i + 1);
    add_segment(batch, run.points[i], run.points[i + 1], first, second, stroke);
  }
}

/// Position in a dash pattern that repeats: which entry, and how far into it.
class DashWalker {
 public:
  explicit DashWalker(Span<const double> pattern) : pattern_(pattern.begin(), pattern.end()) {
    if (pattern_.size() % 2 == 1) {
      pattern_.insert(pattern_.end(), pattern.begin(), pattern.end());
    }
    for (const double entry : pattern_) {
      period_ += entry;
    }
  }

  bool drawing() const { return entry_ % 2 == 0; }
  double left() const { return pattern_[entry_] - used_; }
  double period() const { return period_; }

  void walk(double length) {
    length = std::fmod(length, period_);
    while (length >= left()) {
      length -= left();
      used_ = 0;
      entry_ = (entry_ + 1) % pattern_.size();
    }
    used_ += length;
  }

 private:
  List<double> pattern_;
  double period_ = 0;
  int entry_ = 0;
  double used_ = 0;
};

/// The part of a segment inside the bounds, as lengths from its start; equal if there is none.
FixedList<double, 2> visible_part(const Point& from, const Point& direction, double length,
                                  const Rect& bounds) {
  double enter = 0;
  double leave = length;
  const FixedList<double, 2> low = {bounds.x, bounds.y};
  const FixedList<double, 2> high = {bounds.x + bounds.width, bounds.y + bounds.height};
  for (int axis = 0; axis < 2; ++axis) {
    if (std::abs(direction[axis]) < 1e-12) {
      leave = from[axis] < low[axis] || from[axis] > high[axis] ? enter : leave;
      continue;
    }
    const double first = (low[axis] - from[axis]) / direction[axis];
    const double second = (high[axis] - from[axis]) / direction[axis];
    enter = std::max(enter, std::min(first, second));
    leave = std::min(leave, std::max(first, second));
  }
  return {enter, std::max(enter, leave)};
}

/// Collects the drawn parts while it walks along a run.
struct DashCollector {
  DashWalker walker;
  List<List<Point>> parts = {};
  List<Point> current = {};

  void finish() {
    if (current.size() > 1) {
      parts.push_back(current);
    }
    current.clear();
  }

  void skip(double length) {
    if (length > 0) {
      finish();
      walker.walk(length);
    }
  }

  void segment(const Point& from, const Point& direction, double begin, double end) {
    double at = begin;
    while (at < end && parts.size() < most_dashes) {
      const bool drawing = walker.drawing();
      const double step = std::min(walker.left(), end - at);
      if (drawing && current.empty()) {
        current.push_back(from + at * direction);
      }
      at += step;
      const bool finished = step >= walker.left();
      walker.walk(step);
      if (drawing) {
        current.push_back(from + at * direction);
      }
      if (finished) {
        finish();
      }
      if (!(step > 0) && !finished) {
        break;
      }
    }
  }
};

bool sound(Span<const double> pattern) {
  double sum = 0;
  for (const double entry : pattern) {
    if (!usable(entry) || entry < 0) {
      return false;
    }
    sum += entry;
  }
  return sum > 0.1;
}

void add_usable_run(Batch& batch, Span<const Point> points, const Stroke& stroke) {
  if (!sound(stroke.dash)) {
    add_run(batch, points, stroke);
    return;
  }
  const Rect& frame = batch.bounds();
  const double half = 0.5 * stroke.width;
  const Rect seen = {frame.x - half, frame.y - half, frame.width + stroke.width, frame.height + stroke.width};
  for (const List<Point>& part : dashes(points, stroke.dash, seen)) {
    add_run(batch, part, stroke);
  }
}

}  // namespace

List<List<Point>> dashes(Span<const Point> points, Span<const double> pattern, const Rect& bounds) {
  const Run run = run_of(points);
  DashCollector collector = {.walker = DashWalker(pattern)};
  for (int i = 0; i < run.directions.size(); ++i) {
    const double length = (run.points[i + 1] - run.points[i]).norm();
    const FixedList<double, 2> seen = visible_part(run.points[i], run.directions[i], length, bounds);
    if (seen[0] >= seen[1]) {
      collector.skip(length);
      continue;
    }
    collector.skip(seen[0]);
    collector.segment(run.points[i], run.directions[i], seen[0], seen[1]);
    collector.skip(length - seen[1]);
  }
  collector.finish();
  return collector.parts;
}

void add_polyline(Batch& batch, Span<const Point> points, const Stroke& stroke) {
  if (!usable(stroke.width) || !(stroke.width > 0) || stroke.color.a <= 0) {
    return;
  }
  int begin = 0;
  for (int i = 0; i <= points.size(); ++i) {
    if (i == points.size() || !usable(points[i])) {
      if (i > begin + 1) {
        add_usable_run(batch, points.subspan(begin, i - begin), stroke);
      }
      begin = i + 1;
    }
  }
}

}  // namespace cairn::render
