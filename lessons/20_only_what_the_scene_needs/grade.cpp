// Exercise 20, graded: islands found by asking of every two bodies whether a path leads from one to the
// other.
#include "exercise.cpp"

namespace cairn::exercise20 {
namespace {

/// How a bill may be wrong.
struct Mistake {
  bool ground_joins = false;
  bool ground_is_a = false;    // else it joins, and what it joins is left out
  bool sleepers_part = false;  // no pair joins a body that sleeps
  int passes = 0;  // over the pairs, if not as many as it takes: what joins later is not carried back
  bool no_islands = false;
  bool sleepers_pay = false;
  bool any_sleeper_ends_it = false;
  bool both_must_be_awake = false;
  bool only_a_wakes = false;
  bool only_b_wakes = false;
  bool number_wakes = false;  // the body that gives the island its number
  bool sleeping_pairs_rest = false;
  bool all_wait = false;     // for the island that needs the most sweeps
  bool first_ends = false;   // an island stops when its first pair is satisfied
  bool last_counts = false;  // the sweeps of its last pair
  bool sums_sweeps = false;
  bool once = false;          // one sweep
  bool counts_pairs = false;  // instead of rows
  bool no_ground_rows = false;
  bool no_ground_pairs = false;
  bool last_only = false;
  bool first_left_out = false;
  bool last_left_out = false;
};

/// A mistake, and the words for it.
struct Known {
  Mistake mistake = {};
  const char* what = "";
};

List<Known> known() {
  const char* const grows =
      "An island that grows later has to take all its bodies along, also those of earlier pairs.";
  const char* const wakes = "One body that is awake wakes its whole island.";
  const char* const ground =
      "A pair with the ground has rows, too: they belong to the island of its other body.";
  return {
      {{.ground_joins = true}, "The ground joins nobody: two towers on it are two islands."},
      {{.ground_is_a = true}, "The ground may be the second body of a pair as well: it joins nobody."},
      {{.sleepers_part = true}, "A body that sleeps belongs to an island as well: it is woken with it."},
      {{.passes = 1}, grows},
      {{.passes = 2}, grows},
      {{.passes = 3}, grows},
      {{.no_islands = true}, "A pair that is satisfied is swept on with its island."},
      {{.sleepers_pay = true}, "An island that sleeps has no rows."},
      {{.any_sleeper_ends_it = true}, wakes},
      {{.both_must_be_awake = true}, wakes},
      {{.only_a_wakes = true}, "Either body of a pair may be the one that is awake."},
      {{.only_b_wakes = true}, "Either body of a pair may be the one that is awake."},
      {{.number_wakes = true}, "Any body wakes its island, not only the one that gives it its number."},
      {{.sleeping_pairs_rest = true}, "One body that is awake wakes its whole island, with all its pairs."},
      {{.all_wait = true}, "No island waits for another: each stops on its own."},
      {{.first_ends = true}, "An island goes on until the last of its pairs is satisfied."},
      {{.last_counts = true}, "The most sweeps of an island, not those of the last pair in the list."},
      {{.sums_sweeps = true}, "A sweep goes over all pairs of an island: the most sweeps, not their sum."},
      {{.once = true}, "Those are the rows. How often is each swept?"},
      {{.counts_pairs = true}, "A pair has several rows: add them up."},
      {{.no_ground_rows = true}, ground},
      {{.no_ground_pairs = true}, ground},
      {{.last_only = true}, "Add the islands up: a step pays for all."},
      {{.first_left_out = true}, "The first island is missing: it has the number of body 1."},
      {{.last_left_out = true}, "The last body may be an island of its own: it is missing."}};
}

bool has_ground(const Pair& pair) { return pair.a == 0 || pair.b == 0; }

/// path[i][j]: whether bodies i and j are in one island.
List<List<bool>> paths(const List<Pair>& pairs, const List<int>& asleep, const Mistake& mistake) {
  const int bodies = asleep.size();
  List<List<bool>> path(bodies, List<bool>(bodies, false));
  for (int i = 0; i < bodies; ++i) path[i][i] = true;
  for (const Pair& pair : pairs) {
    const bool stays = mistake.ground_is_a ? pair.a == 0 : has_ground(pair);
    const bool sleeps = asleep[pair.a] == 1 || asleep[pair.b] == 1;
    if ((!stays || mistake.ground_joins) && (!sleeps || !mistake.sleepers_part))
      path[pair.a][pair.b] = path[pair.b][pair.a] = true;
  }
  for (int by = 0; by < bodies; ++by) {
    for (int i = 0; i < bodies; ++i) {
      for (int j = 0; j < bodies; ++j) path[i][j] = path[i][j] || (path[i][by] && path[by][j]);
    }
  }
  return path;
}

/// The number of the island of each pair.
List<int> islands(const List<Pair>& pairs, const List<int>& asleep, const Mistake& mistake) {
  const List<List<bool>> path = paths(pairs, asleep, mistake);
  List<int> label, island;
  for (int i = 0; i < asleep.size(); ++i) label.push_back(i);
  for (int pass = 0; pass < mistake.passes; ++pass) {
    for (const Pair& pair : pairs) {
      if (!has_ground(pair)) label[pair.a] = label[pair.b] = std::min(label[pair.a], label[pair.b]);
    }
  }
  for (int k = 0; k < pairs.size(); ++k) {
    const int body = std::max(pairs[k].a, pairs[k].b);
    int first = 0;
    while (!path[body][first]) ++first;
    island.push_back(mistake.no_islands ? k : mistake.passes > 0 ? label[body] : first);
  }
  return island;
}

/// What an island costs, with all that its pairs say of it.
struct Island {
  int rows = 0, longest = 0, shortest = 1000, last = 0, sum = 0, sleepers = 0;
  bool by_a = false, by_b = false, by_both = false;  // awake

