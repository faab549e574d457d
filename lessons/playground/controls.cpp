// A table of controls: how each is read, written and limited.
#include "lessons/playground/controls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>
#include <functional>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>
#include <cairn/math/nearest.hpp>
#include <cairn/scenes/solver_list.hpp>

namespace cairn::playground {

namespace {

/// One control. With choices its value is one of them, or else a number between two ends.
struct Control {
  std::string name = {};
  std::string title = {};
  std::string unit = {};
  double least = 0;
  double most = 0;
  bool is_whole = false;
  List<std::string> choices = {};
  List<std::string> meanings = {};  // of the choices, where they are no words of English
  std::function<std::string(const Controls&)> value = {};
  std::function<void(Controls&, const std::string&, double)> set = {};  // the word, or the number
};

List<std::string> solver_titles(List<std::string> titles = {}) {
  for (const SolverEntry& entry : solver_entries()) titles.push_back(entry.title);
  return titles;
}

std::string number_text(double number) { return fmt::format("{:g}", number); }

/// What `at` finds in the controls: a number, a switch, or one of the values of an enumeration.
template <typename At>
Control control_of(Control control, At at) {
  using Value = std::remove_cvref_t<std::invoke_result_t<At, Controls&>>;
  if constexpr (std::is_enum_v<Value>) {
    control.choices = words_of<Value>();
    control.value = [at](const Controls& c) { return word_of(at(c)); };
    control.set = [at](Controls& c, const std::string& word, double) { at(c) = value_of<Value>(word); };
  } else if constexpr (std::same_as<Value, bool>) {
    control.choices = {"on", "off"};
    control.value = [at](const Controls& c) { return std::string(at(c) ? "on" : "off"); };
    control.set = [at](Controls& c, const std::string& word, double) { at(c) = word == "on"; };
  } else {
    control.is_whole = std::integral<Value>;
    control.value = [at](const Controls& c) { return number_text(at(c)); };
    control.set = [at](Controls& c, const std::string&, double x) { at(c) = static_cast<Value>(x); };
  }
  return control;
}

List<Control> solver_controls() {
  return {
      {.name = "solver",
       .title = "Solver",
       .choices = solver_names(),
       .meanings = solver_titles(),
       .value = [](const Controls& c) { return c.setting.solver; },
       .set = [](Controls& c, const std::string& word, double) { c.setting.solver = word; }},
      {.name = "other",
       .title = "Second solver",
       .choices = solver_names({"none"}),
       .meanings = solver_titles({""}),
       .value = [](const Controls& c) { return c.other.value_or("none"); },
       .set = [](Controls& c, const std::string& word,
                 double) { c.other = word == "none" ? std::nullopt : std::optional(word); }},
      control_of(
          {.name = "sweeps", .title = "Sweeps", .most = 100},
          [](auto& c) -> auto& { return c.setting.sweeps.iterations; }),
      control_of(
          {.name = "warm", .title = "Warm start"}, [](auto& c) -> auto& { return c.setting.warm_start; })};
}

/// A number that all bodies get, or each its own.
Control of_all_bodies(Control control, std::optional<double> Controls::*number) {
  control.choices.insert(control.choices.begin(), "as-in-scene");
  control.value = [number](const Controls& c) {
    return c.*number ? number_text(*(c.*number)) : "as-in-scene";
  };
  control.set = [number](Controls& c, const std::string& word, double) {
    c.*number = word == "as-in-scene" ? std::nullopt : std::optional(std::stod(word));
  };
  return control;
}

List<Control> scene_controls() {
  return {control_of(
              {.name = "gravity", .title = "Gravity", .unit = "m/s²", .most = 30},
              [](auto& c) -> auto& { return c.gravity; }),
          of_all_bodies({.name = "friction",
                         .title = "Friction, all bodies",
                         .choices = {"0", "0.1", "0.2", "0.3", "0.4", "0.6", "0.8", "1", "1.5"}},
                        &Controls::friction),
          of_all_bodies({.name = "bounce",
                         .title = "Bounce, all bodies",
                         .choices = {"0", "0.2", "0.4", "0.6", "0.8", "0.9", "1"}},
                        &Controls::bounce),
          control_of(
              {.name = "mass-ratio",
               .title = "Mass of the uppermost body",
               .unit = "×",
               .least = 0.01,
               .most = 1000},
              [](auto& c) -> auto& { return c.mass_ratio; })};
}

List<Control> step_controls() {
  return {control_of(
              {.name = "policy", .title = "Stabilization"},
              [](auto& c) -> auto& { return c.setting.stabilization.policy; }),
          control_of(
              {.name = "beta", .title = "Baumgarte factor β", .most = 1},
              [](auto& c) -> auto& { return c.setting.stabilization.baumgarte; }),
          {.name = "rate",
           .title = "Steps a second",
           .unit = "Hz",
           .least = 10,
           .most = 960,
           .value = [](const Controls& c) { return number_text(1 / c.setting.dt); },
           .set = [](Controls& c, const std::string&, double x) { c.setting.dt = 1 / x; }},
          control_of(
              {.name = "substeps", .title = "Substeps", .least = 1, .most = 16},
              [](auto& c) -> auto& { return c.setting.substeps; }),
          control_of(
              {.name = "search", .title = "Contact search"},
              [](auto& c) -> auto& { return c.setting.contact_search; }),
          control_of(
              {.name = "numbers", .title = "Precision"}, [](auto& c) -> auto& { return c.setting.scalar; })};
}

const List<Control>& all_controls() {
  static const List<Control> controls = [] {
    List<Control> all;
    for (const List<Control>& some : {solver_controls(), scene_controls(), step_controls()}) {
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }();
  return controls;
}

/// The least and the most that a control takes: what the scene recommends is among it.
std::pair<double, double> limits_of(const Control& control, const Controls& recommended) {
  const double wanted = std::stod(control.value(recommended));
  return {std::min(control.least, wanted), std::max(control.most, wanted)};
}

double number_in(const Control& control, const std::string& text, const Controls& recommended) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = error == std::errc{} && end == text.data() + text.size();
  const bool is_right = is_number && (!control.is_whole || number == std::floor(number));
  const auto [least, most] = limits_of(control, recommended);
  const std::string rule =
      fmt::format("a {} from {:g} to {:g}", control.is_whole ? "whole number" : "number", least, most);
  require(is_right && number >= least && number <= most, "setting", control.name, rule, text);
  return number;
}

nlohmann::ordered_json array_of(const List<std::string>& words) {
  nlohmann::ordered_json array = nlohmann::ordered_json::array();
  for (const std::string& word : words) array.push_back(word);
  return array;
}

const Control& control_named(const std::string& name) {
  List<std::string> known;
  for (const Control& control : all_controls()) known.push_back(control.name);
  require_known(name, known, "playground", "setting");
  const auto found = std::find(known.begin(), known.end(), name);
  return all_controls()[static_cast<int>(found - known.begin())];
}

}  // namespace

void set_control(Controls& controls, const Controls& recommended, const std::string& name,
                 const std::string& value) {
  const Control& control = control_named(name);
  if (!control.choices.empty()) {
    const std::string word = known_word(value, control.choices);
    if (word.empty()) require_known(value, control.choices, control.name, "choice");
    return control.set(controls, word, 0);
  }
  control.set(controls, value, number_in(control, value, recommended));
}

std::string controls_text(const Controls& controls, const Controls& recommended) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Control& control : all_controls()) {
    const bool is_number = control.choices.empty();
    const auto [least, most] = is_number ? limits_of(control, recommended) : std::pair(0.0, 0.0);
    all.push_back({{"name", control.name},
                   {"title", control.title},
                   {"value", control.value(controls)},
                   {"recommended", control.value(recommended)},
                   {"unit", control.unit},
                   {"least", least},
                   {"most", most},
                   {"choices", array_of(control.choices)},
                   {"meanings", array_of(control.meanings)}});
  }
  return all.dump();
}

std::string control_text(const Controls& controls, const std::string& name) {
  const Control& control = control_named(name);
  const std::string value = control.value(controls) + (control.unit.empty() ? "" : " " + control.unit);
  return control.title + ": " + (value == "as-in-scene" ? "as in the scene" : value);
}

bool can_go_on(const Controls& from, const Controls& to) { return from.setting.scalar == to.setting.scalar; }

}  // namespace cairn::playground
