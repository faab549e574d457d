// Every C function with any arguments, in any order: each comes back, and a refusal changes nothing.
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <utility>

#include <cairn/math/list.hpp>
#include "lessons/playground/interface.h"
#include <cairn/scenes/solver_list.hpp>

namespace {

using cairn::List;

/// What a caller may give, by chance: often what is right, and often what is not.
class Chance {
 public:
  explicit Chance(unsigned seed) : engine_(seed) {}

  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }
  template <typename T>
  T one_of(const List<T>& some) {
    return some[below(some.size())];
  }
  double number() {
    const double infinity = std::numeric_limits<double>::infinity();
    if (below(3) > 0) return std::uniform_real_distribution<double>(-2, 4)(engine_);
    return one_of<double>({std::nan(""), infinity, -infinity, 1e308, -1e308, 1e-308, 0, -0.0, 1e9});
  }
  int index() {
    if (below(3) > 0) return below(6);
    return one_of<int>({-1, -2, 1000000, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()});
  }
  int count() { return below(4) > 0 ? 1 + below(12) : one_of<int>({0, -1, 100001, 2147483647, -2147483647}); }
  const char* text() { return one_of<const char*>(texts); }
  const char* setting() { return below(5) > 0 ? one_of<const char*>(settings) : text(); }
  const char* value() { return below(5) > 0 ? values[below(values.size())].c_str() : text(); }

 private:
  const List<const char*> texts = {
      nullptr,
      "",
      "si",
      "\xff\xfe",
      "[ground]\n[[body]]\ncircle = 0.5\nposition = [0, 2]\n",
      "[ground]\n[[stack]]\nname = \"crate\"\nn = 3\nbox = [1, 1]\n",
      "[ground]\n[[chain]]\nn = 5\nlength = 1\n",
      "[[body]]\nbox = [1, -1]\n",
      "light",
      "gravity = [0, 0]\n[[body]]\ncircle = 0.5\nvelocity = [1.7e308, 0]\n",
      "[ground]\n[[stack]]\nn = 2\nbox = [1, 1]\n[recommended]\ntime_budget = 1e-9\niterations = 1000000\n"};
  const List<const char*> settings = {"solver",     "other",    "sweeps", "warm",   "friction",
                                      "mass-ratio", "gravity",  "bounce", "policy", "beta",
                                      "rate",       "substeps", "search", "numbers"};
  const List<std::string> values =
      cairn::solver_names({"none",          "0",           "1",          "3",       "10",
                           "100",           "0.2",         "1.5",        "1000",    "on",
                           "off",           "as-in-scene", "soft",       "relaxed", "baumgarte",
                           "split-impulse", "when-moved",  "every-step", "float",   "double",
                           "every-substep", "nan",         "inf",        "-1",      "1e400"});

  std::mt19937 engine_;
};

/// Functions that return whether they have done what was asked.
using Act = int (*)(Chance&);
const List<std::pair<const char*, Act>> acts = {
    {"open", [](Chance& c) { return cairn_open(c.text(), c.below(9) > 0 ? "scene" : c.text()); }},
    {"restart", [](Chance&) { return cairn_restart(); }},
    {"set", [](Chance& c) { return cairn_set(c.setting(), c.value()); }},
    {"set", [](Chance& c) { return cairn_set(c.setting(), c.value()); }},
    {"step", [](Chance& c) { return cairn_step(c.count()); }},
    {"step_for", [](Chance& c) { return cairn_step_for(c.count(), c.number()); }},
    {"row", [](Chance& c) { return cairn_row(c.count()); }},
    {"sweep", [](Chance&) { return cairn_sweep(); }},
    {"back", [](Chance&) { return cairn_back(); }},
    {"grab", [](Chance& c) { return cairn_grab(c.number(), c.number()); }},
    {"drag", [](Chance& c) { return cairn_drag(c.number(), c.number()); }},
    {"add_box", [](Chance& c) { return cairn_add_box(c.number(), c.number(), c.number(), c.number()); }},
    {"add_ball", [](Chance& c) { return cairn_add_ball(c.number(), c.number(), c.number()); }},
    {"add_rope",
     [](Chance& c) {
       return cairn_add_rope(c.index(), c.number(), c.number(), c.index(), c.number(), c.number());
     }},
    {"visit", [](Chance& c) { return cairn_visit(c.below(2) > 0 ? c.below(12) : c.index()); }},
    {"visit_row", [](Chance& c) { return cairn_visit_row(c.below(2) > 0 ? c.below(30) : c.index()); }},
    {"zoom", [](Chance& c) { return cairn_zoom(c.number(), 100 * c.number(), 100 * c.number()); }},
    {"pan", [](Chance& c) { return cairn_pan(c.number(), c.number()); }},
    {"remove", [](Chance& c) { return cairn_remove(c.index()); }},
    {"pin", [](Chance& c) { return cairn_pin(c.index(), c.index(), c.number(), c.number()); }},
    {"undo", [](Chance&) { return cairn_undo(); }},
    {"predict", [](Chance& c) { return cairn_predict(c.index(), c.number()); }},
    {"resize", [](Chance& c) { return cairn_resize(c.below(2) > 0 ? 400 : c.index(), 300, c.number()); }},
    {"theme", [](Chance& c) { return cairn_theme(c.text()); }},
    {"draw", [](Chance& c) { return c.below(20) > 0 ? cairn_sweep() : cairn_draw(); }},
    {"patience", [](Chance& c) { return cairn_patience(c.below(9) > 0 ? 0.5 : c.number()); }}};

