// Floor 9. Holding a run against what its scene expects.
#include <cairn/study/expectation.hpp>
#include <cairn/math/list.hpp>

#include <fmt/format.h>

namespace cairn {

namespace {

std::string body_name(BodyId body, const PerBody<std::string>& names) {
  return body.index < names.size() ? names[body] : fmt::format("body {}", body.index);
}

}  // namespace

TrialOptions trial_options(const SceneEntry& scene) {
  TrialOptions options{.seconds = scene.seconds};
  if (scene.expectations.stands) options.stand_distance = *scene.expectations.stands;
  options.places = scene.expectations.places;
  return options;
}

List<std::string> unmet(const Expectations& expectations, const TrialResult& result,
                        const PerBody<std::string>& names) {
  if (result.status == TrialStatus::refused) return {"refused: " + result.reason};
  if (result.status != TrialStatus::ok) {
    const std::string ending = fmt::format("{} after {:.3g} s", status_text(result.status), result.seconds);
    if (!result.not_finite) return {ending};
    return {fmt::format("{}: {} would not be finite", ending, body_name(*result.not_finite, names))};
  }
  List<std::string> missed;
  const auto at_most = [&missed](const char* name, double value, const std::optional<double>& most,
                                 const char* unit) {
    if (!most || value <= *most) return;
    missed.push_back(fmt::format("{} {:.3g} {}, expected at most {:g} {}", name, value, unit, *most, unit));
  };
  at_most("worst penetration", result.worst_penetration, expectations.penetration, "m");
  at_most("worst drift", result.worst_drift, expectations.drift, "m or rad");
  at_most("energy gain", 100 * result.energy_gain, expectations.energy_gain, "%");
  at_most("energy loss", 100 * result.energy_loss, expectations.energy_loss, "%");
  if (expectations.stands && result.fell_at) {
    missed.push_back(fmt::format("stands for {:.3g} s of {:.3g} s", result.stands_until, result.seconds));
  }
  for (int i = 0; i < expectations.places.size(); ++i) {
    const ExpectedPlace& place = expectations.places[i];
    const double distance = result.place_distances[i];
    if (distance <= place.within) continue;
    missed.push_back(fmt::format("place of {} off by {:.3g} m, expected at most {:g} m",
                                 body_name(place.body, names), distance, place.within));
  }
  return missed;
}

}  // namespace cairn
