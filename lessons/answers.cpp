// Reads what may stand in the gap of an exercise.
#include "lessons/answers.hpp"

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>
#include <string_view>

namespace cairn {
namespace {

constexpr std::string_view name_mark = "=== ", words_mark = "says: ";
constexpr std::string_view begin_mark = "// Your code begins here", end_mark = "// Your code ends here";

void require_whole(const GapAnswer& answer, bool is_model) {
  const auto refuse = [&answer](const char* rule) {
    throw std::runtime_error(fmt::format("answer \"{}\" (line {}) {}", answer.name, answer.line, rule));
  };
  if (answer.code.find_first_not_of(" \n") == std::string::npos) refuse("must have code, and has none");
  if (is_model && !answer.says.empty()) refuse("is the model, and must have no line \"says: \"");
  if (!is_model && answer.says.empty()) refuse("must have a line \"says: \" with what the grader says of it");
}

/// Where the line that has `mark` begins.
std::size_t marked_line(const std::string& text, std::string_view mark) {
  const std::size_t at = text.find(mark);
  if (at == std::string::npos || text.find(mark, at + 1) != std::string::npos) {
    throw std::runtime_error(fmt::format("\"{}\" must stand in exactly one line", mark));
  }
  return text.rfind('\n', at) + 1;  // the first line: npos + 1 = 0
}

}  // namespace

List<GapAnswer> read_answers(const std::string& text) {
  List<GapAnswer> answers;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.starts_with(name_mark)) {
      answers.push_back({.name = line.substr(name_mark.size()), .line = number + 1});
    } else if (!answers.empty() && answers.back().code.empty() && line.starts_with(words_mark)) {
      answers.back().says.push_back(line.substr(words_mark.size()));
      answers.back().line = number + 1;
    } else if (!answers.empty()) {
      answers.back().code += line + "\n";
    }
  }
  if (answers.empty()) throw std::runtime_error("there must be a line \"=== NAME\" and an answer below it");
  for (GapAnswer& answer : answers) {
    require_whole(answer, &answer == &answers.front());
    answer.code.erase(answer.code.find_last_not_of('\n') + 1);
    answer.code += '\n';
  }
  return answers;
}

GapText split_at_gap(const std::string& text) {
  const std::size_t begin = marked_line(text, begin_mark), end = marked_line(text, end_mark);
  if (begin > end) {
    throw std::runtime_error(fmt::format("\"{}\" must stand before \"{}\"", begin_mark, end_mark));
  }
  const std::size_t gap = text.find('\n', begin) + 1;
  return {text.substr(0, gap), text.substr(gap, end - gap), text.substr(end)};
}

}  // namespace cairn
