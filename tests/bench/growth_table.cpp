// What it takes to know which shapes are near each other, against their number.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <random>

#include <cairn/collision/near_pairs.hpp>
#include <cairn/math/list.hpp>
#include "measure.hpp"
#include "table.hpp"
#include "tables.hpp"

namespace cairn::bench {

namespace {

constexpr double pace = 0.01;         // [m] that a box moves in a step: 0.6 m/s at 60 Hz
constexpr int steps_one_way = 100;    // then it comes back, so that a heap stays a heap
constexpr double filled_share = 0.7;  // of the room that a heap takes, by its boxes' bounds

/// Boxes of about 1 m on a ground, and how they move.
struct Boxes {
  List<Aabb<double>> bounds = {};
  List<Vec2<double>> velocity = {};  // [m a step]
  List<char> movable = {};
  NearPairs<double> near = {};
  int steps = 0;

  void add(const Vec2<double>& center, const Vec2<double>& half, const Vec2<double>& moves) {
    bounds.push_back({center - half, center + half});
    velocity.push_back(moves);
    movable.push_back(1);
  }
  /// The ground, of that width [m], last.
  void finish(double width) {
    add({0, -0.5}, {width, 0.5}, {0, 0});
    movable[movable.size() - 1] = 0;
    near = NearPairs<double>(BroadphaseKind::grid, movable);
  }
  void step() {
    const double way = (steps++ / steps_one_way) % 2 == 0 ? 1 : -1;
    for (int i = 0; i < bounds.size(); ++i) {
      bounds[i].lower += way * velocity[i];
      bounds[i].upper += way * velocity[i];
    }
    near.update(bounds);
  }
};

/// Boxes of 0.6 to 1.4 m anywhere in a square, each on its own way.
Boxes heap(int count) {
  std::mt19937_64 random(1);
  const auto number = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  Boxes boxes;
  const double side = std::sqrt(count / filled_share);
  for (int i = 0; i < count; ++i) {
    const double angle = number(0, 6.283185307179586);
    const Vec2<double> center(number(-side / 2, side / 2), number(0, side));
    boxes.add(center, {number(0.3, 0.7), number(0.3, 0.7)}, {pace * std::cos(angle), pace * std::sin(angle)});
  }
  boxes.finish(2 * side);
  return boxes;
}

/// Boxes of 1 m side by side, at rest.
Boxes pyramid(int count) {
  Boxes boxes;
  const int base = static_cast<int>(std::sqrt(2.0 * count));
  for (int row = 0; row < base; ++row) {
    for (int k = 0; k < base - row; ++k) boxes.add({k - 0.5 * (base - row), 0.5 + row}, {0.5, 0.5}, {0, 0});
  }
  boxes.finish(base);
  return boxes;
}

/// [s] of all steps there and back: each such time sees the same.
double seconds_of_a_round(Boxes& boxes) {
  const Stopwatch watch;
  for (int i = 0; i < 2 * steps_one_way; ++i) boxes.step();
  return watch.seconds();
}

Case timed(const std::string& name, const Boxes& scene) {
  const auto boxes = std::make_shared<Boxes>(scene);
  seconds_of_a_round(*boxes);  // all memory is touched now
  const std::int64_t rounds = iterations_for(seconds_of_a_round(*boxes));
  const auto run = [boxes](benchmark::State& state) {
    for (auto _ : state) state.SetIterationTime(seconds_of_a_round(*boxes));
  };
  return {.name = name, .run = run, .iterations = rounds, .repetitions = 7};
}

/// The p of time ~ n^p between two sizes.
std::string growth_cell(double time, double next_time, int count, int next_count) {
  return fmt::format("n^{:.2f}",
                     std::log(next_time / time) / std::log(static_cast<double>(next_count) / count));
}

List<Case> timed_scenes(const List<int>& counts) {
  List<Case> cases;
  for (const int count : counts) {
    cases.push_back(timed(fmt::format("heap {}", count), heap(count)));
    cases.push_back(timed(fmt::format("pyramid {}", count), pyramid(count)));
  }
  return cases;
}

}  // namespace

void print_growth_table() {
  print_heading("10. Growth: finding who is near whom, against the number of bodies");
  fmt::print(
      "Boxes of about 1 m: a heap in which each moves {:.0f} mm a step in a direction of its own, and a "
      "pyramid at\n"
      "rest. A step takes in all boxes and brings the list of near pairs up to date. Growth: the p of time ~ "
      "n^p from\n"
      "the line above, and in the last line from first to last.\n\n",
      1000 * pace);
  const List<int> counts = {500, 1000, 2000, 5000, 10'000, 20'000};
  const std::map<std::string, Outcome> outcomes = measure(timed_scenes(counts));
  const auto step_time = [&outcomes](const char* kind, int count) {
    return outcomes.at(fmt::format("{} {}", kind, count)).time.median / (2 * steps_one_way);
  };
  TextTable table({{"bodies", "n"},
                   {"heap", "ns a body"},
                   {"noise", ""},
                   {"growth", ""},
                   {"pyramid", "ns a body"},
                   {"noise", ""},
                   {"growth", ""}});
  for (int i = 0; i < counts.size(); ++i) {
    const int n = counts[i];
    List<std::string> cells = {grouped(n)};
    for (const char* kind : {"heap", "pyramid"}) {
      cells.push_back(three_digits(step_time(kind, n) / n));
      cells.push_back(noise_cell(outcomes.at(fmt::format("{} {}", kind, n)).time));
      cells.push_back(
          i == 0 ? "" : growth_cell(step_time(kind, counts[i - 1]), step_time(kind, n), counts[i - 1], n));
    }
    table.add(cells);
  }
  const int first = counts[0], last = counts[counts.size() - 1];
  const auto over_all = [&](const char* kind) {
    return growth_cell(step_time(kind, first), step_time(kind, last), first, last);
  };
  table.add({"all", "", "", over_all("heap"), "", "", over_all("pyramid")});
  fmt::print("{}\n", table.text());
}

}  // namespace cairn::bench
