// Floor 9. Every number beside its limit.
#include <cairn/study/judgement.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/study/limit.hpp>

namespace cairn {

namespace {

std::string body_name(BodyId body, const PerBody<std::string>& names) {
  return body.index < names.size() ? names[body] : fmt::format("body {}", body.index);
}

std::string ending_of(const TrialResult& result, const PerBody<std::string>& names) {
  if (result.status == TrialStatus::ok) return "";
  if (result.status == TrialStatus::refused) return "refused: " + result.reason;
  const std::string ending = fmt::format("{} after {:.3g} s", status_text(result.status), result.seconds);
  if (!result.not_finite) return ending;
  return fmt::format("{}: {} would not be finite", ending, body_name(*result.not_finite, names));
}

/// A number and the most that it may be, both told in a unit of so much.
void add_at_most(RunJudgement& judgement, const std::string& name, double value,
                 const std::optional<double>& most, double unit, const char* unit_name) {
  if (!most) return;
  judgement.parts.push_back({.name = name,
                             .found = fmt::format("{} {:.3g}{}", name, value / unit, unit_name),
                             .asked = fmt::format("at most {:.6g}{}", *most / unit, unit_name),
                             .share = share_of(value, *most)});
}

/// A run that stood for as long as is asked may fall later.
void add_standing(RunJudgement& judgement, const TrialResult& result, double seconds) {
  const bool fell = result.fell_at && *result.fell_at < seconds;
  const double stood = fell ? *result.fell_at : std::min(result.seconds, seconds);
  const double share =
      fell ? std::max(result.stand_share, std::nextafter(1.0, 2.0)) : std::min(result.stand_share, 1.0);
  judgement.parts.push_back({.name = "stands",
                             .found = fmt::format("stands {:.3g} s", stood),
                             .asked = fmt::format("at least {:g} s", seconds),
                             .share = share});
}

void add_place(RunJudgement& judgement, const ExpectedPlace& place, double distance,
               const std::string& body) {
  judgement.parts.push_back({.name = "place of " + body,
                             .found = fmt::format("place of {} off by {:.3g} mm", body, 1e3 * distance),
                             .asked = fmt::format("at most {:.6g} mm", 1e3 * place.within),
                             .share = share_of(distance, place.within),
                             .can_recover = true});
}

void add_residual(RunJudgement& judgement, const TrialResult& result, const Wish& wish) {
  if (result.worst_residual || !wish.residual)
    return add_at_most(judgement, "R_E", result.worst_residual.value_or(0), wish.residual, 1, "");
  // Who cannot tell its residual does not meet a wish for one.
  judgement.parts.push_back({.name = "R_E",
                             .found = "R_E cannot be measured",
                             .asked = fmt::format("at most {:g}", *wish.residual),
                             .share = std::numeric_limits<double>::infinity()});
}

}  // namespace

Wish wish_of(const SceneEntry& scene) {
  const Expectations& expected = scene.expectations;
  const auto share = [](const std::optional<double>& percent) {
    return percent ? std::optional(*percent / 100) : std::nullopt;
  };
  Wish wish{.penetration = expected.penetration,
            .drift = expected.drift,
            .energy_gain = share(expected.energy_gain),
            .energy_loss = share(expected.energy_loss),
            .places = expected.places};
  if (expected.stands) wish.stands = scene.seconds;
  return wish;
}

TrialOptions trial_options(const SceneEntry& scene) {
  TrialOptions options{.seconds = scene.seconds};
  if (scene.expectations.stands) options.stand_distance = *scene.expectations.stands;
  options.places = scene.expectations.places;
  return options;
}

const JudgedPart* RunJudgement::worst() const {
  const auto worst = std::max_element(
      parts.begin(), parts.end(), [](const JudgedPart& a, const JudgedPart& b) { return a.share < b.share; });
  return worst == parts.end() ? nullptr : &*worst;
}

double RunJudgement::share() const {
  if (fails()) return std::numeric_limits<double>::infinity();
  return parts.empty() ? 0 : worst()->share;
}

bool RunJudgement::is_lost() const {
  return fails() || std::any_of(parts.begin(), parts.end(),
                                [](const JudgedPart& part) { return part.missed() && !part.can_recover; });
}

std::string RunJudgement::first_missed(double seconds) const {
  const JudgedPart* part = worst();
  if (!ending.empty()) return ending;
  if (part != nullptr && part->missed()) {
    const bool is_time = part->name == "stands" || !std::isfinite(part->share);
    return is_time ? part->found : fmt::format("{} after {:.3g} s", part->found, seconds);
  }
  return failures.empty() ? "" : failures.front();
}

List<std::string> RunJudgement::missed() const {
  if (!ending.empty()) return {ending};
  List<JudgedPart> worst_first = parts;
  std::stable_sort(worst_first.begin(), worst_first.end(),
                   [](const JudgedPart& a, const JudgedPart& b) { return a.share > b.share; });
  List<std::string> all;
  for (const JudgedPart& part : worst_first) {
    if (part.missed()) all.push_back(part.found + ", " + part.asked);
  }
  return all;
}

RunJudgement judge(const TrialResult& result, const Wish& wish, const PerBody<std::string>& names) {
  RunJudgement judgement{.ending = ending_of(result, names), .failures = {}, .parts = {}};
  if (result.status == TrialStatus::refused) return judgement;
  add_at_most(judgement, "penetration", result.worst_penetration, wish.penetration, 1e-3, " mm");
  add_at_most(judgement, "drift", result.worst_drift, wish.drift, 1e-3, " mm");
  add_residual(judgement, result, wish);
  add_at_most(judgement, "energy gain", result.energy_gain, wish.energy_gain, 1e-2, " %");
  add_at_most(judgement, "energy loss", result.energy_loss, wish.energy_loss, 1e-2, " %");
  if (wish.energy_loss) judgement.parts.back().can_recover = true;
  if (wish.stands) add_standing(judgement, result, *wish.stands);
  for (int i = 0; i < std::min(wish.places.size(), result.place_distances.size()); ++i)
    add_place(judgement, wish.places[i], result.place_distances[i], body_name(wish.places[i].body, names));
  for (const Failure& failure : result.failures) judgement.failures.push_back(failure_text(failure, names));
  return judgement;
}

}  // namespace cairn
