// A table of controls: how each is read, written and limited.
#include "lessons/playground/controls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "math/check.hpp"
#include "math/list.hpp"
#include "math/nearest.hpp"
#include "scenes/solver_list.hpp"

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

const List<std::string> switch_words = {"on", "off"};

List<std::string> solver_words(std::string SolverEntry::*which, List<std::string> words = {}) {
  for (const SolverEntry& entry : solver_entries()) {
    if (entry.name != "box2d") words.push_back(entry.*which);
  }
  return words;
}

int number_of(const List<std::string>& words, const std::string& word) {
  return static_cast<int>(std::find(words.begin(), words.end(), word) - words.begin());
}

std::string number_text(double number) { return fmt::format("{:g}", number); }

List<Control> solver_controls() {
  return {{.name = "solver",
           .title = "Solver",
           .choices = solver_words(&SolverEntry::name),
           .meanings = solver_words(&SolverEntry::title),
           .value = [](const Controls& c) { return c.setting.solver; },
           .set = [](Controls& c, const std::string& word, double) { c.setting.solver = word; }},
          {.name = "other",
           .title = "Second solver",
           .choices = solver_words(&SolverEntry::name, {"none"}),
           .meanings = solver_words(&SolverEntry::title, {""}),
           .value = [](const Controls& c) { return c.other.value_or("none"); },
           .set = [](Controls& c, const std::string& word,
                     double) { c.other = word == "none" ? std::nullopt : std::optional(word); }},
          {.name = "sweeps",
           .title = "Sweeps",
           .most = 100,
           .is_whole = true,
           .value = [](const Controls& c) { return number_text(c.setting.sweeps.iterations); },
           .set = [](Controls& c, const std::string&,
                     double x) { c.setting.sweeps.iterations = static_cast<int>(x); }},
          {.name = "warm",
           .title = "Warm start",
           .choices = switch_words,
           .value = [](const Controls& c) { return std::string(c.setting.warm_start ? "on" : "off"); },
           .set = [](Controls& c, const std::string& word, double) { c.setting.warm_start = word == "on"; }}};
}

List<Control> scene_controls() {
  return {{.name = "friction",
           .title = "Friction, all bodies",
           .choices = {"as-in-scene", "0", "0.1", "0.2", "0.3", "0.4", "0.6", "0.8", "1", "1.5"},
           .value = [](const Controls& c) { return c.friction ? number_text(*c.friction) : "as-in-scene"; },
           .set =
               [](Controls& c, const std::string& word, double) {
                 c.friction = word == "as-in-scene" ? std::nullopt : std::optional(std::stod(word));
               }},
          {.name = "mass-ratio",
           .title = "Mass of the uppermost body",
           .unit = "×",
           .least = 0.01,
           .most = 1000,
           .value = [](const Controls& c) { return number_text(c.mass_ratio); },
           .set = [](Controls& c, const std::string&, double x) { c.mass_ratio = x; }}};
}

List<Control> step_controls() {
  return {
      {.name = "policy",
       .title = "Stabilization",
       .choices = stabilization_words(),
       .value =
           [](const Controls& c) {
             return stabilization_words()[static_cast<int>(c.setting.stabilization.policy)];
           },
       .set =
           [](Controls& c, const std::string& word, double) {
             c.setting.stabilization.policy =
                 static_cast<StabilizationPolicy>(number_of(stabilization_words(), word));
           }},
      {.name = "beta",
       .title = "Baumgarte factor β",
       .most = 1,
       .value = [](const Controls& c) { return number_text(c.setting.stabilization.baumgarte); },
       .set = [](Controls& c, const std::string&, double x) { c.setting.stabilization.baumgarte = x; }},
      {.name = "rate",
       .title = "Steps a second",
       .unit = "Hz",
       .least = 10,
       .most = 960,
       .value = [](const Controls& c) { return number_text(1 / c.setting.dt); },
       .set = [](Controls& c, const std::string&, double x) { c.setting.dt = 1 / x; }},
      {.name = "substeps",
       .title = "Substeps",
       .least = 1,
       .most = 16,
       .is_whole = true,
       .value = [](const Controls& c) { return number_text(c.setting.substeps); },
       .set = [](Controls& c, const std::string&, double x) { c.setting.substeps = static_cast<int>(x); }},
      {.name = "search",
       .title = "Contact search",
       .choices = contact_search_words(),
       .value =
           [](const Controls& c) {
             return contact_search_words()[static_cast<int>(c.setting.contact_search)];
           },
       .set =
           [](Controls& c, const std::string& word, double) {
             c.setting.contact_search = static_cast<ContactSearch>(number_of(contact_search_words(), word));
           }},
      {.name = "numbers",
       .title = "Precision",
       .choices = {"float", "double"},
       .value =
           [](const Controls& c) {
             return std::string(c.setting.scalar == Precision::single_precision ? "float" : "double");
           },
       .set =
           [](Controls& c, const std::string& word, double) {
             c.setting.scalar = word == "float" ? Precision::single_precision : Precision::double_precision;
           }}};
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

}  // namespace

void set_control(Controls& controls, const Controls& recommended, const std::string& name,
                 const std::string& value) {
  List<std::string> known;
  for (const Control& control : all_controls()) known.push_back(control.name);
  require_known(name, known, "playground", "setting");
  const Control& control = all_controls()[number_of(known, name)];
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

bool can_go_on(const Controls& from, const Controls& to) {
  return from.setting.scalar == to.setting.scalar && from.friction == to.friction &&
         from.mass_ratio == to.mass_ratio && from.other == to.other;
}

}  // namespace cairn::playground
