// Exercise 20, graded: islands found by asking of every two bodies whether a path leads from one to the
// other.
#include <algorithm>
#include <string>

#include "exercise.cpp"

namespace cairn::exercise20 {
namespace {

/// How a bill may be wrong.
struct Mistake {
  bool ground_joins = false;
  bool one_pass = false;  // over the pairs: what joins later is not carried back
  bool no_islands = false;
  bool sleepers_pay = false;
  bool any_sleeper_ends_it = false;
  bool all_wait = false;    // for the island that needs the most sweeps
  bool first_ends = false;  // an island stops when its first pair is satisfied
  bool once = false;        // one sweep
  bool no_ground_rows = false;
  bool last_only = false;
};

/// path[i][j]: whether bodies i and j are in one island.
List<List<bool>> paths(const List<Pair>& pairs, int bodies, bool ground_joins) {
  List<List<bool>> path(bodies, List<bool>(bodies, false));
  for (int i = 0; i < bodies; ++i) path[i][i] = true;
  for (const Pair& pair : pairs) {
    if (ground_joins || (pair.a != 0 && pair.b != 0)) path[pair.a][pair.b] = path[pair.b][pair.a] = true;
  }
  for (int by = 0; by < bodies; ++by) {
    for (int i = 0; i < bodies; ++i) {
      for (int j = 0; j < bodies; ++j) path[i][j] = path[i][j] || (path[i][by] && path[by][j]);
    }
  }
  return path;
}

/// The number of the island of each pair.
List<int> islands(const List<Pair>& pairs, int bodies, const Mistake& mistake) {
  const List<List<bool>> path = paths(pairs, bodies, mistake.ground_joins);
  List<int> label, island;
  for (int i = 0; i < bodies; ++i) label.push_back(i);
  for (const Pair& pair : pairs) {
    if (pair.a == 0 || pair.b == 0) continue;
    label[pair.a] = label[pair.b] = std::min(label[pair.a], label[pair.b]);
  }
  for (int k = 0; k < pairs.size(); ++k) {
    const int body = std::max(pairs[k].a, pairs[k].b);
    int first = 0;
    while (!path[body][first]) ++first;
    island.push_back(mistake.no_islands ? k : mistake.one_pass ? label[body] : first);
  }
  return island;
}

int bill(const List<Pair>& pairs, const List<int>& asleep, const Mistake& mistake) {
  const List<int> island = islands(pairs, asleep.size(), mistake);
  int updates = 0, all_rows = 0, most = 0;
  for (int i = 0; i < std::max(pairs.size(), asleep.size()); ++i) {
    int rows = 0, longest = 0, shortest = 1000, sleepers = 0, awake = 0;
    for (int k = 0; k < pairs.size(); ++k) {
      if (island[k] != i) continue;
      const Pair& pair = pairs[k];
      if (!mistake.no_ground_rows || (pair.a != 0 && pair.b != 0)) rows += pair.rows;
      longest = std::max(longest, pair.sweeps);
      shortest = std::min(shortest, pair.sweeps);
      for (const int body : {pair.a, pair.b}) {
        if (body != 0) (asleep[body] == 1 ? sleepers : awake) += 1;
      }
    }
    const bool sleeps = mistake.any_sleeper_ends_it ? sleepers > 0 : awake == 0;
    if (sleeps && !mistake.sleepers_pay) continue;
    if (mistake.last_only) updates = 0;
    all_rows += rows;
    most = std::max(most, longest);
    updates += rows * (mistake.once ? 1 : mistake.first_ends ? shortest : longest);
  }
  return mistake.all_wait ? all_rows * most : updates;
}

ExpectedNumber expected(const std::string& what, const List<Pair>& pairs, const List<int>& asleep) {
  const auto wrong = [&](const Mistake& mistake) {
    return static_cast<double>(bill(pairs, asleep, mistake));
  };
  return {.what = what + ": row updates",
          .value = wrong({}),
          .tolerance = 0,
          .misconceptions = {
              {wrong({.ground_joins = true}), "The ground joins nobody: two towers on it are two islands."},
              {wrong({.one_pass = true}),
               "An island that grows later has to take all its bodies along, also those of earlier pairs."},
              {wrong({.no_islands = true}), "A pair that is satisfied is swept on with its island."},
              {wrong({.sleepers_pay = true}), "An island that sleeps has no rows."},
              {wrong({.any_sleeper_ends_it = true}), "One body that is awake wakes its whole island."},
              {wrong({.all_wait = true}), "No island waits for another: each stops on its own."},
              {wrong({.first_ends = true}), "An island goes on until the last of its pairs is satisfied."},
              {wrong({.once = true}), "Those are the rows. How often is each swept?"},
              {wrong({.no_ground_rows = true}),
               "A pair with the ground has rows, too: they belong to the island of its other body."},
              {wrong({.last_only = true}), "Add the islands up: a step pays for all."}}};
}

void grade_all(Grade& grade) {
  const auto mark = [&grade](const std::string& what, const List<Pair>& pairs, const List<int>& asleep) {
    grade.number(expected(what, pairs, asleep), row_updates(pairs, asleep));
  };
  mark(
      "two towers, and one asleep",
      {{0, 1, 3, 12}, {1, 2, 4, 20}, {2, 3, 3, 9}, {0, 4, 3, 31}, {4, 5, 4, 7}, {6, 0, 3, 50}, {7, 6, 3, 40}},
      {1, 0, 0, 0, 0, 0, 1, 1});
  mark("a chain, its pairs in any order",
       {{4, 5, 2, 17}, {2, 3, 2, 11}, {3, 4, 2, 23}, {1, 2, 2, 5}, {0, 1, 2, 8}}, {1, 0, 0, 0, 0, 0});
  mark("a ball that meets a pyramid asleep",
       {{0, 1, 3, 10}, {0, 2, 3, 14}, {1, 3, 3, 6}, {2, 3, 3, 19}, {3, 4, 2, 3}}, {1, 1, 1, 1, 0});
  mark("all asleep", {{0, 1, 3, 10}, {1, 2, 3, 50}}, {1, 1, 1});
}

}  // namespace

Exercise exercise() {
  return {
      .lesson = 20,
      .task = "The row updates of a step that does only what it has to.",
      .file = "lessons/20_only_what_the_scene_needs/exercise.cpp",
      .hints =
          {"Give every body the number of its island, at first its own. Each pair without the ground gives "
           "both its bodies the lower of their two numbers. Repeat until nothing changes.",
           "A pair belongs to the island of that of its bodies which is not the ground.",
           "For each island: add the rows of its pairs, take the most sweeps, and see whether any body is "
           "awake."},
      .grade = grade_all};
}

}  // namespace cairn::exercise20
