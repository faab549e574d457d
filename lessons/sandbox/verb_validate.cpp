// cairn validate: every closed form, computed and compared; Box2D beside it where it can run the case.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "lessons/kit/words.hpp"
#include "lessons/sandbox/interrupt.hpp"
#include "lessons/sandbox/validation_page.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>
#include <cairn/measure/whole_file.hpp>
#include <cairn/study/build_info.hpp>
#include <cairn/validation/box2d_engine.hpp>
#include <cairn/validation/case.hpp>

namespace cairn::sandbox {
namespace {

using Json = nlohmann::ordered_json;
using Color = Console::Color;

ValidationResult timed(const ValidationCase& test, const EngineMaker& make, double& seconds) {
  const auto start = std::chrono::steady_clock::now();
  ValidationResult result = test.run(make);
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

Outcome outcome_of(const ValidationCase& test) {
  Outcome outcome{.of = &test};
  outcome.cairn = timed(test, cairn_engine(), outcome.cairn_seconds);
  if (test.asks != Asks::any_engine || !box2d_engine()) return outcome;
  try {
    outcome.box2d = timed(test, box2d_engine(), outcome.box2d_seconds);
  } catch (const std::invalid_argument& error) {
    outcome.box2d_refused = error.what();
  }
  return outcome;
}

void print_numbers(const Outcome& outcome, Console& console) {
  for (int i = 0; i < outcome.cairn.numbers.size(); ++i) {
    const Measured& m = outcome.cairn.numbers[i];
    const std::string unit = m.unit.empty() ? "" : " " + m.unit;
    const std::string verdict =
        m.passes() ? console.colored("ok", Color::good) : console.colored("FAILED", Color::bad);
    console.result(console.spelt(fmt::format("  {}", m.what)));
    console.result(console.spelt(fmt::format("    {} = {}{}, got {}, error {} <= {} ({})  ", m.formula,
                                             short_number(m.expected), unit, short_number(m.got),
                                             error_word(m.error()), error_word(m.tolerance), m.reason)) +
                   verdict);
    const Measured* const beside = outcome.beside(i);
    if (beside == nullptr) continue;
    console.result(
        console.spelt(fmt::format("    Box2D got {}, error {}, {} the tolerance", short_number(beside->got),
                                  error_word(beside->error()), beside->passes() ? "within" : "beyond")));
  }
}

void print_outcome(const Outcome& outcome, Console& console) {
  const bool passes = outcome.cairn.passes();
  console.result(fmt::format("{:<4} {}  ", outcome.of->id, console.spelt(outcome.of->title)) +
                 (passes ? console.colored("ok", Color::good) : console.colored("FAILED", Color::bad)));
  print_numbers(outcome, console);
  if (outcome.cairn.convergence) {
    const Convergence& c = *outcome.cairn.convergence;
    console.result(console.spelt(fmt::format("  {}: order {:.2f} in dt, expected {} to {}", c.what, c.order(),
                                             shortest(c.lowest), shortest(c.highest))));
  }
  std::string time = fmt::format("  Cairn {:.0f} ms", 1e3 * outcome.cairn_seconds);
  if (outcome.box2d) time += fmt::format(", Box2D {:.0f} ms", 1e3 * outcome.box2d_seconds);
  if (!outcome.box2d_refused.empty()) time += "; Box2D refuses: " + outcome.box2d_refused;
  console.narrate(time, Color::faint);
}

Json numbers_json(const ValidationResult& result) {
  Json numbers = Json::array();
  for (const Measured& m : result.numbers) {
    numbers.push_back({{"what", m.what},
                       {"formula", m.formula},
                       {"unit", m.unit},
                       {"expected", m.expected},
                       {"got", m.got},
                       {"error", m.error()},
                       {"tolerance", m.tolerance},
                       {"reason", m.reason},
                       {"passes", m.passes()}});
  }
  return numbers;
}

Json outcome_json(const Outcome& outcome) {
  Json json = {{"id", outcome.of->id},
               {"title", outcome.of->title},
               {"source", outcome.of->source},
               {"passes", outcome.cairn.passes()},
               {"seconds", outcome.cairn_seconds},
               {"numbers", numbers_json(outcome.cairn)}};
  if (outcome.cairn.convergence) {
    const Convergence& c = *outcome.cairn.convergence;
    json["convergence"] = {{"what", c.what},     {"dt", c.dt},         {"error", c.error},
                           {"order", c.order()}, {"lowest", c.lowest}, {"highest", c.highest}};
  }
  if (outcome.box2d)
    json["box2d"] = {{"seconds", outcome.box2d_seconds}, {"numbers", numbers_json(*outcome.box2d)}};
  if (!outcome.box2d_refused.empty()) json["box2d"] = {{"refused", outcome.box2d_refused}};
  return json;
}

List<const ValidationCase*> chosen_cases(const Words& words) {
  List<const ValidationCase*> chosen;
  const List<std::string> only = words.texts("only");
  for (const std::string& id : only) {
    const auto found = std::find_if(validation_cases().begin(), validation_cases().end(),
                                    [&](const ValidationCase& test) { return test.id == id; });
    if (found == validation_cases().end())
      words.refuse("only", "ids of cases; cairn validate --list shows them", id);
    chosen.push_back(&*found);
  }
  for (const ValidationCase& test : validation_cases()) {
    if (only.empty()) chosen.push_back(&test);
  }
  return chosen;
}

int list_cases(const Words& words, Console& console) {
  Json all = Json::array();
  for (const ValidationCase& test : validation_cases()) {
    all.push_back({{"id", test.id}, {"title", test.title}});
    if (!words.has("json")) console.result(console.spelt(fmt::format("{:<4} {}", test.id, test.title)));
  }
  if (words.has("json")) fmt::print("{}\n", all.dump(1));
  return all_well;
}

int run_validate(const Words& words, Console& console) {
  if (words.has("list")) return list_cases(words, console);
  const List<const ValidationCase*> cases = chosen_cases(words);
  List<Outcome> outcomes;
  Progress bar(words.console, "closed forms", cases.size());
  Json json = {{"build", build_json()}, {"cases", Json::array()}};
  for (const ValidationCase* test : cases) {
    outcomes.push_back(outcome_of(*test));
    bar.clear();
    if (words.has("json")) {
      json["cases"].push_back(outcome_json(outcomes.back()));
    } else if (!words.has("summary") || !outcomes.back().cairn.passes()) {
      print_outcome(outcomes.back(), console);
    }
    bar.advance(outcomes.size());
    if (!interrupted()) continue;
    bar.clear();
    console.warn(fmt::format("stopped after {} of {} closed forms", outcomes.size(), cases.size()));
    return stopped;
  }
  bar.clear();
  if (words.has("json")) fmt::print("{}\n", json.dump(1));
  const ValidationSummary sum = summary_of(outcomes);
  if (const std::optional<std::string> path = words.text("page"))
    write_whole_file(*path, validation_page(outcomes));
  const Color color = sum.passed == sum.cases ? Color::good : Color::bad;
  if (words.has("json")) {
    console.narrate(sum.text(), color);
  } else {
    console.result(console.colored(sum.text(), color));
  }
  return sum.passed == sum.cases ? all_well : check_failed;
}

}  // namespace

Verb validate_verb() {
  return {.name = "validate",
          .places = "",
          .summary = "every closed form beside what Cairn and Box2D compute",
          .idea =
              "Runs every case whose answer a formula knows, and compares: the formula's number, the "
              "engine's, the error, the tolerance with where it comes from, and the order of convergence in "
              "dt where there is one. Box2D 2.4.1 runs the cases that it can. Exit code 1 when Cairn misses "
              "a tolerance.",
          .flags = {{"only", "ID,ID", "these cases only, such as B4,B5", true},
                    {"summary", "", "one sentence, and the cases that fail"},
                    {"list", "", "the cases, without running them"},
                    {"page", "FILE", "writes the table as Markdown too"}},
          .examples = {"validate --only A3,B15", "validate --json > validation.json"},
          .run = run_validate};
}

}  // namespace cairn::sandbox
