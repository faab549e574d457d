// Tables that stand for many bodies: how many, where, and joined how.
#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <string>

#include <cairn/math/list.hpp>
#include <cairn/scenes/scene_file.hpp>
#include <cairn/scenes/scene_schema.hpp>
#include <cairn/study/trial.hpp>

using namespace cairn;

namespace {

/// Centres of the bodies of a text, without the ground.
List<Vec2<double>> repeat_places(const std::string& text) {
  List<Vec2<double>> places;
  const Scene scene = read_scene_text(text, "repeat.toml").make();
  for (const SceneBody& body : scene.bodies()) places.push_back(body.pose.position);
  places.erase(places.begin());
  return places;
}

double repeat_drift(const std::string& text) {
  double drift = 0;
  TrialOptions options{.seconds = 0};
  options.observer = [&drift](const Snapshot& now) {
    for (const SnapshotJoint& joint : now.joints) drift = std::max(drift, joint.drift);
  };
  run_trial(read_scene_text(text, "repeat.toml").make(), {}, options);
  return drift;
}

const double repeat_rounding = 1e-14;  // [m] a few roundings of places of some metres

}  // namespace

TEST_CASE("a stack stands on its foot, each body on the one below, alternately to the left and to the right") {
  const auto places = repeat_places("[[stack]]\nn = 3\nbox = [2, 1]\nposition = [1, 2]\noffset = 0.25\n");
  REQUIRE(places.size() == 3);
  for (int i = 0; i < 3; ++i) {
    CHECK(places[i] == Vec2<double>(i == 1 ? 1.25 : 0.75, 2.5 + i));
  }
  CHECK(repeat_places("[[stack]]\nn = 2\ncircle = 0.5\n")[1] == Vec2<double>(0, 1.5));
}

TEST_CASE("a pyramid of n rows has n (n + 1) / 2 boxes, symmetric about its middle") {
  for (const int n : {1, 2, 7}) {
    const auto places = repeat_places("[[pyramid]]\nn = " + std::to_string(n) + "\nbox = [1, 1]\n");
    CHECK(places.size() == n * (n + 1) / 2);
    CHECK(places.back() == Vec2<double>(0, n - 0.5));
    double sum = 0;
    for (const Vec2<double>& place : places) sum += place.x();
    CHECK(std::abs(sum) <= repeat_rounding * n * n);
  }
}

TEST_CASE("a row begins where it should, and its rows are moved in turns") {
  const std::string row =
      "n = 2\nrows = 2\nstep = [2, 0]\nrow_step = [0, 3]\nstagger = [0.5, 0]\ncircle = 0.2\n";
  const auto first = repeat_places("[[row]]\nfirst = [1, 1]\n" + row);
  CHECK(first == List<Vec2<double>>{{1, 1}, {3, 1}, {1.5, 4}, {3.5, 4}});
  const auto middle = repeat_places("[[row]]\nposition = [1, 1]\n" + row);
  CHECK(middle == List<Vec2<double>>{{0, 1}, {2, 1}, {0.5, 4}, {2.5, 4}});
  const Scene mixed = read_scene_text(
                          "[[row]]\nfirst = [0, 0]\nn = 5\nstep = [2, 0]\nbox = [1, 1]\nevery = 3\n"
                          "other = { circle = 0.5 }\n",
                          "mixed.toml")
                          .make();
  for (int i = 0; i < 5; ++i) {
    CHECK(shape_name(mixed.bodies()[{i + 1}].spec.shapes[0]) == (i % 3 == 0 ? "circle" : "polygon"));
  }
}

TEST_CASE("a pile is the same for the same seed, another one for another, and stays in its bounds") {
  const auto pile = [](int seed) {
    return repeat_places(
        "[[pile]]\nn = 12\ncolumns = 4\nfirst = [0, 0]\nstep = [2, 3]\njitter = 0.5\n"
        "spread = 0.25\nbox = [0.5, 0.25]\nseed = " +
        std::to_string(seed) + "\n");
  };
  CHECK(pile(3) == pile(3));
  CHECK(pile(3) != pile(4));
  const auto places = pile(5);
  for (int i = 0; i < 12; ++i) {
    const Vec2<double>& place = places[i];
    CHECK(std::abs(place.x() - 2 * (i % 4)) <= 0.5);
    CHECK(place.y() == 3 * (i / 4));
  }
}

TEST_CASE("an arch of n stones has the area of half a ring, whatever n is, but for its corners") {
  for (const int n : {5, 50}) {
    const Scene scene =
        read_scene_text("[[arch]]\nn = " + std::to_string(n) + "\nradius = 4\nthickness = 1\n", "arch.toml")
            .make();
    double mass = 0;
    for (const SceneBody& body : scene.bodies()) mass += body.mass;
    // n trapezia between circles of 3.5 and 4.5: each (4.5^2 - 3.5^2) / 2 sin(pi / n).
    CHECK(mass == doctest::Approx(n * 4 * std::sin(pi / n)).epsilon(1e-13));
  }
}