/// Functions that tell something, or that nothing can be refused of.
void tell_all(Chance& c) {
  cairn_move(c.index());
  cairn_light_row(c.index());
  if (c.below(9) == 0) cairn_let_go();
  if (c.below(9) == 0) cairn_reveal();
  if (c.below(9) == 0) cairn_show_all();
  const double* bodies = cairn_bodies();
  double sum = 0;
  for (int i = 0; i < 8 * cairn_body_count(); ++i) sum += bodies[i];
  const int rows = cairn_row_count();
  const double* of_rows = cairn_rows();
  for (int i = 0; i < 6 * rows; ++i) sum += of_rows[i];
  const int steps = cairn_history_count();
  const double* of_body = cairn_body_history(c.index());
  for (int i = 0; i < 4 * steps; ++i) sum += of_body[i];
  const double* of_pair = cairn_pair_history(c.index(), c.index());
  for (int i = 0; i < 2 * steps; ++i) sum += of_pair[i];
  for (int i = 0; i < 17; ++i) sum += cairn_numbers()[i];
  for (int i = 0; i < 4; ++i) sum += cairn_at(c.number(), 100 * c.number())[i];
  for (int i = 0; i < 2; ++i) sum += cairn_place(c.number(), c.number())[i];
  CHECK((sum == sum || std::isnan(sum)));  // all of it was read
  for (const char* text : {cairn_words(), cairn_plan(), cairn_body_name(c.index())}) CHECK(text != nullptr);
}

std::string state_now() {
  std::string all = cairn_fingerprint();
  all += cairn_scene_text();
  all += cairn_settings();
  return all + std::to_string(cairn_numbers()[1]);
}

}  // namespace

TEST_CASE("whatever the functions are given, each comes back, and says why where it refuses") {
  using Clock = std::chrono::steady_clock;
  const char* const longer = std::getenv("CAIRN_WILD_SECONDS");  // for a search of its own
  const Clock::time_point end = Clock::now() + std::chrono::seconds(longer ? std::atoi(longer) : 3);
  int done = 0, refused = 0;
  for (unsigned seed = 1; Clock::now() < end; ++seed) {
    Chance chance(seed);
    std::string trail;
    for (int i = 0; i < 40; ++i) {
      const std::string before = state_now();
      const auto& [name, act] = acts[chance.below(acts.size())];
      trail += std::string(" ") + name;
      CAPTURE(seed);
      CAPTURE(trail);
      const int answer = act(chance);
      const std::string why = cairn_refusal();
      REQUIRE((answer == 0 || answer == 1));
      REQUIRE((answer == 1) == why.empty());
      if (answer == 0) REQUIRE(state_now() == before);
      ++(answer == 1 ? done : refused);
      tell_all(chance);
    }
  }
  CHECK(cairn_patience(0.5) == 1);
  CHECK(cairn_resize(1280, 720, 1) == 1);
  CHECK(cairn_theme("light") == 1);
  CHECK(done > 10);
  CHECK(refused > 10);
}
