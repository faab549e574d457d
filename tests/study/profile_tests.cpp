// Performance profiles of made-up work.
#include "study/profile.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>

using namespace cairn;

namespace {

const double failed = std::numeric_limits<double>::infinity();

WorkToError made_up_work(const std::string& scene, const std::string& solver, double updates) {
  return {.scene = scene, .solver = solver, .row_updates = {1, updates}, .ending = "ok"};
}

}  // namespace

TEST_CASE("a profile is the share of problems within a factor of the best, ties and failures counted") {
  const List<PerformanceProfile> profiles = performance_profiles(
      {made_up_work("p", "si", 10), made_up_work("p", "pgs", 30), made_up_work("q", "si", 800),
       made_up_work("q", "pgs", 8), made_up_work("r", "si", 5), made_up_work("r", "pgs", 5),
       made_up_work("s", "si", failed), made_up_work("s", "pgs", 7), made_up_work("t", "si", failed),
       made_up_work("t", "pgs", failed)},
      1);
  REQUIRE(profiles.size() == 2);
  CHECK(profiles[0].solver == "si");
  // si: 1, 100, 1, failed, failed; pgs: 3, 1, 1, 1, failed. Nobody solves t: no share reaches 1.
  CHECK(profiles[0].ratios == List<double>{1, 1, 100, failed, failed});
  CHECK(profiles[1].ratios == List<double>{1, 1, 1, 3, failed});
  CHECK(profiles[0].share(0.999) == 0);
  CHECK(profiles[0].share(1) == 2.0 / 5);
  CHECK(profiles[0].share(99.9) == 2.0 / 5);
  CHECK(profiles[0].share(100) == 3.0 / 5);
  CHECK(profiles[1].share(1) == 3.0 / 5);
  CHECK(profiles[1].share(3) == 4.0 / 5);
  CHECK(profiles[1].share(failed) == 4.0 / 5);
}

TEST_CASE("a solver that was not tried on a problem has failed there") {
  const List<PerformanceProfile> profiles = performance_profiles(
      {made_up_work("p", "si", 1), made_up_work("q", "si", 2), made_up_work("q", "block", 1)}, 1);
  REQUIRE(profiles.size() == 2);
  CHECK(profiles[0].ratios == List<double>{1, 2});
  CHECK(profiles[1].ratios == List<double>{1, failed});
}

TEST_CASE("the error that is asked for decides, and where there is nothing there are no profiles") {
  const List<WorkToError> work = {{.scene = "p", .solver = "si", .row_updates = {4, 40}, .ending = "ok"},
                                  {.scene = "p", .solver = "pgs", .row_updates = {8, 20}, .ending = "ok"}};
  CHECK(performance_profiles(work, 0)[1].ratios == List<double>{2});
  CHECK(performance_profiles(work, 1)[1].ratios == List<double>{1});
  CHECK_THROWS_AS(performance_profiles(work, 2), std::out_of_range);
  CHECK(performance_profiles({}, 0).empty());
  CHECK(PerformanceProfile{}.share(1) == 0);
  CHECK(
      performance_profiles({{.scene = "p", .solver = "si", .row_updates = {0}, .ending = "ok"}}, 0)[0].share(
          1) == 1);
}