TEST_CASE("a house of n storeys has n (n + 1) cards and n boards, and a row of dominoes n pieces") {
  for (const int n : {1, 3}) {
    const auto cards = repeat_places("[[cards]]\nn = " + std::to_string(n) + "\n");
    CHECK(cards.size() == n * (n + 1) + n);
  }
  const auto dominoes = repeat_places("[[dominoes]]\nn = 4\nlean = 0.1\nposition = [0, 1]\n");
  REQUIRE(dominoes.size() == 4);
  CHECK(dominoes[3].x() == doctest::Approx(1.5 * 0.7).epsilon(1e-15));
  CHECK(dominoes[3].y() == doctest::Approx(1.7).epsilon(1e-15));
  // It leans on its lower right corner, which is 0.1 to the right of where its middle would be.
  const Vec2<double> corner(-1.5 * 0.7 + 0.1, 1);
  CHECK((dominoes[0] - corner).norm() == doctest::Approx(std::hypot(0.1, 0.7)).epsilon(1e-14));
  CHECK(std::atan2(dominoes[0].x() - corner.x(), dominoes[0].y() - corner.y()) ==
        doctest::Approx(0.1 - std::atan(0.1 / 0.7)).epsilon(1e-13));
}

TEST_CASE(
    "the most that the page allows of a pyramid or a house of cards is the most that a scene may have") {
  CHECK(repeat_places("[[pyramid]]\nn = 199\nbox = [1, 1]\n").size() == 199 * 200 / 2);
  CHECK(199 * 200 / 2 <= most_scene_bodies);
  CHECK(200 * 201 / 2 > most_scene_bodies);
  CHECK_THROWS_WITH_AS(read_scene_text("[[pyramid]]\nn = 200\nbox = [1, 1]\n", "my.toml"),
                       "my.toml:2:5: pyramid[1].n must be a whole number from 1 to 199, got 200",
                       std::invalid_argument);
  CHECK(repeat_places("[[cards]]\nn = 140\n").size() == 140 * 141 + 140);
  CHECK(141 * 142 + 141 > most_scene_bodies);
  CHECK_THROWS_WITH_AS(read_scene_text("[[cards]]\nn = 141\n", "my.toml"),
                       "my.toml:2:5: cards[1].n must be a whole number from 1 to 140, got 141",
                       std::invalid_argument);
}

TEST_CASE("the most that the page allows of what is n bodies is as many as a scene may have") {
  for (const char* text : {"[[stack]]\nn = 20000\nbox = [1, 1]\n",
                           "[[row]]\nn = 20000\nfirst = [0, 0]\nstep = [1, 0]\ncircle = 0.1\n",
                           "[[pile]]\nn = 20000\ncolumns = 9\nfirst = [0, 0]\nstep = [1, 1]\ncircle = 0.1\n",
                           "[[arch]]\nn = 20000\nradius = 4\nthickness = 1\n", "[[dominoes]]\nn = 20000\n",
                           "[[cradle]]\nn = 20000\n", "[[chain]]\nn = 20000\nlink = 0.1\n"}) {
    CAPTURE(text);
    CHECK(repeat_places(text).size() == most_scene_bodies);
  }
}

TEST_CASE("the joints of chains and cradles begin closed, between ends or with a bob") {
  for (const char* text :
       {"[[chain]]\nn = 5\nlink = 0.3\nangle = 1\n[chain.bob]\nradius = 0.2\nratio = 3\n",
        "[[chain]]\nn = 5\nfrom = [1, 1]\nto = [3, 4]\nb = \"ground\"\n",
        "[[chain]]\nn = 5\nto = [3, 4]\njoint = \"weld\"\n",
        "[[chain]]\nn = 5\nto = [3, 4]\njoint = \"rod\"\ncircle = 0.1\nb = \"ground\"\naside = 0.5\n",
        "[[chain]]\nn = 5\nlink = 0.5\njoint = \"rope\"\ncircle = 0.1\n",
        "[[cradle]]\nn = 4\naside = -0.5\n"}) {
    CAPTURE(text);
    CHECK(repeat_drift(text) <= repeat_rounding);
  }
  const Scene bob =
      read_scene_text("[[chain]]\nn = 2\nlink = 0.5\n[chain.bob]\nradius = 0.2\nratio = 3\n", "bob.toml")
          .make();
  CHECK(bob.joints().size() == 3);
  CHECK(bob.bodies()[{3}].mass == 3 * bob.bodies()[{2}].mass);
  CHECK(bob.bodies()[{3}].pose.position.y() == doctest::Approx(-1.2).epsilon(1e-15));
}

TEST_CASE("bodies come in the order of the file, and each has a name that joints can use") {
  const SceneEntry entry = read_scene_text(R"([[body]]
circle = 0.1
[[stack]]
n = 2
box = [1, 1]
position = [3, 0]
[[body]]
circle = 0.1
position = [6, 0]
[[joint]]
type = "weld"
a = "late.1"
b = "stack.2"
[[row]]
name = "late"
n = 1
first = [9, 0]
step = [1, 0]
circle = 0.1
)",
                                           "names.toml");
  CHECK(entry.body_names ==
        PerBody<std::string>{"ground", "body.1", "stack.1", "stack.2", "body.2", "late.1"});
  const auto joints = entry.make().joints();
  REQUIRE(joints.size() == 1);
  CHECK(joints[0]->attachments()[0].body == BodyId{5});
  CHECK(joints[0]->attachments()[1].body == BodyId{3});
}
