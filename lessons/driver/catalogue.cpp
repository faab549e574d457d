// Finds the lesson programs beside the driver and keeps the notes of progress.
#include "lessons/driver/catalogue.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>

#include "lessons/driver/process.hpp"

namespace cairn::driver {
namespace {

namespace fs = std::filesystem;

bool is_lesson_name(const std::string& name) {
  return name.size() > 9 && name.rfind("lesson", 0) == 0 &&
         std::isdigit(static_cast<unsigned char>(name[6])) != 0 &&
         std::isdigit(static_cast<unsigned char>(name[7])) != 0 && name[8] == '_' &&
         name.find('.') == std::string::npos;
}

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
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!is_lesson_name(name) || !entry.is_regular_file()) continue;
    programs.push_back({.number = std::stoi(name.substr(6, 2)), .name = name, .path = entry.path()});
  }
  std::sort(programs.begin(), programs.end(),
            [](const Program& a, const Program& b) { return a.name < b.name; });
  return programs;
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

About ask(const Program& program) {
  const ProcessResult result = run_quietly({program.path.string(), "--info-json"});
  const auto json = nlohmann::json::parse(result.output, nullptr, false);
  if (!json.is_object()) return {.title = program.name, .idea = "(cannot be started)"};
  return {.title = json.value("title", program.name),
          .idea = json.value("idea", ""),
          .paper = json.value("paper", ""),
          .cover = json.value("cover", 1)};
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
  const fs::path part = file.string() + ".part";
  std::ofstream stream(part);
  for (const auto& [passed, day] : notes) stream << two_digits(passed) << " passed " << day << '\n';
  stream.close();
  std::error_code error;
  if (stream) fs::rename(part, file, error);
  if (stream && !error) return true;
  fs::remove(part, error);
  return false;
}

}  // namespace cairn::driver
