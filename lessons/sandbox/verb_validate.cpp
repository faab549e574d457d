// cairn validate: every closed form, computed and compared; Box2D beside it where it can run the case.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "lessons/kit/words.hpp"
#include "lessons/sandbox/interrupt.hpp"
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

/// A case, what came out of it, and how long it took [s].
struct Outcome {
  const ValidationCase* of = nullptr;
  ValidationResult cairn = {};
  double cairn_seconds = 0;
  std::optional<ValidationResult> box2d = {};
  double box2d_seconds = 0;
  std::string box2d_refused = {};  // why there is none
};

ValidationResult timed(const ValidationCase& test, const EngineMaker& make, double& seconds) {
  const auto start = std::chrono::steady_clock::now();
  ValidationResult result = test.run(make);
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

Outcome outcome_of(const ValidationCase& test) {
  Outcome outcome{
      .of = &test, .cairn = {}, .cairn_seconds = 0, .box2d = {}, .box2d_seconds = 0, .box2d_refused = {}};
  outcome.cairn = timed(test, cairn_engine(), outcome.cairn_seconds);
  if (test.asks != Asks::any_engine || !box2d_engine()) return outcome;
  try {
    outcome.box2d = timed(test, box2d_engine(), outcome.box2d_seconds);
  } catch (const std::invalid_argument& error) {
    outcome.box2d_refused = error.what();
  }
  return outcome;
}

std::string short_number(double value) { return fmt::format("{:.6g}", value); }
std::string error_text(double value) { return value == 0 ? "0" : fmt::format("{:.1e}", value); }

/// Which of two errors is the smaller one, in words.
std::string closer(const Measured& cairn, const Measured& box2d) {
  // Errors within a factor of two, or both inside the tolerance, are told apart by chance.
  const bool alike = cairn.error() <= 2 * box2d.error() && box2d.error() <= 2 * cairn.error();
  if (alike) return "alike";
  return cairn.error() < box2d.error() ? "Cairn" : "Box2D";
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
                                             error_text(m.error()), error_text(m.tolerance), m.reason)) +
                   verdict);
    if (!outcome.box2d || i >= outcome.box2d->numbers.size()) continue;
    const Measured& b = outcome.box2d->numbers[i];
    console.result(console.spelt(fmt::format("    Box2D got {}, error {}; closer: {}", short_number(b.got),
                                             error_text(b.error()), closer(m, b))));
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

struct Summary {
  int cases = 0, passed = 0, numbers = 0, beside = 0, cairn_closer = 0, box2d_closer = 0, orders = 0;
};

Summary summary_of(const List<Outcome>& outcomes) {
  Summary sum;
  for (const Outcome& outcome : outcomes) {
    ++sum.cases;
    sum.passed += outcome.cairn.passes() ? 1 : 0;
    sum.orders += outcome.cairn.convergence ? 1 : 0;
    sum.numbers += outcome.cairn.numbers.size();
    if (!outcome.box2d) continue;
    const int both = std::min(outcome.cairn.numbers.size(), outcome.box2d->numbers.size());
    for (int i = 0; i < both; ++i) {
      const std::string winner = closer(outcome.cairn.numbers[i], outcome.box2d->numbers[i]);
      ++sum.beside;
      sum.cairn_closer += winner == "Cairn" ? 1 : 0;
      sum.box2d_closer += winner == "Box2D" ? 1 : 0;
    }
  }
  return sum;
}

std::string summary_text(const Summary& sum) {
  std::string text = fmt::format("{} of {} closed forms hold, {} numbers in all, {} orders of convergence.",
                                 sum.passed, sum.cases, sum.numbers, sum.orders);
  if (sum.beside > 0) {
    text += fmt::format(
        " Of the {} numbers that Box2D 2.4.1 can give too, Cairn is closer to the formula in {}, Box2D in "
        "{}.",
        sum.beside, sum.cairn_closer, sum.box2d_closer);
  }
  return text;
}

std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.replace(at, 1, "\\|");
  return text;
}

/// The page of the documents: numbers only, so that it is the same on every machine.
std::string page(const List<Outcome>& outcomes) {
  std::string text =
      "# Closed forms\n\nWhat a formula foretells, and what Cairn computes. Made by `build/release/bin/cairn "
      "validate --page src/validation/RESULTS.md`;\n"
      "a test holds this page against a fresh run. The order is that of the error in dt, over halvings of "
      "dt. Box2D 2.4.1\n"
      "stands beside Cairn where it can run the scene; nothing is asked of it.\n\n" +
      summary_text(summary_of(outcomes)) + "\n";
  for (const Outcome& outcome : outcomes) {
    text += fmt::format("\n## {}: {}\n\n{}\n\n", outcome.of->id, outcome.of->title,
                        outcome.of->source.empty() ? "Derived." : "Source: " + outcome.of->source + ".");
    text +=
        "| number | formula | expected | got | error | tolerance, and where it comes from | Box2D's error "
        "|\n|---|---|---|---|---|---|---|\n";
    for (int i = 0; i < outcome.cairn.numbers.size(); ++i) {
      const Measured& m = outcome.cairn.numbers[i];
      const bool beside = outcome.box2d && i < outcome.box2d->numbers.size();
      text += fmt::format("| {} | {} | {} {} | {} | {} | {}: {} | {} |\n", cell(m.what), cell(m.formula),
                          short_number(m.expected), m.unit, short_number(m.got), error_text(m.error()),
                          error_text(m.tolerance), cell(m.reason),
                          beside ? error_text(outcome.box2d->numbers[i].error()) : "");
    }
    if (!outcome.cairn.convergence) continue;
    const Convergence& c = *outcome.cairn.convergence;
    text += fmt::format("\n{}: order {:.2f}, expected {} to {}.\n", c.what, c.order(), shortest(c.lowest),
                        shortest(c.highest));
  }
  return text;
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
  const Summary sum = summary_of(outcomes);
  if (const std::optional<std::string> path = words.text("page")) write_whole_file(*path, page(outcomes));
  const Color color = sum.passed == sum.cases ? Color::good : Color::bad;
  if (words.has("json")) {
    console.narrate(summary_text(sum), color);
  } else {
    console.result(console.colored(summary_text(sum), color));
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
