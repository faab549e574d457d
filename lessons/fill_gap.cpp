// Fills the gap of an exercise with each of its answers: writes one source file that has the exercise and its
// grader once for the file as it comes and once for each answer, each in a namespace of its own, and a
// function answers() that returns them all. Usage: fill_gap 06 FOLDER OUTPUT
#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "lessons/answers.hpp"

namespace cairn {
namespace {

struct SourceFile {
  std::string path = {};
  std::string text = {};
};

SourceFile read_source(const std::string& path) {
  std::ifstream stream(path);
  SourceFile file{.path = path, .text = {std::istreambuf_iterator<char>(stream), {}}};
  if (file.text.empty()) throw std::runtime_error(path + ": cannot be read, or is empty");
  return file;
}

/// Takes the #include lines out of `text` and leaves empty ones. exercise.cpp is not among what is returned:
/// it stands in the output itself.
std::string take_includes(std::string& text) {
  std::string includes, rest;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line); rest += "\n") {
    if (!line.starts_with("#include")) {
      rest += line;
    } else if (line.find("\"exercise.cpp\"") == std::string::npos) {
      includes += line + "\n";
    }
  }
  text = rest;
  return includes;
}

/// The parts of the output that do not change from answer to answer.
struct Parts {
  std::string number = {};
  SourceFile exercise = {};
  SourceFile grade = {};
  SourceFile answers = {};
  GapText gap = {};
};

int lines_in(const std::string& text) { return static_cast<int>(std::count(text.begin(), text.end(), '\n')); }

std::string in_namespace(const Parts& parts, const std::string& text, const std::string& name) {
  const std::string opening = "namespace cairn::exercise" + parts.number;
  const std::size_t at = text.find(opening + " {");
  if (at == std::string::npos) return text;
  return std::string(text).insert(at + opening.size(), "::" + name);
}

/// Compilers report an error in the file that it was written in.
std::string at_line(int line, const SourceFile& file) {
  return fmt::format("#line {} \"{}\"\n", line, file.path);
}

std::string filled(const Parts& parts, const std::string& name, const std::string& gap_line,
                   const std::string& code) {
  const int behind = lines_in(parts.gap.before) + lines_in(parts.gap.gap) + 1;
  return at_line(1, parts.exercise) + in_namespace(parts, parts.gap.before, name) + gap_line + code +
         at_line(behind, parts.exercise) + parts.gap.behind + at_line(1, parts.grade) +
         in_namespace(parts, parts.grade.text, name);
}

std::string output_of(Parts parts) {
  std::string text = take_includes(parts.exercise.text) + take_includes(parts.grade.text);
  parts.gap = split_at_gap(parts.exercise.text);
  text += filled(parts, "unsolved", "", parts.gap.gap);
  std::string all = "unsolved::exercise()";
  int count = 0;
  for (const GapAnswer& answer : read_answers(parts.answers.text)) {
    const std::string name = fmt::format("answer{}", count++);
    text += filled(parts, name, at_line(answer.line, parts.answers), answer.code);
    all += ", " + name + "::exercise()";
  }
  return text + fmt::format(
                    "namespace cairn::exercise{0} {{\nList<Exercise> answers();\n"
                    "List<Exercise> answers() {{ return {{{1}}}; }}\n}}\n",
                    parts.number, all);
}

void fill(const std::string& number, const std::string& folder, const std::string& output) {
  const Parts parts{.number = number,
                    .exercise = read_source(folder + "/exercise.cpp"),
                    .grade = read_source(folder + "/grade.cpp"),
                    .answers = read_source(folder + "/answers.txt")};
  std::string text;
  try {
    text = output_of(parts);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(folder + ": " + error.what());
  }
  std::ofstream stream(output);
  stream << text;
  if (!stream.flush()) throw std::runtime_error(output + ": cannot be written");
}

}  // namespace
}  // namespace cairn

int main(int count, char** words) {
  if (count != 4) {
    fmt::print(stderr, "fill_gap: must have a number, a lesson's folder and an output, got {} words\n",
               count - 1);
    return 2;
  }
  try {
    cairn::fill(words[1], words[2], words[3]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "fill_gap: {}\n", error.what());
    return 2;
  }
  return 0;
}
