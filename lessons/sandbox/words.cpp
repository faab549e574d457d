// Values of flags, understood and checked.
#include <algorithm>
#include <cmath>

#include "lessons/kit/words.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn::sandbox {
namespace {

struct Unit {
  std::string_view name = {};
  std::string_view of = {};  // what it measures, by its SI unit
  double size = 1;
};

constexpr Unit units[] = {{"um", "m", 1e-6}, {"mm", "m", 1e-3}, {"cm", "m", 1e-2}, {"m", "m", 1},
                          {"ms", "s", 1e-3}, {"min", "s", 60},  {"s", "s", 1},     {"%", "%", 1e-2}};

}  // namespace

std::optional<double> read_quantity(std::string_view text, std::string_view unit) {
  const std::size_t end = text.find_last_of("0123456789.");
  if (end == std::string_view::npos) return std::nullopt;
  const std::optional<double> number = parse_number(text.substr(0, end + 1));
  std::string_view rest = text.substr(end + 1);
  while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
  if (!number) return std::nullopt;
  for (const Unit& known : units) {
    if (known.of == unit && known.name == (rest.empty() ? unit : rest)) return *number * known.size;
  }
  return std::nullopt;
}

std::optional<std::string> Words::text(std::string_view flag) const {
  const auto found = flags.find(flag);
  if (found == flags.end() || found->second.empty()) return std::nullopt;
  return found->second.back();
}

List<std::string> Words::texts(std::string_view flag) const {
  List<std::string> values;
  const auto found = flags.find(flag);
  if (found == flags.end()) return values;
  for (const std::string& given : found->second) {
    for (std::size_t begin = 0; begin <= given.size();) {
      const std::size_t end = std::min(given.find(',', begin), given.size());
      if (end == begin) refuse(flag, "words between commas", given);
      values.push_back(given.substr(begin, end - begin));
      begin = end + 1;
    }
  }
  return values;
}

void Words::refuse(std::string_view flag, const std::string& rule, const std::string& value) const {
  throw UsageError("cairn " + verb + ": --" + std::string(flag) + " must be " + rule + ", got " + value);
}

double Words::number(std::string_view flag, double standard, double least, double most) const {
  const std::optional<std::string> given = text(flag);
  if (!given) return standard;
  const std::optional<double> value = parse_number(*given);
  if (value && *value >= least && *value <= most) return *value;
  refuse(flag, "a number from " + shortest(least) + " to " + shortest(most), *given);
}

int Words::whole(std::string_view flag, int standard, int least, int most) const {
  const std::optional<std::string> given = text(flag);
  if (!given) return standard;
  const std::optional<double> value = parse_number(*given);
  if (value && *value >= least && *value <= most && std::trunc(*value) == *value) {
    return static_cast<int>(*value);
  }
  refuse(flag, "a whole number from " + std::to_string(least) + " to " + std::to_string(most), *given);
}

void Words::require_known(std::string_view what, const std::string& value, const List<std::string>& known,
                          const std::string& list) const {
  if (std::find(known.begin(), known.end(), value) != known.end()) return;
  const std::string meant = nearest(value, known);
  std::string rule = "a known name, got " + value + "; did you mean " + meant + "?";
  if (meant.empty()) rule = "one of " + joined(known, ", ") + ", got " + value;
  if (meant.empty() && !list.empty()) rule = "a known name, got " + value + "; " + list + " shows them";
  throw UsageError("cairn " + verb + ": " + std::string(what) + " must be " + rule);
}

List<std::string> Words::known_texts(std::string_view flag, const List<std::string>& known) const {
  List<std::string> once;
  for (const std::string& given : texts(flag)) {
    const std::string value = known_word(given, known);
    if (value.empty()) require_known("--" + std::string(flag), given, known);
    if (std::find(once.begin(), once.end(), value) == once.end()) once.push_back(value);
  }
  return once;
}

void Words::refuse_beside(std::string_view flag, const std::string& what) const {
  if (!has(flag)) return;
  throw UsageError("cairn " + verb + ": --" + std::string(flag) + " means nothing " + what);
}

std::string Words::word(std::string_view flag, const std::string& standard,
                        const List<std::string>& words) const {
  const std::string given = text(flag).value_or(standard);
  if (const std::string known = known_word(given, words); !known.empty()) return known;
  const std::string meant = nearest(given, words);
  refuse(flag, joined(words, " or "), given + (meant.empty() ? "" : "; did you mean " + meant + "?"));
}

double Words::quantity(std::string_view flag, std::string_view unit, double standard, double most) const {
  const std::optional<std::string> given = text(flag);
  if (!given) return standard;
  const std::optional<double> value = read_quantity(*given, unit);
  if (value && *value > 0 && *value <= most) return *value;
  const std::string example = unit == "m"   ? "a length above 0, such as 2mm or 0.002"
                              : unit == "s" ? "a time above 0, such as 10s"
                                            : "a share above 0, such as 1%";
  const bool is_bounded = most < std::numeric_limits<double>::max();
  refuse(flag, example + (is_bounded ? ", and at most " + shortest(most) + " " + std::string(unit) : ""),
         *given);
}

}  // namespace cairn::sandbox
