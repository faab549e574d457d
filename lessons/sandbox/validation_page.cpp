// The page of closed forms: what is the same in a whole table stands above it.
#include "lessons/sandbox/validation_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>

#include <cairn/math/check.hpp>

namespace cairn::sandbox {
namespace {

std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.replace(at, 1, "\\|");
  return text;
}

/// A column of a case's table.
struct PageColumn {
  std::string title = {};
  std::function<std::string(int number)> text = {};
  bool folds = false;  // stands above the table where it is the same for all of the case's numbers
};

List<PageColumn> columns_of(const Outcome& outcome) {
  const List<Measured>& numbers = outcome.cairn.numbers;
  List<PageColumn> columns = {
      {"number", [&](int i) { return cell(numbers[i].what); }},
      {"formula", [&](int i) { return cell(numbers[i].formula); }, true},
      {"expected",
       [&](int i) { return fmt::format("{} {}", short_number(numbers[i].expected), numbers[i].unit); }},
      {"got", [&](int i) { return short_number(numbers[i].got); }},
      {"error", [&](int i) { return error_word(numbers[i].error()); }},
      {"tolerance", [&](int i) { return error_word(numbers[i].tolerance); }},
      {"where the tolerance comes from", [&](int i) { return cell(numbers[i].reason); }, true}};
  if (outcome.box2d) {
    columns.push_back({"Box2D's error", [&](int i) {
                         const Measured* const beside = outcome.beside(i);
                         return beside == nullptr ? "" : error_word(beside->error());
                       }});
  }
  return columns;
}

bool is_same_for_all(const PageColumn& column, int numbers) {
  for (int i = 1; i < numbers; ++i) {
    if (column.text(i) != column.text(0)) return false;
  }
  return numbers > 1;
}

std::string case_text(const Outcome& outcome) {
  const int numbers = outcome.cairn.numbers.size();
  const std::string source = outcome.of->source.empty() ? "derived" : outcome.of->source;
  std::string text =
      fmt::format("\n## {}\n\n**{}**\n\n- source: {}\n", outcome.of->id, outcome.of->title, source);
  std::string head, rule, rows;
  List<PageColumn> shown;
  for (const PageColumn& column : columns_of(outcome)) {
    if (column.folds && is_same_for_all(column, numbers)) {
      text += fmt::format("- {}: {}\n", column.title, column.text(0));
    } else {
      shown.push_back(column);
    }
  }
  for (const PageColumn& column : shown) {
    head += "| " + column.title + " ";
    rule += "|---";
  }
  for (int i = 0; i < numbers; ++i) {
    for (const PageColumn& column : shown) rows += "| " + column.text(i) + " ";
    rows += "|\n";
  }
  if (outcome.cairn.convergence) {
    const Convergence& c = *outcome.cairn.convergence;
    text += fmt::format("- {}: order {:.2f} in dt, expected {} to {}\n", c.what, c.order(),
                        shortest(c.lowest), shortest(c.highest));
  }
  return text + "\n" + head + "|\n" + rule + "|\n" + rows;
}

/// "3 of 4", of those that Box2D gives.
std::string box2d_word(const Outcome& outcome) {
  const ValidationSummary sum = summary_of({outcome});
  return sum.beside == 0 ? "" : fmt::format("{} of {}", sum.both + sum.box2d_alone, sum.beside);
}

/// The part of its tolerance that the worst number uses.
std::string worst_share(const Outcome& outcome) {
  double worst = 0;
  for (const Measured& m : outcome.cairn.numbers)
    worst = std::max(worst, m.tolerance > 0 ? m.error() / m.tolerance : m.error());
  return fmt::format("{:.2g}", worst);
}

std::string contents(const List<Outcome>& outcomes) {
  std::string text =
      "\n| case | what a formula says | numbers | worst error, in tolerances | of Box2D within them |\n"
      "|---|---|---|---|---|\n";
  for (const Outcome& outcome : outcomes) {
    std::string anchor = outcome.of->id;
    std::transform(anchor.begin(), anchor.end(), anchor.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    text +=
        fmt::format("| [{}](#{}) | {} | {} | {} | {} |\n", outcome.of->id, anchor, cell(outcome.of->title),
                    outcome.cairn.numbers.size(), worst_share(outcome), box2d_word(outcome));
  }
  return text;
}

}  // namespace

const Measured* Outcome::beside(int number) const {
  return box2d && number < box2d->numbers.size() ? &box2d->numbers[number] : nullptr;
}

ValidationSummary summary_of(const List<Outcome>& outcomes) {
  ValidationSummary sum;
  for (const Outcome& outcome : outcomes) {
    ++sum.cases;
    sum.passed += outcome.cairn.passes() ? 1 : 0;
    sum.orders += outcome.cairn.convergence ? 1 : 0;
    sum.numbers += outcome.cairn.numbers.size();
    for (int i = 0; i < outcome.cairn.numbers.size(); ++i) {
      const Measured* const beside = outcome.beside(i);
      if (beside == nullptr) continue;
      const bool cairn = outcome.cairn.numbers[i].passes(), box2d = beside->passes();
      ++sum.beside;
      sum.both += cairn && box2d ? 1 : 0;
      sum.cairn_alone += cairn && !box2d ? 1 : 0;
      sum.box2d_alone += box2d && !cairn ? 1 : 0;
    }
  }
  return sum;
}

std::string ValidationSummary::text() const {
  std::string text = fmt::format("{} of {} closed forms hold, {} numbers in all, {} orders of convergence.",
                                 passed, cases, numbers, orders);
  if (beside == 0) return text;
  return text + fmt::format(
                    " Box2D 2.4.1 gives {} of the numbers too: within the tolerance are both in {}, "
                    "Cairn alone in {}, Box2D alone in {}.",
                    beside, both, cairn_alone, box2d_alone);
}

std::string error_word(double value) { return value == 0 ? "0" : fmt::format("{:.1e}", value); }
std::string short_number(double value) { return fmt::format("{:.6g}", value); }

std::string validation_page(const List<Outcome>& outcomes) {
  std::string text =
      "# Closed forms\n\nWhat a formula foretells, and what Cairn computes. Made by\n"
      "`build/release/bin/cairn validate --page src/validation/RESULTS.md`; a test holds this page against a "
      "fresh run. A\n"
      "tolerance is derived: from rounding where the formula is that of the steps, from the order of the "
      "step "
      "where it is that\n"
      "of the motion. An order is that of the error in dt, over halvings of dt. Box2D 2.4.1, in float, runs "
      "the cases that it\n"
      "can; tolerances that come from rounding in double are beyond it.\n\n" +
      summary_of(outcomes).text() + "\n" + contents(outcomes);
  for (const Outcome& outcome : outcomes) text += case_text(outcome);
  return text;
}

}  // namespace cairn::sandbox
