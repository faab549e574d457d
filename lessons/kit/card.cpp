// Keeps the cards that this program was linked with.
#include "lessons/kit/card.hpp"

#include <algorithm>
#include <utility>

#include "lessons/kit/arguments.hpp"

namespace cairn {

namespace {

/// Made by the first card: which file's constants come first is not known.
List<LessonInfo>& all_cards() {
  static List<LessonInfo> all;
  return all;
}

}  // namespace

LessonCard::LessonCard(LessonInfo info) {
  List<LessonInfo>& all = all_cards();
  const auto next = std::find_if(all.begin(), all.end(),
                                 [&](const LessonInfo& other) { return info.number < other.number; });
  all.insert(next, std::move(info));
}

const List<LessonInfo>& cards() { return all_cards(); }

const LessonInfo& card() { return cards().front(); }

LessonInfo card_for(const LessonInfo& info, const Options& options) {
  const auto is_unasked = [&info](const std::string& flag) {
    return std::find(info.unasked.begin(), info.unasked.end(), flag) != info.unasked.end();
  };
  bool fits = true;
  for (const Parameter& parameter : info.parameters)
    fits &= is_unasked(parameter.flag) || options.numbers.at(parameter.flag) == parameter.standard;
  for (const Choice& choice : info.choices)
    fits &= is_unasked(choice.flag) || options.choices.at(choice.flag) == choice.values.front();
  LessonInfo told = info;
  if (!fits) told.question.clear();
  if (!all_cards().empty()) all_cards().front().question = told.question;  // pictures ask card()
  return told;
}

}  // namespace cairn
