// Numbers of a run, with their units, beside what was expected of them.
#include "lessons/sandbox/run_table.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lessons/kit/words.hpp"
#include "lessons/sandbox/scene_words.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/world/scene_length.hpp>

namespace cairn::sandbox {
namespace {

using Color = Console::Color;

constexpr int run_columns = 100;

/// 1e-3 of the unit, with three digits; no "-0".
std::string milli(double value) { return fmt::format("{:.3g}", 1e3 * value); }
std::string percent(double share) { return fmt::format("{:.3g}", 100 * share); }

/// "41 million".
std::string count_text(std::int64_t count) {
  const double value = static_cast<double>(count);
  if (value < 1e5) return fmt::format("{}", count);
  return value < 1e6 ? fmt::format("{:.0f} thousand", value / 1e3)
                     : fmt::format("{:.3g} million", value / 1e6);
}

/// A line of the table: "  worst penetration  1.2 mm  expected at most 5 mm  ok".
void print_line(Console& console, const std::string& name, const std::string& value,
                const std::string& expected = {}, int verdict = 0) {
  std::string line = "  " + padded(name, 20) + (expected.empty() ? value : padded(value, 22) + expected);
  if (verdict == 0) return console.result(console.spelt(line));
  const bool ok = verdict > 0;
  console.result(console.spelt(line + "  ") +
                 console.colored(ok ? "ok" : "MISSED", ok ? Color::good : Color::bad));
}

/// "in 12 of 600 steps, R_E up to 0.33".
std::string unfinished_text(const TrialResult& result) {
  return fmt::format("in {} of {} steps, R_E up to {:.2g}", result.unfinished_steps, result.steps,
                     result.unfinished_residual);
}

/// "R_E 0.23 in the last step"; nothing where its sweeps came near their end.
std::string left_text(const TrialResult& result) {
  constexpr double far_from_the_end = 0.1;
  if (result.unfinished_steps > 0 || !(result.worst_residual.value_or(0) > far_from_the_end)) return "";
  return fmt::format("R_E {:.2g} in the last step: more sweeps would change it", *result.worst_residual);
}

bool is_missed(const SceneRun& run, const std::string& name) {
  for (const JudgedPart& part : run.judgement.parts) {
    if (part.name == name) return part.missed();
  }
  return false;
}

/// Of its limit, in per cent, the worst of what is asked; "-" where there is no such thing.
std::string asked_text(const RunJudgement& judgement) {
  const bool has_one = judgement.worst() != nullptr && !judgement.fails();
  return has_one ? fmt::format("{:.3g}", 100 * judgement.share()) : "-";
}

void print_measure(Console& console, const SceneRun& run, const std::string& name, const std::string& value,
                   const std::optional<std::string>& most) {
  const bool is_judged = most && run.result.status == TrialStatus::ok;
  if (!is_judged) return print_line(console, name, value);
  const std::string part = name.rfind("worst ", 0) == 0 ? name.substr(6) : name;
  print_line(console, name, value, "expected at most " + *most, is_missed(run, part) ? -1 : 1);
}

std::optional<std::string> with_unit(const std::optional<double>& value, double factor, const char* unit) {
  if (!value) return std::nullopt;
  return fmt::format("{:g} {}", factor * *value, unit);
}

/// The bodies that were worst off, and when, below the number that says how far; and how much that is of
/// them, where an eye may see it.
void print_worst(Console& console, const SceneEntry& scene, const TrialWorst& worst, double distance) {
  constexpr double seen_share = 0.01;
  const double share = distance / worst.thickness;
  const std::string what = worst.joint.empty() ? "" : worst.joint + " joint of ";
  std::string seen;
  if (share > 1)
    seen = fmt::format(", {:.3g} times the thinner", share);
  else if (share >= seen_share)
    seen = fmt::format(", {:.2g} % of the thinner", 100 * share);
  print_line(console, "",
             fmt::format("{}{} and {}, at {:.4g} s{}", what, scene.body_names[worst.a],
                         scene.body_names[worst.b], worst.time, seen));
}

/// Motion of what should rest, where an eye may see it.
void print_jitter(const TrialResult& result, Console& console) {
  constexpr double seen_speed = 0.001;  // of the thinnest body, in a second
  if (!(result.jitter > seen_speed * result.thinnest)) return;
  print_line(console, "jitter", milli(result.jitter) + " mm/s to and fro, of a body that rests");
}

void print_overlap_and_drift(const SceneEntry& scene, const SceneRun& run, Console& console) {
  const TrialResult& result = run.result;
  const Expectations& expected = scene.expectations;
  print_measure(console, run, "worst penetration", milli(result.worst_penetration) + " mm",
                with_unit(expected.penetration, 1e3, "mm"));
  if (result.worst_penetration > 0)
    print_worst(console, scene, result.penetration_worst, result.worst_penetration);
  Scene stepped = scene.make();
  stepped.set_settings(with_setting(stepped.settings(), run.setting));
  if (run.in_ground.depth > *full_settings(stepped).stabilization.slop) {
    print_line(console, "through the ground",
               fmt::format(
                   "{} mm: {} is joined to it, and joined bodies do not collide (collide = \"on\" lets them)",
                   milli(run.in_ground.depth), scene.body_names[run.in_ground.b]));
  }
  if (!expected.drift && !(result.worst_drift > 0)) return;
  print_measure(console, run, "worst drift", milli(result.worst_drift) + " mm or mrad",
                with_unit(expected.drift, 1e3, "mm or mrad"));
  if (result.worst_drift > 0) print_worst(console, scene, result.drift_worst, result.worst_drift);
}

void print_standing(const SceneEntry& scene, const SceneRun& run, Console& console) {
  const TrialResult& result = run.result;
  const std::optional<double>& most = scene.expectations.stands;
  if (!std::isfinite(result.farthest)) return;  // the verdict says what became of it
  if (!most || result.status != TrialStatus::ok)
    return print_line(console, "farthest from start", fmt::format("{:.3g} m", result.farthest));
  const std::string stands = result.stands() ? fmt::format("all {:g} s", result.seconds)
                                             : fmt::format("until {:.3g} s", result.stands_until);
  const bool missed = is_missed(run, "stands");
  print_line(console, "stands", stands, fmt::format("expected within {} mm of its place", milli(*most)),
             missed ? -1 : 1);
}

/// Below a micrometre there is only rounding.
std::string off_text(double distance) { return "off by " + milli(distance < 1e-6 ? 0 : distance) + " mm"; }

/// How far each body is from where it should end; nothing of a run that has not come so far.
void print_places(const SceneEntry& scene, const SceneRun& run, Console& console) {
  if (!judges_places(scene, run)) return;
  for (int i = 0; i < scene.expectations.places.size(); ++i) {
    const ExpectedPlace& place = scene.expectations.places[i];
    const double distance = run.result.place_distances[i];
    print_line(console, "place of " + scene.body_names[place.body], off_text(distance),
               "expected at most " + milli(place.within) + " mm", distance <= place.within ? 1 : -1);
  }
}

void print_failures(const SceneRun& run, Console& console) {
  std::string name = "fails";
  for (const std::string& failure : run.judgement.failures) {
    print_line(console, name, failure);
    name = "";
  }
}

std::string verdict_text(const SceneEntry& scene, const SceneRun& run) {
  const RunJudgement& judgement = run.judgement;
  if (!judgement.ending.empty()) return judgement.ending;
  const int missed = judgement.missed().size();
  if (missed > 0)
    return missed == 1 ? "misses an expectation" : fmt::format("misses {} expectations", missed);
  if (judgement.fails()) return "fails, whatever is expected of it";
  if (wish_of(scene).is_empty()) return "nothing is expected of it";
  if (run.result.seconds < scene.seconds - run.setting.dt / 2) {
    return fmt::format("meets so far what is expected of {:g} s", scene.seconds);
  }
  const bool is_longer = run.result.seconds > scene.seconds + run.setting.dt / 2;
  return "meets what is expected" + (is_longer ? fmt::format(" of its first {:g} s", scene.seconds) : "");
}

/// "si x10": what the runs of a comparison do not have in common.
std::string contestant_label(const Setting& setting) {
  const std::string text = setting_text(setting);
  return text.substr(0, text.find(", ")) + (setting.solver == "box2d" ? ", float" : "");
}

void print_row(const SceneEntry& scene, const SceneRun& run, int width, Console& console) {
  const TrialResult& result = run.result;
  const std::string name = padded(contestant_label(run.setting), width);
  if (result.status == TrialStatus::refused) return console.result(name + "  left out");
  const int steps = std::max(1, result.steps);
  const std::string stands = scene.expectations.stands ? fmt::format("{:.3g}", result.stands_until) : "-";
  const std::string numbers = fmt::format(
      "{} {:>9.3g} {:>11.0f} {:>11} {:>9} {:>7} {:>7} {:>6} {:>8.3g} {:>7}  ", name, 1e3 * result.median_step,
      static_cast<double>(result.row_updates) / steps, milli(result.worst_penetration),
      milli(result.worst_drift), percent(result.energy_gain), percent(std::max(0.0, result.energy_loss)),
      stands, 1e3 * result.slowest_step, asked_text(run.judgement));
  const std::string verdict = result.status != TrialStatus::ok ? status_text(result.status)
                              : run.judgement.fails()          ? "fails"
                              : run.judgement.meets()          ? "ok"
                                                               : "misses " + run.judgement.worst()->name;
  console.result(numbers + console.colored(verdict, verdict == "ok" ? Color::good : Color::bad));
}

}  // namespace

bool judges_places(const SceneEntry& scene, const SceneRun& run) {
  return run.result.status == TrialStatus::ok && run.result.seconds >= scene.seconds - run.setting.dt / 2;
}

std::string refusal_text(const SceneEntry& scene, const SceneRun& run) {
  return fmt::format("{} cannot run {}: {}", run.setting.solver, scene.name, run.result.reason);
}

void print_run(const SceneEntry& scene, const SceneRun& run, Console& console) {
  const TrialResult& result = run.result;
  console.result(console.spelt(fmt::format("{}: {}", scene.name, scene.title)));
  print_line(console, "setting", setting_text(run.setting));
  if (const std::string why = why_chosen(scene, run.setting); !why.empty())
    print_line(console, "chosen", why);
  const double real_time = result.cost() > 0 ? 1 / result.cost() : 0;
  print_line(console, "time", fmt::format("{:g} s in {} steps", result.seconds, result.steps));
  print_line(console, "processor time",
             fmt::format("{:.3g} ms a step, the slowest {:.3g}, and {:.3g} before the first; {:.3g} times as "
                         "fast as real time",
                         1e3 * result.median_step, 1e3 * result.slowest_step, 1e3 * result.setup_seconds,
                         real_time));
  print_line(console, "row updates", count_text(result.row_updates));
  if (result.unfinished_steps > 0) print_line(console, "unfinished solves", unfinished_text(result));
  if (const std::string left = left_text(result); !left.empty()) print_line(console, "left undone", left);
  print_overlap_and_drift(scene, run, console);
  print_line(console, "energy scale", fmt::format("{:.3g} J", result.energy_scale));
  print_measure(console, run, "energy gain", percent(result.energy_gain) + " %",
                with_unit(scene.expectations.energy_gain, 1, "%"));
  print_measure(console, run, "energy loss", percent(std::max(0.0, result.energy_loss)) + " %",
                with_unit(scene.expectations.energy_loss, 1, "%"));
  print_standing(scene, run, console);
  print_jitter(result, console);
  print_places(scene, run, console);
  for (const auto& [name, text] : occurrence_lines(scene, run.occurrences)) print_line(console, name, text);
  print_failures(run, console);
  const std::string verdict = verdict_text(scene, run);
  const bool is_good = run.judgement.meets();
  console.result("  " + console.colored(console.spelt(verdict), is_good ? Color::good : Color::bad));
}

void print_runs(const SceneEntry& scene, const List<SceneRun>& runs, Console& console) {
  int width = 6;
  for (const SceneRun& run : runs) width = std::max(width, display_width(contestant_label(run.setting)));
  const auto heading = [&](const std::string& first, const List<std::string>& cells) {
    console.result(fmt::format("{} {:>9} {:>11} {:>11} {:>9} {:>7} {:>7} {:>6} {:>8} {:>7}",
                               padded(first, width), cells[0], cells[1], cells[2], cells[3], cells[4],
                               cells[5], cells[6], cells[7], cells[8]));
  };
  heading("solver", {"ms a step", "row updates", "penetration", "drift", "energy", "energy", "stands",
                     "slowest", "% of"});
  heading("", {"median", "a step", "mm", "mm, mrad", "gain %", "loss %", "s", "step, ms", "limit"});
  for (const SceneRun& run : runs) print_row(scene, run, width, console);
  for (const SceneRun& run : runs) {
    for (int i = 0; judges_places(scene, run) && i < scene.expectations.places.size(); ++i) {
      const ExpectedPlace& place = scene.expectations.places[i];
      console.result(console.spelt(fmt::format(
          "{}: place of {} {}, expected at most {} mm", contestant_label(run.setting),
          scene.body_names[place.body], off_text(run.result.place_distances[i]), milli(place.within))));
    }
    if (run.result.unfinished_steps > 0)
      console.result(contestant_label(run.setting) + ": unfinished solves " + unfinished_text(run.result));
    if (const std::string left = left_text(run.result); !left.empty())
      console.result(contestant_label(run.setting) + ": left undone " + left);
    for (const std::string& failure : run.judgement.failures)
      console.result(wrapped(contestant_label(run.setting) + ": " + failure, run_columns, 2));
  }
}

int exit_code(const SceneRun& run) {
  if (run.result.status == TrialStatus::refused) return bad_usage;
  if (run.result.status != TrialStatus::ok) return diverged;
  return run.judgement.meets() ? all_well : check_failed;
}

}  // namespace cairn::sandbox
