// Settings in words, and what a setting decides of a scene.
#include <cairn/scenes/setting.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

using namespace cairn;

TEST_CASE("a setting is written as the things that differ from the usual") {
  CHECK(setting_text({}) == "si x10, 60 Hz, relaxed, double");
  CHECK(setting_text({.substeps = 4, .stabilization = {.policy = StabilizationPolicy::soft}}) ==
        "si x10, 60 Hz x4, soft, double");
  CHECK(setting_text({.solver = "accelerated",
                      .sweeps = {.iterations = 500, .tolerance = 1e-6, .order = RowOrder::coloured},
                      .scalar = Precision::single_precision,
                      .dt = 1.0 / 240,
                      .stabilization = {.policy = StabilizationPolicy::split_impulse, .baumgarte = 0.1},
                      .warm_start = false}) ==
        "accelerated x500 to 1e-06 coloured, 240 Hz, split impulse 0.1, float, cold");
  CHECK(setting_text({.sweeps = {.relaxation = 1.3, .patience = 3},
                      .stabilization = {.policy = StabilizationPolicy::none, .slop = 0}}) ==
        "si x10 omega 1.3 patience 3, 60 Hz, none, double");
  CHECK(setting_text({.stabilization = {.policy = StabilizationPolicy::soft,
                                        .slop = 0.001,
                                        .max_speed = 3,
                                        .soft = {.frequency = 60, .damping_ratio = 5},
                                        .joint_soft = {.frequency = 90, .damping_ratio = 5}}}) ==
        "si x10, 60 Hz, soft 60 Hz zeta 5 joints 90 Hz slop 0.001 m at most 3 m/s, double");
  CHECK(setting_text({.stabilization = {.policy = StabilizationPolicy::relaxed, .baumgarte = 0.3}}) ==
        "si x10, 60 Hz, relaxed 0.3, double");
  CHECK(setting_text({.substeps = 4, .contact_search = ContactSearch::every_step}) ==
        "si x10, 60 Hz x4, contacts every step, relaxed, double");
  CHECK(setting_text({.contact_search = ContactSearch::when_moved}) ==
        "si x10, 60 Hz, contacts when moved, relaxed, double");
  CHECK(setting_text({.solver = "box2d", .sweeps = {.iterations = 8}, .position_iterations = 3}) ==
        "box2d x8+3, 60 Hz, float");
}

TEST_CASE("a setting decides how a scene steps, and nothing about the scene itself") {
  const SceneSettings own{.gravity = {1, 2},
                          .speculative_margin = 0.3,
                          .restitution_threshold = 0.7,
                          .friction_rows = FrictionRows::per_manifold};
  const SceneSettings result = with_setting(own, {.dt = 0.25,
                                                  .substeps = 5,
                                                  .contact_search = ContactSearch::every_step,
                                                  .stabilization = {.policy = StabilizationPolicy::soft},
                                                  .warm_start = false});
  CHECK(result.gravity == own.gravity);
  CHECK(result.speculative_margin == 0.3);
  CHECK(result.restitution_threshold == 0.7);
  CHECK(result.friction_rows == FrictionRows::per_manifold);
  CHECK(result.dt == 0.25);
  CHECK(result.substeps == 5);
  CHECK(result.contact_search == ContactSearch::every_step);
  CHECK(result.stabilization.policy == StabilizationPolicy::soft);
  CHECK_FALSE(result.warm_start);
}

TEST_CASE("a setting that nothing could run under is refused") {
  check(Setting{});
  CHECK_THROWS_WITH_AS(check({.solver = "jacobi-spilt"}),
                       "Setting: solver must be a known name (jacobi-split?), got jacobi-spilt",
                       std::invalid_argument);
  CHECK_THROWS_AS(check({.sweeps = {.iterations = -1}}), std::invalid_argument);
  CHECK_THROWS_AS(check({.dt = 0}), std::invalid_argument);
  CHECK_THROWS_AS(check({.dt = NAN}), std::invalid_argument);
  CHECK_THROWS_AS(check({.substeps = 0}), std::invalid_argument);
  CHECK_THROWS_AS(check({.stabilization = {.slop = -1}}), std::invalid_argument);
  CHECK_THROWS_AS(check({.position_iterations = -1}), std::invalid_argument);
  if (has_box2d()) {
    check({.solver = "box2d"});
  } else {
    CHECK_THROWS_AS(check({.solver = "box2d"}), std::invalid_argument);
  }
}
