// Keeps the cards that this program was linked with.
#include "lessons/kit/card.hpp"

#include <algorithm>
#include <utility>

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

}  // namespace cairn
