// The stability atlas: classes, cells whose end a formula knows, and the way through the journal.
#include <cairn/study/extremes/atlas.hpp>

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include <cairn/math/list.hpp>
#include <cairn/math/math.hpp>
#include <cairn/scenes/solver_list.hpp>
#include "scratch_folder.hpp"

using namespace cairn;

namespace {

const AtlasPanel& atlas_panel(const AtlasMap& map, const std::string& solver) {
  for (const AtlasPanel& panel : map.panels) {
    if (panel.setting.solver == solver) return panel;
  }
  FAIL("no panel of ", solver);
  return map.panels.front();
}

/// The part of the energy that `steps` steps of h leave to five balls in a row on springs that are all pulled
/// out alike: every mode goes by (1 + a h^2 w^2) v' = (1 + b h^2 w^2) v - h w^2 x, with the a and b that all
/// springs of one frequency share (softness.hpp).
double energy_left_on_springs(double frequency, double h, int steps) {
  const int balls = 5;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(balls, balls), mass = Eigen::MatrixXd::Zero(balls, balls);
  Eigen::VectorXd pulled(balls);
  for (int i = 0; i < balls; ++i) {
    mass(i, i) = i == balls - 1 ? 100 : 1;
    pulled(i) = 0.1 * (i + 1);
    const double reduced = i == 0 ? mass(0, 0) : 1 / (1 / mass(i - 1, i - 1) + 1 / mass(i, i));
    const double k = reduced * std::pow(2 * pi * frequency, 2);
    stiffness(i, i) += k;
    if (i == 0) continue;
    stiffness(i - 1, i - 1) += k;
    stiffness(i, i - 1) -= k;
    stiffness(i - 1, i) -= k;
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness, mass);
  const Eigen::VectorXd shares = modes.eigenvectors().transpose() * mass * pulled;
  const double turn = 2 * pi * frequency * h, share = 1 / (1 + std::pow(turn, 4)), b = share / 4;
  double first = 0, left = 0;
  for (int mode = 0; mode < balls; ++mode) {
    const double w2 = modes.eigenvalues()(mode), s = w2 * h * h;
    double x = shares(mode), v = 0;
    first += w2 * x * x / 2;
    for (int step = 0; step < steps; ++step) {
      v = ((1 + b * s) * v - h * w2 * x) / (1 + (1 - 3 * b) * s);
      x += h * v;
    }
    const double middle = x - h * v / 2;
    left += (v * v + w2 * middle * middle) / 2;
  }
  return left / first;
}

/// A map of 2 by 3 whose cells hold as told, by x and then y.
AtlasSheet sheet_of(AtlasReading reading, const List<bool>& holds) {
  AtlasSheet sheet;
  sheet.map.x = {.title = "x", .values = {10, 100}, .labels = {"10", "100"}};
  sheet.map.y = {.title = "y", .values = {1, 2, 4}, .labels = {"float", "double", "long"}};
  sheet.map.panels = {{"SI, and so PGS", {}, true}};
  sheet.map.reading = reading;
  sheet.map.headline = 1;
  sheet.map.headline_text = "It stands";
  sheet.map.y_unit = "sweeps";
  for (const bool good : holds)
    sheet.cells.push_back({.ending = good ? AtlasClass::holds : AtlasClass::failed});
  return sheet;
}

}  // namespace

TEST_CASE("a number belongs to the class whose limit it keeps, and what is no number has exploded") {
  const AtlasLimits limits{.holds = 0.05, .strained = 0.5};
  CHECK(class_of(0.05, limits) == AtlasClass::holds);
  CHECK(class_of(0.0501, limits) == AtlasClass::strained);
  CHECK(class_of(0.5, limits) == AtlasClass::strained);
  CHECK(class_of(1e300, limits) == AtlasClass::failed);
  CHECK(class_of(INFINITY, limits) == AtlasClass::exploded);
  CHECK(class_of(NAN, limits) == AtlasClass::exploded);
}

TEST_CASE("an exact solver carries every mass ratio of the atlas, and one sweep does not carry the largest") {
  const AtlasMap map = mass_ratio_map();
  const AtlasPanel& exact = atlas_panel(map, "reference");
  CHECK(exact.ignores_y);
  for (const double ratio : {1.0, 100.0, 1e4}) CHECK(map.run(exact, ratio, 1).ending == AtlasClass::holds);
  const AtlasCell crushed = map.run(atlas_panel(map, "si"), 1e4, 1);
  CHECK((crushed.ending == AtlasClass::failed || crushed.ending == AtlasClass::exploded));
}

TEST_CASE("springs of the atlas lose what a step takes from each of their modes, and no more") {
  const AtlasMap map = spring_map();
  for (const double frequency : {0.1, 1.0, 10.0}) {
    const AtlasCell cell = map.run(atlas_panel(map, "reference"), 60, frequency);
    // Sixty steps of an exact solver: rounding, magnified by the condition of five springs (below 1e4).
    CHECK(cell.measured == doctest::Approx(energy_left_on_springs(frequency, 1.0 / 60, 60)).epsilon(1e-9));
    CHECK(cell.energy_gain <= 1e-9);
  }
}

