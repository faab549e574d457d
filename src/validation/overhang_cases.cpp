// Floor 8. Blocks that reach over an edge: B35.
#include <cmath>
#include <string>

#include <cairn/geometry/shape.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double overhang_slop = 1e-4;  // [m]

/// n blocks of 1 m on the edge of a table, each overhanging what is below it by `share` of what can be: the
/// k-th from the top by 1 / 2k of its length.
Scene overhanging_blocks(int n, double share) {
  Scene scene({.stabilization = {.slop = overhang_slop}});
  const double height = 0.2;
  scene.add({.type = BodyType::static_body, .shapes = {box(4, 1)}, .position = {-2, -0.5}});
  double edge = 0;  // of the support
  for (int k = n; k >= 1; --k) {
    edge += share / (2 * k);
    scene.add({.shapes = {box(1, height)}, .position = {edge - 0.5, (n - k + 0.5) * height}, .mass = 1});
  }
  return scene;
}

/// Whether the topmost block sinks by more than 0.02 m in so many seconds.
bool overhang_falls(const EngineMaker& make, int n, double share, double seconds) {
  Motion blocks(make, overhanging_blocks(n, share), 300);
  const double start = blocks.position({n + 1}).y();
  blocks.run(seconds);
  return start - blocks.position({n + 1}).y() > 0.02;
}

ValidationResult overhang(const EngineMaker& make) {
  ValidationResult result;
  double most = 0;  // [m]
  for (int n = 1; n <= 5; ++n) {
    most += 1.0 / (2 * n);
    if (n % 2 == 0) continue;
    const auto falls = [&make, n](double share) { return overhang_falls(make, n, share, 2); };
    const double share = bisected({0.98, 1.02}, 0.005, falls).middle();
    result.add(
        measured(n == 1 ? std::string("reach of a block of 1 m")
                        : "reach of " + std::to_string(n) + " blocks of 1 m",
                 share * most, "m")
            .by("1/2 + 1/4 + ... + 1/2n", most)
            .within_share(
                0.003, "half a bracket of 0.5 %, and 0.05 % that blocks lean where edges sink by the slop"));
  }
  return result;
}

}  // namespace

void add_overhang_cases(ValidationCases& cases) {
  cases.push_back(
      {.id = "B35",
       .title = "A pile of n blocks reaches 1/2 + 1/4 + ... + 1/2n of a length over an edge, and no further",
       .source = "J. G. Coffin, 1923",
       .asks = Asks::any_engine,
       .run = overhang});
}

}  // namespace cairn
