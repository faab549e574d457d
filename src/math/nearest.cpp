// Floor 0. Edit distance (V. Levenshtein, 1966).
#include <cairn/math/nearest.hpp>

#include <algorithm>
#include <numeric>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

int edit_distance(std::string_view a, std::string_view b) {
  List<int> row(std::ssize(b) + 1);
  std::iota(row.begin(), row.end(), 0);
  for (const char letter : a) {
    int diagonal = row[0];
    ++row[0];
    for (int j = 0; const char other : b) {
      const int replaced = diagonal + (letter == other ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
      ++j;
    }
  }
  return row.back();
}

std::string nearest(std::string_view word, const List<std::string>& candidates) {
  std::string best;
  int least = 3;
  for (const std::string& candidate : candidates) {
    const int distance = edit_distance(word, candidate);
    if (distance < least && distance < std::ssize(word)) {
      least = distance;
      best = candidate;
    }
  }
  return best;
}

std::string known_word(std::string_view word, const List<std::string>& known) {
  const auto part = [](char letter) { return letter == ' ' || letter == '_' ? '-' : letter; };
  const auto is_same = [&](char one, char other) { return part(one) == part(other); };
  for (const std::string& each : known) {
    if (std::equal(word.begin(), word.end(), each.begin(), each.end(), is_same)) return each;
  }
  return "";
}

void require_known(std::string_view word, const List<std::string>& known, std::string_view place,
                   std::string_view field) {
  if (std::find(known.begin(), known.end(), word) != known.end()) return;
  const std::string near = nearest(word, known);
  std::string rule = "one of " + (known.empty() ? "none" : known.front());
  for (int i = 1; i < known.size(); ++i) rule += ", " + known[i];
  if (!near.empty()) rule = "a known name (" + near + "?)";
  require(false, place, field, rule, word);
}

}  // namespace cairn