TEST_CASE("a place whose neighbouring numbers are further apart than a box is refused, and near ones hold") {
  const AtlasMap map = origin_map();
  const AtlasPanel& si = atlas_panel(map, "si");
  const double in_float = 0, in_double = 1;
  CHECK(std::nextafter(1e8F, INFINITY) - 1e8F > 1);
  CHECK(map.run(si, 1e8, in_float).ending == AtlasClass::refused);
  CHECK(map.run(si, 1e2, in_float).ending == AtlasClass::holds);
  CHECK(std::nextafter(1e17, INFINITY) - 1e17 > 1);
  CHECK(map.run(si, 1e17, in_double).ending == AtlasClass::refused);
  CHECK(map.run(si, 1e8, in_double).ending == AtlasClass::holds);
}

TEST_CASE("every map has a label for each value, names for its classes, and its headline in the quick part") {
  const List<AtlasMap> all = atlas_maps(AtlasPart::all), quick = atlas_maps(AtlasPart::quick);
  REQUIRE(all.size() == quick.size());
  for (int i = 0; i < all.size(); ++i) {
    CAPTURE(all[i].name);
    for (const AtlasMap* map : {&all[i], &quick[i]}) {
      CHECK(map->x.values.size() == map->x.labels.size());
      CHECK(map->y.values.size() == map->y.labels.size());
      CHECK(map->panels.size() <= 11);  // with the legend, three rows of four
      for (int named = 0; named < 4; ++named) CHECK_FALSE(map->classes[named].name.empty());
    }
    CHECK(all[i].x.values[all[i].headline] == quick[i].x.values[quick[i].headline]);
    CHECK(quick[i].x.values.size() < all[i].x.values.size());
  }
}

TEST_CASE("every map has a panel of every solver, or of one that gives the same numbers") {
  // PGS is SI, eq. (24) to (29), lanes are another order, and without contacts block-contact is block.
  const List<std::string> same_as_others = {"pgs", "pgs-sparse", "pgs-factored", "wide", "wide-accelerated"};
  for (const AtlasMap& map : atlas_maps(AtlasPart::all)) {
    CAPTURE(map.name);
    for (const SolverEntry& solver : solver_entries()) {
      CAPTURE(solver.name);
      if (std::count(same_as_others.begin(), same_as_others.end(), solver.name) > 0) continue;
      if (map.name == "chain" && solver.name == "block-contact") continue;
      CHECK(std::any_of(map.panels.begin(), map.panels.end(),
                        [&](const AtlasPanel& panel) { return panel.setting.solver == solver.name; }));
    }
  }
}

TEST_CASE("cells come back from the journal in their places, and those that were not run say so") {
  const Study study = atlas_study(AtlasPart::quick);
  const testing::ScratchFolder folder;
  Journal journal(folder / "journal.csv", study);
  journal.write(1, study.tasks[1].run());  // the first panel's first x, second y
  const List<AtlasSheet> sheets = atlas_sheets(AtlasPart::quick, journal.csv());
  const AtlasMap& map = sheets.front().map;
  const AtlasCell again = map.run(map.panels[0], map.x.values[0], map.y.values[1]);
  CHECK(sheets.front().cell(0, 0, 1).ending == again.ending);
  CHECK(sheets.front().cell(0, 0, 1).measured == again.measured);
  CHECK(sheets.front().cell(0, 0, 1).energy_gain == again.energy_gain);
  CHECK(sheets.front().cell(0, 0, 0).ending == AtlasClass::not_run);
  CHECK(sheets.back().cells.back().ending == AtlasClass::not_run);
  CHECK_THROWS_AS(atlas_sheets(AtlasPart::quick, "task,a\n0,1\n"), std::invalid_argument);
}

TEST_CASE("what a map says in words is what its cells say") {
  using Reading = AtlasReading;
  CHECK(panel_finding(sheet_of(Reading::from_y, {1, 1, 1, 0, 1, 1}), 0) == "from 2 sweeps");
  CHECK(panel_finding(sheet_of(Reading::from_y, {1, 1, 1, 1, 0, 1}), 0) == "from 4 sweeps");
  CHECK(panel_finding(sheet_of(Reading::from_y, {0, 0, 0, 1, 1, 1}), 0) == "from 1 sweep");
  CHECK(panel_finding(sheet_of(Reading::from_y, {1, 1, 1, 1, 1, 0}), 0) == "not with 4 sweeps");
  CHECK(panel_finding(sheet_of(Reading::up_to_y, {0, 0, 0, 1, 1, 0}), 0) == "up to 2 sweeps");
  CHECK(panel_finding(sheet_of(Reading::up_to_y, {1, 1, 1, 0, 1, 1}), 0) == "not even at 1 sweeps");
  CHECK(panel_finding(sheet_of(Reading::up_to_x, {1, 1, 0, 0, 1, 1}), 0) ==
        "float 10^{1} m, double 10^{2} m, long nowhere");
  CHECK(sheet_finding(sheet_of(Reading::from_y, {1, 1, 1, 0, 1, 1})) == "It stands: SI from 2 sweeps");
}