  void add(const Pair& pair, const List<int>& asleep, const Mistake& mistake) {
    const bool a = asleep[pair.a] == 0, b = asleep[pair.b] == 0;  // the ground is not awake
    by_a = by_a || a, by_b = by_b || b, by_both = by_both || (a && b);
    if (mistake.no_ground_pairs && has_ground(pair)) return;
    if (mistake.sleeping_pairs_rest && !a && !b) return;
    if (!mistake.no_ground_rows || !has_ground(pair)) rows += mistake.counts_pairs ? 1 : pair.rows;
    longest = std::max(longest, pair.sweeps);
    shortest = std::min(shortest, pair.sweeps);
    last = pair.sweeps;
    sum += pair.sweeps;
    for (const int body : {pair.a, pair.b}) sleepers += body != 0 && asleep[body] == 1 ? 1 : 0;
  }

  int sweeps(const Mistake& mistake) const {
    if (mistake.once) return 1;
    if (mistake.sums_sweeps) return sum;
    if (mistake.last_counts) return last;
    return mistake.first_ends && rows > 0 ? shortest : longest;
  }

  bool is_awake(int number, const List<int>& asleep, const Mistake& mistake) const {
    if (mistake.sleepers_pay) return true;
    if (mistake.any_sleeper_ends_it) return sleepers == 0;
    if (mistake.both_must_be_awake) return by_both;
    if (mistake.only_a_wakes) return by_a;
    if (mistake.only_b_wakes) return by_b;
    if (mistake.number_wakes) return number < asleep.size() && asleep[number] == 0;
    return by_a || by_b;
  }
};

int bill(const List<Pair>& pairs, const List<int>& asleep, const Mistake& mistake) {
  const List<int> island = islands(pairs, asleep, mistake);
  int updates = 0, all_rows = 0, most = 0;
  for (int i = 0; i < std::max(pairs.size(), asleep.size()); ++i) {
    Island all;
    for (int k = 0; k < pairs.size(); ++k) {
      if (island[k] == i) all.add(pairs[k], asleep, mistake);
    }
    const bool is_missing = (mistake.ground_is_a && i == 0) || (mistake.first_left_out && i == 1) ||
                            (mistake.last_left_out && i == asleep.size() - 1);
    if (is_missing || all.rows == 0 || !all.is_awake(i, asleep, mistake)) continue;
    if (mistake.last_only) updates = 0;
    all_rows += all.rows;
    most = std::max(most, all.longest);
    updates += all.rows * all.sweeps(mistake);
  }
  return mistake.all_wait ? all_rows * most : updates;
}

struct Scene {
  std::string what = {};
  List<Pair> pairs = {};
  List<int> asleep = {};
};
/// A tower of eight, its pairs from the top down.
List<Pair> chain() {
  List<Pair> pairs;
  for (int body = 8; body > 0; --body) pairs.push_back({body - 1, body, 2, 7 + 5 * body % 13});
  return pairs;
}

List<Scene> scenes() {
  const List<Pair> towers = {{1, 0, 3, 12}, {1, 2, 4, 20}, {2, 3, 3, 9},  {4, 0, 3, 31},
                             {4, 5, 4, 7},  {0, 6, 3, 50}, {7, 6, 3, 40}, {8, 0, 2, 6}};
  const List<Pair> pyramid = {{0, 1, 3, 10}, {0, 2, 3, 14}, {1, 3, 3, 6},
                              {2, 3, 3, 19}, {4, 3, 2, 3},  {5, 3, 2, 8}};
  List<Pair> corner = pyramid;  // body 1 is never the first of its pair, as the balls are never the second
  std::swap(corner[2].a, corner[2].b);
  return {{"two towers, one asleep, and a box alone", towers, {1, 0, 0, 0, 0, 0, 1, 1, 0}},
          {"a chain, its pairs from the top down", chain(), {1, 0, 0, 0, 0, 0, 0, 0, 0}},
          {"two balls that meet a pyramid asleep", pyramid, {1, 1, 1, 1, 0, 0}},
          {"the same, of which a corner is awake", corner, {1, 0, 1, 1, 1, 1}},
          {"all asleep", {{0, 1, 3, 10}, {1, 2, 3, 50}}, {1, 1, 1}}};
}

void grade_all(Grade& grade) {
  // A mistake that explains all bills has the word; where there is none, those that explain one of them,
  // other than 0, have theirs.
  List<Known> everywhere;
  for (const Known& each : known()) {
    bool explains = true;
    for (const Scene& scene : scenes()) {
      explains =
          explains && row_updates(scene.pairs, scene.asleep) == bill(scene.pairs, scene.asleep, each.mistake);
    }
    if (explains) everywhere.push_back(each);
  }
  for (const Scene& scene : scenes()) {
    ExpectedNumber number{.what = scene.what + ": row updates",
                          .value = static_cast<double>(bill(scene.pairs, scene.asleep, {})),
                          .tolerance = 0};
    for (const Known& each : everywhere.empty() ? known() : everywhere) {
      const int wrong = bill(scene.pairs, scene.asleep, each.mistake);
      if (wrong != 0 || !everywhere.empty())
        number.misconceptions.push_back({static_cast<double>(wrong), each.what});
    }
    grade.number(number, row_updates(scene.pairs, scene.asleep));
  }
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
