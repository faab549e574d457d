// Knows the lessons and keeps the notes of progress.
#include "lessons/driver/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include <cairn/measure/whole_file.hpp>

namespace cairn::driver {
namespace {

namespace fs = std::filesystem;

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[32] = {};
  std::strftime(text, sizeof(text), "%Y-%m-%d", std::localtime(&now));
  return text;
}

}  // namespace

std::string two_digits(int number) { return (number < 10 ? "0" : "") + std::to_string(number); }

List<Program> programs_in(const fs::path& folder) {
  List<Program> programs;
  for (const LessonInfo& card : cards()) {
    const std::string name = "lesson" + two_digits(card.number) + "_" + card.name;
    programs.push_back({.number = card.number, .name = name, .path = folder / name, .card = card});
  }
  return programs;
}

List<Program> built(const List<Program>& programs) {
  List<Program> there;
  for (const Program& program : programs) {
    if (fs::exists(program.path)) there.push_back(program);
  }
  return there;
}

void require_built(const Program& program) {
  if (fs::exists(program.path)) return;
  throw std::runtime_error(
      fmt::format("lesson {0} is not built; bash lessons/run {0} builds it", program.number));
}

const Program* find(const List<Program>& programs, std::string_view word) {
  const bool is_number = !word.empty() && word.size() <= 2 &&
                         std::all_of(word.begin(), word.end(),
                                     [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
  for (const Program& program : programs) {
    const bool is_named = word == program.name || word == program.name.substr(0, 8) ||
                          word == program.name.substr(6) || word == program.name.substr(9);
    if (is_named || (is_number && std::stoi(std::string(word)) == program.number)) return &program;
  }
  return nullptr;
}

ProgressNotes read_progress(const fs::path& file) {
  ProgressNotes notes;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    int number = 0;
    std::string passed;
    std::string day;
    if (words >> number >> passed >> day && passed == "passed") notes[number] = day;
  }
  return notes;
}

bool note_pass(const fs::path& file, int number) {
  ProgressNotes notes = read_progress(file);
  notes[number] = today();
  std::string text;
  for (const auto& [passed, day] : notes) text += two_digits(passed) + " passed " + day + "\n";
  try {
    write_whole_file(file, text);
  } catch (const WriteError&) {
    return false;
  }
  return true;
}

}  // namespace cairn::driver
